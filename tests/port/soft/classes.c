/* The arithmetic of float on a target, over all classes of operands: as a comment for each operation the hash of the
 * bits of all results, which is one number where the arithmetic is that of IEEE 754, and the fewest and the most counts
 * of timer_now() that one took. A NaN counts as any other.
 *
 *     arguments: PROGRAM [PAIRS]
 *
 * Operands are all pairs of numbers about some powers of two, zeros, infinities and NaN among them, and so many pairs
 * of any bits. */
#include <string.h>

#include "port/port.h"
#include "tests/port/soft/timer.h"
#include "tests/tap.h"

#ifndef STRIDE
#define STRIDE 1 /* of the numbers that are tried */
#endif

enum { EXPONENTS = 16, NUMBERS = EXPONENTS * 16 };

/* A number about a power of two: eight of each sign for each exponent. */
static uint32_t number_of(const uint16_t index)
{
    static const uint8_t exponents[EXPONENTS] = {0,   1,   2,   24,  64,  103, 120, 126,
                                                 127, 128, 135, 150, 151, 190, 254, 255};
    static const uint32_t fractions[8] = {0, 1, 2, 0x3FFFFF, 0x400000, 0x400001, 0x7FFFFE, 0x7FFFFF};
    return (uint32_t)(index & 8) << 28 | (uint32_t)exponents[index >> 4] << 23 | fractions[index & 7];
}

static float float_of(const uint32_t bits)
{
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* What the compiler calls for an operation, and nothing else. */
#define OPERATION(name, expression)                                                                                    \
    static float __attribute__((noinline)) name(const float a, const float b)                                          \
    {                                                                                                                  \
        (void)b;                                                                                                       \
        return expression;                                                                                             \
    }
OPERATION(nothing, a)
OPERATION(sum, a + b)
OPERATION(difference, a - b)
OPERATION(product, a *b)
OPERATION(quotient, a / b)
OPERATION(root, __builtin_sqrtf(a))

typedef struct tally {
    uint32_t hash;
    uint16_t least, most;
} tally;

static void add(tally *const t, float (*const operation)(float a, float b), const uint32_t a, const uint32_t b)
{
    const float x = float_of(a), y = float_of(b);
    const uint16_t begin = timer_now();
    const float result = operation(x, y);
    const uint16_t took = (uint16_t)(timer_now() - begin);
    t->least = took < t->least ? took : t->least;
    t->most = took > t->most ? took : t->most;
    uint32_t bits;
    memcpy(&bits, &result, sizeof bits);
    bits = (bits & UINT32_C(0x7FFFFFFF)) > UINT32_C(0x7F800000) ? UINT32_C(0x7FC00000) : bits;
    t->hash = (((t->hash << 8) | (t->hash >> 24)) ^ bits) * UINT32_C(0x9E3779B1);
}

int main(int argc, char **argv)
{
    static const struct {
        const char *hash, *least, *most;
        float (*operation)(float a, float b);
        uint16_t others; /* second operands: 1 of those that have none */
    } cases[] = {
        {"hash nothing", "least nothing", "most nothing", nothing, 1},
        {"hash sum", "least sum", "most sum", sum, NUMBERS},
        {"hash difference", "least difference", "most difference", difference, NUMBERS},
        {"hash product", "least product", "most product", product, NUMBERS},
        {"hash quotient", "least quotient", "most quotient", quotient, NUMBERS},
        {"hash root", "least root", "most root", root, 1},
    };
    const uint32_t pairs = (uint32_t)iso_port_duration(argc, argv);
    timer_start();
    for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++) {
        tally t = {0, UINT16_MAX, 0};
        for (uint16_t a = 0; a < NUMBERS; a += STRIDE) {
            for (uint16_t b = 0; b < cases[i].others; b += STRIDE) {
                add(&t, cases[i].operation, number_of(a), number_of(b));
            }
        }
        uint32_t state = UINT32_C(2463534242);
        for (uint32_t n = 0; n < pairs; n++) {
            const uint32_t a = state * UINT32_C(747796405) + UINT32_C(2891336453);
            state = a * UINT32_C(747796405) + UINT32_C(2891336453);
            /* Of every second pair the exponents are near. */
            const uint32_t near =
                (state & UINT32_C(0x807FFFFF)) | ((a + (state & UINT32_C(0x0F800000))) & UINT32_C(0x7F800000));
            add(&t, cases[i].operation, a, n % 2 == 0 ? state : near);
        }
        tap_note_bits(cases[i].hash, t.hash);
        tap_note(cases[i].least, t.least);
        tap_note(cases[i].most, t.most);
    }
    tap_ok(true, "every class");
    tap_done();
}
