#include "tools/isoc/tree/tree.h"

/* Whether any formula asks for one. */
static bool asks_for_inertia(const graph *g)
{
    bool any = false;
    for (size_t i = 0; i < g->count; i++) {
        any = any || g->nodes[i].op == OP_INERTIA;
    }
    return any;
}

/* The acceleration of a point that moves with the body, beside its own, by a unit force there, both along one axis. */
static node mobility(const kinematics *k, const spatial *response, const inertia_query *q, int axis)
{
    graph *g = k->g;
    const body_frame *frame = &k->m->bodies.frames[q->body];
    vector along = vector_zero(g), beside = q->beside;
    along.at[axis] = constant(g, 1.0);
    along = q->in_body ? matrix_apply(g, frame->turn, along) : inward_axes(k, GROUND, frame->segment, along);
    beside = q->in_body ? matrix_apply(g, frame->turn, beside) : inward_axes(k, GROUND, frame->segment, beside);
    const vector placed = vector_add(g, matrix_apply(g, frame->turn, q->point), frame->offset);
    const vector moment = vector_cross(g, vector_add(g, placed, beside), along);
    node sum = constant(g, 0.0);
    for (int i = 0; i < SPATIAL; i++) {
        for (int j = 0; j < SPATIAL; j++) {
            const node push = j < LINEAR ? moment.at[j] : along.at[j - LINEAR];
            const node part = mul(g, response->at[i][j], push);
            sum = add(g, sum, mul(g, i < LINEAR ? moment.at[i] : along.at[i - LINEAR], part));
        }
    }
    return sum;
}

const node *effective_inertias(graph *g, const mechanism *m)
{
    if (!asks_for_inertia(g)) {
        return NULL;
    }
    graph scratch = graph_copy(g); /* so that none of these nodes is in the graph of the plant */
    const kinematics k = kinematics_build(&scratch, m);
    const size_t n = (size_t)m->dof_count, points = 3 * m->queries.inertias.count;
    node *accelerations = arena_take(g->memory, n + points, sizeof *accelerations);
    spatial *responses = arena_take(g->memory, (size_t)m->segment_count, sizeof *responses);
    articulated_responses(&k, accelerations, responses);
    for (size_t i = 0; i < points; i++) {
        const inertia_query *q = &m->queries.inertias.all[i / 3];
        const spatial *response = &responses[m->bodies.frames[q->body].segment];
        accelerations[n + i] = mobility(&k, response, q, (int)(i % 3));
    }
    note_built_in(&scratch, m, accelerations, n + points);
    const double *numbers = numbers_at_start(&scratch, m);
    node *result = arena_take(g->memory, n + points, sizeof *result);
    for (size_t i = 0; i < n + points; i++) {
        result[i] = constant(g, 1.0 / numbers[accelerations[i]]);
    }
    graph_free(&scratch);
    return result;
}
