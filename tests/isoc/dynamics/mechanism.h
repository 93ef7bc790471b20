/* Rigid bodies in maximal coordinates, in long double: the independent check of generated plants.
 *
 * Every body has its six equations of Newton and Euler in the world frame; every joint and every loop closure holds the
 * two bodies that it is between by equations on their poses, all alike. One dense elimination gives accelerations and
 * reactions together. Velocities, and the second derivatives of the equations, come from jets. Nothing is recursive,
 * projected or symbolic here, and nothing is read from the scene compiler.
 */
#ifndef ISO_TESTS_DYNAMICS_MECHANISM_H
#define ISO_TESTS_DYNAMICS_MECHANISM_H

#include <stdbool.h>
#include <stddef.h>

#include "tests/isoc/dynamics/jet.h"

enum {
    BODIES_MAX = 13,
    CLOSURES_MAX = 6,
    COUPLINGS_MAX = 2,
    APPLIED_FORCES_MAX = 4,
    OUTPUTS_MAX = 12,
    GROUND = -1,
    COORDINATES_MAX = 7, /* of a joint */
    SPEEDS_MAX = 6,
};

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

/* The last five are closures only; gear and motion hold coordinates of joints. */
typedef enum joint_kind {
    FIXED,
    REVOLUTE,
    PRISMATIC,
    UNIVERSAL,
    CYLINDRICAL,
    PLANAR,
    SPHERICAL,
    FREE,
    LINE,
    DISTANCE,
    ROLLING,
    GEAR,
    MOTION,
} joint_kind;

/* Joint i carries body i. The axis is x, y or z where the joint is planar; `second` is square to it.
 * Coordinates: what slides, then what turns. Planar: along the two axes that follow the normal, in the order x, y, z,
 * x. Spherical and free: a quaternion w, x, y, z, whose speeds are the angular velocity in the axes of the child's
 * frame. The generalised force of the only coordinate is u[input - 1] - damping q' - stiffness (q - rest), in N or N m;
 * input 0 is none. Where there are several, it is -damping q' of what slides, -spin_damping q' of what turns. */
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
    wide second[3];
    wide spin_damping;
} tree_joint;

/* What holds between a body and its parent, beside the joints of the tree. */
typedef struct loop_closure {
    joint_kind kind;
    int parent, child;
    placement on_parent;
    placement on_child;
    wide axis[3];
    wide length;   /* of DISTANCE; the radius of ROLLING, whose plane across the axis rests; m */
    wide wheel[3]; /* of ROLLING: the axle of a thin disc, in the child's frame; zero: a ball */
} loop_closure;

/* What holds between the coordinates of two joints, or of one and time: q_first = ratio q_second + offset, or, where
 * second is GROUND, q_first = swing sin(omega time + phase). Revolute or prismatic ones. */
typedef struct coupling {
    int first, second;
    wide ratio, offset;
    wide swing, omega, phase;
} coupling;

/* The force u[input - 1] on a point of a body, along an axis of the body; and that times `lever` as a moment about it.
 */
typedef struct applied_force {
    int body;
    wide at[3];
    wide axis[3];
    wide lever;
    int input;
} applied_force;

typedef enum output_kind {
    POSITION,
    SPEED,
    ACCELERATION,
    TURNS,
    POINT,
    POINT_VELOCITY,
    ENERGY,
    ORIENTATION,
    BODY_SPIN,
    FORCE,  /* of a closure on its child, world axes */
    MOMENT, /* about the origin of the child's frame */
    VIOLATION,
} output_kind;

typedef struct tree_output {
    output_kind kind;
    int of;        /* joint, body or closure */
    wide point[3]; /* m, in the body's frame */
} tree_output;

typedef struct mechanism {
    wide gravity[3]; /* m/s^2 */
    int bodies;
    rigid_body body[BODIES_MAX];
    tree_joint joint[BODIES_MAX];
    int closures;
    loop_closure closure[CLOSURES_MAX];
    int couplings;
    coupling coupling[COUPLINGS_MAX];
    wide time; /* s */
    int applied_forces;
    applied_force applied_force[APPLIED_FORCES_MAX];
    int outputs;
    tree_output output[OUTPUTS_MAX];
} mechanism;

/* Coordinates, speeds and accelerations of the joints. */
typedef struct joint_motion {
    wide q[BODIES_MAX][COORDINATES_MAX];
    wide v[BODIES_MAX][SPEEDS_MAX];
    wide a[BODIES_MAX][SPEEDS_MAX];
} joint_motion;

/* World pose of a frame: its point b is at origin + turn b. */
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
    /* How each speed of the joint moves the child against its parent: the point at the hinge, and the turn. */
    wide slide[SPEEDS_MAX][3];
    wide turn[SPEEDS_MAX][3];
} body_motion;

/* Force and moment that a joint or closure puts on its child, at the origin of its frame on the child; of a joint with
 * those of drive, damping, spring and coupling. */
typedef struct reaction {
    wide force[3];
    wide moment[3];
} reaction;

typedef struct solution {
    wide a[BODIES_MAX][SPEEDS_MAX];   /* of the joints */
    wide acceleration[BODIES_MAX][3]; /* of the centres of mass */
    reaction joint[BODIES_MAX];
    reaction closure[CLOSURES_MAX];
    wide coupling[COUPLINGS_MAX]; /* effort on the first joint; on the second it is -ratio times that */
} solution;

/* Linear momentum, and angular momentum about the world's origin; to first order in time. */
typedef struct momentum {
    jet3 linear;
    jet3 angular;
} momentum;

int joint_coordinates(joint_kind kind);
int joint_speeds(joint_kind kind);

/* Coordinates and speeds of all joints. */
int mechanism_coordinates(const mechanism *m);
int mechanism_dofs(const mechanism *m);

/* Whether a body is `root` or hangs on it; all hang on GROUND, which hangs on nothing. */
bool mechanism_carries(const mechanism *m, int root, int body);

/* Poses and velocities of all bodies along the motion; or of body i alone, when its parent is known. */
void mechanism_move(const mechanism *m, const joint_motion *motion, body_motion out[BODIES_MAX]);
void mechanism_move_body(const mechanism *m, const joint_motion *motion, int i, body_motion out[BODIES_MAX]);

/* The frame p on a body that stands at `on`, or on the ground if that is NULL. */
pose frame_on(const pose *on, const placement *p);

/* Where body i stands; NULL for GROUND. */
static inline const pose *pose_of(const body_motion moved[BODIES_MAX], const int i)
{
    return i == GROUND ? NULL : &moved[i].body;
}

/* Moves coordinates and speeds to where the closures hold, by least changes. False if Newton's method does not get
 * there. */
bool mechanism_close(const mechanism *m, joint_motion *motion);

/* How far from dependent the equations of the closures are: the sine of the least angle between a row of their Jacobian
 * and those that were eliminated before it; 1 where there are none. */
wide mechanism_independence(const mechanism *m, const joint_motion *motion);

/* Generalised force of speed k of joint j without its spring, for the inputs u; and the spring's. */
wide mechanism_effort(const mechanism *m, int j, int k, const joint_motion *motion, const wide *u);
wide mechanism_spring(const mechanism *m, int j, const joint_motion *motion);

/* Where the force of a applied force attacks, and its axis. */
void mechanism_applied_force(const mechanism *m, const body_motion moved[BODIES_MAX], int n, wide point[3],
                             wide axis[3]);

/* Accelerations and reactions from the equations of motion; motion->a is not read. Equations of closures that follow
 * from others are left out. False if some contradict others. */
bool mechanism_solve(const mechanism *m, const joint_motion *motion, const wide *u, solution *out);

/* Kinetic and potential energy (gravity from the ground's origin, springs); to first order in time. */
jet mechanism_energy(const mechanism *m, const joint_motion *motion, const body_motion moved[BODIES_MAX]);

/* Momentum of body `root` (of all for GROUND) and of all bodies that hang on it; their weight and its moment about the
 * origin. */
momentum mechanism_momentum(const mechanism *m, const body_motion moved[BODIES_MAX], int root, wide weight[3],
                            wide weight_moment[3]);

/* The outputs in order, vectors as their numbers; returns how many. TURNS and VIOLATION give zero. */
int mechanism_outputs(const mechanism *m, const joint_motion *motion, const solution *solved, wide *y);

/* How many numbers an output has. */
int output_numbers(output_kind kind);

#endif
