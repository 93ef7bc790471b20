/* Delays that the equations read. One of what moves is a sample of a continuous signal: within a step the method has the
 * polynomial through its samples, as of a smooth input (core/methods/inputs.h), so that it stands for x(t - tau) at the time
 * of each stage. One of what is constant within a step is constant too. */
#include "tools/isoc/mechanism/builder.h"

/* What a formula reads besides parameters. */
typedef struct kinds_read {
    bool moving, held;
} kinds_read;

static bool is_delay(const mechanism *made, int input)
{
    return input >= made->input_count && made->memories[input - made->input_count].kept == KEPT_DELAY;
}

/* A delay is as what it is of: of delays one after the other, at most all of them. */
static kinds_read reads(const builder *b, node root, int depth)
{
    const graph *g = b->g;
    const mechanism *made = &b->made;
    bool *needed = arena_take(g->memory, g->count, sizeof *needed);
    kinds_read found = {false, false};
    graph_reach(g, &root, 1, needed);
    for (size_t i = 0; i < g->count; i++) {
        const graph_node *n = &g->nodes[i];
        if (!needed[i] ||
            (n->op != OP_STATE && n->op != OP_POINT_QUERY && n->op != OP_DERIVATIVE && n->op != OP_INPUT)) {
            continue;
        }
        if (n->op == OP_INPUT && is_delay(made, n->index) && depth < made->memory_count) {
            const kinds_read of = reads(b, made->memories[n->index - made->input_count].next, depth + 1);
            found = (kinds_read){found.moving || of.moving, found.held || of.held};
        } else if (n->op == OP_INPUT && !(n->index < made->input_count && made->smooth[n->index])) {
            found.held = true;
        } else {
            found.moving = true;
        }
    }
    arena_return(g->memory, needed, g->count, sizeof *needed);
    return found;
}

static void mark(const graph *g, const node *roots, size_t count, bool *marked)
{
    bool *needed = arena_take(g->memory, g->count, sizeof *needed);
    graph_reach(g, roots, count, needed);
    for (size_t i = 0; i < g->count; i++) {
        if (needed[i] && g->nodes[i].op == OP_INPUT) {
            marked[g->nodes[i].index] = true;
        }
    }
    arena_return(g->memory, needed, g->count, sizeof *needed);
}

/* Marks the inputs and memories that rates and efforts read. */
static void mark_equations(const builder *b, bool *marked)
{
    const mechanism *made = &b->made;
    mark(b->g, made->efforts, (size_t)made->dof_count, marked);
    for (int i = 0; i < made->applied_force_count; i++) {
        if (made->applied_forces[i].drive < 0) {
            mark(b->g, made->applied_forces[i].force.at, 3, marked);
            mark(b->g, made->applied_forces[i].moment.at, 3, marked);
        }
    }
    for (int i = 0; i < made->effect_state_count; i++) {
        mark(b->g, &made->effect_states[i].next, 1, marked);
    }
}

/* Whether steps have samples: those of one length, by one method. */
static bool has_samples(const mechanism *made)
{
    return made->parts == 1 && made->fast_substeps == 0 && made->policies.rung_count == 0;
}

void build_delays(builder *b)
{
    mechanism *made = &b->made;
    bool *smooth = arena_take(b->s->memory, (size_t)held_count(made) + 1, sizeof *smooth);
    bool *read = arena_take(b->s->memory, (size_t)held_count(made) + 1, sizeof *read);
    const unsigned with_samples = made->recipe | ISO_SMOOTH;
    made->sampled_count = made->input_count;
    for (int i = 0; i < made->input_count; i++) {
        smooth[i] = made->smooth[i];
    }
    mark_equations(b, read);
    for (int i = made->input_count; i < held_count(made); i++) {
        if (!read[i] || !is_delay(made, i)) {
            continue;
        }
        effect_quantity *of = &made->memories[i - made->input_count];
        const kinds_read kinds = reads(b, of->next, 0);
        const bool is_sampled = kinds.moving && !kinds.held && has_samples(made);
        of->lags = kinds.moving && !is_sampled;
        smooth[i] = is_sampled && ISO_DEGREE(with_samples) > 0;
        if (smooth[i]) {
            made->recipe = with_samples;
            made->sampled_count = held_count(made);
        }
    }
    made->smooth = smooth;
}
