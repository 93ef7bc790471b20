/* A tree of rigid bodies in maximal coordinates, in long double: the independent check of generated plants.
 *
 * Every body has its six equations of Newton and Euler in the world frame and every joint its six constraint
 * equations; one dense elimination gives accelerations and joint reactions together. Velocities come from jets of the
 * poses. Nothing is recursive, projected or symbolic here, and nothing is read from the scene compiler.
 */
#ifndef ISO_TESTS_DYNAMICS_MECHANISM_H
#define ISO_TESTS_DYNAMICS_MECHANISM_H

#include <stdbool.h>

#include "tests/dynamics/jet.h"

enum { BODIES_MAX = 6, OUTPUTS_MAX = 12, GROUND = -1 };

typedef struct rigid_body {
    wide mass;       /* kg */
    wide com[3];     /* m, in the body's frame */
    wide inertia[6]; /* kg m^2, about com: xx, yy, zz, xy, xz, yz */
} rigid_body;

/* A frame on a body: moved by at (m), then turned by degrees about axis (any length). */
typedef struct placement {
    wide at[3];
    wide degrees;
    wide axis[3];
} placement;

typedef enum joint_kind { FIXED, REVOLUTE, PRISMATIC } joint_kind;

/* Joint i carries body i. Its generalised force is u[input - 1] - damping q' - stiffness (q - rest), in N or N m;
 * input 0 is none. */
typedef struct tree_joint {
    joint_kind kind;
    int parent; /* a body of lower index, or GROUND */
    placement on_parent;
    placement on_child;
    wide axis[3];
    wide damping;
    wide stiffness;
    wide rest;
    int input;
} tree_joint;

typedef enum output_kind { POSITION, SPEED, ACCELERATION, TURNS, POINT, POINT_VELOCITY, ENERGY } output_kind;

typedef struct tree_output {
    output_kind kind;
    int of;        /* joint or body */
    wide point[3]; /* m, in the body's frame */
} tree_output;

typedef struct mechanism {
    wide gravity[3]; /* m/s^2 */
    int bodies;
    rigid_body body[BODIES_MAX];
    tree_joint joint[BODIES_MAX];
    int outputs;
    tree_output output[OUTPUTS_MAX];
} mechanism;

/* Motion of the joints, fixed ones included with zeros: position, speed, acceleration. */
typedef struct joint_motion {
    wide q[BODIES_MAX];
    wide qd[BODIES_MAX];
    wide qdd[BODIES_MAX];
} joint_motion;

/* World pose of body i: point b of the body is at origin + turn b. */
typedef struct pose {
    jet33 turn;
    jet3 origin;
} pose;

typedef struct body_motion {
    pose body;
    jet3 com;      /* position */
    jet3 velocity; /* of com; to first order */
    jet3 omega;    /* to first order */
    jet33 inertia; /* about com, world axes */
    wide hinge[3]; /* origin of the joint's frame on the child */
    wide axis[3];  /* direction of the joint, unit vector */
} body_motion;

/* Forces and moments that the joint puts on its child at `hinge`, with those of drive, damping and spring. */
typedef struct joint_reaction {
    wide force[3];
    wide moment[3];
} joint_reaction;

typedef struct solution {
    wide qdd[BODIES_MAX];
    wide acceleration[BODIES_MAX][3]; /* of the centres of mass */
    joint_reaction reaction[BODIES_MAX];
} solution;

/* Linear momentum, and angular momentum about the world's origin; to first order in time. */
typedef struct momentum {
    jet3 linear;
    jet3 angular;
} momentum;

/* Number of joints that are not fixed. */
int mechanism_freedoms(const mechanism *m);

/* Poses and velocities of all bodies along the motion. */
void mechanism_move(const mechanism *m, const joint_motion *motion, body_motion out[BODIES_MAX]);

/* Generalised force of joint j for the inputs u: drive, damping and spring. */
wide mechanism_force(const mechanism *m, int j, const joint_motion *motion, const wide *u);

/* Accelerations and reactions from the equations of motion; motion->qdd is not read. False if they are singular. */
bool mechanism_solve(const mechanism *m, const joint_motion *motion, const wide *u, solution *out);

/* Kinetic and potential energy (gravity from the ground's origin, springs); to first order in time. */
jet mechanism_energy(const mechanism *m, const joint_motion *motion, const body_motion moved[BODIES_MAX]);

/* Momentum of body `root` and of all bodies that hang on it; add their weight and its moment about the origin. */
momentum mechanism_momentum(const mechanism *m, const body_motion moved[BODIES_MAX], int root, wide weight[3],
                            wide weight_moment[3]);

/* Whether `body` is `root` or hangs on it. */
bool mechanism_carries(const mechanism *m, int root, int body);

/* The outputs in order, vectors as three numbers; returns how many. TURNS gives zero. */
int mechanism_outputs(const mechanism *m, const joint_motion *motion, wide *y);

#endif
