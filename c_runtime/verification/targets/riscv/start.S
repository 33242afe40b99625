/* Start-up of a 32-bit RISC-V, machine mode. */
    .option arch, +zicsr
    .section .start, "ax"
    .globl start
start:
#ifdef __riscv_flen
    li t0, 0x2000           /* mstatus.FS = initial: the floating-point unit is on */
    csrs mstatus, t0
    csrw fcsr, zero         /* round to nearest */
#endif
    la t0, stop
    csrw mtvec, t0
    la sp, stack_top
    call main
    .balign 4               /* also where traps go: no line `done`, so the run counts as failed */
stop:
    j platform_stop

    .text
    .globl platform_retired
platform_retired:
    csrr a0, minstret
    ret
