/* The serial port of a LEON3. */
#include "platform.h"

#define SERIAL_DATA (*(volatile uint32_t *)0x80000100u)
#define SERIAL_STATUS (*(volatile uint32_t *)0x80000104u)
#define SERIAL_CONTROL (*(volatile uint32_t *)0x80000108u)
#define RECEIVED 1u
#define ROOM_TO_SEND 4u
#define RECEIVER_AND_SENDER_ON 3u

void platform_print(const char *text)
{
    SERIAL_CONTROL = RECEIVER_AND_SENDER_ON;
    for (; *text != '\0'; text++) {
        while ((SERIAL_STATUS & ROOM_TO_SEND) == 0) {
        }
        SERIAL_DATA = (uint32_t)(uint8_t)*text;
    }
}

char platform_read(void)
{
    while ((SERIAL_STATUS & RECEIVED) == 0) {
    }
    return (char)SERIAL_DATA;
}
