#include "tools/isoc/closure/closure.h"

#include <math.h>

typedef struct pair {
    const kinematics *k;
    const closure *c;
    int index;
    const matrix *turns; /* of the loop's segments, to the axes that all of this stands in */
    side parent, child;
    vector apart, apart_rate, apart_bias; /* from the parent's point to the child's */
    vector spin, spin_bias;               /* of the child against the parent */
} pair;

static pair build_pair(const kinematics *k, const acceleration *all, int index, closure_axes axes)
{
    graph *g = k->g;
    const closure *c = &k->m->closures[index];
    pair result = {.k = k, .c = c, .index = index, .turns = loop_turns(k, c, axes)};
    result.parent = side_build(k, all, &c->parent, c->base, result.turns);
    result.child = side_build(k, all, &c->child, c->base, result.turns);
    result.apart = vector_sub(g, result.child.point, result.parent.point);
    result.apart_rate = vector_sub(g, result.child.velocity, result.parent.velocity);
    result.apart_bias = vector_sub(g, result.child.acceleration, result.parent.acceleration);
    result.spin = vector_sub(g, result.child.omega, result.parent.omega);
    result.spin_bias = vector_sub(g, result.child.alpha, result.parent.alpha);
    return result;
}

/* The force of a multiplier of one on the child along `a`, in base axes. */
static vector minus_in_base(const pair *p, vector a)
{
    graph *g = p->k->g;
    const vector in_base = matrix_apply(g, matrix_transpose(p->turns[p->c->base + 1]), a);
    return vector_scale(g, constant(g, -1.0), in_base);
}

/* Adds a constraint; one without an entry is dropped. */
static void put(const kinematics *k, constraints *to, constraint result, const char *called)
{
    graph *g = k->g;
    const mechanism *m = k->m;
    node rate = result.rate;
    bool entries = false;
    for (int f = 0; f < m->dof_count; f++) {
        graph_name(g, result.row[f], "Phi_%s_%s", called, m->dofs[f].name);
        rate = add(g, rate, mul(g, result.row[f], leaf(g, OP_STATE, m->position_count + f)));
        entries = entries || !is_zero(g, result.row[f]);
    }
    if (!entries) {
        to->dropped[to->dropped_count++] = result;
        return;
    }
    result.rate = graph_name(g, rate, "rate_%s", called);
    graph_name(g, result.position, "Phi_%s", called);
    graph_name(g, result.bias, "Phi_dd_%s", called);
    to->all[to->count++] = result;
}

static constraint blank(const kinematics *k, int index)
{
    graph *g = k->g;
    const node zero = constant(g, 0.0);
    constraint result = {.closure = index, .position = zero, .rate = zero, .bias = zero};
    result.row = zero_nodes(g, (size_t)k->m->dof_count);
    result.force = result.moment = vector_zero(g);
    return result;
}

static const char *part_name(const pair *p, const char *part)
{
    return arena_format(p->k->g->memory, "%s_%s", p->c->name, part);
}

/* Phi = d . r - length for the displacement r between the points and a direction d that moves with the parent, which
 * turns with omega_A: Phi' = d . r' + omega_A . (d x r), Phi'' = d . r'' + 2 (omega_A x d) . r' + (alpha_A x d +
 * omega_A x (omega_A x d)) . r. With the points together, or d resting, only the first terms stay. */
static void hold_along(const pair *p, constraints *to, vector d, node length, bool turns, const char *called)
{
    const kinematics *k = p->k;
    graph *g = k->g;
    constraint result = blank(k, p->index);
    const vector arm = vector_cross(g, d, p->apart), zero = vector_zero(g);
    result.position = sub(g, vector_dot(g, d, p->apart), length);
    for (int f = 0; f < k->m->dof_count; f++) {
        result.row[f] = vector_dot(g, d, vector_sub(g, p->child.linear[f], p->parent.linear[f]));
        result.row[f] = add(g, result.row[f], vector_dot(g, turns ? arm : zero, p->parent.angular[f]));
    }
    result.bias = vector_dot(g, d, p->apart_bias);
    if (turns) {
        const vector turned = vector_cross(g, p->parent.omega, d);
        const node coriolis = vector_dot(g, vector_scale(g, constant(g, 2.0), turned), p->apart_rate);
        const node carried = vector_dot(g, swing(g, p->parent.omega, p->parent.alpha, d), p->apart);
        result.bias = add(g, result.bias, add(g, coriolis, carried));
    }
    result.force = minus_in_base(p, d);
    put(k, to, result, called);
}

/* Phi = u . w for an axis u of the parent and w of the child: Phi' = (omega_B - omega_A) . c with c = w x u. */
static void hold_across(const pair *p, constraints *to, vector u, vector w, const char *called)
{
    const kinematics *k = p->k;
    graph *g = k->g;
    constraint result = blank(k, p->index);
    const vector c = vector_cross(g, w, u);
    result.position = vector_dot(g, u, w);
    for (int f = 0; f < k->m->dof_count; f++) {
        result.row[f] = vector_dot(g, c, vector_sub(g, p->child.angular[f], p->parent.angular[f]));
    }
    const vector w_rate = vector_cross(g, p->child.omega, w), u_rate = vector_cross(g, p->parent.omega, u);
    const vector from_w = vector_cross(g, w_rate, u), from_u = vector_cross(g, w, u_rate);
    const node turning = vector_dot(g, p->spin, vector_add(g, from_w, from_u));
    result.bias = add(g, vector_dot(g, p->spin_bias, c), turning);
    result.moment = minus_in_base(p, c);
    put(k, to, result, called);
}

/* The distance between the points at the start. */
static node distance_at_start(const pair *p)
{
    graph *g = p->k->g;
    const double *numbers = numbers_at_start(g, p->k->m);
    note_built_in(g, p->k->m, p->apart.at, 3);
    double square = 0.0;
    for (int i = 0; i < 3; i++) {
        square += numbers[p->apart.at[i]] * numbers[p->apart.at[i]];
    }
    return constant(g, sqrt(square));
}

/* Phi = (|r|^2 - length^2) / (2 length), in metres. */
static void hold_distance(const pair *p, constraints *to)
{
    const kinematics *k = p->k;
    graph *g = k->g;
    constraint result = blank(k, p->index);
    const node length = is_zero(g, p->c->length) ? distance_at_start(p) : p->c->length;
    const vector d = vector_scale(g, divide(g, constant(g, 1.0), length), p->apart);
    const node half = constant(g, 0.5);
    result.length = length;
    result.position = mul(g, half, sub(g, vector_dot(g, d, p->apart), length));
    for (int f = 0; f < k->m->dof_count; f++) {
        result.row[f] = vector_dot(g, d, vector_sub(g, p->child.linear[f], p->parent.linear[f]));
    }
    const node square = divide(g, vector_dot(g, p->apart_rate, p->apart_rate), length);
    result.bias = add(g, vector_dot(g, d, p->apart_bias), square);
    result.force = minus_in_base(p, d);
    put(k, to, result, p->c->name);
}

/* The point where a rolling body touches the plane across n: the vector to it from the body's centre, and its rate. */
typedef struct contact {
    vector displacement, rate;
} contact;

/* A disc that rolls: its axle w, gamma = n . w, the height z of its centre, and their rates; with s = |n x w| the
 * height is radius s. */
typedef struct disc {
    vector w, w_rate;
    node radius, gamma, gamma_rate, z, z_rate;
} disc;

static disc disc_of(const pair *p, vector n)
{
    graph *g = p->k->g;
    disc result = {.w = matrix_apply(g, p->turns[p->c->child.segment + 1], p->c->wheel), .radius = p->c->length};
    result.w_rate = vector_cross(g, p->child.omega, result.w);
    result.gamma = vector_dot(g, n, result.w);
    result.gamma_rate = vector_dot(g, n, result.w_rate);
    result.z = vector_dot(g, n, p->apart);
    result.z_rate = vector_dot(g, n, p->apart_rate);
    return result;
}

/* Phi = (z^2 - radius^2 (1 - gamma^2)) / (2 radius), without a root: Phi' = (z z' + radius^2 gamma gamma') / radius
 * with gamma' = omega . (w x n). */
static void hold_disc_height(const pair *p, constraints *to, const disc *d, vector n)
{
    const kinematics *k = p->k;
    graph *g = k->g;
    constraint result = blank(k, p->index);
    const node slope = divide(g, d->z, d->radius), tilt = mul(g, d->radius, d->gamma);
    const vector push = vector_scale(g, slope, n), across = vector_cross(g, d->w, n);
    const vector twist = vector_scale(g, tilt, across);
    const node lying = sub(g, constant(g, 1.0), mul(g, d->gamma, d->gamma));
    const node shortened = mul(g, d->radius, lying);
    result.position = mul(g, constant(g, 0.5), sub(g, mul(g, slope, d->z), shortened));
    result.length = d->z;
    for (int f = 0; f < k->m->dof_count; f++) {
        const node turned = vector_dot(g, twist, p->child.angular[f]);
        result.row[f] = add(g, vector_dot(g, push, p->child.linear[f]), turned);
    }
    const node turning = vector_dot(g, twist, p->child.alpha);
    const node carried = add(g, vector_dot(g, push, p->apart_bias), turning);
    const node swung = mul(g, tilt, vector_dot(g, p->child.omega, vector_cross(g, d->w_rate, n)));
    const node of_tilt = mul(g, d->radius, mul(g, d->gamma_rate, d->gamma_rate));
    const node squares = add(g, divide(g, mul(g, d->z_rate, d->z_rate), d->radius), of_tilt);
    result.bias = add(g, add(g, carried, swung), squares);
    result.force = minus_in_base(p, push);
    result.moment = minus_in_base(p, twist);
    put(k, to, result, part_name(p, "height"));
}

/* The lowest point of a disc, at radius / s (gamma w - n) from its centre; with the height of the centre for radius s.
 */
static contact disc_contact(const pair *p, const disc *d, vector n)
{
    graph *g = p->k->g;
    const node over = divide(g, mul(g, d->radius, d->radius), d->z);
    const node over_rate = neg(g, mul(g, over, divide(g, d->z_rate, d->z)));
    const vector down = vector_sub(g, vector_scale(g, d->gamma, d->w), n);
    const vector turned = vector_scale(g, d->gamma, d->w_rate);
    const vector down_rate = vector_add(g, vector_scale(g, d->gamma_rate, d->w), turned);
    const vector moved = vector_scale(g, over, down_rate);
    const vector rate = vector_add(g, vector_scale(g, over_rate, down), moved);
    return (contact){vector_scale(g, over, down), rate};
}

/* The point of the child that touches the resting plane has no velocity along t. */
static void hold_no_slip(const pair *p, constraints *to, vector t, contact at, const char *called)
{
    const kinematics *k = p->k;
    graph *g = k->g;
    constraint result = blank(k, p->index);
    const vector arm = vector_cross(g, at.displacement, t);
    for (int f = 0; f < k->m->dof_count; f++) {
        const node linear = vector_dot(g, t, p->child.linear[f]);
        result.row[f] = add(g, linear, vector_dot(g, arm, p->child.angular[f]));
    }
    const node carried = vector_dot(g, t, p->apart_bias);
    const node moved = vector_dot(g, p->child.omega, vector_cross(g, at.rate, t));
    result.bias = add(g, add(g, carried, vector_dot(g, arm, p->child.alpha)), moved);
    result.force = minus_in_base(p, t);
    result.moment = minus_in_base(p, arm);
    put(k, to, result, called);
}

/* Phi = q_first - ratio q_second - offset, or q_first - motion(t), less whole turns of continuous joints. A closure
 * that holds in speeds alone has only Phi'. */
static void hold_joints(const kinematics *k, constraints *to, int index)
{
    graph *g = k->g;
    const closure *c = &k->m->closures[index];
    constraint result = blank(k, index);
    const segment *first = &k->m->segments[c->parent.segment];
    result.position = sub(g, k->motions[c->parent.segment].q[0], c->length);
    result.row[first->dof] = constant(g, 1.0);
    if (c->kind == CLOSE_GEAR) {
        const segment *second = &k->m->segments[c->child.segment];
        result.row[second->dof] = neg(g, c->ratio);
        result.position = sub(g, result.position, mul(g, c->ratio, k->motions[c->child.segment].q[0]));
    } else {
        result.position = sub(g, result.position, c->motion);
        result.rate = neg(g, c->motion_rate);
        result.bias = neg(g, c->motion_bias);
    }
    if (!is_zero(g, c->whole)) {
        result.position = divide(g, wrap(g, mul(g, c->whole, result.position)), c->whole);
    }
    result.position = c->in_speed ? constant(g, 0.0) : result.position;
    put(k, to, result, c->name);
}

static void hold_together(const pair *p, constraints *to)
{
    static const char *const parts[] = {"x", "y", "z"};
    const node zero = constant(p->k->g, 0.0);
    for (int i = 0; i < 3; i++) {
        hold_along(p, to, vector_of(p->k->g, i == 0, i == 1, i == 2), zero, false, part_name(p, parts[i]));
    }
}

/* The axis of the child stays across the parent's other two. */
static void hold_parallel(const pair *p, constraints *to)
{
    const int a = p->c->axis;
    const vector w = matrix_column(p->child.axes, a);
    hold_across(p, to, matrix_column(p->parent.axes, (a + 1) % 3), w, part_name(p, "tilt_1"));
    hold_across(p, to, matrix_column(p->parent.axes, (a + 2) % 3), w, part_name(p, "tilt_2"));
}

static void hold_turn(const pair *p, constraints *to)
{
    static const char *const parts[] = {"turn_1", "turn_2", "turn_3"};
    for (int i = 0; i < 3; i++) {
        const vector u = matrix_column(p->parent.axes, i), w = matrix_column(p->child.axes, (i + 1) % 3);
        hold_across(p, to, u, w, part_name(p, parts[i]));
    }
}

/* Two directions across a constant one: n x e for the coordinate axis e that is most across, and n x that. */
static void directions_across(graph *g, vector n, vector across[2])
{
    int most = 0;
    for (int i = 1; i < 3; i++) {
        most = fabs(constant_value(g, n.at[i])) < fabs(constant_value(g, n.at[most])) ? i : most;
    }
    const vector e = vector_of(g, most == 0, most == 1, most == 2), long_one = vector_cross(g, n, e);
    const double square = constant_value(g, vector_dot(g, long_one, long_one));
    across[0] = vector_scale(g, constant(g, 1.0 / sqrt(square)), long_one);
    across[1] = vector_cross(g, n, across[0]);
}

/* Whether the directions across a line of the parent need not turn with it: the line's direction is at rest, or the
 * child does not move along it. Then the two rates are components of a vector, and any two directions will do. */
static bool may_rest(const pair *p)
{
    const kinematics *k = p->k;
    const int a = p->c->axis;
    const vector in_base = outward_axes(k, p->c->parent.segment, p->c->base, matrix_column(p->c->parent.turn, a));
    const bool rests = p->c->base == GROUND && vector_is_constant(k->g, in_base);
    return rests || is_zero(k->g, vector_dot(k->g, matrix_column(p->parent.axes, a), p->apart));
}

/* On the line along the axis of the parent, by two directions across it: constants, as in a planar mechanism, or the
 * parent's. */
static void hold_on_line(const pair *p, constraints *to)
{
    graph *g = p->k->g;
    const int a = p->c->axis;
    const node zero = constant(g, 0.0);
    const bool turns = !may_rest(p);
    const vector along = matrix_column(p->parent.axes, a);
    vector across[2] = {matrix_column(p->parent.axes, (a + 1) % 3), matrix_column(p->parent.axes, (a + 2) % 3)};
    if (!turns && vector_is_constant(g, along)) {
        directions_across(g, along, across);
    }
    hold_along(p, to, across[0], zero, turns, part_name(p, "off_1"));
    hold_along(p, to, across[1], zero, turns, part_name(p, "off_2"));
}

static void hold_rolling(const pair *p, constraints *to)
{
    graph *g = p->k->g;
    const int a = p->c->axis;
    const vector n = vector_scale(g, constant(g, p->c->sign), matrix_column(p->parent.axes, a));
    contact at = {vector_scale(g, neg(g, p->c->length), n), vector_zero(g)};
    if (p->c->is_disc) {
        const disc d = disc_of(p, n);
        hold_disc_height(p, to, &d, n);
        at = disc_contact(p, &d, n);
    } else {
        hold_along(p, to, n, p->c->length, false, part_name(p, "height"));
    }
    hold_no_slip(p, to, matrix_column(p->parent.axes, (a + 1) % 3), at, part_name(p, "slip_1"));
    hold_no_slip(p, to, matrix_column(p->parent.axes, (a + 2) % 3), at, part_name(p, "slip_2"));
}

static void close_pair(const pair *p, constraints *to)
{
    static const struct {
        unsigned what;
        void (*hold)(const pair *p, constraints *to);
    } parts[] = {{HOLDS_ORIGIN, hold_together}, {HOLDS_ON_LINE, hold_on_line}, {HOLDS_DISTANCE, hold_distance},
                 {HOLDS_ROLLING, hold_rolling}, {HOLDS_AXIS, hold_parallel},   {HOLDS_TURN, hold_turn}};
    for (size_t i = 0; i < COUNT_OF(parts); i++) {
        if (closure_rows[p->c->kind].holds & parts[i].what) {
            parts[i].hold(p, to);
        }
    }
}

constraints constraints_build(const kinematics *k, const acceleration *accelerations, closure_axes axes)
{
    enum { MOST_OF_A_CLOSURE = 6 };
    graph *g = k->g;
    const size_t room = MOST_OF_A_CLOSURE * (size_t)k->m->closure_count + 1;
    constraints result = {.all = arena_take(g->memory, room, sizeof *result.all)};
    result.dropped = arena_take(g->memory, room, sizeof *result.dropped);
    for (int i = 0; i < k->m->closure_count; i++) {
        if (acts_along_joints(k->m->closures[i].kind)) {
            hold_joints(k, &result, i);
        } else {
            const pair p = build_pair(k, accelerations, i, axes);
            close_pair(&p, &result);
        }
    }
    return result;
}

node largest_violation(const kinematics *k, const constraints *phi, bool of_rates)
{
    graph *g = k->g;
    node largest = constant(g, 0.0);
    for (int r = 0; r < phi->count; r++) {
        const node one = magnitude(g, of_rates ? phi->all[r].rate : phi->all[r].position);
        largest = is_zero(g, largest) ? one : larger(g, largest, one);
    }
    return largest;
}
