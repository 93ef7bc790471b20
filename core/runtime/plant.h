/* The interface of a plant: generated and hand-written plants fill in the same structs.
 *
 * A plant is x' = f(x, u, p), y = g(x, u, p): states x, inputs u held over a step, tunable parameters p, outputs y,
 * all in SI units (m, kg, s, rad). Its model is constant, and all plants of one kind share it. Its memory is one flat
 * struct without pointers, so that a snapshot is one copy, and every function of the model takes it. C and C++.
 */
#ifndef ISO_CORE_RUNTIME_PLANT_H
#define ISO_CORE_RUNTIME_PLANT_H

#include <stddef.h>

#include "core/methods/equations.h"
#include "core/methods/progress.h"
#include "core/runtime/admit.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Beyond it, the domain of iso_sincos, the sine of an angle is a number of no meaning (rad). */
#define ISO_ANGLE_RANGE ISO_SCALAR(1e4)

/* A state, an input, a parameter or an output by name, unit and limits: a generated header has tables of them. */
typedef struct iso_quantity {
    const char *name;
    const char *unit; /* m, rad/s, N*m, ..., 1 for a pure number */
    iso_scalar least; /* -ISO_REAL_MAX and ISO_REAL_MAX: no limit */
    iso_scalar most;
    iso_scalar start; /* of a state; of a parameter its default; else 0 */
} iso_quantity;

typedef struct iso_statistics iso_statistics;
struct iso_plant;
struct iso_policy;

/* Shared by all plants of one kind. A function that a plant does not need is NULL. */
typedef struct iso_model {
    const char *name;
    const char *method;    /* as a scene calls it */
    const char *step_text; /* the step in seconds, as a decimal number */
    iso_scalar step_size;  /* s */
    uint32_t period_ns;    /* the same step, as the port's tick */
    uint16_t states;       /* sizes of the arrays of a plant */
    uint16_t inputs;
    uint16_t outputs;
    uint16_t parameters;
    uint16_t memories;         /* numbers behind the inputs in u, which `advance` sets */
    const char *state_names;   /* separated by commas; NULL if unknown */
    const char *output_names;  /* likewise; always known */
    const char *output_units;  /* as many: m, rad/s, N*m, ..., 1 for a pure number; NULL if unknown */
    const char *closure_names; /* likewise, where steps are watched for singular positions of closures; else NULL */
    const iso_scalar *start;   /* the state at tick 0 */
    /* Sets the states and memories whose start is a formula, and the memories that do not start at 0. */
    void (*begin)(void *memory);
    const iso_scalar *defaults; /* of the parameters */
    /* [states] For the guard, how large each may be: ISO_REAL_MAX where any finite number is allowed, ISO_ANGLE_RANGE
     * for an angle whose sine is taken. NULL: all may be any finite number. */
    const iso_scalar *range;
    size_t memory_bytes;                   /* of a plant: all that a snapshot must hold */
    void (*output)(void *memory);          /* y from x, u, p */
    real (*violation)(const void *memory); /* m or rad: how far off their closures the states are */
    iso_scalar violation_limit;            /* a tick that ends farther off is counted */
    /* Sets the inputs that are functions of time, and the states that are time itself, to their values at a tick. */
    void (*drive)(void *memory, uint64_t tick);
    /* 0 if no input needs a correction and no parameter has changed: then `admit` is not called, and `finish` keeps the
     * inputs. NULL: `admit` is always called. */
    iso_bits (*amiss)(const void *memory);
    iso_refused (*admit)(void *memory); /* checks, corrects and keeps inputs and parameters */
    void (*advance)(void *memory);      /* begins a row: sets the functions of time that it shows, and the memories */
    /* Whether an input or a parameter has a discontinuity, or an event ended the smooth motion: then the history of the
     * method is invalid. */
    iso_flag (*discontinuity)(void *memory);
    void (*prime)(void *memory); /* computes the method's history, and what depends on parameters alone */
    void (*step)(void *memory);  /* advances x by one step, with constant u: the real-time part */
    /* A step that may begin with a new history, or be made again: iso_plant_attempt. NULL: `step` alone. */
    iso_flag (*attempt)(const struct iso_plant *plant);
    /* Adds a tick to the statistics: iso_plant_tell. */
    void (*tell)(const struct iso_plant *plant, uint64_t tick, iso_statistics *statistics);
    iso_count (*finish)(void *memory); /* the rest of a tick: iso_finish (core/runtime/tick.h) */
    const struct iso_policy *policy;   /* core/runtime/policy.h */
} iso_model;

/* A plant: a model, and where its memory is. In the memory are x, u, p, y and the last good inputs, parameters and
 * outputs. After a write to x between two steps model->output is called; p is read by iso_plant_admit. */
typedef struct iso_plant {
    const iso_model *model;
    void *memory;
    real *x;                        /* state */
    real *u;                        /* inputs */
    real *p;                        /* tunable parameters */
    real *y;                        /* outputs */
    iso_progress *progress;         /* how the last step went; NULL where nothing reads it */
    iso_nearness *nearness;         /* whether steps came near a singular position; NULL where nothing watches */
    iso_event_counts *event_counts; /* events since they were last told; NULL where there are none */
    const iso_adams_state *adams;   /* how its steps vary; NULL for any other method (core/methods/adams.h) */
    void *before;                   /* [memory_bytes] for what was before a step; NULL where no step is made again */
    real *good;                     /* the last good inputs, parameters and outputs */
#ifdef ISO_LANES
    void *spare;       /* [memory_bytes] for actions of some lanes only: core/runtime/lanes.h */
    size_t lane_bytes; /* bytes of the memory that are rows, with a word of each lane */
#endif
} iso_plant;

/* Sets the inputs that are functions of time to those of a tick. */
static inline void iso_plant_drive(const iso_plant *const plant, const uint64_t tick)
{
    if (plant->model->drive != NULL) {
        plant->model->drive(plant->memory, tick);
    }
}

/* Checks, corrects and keeps inputs and tunables. Returns the refused ones. Most ticks have nothing to correct. */
static inline iso_refused iso_plant_admit(const iso_plant *const plant)
{
    const iso_model *const model = plant->model;
    if (model->admit == NULL || (model->amiss != NULL && !iso_any(model->amiss(plant->memory)))) {
        return iso_pair_of(ISO_NOTHING, ISO_NOTHING);
    }
    return model->admit(plant->memory);
}

/* The first part of a start: the state and the parameters of the model, and nothing else in the memory. */
static inline void iso_plant_reset(const iso_plant *const plant)
{
    const iso_model *const model = plant->model;
    if (model->memory_bytes > 0) {
        memset(plant->memory, 0, model->memory_bytes);
    }
    iso_spread(plant->x, model->start, model->states);
    if (model->parameters > 0) {
        iso_spread(plant->p, model->defaults, model->parameters);
    }
}

/* The second part of a start: what follows from state and parameters. Returns what iso_plant_start does. */
static inline bool iso_plant_begin(const iso_plant *const plant)
{
    const iso_model *const model = plant->model;
    iso_plant_drive(plant, 0);
    if (model->admit != NULL) {
        (void)model->admit(plant->memory);
    }
    if (model->begin != NULL) {
        model->begin(plant->memory);
    }
    if (model->prime != NULL) {
        model->prime(plant->memory);
    }
    return !iso_any(iso_not_finite(plant->x[0]));
}

/* Sets all to tick 0: state, parameters, inputs, and the method's history. Returns false where the start found
 * that this build computes with other bits (isoc --name and --standalone): then the first state is a NaN, and every
 * tick ends at the guard. A caller with a state or parameters of its own sets them between the two parts. */
static inline bool iso_plant_start(const iso_plant *const plant)
{
    iso_plant_reset(plant);
    return iso_plant_begin(plant);
}

/* The plant that this program runs. */
#define iso_the_plant ISO_REAL_NAME(iso_the_plant)
extern const iso_plant iso_the_plant;

/* x' = f(x, u, p) of that plant, for programs that analyse it. It is no member of the model: in a small plant it exists
 * as a part of the step only, and a program that does not refer to it has none of its bytes. */
#define iso_the_derivative ISO_REAL_NAME(iso_the_derivative)
extern iso_derivative *const iso_the_derivative;

#ifdef __cplusplus
}
#endif

#endif
