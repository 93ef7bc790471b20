/* One step of any method: its arguments, its first evaluation, and its results. */
#ifndef ISO_CORE_METHODS_STEP_H
#define ISO_CORE_METHODS_STEP_H

#include <stdbool.h>

#include "core/methods/history.h"
#include "core/methods/inputs.h"
#include "core/methods/progress.h"
#include "core/numbers/sincos.h"

/* The arguments and results of a step, or of the priming of a method. */
typedef struct iso_step {
    const iso_history *history; /* the states, and the method's history */
    const iso_equations *equations;
    iso_derivative *f; /* these two are those of the equations */
    iso_derivative_by_sines *by_sines;
    real h;
    const real *u;     /* inputs: constant over the step, or smooth */
    const real *p;     /* parameters */
    const real *sines; /* [2 angle_count] sines and cosines at the start, for `by_sines`; NULL: it is not called */
    real *sines_here;  /* [2 angle_count] those of a stage; behind them room for values that the last one keeps */
    real *lu;   /* [factors] of an implicit method; on entry those of 1 - h gamma J at the start, if it needs them */
    real *work; /* work space; on entry the first [n] are the derivative at the start, if the method needs it */
    uint8_t iterations; /* of Newton */
    real error;         /* the local error of this step, if the method has its own estimate; and then */
    real *errors;       /* [n] of every state: computed less exact; NULL if nothing reads it */
    iso_progress *progress;
    uint8_t degree; /* of the polynomial of smooth inputs; 0 where none is. Their samples are behind u, and room for the
                       inputs is before `work` */
    bool checked;   /* then whether the local error is asked for */
} iso_step;

/* Evaluates with the inputs at the start of the step. */
ISO_INLINE void iso_evaluate(const iso_step *const step, real *const derivative, const real *const x)
{
    step->f(derivative, x, step->u, step->p);
}

/* The room of the inputs at a part of the step: [held] of work space. */
ISO_INLINE real *iso_inputs_room(const iso_step *const step)
{
    return step->work - step->equations->held;
}

/* The inputs at a part c of the step, until the next call. */
ISO_INLINE const real *iso_inputs_at(const iso_step *const step, const real c)
{
    if (step->degree == 0) {
        return step->u;
    }
    real *const at = iso_inputs_room(step);
    iso_extrapolate(step->equations, step->degree, step->u, c, at);
    return at;
}

/* Evaluates with these inputs. */
ISO_INLINE void iso_evaluate_at(const iso_step *const step, const real c, real *const derivative, const real *const x)
{
    step->f(derivative, x, iso_inputs_at(step, c), step->p);
}

/* The state that is angle a. */
ISO_INLINE size_t iso_angle(const uint16_t *const angles, const size_t a)
{
    return angles == NULL ? a : angles[a];
}

/* sines[2 count] = sine and cosine of these states. */
ISO_INLINE void iso_find_sines(const uint16_t *const angles, const size_t count, const real *const x, real *const sines)
{
    ISO_UNROLL
    for (size_t i = 0; i < count; i++) {
        const iso_sine_cosine turn = iso_sincos(x[iso_angle(angles, i)]);
        sines[2 * i] = turn.sin;
        sines[2 * i + 1] = turn.cos;
    }
}

/* Behind the derivative at the start of a step, which is work[n]. If steps are checked, computes the local error of the
 * step before. */
ISO_INLINE void iso_step_begun(iso_step *const step)
{
    step->error = iso_check(step->history, step->h, step->work, NULL);
    iso_keep_derivative(step->history, step->h, step->work);
}

/* The derivative at x with these inputs, and the factors of 1 - hb J there. */
ISO_INLINE void iso_linearise_at(const iso_step *const step, real *const derivative, const real *const x,
                                 const real *const u, const real hb)
{
    const iso_equations *const eq = step->equations;
    if (eq->linearise != NULL) {
        eq->linearise(step->lu, x, u, step->p, hb, derivative);
    } else {
        step->f(derivative, x, u, step->p);
        eq->factor(step->lu, x, u, step->p, hb);
    }
}

/* The begin of a step of an implicit method: computes the derivative at its start, which is then work[n], and the
 * factors of 1 - hb J there. If steps are checked, these remove the stiff part of the local error of the step before
 * (Shampine and Baca 1984, Error estimators for stiff differential equations). The work space is [2 n]. */
ISO_INLINE void iso_step_factored(iso_step *const step, const real hb)
{
    const iso_history *const history = step->history;
    const iso_equations *const eq = step->equations;
    real *const derivative = step->work;
    real *const error = step->work + history->n;
    iso_linearise_at(step, derivative, history->x, step->u, hb);
    if (history->checked > 0) {
        (void)iso_check(history, step->h, derivative, error);
        eq->solve(error, step->lu);
        step->error = R(0.0);
        ISO_UNROLL
        for (size_t s = 0; s < history->n; s++) {
            step->error = iso_larger(step->error, error[s]);
        }
    }
    iso_keep_derivative(history, step->h, derivative);
}

/* The begin of a step that evaluates the derivative at the states, without sines. */
ISO_INLINE void iso_step_begin(iso_step *const step)
{
    iso_evaluate(step, step->work, step->history->x);
    iso_step_begun(step);
}

/* A local error of more than ISO_DISCONTINUITY_RATIO times its usual size is a discontinuity: a kink makes the error
 * larger than that of a smooth motion by 1 / h or a higher power of it, and the error of a smooth motion grows little
 * in a step. The usual size is the largest recent error; it decays by a sixteenth in a step. It is known after
 * ISO_USUAL_STEPS steps. */
#define ISO_DISCONTINUITY_RATIO R(64.0)
enum { ISO_USUAL_STEPS = 16 };

/* Sets whether the step with this error contains a discontinuity. No branch on the error. */
static inline void iso_watch(iso_progress *const progress, const real error)
{
    const iso_flag known = (iso_flag)(progress->watched == ISO_USUAL_STEPS);
    const iso_bits leap = iso_less(ISO_DISCONTINUITY_RATIO * progress->usual, error) & ~iso_not_finite(error);
    progress->discontinuity = known & iso_is_set(leap);
    progress->usual = iso_max(error, progress->usual - progress->usual / iso_whole(ISO_USUAL_STEPS));
    progress->watched = (iso_steps)iso_more_unless(known, progress->watched);
}

#endif
