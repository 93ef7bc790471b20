/* The operations of port/soft against those of the processor, bit for bit; a NaN is as good as any other.
 *
 *     arguments: PROGRAM [PAIRS]
 *
 * First all pairs of numbers about the powers of two, then so many pairs at random: of any bits, of exponents that are
 * near, of few bits (sums and products then lie halfway), and with results about the least normal number. An operation
 * of one number has each of these once. With TURNS only the exponents whose turn it is are the first of a pair, and the
 * pairs at random are others each TURN. */
#include <stdbool.h>
#include <string.h>

#include "port/port.h"
#include "tests/port/soft/operations.h"
#include "tests/tap.h"

#ifndef EXPONENT_STEP
#define EXPONENT_STEP 1
#endif
#ifndef TURNS
#define TURN 0
#define TURNS 1
#endif

enum { KINDS = 14 };

typedef uint32_t (*operation)(uint32_t a, uint32_t b);

static float number(const uint32_t bits)
{
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static uint32_t bits_of(const float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static bool is_nan(const uint32_t bits)
{
    return (bits & 0x7FFFFFFFU) > 0x7F800000U;
}

static uint32_t add(const uint32_t a, const uint32_t b)
{
    return bits_of(number(a) + number(b));
}

static uint32_t subtract(const uint32_t a, const uint32_t b)
{
    return bits_of(number(a) - number(b));
}

static uint32_t multiply(const uint32_t a, const uint32_t b)
{
    return bits_of(number(a) * number(b));
}

static uint32_t divide(const uint32_t a, const uint32_t b)
{
    return bits_of(number(a) / number(b));
}

static uint32_t root(const uint32_t a, const uint32_t unused)
{
    (void)unused;
    return bits_of(__builtin_sqrtf(number(a)));
}

static uint32_t compare(const uint32_t a, const uint32_t b)
{
    const float x = number(a), y = number(b);
    return (uint32_t)(x < y) | (uint32_t)(x == y) << 1 | (uint32_t)(x <= y) << 2 |
           (uint32_t)(is_nan(a) || is_nan(b)) << 3;
}

static uint32_t from_int32(const uint32_t n, const uint32_t unused)
{
    (void)unused;
    return bits_of((float)(int32_t)n);
}

static uint32_t from_uint32(const uint32_t n, const uint32_t unused)
{
    (void)unused;
    return bits_of((float)n);
}

/* Rounded once: what does not fit into a number is shifted until it does, and its lowest bit tells of the rest. */
static uint32_t from_uint64(const uint32_t low, const uint32_t high)
{
    uint64_t n = (uint64_t)high << 32 | low;
    float scale = 1.0F;
    while (n >> 31 != 0) {
        n = n >> 1 | (n & 1);
        scale *= 2.0F;
    }
    return bits_of((float)(int32_t)n * scale);
}

static uint32_t from_int64(const uint32_t low, const uint32_t high)
{
    const uint64_t n = (uint64_t)high << 32 | low;
    const uint64_t size = high >> 31 != 0 ? 0 - n : n;
    return from_uint64((uint32_t)size, (uint32_t)(size >> 32)) | (high & 0x80000000U);
}

/* The integer towards zero of a magnitude below 2^64, and all ones of a larger one. */
static uint64_t natural(const uint32_t a)
{
    const float x = number(a & 0x7FFFFFFFU);
    if (is_nan(a)) {
        return 0;
    }
    if (x >= 18446744073709551616.0F) {
        return UINT64_MAX;
    }
    const int32_t shift = (int32_t)(a >> 23 & 0xFF) - 150;
    const uint64_t significand = (a & 0x7FFFFFU) | 0x800000U;
    return x < 1.0F ? 0 : shift >= 0 ? significand << shift : significand >> -shift;
}

static uint64_t limited(const uint32_t a, const uint64_t positive, const uint64_t negative)
{
    const uint64_t n = natural(a);
    const uint64_t most = a >> 31 != 0 ? negative : positive;
    const uint64_t size = n > most ? most : n;
    return a >> 31 != 0 ? 0 - size : size;
}

static uint32_t to_int32(const uint32_t a, const uint32_t unused)
{
    (void)unused;
    return (uint32_t)limited(a, INT32_MAX, (uint64_t)INT32_MAX + 1);
}

static uint32_t to_uint32(const uint32_t a, const uint32_t unused)
{
    (void)unused;
    return (uint32_t)limited(a, UINT32_MAX, 0);
}

static uint32_t to_int64(const uint32_t a, const uint32_t is_high)
{
    const uint64_t n = limited(a, INT64_MAX, (uint64_t)INT64_MAX + 1);
    return (uint32_t)(is_high == 0 ? n : n >> 32);
}

static uint32_t to_uint64(const uint32_t a, const uint32_t is_high)
{
    const uint64_t n = limited(a, UINT64_MAX, 0);
    return (uint32_t)(is_high == 0 ? n : n >> 32);
}

/* A generator of Marsaglia (2003), Xorshift RNGs, section 3. */
static uint32_t next(uint32_t *const state)
{
    *state ^= *state << 13;
    *state ^= *state >> 17;
    *state ^= *state << 5;
    return *state;
}

typedef struct pair {
    uint32_t a, b;
} pair;

/* The kinds take turns. */
static pair random_pair(uint32_t *const state, const uint32_t turn)
{
    pair p = {next(state), next(state)};
    const uint32_t more = next(state);
    const uint32_t exponent = p.a >> 23 & 0xFF;
    switch (turn % 4) {
    case 0:
        break;
    case 1: /* exponents that differ by -32 to 31 */
        p.b = (p.b & 0x807FFFFFU) | ((exponent + more % 64 - 32) & 0xFF) << 23;
        break;
    case 2: /* significands of few bits, near exponents */
        p.a &= 0xFFFFFFFFU << more % 23;
        p.b = (p.b & 0x807FFFFFU & 0xFFFFFFFFU << (more >> 8) % 23) | ((exponent + (more >> 16) % 64 - 32) & 0xFF)
                                                                          << 23;
        break;
    default: /* exponents of which a product or a quotient is near the least or the largest */
        p.b = (p.b & 0x807FFFFFU) | (((more & 0x100U) != 0 ? 127 - exponent : exponent - 127) + (more & 31) - 20) % 256
                                        << 23;
        break;
    }
    return p;
}

static bool same(const uint32_t got, const uint32_t want, const bool is_number)
{
    return got == want || (is_number && is_nan(got) && is_nan(want));
}

/* Tries an operation on a pair. The first that differs is told. */
static uint32_t differs(const operation tried, const operation right, const pair p, const bool is_number)
{
    static bool is_told;
    const uint32_t got = tried(p.a, p.b), want = right(p.a, p.b);
    if (same(got, want, is_number)) {
        return 0;
    }
    if (!is_told) {
        tap_note_bits("a", p.a);
        tap_note_bits("b", p.b);
        tap_note_bits("got", got);
        tap_note_bits("want", want);
        is_told = true;
    }
    return 1;
}

/* The numbers about a power of two, and halfway to the next: eight of each sign for each exponent. */
static uint32_t structured(const uint32_t index)
{
    static const uint32_t fractions[8] = {0, 1, 2, 0x3FFFFF, 0x400000, 0x400001, 0x7FFFFE, 0x7FFFFF};
    return (index & 8) << 28 | (index >> 4) << 23 | fractions[index & 7];
}

/* The index that follows: of the same exponent, or of the next that is tried. */
static uint32_t following(const uint32_t index)
{
    return index + ((index & 15) == 15 ? 1 + 16 * (EXPONENT_STEP - 1) : 1);
}

/* What an operation of one number reads of the second one, which word of the result it wants, is 0 or not. */
static uint32_t structured_differ(const operation tried, const operation right, const bool is_number,
                                  const bool is_of_two)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < 256 * 16; i = following(i)) {
        for (uint32_t k = 0; (i >> 4) % TURNS == TURN && k < (is_of_two ? 256 * 16 : 2); k = following(k)) {
            count += differs(tried, right, (pair){structured(i), structured(k)}, is_number);
        }
    }
    return count;
}

static uint32_t random_differ(const operation tried, const operation right, const bool is_number, const uint32_t pairs)
{
    uint32_t count = 0, state = 2463534242U + TURN;
    for (uint32_t i = 0; i < pairs; i++) {
        count += differs(tried, right, random_pair(&state, i), is_number);
    }
    return count;
}

int main(int argc, char **argv)
{
    const operations *const soft = &the_operations;
    const struct {
        const char *name;
        operation tried, right;
        bool is_number, is_of_two;
    } cases[KINDS] = {
        {"sum", soft->add, add, true, true},
        {"difference", soft->subtract, subtract, true, true},
        {"product", soft->multiply, multiply, true, true},
        {"quotient", soft->divide, divide, true, true},
        {"root", soft->root, root, true, false},
        {"comparison", soft->compare, compare, false, true},
        {"from int32", soft->from_int32, from_int32, true, false},
        {"from uint32", soft->from_uint32, from_uint32, true, false},
        {"from int64", soft->from_int64, from_int64, true, true},
        {"from uint64", soft->from_uint64, from_uint64, true, true},
        {"to int32", soft->to_int32, to_int32, false, false},
        {"to uint32", soft->to_uint32, to_uint32, false, false},
        {"to int64", soft->to_int64, to_int64, false, false},
        {"to uint64", soft->to_uint64, to_uint64, false, false},
    };
    const uint32_t pairs = (uint32_t)iso_port_duration(argc, argv);
    for (unsigned i = 0; i < KINDS; i++) {
        const uint32_t count =
            structured_differ(cases[i].tried, cases[i].right, cases[i].is_number, cases[i].is_of_two) +
            random_differ(cases[i].tried, cases[i].right, cases[i].is_number, pairs);
        tap_count(count, 0, cases[i].name);
    }
    tap_done();
}
