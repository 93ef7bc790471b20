/* What a plant is to everything downstream: generated and hand-written plants fill in the same struct.
 *
 * A plant is x' = f(x, u, p), y = g(x, u, p): states x, inputs u held over a step, tunable parameters p, outputs y,
 * all in SI units (m, kg, s, rad). Its memory is one flat struct without pointers, so that a snapshot is one copy.
 */
#ifndef ISO_CORE_RUNTIME_PLANT_H
#define ISO_CORE_RUNTIME_PLANT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/methods/equations.h"

/* Beyond it, the domain of iso_sincos, the sine of an angle is a number of no meaning (rad). */
#define ISO_ANGLE_RANGE R(1e4)

/* y[outputs] = g(x[states], u[inputs], p[parameters]). */
typedef void iso_outputs(real *restrict y, const real *restrict x, const real *restrict u, const real *restrict p);

typedef struct iso_plant {
    const char *name;
    const char *method;    /* as a scene calls it */
    const char *step_text; /* the step in seconds, as a decimal number */
    real step_size;        /* s */
    uint32_t period_ns;    /* the same step, as the port's tick */
    uint16_t states;       /* sizes of the arrays below */
    uint16_t inputs;
    uint16_t outputs;
    uint16_t parameters;
    const char *output_names; /* separated by commas */

    real *x;                             /* state, in the plant's memory */
    real *u;                             /* inputs */
    real *p;                             /* tunable parameters */
    real *y;                             /* outputs */
    const real *start;                   /* the state at tick 0 */
    const real *defaults;                /* of the parameters */
    const real *range;                   /* [states] each may be this large, for the guard; NULL where all may be any
                                            finite number, ISO_REAL_MAX where one may. ISO_ANGLE_RANGE for an angle
                                            whose sine is taken */
    struct iso_progress *progress;       /* how the last step went; NULL where nothing asks (core/methods/method.h) */
    const struct iso_adams_state *adams; /* how its steps vary; NULL for any other method (core/methods/adams.h) */
    void *memory;                        /* all that a snapshot must hold */
    size_t memory_bytes;
    void *before; /* [memory_bytes] for a snapshot from before a step that is made again after a jump, where the method
                     watches for one; NULL where no step is */

    iso_derivative *derivative;
    iso_outputs *output;
    iso_outputs *violation; /* y[1], m or rad: how far off their closures the states are; NULL where nothing asks */
    real violation_limit;   /* a tick that ends farther off is counted */
    void (*drive)(uint32_t tick); /* sets u to the scene's functions of time, and the states that are time itself to
                                     what they are at a tick; NULL without inputs and such states */
    bool (*jumped)(void);         /* whether an input or a parameter jumped, or something happened that ends the smooth
                                     motion: then the history is of no use. NULL where no history is kept */
    void (*prime)(void);          /* fills the method's history from x and u; NULL for a one-step method */
    void (*step)(void);           /* advances x by one step with u held: the real-time part */
} iso_plant;

/* Puts everything to tick 0: state, parameters, inputs, and what the method keeps. */
static inline void iso_plant_start(const iso_plant *const plant)
{
    if (plant->memory_bytes > 0) {
        memset(plant->memory, 0, plant->memory_bytes);
    }
    memcpy(plant->x, plant->start, plant->states * sizeof *plant->x);
    if (plant->parameters > 0) {
        memcpy(plant->p, plant->defaults, plant->parameters * sizeof *plant->p);
    }
    if (plant->drive != NULL) {
        plant->drive(0);
    }
    if (plant->prime != NULL) {
        plant->prime();
    }
}

/* The plant that this program runs. */
#define iso_the_plant ISO_REAL_NAME(iso_the_plant)
extern const iso_plant iso_the_plant;

#endif
