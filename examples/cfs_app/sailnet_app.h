/* Messages of the app. The numbers of the messages are the mission's to choose. */
#ifndef SAILNET_APP_H
#define SAILNET_APP_H

#include "cfe.h"
#include "sailnet_guidance.h"

#define SAILNET_APP_STATE_MID 0x18C0 /* from navigation, once a guidance period */
#define SAILNET_APP_GROUND_MID 0x18C1
#define SAILNET_APP_COMMAND_MID 0x08C0 /* to the attitude control */

#define SAILNET_APP_START_CC 0 /* function codes of the ground's commands */
#define SAILNET_APP_PIPE_DEPTH 8

#define SAILNET_APP_STARTED_EID 1
#define SAILNET_APP_STATUS_EID 2
#define SAILNET_APP_UNKNOWN_EID 3
#define SAILNET_APP_PIPE_EID 4

typedef struct {
    CFE_MSG_CommandHeader_t header;
    double r;          /* [AU] */
    double u, v;       /* [AU/TU] */
    double cone_angle; /* mean since the last message [rad], as measured; NaN where not */
    double period;     /* until the next [TU] */
} SAILNET_APP_State_t;

typedef struct {
    CFE_MSG_TelemetryHeader_t header;
    double cone_angle;     /* to hold [rad] */
    double hold;           /* for so long [TU] */
    double time_of_flight; /* still to go, predicted [TU] */
    double beta;           /* estimate */
    int32 status;          /* sailnet_status */
} SAILNET_APP_Command_t;

void SAILNET_APP_Main(void);

#endif
