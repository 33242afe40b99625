/* Start-up of a Cortex-M with a floating-point unit, and semihosting: the debugger prints. */
#include "platform.h"

#define COPROCESSOR_ACCESS (*(volatile uint32_t *)0xE000ED88u)
#define FULL_ACCESS_TO_FPU (0xFu << 20)

#define SYS_WRITE0 0x04u
#define SYS_EXIT 0x18u
#define APPLICATION_EXIT ((const void *)0x20026u)

extern uint32_t stack_top;
extern int main(void);
void reset(void);
void fault(void);

__attribute__((section(".vectors"), used)) static void *const vectors[16] = {
    &stack_top, (void *)reset, (void *)fault, (void *)fault, (void *)fault, (void *)fault, (void *)fault};

static void semihosting(uint32_t operation, const void *argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
}

void reset(void)
{
    COPROCESSOR_ACCESS |= FULL_ACCESS_TO_FPU;
    __asm__ volatile("dsb\n\tisb" ::: "memory");
    (void)main();
}

void fault(void)
{
    platform_print("fault\n");
    platform_stop();
}

void platform_print(const char *text)
{
    semihosting(SYS_WRITE0, text);
}

void platform_stop(void)
{
    semihosting(SYS_EXIT, APPLICATION_EXIT);
    for (;;) {
    }
}

uint32_t platform_retired(void)
{
    return 0;
}
