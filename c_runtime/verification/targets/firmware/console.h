/* What programs on a target print and read: numbers as the hexadecimals of their bits, words between blanks. */
#ifndef CONSOLE_H
#define CONSOLE_H

#include "platform.h"
#include "sailnet_guidance.h"

#ifdef SAILNET_FLOAT64
typedef uint64_t real_bits;
#else
typedef uint32_t real_bits;
#endif

/* Never inlined, specialised or removed. */
#define APART __attribute__((noipa))

/* Between these two the plugin counts instructions. */
void count_begin(void);
void count_end(void);

sailnet_real number(real_bits bits);
void print_number(uint32_t value);
/* With a blank before it. */
void print_bits(sailnet_real value);

#endif
