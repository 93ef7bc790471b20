#include "tools/isoc/stability/stability.h"

#include <math.h>
#include <string.h>

#include "core/numbers/angle.h"
#include "core/numbers/exp.h"
#include "core/numbers/log.h"

/* A run is looked at in windows of so many steps; a formula that jumps less often in one does not count as switching.
 */
enum { WINDOW = 2000, FEWEST_JUMPS = 4 };

/* Nodes evaluated: some 50 ms of isoc. */
static const double most_evaluated = 1e7;

/* The largest share of a switched value that half a step at each jump may be. */
static const double most_share = 0.01;

/* Some functions of a graph, with their values in this step and in the one before. */
typedef struct functions {
    graph g;
    node *roots;
    bool *switches, any_switch;   /* [nodes] constant but for jumps; whether there is one */
    double *now, *before, *moved; /* [nodes] */
} functions;

/* A contribution of an effect: an effort, a force, a moment, or the rate of a state. */
typedef struct gift {
    int effect, first, count; /* of the roots */
    bool is_rate;
    double last, largest; /* the size of the last jump; and the largest of the gift itself so far */
    double jumps, amount; /* sums over the steps of a window */
    int times;
} gift;

/* The worst window of an effect. */
typedef struct finding {
    double share, steps, until; /* steps between two jumps; s */
} finding;

typedef struct look {
    const mechanism *m;
    functions drives, plant;
    size_t states;
    double *x, *x_before, *u, *u_before, *u_moved, *parameters;
    gift *gifts;
    int gift_count;
    finding *worst; /* [effects] */
    double step, evaluated;
} look;

/* A square of an even period has its edges on ticks, as have a step and a prbs: such a jump is where it ought to be. */
static bool is_switch(const graph_node *n)
{
    return n->op == OP_ABOVE || n->op == OP_SIGN || n->op == OP_FLOOR || n->op == OP_ROUND ||
           n->op == OP_SQUARE_OF_PHASE || (n->op == OP_SQUARE && n->value < 2.0 * n->index);
}

static functions functions_of(const graph *g, const node *roots, size_t count)
{
    arena *memory = g->memory;
    functions result = {.roots = arena_take(memory, count + 1, sizeof *result.roots)};
    result.g = economise(g, roots, count, result.roots);
    result.switches = arena_take(memory, result.g.count + 1, sizeof *result.switches);
    result.now = arena_take(memory, result.g.count + 1, sizeof *result.now);
    result.before = arena_take(memory, result.g.count + 1, sizeof *result.before);
    result.moved = arena_take(memory, result.g.count + 1, sizeof *result.moved);
    for (size_t i = 0; i < result.g.count; i++) {
        result.switches[i] = is_switch(&result.g.nodes[i]);
        result.any_switch = result.any_switch || result.switches[i];
    }
    return result;
}

/* An operation as the target computes it: isoc's own functions, which round to the nearest, take a hundred times as
 * long. */
static double value_at(const graph *g, const graph_node *n, const evaluation *at, double a, double b)
{
    switch (n->op) {
    case OP_EXP:
        return iso_exp(a);
    case OP_LOG:
        return iso_log(a);
    case OP_ATAN2:
        return iso_atan2(a, b);
    default:
        return operators[n->op].value(g, n, at, a, b);
    }
}

/* The values of all nodes; those that switch are as in `kept`, where that is not NULL. */
static void evaluate(look *l, const functions *f, const evaluation *at, const double *kept, double *numbers)
{
    for (size_t i = 0; i < f->g.count; i++) {
        const graph_node *n = &f->g.nodes[i];
        numbers[i] = kept != NULL && f->switches[i] ? kept[i] : value_at(&f->g, n, at, numbers[n->a], numbers[n->b]);
    }
    l->evaluated += (double)f->g.count;
}

static bool has_switched(const functions *f)
{
    bool any = false;
    for (size_t i = 0; i < f->g.count && !any; i++) {
        any = f->switches[i] && f->now[i] != f->before[i];
    }
    return any;
}

static void swap(double **a, double **b)
{
    double *other = *a;
    *a = *b;
    *b = other;
}

static void take_inputs(const look *l, const double *numbers, double *u)
{
    for (int i = 0; i < l->m->inputs.count; i++) {
        u[i] = input_in_row(l->m, i, numbers[l->drives.roots[i]]);
    }
}

/* The inputs, clocks and tunables of a tick. */
static void begin_tick(look *l, uint64_t tick)
{
    const mechanism *m = l->m;
    for (int i = 0; i < m->parameters.change_count; i++) {
        if ((uint64_t)m->parameters.changes[i].tick == tick) {
            l->parameters[m->parameters.changes[i].parameter] = m->parameters.changes[i].value;
        }
    }
    swap(&l->drives.now, &l->drives.before);
    evaluate(l, &l->drives, &(evaluation){.p = l->parameters, .tick = tick}, NULL, l->drives.now);
    take_inputs(l, l->drives.now, l->u);
    for (int i = 0; i < m->clocks.count; i++) {
        l->x[m->clocks.first + i] = l->drives.now[l->drives.roots[m->inputs.count + i]];
    }
}

/* The jumps of the roots: the plant here as it is switched on the other side, jumped[roots]. `sign` is 1 where the
 * other side is the step before. */
static void jump_at(look *l, const double *x, const double *u, uint64_t tick, double sign, double *jumped)
{
    functions *f = &l->plant, *d = &l->drives;
    const bool is_after = sign > 0.0;
    memcpy(l->u_moved, u, (size_t)held_count(l->m) * sizeof *u);
    if (has_switched(d)) {
        evaluate(l, d, &(evaluation){.p = l->parameters, .tick = tick}, is_after ? d->before : d->now, d->moved);
        take_inputs(l, d->moved, l->u_moved);
    }
    const double *here = is_after ? f->now : f->before, *there = is_after ? f->before : f->now;
    evaluate(l, f, &(evaluation){.x = x, .u = l->u_moved, .p = l->parameters, .tick = tick}, there, f->moved);
    for (int i = 0; i < l->gift_count; i++) {
        for (int k = l->gifts[i].first; k < l->gifts[i].first + l->gifts[i].count; k++) {
            jumped[k] = sign * (here[f->roots[k]] - f->moved[f->roots[k]]);
        }
    }
}

/* A kink has a difference that changes its sign where it is, and jumps by nothing; a jump has one on both sides. */
static double size_of_jump(const gift *g, const double *after, const double *before)
{
    double sum = 0.0;
    for (int k = g->first; k < g->first + g->count; k++) {
        const double least = fmin(fabs(after[k]), fabs(before[k]));
        sum += (after[k] > 0.0) == (before[k] > 0.0) ? least : 0.0;
    }
    return sum;
}

static double size_of_gift(const look *l, const gift *g)
{
    double sum = 0.0;
    for (int k = g->first; k < g->first + g->count; k++) {
        sum += fabs(l->plant.now[l->plant.roots[k]]);
    }
    return sum;
}

/* A rate falls between two jumps, as the state follows the switched value: the fall counts as half of the jump, at
 * least. */
static void add_step(look *l, bool jumps, const double *after, const double *before)
{
    static const double rounding = 1e-9;
    FOR_ALL (gift, g, l->gifts, l->gift_count) {
        const double size = size_of_gift(l, g), jump = jumps ? size_of_jump(g, after, before) : 0.0;
        g->largest = fmax(g->largest, size);
        if (jump > rounding * g->largest) {
            g->last = jump;
            g->jumps += jump;
            g->times++;
        }
        g->amount += g->is_rate ? fmax(size, 0.5 * g->last) : size;
    }
}

static void end_window(look *l, double until)
{
    FOR_ALL (gift, g, l->gifts, l->gift_count) {
        const double share = g->times >= FEWEST_JUMPS ? 0.5 * g->jumps / g->amount : 0.0;
        finding *worst = &l->worst[g->effect];
        if (share > worst->share) {
            *worst = (finding){share, (double)WINDOW / (double)g->times, until};
        }
        g->jumps = g->amount = 0.0;
        g->times = 0;
    }
}

/* A step of rk4, whose first stage is evaluated. Returns whether the states are finite. */
static bool move(look *l, uint64_t tick, double *stage, double *sum)
{
    static const double reach[] = {0.5, 0.5, 1.0}, weight[] = {2.0, 2.0, 1.0};
    const functions *f = &l->plant;
    const double *numbers = f->now;
    bool finite = true;
    memset(sum, 0, l->states * sizeof *sum);
    for (int k = 0; k < 4; k++) {
        for (size_t i = 0; i < l->states; i++) {
            sum[i] += (k == 0 ? 1.0 : weight[k - 1]) * numbers[f->roots[i]];
            stage[i] = k < 3 ? l->x[i] + reach[k] * l->step * numbers[f->roots[i]] : 0.0;
        }
        if (k < 3) {
            evaluate(l, f, &(evaluation){.x = stage, .u = l->u, .p = l->parameters, .tick = tick}, NULL, f->moved);
            numbers = f->moved;
        }
    }
    for (size_t i = 0; i < l->states; i++) {
        l->x_before[i] = l->x[i];
        l->x[i] += l->step * sum[i] / 6.0;
        finite = finite && isfinite(l->x[i]);
    }
    return finite;
}

static void follow(look *l, arena *memory, size_t roots)
{
    const uint64_t in_tick = (uint64_t)lround(l->m->method.step / l->step);
    double *after = arena_take(memory, roots + 1, sizeof *after);
    double *before = arena_take(memory, roots + 1, sizeof *before);
    double *stage = arena_take(memory, l->states + 1, sizeof *stage);
    double *sum = arena_take(memory, l->states + 1, sizeof *sum);
    bool goes_on = true;
    for (uint64_t k = 0; goes_on && l->evaluated < most_evaluated && (double)k * l->step < life; k++) {
        const uint64_t tick = k / in_tick, earlier = k == 0 ? 0 : (k - 1) / in_tick;
        memcpy(l->u_before, l->u, (size_t)held_count(l->m) * sizeof *l->u);
        if (k % in_tick == 0) {
            begin_tick(l, tick);
        } else {
            memcpy(l->drives.before, l->drives.now, l->drives.g.count * sizeof *l->drives.now);
        }
        swap(&l->plant.now, &l->plant.before);
        evaluate(l, &l->plant, &(evaluation){.x = l->x, .u = l->u, .p = l->parameters, .tick = tick}, NULL,
                 l->plant.now);
        const bool jumps = k > 0 && (has_switched(&l->plant) || has_switched(&l->drives));
        if (jumps) {
            jump_at(l, l->x, l->u, tick, 1.0, after);
            jump_at(l, l->x_before, l->u_before, earlier, -1.0, before);
        }
        add_step(l, jumps, after, before);
        if ((k + 1) % WINDOW == 0) {
            end_window(l, (double)(k + 1) * l->step);
        }
        goes_on = move(l, tick, stage, sum);
    }
}

/* The derivatives, and behind them the efforts and rates of each effect. */
static size_t list_contributions(look *l, const plant *p, node *roots)
{
    const mechanism *m = l->m;
    int count = (int)l->states;
    memcpy(roots, p->derivatives, l->states * sizeof *roots);
    for (int i = 0; i < m->effects.push_count; i++) {
        l->gifts[l->gift_count++] = (gift){.effect = m->effects.pushes[i].effect, .first = count, .count = 1};
        roots[count++] = m->effects.pushes[i].effort;
    }
    FOR_ALL (const applied_force, f, m->forces.applied, m->forces.applied_count) {
        for (int turns = 0; turns < 2 && f->drive < 0; turns++, count += 3) {
            l->gifts[l->gift_count++] = (gift){.effect = f->effect, .first = count, .count = 3};
            memcpy(roots + count, turns ? f->moment.at : f->force.at, 3 * sizeof *roots);
        }
    }
    FOR_ALL (const effect_quantity, e, m->effects.states, m->effects.state_count) {
        if (e->is_mode) {
            continue;
        }
        l->gifts[l->gift_count++] = (gift){.effect = e->effect, .first = count, .count = 1, .is_rate = true};
        roots[count++] = e->next;
    }
    return (size_t)count;
}

static bool uses_memory(const functions *f, const mechanism *m)
{
    bool any = false;
    for (size_t i = 0; i < f->g.count; i++) {
        any = any || (f->g.nodes[i].op == OP_INPUT && f->g.nodes[i].index >= m->inputs.count);
    }
    return any;
}

static void warn_of_jumps(const source *s, const look *l, int effect)
{
    const finding *f = &l->worst[effect];
    const name *n = &l->m->effects.names[effect];
    source_warn(s, n->at,
                "the effect '%s' jumps every %.3g steps of %.4g ms in the %.3g s until %.4g s: a jump within a step is "
                "misplaced by up to half of it, here %.2g %% of what it switches; up to 1 %% takes a step of %.2g ms",
                n->text, f->steps, 1e3 * l->step, (double)WINDOW * l->step, f->until, 100.0 * f->share,
                1e3 * l->step * most_share / f->share);
}

/* All that it needs to follow the plant, with the states at the start. */
static look look_of(const graph *g, const plant *p, size_t *root_count)
{
    const mechanism *m = p->m;
    arena *memory = g->memory;
    const int parts = m->method.parts * (m->effects.fast_substeps > 0 ? m->effects.fast_substeps : 1);
    const size_t states = (size_t)state_count(m), inputs = (size_t)held_count(m) + 1;
    const size_t room = states + (size_t)(m->effects.push_count + 6 * m->forces.applied_count + m->effects.state_count);
    node *roots = arena_take(memory, room + 1, sizeof *roots);
    look l = {.m = m, .states = states, .step = m->method.step / (double)parts};
    l.gifts = arena_take(memory, room + 1, sizeof *l.gifts);
    l.worst = arena_take(memory, (size_t)m->effects.count + 1, sizeof *l.worst);
    *root_count = list_contributions(&l, p, roots);
    l.plant = functions_of(g, roots, *root_count);
    const node first_leaf = 0; /* in the place of an input of the port */
    const size_t drives = (size_t)(m->inputs.count + m->clocks.count);
    node *driving = arena_take(memory, drives + 1, sizeof *driving);
    for (size_t i = 0; i < drives; i++) {
        const bool is_clock = i >= (size_t)m->inputs.count;
        driving[i] = is_clock || m->inputs.driven[i] ? m->inputs.drives[i] : first_leaf;
    }
    l.drives = functions_of(g, driving, drives);
    l.x = mechanism_start(m, memory);
    l.x_before = arena_take(memory, states + 1, sizeof *l.x_before);
    l.u = arena_take(memory, inputs, sizeof *l.u);
    l.u_before = arena_take(memory, inputs, sizeof *l.u_before);
    l.u_moved = arena_take(memory, inputs, sizeof *l.u_moved);
    l.parameters = list_copy(memory, m->parameters.defaults, (size_t)m->parameters.count, sizeof *l.parameters);
    return l;
}

void switching_check(const source *s, const graph *g, const plant *p)
{
    const mechanism *m = p->m;
    const bool is_followed = !ISO_IS_VARYING(m->method.recipe) && !ISO_IS_IMPLICIT(m->method.recipe);
    if (!is_followed || m->effects.count == 0 || m->events.count > 0) {
        return;
    }
    size_t roots;
    look l = look_of(g, p, &roots);
    if (!uses_memory(&l.plant, m) && (l.plant.any_switch || l.drives.any_switch)) {
        follow(&l, g->memory, roots);
    }
    for (int i = 0; i < m->effects.count; i++) {
        if (l.worst[i].share > most_share) {
            warn_of_jumps(s, &l, i);
        }
    }
    graph_free(&l.plant.g);
    graph_free(&l.drives.g);
}
