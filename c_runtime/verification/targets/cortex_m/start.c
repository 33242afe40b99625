/* Start-up of a Cortex-M with a floating-point unit, and the first serial port of an MPS2 board. */
#include "platform.h"

#define COPROCESSOR_ACCESS (*(volatile uint32_t *)0xE000ED88u)
#define FULL_ACCESS_TO_FPU (0xFu << 20)

#define SERIAL_DATA (*(volatile uint32_t *)0x40004000u)
#define SERIAL_STATE (*(volatile uint32_t *)0x40004004u)
#define SERIAL_CONTROL (*(volatile uint32_t *)0x40004008u)
#define SERIAL_DIVISOR (*(volatile uint32_t *)0x40004010u)
#define NO_ROOM_TO_SEND 1u
#define RECEIVED 2u
#define SENDER_AND_RECEIVER_ON 3u
#define FASTEST 16u

/* Semihosting: the debugger ends the emulation. */
#define SYS_EXIT 0x18u
#define APPLICATION_EXIT 0x20026u

extern uint32_t stack_top;
extern int main(void);
void reset(void);
void fault(void);

__attribute__((section(".vectors"), used)) static void *const vectors[16] = {
    &stack_top, (void *)reset, (void *)fault, (void *)fault, (void *)fault, (void *)fault, (void *)fault};

void reset(void)
{
    COPROCESSOR_ACCESS |= FULL_ACCESS_TO_FPU;
    __asm__ volatile("dsb\n\tisb" ::: "memory");
    SERIAL_DIVISOR = FASTEST;
    SERIAL_CONTROL = SENDER_AND_RECEIVER_ON;
    (void)main();
}

void fault(void)
{
    platform_print("fault\n");
    platform_stop();
}

void platform_print(const char *text)
{
    for (; *text != '\0'; text++) {
        while ((SERIAL_STATE & NO_ROOM_TO_SEND) != 0) {
        }
        SERIAL_DATA = (uint32_t)(uint8_t)*text;
    }
}

char platform_read(void)
{
    while ((SERIAL_STATE & RECEIVED) == 0) {
    }
    return (char)SERIAL_DATA;
}

void platform_stop(void)
{
    register uint32_t r0 __asm__("r0") = SYS_EXIT;
    register uint32_t r1 __asm__("r1") = APPLICATION_EXIT;
    for (;;) {
        __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    }
}

uint32_t platform_retired(void)
{
    return 0;
}
