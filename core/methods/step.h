/* One step of any method: what it is given, what it begins with, and what it tells. */
#ifndef ISO_CORE_METHODS_STEP_H
#define ISO_CORE_METHODS_STEP_H

#include <stdbool.h>

#include "core/methods/history.h"
#include "core/methods/progress.h"

/* A step, or the priming of a method, on its way through one of the functions that make it. */
typedef struct iso_step {
    const iso_history *history; /* the states, and what the method keeps */
    const iso_equations *equations;
    iso_derivative *f; /* of the equations */
    real h;
    const real *u; /* inputs and parameters, held over the step */
    const real *p;
    real *lu;   /* [factors] of an implicit method: at first those of 1 - h gamma J at the start, if it asks for them */
    real *work; /* the first [n] are at first the derivative at the start, if the method asks for it */
    uint8_t iterations; /* of Newton */
    real error;         /* the local error, where the method has an estimate of its own: of this step */
    iso_progress *progress;
} iso_step;

ISO_INLINE void iso_evaluate(const iso_step *const step, real *const derivative, const real *const x)
{
    step->f(derivative, x, step->u, step->p);
}

/* What a method begins with that asks for the derivative at the start: it, and where gamma is not zero the factors of
 * 1 - h gamma J there. With both, the local error of the step before, where steps are checked; the factors take the
 * stiff part out of it (Shampine and Baca 1984, Error estimators for stiff differential equations). The work space is
 * [n], with factors [2 n]. */
ISO_INLINE void iso_step_begin(iso_step *const step, const real gamma)
{
    const iso_history *const history = step->history;
    const iso_equations *const eq = step->equations;
    real *const derivative = step->work;
    iso_evaluate(step, derivative, history->x);
    if (gamma != R(0.0)) {
        real *const error = step->work + history->n;
        eq->factor(step->lu, history->x, step->u, step->p, step->h * gamma);
        if (history->checked > 0) {
            (void)iso_check(history, step->h, derivative, error);
            eq->solve(error, step->lu);
            real largest = R(0.0);
            ISO_UNROLL
            for (size_t s = 0; s < history->n; s++) {
                largest = iso_larger(largest, error[s]);
            }
            step->error = largest;
        }
    } else {
        step->error = iso_check(history, step->h, derivative, NULL);
    }
    iso_keep_derivative(history, step->h, derivative);
}

/* A local error so many times its usual size is a jump of the motion: kinks are by 1 / h or a higher power of it larger
 * than the error of a smooth motion, which grows little in a step. The usual size is the largest of late, and is
 * forgotten by a sixteenth in a step; nothing is usual before so many steps. */
#define ISO_JUMP R(64.0)
enum { ISO_USUAL_STEPS = 16 };

/* Whether the motion jumped within the step whose error this is. Without a branch on it. */
static inline void iso_watch(iso_progress *const progress, const real error)
{
    const bool known = progress->watched == ISO_USUAL_STEPS;
    const iso_bits leap = iso_less(ISO_JUMP * progress->usual, error) & ~iso_not_finite(error);
    progress->jumped = known & (leap != 0);
    progress->usual = iso_max(error, progress->usual - progress->usual / (real)ISO_USUAL_STEPS);
    progress->watched = (uint8_t)(progress->watched + !known);
}

#endif
