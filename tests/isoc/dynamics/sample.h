/* Random states of a mechanism, with what the plant and the independent dynamics say there. */
#ifndef ISO_TESTS_DYNAMICS_SAMPLE_H
#define ISO_TESTS_DYNAMICS_SAMPLE_H

#include "core/runtime/plant.h"
#include "tests/isoc/dynamics/tables.h"

enum { STATES = 100, STATES_MAX = 64, INPUTS_MAX = 6, NUMBERS_MAX = 4 * OUTPUTS_MAX };

/* What tolerances are multiples of, and how far off positive controls are, in the plant's real. */
#define EPSILON ((wide)ISO_REAL_EPSILON)
#ifdef ISO_REAL_DOUBLE
#define CONTROL_OFF 1e-6L
#else
#define CONTROL_OFF 1.0L
#endif

typedef struct sample {
    real x[STATES_MAX];
    real u[INPUTS_MAX];
    real dx[STATES_MAX];
    wide input[INPUTS_MAX];
    joint_motion motion; /* a is the plant's */
    solution exact;
    /* Of the accelerations, over the relative change of coordinates, speeds, lengths and masses that makes it; 0
     * without closures. */
    wide change[BODIES_MAX][SPEEDS_MAX];
    wide condition; /* the same in 2-norms, relative to the accelerations; at least 1 */
} sample;

/* All states: angles over the whole circle, sliders within 0.5 m, speeds to 10 rad/s or m/s, inputs to 10 N or N m;
 * where there are closures, about the scene's start, and then moved to where they hold. False if too few can be found.
 */
bool sample_all(sample s[STATES]);

/* The plant's positions change as its speeds say: the worst error relative to the speed; exact but for quaternions. */
wide sample_position_rates(const sample *s);

/* y[outputs]: the plant's outputs at the sample, with its parameters at their defaults. */
void sample_outputs(const sample *s, real *y);

#endif
