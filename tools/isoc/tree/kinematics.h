/* How the segments move, as nodes: joint by joint, in segment axes about segment origins. */
#ifndef ISOC_TREE_KINEMATICS_H
#define ISOC_TREE_KINEMATICS_H

#include "tools/isoc/mechanism/mechanism.h"

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

/* The component of a force and a moment along a degree of freedom. */
node component_along(const kinematics *k, int f, vector linear, vector angular);

/* A vector from segment axes to the parent's axes and back. */
vector to_parent(const kinematics *k, int segment, vector a);
vector from_parent(const kinematics *k, int segment, vector a);

/* Across the joint alone: from segment axes to the axes that the segment would have unturned, and tensors likewise. */
vector unturn(const kinematics *k, int segment, vector a);
matrix unturn_matrix(const kinematics *k, int segment, matrix a);
tensor unturn_tensor(const kinematics *k, int segment, tensor j);

/* From the axes of a segment to those of one before it, or the ground's; the place of a point of a segment in that
 * frame. */
vector outward_axes(const kinematics *k, int segment, int to, vector a);
vector outward_point(const kinematics *k, int segment, int to, vector point);

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

#endif
