/*
 * Runs the golden vectors on a target and prints, line by line,
 *
 *   guidance STATUS CONE_ANGLE TIME_OF_FLIGHT BETA HOLD     a command, numbers as the hexadecimals of their bits
 *   steering STATUS CONE_ANGLE TIME_OF_FLIGHT BETA HOLD
 *   stack WHICH BYTES                                       the most that a call wrote below its caller's frame
 *   retired WHICH INSTRUCTIONS                              by the processor's own counter, all calls together
 *   exceeded COMMANDS                                       how many differ from the reference by more than the bound
 *   done
 *
 * Instructions are counted from outside (count_instructions.c), between count_begin and count_end. Of
 * either kind the first call counted is of a function that does nothing: what calling costs.
 */
#include "console.h"
#include "golden.h"

#include <stddef.h>

#define PAINT UINT32_C(0x5AA5C33C)
#define PAINTED_WORDS 4096

#if defined(__x86_64__)
register uintptr_t stack_pointer __asm__("rsp");
#elif defined(__powerpc__)
register uintptr_t stack_pointer __asm__("r1");
#else
register uintptr_t stack_pointer __asm__("sp");
#endif

typedef struct {
    const sailnet_state *state;
    sailnet_real other; /* beta of guidance, period of steering */
    sailnet_memory *memory;
    sailnet_command *command;
} call;

typedef sailnet_status (*law)(const sailnet_state *, sailnet_real, sailnet_command *);
typedef sailnet_status (*steering)(sailnet_memory *, const sailnet_state *, sailnet_real, sailnet_command *);

typedef struct {
    uint32_t stack;   /* largest [bytes] */
    uint32_t retired; /* all calls together */
} cost;

APART static sailnet_status no_law(const sailnet_state *state, sailnet_real beta, sailnet_command *command)
{
    (void)state;
    (void)beta;
    (void)command;
    return SAILNET_OK;
}

APART static sailnet_status no_steering(sailnet_memory *memory, const sailnet_state *state, sailnet_real period,
                                        sailnet_command *command)
{
    (void)memory;
    (void)state;
    (void)period;
    (void)command;
    return SAILNET_OK;
}

/* One call, counted, of whichever function is given. The stack below this frame is painted before. */
APART static sailnet_status counted(law guidance, steering steer, const call *with, cost *most)
{
    volatile uint32_t *const top = (volatile uint32_t *)stack_pointer;
    volatile uint32_t *word = top - PAINTED_WORDS;
    sailnet_status status;
    for (; word < top; word++) {
        *word = PAINT;
    }
    const uint32_t before = platform_retired();
    if (guidance != NULL) {
        count_begin();
        status = guidance(with->state, with->other, with->command);
        count_end();
    } else {
        count_begin();
        status = steer(with->memory, with->state, with->other, with->command);
        count_end();
    }
    most->retired += platform_retired() - before;
    for (word = top - PAINTED_WORDS; word < top && *word == PAINT; word++) {
    }
    const uint32_t used = (uint32_t)((uintptr_t)top - (uintptr_t)word);
    most->stack = used > most->stack ? used : most->stack;
    return status;
}

/* Whether all four numbers are within their bounds of the reference, and the status is the same. */
static uint32_t agrees(const golden_row *golden, sailnet_status status, const sailnet_real output[4],
                       const sailnet_real bounds[4])
{
    uint32_t within = (int32_t)status == golden->status;
    for (int32_t i = 0; i < 4; i++) {
        const sailnet_real expected = number(golden->expected[i]);
        const sailnet_real size = expected < 0 ? -expected : expected;
        const sailnet_real allowed = bounds[i] * (1 + size);
        const sailnet_real difference = output[i] - expected;
        within &= (difference <= allowed) & (difference >= -allowed);
    }
    return within;
}

static void print_cost(const char *what, const char *which, uint32_t value)
{
    platform_print(what);
    platform_print(which);
    print_number(value);
    platform_print("\n");
}

static uint32_t run(const char *which, law guidance, steering steer, const golden_row *rows, uint32_t count,
                    const sailnet_real bounds[4])
{
    uint32_t exceeded = 0;
    cost most = {0, 0};
    sailnet_memory memory;
    for (uint32_t i = 0; i < count; i++) {
        const sailnet_state state = {number(rows[i].input[0]), number(rows[i].input[1]),
                                     number(rows[i].input[2])};
        sailnet_command command;
        const call with = {&state, number(rows[i].input[3]), &memory, &command};
        if (rows[i].starts) {
            sailnet_start(&memory);
        }
        const sailnet_status status = counted(guidance, steer, &with, &most);
        const sailnet_real output[4] = {command.cone_angle, command.time_of_flight, command.beta, command.hold};
        exceeded += 1 - agrees(&rows[i], status, output, bounds);
        platform_print(which);
        print_number((uint32_t)status);
        for (int32_t k = 0; k < 4; k++) {
            print_bits(output[k]);
        }
        platform_print("\n");
    }
    print_cost("stack ", which, most.stack);
    print_cost("retired ", which, most.retired);
    return exceeded;
}

int main(void)
{
    cost ignored = {0, 0};
    const call nothing = {NULL, 0, NULL, NULL};
    (void)counted(no_law, NULL, &nothing, &ignored);
    print_cost("retired ", "no_guidance ", ignored.retired);
    uint32_t exceeded =
        run("guidance ", sailnet_guidance, NULL, golden_commands, GOLDEN_COMMANDS, golden_command_bounds);
    ignored.retired = 0;
    (void)counted(NULL, no_steering, &nothing, &ignored);
    print_cost("retired ", "no_steering ", ignored.retired);
    exceeded += run("steering ", NULL, sailnet_steer, golden_steps, GOLDEN_STEPS, golden_step_bounds);
    print_cost("exceeded ", "", exceeded);
    platform_print("done\n");
    platform_stop();
    return 0;
}
