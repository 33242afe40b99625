/* An app of the core Flight System, for cFE 7; built by the tests with a stand-in for its header, not with cFE itself. */
/* A state message in, a command message out. */
#include "sailnet_app.h"

#include <string.h>

static struct {
    sailnet_memory memory;
    sailnet_status last;
    CFE_SB_PipeId_t pipe;
    SAILNET_APP_Command_t command;
} SAILNET_APP;

static CFE_Status_t initialise(void)
{
    CFE_Status_t status = CFE_EVS_Register(NULL, 0, CFE_EVS_EventFilter_BINARY);
    if (status == CFE_SUCCESS) {
        status = CFE_SB_CreatePipe(&SAILNET_APP.pipe, SAILNET_APP_PIPE_DEPTH, "SAILNET_PIPE");
    }
    if (status == CFE_SUCCESS) {
        status = CFE_SB_Subscribe(CFE_SB_ValueToMsgId(SAILNET_APP_STATE_MID), SAILNET_APP.pipe);
    }
    if (status == CFE_SUCCESS) {
        status = CFE_SB_Subscribe(CFE_SB_ValueToMsgId(SAILNET_APP_GROUND_MID), SAILNET_APP.pipe);
    }
    if (status == CFE_SUCCESS) {
        status = CFE_MSG_Init(CFE_MSG_PTR(SAILNET_APP.command.header), CFE_SB_ValueToMsgId(SAILNET_APP_COMMAND_MID),
                              sizeof SAILNET_APP.command);
    }
    sailnet_start(&SAILNET_APP.memory);
    SAILNET_APP.last = SAILNET_OK;
    return status;
}

static void steer(const SAILNET_APP_State_t *told)
{
    const sailnet_state state = {(sailnet_real)told->r, (sailnet_real)told->u, (sailnet_real)told->v};
    sailnet_command command;
    sailnet_measured(&SAILNET_APP.memory, (sailnet_real)told->cone_angle); /* of a NaN it takes no notice */
    const sailnet_status status = sailnet_steer(&SAILNET_APP.memory, &state, (sailnet_real)told->period, &command);
    SAILNET_APP.command.cone_angle = (double)command.cone_angle;
    SAILNET_APP.command.hold = (double)command.hold;
    SAILNET_APP.command.time_of_flight = (double)command.time_of_flight;
    SAILNET_APP.command.beta = (double)command.beta;
    SAILNET_APP.command.status = (int32)status;
    CFE_SB_TimeStampMsg(CFE_MSG_PTR(SAILNET_APP.command.header));
    (void)CFE_SB_TransmitMsg(CFE_MSG_PTR(SAILNET_APP.command.header), true);
    if (status != SAILNET_APP.last) { /* on change: once a period would be a flood */
        (void)CFE_EVS_SendEvent(SAILNET_APP_STATUS_EID, CFE_EVS_EventType_INFORMATION, "SAILNET: status %d, %d before",
                                (int)status, (int)SAILNET_APP.last);
        SAILNET_APP.last = status;
    }
}

static void obey_ground(const CFE_MSG_Message_t *message)
{
    CFE_MSG_FcnCode_t code = 0;
    (void)CFE_MSG_GetFcnCode(message, &code);
    if (code == SAILNET_APP_START_CC) {
        sailnet_start(&SAILNET_APP.memory);
        (void)CFE_EVS_SendEvent(SAILNET_APP_STARTED_EID, CFE_EVS_EventType_INFORMATION, "SAILNET: a flight begins");
    } else {
        (void)CFE_EVS_SendEvent(SAILNET_APP_UNKNOWN_EID, CFE_EVS_EventType_ERROR, "SAILNET: no command %u",
                                (unsigned)code);
    }
}

static void take(const CFE_SB_Buffer_t *buffer)
{
    CFE_SB_MsgId_t id = CFE_SB_INVALID_MSG_ID;
    CFE_MSG_Size_t size = 0;
    (void)CFE_MSG_GetMsgId(&buffer->Msg, &id);
    (void)CFE_MSG_GetSize(&buffer->Msg, &size);
    const uint32 value = (uint32)CFE_SB_MsgIdToValue(id);
    if (value == SAILNET_APP_STATE_MID && size == sizeof(SAILNET_APP_State_t)) {
        SAILNET_APP_State_t told;
        memcpy(&told, buffer, sizeof told);
        steer(&told);
    } else if (value == SAILNET_APP_GROUND_MID) {
        obey_ground(&buffer->Msg);
    } else {
        (void)CFE_EVS_SendEvent(SAILNET_APP_UNKNOWN_EID, CFE_EVS_EventType_ERROR, "SAILNET: message 0x%x of %u bytes",
                                (unsigned)value, (unsigned)size);
    }
}

void SAILNET_APP_Main(void)
{
    uint32 run = CFE_ES_RunStatus_APP_RUN;
    if (initialise() != CFE_SUCCESS) {
        run = CFE_ES_RunStatus_APP_ERROR;
    }
    while (CFE_ES_RunLoop(&run)) {
        CFE_SB_Buffer_t *buffer = NULL;
        const CFE_Status_t status = CFE_SB_ReceiveBuffer(&buffer, SAILNET_APP.pipe, CFE_SB_PEND_FOREVER);
        if (status == CFE_SUCCESS && buffer != NULL) {
            take(buffer);
        } else {
            (void)CFE_EVS_SendEvent(SAILNET_APP_PIPE_EID, CFE_EVS_EventType_ERROR, "SAILNET: pipe, 0x%08X",
                                    (unsigned)status);
            run = CFE_ES_RunStatus_APP_ERROR;
        }
    }
    CFE_ES_ExitApp(run);
}
