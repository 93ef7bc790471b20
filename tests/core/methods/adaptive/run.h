/* A run of the adams method, with all that it works on. */
#ifndef ISO_TESTS_ADAMS_RUN_H
#define ISO_TESTS_ADAMS_RUN_H

#include "core/methods/all.h"
#include "core/methods/method.h"

enum { ADAMS_STATES_MAX = 10 };

typedef struct adams_memory {
    real x[ISO_METHOD_STATE(ISO_ADAMS, ADAMS_STATES_MAX)];
    real work[ISO_ADAMS_VECTORS * ADAMS_STATES_MAX];
    iso_history history;
    iso_equations equations;
    iso_adams_options options;
    iso_adams_state state;
} adams_memory;

/* From these states; tolerance is for 1 + |x|. */
static inline void adams_prepare(adams_memory *const m, const size_t n, const real *const start, const real tolerance,
                                 const uint32_t budget)
{
    memset(m, 0, sizeof *m);
    memcpy(m->x, start, n * sizeof *start);
    m->history = (iso_history){.n = n, .x = m->x, .past = m->x + n};
    m->options = (iso_adams_options){
        .tolerance_absolute = tolerance,
        .tolerance_relative = tolerance,
        .budget = budget,
        .level_max = budget > ISO_ADAMS_BUDGET ? ISO_ADAMS_LEVELS : ISO_ADAMS_LEVEL_MAX,
    };
}

static inline iso_step adams_step_of(adams_memory *const m, iso_derivative *const f, const real h, const real *const u,
                                     const real *const p)
{
    m->equations = (iso_equations){.derivative = f, .adams = &m->options};
    return (iso_step){.history = &m->history,
                      .equations = &m->equations,
                      .f = f,
                      .h = h,
                      .u = u,
                      .p = p,
                      .work = m->work,
                      .progress = &m->state.progress};
}

static inline void adams_begin(adams_memory *const m, iso_derivative *const f, const real h, const real *const u)
{
    iso_step step = adams_step_of(m, f, h, u, NULL);
    iso_adams_prime(&step);
}

static inline real adams_tick(adams_memory *const m, iso_derivative *const f, const real h, const real *const u)
{
    iso_step step = adams_step_of(m, f, h, u, NULL);
    iso_adams_step(&step);
    return step.error;
}

/* A tick that is walked by hand. */
static inline iso_adams_run adams_walk(adams_memory *const m, iso_derivative *const f, const real h)
{
    const iso_step step = adams_step_of(m, f, h, NULL, NULL);
    const iso_adams_run run = iso_adams_run_of(&step);
    memset(run.error, 0, m->history.n * sizeof *run.error);
    return run;
}

#endif
