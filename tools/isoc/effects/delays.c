/* Delays that the equations read. A delay of a moving quantity has samples of a continuous signal: within a step the
 * method evaluates the polynomial through its samples, as for a smooth input (core/methods/inputs.h), so that each
 * stage reads x(t - tau) at its own time. A delay of a quantity that is constant within a step is constant too. */
#include <string.h>

#include "tools/isoc/effects/effects.h"

/* The operands of a formula besides parameters. */
typedef struct kinds_read {
    bool moving, held;
} kinds_read;

static bool is_delay(const mechanism *m, int input)
{
    return input >= m->inputs.count && m->effects.memories[input - m->inputs.count].kept == KEPT_DELAY;
}

/* Quantities that change at the end of a step only. */
static bool jumps(quantity_kind kind)
{
    return kind == QUANTITY_TURNS || quantity_rows[kind].owner == OF_STEP;
}

/* A delay reads the same kinds as its formula; delays of delays are followed to the depth of their number. */
static kinds_read reads(const builder *b, node root, int depth)
{
    const mechanism *m = &b->mechanism;
    kinds_read found = {false, false};
    for (reached r = reach(b->g, &root, 1); reach_next(&r);) {
        const graph_node *n = r.n;
        if (n->op != OP_STATE && n->op != OP_QUERY && n->op != OP_DERIVATIVE && n->op != OP_INPUT) {
            continue;
        }
        if (n->op == OP_INPUT && is_delay(m, n->index) && depth < m->effects.memory_count) {
            const kinds_read k = reads(b, m->effects.memories[n->index - m->inputs.count].next, depth + 1);
            found = (kinds_read){found.moving || k.moving, found.held || k.held};
        } else if ((n->op == OP_INPUT && !(n->index < m->inputs.count && m->inputs.smooth[n->index])) ||
                   (n->op == OP_QUERY && jumps(m->queries.all[n->index / QUERY_PARTS].kind))) {
            found.held = true;
        } else {
            found.moving = true;
        }
    }
    return found;
}

/* Marks the inputs and memories that rates and efforts read. */
static void mark_equations(const builder *b, bool *marked)
{
    const mechanism *m = &b->mechanism;
    mark_leaves(b->g, m->effects.efforts, (size_t)m->dof_count, OP_INPUT, marked);
    for (int i = 0; i < m->forces.applied_count; i++) {
        if (m->forces.applied[i].drive < 0) {
            mark_leaves(b->g, m->forces.applied[i].force.at, 3, OP_INPUT, marked);
            mark_leaves(b->g, m->forces.applied[i].moment.at, 3, OP_INPUT, marked);
        }
    }
    for (int i = 0; i < m->effects.state_count; i++) {
        mark_leaves(b->g, &m->effects.states[i].next, 1, OP_INPUT, marked);
    }
}

/* Whether steps have samples: those of one length, by one method. */
static bool has_samples(const mechanism *m)
{
    return m->method.parts == 1 && m->effects.fast_substeps == 0 && m->policies.rung_count == 0 && !has_events(m);
}

void build_delays(builder *b)
{
    mechanism *m = &b->mechanism;
    bool *smooth = arena_take(b->s->memory, (size_t)held_count(m) + 1, sizeof *smooth);
    bool *read = arena_take(b->s->memory, (size_t)held_count(m) + 1, sizeof *read);
    const unsigned with_samples = m->method.recipe | ISO_SMOOTH;
    m->inputs.sampled_count = m->inputs.count;
    memcpy(smooth, m->inputs.smooth, (size_t)m->inputs.count * sizeof *smooth);
    mark_equations(b, read);
    for (int i = m->inputs.count; i < held_count(m); i++) {
        if (!read[i] || !is_delay(m, i)) {
            continue;
        }
        effect_quantity *e = &m->effects.memories[i - m->inputs.count];
        const kinds_read kinds = reads(b, e->next, 0);
        const bool is_sampled = kinds.moving && !kinds.held && has_samples(m);
        e->lags = kinds.moving && !is_sampled;
        smooth[i] = is_sampled && ISO_DEGREE(with_samples) > 0;
        if (smooth[i]) {
            m->method.recipe = with_samples;
            m->inputs.sampled_count = held_count(m);
        }
    }
    m->inputs.smooth = smooth;
}
