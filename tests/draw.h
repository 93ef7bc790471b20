/* Random numbers of a test: a generator of 32 bits (Marsaglia 2003, xorshift). */
#ifndef ISO_TESTS_DRAW_H
#define ISO_TESTS_DRAW_H

#include <stdint.h>

static uint32_t seed;

static uint32_t draw(const uint32_t below)
{
    seed ^= seed << 13;
    seed ^= seed >> 17;
    seed ^= seed << 5;
    return seed % below;
}

#endif
