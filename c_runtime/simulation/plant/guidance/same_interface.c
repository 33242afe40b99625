/*
 * Compiled with every exported guidance that is to fly: does not compile unless what that guidance gives is
 * what the plant takes, and what it reads what the plant shows. A negative size of an array is how C99 asserts.
 */
#include <stddef.h>

#include "sailnet_batch.h"
#include "sailnet_plant.h"

/* Flight files of the plane may not say so. */
#if defined(SAILNET_IN_SPACE) && SAILNET_IN_SPACE
#define COMMAND PLANT_COMMAND_IN_SPACE
#define STATE PLANT_SHOWN_IN_SPACE
#else
#define COMMAND PLANT_COMMAND
#define STATE PLANT_SHOWN
#endif

typedef struct {
    COMMAND(PLANT_MEMBER, sailnet_real)
} taken;

typedef struct {
    STATE(PLANT_MEMBER, sailnet_real)
} shown;

#define SAME(name, condition) extern const char plant_takes_the_same_##name[(condition) ? 1 : -1];
#define MEMBER(type, name, extent)                                                         \
    SAME(name, offsetof(taken, name) == offsetof(sailnet_command, name) &&                 \
                   sizeof(((taken *)0)->name) == sizeof(((sailnet_command *)0)->name))
#define COMPONENT(type, name, extent)                                          \
    SAME(state_##name, offsetof(shown, name) == offsetof(sailnet_state, name))
#define VALUE(name, number) SAME(name, (int)PLANT_##name == (int)SAILNET_##name)

COMMAND(MEMBER, sailnet_real)
STATE(COMPONENT, sailnet_real)
PLANT_STATUS(VALUE)
SAME(size, sizeof(taken) == sizeof(sailnet_command))
SAME(state_size, sizeof(shown) == sizeof(sailnet_state))
