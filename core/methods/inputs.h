/* Inputs of a step. One that is held has its value through the step. One that is smooth is a sample of a continuous
 * signal, taken at the start of the step: an evaluation later in the step gets the polynomial through that sample and
 * the `degree` samples before it, by backward differences (Newton):
 *
 *     u(t + c h) = u + c d1 + c (c + 1) / 2 d2 + c (c + 1) (c + 2) / 6 d3
 *
 * Howe (1995), Dynamics of Real-Time Simulation, ch. 4 and 8. A polynomial of degree k is off by h^(k+1) times the
 * signal's derivative of that order, and the step by h times that: a method of order k + 1 keeps its order. A method
 * that evaluates at the starts of steps only needs none.
 *
 * Before the first sample, and before a discontinuity, the signal is taken as constant: its differences are zero.
 *
 * The samples stand behind the other values of u, at u[held + ISO_METHOD_SAMPLES(recipe, inputs)]: the last sample of
 * each input, its differences, and whether there is a last sample.
 */
#ifndef ISO_CORE_METHODS_INPUTS_H
#define ISO_CORE_METHODS_INPUTS_H

#include "core/methods/equations.h"
#include "core/numbers/unroll.h"

/* Reals behind the inputs, for a polynomial of this degree. */
#define ISO_SAMPLE_REALS(degree, inputs) ((degree) > 0 ? (size_t)(inputs) * (size_t)((degree) + 1) + 1 : 0)

/* Takes the sample of a tick: u_last, d1, d2, ... become those of this tick. No branch on data. */
ISO_INLINE void iso_take_samples(const iso_equations *const eq, const uint8_t degree, real *const u)
{
    const size_t m = eq->inputs;
    real *const samples = u + eq->held;
    real *const known = samples + m * (degree + 1U);
    ISO_UNROLL
    for (size_t i = 0; i < m; i++) {
        if (eq->smooth[i]) {
            real newest = u[i];
            ISO_UNROLL
            for (size_t j = 0; j <= degree; j++) {
                const real before = samples[j * m + i];
                samples[j * m + i] = newest;
                newest -= before;
                newest = j == 0 ? *known * newest : newest;
            }
        }
    }
    *known = R(1.0);
}

/* Forgets the past: the next sample is the first one. */
ISO_INLINE void iso_forget_samples(const iso_equations *const eq, const uint8_t degree, real *const u)
{
    memset(u + eq->held, 0, ISO_SAMPLE_REALS(degree, eq->inputs) * sizeof *u);
}

/* at[held] = u at a part c of the step. */
ISO_INLINE void iso_extrapolate(const iso_equations *const eq, const uint8_t degree, const real *const u, const real c,
                                real *const at)
{
    const size_t m = eq->inputs;
    const real *const samples = u + eq->held;
    ISO_UNROLL
    for (size_t i = 0; i < eq->held; i++) {
        at[i] = u[i];
        if (i < m && eq->smooth[i]) {
            real moved = (c + iso_whole(degree - 1)) / iso_whole(degree) * samples[degree * m + i];
            ISO_UNROLL
            for (size_t j = degree - 1U; j > 0; j--) {
                moved = (c + iso_whole((int32_t)j - 1)) / iso_whole((int32_t)j) * (samples[j * m + i] + moved);
            }
            at[i] += moved;
        }
    }
}

/* at[held] = u + sign h u', by the rate at the start of the step: that of the polynomial, d1 + d2 / 2 + d3 / 3. */
ISO_INLINE void iso_input_ahead(const iso_equations *const eq, const uint8_t degree, const real sign,
                                const real *const u, real *const at)
{
    const size_t m = eq->inputs;
    const real *const samples = u + eq->held;
    ISO_UNROLL
    for (size_t i = 0; i < eq->held; i++) {
        at[i] = u[i];
        if (i < m && eq->smooth[i]) {
            real rate = samples[degree * m + i] / iso_whole(degree);
            ISO_UNROLL
            for (size_t j = degree - 1U; j > 0; j--) {
                rate += samples[j * m + i] / iso_whole((int32_t)j);
            }
            at[i] += sign * rate;
        }
    }
}

#endif
