#include "core/numbers/self_check.h"

#include "core/numbers/sincos.h"
#include "core/numbers/unroll.h"

#ifdef ISO_REAL_DOUBLE
#define LEAST DBL_MIN
static const iso_bits expected = UINT64_C(0x5440044D53B70F0C);
#else
#define LEAST FLT_MIN
static const iso_bits expected = UINT32_C(0x1AC29DAC);
#endif

/* Fowler, Noll and Vo's hash FNV-1a, over a real at a time. */
static iso_bits continued(const iso_bits hash, const real x)
{
    return (hash ^ iso_bits_of(x)) * 16777619U;
}

/* Lorenz (1963) by Euler steps, with sine and divisions: every rounding of a state or a derivative shows. What is fused,
 * divided by a reciprocal or kept in a wider register rounds otherwise. */
static iso_bits run(iso_bits hash, const real unit)
{
    enum { STEPS = 24 };
    const real h = unit / R(64.0);
    real x = unit, y = unit, z = R(20.0) * unit;
    for (int i = 0; i < STEPS; i++) {
        const iso_sine_cosine angle = iso_sincos(z);
        const real around = R(3.0) + angle.cos;
        const real dx = R(10.0) * (y - x) + angle.sin / around;
        const real dy = x * (R(28.0) - z) - y;
        const real dz = x * y - (z / R(0.375) - x / R(7.0)) / around;
        x += h * dx;
        y += h * dy;
        z += h * dz;
        hash = continued(continued(continued(hash, x), y), dz);
    }
    return hash;
}

/* Below the least normal number: neither a result nor an operand may become zero. */
static iso_bits denormals(const iso_bits hash, const real unit)
{
    const real least = LEAST * unit;
    const real part = R(0.375) * least;
    return continued(continued(hash, part), R(4.0) * part);
}

ISO_RARE bool iso_self_check(void)
{
    volatile real one = R(1.0); /* the compiler does not know it, so that the processor computes */
    const real unit = one;
    return denormals(run(1, unit), unit) == expected;
}
