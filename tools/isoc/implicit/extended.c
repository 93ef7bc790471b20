#include "tools/isoc/implicit/jacobian.h"

typedef struct entry {
    int row, column;
    node is;
} entry;

/* The equations, linearised and times hb, with r the right side:
 *
 *     of a quantity w = w(w, x, q''):  hb dw - w_w hb dw - hb w_x dx - w_q'' hb dq'' = 0
 *     of a position x' = f(w, x):      dx - f_w hb dw - hb f_x dx = r
 *     of an acceleration:              dx - hb dq'' = r, where x is the speed
 *     of a speed, the balance:         left_w hb dw + hb left_x dx + left_q'' hb dq'' = 0, negated.
 *
 * Unknowns in this order: the quantities, positions, speeds, accelerations. */
typedef struct extended_unknowns {
    graph *g;
    const dynamics *d;
    int quantities, states, count;
    node *quantity; /* [quantities] */
    int *group;     /* [count] of the order of the elimination */
    bool *stops;    /* [nodes] which are unknowns */
    int *unknown;   /* [nodes] which one */
    entry *entries;
    size_t entry_count, entry_room;
} extended_unknowns;

/* From the tips to the root, like the factorisation of M, and in a segment the speeds last: before, the quantities
 * follow from one another and from the states, so that their pivots are 1; then those of the speeds are the pivots of
 * the matrix in the states alone, which the unrolled elimination has. */
enum { GROUPS = 4, LEAST_OF_SPEED = 0, OF_QUANTITIES = 3 };

static int group_of(int owner, int of_segment)
{
    return GROUPS * (owner + 1) + of_segment;
}

static void mark(extended_unknowns *z, node n, int unknown)
{
    z->stops[n] = true;
    z->unknown[n] = unknown;
}

/* A quantity that is computed, unless it is one already. */
static void add_quantity(extended_unknowns *z, node n, int owner)
{
    n = z->g->nodes[n].op == OP_NEG ? z->g->nodes[n].a : n;
    if (operators[z->g->nodes[n].op].kind == KIND_OPERATION && !z->stops[n]) {
        mark(z, n, z->quantities);
        z->group[z->quantities] = group_of(owner, OF_QUANTITIES);
        z->quantity[z->quantities++] = n;
    }
}

static void add_vector(extended_unknowns *z, vector a, int owner)
{
    for (int i = 0; i < 3; i++) {
        add_quantity(z, a.at[i], owner);
    }
}

/* A force that several segments hand on unchanged belongs to the last of them: the balance of each of their speeds
 * depends on it. A quantity that depends on the rate of a speed then belongs to the speed's segment or to one behind
 * it. */
static void add_quantities(extended_unknowns *z, const balance *b)
{
    const int segments = z->d->m->segment_count;
    for (int i = segments - 1; i >= 0; i--) {
        add_vector(z, b->wrenches[i].force, i);
        add_vector(z, b->wrenches[i].moment, i);
    }
    for (int i = 0; i < segments; i++) {
        add_vector(z, z->d->k.motions[i].omega, i);
        add_vector(z, b->accelerations[i].alpha, i);
        add_vector(z, b->accelerations[i].a, i);
    }
}

static void add_states(extended_unknowns *z)
{
    const mechanism *m = z->d->m;
    for (int i = 0; i < m->segment_count; i++) {
        const segment *l = &m->segments[i];
        for (int n = 0; n < positions_of(l->kind); n++) {
            z->group[z->quantities + l->position + n] = group_of(i, OF_QUANTITIES);
        }
        for (int n = 0; n < dofs_of(l->kind); n++) {
            const int speed = z->quantities + m->position_count + l->dof + n;
            z->group[speed] = group_of(i, LEAST_OF_SPEED + n);
            z->group[speed + m->dof_count] = group_of(i, OF_QUANTITIES);
        }
    }
    for (size_t i = 0; i < z->g->count; i++) {
        const graph_node *n = &z->g->nodes[i];
        if (n->op == OP_STATE || n->op == OP_DERIVATIVE) {
            mark(z, (node)i, z->quantities + n->index + (n->op == OP_DERIVATIVE ? m->dof_count : 0));
        }
    }
    z->count = z->quantities + z->states + m->dof_count;
}

static extended_unknowns extended_unknowns_of(graph *g, const dynamics *d, const balance *b)
{
    enum { OF_LINK = 15 };
    const mechanism *m = d->m;
    extended_unknowns z = {.g = g, .d = d, .states = state_count(m)};
    const size_t most = (size_t)(OF_LINK * m->segment_count), all = most + (size_t)(z.states + m->dof_count);
    z.quantity = arena_take(g->memory, most, sizeof *z.quantity);
    z.group = arena_take(g->memory, all, sizeof *z.group);
    z.stops = arena_take(g->memory, g->count, sizeof *z.stops);
    z.unknown = arena_take(g->memory, g->count, sizeof *z.unknown);
    add_quantities(&z, b);
    add_states(&z);
    return z;
}

static void add_entry(extended_unknowns *z, int row, int column, node is)
{
    ADD_TO(z->g->memory, z->entries, z->entry_count, z->entry_room, ((entry){row, column, is}));
}

static bool is_state(const extended_unknowns *z, int unknown)
{
    return unknown >= z->quantities && unknown < z->quantities + z->states;
}

/* The row of an equation, `own` = root; one where there is a diagonal of its own, else zero. */
static void add_row(extended_unknowns *z, partials *p, int row, node own, node root)
{
    graph *g = z->g;
    node *by, *derivatives;
    const size_t count = partial_derivatives(p, root, &by, &derivatives);
    const node hb = leaf(g, OP_STEP, 0);
    node diagonal = own;
    for (size_t i = 0; i < count; i++) {
        const int column = z->unknown[by[i]];
        const node part = is_state(z, column) ? mul(g, hb, derivatives[i]) : derivatives[i];
        if (column == row) {
            diagonal = sub(g, diagonal, part);
        } else if (!is_zero(g, part)) {
            add_entry(z, row, column, neg(g, part));
        }
    }
    add_entry(z, row, row, diagonal);
}

static void add_rows(extended_unknowns *z, const balance *b, const node *derivatives)
{
    graph *g = z->g;
    const mechanism *m = z->d->m;
    partials p = partials_start(g, z->stops);
    const node zero = constant(g, 0.0), one = constant(g, 1.0);
    for (int i = 0; i < z->quantities; i++) {
        add_row(z, &p, i, one, z->quantity[i]);
    }
    for (int i = 0; i < m->position_count; i++) {
        add_row(z, &p, z->quantities + i, one, derivatives[i]);
    }
    for (int f = 0; f < m->dof_count; f++) {
        const int speed = z->quantities + m->position_count + f, rate = speed + m->dof_count;
        add_row(z, &p, speed, zero, b->left[f]);
        add_entry(z, rate, speed, one);
        add_entry(z, rate, rate, constant(g, -1.0));
    }
}

const extended *extended_build(graph *g, const dynamics *d, const node *derivatives)
{
    const mechanism *m = d->m;
    const balance b = balance_build(d);
    extended_unknowns z = extended_unknowns_of(g, d, &b);
    extended *result = arena_take(g->memory, 1, sizeof *result);
    graph_section(g, "Entries of 1 - hb J, with what Newton-Euler hands on from link to link as unknowns");
    add_rows(&z, &b, derivatives);
    pattern places = pattern_start(g->memory, z.count);
    for (size_t i = 0; i < z.entry_count; i++) {
        pattern_add(&places, z.entries[i].row, z.entries[i].column);
    }
    result->e = elimination_of(&places, z.group);
    result->entries = zero_nodes(g, (size_t)result->e.nonzeros);
    for (size_t i = 0; i < z.entry_count; i++) {
        result->entries[elimination_index(&result->e, z.entries[i].row, z.entries[i].column)] = z.entries[i].is;
    }
    result->right_row = arena_take(g->memory, (size_t)z.states, sizeof *result->right_row);
    result->found = arena_take(g->memory, (size_t)z.states, sizeof *result->found);
    for (int i = 0; i < z.states; i++) {
        const int first = z.quantities + i, speeds = i < m->position_count ? 0 : m->dof_count;
        result->found[i] = result->e.place[first];
        result->right_row[i] = result->e.place[first + speeds];
    }
    return result;
}
