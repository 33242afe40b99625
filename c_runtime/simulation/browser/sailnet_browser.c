/*
 * One sail at a time for a page in a browser: the flight file and the plant, compiled together to WebAssembly.
 *
 * A page cannot hand over structures, only numbers: so they stand here, one of each, and a page writes and reads them
 * where they are, by the names and offsets that browser_layout tells. Nothing is imported: no clock, no files.
 */
#include <string.h>

#include "sailnet_batch.h"
#include "sailnet_plant.h"

#ifdef __wasm__
#define EXPORTED(name) __attribute__((export_name(#name)))
#else /* a library of the same, which tests hold beside it */
#define EXPORTED(name)
#endif

/* Guidance periods that are flown in one call, and commands under way: what is delayed for longer is refused. */
#define PERIODS 256u
#define SLOTS 4096u

static plant_rules rules;
static plant_sail sail;
static plant_record records[PERIODS];
static sailnet_memory memory;
static sailnet_command command;

static plant_attitude queue[SLOTS];
static uint64_t row;
static double seen[3];
static double attitude;
static int32_t status;
static plant_flights flights;

#define TEXT 16384u
static char layout[TEXT];
static uint32_t written;

static void put_text(const char *text)
{
    while (*text != '\0' && written < TEXT - 1u) {
        layout[written++] = *text++;
    }
    layout[written] = '\0';
}

static void put_number(uint64_t number)
{
    char digits[21] = {0};
    uint32_t first = sizeof digits - 1u;
    do {
        digits[--first] = (char)('0' + number % 10u);
        number /= 10u;
    } while (number > 0u);
    put_text(&digits[first]);
}

static void put_member(const char *owner, const char *name, const char *type, uint64_t offset, uint64_t size)
{
    put_text(owner);
    put_text(",");
    put_text(name);
    put_text(",");
    put_text(type);
    put_text(",");
    put_number(offset);
    put_text(",");
    put_number(size);
    put_text("\n");
}

/* What plant_describe tells, a line each: structure, member, type, offset, size. */
EXPORTED(browser_layout) const char *browser_layout(void)
{
    written = 0u;
    plant_describe(put_member);
    return layout;
}

/* Where the page writes plant_rules before a flight, and reads of it plant_sail and plant_record[]. */
EXPORTED(browser_rules) plant_rules *browser_rules(void)
{
    return &rules;
}

EXPORTED(browser_sail) const plant_sail *browser_sail(void)
{
    return &sail;
}

EXPORTED(browser_records) const plant_record *browser_records(void)
{
    return records;
}

/* The law alone: its status; the command is a plant_command_f64 at browser_command. */
EXPORTED(browser_guidance) int32_t browser_guidance(double r, double u, double v, double beta)
{
    const sailnet_state state = {r, u, v};
    return (int32_t)sailnet_guidance(&state, beta, &command);
}

EXPORTED(browser_command) const sailnet_command *browser_command(void)
{
    return &command;
}

/* Begin a flight from r, u, v by the rules; returns 0, and none begins, if the delay is too long. */
EXPORTED(browser_depart) int32_t browser_depart(double r, double u, double v)
{
    const plant_flights begun = {
        .count = 1u,
        .flying = 1u,
        .sails = &sail,
        .rows = &row,
        .queue = queue,
        .states = seen,
        .attitudes = &attitude,
        .commands = &command,
        .statuses = &status,
    };
    if (plant_queue_slots(&rules) > SLOTS) {
        return 0;
    }
    (void)memset(&sail, 0, sizeof sail);
    (void)memset(queue, 0, sizeof queue);
    sail.state.r = r;
    sail.state.u = u;
    sail.state.v = v;
    row = 0u;
    flights = begun;
    sailnet_start(&memory);
    return 1;
}

/* Fly on; returns for how many periods, of which there are as many records: 0 once the flight has ended. */
EXPORTED(browser_fly) uint32_t browser_fly(void)
{
    const plant_steering steering = {.f64 = (plant_steer_f64 *)sailnet_steer_batch, .memories = &memory};
    const uint32_t before = sail.periods;
    (void)plant_fly(&rules, &steering, &flights, PERIODS, records);
    return sail.periods - before;
}

#ifndef BROWSER_SOURCES_DIGEST
#define BROWSER_SOURCES_DIGEST ""
#endif

/* SHA-256 of all that this was compiled from. */
EXPORTED(browser_sources_digest) const char *browser_sources_digest(void)
{
    return BROWSER_SOURCES_DIGEST;
}
