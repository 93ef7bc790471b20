#include "tools/isoc/tree/tree.h"

bool slides(const segment *l)
{
    return l->kind == JOINT_PRISMATIC;
}

node component_along(const kinematics *k, int f, wrench w)
{
    const segment *l = &k->m->segments[k->m->dofs[f].segment];
    const vector axis = axis_of(k, f);
    const node along = vector_dot(k->g, axis, slides(l) ? w.force : w.moment);
    return l->lead == 0.0 ? along
                          : add(k->g, along, vector_dot(k->g, slide_of(k, k->m->dofs[f].segment, axis), w.force));
}

vector slide_of(const kinematics *k, int i, vector moved)
{
    const segment *l = &k->m->segments[i];
    return slides(l) ? moved : l->lead == 0.0 ? vector_zero(k->g) : vector_scale(k->g, constant(k->g, l->lead), moved);
}

vector turn_of(const kinematics *k, int i, vector moved)
{
    return slides(&k->m->segments[i]) ? vector_zero(k->g) : moved;
}

int shared_axis(const kinematics *k, int i)
{
    const segment *l = &k->m->segments[i];
    const segment *parent = l->parent == GROUND ? l : &k->m->segments[l->parent];
    if (!k->absolute || parent == l || l->kind != JOINT_REVOLUTE || parent->kind != JOINT_REVOLUTE || l->lead != 0.0 ||
        parent->lead != 0.0) {
        return 0;
    }
    const double along = l->sign * parent->sign * constant_value(k->g, l->turn.at[parent->axis][l->axis]);
    return along == 1.0 ? 1 : along == -1.0 ? -1 : 0;
}

vector axis_of(const kinematics *k, int f)
{
    vector a = vector_zero(k->g);
    const segment *l = &k->m->segments[k->m->dofs[f].segment];
    a.at[k->m->dofs[f].axis] = constant(k->g, l->kind == JOINT_SPHERICAL ? 1.0 : l->sign);
    return a;
}

vector unturn(const kinematics *k, int i, vector a)
{
    const segment *l = &k->m->segments[i];
    const motion *now = &k->motions[i];
    return l->kind == JOINT_SPHERICAL ? matrix_apply(k->g, now->free_turn, a)
                                      : turn_out(k->g, l->axis, now->s, now->c, a);
}

matrix unturn_matrix(const kinematics *k, int i, matrix a)
{
    const segment *l = &k->m->segments[i];
    const motion *now = &k->motions[i];
    return l->kind == JOINT_SPHERICAL ? matrix_rotate(k->g, now->free_turn, a)
                                      : matrix_turn_out(k->g, l->axis, now->s, now->c, a);
}

/* R = turn * (rotation of the joint). One full matrix where both are needed at once, else two sparse ones. */
vector to_parent(const kinematics *k, int i, vector a)
{
    return matrix_apply(k->g, k->m->segments[i].turn, unturn(k, i, a));
}

vector from_parent(const kinematics *k, int i, vector a)
{
    const segment *l = &k->m->segments[i];
    const motion *now = &k->motions[i];
    const vector unturned = matrix_apply(k->g, matrix_transpose(l->turn), a);
    return l->kind == JOINT_SPHERICAL ? matrix_apply(k->g, matrix_transpose(now->free_turn), unturned)
                                      : turn_in(k->g, l->axis, now->s, now->c, unturned);
}

/* Whether an implicit method differentiates products of R and R', which are one where |q| is: from the parent's axes to
 * the segment's and back. The solved equations and the balance differ in them (tools/isoc/implicit/jacobian.h), and a
 * Jacobian of the one in the place of the other's takes an order from a linearly implicit method. */
static bool is_turned_back(const mechanism *m, const segment *l)
{
    return ISO_IS_IMPLICIT(m->method.recipe) && l->parent != GROUND;
}

static void start_motion(const kinematics *k, int i)
{
    graph *g = k->g;
    const mechanism *m = k->m;
    const segment *l = &m->segments[i];
    motion *now = &k->motions[i];
    now->s = constant(g, 0.0);
    now->c = constant(g, 1.0);
    now->p = l->offset;
    now->rate = vector_zero(g);
    for (int n = 0; n < positions_of(l->kind); n++) {
        now->q[n] = leaf(g, OP_STATE, l->position + n);
    }
    for (int n = 0; n < dofs_of(l->kind); n++) {
        now->qd[n] = leaf(g, OP_STATE, m->position_count + l->dof + n);
        now->rate = vector_add(g, now->rate, vector_scale(g, now->qd[n], axis_of(k, l->dof + n)));
    }
    if (l->kind == JOINT_SPHERICAL) {
        now->free_turn = is_turned_back(m, l) ? quaternion_matrix_of_any(g, now->q) : quaternion_matrix(g, now->q);
        for (int n = 0; n < 9; n++) {
            graph_name(g, now->free_turn.at[n / 3][n % 3], "R_%s_%d%d", l->name, n / 3 + 1, n % 3 + 1);
        }
        return;
    }
    if (slides(l) || l->lead != 0.0) {
        const vector along = slide_of(k, i, vector_scale(g, now->q[0], axis_of(k, l->dof)));
        now->p = vector_name(g, vector_add(g, l->offset, matrix_apply(g, l->turn, along)), "p", l->name);
    }
    if (!slides(l)) {
        const node s = graph_name(g, sine(g, now->q[0]), "sin_%s", l->name);
        now->s = mul(g, constant(g, l->sign), s);
        now->c = graph_name(g, cosine(g, now->q[0]), "cos_%s", l->name);
    }
}

/* omega_i = R' omega_parent + e q' */
static void rotate_outward(const kinematics *k, int i)
{
    graph *g = k->g;
    const segment *l = &k->m->segments[i];
    motion *now = &k->motions[i];
    now->carried = l->parent == GROUND ? vector_zero(g) : from_parent(k, i, k->motions[l->parent].omega);
    now->omega = slides(l) ? now->carried : vector_add(g, now->carried, now->rate);
    vector_name(g, now->omega, "omega", l->name);
}

kinematics kinematics_build(graph *g, const mechanism *m)
{
    kinematics k = {.m = m, .g = g, .motions = arena_take(g->memory, (size_t)m->segment_count, sizeof *k.motions)};
    graph_section(g, "Joints: sines and cosines, places");
    for (int i = 0; i < m->segment_count; i++) {
        start_motion(&k, i);
    }
    graph_section(g, "Angular velocities outward, in link axes");
    for (int i = 0; i < m->segment_count; i++) {
        rotate_outward(&k, i);
    }
    return k;
}

void kinematics_velocities(const kinematics *k)
{
    graph *g = k->g;
    graph_section(g, "Velocities outward, in link axes");
    for (int i = 0; i < k->m->segment_count; i++) {
        const segment *l = &k->m->segments[i];
        motion *now = &k->motions[i];
        now->v = l->parent == GROUND ? vector_zero(g) : from_parent(k, i, point_velocity(k, l->parent, now->p));
        if (slides(l) || l->lead != 0.0) {
            now->v = vector_add(g, now->v, slide_of(k, i, now->rate));
        }
        vector_name(g, now->v, "v", l->name);
    }
}

vector outward_axes(const kinematics *k, int i, int to, vector a)
{
    for (; i != to; i = k->m->segments[i].parent) {
        a = to_parent(k, i, a);
    }
    return a;
}

vector axes_of_body(const kinematics *k, const body_frame *frame, bool in_body, vector a)
{
    return in_body ? matrix_apply(k->g, matrix_transpose(frame->turn), a) : outward_axes(k, frame->segment, GROUND, a);
}

vector inward_axes(const kinematics *k, int from, int i, vector a)
{
    return i == from ? a : from_parent(k, i, inward_axes(k, from, k->m->segments[i].parent, a));
}

vector outward_point(const kinematics *k, int i, int to, vector point)
{
    for (; i != to; i = k->m->segments[i].parent) {
        point = vector_add(k->g, to_parent(k, i, point), k->motions[i].p);
    }
    return point;
}

vector point_velocity(const kinematics *k, int i, vector point)
{
    if (i == GROUND) {
        return vector_zero(k->g);
    }
    return vector_add(k->g, k->motions[i].v, vector_cross(k->g, k->motions[i].omega, point));
}

vector swing(graph *g, vector w, vector alpha, vector r)
{
    vector result = vector_cross(g, alpha, r);
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const node square_j = mul(g, w.at[j], w.at[j]), square_k = mul(g, w.at[k], w.at[k]);
        const node squares = add(g, square_j, square_k);
        const node product_j = mul(g, mul(g, w.at[i], w.at[j]), r.at[j]);
        const node product_k = mul(g, mul(g, w.at[i], w.at[k]), r.at[k]);
        const node across = add(g, product_j, product_k);
        const node inward = mul(g, squares, r.at[i]);
        result.at[i] = add(g, result.at[i], sub(g, across, inward));
    }
    return result;
}

void position_rates(const kinematics *k, int i, node *rates)
{
    graph *g = k->g;
    const motion *now = &k->motions[i];
    if (k->m->segments[i].kind != JOINT_SPHERICAL) {
        rates[0] = now->qd[0];
        return;
    }
    quaternion_rates(g, now->q, now->qd, rates);
}

/* The quaternion of the rotation of a segment's joint. */
static void joint_quaternion(const kinematics *k, int i, node q[4])
{
    graph *g = k->g;
    const segment *l = &k->m->segments[i];
    const motion *now = &k->motions[i];
    for (int n = 0; n < 4; n++) {
        q[n] = l->kind == JOINT_SPHERICAL ? now->q[n] : constant(g, n == 0 ? 1.0 : 0.0);
    }
    if (l->kind == JOINT_REVOLUTE) {
        const node half = mul(g, constant(g, 0.5 * l->sign), now->q[0]);
        q[0] = cosine(g, half);
        q[1 + l->axis] = sine(g, half);
    }
}

void body_orientation(const kinematics *k, const body_frame *frame, node q[4])
{
    quaternion_of_constant(k->g, frame->turn, q);
    for (int i = frame->segment; i != GROUND; i = k->m->segments[i].parent) {
        node turned[4], fixed[4];
        joint_quaternion(k, i, turned);
        quaternion_product(k->g, turned, q, q);
        quaternion_of_constant(k->g, k->m->segments[i].turn, fixed);
        quaternion_product(k->g, fixed, q, q);
    }
}
