#include "tools/isoc/stability/stability.h"

#include <math.h>
#include <string.h>

/* The formulas of one effect, with their derivatives. */
struct formulas {
    const mechanism *m;
    linearised l;
    int count;
    double *numbers, *arguments; /* of all nodes; inputs and memories, and the changes of the states */
    double *x;                   /* where they are evaluated */
    bool *is_reached;            /* of each node, whether a position leads to its kink */
};

/* The contributions of an effect: its efforts, forces, moments, and the rates of its states. */
static int list_formulas(const mechanism *m, int effect, node *roots)
{
    int count = 0;
    for (int i = 0; i < m->effects.push_count; i++) {
        if (m->effects.pushes[i].effect == effect) {
            roots[count++] = m->effects.pushes[i].effort;
        }
    }
    FOR_ALL (const applied_force, f, m->forces.applied, m->forces.applied_count) {
        for (int axis = 0; axis < 3 && f->drive < 0 && f->effect == effect; axis++) {
            roots[count++] = f->force.at[axis];
            roots[count++] = f->moment.at[axis];
        }
    }
    for (int i = 0; i < m->effects.state_count; i++) {
        if (m->effects.states[i].effect == effect) {
            roots[count++] = m->effects.states[i].next;
        }
    }
    return count;
}

static void evaluate_formulas(formulas *f)
{
    graph_evaluate(&f->l.g, 0, &(evaluation){.x = f->x, .u = f->arguments, .p = f->m->parameters.at_start}, f->numbers);
}

/* Whether a node of this operation has a kink, where its operands are the same, or where its only one is zero. */
static bool kinks_where_same(operation op)
{
    return op == OP_MAX || op == OP_MIN || op == OP_ABOVE;
}

static bool kinks_at_zero(operation op)
{
    return op == OP_POSITIVE || op == OP_NEGATIVE || op == OP_ABS || op == OP_SIGN;
}

/* A number that is zero where a node has its kink. */
static double distance_from_kink(const formulas *f, size_t i)
{
    const graph_node *n = &f->l.g.nodes[i];
    return f->numbers[n->a] - (kinks_where_same(n->op) ? f->numbers[n->b] : 0.0);
}

static double distance_at(formulas *f, size_t kink, int index, double moved)
{
    f->x[index] = moved;
    evaluate_formulas(f);
    return distance_from_kink(f, kink);
}

/* The value of a state at which a kink is, by secants from a value; NAN where they find none. */
static double find_from(formulas *f, size_t kink, int index, double begin)
{
    enum { SECANTS = 12 };
    double before = begin, after = begin + 1e-3 * (1.0 + fabs(begin));
    double d = distance_at(f, kink, index, before), e = distance_at(f, kink, index, after);
    for (int i = 0; i < SECANTS && e != d && isfinite(e - d); i++) {
        const double next = after - e * (after - before) / (e - d);
        if (fabs(next - after) <= 1e-12 * (1.0 + fabs(next))) {
            return next;
        }
        before = after;
        d = e;
        after = next;
        e = distance_at(f, kink, index, after);
    }
    return (double)NAN;
}

/* The same from where the state is; of a position that has a part in it also from elsewhere in a turn, since secants of
 * an angle may lead astray. */
static double find_kink(formulas *f, size_t kink, int index)
{
    static const double begins[] = {0.0, 1.0, -1.0, 2.0, -2.0, 3.0};
    const double here = f->x[index], first = distance_at(f, kink, index, here);
    const bool has_part = distance_at(f, kink, index, here + 1e-3 * (1.0 + fabs(here))) != first;
    const size_t count = !has_part ? 0 : index < f->m->position_count ? COUNT_OF(begins) : 1;
    double found = (double)NAN;
    for (size_t i = 0; i < count && isnan(found); i++) {
        found = find_from(f, kink, index, here + begins[i]);
    }
    f->x[index] = here;
    return found;
}

/* The largest sums of the sizes of the slopes by one state: by a position, and by any other. */
static void slopes_of(formulas *f, double largest[STEEPEST_POINTS])
{
    const int inputs = held_count(f->m);
    largest[0] = largest[1] = 0.0;
    for (int s = 0; s < state_count(f->m); s++) {
        const bool is_position = s < f->m->position_count;
        double sum = 0.0;
        f->arguments[inputs + s] = 1.0;
        evaluate_formulas(f);
        f->arguments[inputs + s] = 0.0;
        for (int i = 0; i < f->count; i++) {
            sum += fabs(f->numbers[f->l.changes[i]]);
        }
        largest[!is_position] = fmax(largest[!is_position], sum);
    }
}

/* Keeps the point in the place of one that is less steep; an infinite slope is a jump, which no step follows. */
static void keep_steeper(formulas *f, double steepest[STEEPEST_POINTS], double *points[STEEPEST_POINTS])
{
    double here[STEEPEST_POINTS];
    slopes_of(f, here);
    for (int i = 0; i < STEEPEST_POINTS; i++) {
        if (isfinite(here[i]) && here[i] > 1.0001 * steepest[i]) {
            const size_t size = (size_t)state_count(f->m);
            points[i] = points[i] != NULL ? points[i] : arena_take(f->l.g.memory, size, sizeof *points[i]);
            memcpy(points[i], f->x, size * sizeof *points[i]);
            steepest[i] = here[i];
        }
    }
}

/* The value of a state beside a kink; of a mode, the next whole number. */
static double beside_kink(const formulas *f, int index, double at, int sign)
{
    const int effect = index - f->m->effects.first_state;
    if (effect >= 0 && effect < f->m->effects.state_count && f->m->effects.states[effect].is_mode) {
        return sign > 0 ? floor(at) + 1.0 : ceil(at) - 1.0;
    }
    return at + sign * 1e-6 * (1.0 + fabs(at));
}

/* Moves one state to both sides of each kink that it leads to; a speed only to those to which no position does: one
 * that leads to these as well would pass them within a step or two. */
static void try_kinks(formulas *f, int index, double steepest[STEEPEST_POINTS], double *points[STEEPEST_POINTS])
{
    const double here = f->x[index];
    const int speed = index - f->m->position_count;
    for (size_t k = 0; k < f->l.g.count; k++) {
        const operation op = f->l.g.nodes[k].op;
        const bool is_passed = f->is_reached[k] && speed >= 0 && speed < f->m->dof_count;
        if ((!kinks_where_same(op) && !kinks_at_zero(op)) || is_passed) {
            continue;
        }
        const double at = isnan(distance_at(f, k, index, here)) ? (double)NAN : find_kink(f, k, index);
        f->is_reached[k] = f->is_reached[k] || (index < f->m->effects.first_state && !isnan(at));
        for (int sign = -1; sign <= 1 && !isnan(at); sign += 2) {
            f->x[index] = beside_kink(f, index, at, sign);
            keep_steeper(f, steepest, points);
        }
        f->x[index] = here;
    }
}

steepness *steepness_find(const graph *g, const mechanism *m, int effect, const double *x, const double *u)
{
    arena *memory = g->memory;
    const size_t states = (size_t)state_count(m), inputs = (size_t)held_count(m);
    const size_t room = (size_t)(m->effects.push_count + 6 * m->forces.applied_count + m->effects.state_count) + 1;
    node *roots = arena_take(memory, room, sizeof *roots);
    steepness *result = arena_take(memory, 1, sizeof *result);
    formulas *f = arena_take(memory, 1, sizeof *f);
    *f = (formulas){.m = m, .count = list_formulas(m, effect, roots)};
    f->l = linearise(g, m, roots, (size_t)f->count);
    f->numbers = arena_take(memory, f->l.g.count + 1, sizeof *f->numbers);
    f->arguments = arena_take(memory, inputs + states + 1, sizeof *f->arguments);
    f->x = list_copy(memory, x, states, sizeof *x);
    f->is_reached = arena_take(memory, f->l.g.count + 1, sizeof *f->is_reached);
    memcpy(f->arguments, u, inputs * sizeof *u);
    const state *moved = mechanism_states(m, memory);
    double *points[STEEPEST_POINTS] = {NULL};
    result->effect = f;
    slopes_of(f, result->steepest);
    for (int s = 0; s < state_count(m); s++) {
        if (moved[s].kind != STATE_QUATERNION) { /* a part of a quaternion cannot move alone */
            try_kinks(f, s, result->steepest, points);
        }
    }
    for (int i = 0; i < STEEPEST_POINTS; i++) {
        if (points[i] != NULL) {
            result->points[result->count++] = points[i];
        }
    }
    return result;
}

bool is_passed(const steepness *s, const double *x, const double *there)
{
    static const double beside = 1e-5; /* of a point of several effects, on either side of its kink */
    bool any = false;
    for (int i = 0; i < state_count(s->effect->m); i++) {
        const double way = there[i] - x[i];
        for (int k = 0; k < s->count && way != 0.0; k++) {
            const double own = s->points[k][i] - x[i];
            any = any || (own * way > 0.0 && fabs(own) < fabs(way) - beside * (1.0 + fabs(there[i])));
        }
    }
    return any;
}

void steepness_free(steepness *s)
{
    graph_free(&s->effect->l.g);
}
