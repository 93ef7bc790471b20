/* What a joint or a closure holds: equations on the poses of two frames, one on the parent and one on the child. */
#ifndef ISO_TESTS_DYNAMICS_HOLD_H
#define ISO_TESTS_DYNAMICS_HOLD_H

#include "tests/isoc/dynamics/mechanism.h"

enum { HELD_MAX = 6 };

typedef struct hold {
    int kind; /* a joint_kind, or a coordinate */
    int parent, child;
    placement on_parent, on_child;
    wide axis[3];
    wide second[3];
    wide length;
} hold;

/* One hold at a motion: the equations' values, the rates for unit velocities of the two bodies (of the centre of mass,
 * then angular; world axes), and the second derivatives for zero accelerations. */
typedef struct held {
    int rows;
    wide value[HELD_MAX];
    wide rate[HELD_MAX];
    wide bias[HELD_MAX];
    wide of_parent[HELD_MAX][6];
    wide of_child[HELD_MAX][6];
} held;

hold hold_of_joint(const mechanism *m, int j);
hold hold_of_closure(const mechanism *m, int n);

/* The coordinate of a revolute or prismatic joint that is at q: its one equation has the coordinate's rates. */
hold hold_of_coordinate(const mechanism *m, int j, wide q);

held hold_linearise(const hold *h, const body_motion moved[BODIES_MAX]);

#endif
