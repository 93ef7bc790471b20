#include "tools/isoc/linear/linear.h"

#include <string.h>

expansion expand(const graph *g, const plant *p, const node *derivatives, bool is_whole)
{
    const mechanism *m = p->m;
    expansion e = {.p = p, .states = state_count(m), .inputs = m->inputs.count};
    e.outputs = is_whole ? p->outputs.count : 0;
    e.gaps = is_whole ? p->d->loops.phi.count : 0;
    e.roots = e.states + e.outputs + 2 * e.gaps;
    const size_t roots = (size_t)e.roots;
    graph copy = graph_copy(g);
    node *all = arena_take(g->memory, roots + 1, sizeof *all);
    list_roots(&copy, p, derivatives, e.outputs, all);
    node *gaps = all + e.states + e.outputs;
    for (int i = 0; i < e.gaps; i++) {
        gaps[i] = p->d->loops.phi.all[i].position;
        gaps[e.gaps + i] = p->d->loops.phi.all[i].rate;
    }
    e.l = linearise(&copy, m, all, roots);
    graph_free(&copy);
    e.by_input = arena_take(g->memory, (roots + 1) * ((size_t)e.inputs + 1), sizeof *e.by_input);
    for (int i = 0; i < e.inputs; i++) {
        differentiate(&e.l.g, e.l.values, roots, leaf(&e.l.g, OP_INPUT, i), e.by_input + i * e.roots);
    }
    return e;
}

point point_copy(arena *memory, const expansion *e, const point *at)
{
    return (point){list_copy(memory, at->x, (size_t)e->states, sizeof *at->x),
                   list_copy(memory, at->u, (size_t)held_count(e->p->m), sizeof *at->u), at->p};
}

void numbers_at(const expansion *e, const point *at, const double *along, const node *nodes, double *numbers)
{
    const graph *g = &e->l.g;
    const int kept = held_count(e->p->m);
    const size_t room = (size_t)(kept + e->states) + 1;
    double *all = arena_take(g->memory, g->count, sizeof *all), *u = arena_take(g->memory, room, sizeof *u);
    memcpy(u, at->u, (size_t)kept * sizeof *u);
    if (along != NULL) {
        memcpy(u + kept, along, (size_t)e->states * sizeof *u);
    }
    graph_evaluate(g, 0, &(evaluation){.x = at->x, .u = u, .p = at->p}, all);
    for (int i = 0; i < e->roots; i++) {
        numbers[i] = all[nodes[i]];
    }
    arena_return(g->memory, all, g->count, sizeof *all);
    arena_return(g->memory, u, room, sizeof *u);
}
