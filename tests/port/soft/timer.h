/* A counter of cycles for tests/port/soft/classes.c, modulo 2^16. */
#ifndef ISO_TESTS_SOFT_TIMER_H
#define ISO_TESTS_SOFT_TIMER_H

#include <stdint.h>

void timer_start(void);
uint16_t timer_now(void);

#endif
