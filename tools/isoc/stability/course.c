/* The motion from the start as isoc follows it: rk4 in double, with the inputs, clocks, tunables and memories of each
 * tick. */
#include "tools/isoc/stability/stability.h"

#include <math.h>
#include <string.h>

#include "core/numbers/angle.h"
#include "core/numbers/exp.h"
#include "core/numbers/log.h"
#include "core/numbers/power.h"

/* Nodes evaluated: some 50 ms of isoc. */
static const double most_evaluated = 1e7;

/* A square of an even period has its edges on ticks, as have a step and a prbs: such a jump is where it ought to be. */
static bool is_switch(const graph_node *n)
{
    return n->op == OP_ABOVE || n->op == OP_SIGN || n->op == OP_FLOOR || n->op == OP_ROUND ||
           n->op == OP_SQUARE_OF_PHASE || (n->op == OP_SQUARE && n->value < 2.0 * n->index);
}

/* A condition on states, of a memory that is set at rows. */
static bool is_comparison(const graph_node *n)
{
    return n->op == OP_ABOVE || n->op == OP_SIGN;
}

/* What changes within a step: states but for modes; and for what is not set at rows, inputs. */
static bool is_moving(const mechanism *m, const graph_node *n, bool at_rows)
{
    const int number = n->index - m->effects.first_state;
    const bool is_mode = number >= 0 && number < m->effects.state_count && m->effects.states[number].is_mode;
    return n->op == OP_STATE ? !is_mode : n->op == OP_INPUT && n->index < m->inputs.count && !at_rows;
}

/* A node that switches by events alone, or by memories, does so at its time. */
static functions functions_of(const graph *g, const mechanism *m, const node *roots, size_t count, bool at_rows)
{
    arena *memory = g->memory;
    functions result = {.roots = arena_take(memory, count + 1, sizeof *result.roots)};
    result.g = economise(g, roots, count, result.roots);
    result.switches = arena_take(memory, result.g.count + 1, sizeof *result.switches);
    result.now = arena_take(memory, result.g.count + 1, sizeof *result.now);
    result.before = arena_take(memory, result.g.count + 1, sizeof *result.before);
    result.moved = arena_take(memory, result.g.count + 1, sizeof *result.moved);
    bool *moves = arena_take(memory, result.g.count + 1, sizeof *moves);
    for (size_t i = 0; i < result.g.count; i++) {
        const graph_node *n = &result.g.nodes[i];
        const int operands = operators[n->op].operands;
        moves[i] = operands == 0 ? is_moving(m, n, at_rows) : moves[n->a] || (operands == 2 && moves[n->b]);
        result.switches[i] = (operands == 0 || moves[i]) && (at_rows ? is_comparison(n) : is_switch(n));
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
    case OP_POWER:
        return iso_power(a, b);
    case OP_ATAN2:
        return iso_atan2(a, b);
    default:
        return operators[n->op].value(g, n, at, a, b);
    }
}

void course_evaluate(course *w, const functions *f, const evaluation *at, const double *kept, double *numbers)
{
    for (size_t i = 0; i < f->g.count; i++) {
        const graph_node *n = &f->g.nodes[i];
        numbers[i] = kept != NULL && f->switches[i] ? kept[i] : value_at(&f->g, n, at, numbers[n->a], numbers[n->b]);
    }
    w->evaluated += (double)f->g.count;
}

bool has_switched(const functions *f)
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

void course_inputs(const course *w, const double *numbers, double *u)
{
    for (int i = 0; i < w->m->inputs.count; i++) {
        u[i] = input_in_row(w->m, i, numbers[w->drives.roots[i]]);
    }
}

/* The values of all memories' formulas, by those of inputs and memories now. */
static void find_nexts(course *w, double *numbers)
{
    course_evaluate(w, &w->nexts, &(evaluation){.x = w->x, .u = w->u, .p = w->parameters, .tick = w->tick}, NULL,
                    numbers);
}

/* A row: what is shown of rows before, all memories of effects, then samples and shares. A sample of another one is
 * that of a row before. */
static void advance_memories(course *w)
{
    const mechanism *m = w->m;
    double *u = w->u + m->inputs.count;
    for (int i = 0; i < m->effects.memory_count && w->tick > 0; i++) {
        const effect_quantity *e = &m->effects.memories[i];
        u[i] = is_late(e) ? w->past[i][w->tick % (uint64_t)e->ticks] : u[i];
    }
    swap(&w->nexts.now, &w->nexts.before);
    find_nexts(w, w->nexts.now);
    for (int i = 0; i < m->effects.memory_count && w->tick > 0; i++) {
        u[i] = m->effects.memories[i].kept == KEPT_NEXT ? w->nexts.now[w->nexts.roots[i]] : u[i];
    }
    find_nexts(w, w->nexts.moved);
    for (int i = 0; i < m->effects.memory_count; i++) {
        const effect_quantity *e = &m->effects.memories[i];
        const double found = w->nexts.moved[w->nexts.roots[i]];
        const bool is_due = e->kept == KEPT_SHARE || (e->kept == KEPT_SAMPLE && w->tick % (uint64_t)e->ticks == 0);
        u[i] = is_due && (w->tick > 0 || e->kept == KEPT_SHARE) ? found : u[i];
        if (is_late(e)) {
            w->past[i][w->tick % (uint64_t)e->ticks] = found;
        }
    }
}

/* The inputs, clocks, tunables and memories of a tick. */
static void begin_tick(course *w, uint64_t tick)
{
    const mechanism *m = w->m;
    for (int i = 0; i < m->parameters.change_count; i++) {
        if ((uint64_t)m->parameters.changes[i].tick == tick) {
            w->parameters[m->parameters.changes[i].parameter] = m->parameters.changes[i].value;
        }
    }
    swap(&w->drives.now, &w->drives.before);
    course_evaluate(w, &w->drives, &(evaluation){.p = w->parameters, .tick = tick}, NULL, w->drives.now);
    course_inputs(w, w->drives.now, w->u);
    for (int i = 0; i < m->clocks.count; i++) {
        w->x[m->clocks.first + i] = w->drives.now[w->drives.roots[m->inputs.count + i]];
    }
    if (m->effects.memory_count > 0) {
        advance_memories(w);
    }
}

void course_plant(course *w, const double *x, double *numbers)
{
    course_evaluate(w, &w->plant, &(evaluation){.x = x, .u = w->u, .p = w->parameters, .tick = w->tick}, NULL, numbers);
}

void course_begin(course *w, uint64_t step)
{
    const uint64_t in_tick = (uint64_t)lround(w->m->method.step / w->step);
    w->earlier = w->tick;
    w->tick = step / in_tick;
    memcpy(w->u_before, w->u, (size_t)held_count(w->m) * sizeof *w->u);
    if (step % in_tick == 0) {
        begin_tick(w, w->tick);
    } else {
        memcpy(w->drives.before, w->drives.now, w->drives.g.count * sizeof *w->drives.now);
    }
    swap(&w->plant.now, &w->plant.before);
    course_plant(w, w->x, w->plant.now);
}

bool course_goes_on(const course *w, uint64_t step)
{
    return w->evaluated < most_evaluated && (double)step * w->step < life;
}

bool course_move(course *w, double length)
{
    static const double reach[] = {0.5, 0.5, 1.0}, weight[] = {2.0, 2.0, 1.0};
    const functions *f = &w->plant;
    const double *numbers = f->now;
    bool finite = true;
    memset(w->sum, 0, w->states * sizeof *w->sum);
    for (int k = 0; k < 4; k++) {
        for (size_t i = 0; i < w->states; i++) {
            w->sum[i] += (k == 0 ? 1.0 : weight[k - 1]) * numbers[f->roots[i]];
            w->stage[i] = k < 3 ? w->x[i] + reach[k] * length * numbers[f->roots[i]] : 0.0;
        }
        if (k < 3) {
            course_evaluate(w, f, &(evaluation){.x = w->stage, .u = w->u, .p = w->parameters, .tick = w->tick}, NULL,
                            f->moved);
            numbers = f->moved;
        }
    }
    for (size_t i = 0; i < w->states; i++) {
        w->x_before[i] = w->x[i];
        w->x[i] += length * w->sum[i] / 6.0;
        finite = finite && isfinite(w->x[i]);
    }
    return finite;
}

/* The formulas of memories, and room for their past. */
static void begin_memories(course *w, const graph *g, const plant *p)
{
    const mechanism *m = w->m;
    arena *memory = g->memory;
    const size_t count = (size_t)m->effects.memory_count;
    node *roots = arena_take(memory, count + 1, sizeof *roots);
    graph with_derivatives = graph_copy(g);
    w->past = arena_take(memory, count + 1, sizeof *w->past);
    for (size_t i = 0; i < count; i++) {
        const effect_quantity *e = &m->effects.memories[i];
        const size_t rows = is_late(e) ? (size_t)e->ticks : 0;
        roots[i] = e->next;
        w->u[(size_t)m->inputs.count + i] = e->about.start;
        w->past[i] = arena_take(memory, rows + 1, sizeof **w->past);
        for (size_t k = 0; k < rows; k++) {
            w->past[i][k] = e->about.start;
        }
    }
    replace_leaves(&with_derivatives, roots, count, OP_DERIVATIVE, p->derivatives);
    w->nexts = functions_of(&with_derivatives, m, roots, count, true);
    graph_free(&with_derivatives);
}

course course_of(const graph *g, const plant *p, const node *roots, size_t count)
{
    const mechanism *m = p->m;
    arena *memory = g->memory;
    const int parts = m->method.parts * (m->effects.fast_substeps > 0 ? m->effects.fast_substeps : 1);
    const size_t states = (size_t)state_count(m), inputs = (size_t)held_count(m) + 1;
    course w = {.m = m, .states = states, .step = m->method.step / (double)parts};
    w.plant = functions_of(g, m, roots, count, false);
    const node first_leaf = 0; /* in the place of an input of the port */
    const size_t drives = (size_t)(m->inputs.count + m->clocks.count);
    node *driving = arena_take(memory, drives + 1, sizeof *driving);
    for (size_t i = 0; i < drives; i++) {
        const bool is_clock = i >= (size_t)m->inputs.count;
        driving[i] = is_clock || m->inputs.driven[i] ? m->inputs.drives[i] : first_leaf;
    }
    w.drives = functions_of(g, m, driving, drives, false);
    w.x = mechanism_start(m, memory);
    w.x_before = arena_take(memory, states + 1, sizeof *w.x_before);
    w.stage = arena_take(memory, states + 1, sizeof *w.stage);
    w.sum = arena_take(memory, states + 1, sizeof *w.sum);
    w.u = arena_take(memory, inputs, sizeof *w.u);
    w.u_before = arena_take(memory, inputs, sizeof *w.u_before);
    w.parameters = list_copy(memory, m->parameters.defaults, (size_t)m->parameters.count, sizeof *w.parameters);
    begin_memories(&w, g, p);
    return w;
}

void course_free(course *w)
{
    graph_free(&w->plant.g);
    graph_free(&w->drives.g);
    graph_free(&w->nexts.g);
}
