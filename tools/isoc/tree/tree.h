/* Shared by the files of trees. */
#ifndef ISOC_TREE_TREE_H
#define ISOC_TREE_TREE_H

#include "tools/isoc/mechanism/mechanism.h"

/* kinematics.c: how the segments move, as nodes: joint by joint, in segment axes about segment origins. */

/* The motion of each segment's joint, and of the segment by it and those before it. */
typedef struct motion {
    node q[4], qd[3]; /* positions and speeds: states */
    node s, c;        /* sine and cosine of the turn about the segment's axis; 0 and 1 where it slides */
    matrix free_turn; /* of a spherical joint: from the segment's axes to those that it had unturned */
    vector rate;      /* the joint's share of the angular velocity, or of the velocity: in the segment's axes */
    vector p;         /* the segment's origin in the parent's frame */
    vector carried;   /* the parent's angular velocity, in the segment's axes */
    vector omega;     /* angular velocity, in the segment's axes */
    vector v;         /* velocity of the origin, in the segment's axes; after kinematics_velocities */
} motion;

/* A force and a moment, in the axes of a segment or of the ground, about its origin. */
typedef struct wrench {
    vector force, moment;
} wrench;

typedef struct kinematics {
    const mechanism *m;
    graph *g;
    motion *motions;
    bool absolute; /* of segments that turn about parallel axes: relative to the parent of the first of them */
} kinematics;

/* Places and angular velocities. */
kinematics kinematics_build(graph *g, const mechanism *m);

/* Velocities of the segments' origins, which only outputs and closures need. */
void kinematics_velocities(const kinematics *k);

bool slides(const segment *l);

/* Where speeds are absolute and a segment turns about the axis that its parent turns about: 1, or -1 if the other way
 * about; else 0. */
int shared_axis(const kinematics *k, int segment);

/* The axis of a degree of freedom in its segment's axes. */
vector axis_of(const kinematics *k, int f);

/* The parts of a joint's motion along its axes, such as its rate, that slide and that turn. */
vector slide_of(const kinematics *k, int segment, vector moved);
vector turn_of(const kinematics *k, int segment, vector moved);

/* The component of a wrench along a degree of freedom. */
node component_along(const kinematics *k, int f, wrench w);

/* A vector from segment axes to the parent's axes and back. */
vector to_parent(const kinematics *k, int segment, vector a);
vector from_parent(const kinematics *k, int segment, vector a);

/* Across the joint alone: from segment axes to the axes that the segment would have unturned. */
vector unturn(const kinematics *k, int segment, vector a);
matrix unturn_matrix(const kinematics *k, int segment, matrix a);

/* From the axes of a segment to those of one before it, or the ground's; the place of a point of a segment in that
 * frame. */
vector outward_axes(const kinematics *k, int segment, int to, vector a);
vector outward_point(const kinematics *k, int segment, int to, vector point);

/* From the axes of a body's segment to those of the body, or of the ground. */
vector axes_of_body(const kinematics *k, const body_frame *frame, bool in_body, vector a);

/* From the axes of a segment, or the ground's, to those of a segment that hangs on it. */
vector inward_axes(const kinematics *k, int from, int segment, vector a);

/* The velocity of a point of a segment, in the segment's axes. */
vector point_velocity(const kinematics *k, int segment, vector point);

/* The orientation of a body against the ground, as a quaternion w, x, y, z. */
void body_orientation(const kinematics *k, const body_frame *frame, node q[4]);

/* alpha x r + omega x (omega x r), with the squares and products of omega shared by all points of a segment. */
vector swing(graph *g, vector omega, vector alpha, vector r);

/* q' of the positions of a segment: its speeds, or 1/2 q (0, omega) of a quaternion. */
void position_rates(const kinematics *k, int segment, node *rates);

/* wrench.c: forces with their moments, as nodes. */

/* The acceleration of a segment, with the ground accelerated by -gravity; in segment axes. */
typedef struct acceleration {
    vector alpha; /* angular */
    vector a;     /* of the origin */
} acceleration;

wrench wrench_add(graph *g, wrench a, wrench b);
wrench wrench_sub(graph *g, wrench a, wrench b);

/* A force at a point, with a moment beside it. */
wrench wrench_at(graph *g, vector point, vector force, vector moment);

/* The wrench that a body needs for this motion. */
wrench wrench_of_motion(graph *g, composite whole, vector omega, acceleration now);

/* The wrench of a force on its segment. */
wrench wrench_of_applied_force(graph *g, const applied_force *t);

/* From a segment to its parent. */
wrench wrench_to_parent(const kinematics *k, int segment, wrench w);

/* bias.c: the efforts that the tree of segments needs to move with q'' = 0: recursive Newton-Euler, as nodes.
 *
 * Luh, Walker, Paul (1980), "On-line computational scheme for mechanical manipulators", J. Dynamic Systems,
 * Measurement, and Control 102(2), about segment origins after Khalil and Kleinfinger (1987).
 */

/* The acceleration of a segment that comes from turning its joint's own rate. */
acceleration joint_coriolis(const kinematics *k, int segment);

/* The acceleration of a segment at q'' = 0 from that of its parent, which stands in `all`. */
acceleration accelerate_outward(const kinematics *k, int segment, const acceleration *all);

/* The wrench that each segment alone needs for its acceleration, less the forces on it. */
void inertial_wrenches(const kinematics *k, const acceleration *accelerations, wrench *wrenches);

/* From the tips to the root: efforts[degrees of freedom] from the wrenches of single segments, which become those of
 * segments with their descendants. */
void efforts_of_wrenches(const kinematics *k, wrench *wrenches, node *efforts);

/* Fills bias[degrees of freedom] with the efforts, less those of forces on bodies, and accelerations[segments]. */
void bias_build(const kinematics *k, node *bias, acceleration *accelerations);

/* mass_matrix.c: the mass matrix of a tree of segments, as nodes, factorised.
 *
 * Composite bodies in segment frames, after Khalil and Kleinfinger (1987), "Minimum operations and minimum parameters
 * of the dynamic models of tree structure robots", IEEE J. Robotics Automation 3(6); and the factorisation M = L' D L
 * of Featherstone (2008), Rigid Body Dynamics Algorithms, ch. 6, which keeps the zeros between branches. */

typedef struct mass_matrix {
    const kinematics *k;
    int n;
    node *entries; /* [n n] of M, where one degree of freedom is an ancestor of the other: below the diagonal, and on it
                    */
    node *at;      /* [n n]: L below the diagonal, after the factorisation */
    node *pivots;  /* D_i: M_ii less the parts of the degrees of freedom beyond i */
    node *inverse; /* 1 / D_i; zero of those that are left */
    const bool *is_left; /* [n] degrees of freedom, with all their ancestors, that the factorisation leaves: their rows
                          * of `at` are M less the parts of those beyond them; NULL: none */
} mass_matrix;

/* M itself; then its factors. */
mass_matrix mass_matrix_build(const kinematics *k);
void mass_matrix_factorise(mass_matrix *m);

/* The remainder of M_ij, for i and j that are left, j not after i. */
node mass_matrix_left(const mass_matrix *m, int i, int j);

/* The number of products of variables in the factorisation, from the zeros of M and the fill. Rows are made from the
 * tips on, until these are more than `most`. */
int mass_matrix_products(const kinematics *k, int most);

/* The diagonal alone, [degrees of freedom]: the inertia of each where all others are locked. For relative speeds. */
void mass_matrix_diagonal(const kinematics *k, node *diagonal);

/* x := L'^-1 x, from the tips to the root; and x := L^-1 x, from the root to the tips. [n] */
void mass_matrix_inward(const mass_matrix *m, node *x);
void mass_matrix_outward(const mass_matrix *m, node *x);

/* x := D^-1 x; a division, if nothing else needs the inverse of the pivot. */
void mass_matrix_scale(const mass_matrix *m, node *x);

/* The whole mechanism as one body about the ground's origin. */
composite composite_of_all(const kinematics *k);

/* articulated.c: the accelerations of a tree of segments by articulated bodies, as nodes.
 *
 * Featherstone (1983), "The calculation of robot dynamics using articulated-body inertias", Int. J. Robotics Research
 * 2(1); (2008), Rigid Body Dynamics Algorithms, ch. 7. In segment frames, about segment origins, with accelerations of
 * points in place of spatial ones, so that no velocity of an origin is needed. The cost grows with the number of
 * segments; factorising a mass matrix (tools/isoc/tree/mass_matrix.c) costs less for few segments, and grows with a
 * higher power. */

/* Angular components, then linear ones: of a wrench its moment and its force. */
enum { ANGULAR = 0, LINEAR = 3, SPATIAL = 6 };

typedef struct spatial {
    node at[SPATIAL][SPATIAL]; /* symmetric */
} spatial;

/* From x = efforts to x = q''. [degrees of freedom] */
void articulated_solve(const kinematics *k, node *x);

/* D of M = L' D L [degrees of freedom]: the inertia of each where those beyond it are free and those before it are not.
 */
void articulated_pivots(const kinematics *k, node *pivots);

/* Accelerations of the tree at rest: of each degree of freedom by a unit effort of its own, the diagonal of M^-1; and
 * of each segment's origin by a wrench about it, in segment axes. The cost grows with the number of segments:
 * Kreutz-Delgado, Jain and Rodriguez (1992), "Recursive formulation of operational space control", Int. J. Robotics
 * Research 11(4). */
void articulated_responses(const kinematics *k, node *joints, spatial *segments);

/* point_query.c: the motion of the points that effects and outputs ask for, in the place of the leaves that stand for
 * it; and the forces of effects, from the axes of the ground to those of their segments. */

/* The numbers of such a quantity of a point. */
void point_query_nodes(const kinematics *k, const query *q, node parts[QUERY_PARTS]);

void point_queries_resolve(graph *g, mechanism *m);

/* effective_inertia.c: the inertia that mechanisms offer at the start: a joint to an effort on it alone, and a point
 * of a body to a force along one axis alone. Effects derive from it how stiff they can be.
 */

/* The values of the leaves OP_INERTIA, as constants: of each degree of freedom, then three of each point that
 * is asked for (mechanism.h), infinite along an axis along which it cannot move. Closures would make them larger. NULL
 * where no formula asks for one. */
const node *effective_inertias(graph *g, const mechanism *m);

#endif
