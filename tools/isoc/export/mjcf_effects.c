/* Effects that MuJoCo can express. The efforts of an effect decide on its form, not its name: one that is linear in
 * coordinates, speeds and inputs becomes tendons, which are springs and dampers of sums of joints, and motors; a
 * limited one becomes an actuator with a range of its force; dry friction, and an effect that acts beyond two limits
 * alone, become attributes of the joint. */
#include <math.h>
#include <string.h>

#include "tools/isoc/base/numbers.h"
#include "tools/isoc/export/mjcf.h"

/* effort = constant + sums over degrees of freedom and inputs. */
typedef struct linear_effort {
    double constant, *by_place, *by_speed, *by_input;
} linear_effort;

/* effort = -stiffness coordinates - damping speeds + constant + drive inputs, over the degrees of freedom. */
typedef struct linear_effect {
    double *stiffness, *damping, *constant, *drive; /* [n n], [n n], [n], [n][inputs] */
} linear_effect;

/* The largest rounding of a zero, relative to the largest number. */
static const double none = 1e-12;

static double *zeros(const mjcf_writer *w, int count)
{
    return arena_take(w->g->memory, (size_t)count + 1, sizeof(double));
}

static double value_at(const mjcf_writer *w, node n, const double *x, const double *u)
{
    double *all = arena_take(w->g->memory, w->g->count, sizeof *all);
    graph_evaluate(w->g, 0, &(evaluation){.x = x, .u = u, .p = w->m->parameters.at_start}, all);
    const double result = all[n];
    arena_return(w->g->memory, all, w->g->count, sizeof *all);
    return result;
}

/* The degree of freedom of a state, where it is of a joint of one coordinate; else -1. */
static int dof_of_state(const mechanism *m, int number, bool *is_speed)
{
    FOR_ALL (const segment, l, m->segments, m->segment_count) {
        *is_speed = number == m->position_count + l->dof;
        if (l->kind != JOINT_SPHERICAL && (*is_speed || number == l->position)) {
            return l->dof;
        }
    }
    return -1;
}

/* [count] The leaves of an operation that a node needs. */
static bool *needs_leaves(const mjcf_writer *w, node n, operation op, int count)
{
    bool *marked = arena_take(w->g->memory, (size_t)count + 1, sizeof *marked);
    mark_leaves(w->g, &n, 1, op, marked);
    return marked;
}

/* Whether a node is a number of states and inputs, at any time. */
static bool is_steady(const mjcf_writer *w, node n)
{
    return !uses_time(w->g, &n, 1) && !uses_operation(w->g, &n, 1, OP_QUERY) &&
           !uses_operation(w->g, &n, 1, OP_DERIVATIVE);
}

/* The value of a node that nothing changes; false of others. */
static bool number_of(const mjcf_writer *w, node n, double *number)
{
    if (can_change(w->g, n) || !is_steady(w, n)) {
        return false;
    }
    *number = value_at(w, n, NULL, NULL);
    return true;
}

/* The derivative by a leaf, where that is a number. */
static bool slope(const mjcf_writer *w, node n, node by, double *result)
{
    node d;
    differentiate(w->g, &n, 1, by, &d);
    return number_of(w, d, result) && isfinite(*result);
}

/* False where a node is no such sum. */
static bool linear_effort_of(const mjcf_writer *w, node n, linear_effort *l)
{
    const mechanism *m = w->m;
    const bool *states = needs_leaves(w, n, OP_STATE, state_count(m));
    const bool *inputs = needs_leaves(w, n, OP_INPUT, held_count(m));
    *l = (linear_effort){0.0, zeros(w, m->dof_count), zeros(w, m->dof_count), zeros(w, m->inputs.count)};
    if (!is_steady(w, n)) {
        return false;
    }
    for (int i = 0; i < state_count(m); i++) {
        bool is_speed = false;
        const int freedom = states[i] ? dof_of_state(m, i, &is_speed) : -1;
        if (states[i] && (freedom < 0 || !slope(w, n, leaf(w->g, OP_STATE, i),
                                                is_speed ? &l->by_speed[freedom] : &l->by_place[freedom]))) {
            return false;
        }
    }
    for (int i = 0; i < held_count(m); i++) {
        if (inputs[i] && (i >= m->inputs.count || !slope(w, n, leaf(w->g, OP_INPUT, i), &l->by_input[i]))) {
            return false;
        }
    }
    l->constant = value_at(w, n, NULL, NULL);
    return isfinite(l->constant);
}

static const segment *joint_of(const mjcf_writer *w, int freedom)
{
    return &w->m->segments[w->m->dofs[freedom].segment];
}

/* --- springs and dampers --- */

/* A symmetric matrix as sums of d l l', of which row k has d and l[k] = 1: L D L' of Golub and Van Loan (2013), 4.1.
 * False where it is none, or a zero on its diagonal stands before others. */
static bool split_rows(const double *rows, int n, double *a, double *d)
{
    const double size = largest_of(rows, n * n);
    memcpy(a, rows, (size_t)(n * n) * sizeof *a);
    for (int k = 0; k < n; k++) {
        d[k] = fabs(a[k * n + k]) > none * size ? a[k * n + k] : 0.0;
        for (int j = k; j < n; j++) {
            const double upper = a[k * n + j], lower = a[j * n + k];
            if (fabs(upper - lower) > none * size || (d[k] == 0.0 && fabs(upper) > none * size)) {
                return false;
            }
        }
        for (int i = k + 1; i < n && d[k] != 0.0; i++) {
            for (int j = k + 1; j < n; j++) {
                a[i * n + j] -= a[k * n + i] * a[k * n + j] / d[k];
            }
        }
        for (int j = k; j < n && d[k] != 0.0; j++) {
            a[k * n + j] = fabs(a[k * n + j]) > none * size ? a[k * n + j] / d[k] : 0.0;
        }
    }
    return true;
}

/* A tendon: the sum of coordinates with the factors of row k, which begin there; or less that sum, so that a spring's
 * rest is not below zero, which MuJoCo takes for its start. */
static void put_tendon(mjcf_writer *w, const char *called, const char *more, const double *row, int k, double sign)
{
    text_add(&w->tendons, "<fixed name=\"%s\"%s>", called, more);
    for (int j = k; j < w->m->dof_count; j++) {
        if (row[j] != 0.0) {
            text_add(&w->tendons, "<joint joint=\"%s\" coef=\"%s\"/>", joint_of(w, j)->name,
                     mjcf_number(w, sign * row[j]));
        }
    }
    text_add(&w->tendons, "</fixed>\n");
}

/* False where the matrices are not those of springs and dampers. */
static bool say_linear(mjcf_writer *w, const char *called, const linear_effect *l)
{
    arena *memory = w->g->memory;
    const int n = w->m->dof_count, inputs = w->m->inputs.count;
    double *springs = zeros(w, n * n), *dampers = zeros(w, n * n), *stiff = zeros(w, n), *damped = zeros(w, n);
    if (!split_rows(l->stiffness, n, springs, stiff) || !split_rows(l->damping, n, dampers, damped)) {
        return false;
    }
    for (int k = 0; k < n; k++) {
        const bool both = damped[k] != 0.0 &&
                          memcmp(springs + k * n + k, dampers + k * n + k, (size_t)(n - k) * sizeof *springs) == 0;
        const char *damping = arena_format(memory, " damping=\"%s\"", mjcf_number(w, damped[k]));
        if (stiff[k] != 0.0) {
            const double length = l->constant[k] / stiff[k];
            put_tendon(w, arena_format(memory, "%s_spring_%s", called, joint_of(w, k)->name),
                       arena_format(memory, " stiffness=\"%s\" springlength=\"%s\"%s", mjcf_number(w, stiff[k]),
                                    mjcf_number(w, fabs(length)), both ? damping : ""),
                       springs + k * n, k, length < 0.0 ? -1.0 : 1.0);
            for (int j = n - 1; j >= k; j--) {
                l->constant[j] -= springs[k * n + j] * l->constant[k];
            }
        }
        if (damped[k] != 0.0 && !both) {
            put_tendon(w, arena_format(memory, "%s_damper_%s", called, joint_of(w, k)->name), damping, dampers + k * n,
                       k, 1.0);
        }
    }
    for (int k = 0; k < n; k++) {
        if (l->constant[k] != 0.0) {
            text_add(&w->actuators,
                     "<general name=\"%s_constant_%s\" joint=\"%s\" gainprm=\"0\" biastype=\"affine\" "
                     "biasprm=\"%s 0 0\"/>\n",
                     called, joint_of(w, k)->name, joint_of(w, k)->name, mjcf_number(w, l->constant[k]));
        }
        for (int i = 0; i < inputs; i++) {
            if (l->drive[k * inputs + i] != 0.0) {
                text_add(&w->actuators, "<motor name=\"%s_on_%s_%s\" joint=\"%s\" gear=\"%s\"/>\n",
                         w->m->inputs.all[i].name, called, joint_of(w, k)->name, joint_of(w, k)->name,
                         mjcf_number(w, l->drive[k * inputs + i]));
            }
        }
    }
    return true;
}

static bool is_linear(mjcf_writer *w, int effect)
{
    const mechanism *m = w->m;
    const int n = m->dof_count, inputs = m->inputs.count;
    const linear_effect all = {zeros(w, n * n), zeros(w, n * n), zeros(w, n), zeros(w, n * inputs)};
    FOR_ALL (const effect_effort, e, m->effects.pushes, m->effects.push_count) {
        linear_effort own;
        if (e->effect != effect) {
            continue;
        }
        if (joint_of(w, e->dof)->kind == JOINT_SPHERICAL || !linear_effort_of(w, e->effort, &own)) {
            return false;
        }
        all.constant[e->dof] += own.constant;
        for (int j = 0; j < n; j++) {
            all.stiffness[e->dof * n + j] -= own.by_place[j];
            all.damping[e->dof * n + j] -= own.by_speed[j];
        }
        for (int i = 0; i < inputs; i++) {
            all.drive[e->dof * inputs + i] += own.by_input[i];
        }
    }
    return say_linear(w, m->effects.names[effect].text, &all);
}

/* --- actuators with a range --- */

/* Takes numbers and signs from a product, and multiplies the scale by them. */
static node without_factors(const mjcf_writer *w, node n, double *scale)
{
    for (;;) {
        const graph_node *at = &w->g->nodes[n];
        double factor = 1.0;
        if (at->op == OP_NEG) {
            *scale = -*scale;
            n = at->a;
        } else if (at->op == OP_MUL && number_of(w, at->a, &factor)) {
            *scale *= factor;
            n = w->g->nodes[n].b;
        } else if ((at->op == OP_MUL || at->op == OP_DIV) && number_of(w, w->g->nodes[n].b, &factor)) {
            *scale *= w->g->nodes[n].op == OP_MUL ? factor : 1.0 / factor;
            n = w->g->nodes[n].a;
        } else {
            return n;
        }
    }
}

/* The operand of a min or max that is no number, and the number. */
static bool limited_operand(const mjcf_writer *w, operation op, node n, node *inner, double *bound)
{
    const graph_node at = w->g->nodes[n];
    if (at.op != op) {
        return false;
    }
    *inner = number_of(w, at.a, bound) ? at.b : at.a;
    return *inner == at.b || number_of(w, at.b, bound);
}

/* Whether a node is clamp(inner, least, most). */
static bool clamped(const mjcf_writer *w, node n, node *inner, double limits[2])
{
    node between;
    return (limited_operand(w, OP_MIN, n, &between, &limits[1]) &&
            limited_operand(w, OP_MAX, between, inner, &limits[0])) ||
           (limited_operand(w, OP_MAX, n, &between, &limits[0]) &&
            limited_operand(w, OP_MIN, between, inner, &limits[1]));
}

static void put_actuator(mjcf_writer *w, const char *called, const double *ratios, const linear_effort *l, int input,
                         const double bias[3], const double limits[2])
{
    int joints = 0, first = -1;
    for (int k = 0; k < w->m->dof_count; k++) {
        joints += ratios[k] != 0.0;
        first = first < 0 && ratios[k] != 0.0 ? k : first;
    }
    text_add(&w->actuators, "<general name=\"%s_on_%s\"", input < 0 ? "nothing" : w->m->inputs.all[input].name, called);
    if (joints > 1) {
        put_tendon(w, arena_format(w->g->memory, "%s_joints", called), "", ratios, first, 1.0);
        text_add(&w->actuators, " tendon=\"%s_joints\"", called);
    } else {
        text_add(&w->actuators, " joint=\"%s\"", joint_of(w, first)->name);
    }
    text_add(
        &w->actuators,
        " gear=\"%s\" gainprm=\"%s\" biastype=\"affine\" biasprm=\"%s\" forcerange=\"%s\" forcelimited=\"true\"/>\n",
        mjcf_number(w, joints > 1 ? 1.0 : ratios[first]), mjcf_number(w, input < 0 ? 0.0 : l->by_input[input]),
        mjcf_numbers(w, bias, 3), mjcf_numbers(w, limits, 2));
}

/* Of an effect with a range: the same clamped sum on each joint, times a number, which the sum has of its coordinate
 * too. */
static bool is_actuator(mjcf_writer *w, int effect)
{
    const mechanism *m = w->m;
    double *ratios = zeros(w, m->dof_count), limits[2] = {0.0, 0.0}, bias[3] = {0.0, 0.0, 0.0};
    node core = -1, inner = -1;
    FOR_ALL (const effect_effort, e, m->effects.pushes, m->effects.push_count) {
        double scale = 1.0;
        const node own = e->effect == effect ? without_factors(w, e->effort, &scale) : core;
        if (e->effect == effect && (joint_of(w, e->dof)->kind == JOINT_SPHERICAL || (core >= 0 && own != core))) {
            return false;
        }
        core = own;
        ratios[e->dof] += e->effect == effect ? scale : 0.0;
    }
    linear_effort l;
    if (core < 0 || !clamped(w, core, &inner, limits) || limits[0] >= limits[1] || !linear_effort_of(w, inner, &l)) {
        return false;
    }
    int input = -1;
    for (int i = 0; i < m->inputs.count; i++) {
        if (l.by_input[i] != 0.0 && input >= 0) {
            return false;
        }
        input = l.by_input[i] != 0.0 ? i : input;
    }
    bias[0] = l.constant;
    for (int k = 0; k < m->dof_count; k++) {
        bias[1] = bias[1] == 0.0 && ratios[k] != 0.0 ? l.by_place[k] / ratios[k] : bias[1];
        bias[2] = bias[2] == 0.0 && ratios[k] != 0.0 ? l.by_speed[k] / ratios[k] : bias[2];
    }
    for (int k = 0; k < m->dof_count; k++) {
        if (fabs(l.by_place[k] - bias[1] * ratios[k]) > none * fabs(l.by_place[k]) ||
            fabs(l.by_speed[k] - bias[2] * ratios[k]) > none * fabs(l.by_speed[k])) {
            return false;
        }
    }
    put_actuator(w, m->effects.names[effect].text, ratios, &l, input, bias, limits);
    return true;
}

/* --- friction and limits --- */

/* An effort that only the joint's own coordinate and speed change. */
typedef struct own_effort {
    const mjcf_writer *w;
    const segment *joint;
    node effort;
    double *x;
} own_effort;

static double effort_at(const own_effort *e, double position, double speed)
{
    e->x[e->joint->position] = position;
    e->x[e->w->m->position_count + e->joint->dof] = speed;
    return value_at(e->w, e->effort, e->x, NULL);
}

static bool own_effort_of(mjcf_writer *w, int effect, own_effort *result)
{
    const mechanism *m = w->m;
    int count = 0;
    FOR_ALL (const effect_effort, e, m->effects.pushes, m->effects.push_count) {
        if (e->effect == effect) {
            *result = (own_effort){w, joint_of(w, e->dof), e->effort, mechanism_start(m, w->g->memory)};
            count++;
        }
    }
    if (count != 1 || result->joint->kind == JOINT_SPHERICAL || !is_steady(w, result->effort) ||
        uses_operation(w->g, &result->effort, 1, OP_INPUT)) {
        return false;
    }
    const bool *states = needs_leaves(w, result->effort, OP_STATE, state_count(m));
    for (int i = 0; i < state_count(m); i++) {
        if (states[i] && i != result->joint->position && i != m->position_count + result->joint->dof) {
            return false;
        }
    }
    return true;
}

/* The same against every speed from some on, anywhere, and nowhere more. */
static bool is_friction(const own_effort *e, double *size)
{
    static const double fast = 1e6;
    const double here = e->joint->start[0];
    *size = -effort_at(e, here, fast);
    for (double speed = 1e-9; speed <= fast; speed *= 4.0) {
        const double forth = -effort_at(e, here + speed, speed), back = effort_at(e, here - speed, -speed);
        if (!(forth >= 0.0 && forth <= *size * (1.0 + none) && fabs(forth - back) <= none * *size)) {
            return false;
        }
    }
    return *size > 0.0 && -effort_at(e, here, 0.001 * fast) >= *size * (1.0 - none);
}

/* The last place from the start on, in steps of this sign, where nothing acts; false where it acts nowhere. */
static bool limit_of(const own_effort *e, double sign, double *result)
{
    enum { HALVINGS = 80 };
    static const double farthest = 1e5;
    double within = e->joint->start[0], beyond = within, step = 1e-3;
    while (effort_at(e, beyond, 0.0) == 0.0 && step < farthest) {
        within = beyond;
        beyond = e->joint->start[0] + sign * step;
        step *= 2.0;
    }
    for (int i = 0; i < HALVINGS; i++) {
        const double middle = 0.5 * (within + beyond);
        *(effort_at(e, middle, 0.0) == 0.0 ? &within : &beyond) = middle;
    }
    *result = within;
    return sign * effort_at(e, beyond + sign * 1e-3, 0.0) < 0.0;
}

/* Whether an effort is zero between two limits, and pushes back from beyond them. */
static bool is_limits(const own_effort *e, double limits[2])
{
    enum { PROBES = 20 };
    if (effort_at(e, e->joint->start[0], 0.0) != 0.0 || !limit_of(e, -1.0, &limits[0]) ||
        !limit_of(e, 1.0, &limits[1])) {
        return false;
    }
    bool is_free = limits[0] < limits[1];
    for (int i = 1; i < PROBES; i++) {
        const double position = limits[0] + (limits[1] - limits[0]) * i / (double)PROBES;
        is_free = is_free && effort_at(e, position, 1.0) == 0.0 && effort_at(e, position, -1.0) == 0.0;
    }
    return is_free;
}

static bool is_of_joint(mjcf_writer *w, int effect)
{
    own_effort e;
    double size, limits[2];
    if (!own_effort_of(w, effect, &e)) {
        return false;
    }
    joint_bounds *b = &w->bounds[e.joint - w->m->segments];
    if (is_friction(&e, &size)) {
        b->friction += size;
        return true;
    }
    if (b->is_limited || !is_limits(&e, limits)) {
        return false;
    }
    *b = (joint_bounds){true, limits[0], limits[1], b->friction};
    return true;
}

void mjcf_say_effects(mjcf_writer *w)
{
    const mechanism *m = w->m;
    /* Those that push joints, and no body. */
    bool *is_of_joints = arena_take(w->g->memory, (size_t)m->effects.count + 1, sizeof *is_of_joints);
    FOR_ALL (const effect_effort, e, m->effects.pushes, m->effects.push_count) {
        is_of_joints[e->effect] = true;
    }
    FOR_ALL (const applied_force, f, m->forces.applied, m->forces.applied_count) {
        if (f->drive < 0) {
            is_of_joints[f->effect] = false;
        }
    }
    for (int i = 0; i < m->effects.count; i++) {
        w->is_said[i] = is_of_joints[i] && (is_linear(w, i) || is_actuator(w, i) || is_of_joint(w, i));
    }
}
