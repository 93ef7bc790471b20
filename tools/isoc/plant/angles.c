/* Angles: a stage takes their sines from those of the start of the step. It needs no angle that the derivative reads by
 * its sine and cosine alone. */
#include "tools/isoc/plant/plant.h"

/* The state of which a node is the sine or the cosine; -1 where it is none. */
static int turned_state(const graph *g, const graph_node *n)
{
    const bool is_sine = n->op == OP_SIN || n->op == OP_COS;
    return is_sine && g->nodes[n->a].op == OP_STATE ? g->nodes[n->a].index : -1;
}

const bool *turned_states(const graph *g, const mechanism *m, const node *roots, size_t count)
{
    bool *is_turned = arena_take(g->memory, (size_t)state_count(m), sizeof *is_turned);
    for (reached r = reach(g, roots, count); reach_next(&r);) {
        if (turned_state(g, r.n) >= 0) {
            is_turned[turned_state(g, r.n)] = true;
        }
    }
    return is_turned;
}

/* Whether the derivative has sine and cosine of the state: one alone is had for less than by addition. */
static bool has_both(const graph *g, const node *derivatives, size_t states, int angle)
{
    bool has_sine = false, has_cosine = false;
    for (reached r = reach(g, derivatives, states); reach_next(&r);) {
        if (turned_state(g, r.n) == angle) {
            has_sine |= r.n->op == OP_SIN;
            has_cosine |= r.n->op == OP_COS;
        }
    }
    return has_sine && has_cosine;
}

/* The angles of turning joints of which the derivative has sine or cosine, where the method has several stages. In a
 * step they turn little, but for one that is continuous. */
static void find_angles(sine_states *angles, const graph *g, const mechanism *m, const node *derivatives,
                        bool *is_angle)
{
    const bool *is_turned = turned_states(g, m, derivatives, (size_t)state_count(m));
    FOR_ALL (const segment, l, m->segments, m->segment_count) {
        const bool by_addition = !l->continuous || has_both(g, derivatives, (size_t)state_count(m), l->position);
        if (l->kind == JOINT_REVOLUTE && is_turned[l->position] && by_addition) {
            is_angle[l->position] = true;
            angles->spins[angles->count] = l->continuous;
            angles->spin_count += l->continuous;
            angles->all[angles->count++] = l->position;
        }
    }
}

static void note_state(const graph *g, node i, bool *is_read)
{
    if (g->nodes[i].op == OP_STATE) {
        is_read[g->nodes[i].index] = true;
    }
}

/* The states that the derivative reads not only by the sines of angles. */
static bool *find_read(const graph *g, const node *derivatives, size_t states, const bool *is_angle)
{
    bool *is_read = arena_take(g->memory, states, sizeof *is_read);
    for (reached r = reach(g, derivatives, states); reach_next(&r);) {
        const int turned = turned_state(g, r.n), operands = operators[r.n->op].operands;
        const node read[] = {r.n->a, r.n->b};
        for (int i = 0; i < operands && (turned < 0 || !is_angle[turned]); i++) {
            note_state(g, read[i], is_read);
        }
    }
    for (size_t i = 0; i < states; i++) {
        note_state(g, derivatives[i], is_read);
    }
    return is_read;
}

sine_states angles_build(const graph *g, const mechanism *m, const node *derivatives)
{
    const size_t states = (size_t)state_count(m);
    sine_states result = {.all = arena_take(g->memory, states, sizeof *result.all),
                          .spins = arena_take(g->memory, states, sizeof *result.spins)};
    if (ISO_BY_SINES(m->method.recipe) && fast_build(g, m, derivatives).count == 0) {
        bool *is_angle = arena_take(g->memory, states, sizeof *is_angle);
        find_angles(&result, g, m, derivatives, is_angle);
        const bool *is_read = find_read(g, derivatives, states, is_angle);
        while (result.unread < (int)states && !is_read[result.unread]) {
            result.unread++;
        }
    }
    return result;
}
