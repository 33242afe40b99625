/*
 * onnxruntime's C interface: a state and beta to angles and time of flight, by its merged graph.
 *
 * Its wheel holds the library without a header. The part of its table of functions that is needed is
 * declared here by position; positions are fixed since version 1 of that interface. Tensors are made
 * once, over memory of ours: a call copies nothing and allocates no tensor.
 */
#include <stddef.h>
#include <stdint.h>

#include "candidate.h"

typedef struct ort_status ort_status;
typedef struct ort_environment ort_environment;
typedef struct ort_options ort_options;
typedef struct ort_session ort_session;
typedef struct ort_memory ort_memory;
typedef struct ort_value ort_value;

typedef void (*other)(void);

typedef struct {
    other from_0[2];
    const char *(*get_error_message)(const ort_status *status);
    ort_status *(*create_environment)(int32_t level, const char *name, ort_environment **environment);
    other from_4[3];
    ort_status *(*create_session)(const ort_environment *environment, const char *model,
                                  const ort_options *options, ort_session **session);
    other from_8[1];
    ort_status *(*run)(ort_session *session, const void *run_options, const char *const *input_names,
                       const ort_value *const *inputs, size_t input_count, const char *const *output_names,
                       size_t output_count, ort_value **outputs);
    ort_status *(*create_options)(ort_options **options);
    other from_11[13];
    ort_status *(*set_threads_within)(ort_options *options, int threads);
    ort_status *(*set_threads_between)(ort_options *options, int threads);
    other from_26[23];
    ort_status *(*create_tensor)(const ort_memory *memory, void *data, size_t bytes, const int64_t *shape,
                                 size_t rank, int32_t type, ort_value **value);
    other from_50[19];
    ort_status *(*create_memory)(int32_t allocator, int32_t kind, ort_memory **memory);
} ort_functions;

typedef char position_9[offsetof(ort_functions, run) == 9 * sizeof(other) ? 1 : -1];
typedef char position_69[offsetof(ort_functions, create_memory) == 69 * sizeof(other) ? 1 : -1];

typedef struct {
    const ort_functions *(*get_functions)(uint32_t version);
    const char *(*get_version)(void);
} ort_base;

enum { LEVEL_ERROR = 3, ARENA = 1, FLOAT = 1, DOUBLE = 11, MOST_INPUTS = 2, COMPONENTS = CANDIDATE_INPUTS - 1 };

static const ort_functions *functions;
static ort_session *session;
static const char *const *names_in;
static const char *const *names_out;
static uint64_t count;
static ort_value *values_in[MOST_INPUTS];
static ort_value *values_out[CANDIDATE_OUTPUTS];
static candidate_real given[CANDIDATE_INPUTS];
static candidate_real result[CANDIDATE_OUTPUTS];

static const char *message(const ort_status *status)
{
    return status == NULL ? NULL : functions->get_error_message(status);
}

static ort_status *tensor(const ort_memory *memory, candidate_real *data, int64_t columns, size_t rank,
                          ort_value **value)
{
    const int64_t shape[2] = {1, columns};
    const int32_t type = sizeof(candidate_real) == sizeof(double) ? DOUBLE : FLOAT;
    return functions->create_tensor(memory, data, (size_t)columns * sizeof *data, shape, rank, type, value);
}

/*
 * Once, before `candidate`: loads a model whose inputs are the state and, if there are two, beta.
 * The names must stay where they are. Returns what went wrong, or null.
 */
__attribute__((visibility("default"))) const char *prepare(const ort_base *(*get_base)(void), const char *model,
                                                           const char *const *input_names, uint64_t inputs,
                                                           const char *const *output_names)
{
    ort_environment *environment = NULL;
    ort_options *options = NULL;
    ort_memory *memory = NULL;
    ort_status *status;
    functions = get_base()->get_functions(1);
    if (functions == NULL || inputs < 1 || inputs > MOST_INPUTS) {
        return "it has no version 1 of its interface, or the model has other inputs";
    }
    names_in = input_names;
    names_out = output_names;
    count = inputs;
    status = functions->create_environment(LEVEL_ERROR, "bench", &environment);
    status = status != NULL ? status : functions->create_options(&options);
    status = status != NULL ? status : functions->set_threads_within(options, 1);
    status = status != NULL ? status : functions->set_threads_between(options, 1);
    status = status != NULL ? status : functions->create_session(environment, model, options, &session);
    status = status != NULL ? status : functions->create_memory(ARENA, 0, &memory);
    status = status != NULL ? status : tensor(memory, given, COMPONENTS, 2, &values_in[0]);
    status = status != NULL ? status : tensor(memory, given + COMPONENTS, 1, 1, &values_in[1]);
    for (int i = 0; i < CANDIDATE_OUTPUTS; i++) {
        status = status != NULL ? status : tensor(memory, result + i, 1, 1, &values_out[i]);
    }
    return message(status);
}

void candidate(const candidate_real *input, candidate_real *output)
{
    for (int i = 0; i < CANDIDATE_INPUTS; i++) {
        given[i] = input[i];
    }
    for (int i = 0; i < CANDIDATE_OUTPUTS; i++) {
        result[i] = -1000;
    }
    functions->run(session, NULL, names_in, (const ort_value *const *)values_in, count, names_out, CANDIDATE_OUTPUTS,
                   values_out);
    for (int i = 0; i < CANDIDATE_OUTPUTS; i++) {
        output[i] = result[i];
    }
}
