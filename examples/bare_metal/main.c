/* The main loop of a flight computer without an operating system: once a guidance period a state in, a command out. */
#include "board.h"
#include "sailnet_guidance.h"

#include <stddef.h>

#define PERIOD SAILNET_REAL(0.005) /* [TU], 7 hours: what the networks were tested with */

int main(void)
{
    static sailnet_memory memory; /* all that is remembered: keep a copy where a reset leaves it */
    sailnet_status status;
    sailnet_start(&memory);
    do {
        sailnet_state state;
        sailnet_real cone_angle;
        sailnet_command command;
        const bool navigated = board_navigate(&state);
        if (board_attitude(&cone_angle)) {
            sailnet_measured(&memory, cone_angle);
        }
        /* Without a state the sail is steered by where it must be: a null pointer says so. */
        status = sailnet_steer(&memory, navigated ? &state : NULL, PERIOD, &command);
        board_report(status, &command);
        board_hold(command.cone_angle, command.hold);
    } while (status != SAILNET_ARRIVED);
    board_arrived();
    return 0;
}
