/* QEMU's machine "virt": a 16550 serial port and a register that ends the emulation. */
#include "platform.h"

#define SERIAL_PORT (*(volatile uint8_t *)0x10000000u)
#define SERIAL_STATUS (*(volatile uint8_t *)0x10000005u)
#define RECEIVED 1u
#define TEST_FINISHER (*(volatile uint32_t *)0x100000u)
#define PASS 0x5555u

void platform_print(const char *text)
{
    for (; *text != '\0'; text++) {
        SERIAL_PORT = (uint8_t)*text;
    }
}

char platform_read(void)
{
    while ((SERIAL_STATUS & RECEIVED) == 0) {
    }
    return (char)SERIAL_PORT;
}

void platform_stop(void)
{
    TEST_FINISHER = PASS;
    for (;;) {
    }
}
