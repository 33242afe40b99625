/*
 * Steers one flight over the console. The other side writes a line a guidance period,
 *
 *   fly R U V PERIOD                                        numbers as the hexadecimals of their bits
 *   fly R LATITUDE U V W PERIOD                             in space
 *
 * and is answered
 *
 *   steering STATUS CONE_ANGLE TIME_OF_FLIGHT BETA HOLD LAMBDA_V
 *   steering STATUS CONE_ANGLE CLOCK_ANGLE TIME_OF_FLIGHT BETA HOLD LAMBDA_V LAMBDA_W
 *
 * until it writes `end`. Instructions are counted from outside, as of golden vectors: the first call counted is
 * of a function that does nothing.
 */
#include "console.h"

#include <string.h>

typedef sailnet_status (*steering)(sailnet_memory *, const sailnet_state *, sailnet_real, sailnet_command *);

APART static sailnet_status no_steering(sailnet_memory *memory, const sailnet_state *state, sailnet_real period,
                                        sailnet_command *command)
{
    (void)memory;
    (void)state;
    (void)period;
    (void)command;
    return SAILNET_OK;
}

APART static sailnet_status counted(steering steer, sailnet_memory *memory, const sailnet_state *state,
                                    sailnet_real period, sailnet_command *command)
{
    count_begin();
    const sailnet_status status = steer(memory, state, period, command);
    count_end();
    return status;
}

/* A number after blanks; what ends it is read too. */
static sailnet_real read_number(void)
{
    real_bits bits = 0;
    char letter = platform_read();
    while (letter == ' ') {
        letter = platform_read();
    }
    while (letter != ' ' && letter != '\n') {
        bits = bits << 4 | (real_bits)(letter <= '9' ? letter - '0' : letter - 'a' + 10);
        letter = platform_read();
    }
    return number(bits);
}

static void read_state(sailnet_state *state)
{
    state->r = read_number();
#if SAILNET_IN_SPACE
    state->latitude = read_number();
#endif
    state->u = read_number();
    state->v = read_number();
#if SAILNET_IN_SPACE
    state->w = read_number();
#endif
}

static void print_command(const sailnet_command *command)
{
    print_bits(command->cone_angle);
#if SAILNET_IN_SPACE
    print_bits(command->clock_angle);
#endif
    print_bits(command->time_of_flight);
    print_bits(command->beta);
    print_bits(command->hold);
    print_bits(command->lambda_v);
#if SAILNET_IN_SPACE
    print_bits(command->lambda_w);
#endif
}

int main(void)
{
    sailnet_memory memory;
    sailnet_state state;
    sailnet_command command;
    memset(&state, 0, sizeof state);
    sailnet_start(&memory);
    (void)counted(no_steering, &memory, &state, 0, &command);
    platform_print("ready\n");
    while (platform_read() == 'f') {
        for (int32_t letters = 0; letters < 3; letters++) {
            (void)platform_read(); /* the rest of the word and the blank */
        }
        read_state(&state);
        const sailnet_real period = read_number();
        const sailnet_status status = counted(sailnet_steer, &memory, &state, period, &command);
        platform_print("steering ");
        print_number((uint32_t)status);
        print_command(&command);
        platform_print("\n");
    }
    platform_print("done\n");
    platform_stop();
    return 0;
}
