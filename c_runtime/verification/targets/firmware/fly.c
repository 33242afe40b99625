/*
 * Steers one flight over the console. The other side writes a line a guidance period,
 *
 *   fly R U V PERIOD                                        numbers as the hexadecimals of their bits
 *
 * and is answered
 *
 *   steering STATUS CONE_ANGLE TIME_OF_FLIGHT BETA HOLD LAMBDA_V
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

int main(void)
{
    sailnet_memory memory;
    sailnet_state state = {0, 0, 0};
    sailnet_command command;
    sailnet_start(&memory);
    (void)counted(no_steering, &memory, &state, 0, &command);
    platform_print("ready\n");
    while (platform_read() == 'f') {
        for (int32_t letters = 0; letters < 3; letters++) {
            (void)platform_read(); /* the rest of the word and the blank */
        }
        state.r = read_number();
        state.u = read_number();
        state.v = read_number();
        const sailnet_real period = read_number();
        const sailnet_status status = counted(sailnet_steer, &memory, &state, period, &command);
        const sailnet_real told[5] = {command.cone_angle, command.time_of_flight, command.beta, command.hold,
                                      command.lambda_v};
        platform_print("steering ");
        print_number((uint32_t)status);
        for (int32_t k = 0; k < 5; k++) {
            print_bits(told[k]);
        }
        platform_print("\n");
    }
    platform_print("done\n");
    platform_stop();
    return 0;
}
