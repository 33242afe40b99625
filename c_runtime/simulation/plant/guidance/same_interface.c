/*
 * Compiled with every exported guidance that is to fly: does not compile unless what that guidance gives is
 * what the plant takes. A negative size of an array is how C99 asserts.
 */
#include <stddef.h>

#include "sailnet_batch.h"
#include "sailnet_plant.h"

typedef struct {
    PLANT_COMMAND(PLANT_MEMBER, sailnet_real)
} taken;

#define SAME(name, condition) extern const char plant_takes_the_same_##name[(condition) ? 1 : -1];
#define MEMBER(type, name, extent)                                                         \
    SAME(name, offsetof(taken, name) == offsetof(sailnet_command, name) &&                 \
                   sizeof(((taken *)0)->name) == sizeof(((sailnet_command *)0)->name))
#define VALUE(name, number) SAME(name, (int)PLANT_##name == (int)SAILNET_##name)

/* What is commanded in three dimensions the plant does not take yet. */
#if !defined(SAILNET_IN_SPACE)
PLANT_COMMAND(MEMBER, sailnet_real)
SAME(size, sizeof(taken) == sizeof(sailnet_command))
#endif
PLANT_STATUS(VALUE)
