/* Semi-implicit Euler, for a mechanical plant: half of its states are positions, half their speeds. */
#ifndef ISO_CORE_METHODS_SEMI_IMPLICIT_H
#define ISO_CORE_METHODS_SEMI_IMPLICIT_H

#include "core/methods/step.h"

/* v += h a(q, v) for the speeds v, then q += h q'(q, v) for the positions q, with the new speeds. Symplectic where
 * q' = v, the mass matrix is constant and a comes from a potential of q; elsewhere the energy drifts, as with any
 * method of order one (tests/promises/hard/long_run.c). Vogelaere (1956), Methods of integration which preserve the
 * contact transformation property; Hairer, Lubich, Wanner (2006), Geometric Numerical Integration, eq. I.1.9. */
ISO_INLINE void iso_semi_implicit_step(iso_step *const step)
{
    const iso_history *const history = step->history;
    const iso_equations *const eq = step->equations;
    const size_t positions = eq->rates == NULL ? history->n / 2 : eq->positions;
    real *const derivative = step->work;

    iso_step_begun(step);
    ISO_UNROLL
    for (size_t s = positions; s < history->n; s++) {
        iso_advance(history, s, step->h * derivative[s]);
    }
    if (eq->rates != NULL) {
        eq->rates(derivative, history->x, step->u, step->p);
    }
    ISO_UNROLL
    for (size_t s = 0; s < positions; s++) {
        iso_advance(history, s, step->h * (eq->rates == NULL ? history->x[positions + s] : derivative[s]));
    }
}

/* The columns of core/methods/table.h. */
#define ISO_SEMI_IMPLICIT_ORDER(r) 1
#define ISO_SEMI_IMPLICIT_STAGES(r) 0
#define ISO_SEMI_IMPLICIT_TABLEAU NULL
#define ISO_SEMI_IMPLICIT_EVALUATIONS(r) 1
#define ISO_SEMI_IMPLICIT_SOLUTIONS(r) 0
#define ISO_SEMI_IMPLICIT_PAST(r) 0
#define ISO_SEMI_IMPLICIT_WORK(r) 1
#define ISO_SEMI_IMPLICIT_PRIME(r) ISO_PRIME_VECTORS
#define ISO_SEMI_IMPLICIT_PRIMES(r) iso_prime_check
#define ISO_SEMI_IMPLICIT_SUMS(r) 0
#define ISO_SEMI_IMPLICIT_PRODUCTS(r) 1
#define ISO_SEMI_IMPLICIT_KIND(r) ISO_FROM_START

#endif
