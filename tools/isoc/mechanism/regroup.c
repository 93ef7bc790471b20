#include "tools/isoc/mechanism/builder.h"

/* Adds mass, first moment and inertia about the origin of a segment's frame to the segment's parent. */
static void move_to_parent(builder *b, const segment *from, node mass, vector ms, tensor inertia)
{
    graph *g = b->g;
    const vector turned = matrix_apply(g, from->turn, ms);
    const vector moment = vector_add(g, turned, vector_scale(g, mass, from->offset));
    if (from->parent == GROUND) {
        b->mechanism.bodies.ground_mass = add(g, b->mechanism.bodies.ground_mass, mass);
        b->mechanism.bodies.ground_moment = vector_add(g, b->mechanism.bodies.ground_moment, moment);
        return;
    }
    segment *to = &b->mechanism.segments[from->parent];
    const tensor shifted = tensor_shift(g, tensor_rotate(g, from->turn, inertia), mass, turned, from->offset);
    to->own.inertia = tensor_add(g, to->own.inertia, shifted);
    to->own.ms = vector_add(g, to->own.ms, moment);
    to->own.mass = add(g, to->own.mass, mass);
}

/* Inertial parameters that a joint's motion does not change can be moved to the parent (Gautier and Khalil 1990,
 * "Direct calculation of minimum set of inertial parameters of serial robots", IEEE Trans. Robotics Automation 6(3)):
 * of a revolute joint the mass, the first moment along the axis and equal moments of inertia across it; of a prismatic
 * joint the whole inertia; of a spherical joint the mass. The equations of motion are the same, and most parameters of
 * each segment are zero. */
void regroup(builder *b)
{
    graph *g = b->g;
    const node zero = constant(g, 0.0);
    for (int i = b->mechanism.segment_count - 1; i >= 0; i--) {
        segment *l = &b->mechanism.segments[i];
        if (l->lead != 0.0) {
            continue; /* a screw moves all of them */
        }
        if (l->kind == JOINT_PRISMATIC) {
            move_to_parent(b, l, zero, vector_zero(g), l->own.inertia);
            l->own.inertia = tensor_zero(g);
            continue;
        }
        if (l->kind == JOINT_SPHERICAL) {
            move_to_parent(b, l, l->own.mass, vector_zero(g), tensor_zero(g));
            l->own.mass = zero;
            continue;
        }
        node *const diagonal[3] = {&l->own.inertia.xx, &l->own.inertia.yy, &l->own.inertia.zz};
        node *const one = diagonal[(l->axis + 1) % 3], *const other = diagonal[(l->axis + 2) % 3];
        const node across = *other;
        tensor ring = {across, across, across, zero, zero, zero};
        node *const of_ring[3] = {&ring.xx, &ring.yy, &ring.zz};
        *of_ring[l->axis] = zero;
        vector along = vector_zero(g);
        along.at[l->axis] = l->own.ms.at[l->axis];

        move_to_parent(b, l, l->own.mass, along, ring);
        *one = sub(g, *one, across);
        *other = zero;
        l->own.ms.at[l->axis] = zero;
        l->own.mass = zero;
    }
}
