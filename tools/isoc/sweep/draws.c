/* Random values of runs. The state begins with the hash FNV-1a of a text that names the seed, the variable and the run;
 * the finaliser of SplitMix64 (Steele, Lea and Flood 2014) makes the numbers. Normal ones by the polar method
 * (Marsaglia and Bray 1964), with the logarithm that has the same bits on every host. */
#include "tools/isoc/sweep/sweep.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

#include "tools/isoc/base/numbers.h"

static uint64_t hash_of(const char *words)
{
    uint64_t hash = UINT64_C(0xCBF29CE484222325);
    for (const char *c = words; *c != '\0'; c++) {
        hash = (hash ^ (unsigned char)*c) * UINT64_C(0x00000100000001B3);
    }
    return hash;
}

/* The next number between 0 and 1, both excluded. */
static double next_number(uint64_t *last)
{
    *last += UINT64_C(0x9E3779B97F4A7C15);
    uint64_t z = *last;
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    z ^= z >> 31;
    return ((double)(z >> 12) + 0.5) / 4503599627370496.0;
}

double sweep_draw(uint64_t seed, const char *called, uint64_t run, sweep_law law, double first, double second)
{
    char words[160];
    snprintf(words, sizeof words, "%" PRIu64 " %s %" PRIu64, seed, called, run);
    uint64_t numbers = hash_of(words);
    if (law == SWEEP_UNIFORM) {
        return first + (second - first) * next_number(&numbers);
    }
    double x, square;
    do {
        x = 2.0 * next_number(&numbers) - 1.0;
        const double y = 2.0 * next_number(&numbers) - 1.0;
        square = x * x + y * y;
    } while (square >= 1.0);
    return first + second * (x * sqrt(-2.0 * elementary_log(square) / square));
}
