/* What a board has to do for main.c; board_desk.c does it on a desk. */
#ifndef BOARD_H
#define BOARD_H

#include "sailnet_guidance.h"

#include <stdbool.h>

/* The state by navigation, of this moment; false without one. */
bool board_navigate(sailnet_state *state);
/* The mean cone angle since the last call [rad], as measured; false where nothing measures it. */
bool board_attitude(sailnet_real *cone_angle);
/* Turn to a cone angle [rad] and keep it; returns when `hold` [TU] are over. */
void board_hold(sailnet_real cone_angle, sailnet_real hold);
/* To the ground. */
void board_report(sailnet_status status, const sailnet_command *command);
/* The target orbit is reached. */
void board_arrived(void);

#endif
