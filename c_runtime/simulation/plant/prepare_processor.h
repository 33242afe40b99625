/*
 * Other code of the process may have left the upper halves of vector registers in use, with which some
 * processors take four times as long for code without AVX. A program without AVX never meets that.
 */
#ifndef PREPARE_PROCESSOR_H
#define PREPARE_PROCESSOR_H

#if defined(__GNUC__) && defined(__x86_64__)
__attribute__((target("avx"))) static void clear_upper_halves(void)
{
    __builtin_ia32_vzeroupper();
}
#endif

static void prepare_processor(void)
{
#if defined(__GNUC__) && defined(__x86_64__)
    if (__builtin_cpu_supports("avx")) {
        clear_upper_halves();
    }
#endif
}

#endif
