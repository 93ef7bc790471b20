#include "tools/isoc/dynamics.h"

/* A force on a link and its moment about the link's origin. */
typedef struct wrench {
    vector force, moment;
} wrench;

static bool slides(const link *l)
{
    return l->kind == JOINT_PRISMATIC;
}

static vector axis_of(graph *g, const link *l, node size)
{
    vector a = vector_zero(g);
    a.at[l->axis] = mul(g, constant(g, l->sign), size);
    return a;
}

/* R = turn * (turn about the axis). One full matrix where both are needed at once, else two sparse ones. */
vector to_parent(const dynamics *d, int i, vector a)
{
    const link *l = &d->m->links[i];
    const motion *k = &d->motions[i];
    return matrix_apply(d->g, l->turn, turn_out(d->g, l->axis, k->s, k->c, a));
}

vector from_parent(const dynamics *d, int i, vector a)
{
    const link *l = &d->m->links[i];
    const motion *k = &d->motions[i];
    return turn_in(d->g, l->axis, k->s, k->c, matrix_apply(d->g, matrix_transpose(l->turn), a));
}

/* --- outward: coordinates and velocities --- */

static void start_motion(dynamics *d, int i)
{
    graph *g = d->g;
    const link *l = &d->m->links[i];
    motion *k = &d->motions[i];
    k->q = leaf(g, OP_STATE, i);
    k->qd = leaf(g, OP_STATE, d->m->link_count + i);
    k->rate = mul(g, constant(g, l->sign), k->qd);
    k->s = constant(g, 0.0);
    k->c = constant(g, 1.0);
    k->p = l->offset;
    if (slides(l)) {
        const vector travel = matrix_apply(g, l->turn, axis_of(g, l, k->q));
        k->p = vector_name(g, vector_add(g, l->offset, travel), "p", l->name);
    } else {
        k->s = mul(g, constant(g, l->sign), graph_name(g, sine(g, k->q), "sin_%s", l->name));
        k->c = graph_name(g, cosine(g, k->q), "cos_%s", l->name);
    }
}

/* omega_i = R' omega_parent + e q' */
static void rotate_outward(dynamics *d, int i)
{
    graph *g = d->g;
    const link *l = &d->m->links[i];
    motion *k = &d->motions[i];
    k->omega = l->parent == GROUND ? vector_zero(g) : from_parent(d, i, d->motions[l->parent].omega);
    if (!slides(l)) {
        k->omega = vector_add(g, k->omega, axis_of(g, l, k->qd));
    }
    vector_name(g, k->omega, "omega", l->name);
}

/* a x r + w x (w x r), with the squares and products of w shared by all points of a link. */
static vector swing(graph *g, vector w, vector alpha, vector r)
{
    vector result = vector_cross(g, alpha, r);
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const node squares = add(g, mul(g, w.at[j], w.at[j]), mul(g, w.at[k], w.at[k]));
        const node across =
            add(g, mul(g, mul(g, w.at[i], w.at[j]), r.at[j]), mul(g, mul(g, w.at[i], w.at[k]), r.at[k]));
        result.at[i] = add(g, result.at[i], sub(g, across, mul(g, squares, r.at[i])));
    }
    return result;
}

/* --- bias: recursive Newton-Euler with q'' = 0, the ground accelerated by -gravity --- */

typedef struct acceleration {
    vector alpha, a; /* angular; of the origin */
} acceleration;

static acceleration accelerate_outward(const dynamics *d, int i, const acceleration *all)
{
    graph *g = d->g;
    const link *l = &d->m->links[i];
    const motion *k = &d->motions[i];
    vector alpha = vector_zero(g), origin = vector_sub(g, vector_zero(g), d->m->gravity);
    if (l->parent != GROUND) {
        const acceleration *parent = &all[l->parent];
        alpha = from_parent(d, i, parent->alpha);
        origin = vector_add(g, parent->a, swing(g, d->motions[l->parent].omega, parent->alpha, k->p));
    }
    acceleration made = {alpha, from_parent(d, i, origin)};
    const vector along = axis_of(g, l, k->qd);
    if (slides(l)) {
        /* Coriolis: 2 omega x e q'. */
        made.a = vector_add(g, made.a, vector_scale(g, constant(g, 2.0), vector_cross(g, k->omega, along)));
    } else {
        made.alpha = vector_add(g, made.alpha, vector_cross(g, k->omega, along));
    }
    vector_name(g, made.alpha, "alpha", l->name);
    vector_name(g, made.a, "a", l->name);
    return made;
}

/* Newton and Euler about the link's origin: F = m a + swing(ms), N = J alpha + omega x J omega + ms x a. */
static wrench inertial_wrench(const dynamics *d, int i, acceleration now)
{
    graph *g = d->g;
    const link *l = &d->m->links[i];
    const vector w = d->motions[i].omega;
    wrench made;
    made.force = vector_add(g, vector_scale(g, l->mass, now.a), swing(g, w, now.alpha, l->first_moment));
    const vector gyroscopic = vector_cross(g, w, tensor_apply(g, l->inertia, w));
    const vector angular = vector_add(g, tensor_apply(g, l->inertia, now.alpha), gyroscopic);
    made.moment = vector_add(g, angular, vector_cross(g, l->first_moment, now.a));
    return made;
}

static wrench wrench_to_parent(const dynamics *d, int i, wrench w)
{
    wrench made;
    made.force = to_parent(d, i, w.force);
    made.moment = vector_add(d->g, to_parent(d, i, w.moment), vector_cross(d->g, d->motions[i].p, made.force));
    return made;
}

/* The part of a wrench that a joint's effort bears. */
static node along_axis(graph *g, const link *l, wrench w)
{
    return mul(g, constant(g, l->sign), slides(l) ? w.force.at[l->axis] : w.moment.at[l->axis]);
}

static void build_bias(const dynamics *d, node *bias)
{
    graph *g = d->g;
    const int n = d->m->link_count;
    acceleration *all = arena_take(g->memory, (size_t)n, sizeof *all);
    wrench *wrenches = arena_take(g->memory, (size_t)n, sizeof *wrenches);
    graph_section(g, "Accelerations outward, at q'' = 0 and with the ground accelerated by -gravity (Newton-Euler)");
    for (int i = 0; i < n; i++) {
        all[i] = accelerate_outward(d, i, all);
    }
    graph_section(g, "Forces and moments inward: what q'' = 0 would take (bias)");
    for (int i = 0; i < n; i++) {
        wrenches[i] = inertial_wrench(d, i, all[i]);
    }
    for (int i = n - 1; i >= 0; i--) {
        const link *l = &d->m->links[i];
        vector_name(g, wrenches[i].force, "force", l->name);
        vector_name(g, wrenches[i].moment, "moment", l->name);
        bias[i] = graph_name(g, along_axis(g, l, wrenches[i]), "bias_%s", l->name);
        if (l->parent != GROUND) {
            const wrench w = wrench_to_parent(d, i, wrenches[i]);
            wrench *parent = &wrenches[l->parent];
            parent->force = vector_add(g, parent->force, w.force);
            parent->moment = vector_add(g, parent->moment, w.moment);
        }
    }
}

/* --- mass matrix: composite bodies --- */

/* A link with all that hangs on it, seen as one rigid body. */
typedef struct composite {
    node mass;
    vector ms;
    tensor inertia;
} composite;

/* Row i of the mass matrix: the efforts that a unit acceleration of joint i takes at i and at its ancestors. The
 * wrench is made after the joint's own turn, which its axis does not feel. */
static void build_row(const dynamics *d, int i, composite turned, node *row)
{
    graph *g = d->g;
    const link *l = &d->m->links[i];
    const vector e = axis_of(g, l, constant(g, 1.0));
    wrench w;
    if (slides(l)) {
        w.force = vector_scale(g, turned.mass, e);
        w.moment = vector_cross(g, turned.ms, e);
    } else {
        w.force = vector_cross(g, e, turned.ms);
        w.moment = tensor_apply(g, turned.inertia, e);
    }
    row[i] = graph_name(g, along_axis(g, l, w), "M_%s", l->name);
    w.force = matrix_apply(g, l->turn, w.force);
    w.moment = vector_add(g, matrix_apply(g, l->turn, w.moment), vector_cross(g, d->motions[i].p, w.force));
    for (int j = l->parent; j != GROUND; j = d->m->links[j].parent) {
        row[j] = graph_name(g, along_axis(g, &d->m->links[j], w), "M_%s_%s", l->name, d->m->links[j].name);
        if (d->m->links[j].parent != GROUND) {
            w = wrench_to_parent(d, j, w);
        }
    }
}

/* What a composite body adds to its parent, from the joint's own turned frame. */
static void join(const dynamics *d, int i, composite turned, composite *parent)
{
    graph *g = d->g;
    const link *l = &d->m->links[i];
    const vector p = d->motions[i].p;
    const vector ms = matrix_apply(g, l->turn, turned.ms);
    const tensor inertia = tensor_shift(g, tensor_rotate(g, l->turn, turned.inertia), turned.mass, ms, p);
    parent->mass = add(g, parent->mass, turned.mass);
    parent->ms = vector_add(g, parent->ms, vector_add(g, ms, vector_scale(g, turned.mass, p)));
    parent->inertia = tensor_add(g, parent->inertia, inertia);
}

static composite *link_composites(const dynamics *d)
{
    composite *bodies = arena_take(d->g->memory, (size_t)d->m->link_count, sizeof *bodies);
    for (int i = 0; i < d->m->link_count; i++) {
        const link *l = &d->m->links[i];
        bodies[i] = (composite){l->mass, l->first_moment, l->inertia};
    }
    return bodies;
}

static composite turn_composite(const dynamics *d, int i, composite whole)
{
    const link *l = &d->m->links[i];
    const motion *k = &d->motions[i];
    return (composite){whole.mass, turn_out(d->g, l->axis, k->s, k->c, whole.ms),
                       tensor_turn_out(d->g, l->axis, k->s, k->c, whole.inertia)};
}

static void build_mass_matrix(const dynamics *d, node *matrix_made)
{
    const int n = d->m->link_count;
    composite *bodies = link_composites(d);
    graph_section(d->g, "Mass matrix M (composite rigid bodies)");
    for (int i = n - 1; i >= 0; i--) {
        const composite turned = turn_composite(d, i, bodies[i]);
        build_row(d, i, turned, matrix_made + i * n);
        if (d->m->links[i].parent != GROUND) {
            join(d, i, turned, &bodies[d->m->links[i].parent]);
        }
    }
}

/* --- q'' = M^-1 (effort - bias) by M = L' D L --- */

/* tau = u - d q' - k (q - rest) - bias */
static void build_efforts(const dynamics *d, const node *bias, node *tau)
{
    graph *g = d->g;
    graph_section(g, "Efforts less bias: drives, damping, springs");
    for (int i = 0; i < d->m->link_count; i++) {
        const link *l = &d->m->links[i];
        node effort = l->drive < 0 ? constant(g, 0.0) : leaf(g, OP_INPUT, l->drive);
        effort = sub(g, effort, mul(g, l->damping, d->motions[i].qd));
        effort = sub(g, effort, mul(g, l->spring, sub(g, d->motions[i].q, l->rest)));
        tau[i] = graph_name(g, sub(g, effort, bias[i]), "tau_%s", l->name);
    }
}

/* Featherstone (2008), table 6.3: from the tips to the root, each row is divided by its pivot and taken out of its
 * ancestors' rows. On return row i holds L_ij for the ancestors j, inverse[i] = 1 / D_i. */
static void factorise(const dynamics *d, node *m, node *inverse)
{
    graph *g = d->g;
    const int n = d->m->link_count;
    graph_section(g, "Factorisation M = L' D L");
    for (int i = n - 1; i >= 0; i--) {
        const link *l = &d->m->links[i];
        d->pivots[i] = graph_name(g, m[i * n + i], "D_%s", l->name);
        inverse[i] = divide(g, constant(g, 1.0), d->pivots[i]);
        if (l->parent != GROUND) {
            graph_name(g, inverse[i], "inverse_D_%s", l->name);
        }
        for (int j = l->parent; j != GROUND; j = d->m->links[j].parent) {
            const node factor = mul(g, m[i * n + j], inverse[i]);
            graph_name(g, factor, "L_%s_%s", l->name, d->m->links[j].name);
            for (int k = j; k != GROUND; k = d->m->links[k].parent) {
                m[j * n + k] = sub(g, m[j * n + k], mul(g, factor, m[i * n + k]));
            }
            m[i * n + j] = factor;
        }
    }
}

static void solve(const dynamics *d, const node *m, const node *inverse, node *x)
{
    graph *g = d->g;
    const int n = d->m->link_count;
    graph_section(g, "Accelerations q'' = L^-1 D^-1 L'^-1 (effort - bias)");
    for (int i = n - 1; i >= 0; i--) {
        for (int j = d->m->links[i].parent; j != GROUND; j = d->m->links[j].parent) {
            x[j] = sub(g, x[j], mul(g, m[i * n + j], x[i]));
        }
        x[i] = d->m->links[i].parent == GROUND ? divide(g, x[i], d->pivots[i]) : mul(g, x[i], inverse[i]);
    }
    for (int i = 0; i < n; i++) {
        for (int j = d->m->links[i].parent; j != GROUND; j = d->m->links[j].parent) {
            x[i] = sub(g, x[i], mul(g, m[i * n + j], x[j]));
        }
        graph_name(g, x[i], "qdd_%s", d->m->links[i].name);
    }
}

dynamics dynamics_build(graph *g, const mechanism *m)
{
    const size_t n = (size_t)m->link_count;
    dynamics d = {.m = m, .g = g, .motions = arena_take(g->memory, n, sizeof *d.motions)};
    d.acceleration = arena_take(g->memory, n, sizeof *d.acceleration);
    d.pivots = arena_take(g->memory, n, sizeof *d.pivots);
    d.inertias = arena_take(g->memory, n, sizeof *d.inertias);
    node *bias = arena_take(g->memory, n, sizeof *bias), *inverse = arena_take(g->memory, n, sizeof *inverse);
    node *mass_matrix = arena_take(g->memory, n * n, sizeof *mass_matrix);

    graph_section(g, "Joints: sines and cosines, places");
    for (int i = 0; i < m->link_count; i++) {
        start_motion(&d, i);
    }
    graph_section(g, "Angular velocities outward, in link axes");
    for (int i = 0; i < m->link_count; i++) {
        rotate_outward(&d, i);
    }
    build_bias(&d, bias);
    build_efforts(&d, bias, d.acceleration);
    build_mass_matrix(&d, mass_matrix);
    for (size_t i = 0; i < n; i++) {
        d.inertias[i] = mass_matrix[i * n + i];
    }
    factorise(&d, mass_matrix, inverse);
    solve(&d, mass_matrix, inverse, d.acceleration);
    return d;
}

/* --- for outputs --- */

void dynamics_velocities(dynamics *d)
{
    graph *g = d->g;
    graph_section(g, "Velocities outward, in link axes");
    for (int i = 0; i < d->m->link_count; i++) {
        const link *l = &d->m->links[i];
        motion *k = &d->motions[i];
        k->v = vector_zero(g);
        if (l->parent != GROUND) {
            const motion *parent = &d->motions[l->parent];
            k->v = from_parent(d, i, vector_add(g, parent->v, vector_cross(g, parent->omega, k->p)));
        }
        if (slides(l)) {
            k->v = vector_add(g, k->v, axis_of(g, l, k->qd));
        }
        vector_name(g, k->v, "v", l->name);
    }
}

vector point_position(const dynamics *d, int i, vector point)
{
    for (; i != GROUND; i = d->m->links[i].parent) {
        point = vector_add(d->g, to_parent(d, i, point), d->motions[i].p);
    }
    return point;
}

vector point_velocity(const dynamics *d, int i, vector point)
{
    if (i == GROUND) {
        return vector_zero(d->g);
    }
    vector v = vector_add(d->g, d->motions[i].v, vector_cross(d->g, d->motions[i].omega, point));
    for (; i != GROUND; i = d->m->links[i].parent) {
        v = to_parent(d, i, v);
    }
    return v;
}

node dynamics_energy(const dynamics *d)
{
    graph *g = d->g;
    const node half = constant(g, 0.5);
    graph_section(g, "Energy: kinetic, of gravity, of springs");

    /* T = m v.v / 2 + v.(omega x ms) + omega.J omega / 2, about link origins. */
    node sum = constant(g, 0.0);
    for (int i = 0; i < d->m->link_count; i++) {
        const link *l = &d->m->links[i];
        const motion *k = &d->motions[i];
        const node linear = mul(g, mul(g, half, l->mass), vector_dot(g, k->v, k->v));
        const node mixed = vector_dot(g, k->v, vector_cross(g, k->omega, l->first_moment));
        const node angular = mul(g, half, vector_dot(g, k->omega, tensor_apply(g, l->inertia, k->omega)));
        sum = add(g, sum, add(g, add(g, linear, mixed), angular));
        const node stretch = sub(g, k->q, l->rest);
        sum = add(g, sum, mul(g, mul(g, half, l->spring), mul(g, stretch, stretch)));
    }

    /* V = -g . (the first moment of everything about the ground's origin) */
    composite ground = {d->m->ground_mass, d->m->ground_moment, tensor_zero(g)};
    composite *bodies = link_composites(d);
    for (int i = d->m->link_count - 1; i >= 0; i--) {
        const int parent = d->m->links[i].parent;
        join(d, i, turn_composite(d, i, bodies[i]), parent == GROUND ? &ground : &bodies[parent]);
    }
    return sub(g, sum, vector_dot(g, d->m->gravity, ground.ms));
}
