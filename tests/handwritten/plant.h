/* The rest of a hand-written rk4 plant of 1 ms steps, once its derivative, its start and its parameters are there.
 * The memory and the kernel are those of a generated plant, so that only the derivative differs.
 */
#ifndef ISO_TESTS_HANDWRITTEN_PLANT_H
#define ISO_TESTS_HANDWRITTEN_PLANT_H

#include "core/explicit.h"
#include "core/plant.h"

/* An array of C has at least one member; counts of inputs and parameters may be zero. */
#define HANDWRITTEN_PLANT(plant_name, state_count, input_count, parameter_count)                                       \
    static struct {                                                                                                    \
        real x[state_count];                                                                                           \
        real u[(input_count) + 1];                                                                                     \
        real p[(parameter_count) + 1];                                                                                 \
        real work[ISO_EXPLICIT_WORK(state_count)];                                                                     \
    } memory;                                                                                                          \
                                                                                                                       \
    static void step(void)                                                                                             \
    {                                                                                                                  \
        iso_explicit_step(&iso_tableau_rk4, state_count, derivative, R(0.001), memory.x, memory.u, memory.p,           \
                          memory.work);                                                                                \
    }                                                                                                                  \
                                                                                                                       \
    const iso_plant iso_the_plant = {                                                                                  \
        .name = plant_name,                                                                                            \
        .method = "rk4",                                                                                               \
        .step_text = "0.001",                                                                                          \
        .step_size = R(0.001),                                                                                         \
        .period_ns = 1000000,                                                                                          \
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
        .step = step,                                                                                                  \
    }

#endif
