/* A repeatable sequence of numbers for test states: xorshift64* of Vigna (2016), ACM Trans. Math. Softw. 42(4). */
#ifndef ISO_TESTS_DYNAMICS_RANDOM_H
#define ISO_TESTS_DYNAMICS_RANDOM_H

#include <stdint.h>

typedef struct sequence {
    uint64_t state; /* not zero */
} sequence;

/* The next number, in [-bound, bound). */
static inline double sequence_next(sequence *const s, const double bound)
{
    s->state ^= s->state >> 12;
    s->state ^= s->state << 25;
    s->state ^= s->state >> 27;
    const uint64_t bits = s->state * UINT64_C(2685821657736338717) >> 11;
    return bound * ((double)bits * 0x1p-52 - 1.0);
}

#endif
