/* The events of a plant as nodes: their functions, the rates of these, and what they set. */
#include "core/methods/hold.h"
#include "tools/isoc/plant/plant.h"

/* Adds one state that an event sets. */
static void add_set(event_plan *to, int owner, int index, node root)
{
    to->states[to->set_count] = index;
    to->owners[to->set_count] = owner;
    to->values[to->set_count++] = root;
}

/* The speeds that an event gives, and all others that change with them. */
static void add_impulse(const plant *p, event_plan *to, int owner)
{
    const mechanism *m = p->m;
    const event *e = &m->events.all[owner];
    given_speed *wanted = arena_take(p->d->g->memory, (size_t)e->set_count, sizeof *wanted);
    int count = 0;
    FOR_ALL (const event_set, set, e->sets, e->set_count) {
        if (is_impulse(set)) {
            wanted[count++] = (given_speed){set->dof, set->speed, set->to};
        }
    }
    if (count == 0) {
        return;
    }
    const node *speeds = impulse_build(p->d, wanted, count);
    for (int f = 0; f < m->dof_count; f++) {
        if (speeds[f] >= 0) {
            add_set(to, owner, m->position_count + f, speeds[f]);
        }
    }
}

/* The states that the function of an event reads. */
static void add_reads(event_plan *to, const graph *g, int i, int states)
{
    bool *is_read = arena_take(g->memory, (size_t)states, sizeof *is_read);
    mark_leaves(g, &to->functions[2 * i], 1, OP_STATE, is_read);
    to->ends[i] = i == 0 ? 0 : to->ends[i - 1];
    for (int s = 0; s < states; s++) {
        if (is_read[s]) {
            to->reads[to->ends[i]++] = s;
        }
    }
    arena_return(g->memory, is_read, (size_t)states, sizeof *is_read);
}

/* The energy before an event less that behind it, added to the sum of these. */
static void add_loss(const plant *p, graph *g, event_plan *to, int owner, int first)
{
    const mechanism *m = p->m;
    const int states = state_count(m);
    if (m->events.loss_state < 0) {
        return;
    }
    node *behind = arena_take(g->memory, (size_t)states, sizeof *behind);
    for (int i = 0; i < states; i++) {
        behind[i] = leaf(g, OP_STATE, i);
    }
    for (int k = first; k < to->set_count; k++) {
        behind[to->states[k]] = to->values[k];
    }
    kinematics_velocities(&p->d->k);
    const node before = account_energy(p->d);
    node after = before;
    replace_leaves(g, &after, 1, OP_STATE, behind);
    const node lost = sub(g, before, after);
    add_set(to, owner, m->events.loss_state, add(g, leaf(g, OP_STATE, m->events.loss_state), lost));
}

/* The numbers of holds, by which core/methods/hold.h finds their changes. */
static node *hold_numbers_of(const plant *p, graph *g)
{
    const mechanism *m = p->m;
    const hold_equations *found = &p->d->holds;
    const int n = m->events.hold_count;
    node *result = arena_take(g->memory, ISO_HOLD_NUMBERS(n), sizeof *result), *next = result + ISO_HOLD_PARTS * n;
    graph_section(g, "Numbers of holds");
    for (int i = 0; i < n; i++) {
        const held_speed *h = &m->events.holds[i];
        result[ISO_HOLD_SPEED * n + i] = leaf(g, OP_STATE, m->position_count + h->dof);
        if (h->against >= 0) {
            result[i] = sub(g, result[i], leaf(g, OP_STATE, m->position_count + h->against));
        }
        result[ISO_HOLD_FREE * n + i] = found->free[i];
        result[ISO_HOLD_LEAST * n + i] = neg(g, h->limit);
        result[ISO_HOLD_MOST * n + i] = h->limit;
        result[ISO_HOLD_FORWARD * n + i] = neg(g, h->sliding);
        result[ISO_HOLD_BACK * n + i] = h->sliding;
        for (int j = 0; j <= i; j++) {
            *next++ = found->mobility[i * n + j];
        }
    }
    return result;
}

void event_plan_build(plant *p, graph *g)
{
    const mechanism *m = p->m;
    event_plan *to = &p->events;
    if (m->events.hold_count > 0) {
        to->hold_numbers = hold_numbers_of(p, g);
    }
    const size_t count = (size_t)m->events.count, states = (size_t)state_count(m);
    if (count == 0) {
        return;
    }
    size_t room = count * (size_t)(m->dof_count + 1);
    FOR_ALL (const event, e, m->events.all, m->events.count) {
        room += (size_t)e->set_count;
    }
    to->functions = arena_take(g->memory, 2 * count, sizeof *to->functions);
    to->moves = arena_take(g->memory, count, sizeof *to->moves);
    to->reads = arena_take(g->memory, count * states, sizeof *to->reads);
    to->ends = arena_take(g->memory, count, sizeof *to->ends);
    to->states = arena_take(g->memory, room, sizeof *to->states);
    to->owners = arena_take(g->memory, room, sizeof *to->owners);
    to->values = arena_take(g->memory, room, sizeof *to->values);
    node *along = arena_take(g->memory, states, sizeof *along);
    for (size_t i = 0; i < states; i++) {
        along[i] = leaf(g, OP_DERIVATIVE, (int)i);
    }
    for (int i = 0; i < m->events.count; i++) {
        const event *e = &m->events.all[i];
        const int first = to->set_count;
        FOR_ALL (const event_set, set, e->sets, e->set_count) {
            if (!is_impulse(set)) {
                add_set(to, i, set->state, set->to);
            }
        }
        add_impulse(p, to, i);
        add_loss(p, g, to, i, first);
        graph_section(g, "The function of an event, and its rate");
        to->functions[2 * i] = e->function;
        add_reads(to, g, i, (int)states);
        differentiate_along(g, &e->function, 1, along, NULL, &to->functions[2 * i + 1]);
        for (int k = first; k < to->set_count; k++) {
            to->moves[i] = to->moves[i] || uses_leaf(g, &e->function, 1, leaf(g, OP_STATE, to->states[k]));
        }
    }
}

int evaluations_of_events(const mechanism *m)
{
    return !has_events(m) ? 0 : m->events.slots * (1 + ISO_STAGES_OF(m->events.rest));
}

/* Of holds, besides the evaluations: their numbers at the begin of a step, and in a slot at its end, near the first
 * change and at it, each with a solution for the efforts; and the passes, each with one more and a comparison of all.
 */
static operations cost_of_holds(const mechanism *m, const event_plan *plan, const graph *g)
{
    enum { FIXED = 4 };
    const int n = m->events.hold_count, passes = n < 2 ? 3 : 2 * n - 1;
    const int square = n * n, cube = n * square / 6;
    const operations solution = {.add = 3 * square + cube, .mul = 3 * square + 2 * cube, .div = n};
    const operations comparison = {.add = square + 8 * n, .mul = square + n, .div = 3 * n};
    operations once = {0}, all = {0};
    if (n == 0) {
        return all;
    }
    once = operations_plus(solution, 1, count_operations(g, plan->hold_numbers, ISO_HOLD_NUMBERS(n)));
    all = operations_plus(all, 1 + (FIXED - 1) * m->events.slots, once);
    all = operations_plus(all, m->events.slots * (1 + passes), solution);
    return operations_plus(all, m->events.slots * passes, comparison);
}

/* In a slot: the cubic at the place of the event, and at one for the function of each, which is known at four; what is
 * set; the derivative at the end of the trial and in the rest of the step. */
operations cost_of_events(const plant *p, const graph *g)
{
    const mechanism *m = p->m;
    const event_plan *plan = &p->events;
    const int n = state_count(m), events = m->events.count;
    const operations cubic = {.add = 7, .mul = 8}, choice = {.add = 8, .mul = 3, .div = 3};
    const operations rest = {.add = ISO_SUMS_OF(m->events.rest) + 1, .mul = ISO_PRODUCTS_OF(m->events.rest)};
    operations functions = {0}, slot = {0};
    if (plan->functions == NULL && plan->hold_numbers == NULL) { /* none, or not yet */
        return slot;
    }
    for (int i = 0; i < events; i++) {
        functions = operations_plus(functions, 1, count_operations(g, &plan->functions[2 * i], 2));
    }
    const operations derivative = count_operations(g, p->derivatives, (size_t)n);
    slot = operations_plus(slot, evaluations_of_events(m) / m->events.slots, derivative);
    slot = operations_plus(slot, (events == 0 ? 0 : plan->ends[events - 1]) + n, cubic);
    slot = operations_plus(slot, events, choice);
    slot = operations_plus(slot, 4, functions);
    slot = operations_plus(slot, n, rest);
    slot = operations_plus(slot, 1, count_operations(g, plan->values, (size_t)plan->set_count));
    const operations whole = operations_plus(cost_of_holds(m, plan, g), 2, functions);
    return operations_plus(whole, m->events.slots, slot);
}
