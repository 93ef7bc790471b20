#include "tools/isoc/plant/plant.h"

#include <math.h>

/* The states, inputs and memories that a formula reads. */
typedef struct readings {
    bool *states, *held;
} readings;

typedef struct rows_builder {
    source *s;
    graph *g;
    plant *p;
    readings of_derivative; /* of an acceleration */
} rows_builder;

static readings no_readings(const rows_builder *b)
{
    const mechanism *m = b->p->m;
    return (readings){arena_take(b->g->memory, (size_t)state_count(m) + 1, sizeof(bool)),
                      arena_take(b->g->memory, (size_t)held_count(m) + 1, sizeof(bool))};
}

/* Adds the leaves that these roots read; an acceleration adds all leaves of the derivative. */
static void add_readings(const rows_builder *b, const node *roots, size_t count, readings *to)
{
    const graph *g = b->g;
    const mechanism *m = b->p->m;
    const bool derives = uses_operation(g, roots, count, OP_DERIVATIVE);
    mark_leaves(g, roots, count, OP_STATE, to->states);
    mark_leaves(g, roots, count, OP_INPUT, to->held);
    for (int i = 0; derives && i < state_count(m); i++) {
        to->states[i] = to->states[i] || b->of_derivative.states[i];
    }
    for (int i = 0; derives && i < held_count(m); i++) {
        to->held[i] = to->held[i] || b->of_derivative.held[i];
    }
}

static readings readings_of(const rows_builder *b, node root)
{
    readings result = no_readings(b);
    add_readings(b, &root, 1, &result);
    return result;
}

/* --- orders --- */

static effect_quantity *quantity_of(const mechanism *m, int which)
{
    return which < state_count(m) ? &m->effects.states[which - m->effects.first_state]
                                  : &m->effects.memories[which - state_count(m)];
}

/* Whether a memory that still waits is among the readings. */
static bool reads_any(const mechanism *m, const readings *r, const bool *waits)
{
    bool any = false;
    for (int i = 0; i < state_count(m); i++) {
        any = any || (r->states[i] && waits[i]);
    }
    for (int i = 0; i < m->effects.memory_count; i++) {
        any = any || (r->held[m->inputs.count + i] && waits[state_count(m) + i]);
    }
    return any;
}

/* Puts those that wait in an order in which each reads only those before it. Returns the first without a place, or -1.
 */
static int put_in_order(const rows_builder *b, bool *waits, const readings *reads, row_order *result)
{
    const mechanism *m = b->p->m;
    const int all = state_count(m) + m->effects.memory_count;
    result->all = arena_take(b->g->memory, (size_t)all + 1, sizeof *result->all);
    result->level = arena_take(b->g->memory, (size_t)all + 1, sizeof *result->level);
    int first = -1;
    for (int before = -1; before < result->count; result->levels++) {
        before = result->count;
        for (int i = 0; i < all; i++) {
            if (waits[i] && !reads_any(m, &reads[i], waits)) {
                result->all[result->count] = i;
                result->level[result->count++] = result->levels;
            }
        }
        for (int i = before; i < result->count; i++) {
            waits[result->all[i]] = false;
        }
    }
    result->levels = result->count == 0 ? 0 : result->level[result->count - 1] + 1;
    for (int i = all; i-- > 0;) {
        first = waits[i] ? i : first;
    }
    return first;
}

static readings *room_for_readings(const rows_builder *b)
{
    const mechanism *m = b->p->m;
    return arena_take(b->g->memory, (size_t)(state_count(m) + m->effects.memory_count) + 1, sizeof(readings));
}

/* --- samples --- */

/* Marks the samples that a `next` reads, and those that these read. */
static void find_early(const rows_builder *b, bool *is_early)
{
    const mechanism *m = b->p->m;
    readings r = no_readings(b);
    for (int i = 0; i < m->effects.memory_count; i++) {
        if (m->effects.memories[i].kept == KEPT_NEXT) {
            add_readings(b, &m->effects.memories[i].next, 1, &r);
        }
    }
    for (bool more = true; more;) {
        more = false;
        for (int i = 0; i < m->effects.memory_count; i++) {
            bool *is = &is_early[state_count(m) + i];
            if (m->effects.memories[i].kept == KEPT_SAMPLE && r.held[m->inputs.count + i] && !*is) {
                *is = more = true;
                add_readings(b, &m->effects.memories[i].next, 1, &r);
            }
        }
    }
}

/* Whether a reading of a formula is set after the early samples. */
static bool reads_new(const mechanism *m, const readings *r, const bool *is_late_sample)
{
    bool any = false;
    for (int i = 0; i < m->effects.memory_count; i++) {
        any = any || (r->held[m->inputs.count + i] &&
                      (m->effects.memories[i].kept == KEPT_NEXT || is_late_sample[state_count(m) + i]));
    }
    return any;
}

static void order_samples(rows_builder *b)
{
    const mechanism *m = b->p->m;
    const int states = state_count(m);
    const size_t all = (size_t)(states + m->effects.memory_count) + 1;
    bool *is_early = arena_take(b->g->memory, all, sizeof *is_early),
         *is_after = arena_take(b->g->memory, all, sizeof *is_after);
    readings *reads = room_for_readings(b);
    find_early(b, is_early);
    for (int i = 0; i < m->effects.memory_count; i++) {
        if (m->effects.memories[i].kept == KEPT_SAMPLE) {
            reads[states + i] = readings_of(b, m->effects.memories[i].next);
            is_after[states + i] = !is_early[states + i];
        }
    }
    for (bool more = true; more;) {
        more = false;
        for (int i = 0; i < m->effects.memory_count; i++) {
            const bool is_new = m->effects.memories[i].kept == KEPT_SAMPLE && !is_after[states + i] &&
                                reads_new(m, &reads[states + i], is_after);
            is_after[states + i] = is_after[states + i] || is_new;
            more = more || is_new;
        }
    }
    const int stuck = put_in_order(b, is_early, reads, &b->p->rows.early);
    const int stuck_after = put_in_order(b, is_after, reads, &b->p->rows.late);
    if (stuck >= 0 || stuck_after >= 0) {
        source_problem(b->s, quantity_of(m, stuck >= 0 ? stuck : stuck_after)->at,
                       "an algebraic loop: in a row that it samples, this needs itself; previous(x, START) breaks it");
    }
}

/* --- next values of slow memories --- */

/* The place of a memory's rate among those of slow memories, by its first memory; that of each row is the last. */
static int rate_place(const mechanism *m, int memory)
{
    const effect_quantity *all = m->effects.memories;
    int first = 0;
    while (!is_same_rate(all[first].rate, all[memory].rate) || all[first].kept != KEPT_NEXT) {
        first++;
    }
    return is_slow(all[memory].rate) ? first : m->effects.memory_count;
}

/* Memories change together, but those of each rate are set by a function of its own, each row's by the last. A memory
 * that a later one of these reads waits for it. */
static void find_coming(rows_builder *b, const plant *whole)
{
    const mechanism *m = b->p->m;
    row_plan *result = &b->p->rows;
    if (whole != NULL) {
        result->coming = whole->rows.coming;
        result->coming_count = whole->rows.coming_count;
        return;
    }
    const effect_quantity *all = m->effects.memories;
    readings *reads = room_for_readings(b);
    result->coming = arena_take(b->g->memory, (size_t)m->effects.memory_count + 1, sizeof *result->coming);
    for (int n = 0; n < m->effects.memory_count && has_slow_memories(m); n++) {
        reads[n] = readings_of(b, all[n].next);
    }
    for (int i = 0; i < m->effects.memory_count; i++) {
        bool waits = false;
        for (int n = 0; n < m->effects.memory_count && all[i].kept == KEPT_NEXT && is_slow(all[i].rate); n++) {
            waits = waits || (all[n].kept == KEPT_NEXT && rate_place(m, n) > rate_place(m, i) &&
                              reads[n].held[m->inputs.count + i]);
        }
        result->coming[i] = waits ? result->coming_count++ : -1;
    }
}

/* --- starts --- */

/* The numbers of a level, from those before it. */
static void evaluate_level(rows_builder *b, const row_order *order, int level, double *x, double *u)
{
    const mechanism *m = b->p->m;
    graph g = graph_copy(b->g);
    node *roots = arena_take(g.memory, (size_t)order->count + 1, sizeof *roots);
    for (int i = 0; i < order->count; i++) {
        roots[i] = quantity_of(m, order->all[i])->begin;
    }
    if (uses_operation(&g, roots, (size_t)order->count, OP_DERIVATIVE)) {
        replace_leaves(&g, roots, (size_t)order->count, OP_DERIVATIVE, b->p->derivatives);
    }
    double *numbers = arena_take(g.memory, g.count, sizeof *numbers);
    graph_evaluate(&g, 0, &(evaluation){.x = x, .u = u, .p = m->parameters.at_start}, numbers);
    for (int i = 0; i < order->count; i++) {
        const int which = order->all[i];
        if (order->level[i] == level) {
            double *to = which < state_count(m) ? &x[which] : &u[m->inputs.count + which - state_count(m)];
            *to = quantity_of(m, which)->about.start = numbers[roots[i]];
        }
    }
    arena_return(g.memory, numbers, g.count, sizeof *numbers);
    graph_free(&g);
}

static void find_start_numbers(rows_builder *b, const row_order *order)
{
    const mechanism *m = b->p->m;
    double *u = inputs_at_start(b->g, m), *x = mechanism_start(m, b->g->memory);
    for (int level = 0; level < order->levels; level++) {
        evaluate_level(b, order, level, x, u);
    }
}

/* Constant starts are known; of the rest each start comes after its readings. */
static void order_starts(rows_builder *b)
{
    const mechanism *m = b->p->m;
    const int states = state_count(m);
    bool *waits = arena_take(b->g->memory, (size_t)(states + m->effects.memory_count) + 1, sizeof *waits);
    readings *reads = room_for_readings(b);
    for (int n = 0; n < m->effects.state_count + m->effects.memory_count; n++) {
        const int i = n < m->effects.state_count ? m->effects.first_state + n : states + n - m->effects.state_count;
        effect_quantity *e = quantity_of(m, i);
        waits[i] = !is_constant(b->g, e->begin);
        e->about.start = waits[i] ? 0.0 : constant_value(b->g, e->begin);
        if (waits[i]) {
            reads[i] = readings_of(b, e->begin);
        }
    }
    const int stuck = put_in_order(b, waits, reads, &b->p->rows.starts);
    if (stuck >= 0) {
        source_problem(b->s, quantity_of(m, stuck)->at,
                       "an algebraic loop: the start of '%s' needs itself; a memory with a start of its own, or "
                       "previous(x, START), breaks it",
                       quantity_of(m, stuck)->about.name);
        return;
    }
    find_start_numbers(b, &b->p->rows.starts);
}

/* --- functions of time --- */

/* Whether an input can come from a segment. */
static bool is_wired(const mechanism *m, int input)
{
    bool is = false;
    for (int i = 0; i < m->inputs.wire_count; i++) {
        is = is || m->inputs.wires[i].input == input;
    }
    return is;
}

static node within_limits(graph *g, const variable *v, node n)
{
    const node below = isinf(v->most) ? n : function(g, OP_MIN, n, constant(g, v->most));
    return isinf(v->least) ? below : larger(g, below, constant(g, v->least));
}

static void mark_inputs(graph *g, node *roots, size_t count, void *context)
{
    mark_leaves(g, roots, count, OP_INPUT, context);
}

/* The rows in which inputs are read: those of a rate, where all memories and outputs that read one have it, and nothing
 * within a step does; else each. */
static row_rate *find_sees_at(rows_builder *b)
{
    const mechanism *m = b->p->m;
    row_rate *rates = arena_take(b->g->memory, (size_t)m->inputs.count + 1, sizeof *rates);
    bool *is_in_step = arena_take(b->g->memory, (size_t)held_count(m) + 1, sizeof *is_in_step);
    for_roots(b->g, m, false, mark_inputs, is_in_step);
    for (int n = 0; n < m->effects.memory_count && has_slow_memories(m); n++) {
        const readings r = readings_of(b, m->effects.memories[n].next);
        for (int i = 0; i < m->inputs.count; i++) {
            const row_rate own = m->effects.memories[n].rate;
            const bool is_new = rates[i].every < 1.0, is_same = is_new || is_same_rate(rates[i], own);
            rates[i] = !r.held[i] ? rates[i] : is_same ? own : each_row;
        }
    }
    for (int i = 0; i < m->inputs.count; i++) {
        rates[i] = is_in_step[i] || b->of_derivative.held[i] || rates[i].every < 1.0 ? each_row : rates[i];
    }
    return rates;
}

static void find_seen(rows_builder *b, const plant *whole)
{
    const mechanism *m = b->p->m;
    row_plan *result = &b->p->rows;
    if (whole != NULL) {
        result->sees = whole->rows.sees;
        result->sees_at = whole->rows.sees_at;
        result->sees_again = whole->rows.sees_again;
        result->any = whole->rows.any;
        return;
    }
    readings r = no_readings(b);
    add_readings(b, b->p->outputs.roots, (size_t)b->p->outputs.count, &r);
    for (int i = 0; i < m->effects.memory_count; i++) {
        add_readings(b, &m->effects.memories[i].next, 1, &r);
    }
    result->sees = arena_take(b->g->memory, (size_t)m->inputs.count + 1, sizeof *result->sees);
    result->sees_again = arena_take(b->g->memory, (size_t)m->inputs.count + 1, sizeof *result->sees_again);
    result->sees_at = find_sees_at(b);
    result->any = m->parameters.change_count > 0;
    for (int i = 0; i < m->inputs.count; i++) {
        const bool is = r.held[i] && m->inputs.driven[i] && !is_wired(m, i);
        result->sees[i] = is ? within_limits(b->g, &m->inputs.all[i], m->inputs.drives[i]) : -1;
        result->sees_again[i] = is && (result->sees[i] != m->inputs.drives[i] ||
                                       uses_operation(b->g, &m->inputs.drives[i], 1, OP_PARAMETER));
        result->any = result->any || is;
    }
}

void rows_build(source *s, graph *g, plant *p, const plant *whole)
{
    rows_builder b = {.s = s, .g = g, .p = p};
    b.of_derivative = no_readings(&b);
    add_readings(&b, p->derivatives, (size_t)state_count(p->m), &b.of_derivative);
    order_samples(&b);
    find_coming(&b, whole);
    order_starts(&b);
    find_seen(&b, whole);
}
