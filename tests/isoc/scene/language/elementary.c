/* tools/isoc/base/elementary.c against long double: every result is the nearest double, but where the exact value is
 * near the middle between two. Long double has 64 bits: its functions are within 1 ulp of theirs (glibc's manual,
 * "Errors in Math Functions"), 2^-11 ulp of a double, so a result may be half an ulp and 2^-11 off; where double and
 * long double are the same there is nothing to compare with.
 */
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "tools/isoc/base/numbers.h"

enum { NUMBERS = 2000 };
static const uint64_t seed = 20261122;
static const double bound = 0.5 + 1.0 / 2048;

static int tests, failures;
static uint64_t noise;

/* Uniform in [0, 1): Knuth's linear congruential generator MMIX. */
static double uniform(void)
{
    noise = noise * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (double)(noise >> 11) * 0x1p-53;
}

static double between(double least, double most)
{
    return least + (most - least) * uniform();
}

/* Of any size. */
static double scattered(void)
{
    return ldexp(between(-1.0, 1.0), (int)between(-300.0, 300.0));
}

/* How far a result is from the right one, in ulp. */
static double off(double got, long double want)
{
    int exponent;
    frexpl(want, &exponent);
    return want == 0.0L ? (got == 0.0 ? 0.0 : HUGE_VAL)
                        : (double)(fabsl((long double)got - want) / ldexpl(1.0L, exponent - 53));
}

static void verdict(bool good, const char *name, double worst)
{
    printf("%sok %d - %s: at most %.5f ulp\n", good ? "" : "not ", ++tests, name, worst);
    failures += !good;
}

static void compare(const char *name, const double errors[NUMBERS])
{
    double worst = 0.0;
    for (int i = 0; i < NUMBERS; i++) {
        worst = errors[i] <= worst ? worst : errors[i];
    }
    verdict(worst <= bound || sizeof(long double) == sizeof(double) || LDBL_MANT_DIG < 64, name, worst);
}

int main(void)
{
    static double exps[NUMBERS], logs[NUMBERS], near[NUMBERS], angles[NUMBERS], sines[NUMBERS], cosines[NUMBERS],
        powers[NUMBERS];
    noise = seed;
    printf("# seed %llu\n", (unsigned long long)seed);
    for (int i = 0; i < NUMBERS; i++) {
        const double x = between(-700.0, 700.0), positive = fabs(scattered()) + 0x1p-400, close = between(0.7, 1.4);
        const double y = scattered(), side = i % 2 == 0 ? scattered() : between(-2.0, 2.0) * y;
        const double part = i % 4 == 0 ? 1.0 - ldexp(uniform(), -(int)between(0.0, 50.0)) : between(-1.0, 1.0);
        exps[i] = off(elementary_exp(x), expl((long double)x));
        logs[i] = off(elementary_log(positive), logl((long double)positive));
        near[i] = off(elementary_log(close), logl((long double)close));
        const double exponent = between(-600.0, 600.0) / fmax(1.0, fabs(log(positive)));
        powers[i] = off(elementary_power(positive, exponent), powl((long double)positive, (long double)exponent));
        angles[i] = off(elementary_atan2(y, side), atan2l((long double)y, (long double)side));
        sines[i] = off(elementary_asin(part), asinl((long double)part));
        cosines[i] = off(elementary_acos(part), acosl((long double)part));
    }
    compare("exp", exps);
    compare("log", logs);
    compare("log near 1", near);
    compare("power", powers);
    compare("atan2", angles);
    compare("asin", sines);
    compare("acos", cosines);

    /* What is exact, and the corners. */
    const double pi = 3.14159265358979323846;
    const bool corners = elementary_exp(0.0) == 1.0 && elementary_log(1.0) == 0.0 &&
                         elementary_atan2(0.0, 1.0) == 0.0 && elementary_atan2(1.0, 0.0) == pi / 2 &&
                         elementary_atan2(-1.0, 0.0) == -pi / 2 && elementary_atan2(0.0, -1.0) == pi &&
                         elementary_atan2(1.0, 1.0) == pi / 4 && elementary_asin(1.0) == pi / 2 &&
                         elementary_asin(-1.0) == -pi / 2 && elementary_acos(1.0) == 0.0 &&
                         elementary_acos(-1.0) == pi && elementary_acos(0.0) == pi / 2;
    verdict(corners, "corners", 0.0);
    verdict(off(1.0 + DBL_EPSILON, 1.0L) > bound, "control: the next double is found", off(1.0 + DBL_EPSILON, 1.0L));
    printf("1..%d\n", tests);
    return failures > 0;
}
