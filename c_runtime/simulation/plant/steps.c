/* By how much a command changes from one period to the next: what the actuator is asked to do. */
#include <math.h>

#include "sailnet_plant.h"

#define SIZES_PER_OCTAVE 16
/* Octave 0 begins at 2^-14 rad, 0.0035 degrees; the last ends at 4 rad, and no step within +-pi/2, and no
   angle between normals, is larger. */
#define FIRST_OCTAVE (-14)

static uint32_t size_of(double step)
{
    if (step < ldexp(1.0, FIRST_OCTAVE)) {
        return 0u;
    }
    int octave;
    const double half = frexp(step, &octave); /* step = half 2^octave, and half is from 1/2 to 1 */
    const int size = SIZES_PER_OCTAVE * (octave - 1 - FIRST_OCTAVE) + (int)((2.0 * half - 1.0) * SIZES_PER_OCTAVE);
    return size < PLANT_STEP_SIZES ? (uint32_t)size : PLANT_STEP_SIZES - 1u;
}

double plant_step_edge(uint32_t size)
{
    const double share = 1.0 + (double)(size % SIZES_PER_OCTAVE + 1u) / SIZES_PER_OCTAVE;
    return ldexp(share, (int)(size / SIZES_PER_OCTAVE) + FIRST_OCTAVE);
}

void plant_count_step(const plant_rules *rules, double step, plant_sail *sail)
{
    const double size = fabs(step);
    if (!isfinite(size)) {
        return;
    }
    sail->command_slew += size;
    sail->reversals += size > rules->reversal;
    sail->steps[size_of(size)]++;
}
