/* Shares of a step (tools/isoc/formula/shares.c). What changes in a step does so, to first order, by the derivatives at
 * its begin. There a share is 1 or 0, as its condition is; so a condition may be of what the share itself acts on. The
 * wave of a pwm is known before the step: the conditions of others see its share. */
#include "tools/isoc/plant/plant.h"

#include <string.h>

static effect_quantity *share_at(const mechanism *m, int i)
{
    effect_quantity *e = &m->effects.memories[i];
    return e->kept == KEPT_SHARE ? e : NULL;
}

int count_shares(const mechanism *m)
{
    int count = 0;
    for (int i = 0; i < m->effects.memory_count; i++) {
        count += share_at(m, i) != NULL;
    }
    return count;
}

static bool is_of_wave(const effect_quantity *e)
{
    return e->ticks > 0.0;
}

/* The root with these nodes in the place of the changes of all others: by[nodes], -1 where none is. */
static node with_changes(graph *g, node root, size_t before, const node *by)
{
    node *to = all_nodes(g);
    for (size_t i = 0; i < before; i++) {
        to[i] = by[i] >= 0 ? by[i] : to[i];
    }
    replace_nodes(g, &root, 1, g->count, to);
    return root;
}

/* The share with all changes zero: whether it holds at the begin of the step. */
static node begin_of(graph *g, node share)
{
    const size_t before = g->count;
    node *by = arena_take(g->memory, before, sizeof *by);
    const node zero = constant(g, 0.0);
    for (size_t i = 0; i < before; i++) {
        by[i] = g->nodes[i].op == OP_CHANGE ? zero : -1;
    }
    return with_changes(g, share, before, by);
}

/* The changes of the inputs in a step: of `time`, and of the steps in the period of a wave. */
static node *changes_of_inputs(graph *g, const mechanism *m)
{
    node *changes = zero_nodes(g, (size_t)held_count(m) + 1);
    for (int i = 0; i < m->inputs.count; i++) {
        const int which = m->inputs.time_input_of[i];
        const char *word = which < 0 ? "" : m->inputs.time_inputs[which].word;
        changes[i] = strcmp(word, "time") == 0  ? constant(g, m->method.step)
                     : strcmp(word, "pwm") == 0 ? constant(g, 1.0)
                                                : changes[i];
    }
    return changes;
}

/* The share with the changes of its values, where the states change by along[] and the inputs by inputs[]. */
static node with_rates(graph *g, node share, const node *along, const node *inputs)
{
    const size_t before = g->count;
    node *by = arena_take(g->memory, before, sizeof *by);
    memset(by, -1, before * sizeof *by);
    for (reached r = reach(g, &share, 1); reach_next(&r);) {
        if (r.n->op == OP_CHANGE) {
            const node shared = r.n->a;
            differentiate_along(g, &shared, 1, along, inputs, &by[r.at]);
        }
    }
    return with_changes(g, share, before, by);
}

/* Puts the shares in their last form: those of waves, or the others, with their states in leaves[] at the begin. */
static void resolve(const plant *p, graph *g, bool of_waves, node *leaves, const node *inputs)
{
    const mechanism *m = p->m;
    const size_t states = (size_t)state_count(m);
    node *along = list_copy(g->memory, p->derivatives, states, sizeof *along);
    replace_leaves(g, along, states, OP_INPUT, leaves);
    for (size_t i = 0; i < states; i++) {
        along[i] = mul(g, constant(g, m->method.step), along[i]);
    }
    for (int i = 0; i < m->effects.memory_count; i++) {
        effect_quantity *e = share_at(m, i);
        if (e != NULL && is_of_wave(e) == of_waves) {
            e->begin = e->next = leaves[m->inputs.count + i] = with_rates(g, e->next, along, inputs);
        }
    }
}

void shares_build(const plant *p, graph *g)
{
    const mechanism *m = p->m;
    node *leaves = arena_take(g->memory, (size_t)held_count(m) + 1, sizeof *leaves);
    for (int i = 0; i < held_count(m); i++) {
        leaves[i] = leaf(g, OP_INPUT, i);
    }
    graph_section(g, "Shares of a step");
    for (int i = 0; i < m->effects.memory_count; i++) {
        if (share_at(m, i) != NULL) {
            leaves[m->inputs.count + i] = begin_of(g, share_at(m, i)->next);
        }
    }
    if (count_shares(m) > 0) {
        const node *inputs = changes_of_inputs(g, m);
        resolve(p, g, true, leaves, inputs);
        resolve(p, g, false, leaves, inputs);
    }
}

operations cost_of_shares(const plant *p, const graph *g)
{
    const mechanism *m = p->m;
    node *roots = arena_take(g->memory, (size_t)m->effects.memory_count + 1, sizeof *roots);
    size_t count = 0;
    for (int i = 0; i < m->effects.memory_count; i++) {
        if (share_at(m, i) != NULL) {
            roots[count++] = share_at(m, i)->next;
        }
    }
    return count_operations(g, roots, count);
}
