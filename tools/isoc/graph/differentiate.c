#include "tools/isoc/graph/graph.h"

#include "tools/isoc/graph/rules.h"

/* The chain rule from the leaves to the roots: d[before] has the derivatives of the leaves; its memory ends here. */
static void follow(graph *g, const node *roots, size_t count, node *d, size_t before, node *derivatives)
{
    for (reached r = reach(g, roots, count); reach_next(&r);) {
        const graph_node n = *r.n;
        if (operators[n.op].operands > 0) {
            d[r.at] = rules[n.op].derivative(g, r.at, d[n.a], d[n.b]);
        }
    }
    for (size_t i = 0; i < count; i++) {
        derivatives[i] = d[roots[i]];
    }
    arena_return(g->memory, d, before, sizeof *d);
}

void differentiate(graph *g, const node *roots, size_t count, node by, node *derivatives)
{
    const size_t before = g->count;
    node *d = zero_nodes(g, before);
    d[by] = constant(g, 1.0);
    follow(g, roots, count, d, before, derivatives);
}

void differentiate_along(graph *g, const node *roots, size_t count, const node *along, const node *inputs,
                         node *changes)
{
    const size_t before = g->count;
    node *d = zero_nodes(g, before);
    for (size_t i = 0; i < before; i++) {
        const graph_node *n = &g->nodes[i];
        d[i] = n->op == OP_STATE ? along[n->index] : n->op == OP_INPUT && inputs != NULL ? inputs[n->index] : d[i];
    }
    follow(g, roots, count, d, before, changes);
}

partials partials_start(graph *g, const bool *stops)
{
    partials p = {.g = g, .count = g->count, .stops = stops};
    p.parts = arena_take(g->memory, p.count, sizeof *p.parts);
    p.d = arena_take(g->memory, p.count, sizeof *p.d);
    p.is_visited = arena_take(g->memory, p.count, sizeof *p.is_visited);
    return p;
}

static void see(partials *p, node n, size_t *count)
{
    if (!p->is_visited[n]) {
        p->is_visited[n] = true;
        p->parts[(*count)++] = n;
    }
}

/* The nodes below the root, down to stops and leaves, each after its operands. */
static size_t list_parts(partials *p, node root)
{
    size_t count = 0;
    see(p, root, &count);
    for (size_t next = 0; next < count; next++) {
        const graph_node *n = &p->g->nodes[p->parts[next]];
        const int operands = p->stops[p->parts[next]] && next > 0 ? 0 : operators[n->op].operands;
        const node below[] = {n->a, n->b};
        for (int i = 0; i < operands; i++) {
            see(p, below[i], &count);
        }
    }
    sort_nodes(p->parts, count);
    return count;
}

static bool is_end(const partials *p, node n, node root)
{
    return operators[p->g->nodes[n].op].operands == 0 || (p->stops[n] && n != root);
}

size_t partial_derivatives(partials *p, node root, node **by, node **derivatives)
{
    graph *g = p->g;
    const node zero = constant(g, 0.0), one = constant(g, 1.0);
    const size_t parts = list_parts(p, root);
    size_t found = 0;
    *by = arena_take(g->memory, parts, sizeof **by);
    *derivatives = arena_take(g->memory, parts, sizeof **derivatives);
    for (size_t i = 0; i < parts; i++) {
        if (p->stops[p->parts[i]] && is_end(p, p->parts[i], root)) {
            (*by)[found++] = p->parts[i];
        }
    }
    for (size_t x = 0; x < found; x++) {
        for (size_t i = 0; i < parts; i++) {
            const node part = p->parts[i];
            const graph_node n = g->nodes[part];
            p->d[part] = part == (*by)[x] ? one : zero;
            if (!is_end(p, part, root)) {
                p->d[part] = rules[n.op].derivative(g, part, p->d[n.a], p->d[n.b]);
            }
        }
        (*derivatives)[x] = p->d[root];
    }
    for (size_t i = 0; i < parts; i++) {
        p->is_visited[p->parts[i]] = false;
    }
    return found;
}

node node_again(graph *g, const graph_node *n, node a, node b, void *context)
{
    (void)context;
    return a == n->a && b == n->b ? -1 : rules[n->op].again(g, a, b);
}

void replace_nodes(graph *g, node *roots, size_t count, size_t before, node *to)
{
    replace_nodes_by(g, roots, count, before, to, node_again, NULL);
}

void replace_nodes_by(graph *g, node *roots, size_t count, size_t before, node *to, node_maker *again, void *context)
{
    for (reached r = reach(g, roots, count); reach_next(&r);) {
        const graph_node n = *r.n;
        const operator_row *row = &operators[n.op];
        if ((size_t)r.at < before && row->operands > 0 && to[r.at] == r.at) {
            const size_t known = g->count;
            const node result = again(g, &n, to[n.a], row->operands == 2 ? to[n.b] : n.b, context);
            to[r.at] = result < 0 ? r.at : result;
            if ((size_t)to[r.at] >= known && !is_constant(g, to[r.at])) {
                g->nodes[to[r.at]].name = n.name;
                g->nodes[to[r.at]].section = n.section;
            }
        }
    }
    for (size_t i = 0; i < count; i++) {
        roots[i] = to[roots[i]];
    }
}

void replace_more_leaves(graph *g, node *roots, size_t count, replacement *r)
{
    while (r->count < g->count) {
        const graph_node *n = &g->nodes[r->count];
        const node stands = n->op == r->op ? r->by[n->index] : (node)r->count;
        ADD_TO(g->memory, r->to, r->count, r->room, stands);
    }
    replace_nodes(g, roots, count, r->count, r->to);
}

void replace_leaves(graph *g, node *roots, size_t count, operation op, const node *by)
{
    replacement r = {.op = op, .by = by};
    replace_more_leaves(g, roots, count, &r);
    arena_return(g->memory, r.to, r.room, sizeof *r.to);
}

node replace_leaf(graph *g, node root, node leaf, node by)
{
    const size_t before = g->count;
    node *to = all_nodes(g);
    to[leaf] = by;
    replace_nodes(g, &root, 1, before, to);
    arena_return(g->memory, to, before, sizeof *to);
    return root;
}
