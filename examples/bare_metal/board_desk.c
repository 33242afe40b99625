/* A board on a desk: its sail is a few lines of arithmetic, its radio a terminal. Replace this file. */
#include "board.h"

#include "../point_mass.h"

#include <stdio.h>

static point_mass sail = {1.05, 0.15, 1.03};
static double elapsed; /* [TU] */
static unsigned periods;

bool board_navigate(sailnet_state *state)
{
    state->r = (sailnet_real)sail.r;
    state->u = (sailnet_real)sail.u;
    state->v = (sailnet_real)sail.v;
    return periods % 500u != 499u; /* now and then there is no fix */
}

bool board_attitude(sailnet_real *cone_angle)
{
    (void)cone_angle;
    return false;
}

void board_hold(sailnet_real cone_angle, sailnet_real hold)
{
    sail = point_mass_after(sail, (double)cone_angle, (double)hold);
    elapsed += (double)hold;
    periods++;
}

void board_report(sailnet_status status, const sailnet_command *command)
{
    if (periods % 250u == 0u || status == SAILNET_ARRIVED) {
        printf("%5.2f TU: cone angle %+6.3f rad, %5.2f TU to go, status %d\n", elapsed, (double)command->cone_angle,
               (double)command->time_of_flight, (int)status);
    }
}

void board_arrived(void)
{
    printf("arrived after %.4f TU: r %.6f AU, u %+.6f, v %.6f AU/TU\n", elapsed, sail.r, sail.u, sail.v);
}
