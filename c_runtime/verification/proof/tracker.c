/*
 * What Frama-C's Eva proves of the tracker, for any bits of a plan, a state, a problem and a beta: every index is
 * within its array, nothing is read before it is written, no integer overflows, every loop ends within its budget.
 * Numbers may be NaN or infinite: what is commanded is bounded elsewhere.
 */
#include "sailnet_extremal.c"
#undef STATES
#define size_of size_of_number
#include "sailnet_plan.c"

typedef union {
    uint64_t bits[sizeof(sailnet_plan) / sizeof(uint64_t)];
    sailnet_plan value;
} any_plan_bits;
typedef union {
    uint64_t bits[sizeof(sailnet_problem) / sizeof(uint64_t)];
    sailnet_problem value;
} any_problem_bits;
typedef union {
    uint64_t bits[SAILNET_STATES + 2];
    double value[SAILNET_STATES + 2];
} any_numbers_bits;
extern any_plan_bits plan_bits;
extern any_problem_bits problem_bits;
extern any_numbers_bits number_bits;
extern int32_t any_budget;

void prove_tracker(void)
{
    sailnet_end end;
    sailnet_attitude attitude;
    const double *const numbers = number_bits.value;
    const int32_t most = any_budget;
    if ((most > 0) && (most <= SAILNET_MOST_EXTREMALS)) {
        const int32_t computed =
            sailnet_track(&problem_bits.value, numbers, numbers[SAILNET_STATES], most, &plan_bits.value, &end);
        sailnet_planned_attitude(&problem_bits.value, &end, numbers[SAILNET_STATES + 1], &attitude);
        /*@ assert budget: computed <= 2 * SAILNET_MOST_EXTREMALS; */
    }
}
