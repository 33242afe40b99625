/*
 * What Frama-C's Eva proves of an exported guidance, for any bits of every input: see SOUNDNESS.md.
 * The flight file is included as it is; the contracts below stand for some of its functions.
 */
#include "sailnet_guidance.h"

/* The lemmas, which lemmas.c checks. */
#ifdef SAILNET_FLOAT64
#define SMALLEST_POWER 0x1p-1000
#define LARGEST_POWER 0x1p1000
#else
#define SMALLEST_POWER 0x1p-64
#define LARGEST_POWER 0x1p63
#endif
/*@ requires steep: -1000 <= octaves <= 1000;
    assigns \result \from octaves;
    ensures \is_finite(\result) && -0.5 <= \result <= 0.5; */
static sailnet_real sailnet_fraction(sailnet_real octaves);
/*@ requires steep: -1000 <= octaves <= 1000;
    assigns \result \from octaves;
    ensures \is_finite(\result) && SMALLEST_POWER <= \result <= LARGEST_POWER;
    ensures -500 <= octaves <= 500 ==> 0x1p-500 <= \result <= 0x1p500; */
static sailnet_real sailnet_power(sailnet_real octaves);
/*@ requires steep: -1000 <= octaves <= 1000;
    assigns \result \from octaves;
    ensures \is_finite(\result) && -1 <= \result <= 1; */
static sailnet_real sailnet_sigmoid(sailnet_real octaves);
/*@ requires bounds: \is_finite(lower) && \is_finite(upper);
    assigns \result \from value, lower, upper;
    ensures \is_finite(\result) && \result <= upper && (lower <= \result || upper <= \result); */
static sailnet_real sailnet_clamped(sailnet_real value, sailnet_real lower, sailnet_real upper);
/*@ assigns \result \from *value;
    ensures \is_finite(\result) && 0.99e-12 <= \result <= 1.01e12; */
static sailnet_real sailnet_per_root(const sailnet_real *value);
/*@ requires number: \is_finite(value);
    assigns \result \from value;
    ensures \is_finite(\result) && 0 <= \result && (\result == value || \result == -value); */
static sailnet_real sailnet_size(sailnet_real value);
/* The tracker, of which tracker.c proves this: whatever it remembers then, and whatever a plan commands. */
/*@ requires numbers: \valid_read(problem) && \valid(tracker) && \valid_read(state + (0 .. SAILNET_STATES - 1));
    requires written: \valid(planned);
    assigns *tracker \from *problem, *tracker, state[0 .. SAILNET_STATES - 1], estimated, hold, most;
    assigns *planned \from *problem, *tracker, state[0 .. SAILNET_STATES - 1], estimated, hold, most;
    assigns \result \from *problem, *tracker, state[0 .. SAILNET_STATES - 1], estimated, hold, most;
    ensures flown: \result == 0 || (\result == 1 && \initialized(planned)); */
static int32_t sailnet_follow(const sailnet_problem *problem, sailnet_tracker *tracker,
                              const double state[SAILNET_STATES], double estimated, double hold, int32_t most,
                              sailnet_planned *planned);
/*@ requires numbers: \valid_read(problem) && \valid(tracker) && \valid_read(state + (0 .. SAILNET_STATES - 1));
    requires direction: \valid_read(direction + (0 .. SAILNET_STATES - 1));
    assigns *tracker \from *problem, *tracker, state[0 .. SAILNET_STATES - 1],
                           direction[0 .. SAILNET_STATES - 1], time_to_go;
    assigns \result \from *problem, *tracker, state[0 .. SAILNET_STATES - 1],
                           direction[0 .. SAILNET_STATES - 1], time_to_go;
    ensures taken: 0 <= \result <= 1; */
static int32_t sailnet_take_plan(const sailnet_problem *problem, sailnet_tracker *tracker,
                                 const double state[SAILNET_STATES], const double direction[SAILNET_STATES],
                                 double time_to_go);
#if defined(TESTED_HOST) && SAILNET_READS_BETA
/*@ requires range: 0.99e-24 <= value <= 1.01e30;
    assigns \result \from value;
    ensures \is_finite(\result) && 3e-8 <= \result <= 1.01e6; */
static sailnet_real sailnet_inverse_fourth_root(sailnet_real value);
#endif

#include "../tested.h"

/* Any bits, any pointer that is null or valid. */
typedef union {
    sailnet_bits bits[sizeof(sailnet_state) / sizeof(sailnet_bits)];
    sailnet_state value;
} any_state_bits;
typedef union {
    sailnet_bits bits;
    sailnet_real value;
} any_real_bits;
typedef union {
    sailnet_bits bits[sizeof(sailnet_memory) / sizeof(sailnet_bits)];
    sailnet_memory value;
} any_memory_bits;
typedef union {
    uint64_t bits[sizeof(sailnet_arrival) / sizeof(uint64_t)];
    sailnet_arrival value;
} any_plan_bits;
extern any_state_bits state_bits;
extern any_real_bits beta_bits;
extern any_real_bits period_bits;
extern any_real_bits attitude_bits;
extern any_memory_bits memory_bits;
extern any_plan_bits plan_bits;
extern char any_digest[sizeof SAILNET_MISSION_DIGEST];
#define any_state state_bits.value
#define any_beta beta_bits.value
#define any_period period_bits.value
#define any_attitude attitude_bits.value
#define any_memory memory_bits.value
#define any_plan plan_bits.value
extern int any_choice[5];

static void check(const sailnet_command *command)
{
    /* As the compiler rounds them: in ACSL a decimal is a real number. */
    const sailnet_real phi_max = SAILNET_PHI_MAX;
    const sailnet_real beta_min = SAILNET_BETA_MIN;
    const sailnet_real beta_max = SAILNET_BETA_MAX;
    const sailnet_real largest_period = SAILNET_LARGEST_PERIOD;
#if SAILNET_IN_SPACE
    /*@ assert cone_angle: \is_finite(command->cone_angle) && 0 <= command->cone_angle <= phi_max; */
    /*@ assert clock_angle: \is_finite(command->clock_angle) && -\pi < command->clock_angle <= \pi; */
    /*@ assert costates: \is_finite(command->lambda_w) && -1e18 <= command->lambda_v <= 1e18 &&
                         -1e18 <= command->lambda_w <= 1e18; */
#else
    /*@ assert cone_angle: \is_finite(command->cone_angle) && -phi_max <= command->cone_angle <= phi_max; */
#endif
    /*@ assert beta: \is_finite(command->beta) && beta_min <= command->beta <= beta_max; */
    /*@ assert time_of_flight: \is_finite(command->time_of_flight); */
    /*@ assert lambda_v: \is_finite(command->lambda_v); */
    /*@ assert hold: \is_finite(command->hold) && 0 <= command->hold <= largest_period; */
}

void prove_guidance(void)
{
    sailnet_command command;
    (void)sailnet_guidance(any_choice[0] ? &any_state : (const sailnet_state *)0, any_beta, &command);
    check(&command);
}

void prove_steering(void)
{
    sailnet_command command;
#if !SAILNET_IN_SPACE
    if (any_choice[1]) {
        sailnet_measured(&any_memory, any_attitude);
    }
#endif
    (void)sailnet_steer(&any_memory, any_choice[0] ? &any_state : (const sailnet_state *)0, any_period, &command);
    check(&command);
    const sailnet_real beta_min = SAILNET_BETA_MIN;
    const sailnet_real beta_max = SAILNET_BETA_MAX;
    const sailnet_real tangential_max = SAILNET_LARGEST_TANGENTIAL;
    const sailnet_real largest_period = SAILNET_LARGEST_PERIOD;
    /*@ assert memory: \is_finite(any_memory.estimate.beta) && beta_min <= any_memory.estimate.beta <= beta_max; */
#if SAILNET_IN_SPACE
    /*@ assert normal: \is_finite(any_memory.estimate.normal[0]) && -1 <= any_memory.estimate.normal[0] <= 1; */
    /*@ assert along: \is_finite(any_memory.estimate.normal[1]) && -1 <= any_memory.estimate.normal[1] <= 1; */
    /*@ assert northward: \is_finite(any_memory.estimate.normal[2]) && -1 <= any_memory.estimate.normal[2] <= 1; */
#else
    const sailnet_real phi_max = SAILNET_PHI_MAX;
    const sailnet_real offset_max = SAILNET_LARGEST_OFFSET;
    /*@ assert told:
          \is_finite(any_memory.estimate.cone_angle) && -phi_max <= any_memory.estimate.cone_angle <= phi_max; */
    /*@ assert offset:
          \is_finite(any_memory.estimate.offset) && -offset_max <= any_memory.estimate.offset <= offset_max; */
#endif
    /*@ assert tangential:
          \is_finite(any_memory.estimate.tangential) &&
          -tangential_max <= any_memory.estimate.tangential <= tangential_max; */
    /*@ assert variance: \is_finite(any_memory.estimate.variance) && -1 <= any_memory.estimate.variance <= 1; */
    /*@ assert autocovariance:
          \is_finite(any_memory.estimate.autocovariance) && -1 <= any_memory.estimate.autocovariance <= 1; */
    /*@ assert held: \is_finite(any_memory.estimate.held) && 0 <= any_memory.estimate.held <= largest_period; */
}

/* A plan from the ground, of any numbers, in a text of any characters; and what the networks propose. */
void prove_plans(void)
{
    sailnet_arrival arrival;
    sailnet_plan_report report;
    const sailnet_status uploaded = sailnet_plan_upload(
        any_choice[0] ? &any_memory : (sailnet_memory *)0, any_choice[1] ? any_digest : (const char *)0,
        any_choice[2] ? &any_state : (const sailnet_state *)0, any_choice[3] ? &any_plan : (const sailnet_arrival *)0);
    /*@ assert uploaded: uploaded == SAILNET_OK || uploaded == SAILNET_INVALID_INPUT; */
    const sailnet_status proposed = sailnet_propose_plan(any_choice[2] ? &any_state : (const sailnet_state *)0, any_beta,
                                                         any_choice[4] ? &arrival : (sailnet_arrival *)0);
    /*@ assert proposed: proposed == SAILNET_OK || proposed == SAILNET_INVALID_INPUT; */
    if (proposed == SAILNET_OK) {
        /*@ assert arrival: \initialized(&arrival) && \is_finite(arrival.time_to_go) && \is_finite(arrival.beta) &&
              (\forall integer n; 0 <= n < SAILNET_STATES ==> \is_finite(arrival.direction[n])); */
    }
    sailnet_report_plan(any_choice[0] ? &any_memory : (sailnet_memory *)0,
                        any_choice[4] ? &report : (sailnet_plan_report *)0);
}

/* Saved and read again. */
void prove_saving(void)
{
    const sailnet_status status = sailnet_restore(any_choice[0] ? &any_memory : (sailnet_memory *)0);
    /*@ assert restored: status == SAILNET_OK || status == SAILNET_INVALID_INPUT; */
    sailnet_seal(any_choice[1] ? &any_memory : (sailnet_memory *)0);
}

/* Nothing is written through a null pointer, nothing read. */
void prove_null_pointers(void)
{
    sailnet_command command;
    sailnet_start((sailnet_memory *)0);
    sailnet_start(&any_memory);
#if !SAILNET_IN_SPACE
    sailnet_measured((sailnet_memory *)0, any_attitude);
#endif
    (void)sailnet_guidance(&any_state, any_beta, (sailnet_command *)0);
    (void)sailnet_steer(&any_memory, &any_state, any_period, (sailnet_command *)0);
    (void)sailnet_steer((sailnet_memory *)0, &any_state, any_period, &command);
    check(&command);
}
