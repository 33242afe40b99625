/* What a caller that loads the plant as a shared library asks before it flies. */
#include <stddef.h>

#include "sailnet_plant.h"

#define MEMBER(type, name, extent) \
    visit(owner, #name, #type, offsetof(structure, name), sizeof(((structure *)0)->name));
#define VALUE(name, number) visit(owner, #name, "", (number), 0u);

#define STRUCTURE(of, members)                       \
    {                                                \
        typedef of structure;                        \
        const char *const owner = #of;               \
        visit(owner, "", "", 0u, sizeof(structure)); \
        members(MEMBER)                              \
    }
#define ENUMERATION(of, values)        \
    {                                  \
        const char *const owner = #of; \
        visit(owner, "", "", 0u, 0u);  \
        values(VALUE)                  \
    }

/* A structure comes after those that it holds. */
void plant_describe(plant_visit *visit)
{
    STRUCTURE(plant_state, PLANT_STATE)
    STRUCTURE(plant_optics, PLANT_OPTICS)
    STRUCTURE(plant_attitude, PLANT_ATTITUDE)
    STRUCTURE(plant_turn, PLANT_TURN)
    STRUCTURE(plant_rules, PLANT_RULES)
    STRUCTURE(plant_sail, PLANT_SAIL)
    STRUCTURE(plant_record, PLANT_RECORD)
    STRUCTURE(plant_command_f32, PLANT_COMMAND_F32)
    STRUCTURE(plant_command_f64, PLANT_COMMAND_F64)
    STRUCTURE(plant_command_in_space_f32, PLANT_COMMAND_IN_SPACE_F32)
    STRUCTURE(plant_command_in_space_f64, PLANT_COMMAND_IN_SPACE_F64)
    STRUCTURE(plant_steering, PLANT_STEERING)
    STRUCTURE(plant_flights, PLANT_FLIGHTS)
    ENUMERATION(plant_ending, PLANT_ENDING)
    ENUMERATION(plant_status, PLANT_STATUS)
}

uint32_t plant_api_version(void)
{
    return PLANT_API_VERSION;
}

#ifndef PLANT_SOURCES_DIGEST
#define PLANT_SOURCES_DIGEST ""
#endif

const char *plant_sources_digest(void)
{
    return PLANT_SOURCES_DIGEST;
}
