/*
 * What Frama-C's Eva proves of the tracker, for any bits of what it remembers, a state and a problem: every index
 * is within its array, nothing is read before it is written, no integer overflows, every loop ends within its budget.
 * Numbers may be NaN or infinite: what is commanded is bounded by sailnet_steer. The contracts by which eva.c knows
 * sailnet_follow and sailnet_take_plan are asserted here.
 */
#include "sailnet_extremal.c"
#undef STATES
#include "sailnet_plan.c"
#undef STATES
#include "sailnet_candidate.c"
#undef STATES
#include "sailnet_tracker.c"

typedef union {
    uint64_t bits[sizeof(sailnet_tracker) / sizeof(uint64_t)];
    sailnet_tracker value;
} any_tracker_bits;
typedef union {
    uint64_t bits[sizeof(sailnet_problem) / sizeof(uint64_t)];
    sailnet_problem value;
} any_problem_bits;
typedef union {
    uint64_t bits[2 * SAILNET_STATES + 4];
    double value[2 * SAILNET_STATES + 4];
} any_numbers_bits;
extern any_tracker_bits tracker_bits;
extern any_problem_bits problem_bits;
extern any_numbers_bits number_bits;
/* However many there are, they are looked at one after the other. */
#define KNOWN 3
typedef union {
    uint32_t bits[KNOWN * (2 * SAILNET_STATES + 2)];
    sailnet_known_plan value[KNOWN];
} any_known_bits;
extern any_known_bits known_bits;

/* Of a guidance period. */
#define BUDGET 8

void prove_tracker(void)
{
    sailnet_planned planned;
    sailnet_tracker *const tracker = &tracker_bits.value;
    const double *const state = number_bits.value;
    const double *const direction = &state[SAILNET_STATES];
    const double *const numbers = &direction[SAILNET_STATES];
    sailnet_time_passes(tracker, numbers[0]);
    const int32_t asked = sailnet_asks(tracker);
    if (asked == SAILNET_ASKS_NETWORKS) {
        sailnet_propose(&problem_bits.value, tracker, direction, numbers[1], KNOWN);
    } else if (asked == SAILNET_ASKS_KNOWN) {
        sailnet_propose_known(&problem_bits.value, tracker, state, numbers[1], known_bits.value, KNOWN);
    } else {
        /*@ assert asked: asked == SAILNET_ASKS_NOTHING; */
    }
    const int32_t flown =
        sailnet_follow(&problem_bits.value, tracker, state, numbers[2], numbers[3], BUDGET, &planned);
    /*@ assert flown: 0 <= flown <= 1; */
    if (flown != 0) {
        /*@ assert planned: \initialized(&planned); */
    }
    /* The plan for another beta, the plan for its own, and the candidate: that they share the budget is tested. */
    /*@ assert budget: 0 <= tracker->computed <= 3 * BUDGET; */
}

void prove_take_plan(void)
{
    const double *const state = number_bits.value;
    const double *const direction = &state[SAILNET_STATES];
    const double *const numbers = &direction[SAILNET_STATES];
    const int32_t taken =
        sailnet_take_plan(&problem_bits.value, &tracker_bits.value, state, direction, numbers[0]);
    /*@ assert taken: 0 <= taken <= 1; */
}
