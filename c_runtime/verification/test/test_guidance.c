/*
 * Unit tests of an exported guidance, in one translation unit with the flight file itself, to reach its parts.
 * Random numbers are drawn one after the other: what a part draws depends on those before it.
 */
#include "law.inc"
#include "elementary.inc"
#include "steering.inc"
#include "reckoning.inc"
#include "learning.inc"
#include "tracker.inc"
#include "plans.inc"
#include "known_plans.inc"
#include "saving.inc"
#if !SAILNET_IN_SPACE
#include "measured_attitude.inc"
#endif
#include "batch.inc"
#include "ageing.inc"

int main(void)
{
    test_law();
    test_elementary_functions();
    test_steering();
    test_reckoning();
    test_tracker();
    test_plans();
    test_known_plans();
    test_saving();
    test_learning();
#if !SAILNET_IN_SPACE
    test_measured_attitude();
#endif
    test_batches();
    test_ageing();
    test_without_a_plan_a_flight_ends_where_the_target_is_nearest();
    printf("%s, %s: %s\n", SAILNET_MISSION, sizeof(sailnet_real) == 8 ? "float64" : "float32",
           failures == 0 ? "all passed" : "FAILED");
    return failures == 0 ? 0 : 1;
}
