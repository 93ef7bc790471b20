/* The rest of a hand-written plant, once its derivative, its start and its parameters are there: the same memory and
 * kernel as a generated plant, so that only the derivative differs. It is declared inline: where the compiler takes the
 * hint, a step is cheaper still.
 */
#ifndef ISO_TESTS_HANDWRITTEN_PLANT_H
#define ISO_TESTS_HANDWRITTEN_PLANT_H

#include "core/runtime/handwritten.h"

#define HANDWRITTEN_PLANT(plant_name, state_count, input_count, parameter_count)                                       \
    ISO_PLANT_MEMORY(state_count, input_count, parameter_count, 0);                                                    \
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
    ISO_PLANT(state_count, input_count, parameter_count, 0, .name = plant_name, .output_names = "",                    \
              .defaults = defaults)

#endif
