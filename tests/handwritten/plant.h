/* The rest of a hand-written plant, once its derivative, its start and its parameters are there: the method and the step
 * of core/choice.h, and the same memory and kernel as a generated plant, so that only the derivative differs. It is
 * declared inline: where the compiler takes the hint, a step is cheaper still.
 */
#ifndef ISO_TESTS_HANDWRITTEN_PLANT_H
#define ISO_TESTS_HANDWRITTEN_PLANT_H

#include "core/choice.h"

/* An array of C has at least one member; counts of inputs and parameters may be zero. */
#define HANDWRITTEN_PLANT(plant_name, state_count, input_count, parameter_count)                                       \
    static struct {                                                                                                    \
        real x[ISO_METHOD_STATE(ISO_METHOD, state_count)];                                                             \
        real u[(input_count) + 1];                                                                                     \
        real p[(parameter_count) + 1];                                                                                 \
        iso_progress progress;                                                                                         \
    } memory;                                                                                                          \
                                                                                                                       \
    static void output(real *restrict const y, const real *restrict const x, const real *restrict const u,             \
                       const real *restrict const p)                                                                   \
    {                                                                                                                  \
        (void)y;                                                                                                       \
        (void)x;                                                                                                       \
        (void)u;                                                                                                       \
        (void)p;                                                                                                       \
    }                                                                                                                  \
                                                                                                                       \
    static const iso_equations equations = {.derivative = derivative};                                                 \
                                                                                                                       \
    static void step(void)                                                                                             \
    {                                                                                                                  \
        real work[ISO_METHOD_WORK(ISO_METHOD, state_count)];                                                           \
        iso_method_step(ISO_METHOD, state_count, &equations, ISO_STEP_SIZE, memory.x,                                  \
                        (input_count) > 0 ? memory.u : NULL, (parameter_count) > 0 ? memory.p : NULL, NULL, work,      \
                        &memory.progress);                                                                             \
    }                                                                                                                  \
                                                                                                                       \
    const iso_plant iso_the_plant = {                                                                                  \
        .name = plant_name,                                                                                            \
        .method = ISO_METHOD_TEXT,                                                                                     \
        .step_text = ISO_STEP_TEXT,                                                                                    \
        .step_size = ISO_STEP_SIZE,                                                                                    \
        .period_ns = ISO_STEP_NS,                                                                                      \
        .states = state_count,                                                                                         \
        .inputs = input_count,                                                                                         \
        .parameters = parameter_count,                                                                                 \
        .output_names = "",                                                                                            \
        .x = memory.x,                                                                                                 \
        .u = memory.u,                                                                                                 \
        .p = memory.p,                                                                                                 \
        .start = start,                                                                                                \
        .defaults = defaults,                                                                                          \
        .memory = &memory,                                                                                             \
        .memory_bytes = sizeof memory,                                                                                 \
        .derivative = derivative,                                                                                      \
        .output = output,                                                                                              \
        .step = step,                                                                                                  \
    }

#endif
