/* What plants that are written by hand share: the method and the step, the memory, and an iso_plant of it and the
 * equations. A build can set another method and step by -DISO_METHOD=ISO_HEUN -DISO_METHOD_NAME=heun -DISO_STEP=0.0005
 * (seconds, with a decimal point), and options of the method by -DISO_CHECK, -DISO_COMPENSATE, and -DISO_TOLERANCE=1e-9
 * of adams, which then makes as many sub-steps as it needs. */
#ifndef ISO_CORE_RUNTIME_HANDWRITTEN_H
#define ISO_CORE_RUNTIME_HANDWRITTEN_H

#ifndef ISO_METHOD
#define ISO_METHOD ISO_RK4
#define ISO_METHOD_NAME rk4
#endif

#define ISO_EXPAND(macro, argument) macro(argument)
#define ISO_STRING(text) #text

#ifdef ISO_TOLERANCE
#define ISO_ADAMS_TOLERANCE ISO_EXPAND(R, ISO_TOLERANCE)
#define ISO_ADAMS_SUBSTEPS 1000000
#define ISO_ADAMS_HALVINGS ISO_ADAMS_LEVELS
#endif

/* The list of this one method. */
#ifndef ISO_METHOD_LIST
#include "core/methods/all.h"
#undef ISO_METHOD_LIST
#define ISO_ROW_OF_METHOD(X, r, m, name) X(r, m, name)
#define ISO_METHOD_LIST(X, r) ISO_ROW_OF_METHOD(X, r, ISO_METHOD, ISO_METHOD_NAME)
#endif

#include "core/methods/primed.h"
#include "core/runtime/plant.h"
#include "core/runtime/tick.h"

#ifndef ISO_STEP
#define ISO_STEP 0.001
#endif

/* A plant that defines `factor` and `solve` defines this before it includes the file: an implicit method calls both. */
#ifndef ISO_HAS_JACOBIAN
_Static_assert(!ISO_IS_IMPLICIT(ISO_METHOD),
               "this method needs a Jacobian, and this plant has none: give its equations "
               "factor and solve, and define ISO_HAS_JACOBIAN before handwritten.h");
#endif

#ifdef ISO_CHECK
#define ISO_RECIPE_CHECK ISO_CHECKED
#else
#define ISO_RECIPE_CHECK 0
#endif

#ifdef ISO_COMPENSATE
#define ISO_RECIPE_SUM ISO_COMPENSATED
#else
#define ISO_RECIPE_SUM 0
#endif

/* A plant with smooth inputs defines this before it includes the file; its equations then have held, inputs and
 * smooth. */
#ifdef ISO_HAS_SMOOTH_INPUTS
#define ISO_RECIPE_INPUTS ISO_SMOOTH
#else
#define ISO_RECIPE_INPUTS 0
#endif

#define ISO_RECIPE (ISO_METHOD | ISO_RECIPE_CHECK | ISO_RECIPE_SUM | ISO_RECIPE_INPUTS)

/* The step as a number, as text, and as the port's tick. */
#define ISO_STEP_SIZE ISO_EXPAND(R, ISO_STEP)
#define ISO_METHOD_TEXT ISO_EXPAND(ISO_STRING, ISO_METHOD_NAME)
#define ISO_STEP_TEXT ISO_EXPAND(ISO_STRING, ISO_STEP)
#define ISO_STEP_NS ((uint32_t)(ISO_STEP * 1e9 + 0.5))

/* `plant_memory`: the state with the method's history behind it, inputs, parameters and outputs. C has no empty array:
 * an array without elements is one number that nothing uses. */
#define ISO_PLANT_MEMORY(state_count, input_count, parameter_count, output_count)                                      \
    typedef struct plant_memory {                                                                                      \
        real x[ISO_METHOD_STATE(ISO_RECIPE, state_count)];                                                             \
        real u[((input_count) > 0 ? (input_count) : 1) + ISO_METHOD_SAMPLES(ISO_RECIPE, input_count)];                 \
        real p[(parameter_count) > 0 ? (parameter_count) : 1];                                                         \
        real y[(output_count) > 0 ? (output_count) : 1];                                                               \
        real good[(input_count) + (parameter_count) + (output_count) + 1];                                             \
        iso_any_progress progress;                                                                                     \
    } plant_memory

/* Defines iso_the_plant and iso_the_derivative from `plant_memory`, `equations`, `output` and `start`; further members
 * of the model follow as initialisers. */
#define ISO_PLANT(state_count, input_count, parameter_count, output_count, ...)                                        \
    static void publish(void *const instance)                                                                          \
    {                                                                                                                  \
        plant_memory *const memory = instance;                                                                         \
        output(memory->y, memory->x, memory->u, memory->p);                                                            \
    }                                                                                                                  \
                                                                                                                       \
    static iso_refused admit(void *const instance)                                                                     \
    {                                                                                                                  \
        plant_memory *const memory = instance;                                                                         \
        return iso_pair_of(iso_admit(memory->u, memory->good, NULL, input_count, NULL),                                \
                           iso_admit(memory->p, memory->good + (input_count), NULL, parameter_count, NULL));           \
    }                                                                                                                  \
                                                                                                                       \
    static void prime(void *const instance)                                                                            \
    {                                                                                                                  \
        plant_memory *const memory = instance;                                                                         \
        real work[ISO_METHOD_PRIME_WORK(ISO_RECIPE, state_count) + ISO_ROOM(input_count)];                             \
        real lu[(state_count) * (state_count)];                                                                        \
        iso_method_forget(ISO_RECIPE, &equations, memory->u);                                                          \
        iso_method_prime(ISO_RECIPE, state_count, &equations, ISO_STEP_SIZE, memory->x, memory->u, memory->p, lu,      \
                         work, &memory->progress.progress);                                                            \
    }                                                                                                                  \
                                                                                                                       \
    ISO_FLAT static void step(void *const instance)                                                                    \
    {                                                                                                                  \
        plant_memory *const memory = instance;                                                                         \
        real work[ISO_METHOD_WORK(ISO_RECIPE, state_count) + ISO_ROOM(input_count)];                                   \
        real lu[(state_count) * (state_count)];                                                                        \
        iso_method_sample(ISO_RECIPE, &equations, memory->u);                                                          \
        iso_method_step(ISO_RECIPE, state_count, &equations, ISO_STEP_SIZE, memory->x, memory->u, memory->p, lu, work, \
                        &memory->progress.progress);                                                                   \
    }                                                                                                                  \
                                                                                                                       \
    static const iso_model model;                                                                                      \
    static iso_count finish(void *const instance)                                                                      \
    {                                                                                                                  \
        plant_memory *const memory = instance;                                                                         \
        return iso_finish(memory, memory->x, model.range, state_count, model.advance, publish, memory->y,              \
                          memory->good + (input_count) + (parameter_count), output_count);                             \
    }                                                                                                                  \
                                                                                                                       \
    static const iso_model model = {.method = ISO_METHOD_TEXT,                                                         \
                                    .step_text = ISO_STEP_TEXT,                                                        \
                                    .step_size = ISO_STEP_SIZE,                                                        \
                                    .period_ns = ISO_STEP_NS,                                                          \
                                    .states = state_count,                                                             \
                                    .inputs = input_count,                                                             \
                                    .outputs = output_count,                                                           \
                                    .parameters = parameter_count,                                                     \
                                    .start = start,                                                                    \
                                    .memory_bytes = sizeof(plant_memory),                                              \
                                    .output = publish,                                                                 \
                                    .admit = (input_count) + (parameter_count) > 0 ? admit : NULL,                     \
                                    .prime = prime,                                                                    \
                                    .step = step,                                                                      \
                                    .attempt = ISO_IS_PRIMED(ISO_RECIPE) ? iso_plant_attempt : NULL,                   \
                                    .tell = iso_plant_tell,                                                            \
                                    .finish = finish,                                                                  \
                                    __VA_ARGS__};                                                                      \
                                                                                                                       \
    static plant_memory the_memory, the_memory_before;                                                                 \
    iso_derivative *const iso_the_derivative = derivative;                                                             \
    const iso_plant iso_the_plant = {.model = &model,                                                                  \
                                     .memory = &the_memory,                                                            \
                                     .x = the_memory.x,                                                                \
                                     .u = the_memory.u,                                                                \
                                     .p = the_memory.p,                                                                \
                                     .y = the_memory.y,                                                                \
                                     .progress = &the_memory.progress.progress,                                        \
                                     .adams = ISO_IS_VARYING(ISO_RECIPE) ? &the_memory.progress.adams : NULL,          \
                                     .before = ISO_IS_WATCHED(ISO_RECIPE) ? &the_memory_before : NULL,                 \
                                     .good = the_memory.good}

/* Reals of work space for the inputs of a stage. */
#define ISO_ROOM(input_count) (ISO_IS_SMOOTH(ISO_RECIPE) ? (size_t)(input_count) : 0)

#endif
