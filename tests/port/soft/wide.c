/* The operations of port/soft/binary64.h against those of the processor, bit for bit; a NaN is as good as any other.
 *
 *     arguments: PROGRAM [PAIRS]
 *
 * First all pairs of numbers about some powers of two, then so many pairs at random, of the kinds of soft.c. */
#include <string.h>

#include "port/port.h"
#include "tests/port/soft/wide_operations.h"
#include "tests/tap.h"

#ifndef EXPONENT_STEP
#define EXPONENT_STEP 1
#endif

static const uint64_t infinity = UINT64_C(0x7FF) << 52, sign = UINT64_C(1) << 63;

static double number(const uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static uint64_t bits_of(const double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static bool is_nan(const uint64_t bits)
{
    return (bits & ~sign) > infinity;
}

/* Rounded once: both terms are exact. */
static uint64_t from_uint64(const uint64_t n)
{
    return bits_of((double)(uint32_t)(n >> 32) * 4294967296.0 + (double)(uint32_t)n);
}

/* The integer towards zero, within these magnitudes. */
static uint64_t integer(const uint64_t a, const uint64_t positive, const uint64_t negative)
{
    const double x = number(a & ~sign);
    const int32_t shift = (int32_t)(a >> 52 & 0x7FF) - 1075;
    const uint64_t significand = (a & ((UINT64_C(1) << 52) - 1)) | UINT64_C(1) << 52;
    const uint64_t n = is_nan(a) || x < 1.0          ? 0
                       : x >= 18446744073709551616.0 ? UINT64_MAX
                       : shift >= 0                  ? significand << shift
                                                     : significand >> -shift;
    const bool is_negative = a >= sign;
    const uint64_t most = is_negative ? negative : positive, size = n > most ? most : n;
    return is_negative ? 0 - size : size;
}

static uint64_t single(const uint64_t a)
{
    const float x = (float)number(a);
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static uint64_t of_single(const uint32_t a)
{
    float x;
    memcpy(&x, &a, sizeof x);
    return bits_of((double)x);
}

static uint64_t right(const wide_kind kind, const uint64_t a, const uint64_t b)
{
    const double x = number(a), y = number(b);
    switch (kind) {
    case WIDE_SUM:
        return bits_of(x + y);
    case WIDE_DIFFERENCE:
        return bits_of(x - y);
    case WIDE_PRODUCT:
        return bits_of(x * y);
    case WIDE_QUOTIENT:
        return bits_of(x / y);
    case WIDE_ROOT:
        return bits_of(__builtin_sqrt(x));
    case WIDE_COMPARISON:
        return (uint64_t)(x < y) | (uint64_t)(x == y) << 1 | (uint64_t)(x <= y) << 2 |
               (uint64_t)(is_nan(a) || is_nan(b)) << 3;
    case WIDE_FROM_INT32:
        return bits_of((double)(int32_t)(uint32_t)a);
    case WIDE_FROM_UINT32:
        return bits_of((double)(uint32_t)a);
    case WIDE_FROM_INT64:
        return from_uint64(a >= sign ? 0 - a : a) | (a & sign);
    case WIDE_FROM_UINT64:
        return from_uint64(a);
    case WIDE_TO_INT32:
        return (uint32_t)integer(a, INT32_MAX, (uint64_t)INT32_MAX + 1);
    case WIDE_TO_UINT32:
        return (uint32_t)integer(a, UINT32_MAX, 0);
    case WIDE_TO_INT64:
        return integer(a, INT64_MAX, (uint64_t)INT64_MAX + 1);
    case WIDE_TO_UINT64:
        return integer(a, UINT64_MAX, 0);
    case WIDE_FROM_BINARY32:
        return of_single((uint32_t)a);
    default:
        return single(a);
    }
}

/* Whether a result is a number of that kind, and none. */
static bool is_none(const wide_kind kind, const uint64_t bits)
{
    const bool is_integer = kind == WIDE_COMPARISON || (kind >= WIDE_TO_INT32 && kind <= WIDE_TO_UINT64);
    return kind == WIDE_TO_BINARY32 ? (bits & 0x7FFFFFFFU) > 0x7F800000U : !is_integer && is_nan(bits);
}

/* A generator of Marsaglia (2003), Xorshift RNGs, section 4. */
static uint64_t next(uint64_t *const state)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return *state;
}

typedef struct pair {
    uint64_t a, b;
} pair;

static uint64_t with_exponent(const uint64_t bits, const uint64_t exponent)
{
    return (bits & ~infinity) | (exponent & 0x7FF) << 52;
}

/* The kinds take turns; the last has numbers about the range of integers and of binary32. */
static pair random_pair(uint64_t *const state, const uint32_t turn)
{
    pair p = {next(state), next(state)};
    const uint64_t more = next(state), exponent = p.a >> 52 & 0x7FF;
    switch (turn % 5) {
    case 0:
        break;
    case 1: /* exponents that differ by -64 to 63 */
        p.b = with_exponent(p.b, exponent + more % 128 - 64);
        break;
    case 2: /* significands of few bits, near exponents */
        p.a &= UINT64_MAX << more % 52;
        p.b = with_exponent(p.b & UINT64_MAX << (more >> 8) % 52, exponent + (more >> 16) % 128 - 64);
        break;
    case 3: /* exponents of which a product or a quotient is near the least or the largest */
        p.b = with_exponent(p.b, ((more & 0x100U) != 0 ? 1023 - exponent : exponent - 1023) + (more & 63) - 40);
        break;
    default:
        p.a = with_exponent(p.a & UINT64_MAX << more % 52, 1023 - 150 + (more >> 8) % 300);
        break;
    }
    return p;
}

/* Whether an operation differs on a pair. The first that does is told. */
static uint32_t differs(const wide_kind kind, const pair p)
{
    static bool is_told;
    const uint64_t got = wide_operations[kind](p.a, p.b), want = right(kind, p.a, p.b);
    if (got == want || (is_none(kind, got) && is_none(kind, want))) {
        return 0;
    }
    const uint64_t told[4] = {p.a, p.b, got, want};
    for (int i = 0; i < 4 && !is_told; i++) {
        tap_note_bits(i < 2 ? "operand, high" : "got, or want, high", (uint32_t)(told[i] >> 32));
        tap_note_bits("low", (uint32_t)told[i]);
    }
    is_told = true;
    return 1;
}

/* The numbers about a power of two, and halfway to the next: eight of each sign for each of some exponents, which are
 * the least and the largest of double, of float and of integers among them. */
static uint64_t structured(const uint32_t index)
{
    static const uint16_t exponents[] = {0,    1,    2,    51,   52,   53,   54,   511,  512,  872,  873,  874,  896,
                                         897,  898,  970,  1021, 1022, 1023, 1024, 1025, 1053, 1054, 1055, 1075, 1076,
                                         1085, 1086, 1087, 1149, 1150, 1151, 1535, 1996, 2044, 2045, 2046, 2047};
    static const uint64_t half = UINT64_C(1) << 51, all = (UINT64_C(1) << 52) - 1;
    const uint64_t fractions[8] = {0, 1, 2, half - 1, half, half + 1, all - 1, all};
    const uint32_t of = (index >> 4) * EXPONENT_STEP;
    return of >= sizeof exponents / sizeof exponents[0]
               ? UINT64_MAX
               : (uint64_t)(index >> 3 & 1) << 63 | (uint64_t)exponents[of] << 52 | fractions[index & 7];
}

static uint32_t structured_differ(const wide_kind kind)
{
    uint32_t count = 0;
    for (uint32_t i = 0; structured(i) != UINT64_MAX; i++) {
        for (uint32_t k = 0; structured(k) != UINT64_MAX && (k == 0 || wide_has_two(kind)); k++) {
            count += differs(kind, (pair){structured(i), structured(k)});
        }
    }
    return count;
}

int main(int argc, char **argv)
{
    const uint32_t pairs = (uint32_t)iso_port_duration(argc, argv);
    for (int kind = 0; kind < WIDE_KINDS; kind++) {
        uint64_t state = UINT64_C(88172645463325252);
        uint32_t count = structured_differ((wide_kind)kind);
        for (uint32_t i = 0; i < pairs; i++) {
            count += differs((wide_kind)kind, random_pair(&state, i));
        }
        tap_count(count, 0, wide_names[kind]);
    }
    tap_done();
}
