/* Start-up of a LEON3 (SPARC V8 with eight register windows): traps, floating-point unit, stack. */
#define WINDOWS 8
#define PSR_SUPERVISOR 0x1080   /* floating-point unit on, traps off, window 0 */
#define PSR_TRAPS 0x20
#define FRAME 96

    .section .start, "ax"
    .globl trap_table
    .align 4096
trap_table:
    /* 0: reset */
    ba start
    nop
    nop
    nop
    /* 1 to 4 */
    .rept 4
    ba unexpected
    nop
    nop
    nop
    .endr
    /* 5: a save found no free window */
    ba window_overflow
    rd %wim, %l3
    nop
    nop
    /* 6: a restore found its window in memory */
    ba window_underflow
    rd %wim, %l3
    nop
    nop
    .rept 249
    ba unexpected
    nop
    nop
    nop
    .endr

    .globl start
start:
    set trap_table, %g1
    wr %g1, %tbr
    set PSR_SUPERVISOR, %g1
    wr %g1, %psr
    nop
    nop
    nop
    wr %g0, 2, %wim
    nop
    nop
    nop
    set PSR_SUPERVISOR | PSR_TRAPS, %g1
    wr %g1, %psr
    nop
    nop
    nop
    set zero, %g1
    ld [%g1], %fsr              /* round to nearest, no traps */
    set stack_top - FRAME, %sp
    clr %fp
    call main
    nop
unexpected:
    call platform_stop          /* no line `done`, so the run counts as failed */
    nop

    .globl platform_stop
platform_stop:
    set PSR_SUPERVISOR, %g1
    wr %g1, %psr
    nop
    nop
    nop
    ta 0                        /* with traps off: the processor halts and the emulation ends */
    nop

    .globl platform_retired
platform_retired:
    retl
    mov %g0, %o0

/* The window beyond is the oldest: to its stack, and invalid is then that one. */
window_overflow:
    mov %g1, %l7
    srl %l3, 1, %g1
    sll %l3, WINDOWS - 1, %l4
    or %g1, %l4, %g1
    save
    wr %g1, %wim
    nop
    nop
    nop
    std %l0, [%sp]
    std %l2, [%sp + 8]
    std %l4, [%sp + 16]
    std %l6, [%sp + 24]
    std %i0, [%sp + 32]
    std %i2, [%sp + 40]
    std %i4, [%sp + 48]
    std %i6, [%sp + 56]
    restore
    mov %l7, %g1
    jmp %l1
    rett %l2

window_underflow:
    sll %l3, 1, %l4
    srl %l3, WINDOWS - 1, %l5
    or %l4, %l5, %l5
    wr %l5, %wim
    nop
    nop
    nop
    restore
    restore
    ldd [%sp], %l0
    ldd [%sp + 8], %l2
    ldd [%sp + 16], %l4
    ldd [%sp + 24], %l6
    ldd [%sp + 32], %i0
    ldd [%sp + 40], %i2
    ldd [%sp + 48], %i4
    ldd [%sp + 56], %i6
    save
    save
    jmp %l1
    rett %l2

    .align 8
zero:
    .word 0
