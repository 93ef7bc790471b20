#include "tools/isoc/closure/closure.h"

#include <string.h>

/* The rotation from a segment's axes to its parent's. */
static matrix joint_turn(const kinematics *k, int i)
{
    matrix result;
    for (int j = 0; j < 3; j++) {
        const vector e = to_parent(k, i, vector_of(k->g, j == 0, j == 1, j == 2));
        for (int n = 0; n < 3; n++) {
            result.at[n][j] = e.at[n];
        }
    }
    return result;
}

static void turn_outward(const kinematics *k, int i, int base, matrix *turns)
{
    if (i != base) {
        const int parent = k->m->segments[i].parent;
        turn_outward(k, parent, base, turns);
        turns[i + 1] = matrix_product(k->g, turns[parent + 1], joint_turn(k, i));
    }
}

const matrix *loop_turns(const kinematics *k, const closure *c, closure_axes chosen)
{
    matrix *turns = arena_take(k->g->memory, (size_t)k->m->segment_count + 1, sizeof *turns);
    const int last = chosen == AXES_OF_PARENT  ? c->parent.segment
                     : chosen == AXES_OF_CHILD ? c->child.segment
                                               : c->base;
    turns[last + 1] = matrix_identity(k->g);
    for (int i = last; i != c->base; i = k->m->segments[i].parent) {
        const matrix back = matrix_transpose(joint_turn(k, i));
        turns[k->m->segments[i].parent + 1] = matrix_product(k->g, turns[i + 1], back);
    }
    if (chosen != AXES_OF_PARENT) {
        turn_outward(k, c->parent.segment, c->base, turns);
    }
    if (chosen != AXES_OF_CHILD) {
        turn_outward(k, c->child.segment, c->base, turns);
    }
    return turns;
}

static bool same(vector a, vector b)
{
    return memcmp(a.at, b.at, sizeof a.at) == 0;
}

/* Adds the displacement `from` on a segment, from its joint to the next one, with its velocity and acceleration by the
 * segment's motion. These are computed in the segment's axes, as the dynamics does; or after the rotation, where it
 * does not change the angular velocity, as in a plane: there the rotated displacement is shared with the Jacobian. */
static void add_way(const kinematics *k, const acceleration *all, int i, bool moves, vector from, matrix rotation,
                    side *to)
{
    graph *g = k->g;
    const vector displacement = matrix_apply(g, rotation, from), zero = vector_zero(g);
    to->point = vector_add(g, to->point, displacement);
    if (i == GROUND) {
        return;
    }
    const vector omega = k->motions[i].omega, alpha = all[i].alpha;
    const vector slid = moves ? slide_of(k, i, k->motions[i].rate) : zero;
    const vector coriolis = moves ? joint_coriolis(k, i).a : zero;
    vector rate, bias;
    if (same(matrix_apply(g, rotation, omega), omega) && same(matrix_apply(g, rotation, alpha), alpha)) {
        const vector own_rate = matrix_apply(g, rotation, slid);
        rate = vector_add(g, vector_cross(g, omega, displacement), own_rate);
        const vector own_bias = matrix_apply(g, rotation, coriolis);
        bias = vector_add(g, swing(g, omega, alpha, displacement), own_bias);
    } else {
        rate = matrix_apply(g, rotation, vector_add(g, vector_cross(g, omega, from), slid));
        bias = matrix_apply(g, rotation, vector_add(g, swing(g, omega, alpha, from), coriolis));
    }
    to->velocity = vector_add(g, to->velocity, rate);
    to->acceleration = vector_add(g, to->acceleration, bias);
}

/* Adds the parts of a segment's degrees of freedom in the motion of the end, which is at to->point from the segment's
 * origin on its parent. */
static void add_dofs(const kinematics *k, int i, matrix rotation, side *to)
{
    graph *g = k->g;
    const segment *l = &k->m->segments[i];
    for (int f = l->dof; f < l->dof + dofs_of(l->kind); f++) {
        const vector e = matrix_apply(g, rotation, axis_of(k, f));
        to->angular[f] = turn_of(k, i, e);
        const vector slid = slide_of(k, i, e);
        to->linear[f] = slides(l) ? e : vector_add(g, vector_cross(g, e, to->point), slid);
    }
}

side side_build(const kinematics *k, const acceleration *all, const closure_end *end, int base, const matrix *turns)
{
    graph *g = k->g;
    const mechanism *m = k->m;
    const vector zero = vector_zero(g);
    const matrix last = turns[end->segment + 1];
    side result = {.point = zero, .velocity = zero, .acceleration = zero, .omega = zero, .alpha = zero};
    result.linear = arena_take(g->memory, (size_t)m->dof_count, sizeof *result.linear);
    result.angular = arena_take(g->memory, (size_t)m->dof_count, sizeof *result.angular);
    for (int f = 0; f < m->dof_count; f++) {
        result.linear[f] = result.angular[f] = zero;
    }
    vector from = end->point;
    for (int i = end->segment; i != base; i = m->segments[i].parent) {
        add_way(k, all, i, true, from, turns[i + 1], &result);
        add_dofs(k, i, turns[i + 1], &result);
        from = k->motions[i].p;
    }
    add_way(k, all, base, false, from, turns[base + 1], &result);
    if (end->segment != GROUND) {
        result.omega = matrix_apply(g, last, k->motions[end->segment].omega);
        result.alpha = matrix_apply(g, last, all[end->segment].alpha);
    }
    result.axes = matrix_product(g, last, end->turn);
    return result;
}
