/* A software bus with one app on it, and a sail: on the bus it is navigation and attitude control in one. */
#include "../sailnet_app.h"

#include "../../point_mass.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

static point_mass sail = {1.05, 0.15, 1.03};
static double elapsed; /* [TU] */
static int messages;
static bool arrived;

CFE_Status_t CFE_SB_ReceiveBuffer(CFE_SB_Buffer_t **buffer, CFE_SB_PipeId_t pipe, int32 timeout)
{
    static union {
        CFE_SB_Buffer_t buffer;
        SAILNET_APP_State_t state;
    } sent;
    (void)pipe;
    (void)timeout;
    *buffer = &sent.buffer;
    if (messages++ == 0) { /* the ground speaks first */
        sent.buffer.Msg = (CFE_MSG_Message_t){SAILNET_APP_GROUND_MID, sizeof sent.buffer.Msg, SAILNET_APP_START_CC};
        return CFE_SUCCESS;
    }
    sent.state = (SAILNET_APP_State_t){
        {{SAILNET_APP_STATE_MID, sizeof sent.state, 0}}, sail.r, sail.u, sail.v, NAN, 0.005};
    return CFE_SUCCESS;
}

CFE_Status_t CFE_SB_TransmitMsg(const CFE_MSG_Message_t *message, bool count_it)
{
    const SAILNET_APP_Command_t *const command = (const SAILNET_APP_Command_t *)(const void *)message;
    (void)count_it;
    sail = point_mass_after(sail, command->cone_angle, command->hold);
    elapsed += command->hold;
    arrived = command->status == SAILNET_ARRIVED;
    return CFE_SUCCESS;
}

CFE_Status_t CFE_EVS_SendEvent(uint16 id, uint16 type, const char *text, ...)
{
    va_list values;
    printf("%6.2f TU, event %u%s: ", elapsed, (unsigned)id, type == CFE_EVS_EventType_ERROR ? ", error" : "");
    va_start(values, text);
    (void)vprintf(text, values);
    va_end(values);
    (void)putchar('\n');
    return CFE_SUCCESS;
}

CFE_Status_t CFE_EVS_Register(const void *filters, uint16 count, uint16 scheme)
{
    (void)filters;
    (void)count;
    (void)scheme;
    return CFE_SUCCESS;
}

CFE_Status_t CFE_SB_CreatePipe(CFE_SB_PipeId_t *pipe, uint16 depth, const char *name)
{
    (void)depth;
    (void)name;
    *pipe = 1;
    return CFE_SUCCESS;
}

CFE_Status_t CFE_SB_Subscribe(CFE_SB_MsgId_t id, CFE_SB_PipeId_t pipe)
{
    (void)id;
    (void)pipe;
    return CFE_SUCCESS;
}

void CFE_SB_TimeStampMsg(CFE_MSG_Message_t *message)
{
    (void)message;
}

CFE_Status_t CFE_MSG_Init(CFE_MSG_Message_t *message, CFE_SB_MsgId_t id, CFE_MSG_Size_t size)
{
    *message = (CFE_MSG_Message_t){id.Value, (uint32)size, 0};
    return CFE_SUCCESS;
}

CFE_Status_t CFE_MSG_GetMsgId(const CFE_MSG_Message_t *message, CFE_SB_MsgId_t *id)
{
    id->Value = message->id;
    return CFE_SUCCESS;
}

CFE_Status_t CFE_MSG_GetSize(const CFE_MSG_Message_t *message, CFE_MSG_Size_t *size)
{
    *size = message->size;
    return CFE_SUCCESS;
}

CFE_Status_t CFE_MSG_GetFcnCode(const CFE_MSG_Message_t *message, CFE_MSG_FcnCode_t *code)
{
    *code = message->code;
    return CFE_SUCCESS;
}

bool CFE_ES_RunLoop(uint32 *run)
{
    return *run == CFE_ES_RunStatus_APP_RUN && !arrived;
}

void CFE_ES_ExitApp(uint32 run)
{
    printf("arrived after %.4f TU: r %.6f AU, u %+.6f, v %.6f AU/TU\n", elapsed, sail.r, sail.u, sail.v);
    exit(run == CFE_ES_RunStatus_APP_RUN ? EXIT_SUCCESS : EXIT_FAILURE);
}

int main(void)
{
    SAILNET_APP_Main();
    return EXIT_FAILURE; /* an app exits by itself */
}
