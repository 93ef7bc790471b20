#include "tools/isoc/tree/tree.h"

#include <string.h>

/* The quantity of a point, in the axes of the body's segment. */
static vector in_segment(const kinematics *k, const query *q, vector point)
{
    const body_frame *frame = &k->m->bodies.frames[q->body];
    const int at = frame->segment;
    vector found = vector_zero(k->g);
    if (q->kind == QUANTITY_VELOCITY) {
        found = point_velocity(k, at, point);
    } else if (q->kind == QUANTITY_SPIN) {
        found = at == GROUND ? found : k->motions[at].omega;
    } else {
        for (int i = 0; i < 3; i++) {
            found.at[i] = frame->turn.at[i][q->kind - QUANTITY_X_AXIS];
        }
    }
    return found;
}

void point_query_nodes(const kinematics *k, const query *q, node parts[QUERY_PARTS])
{
    graph *g = k->g;
    const body_frame *frame = &k->m->bodies.frames[q->body];
    if (q->kind == QUANTITY_ORIENTATION) {
        body_orientation(k, frame, parts);
        return;
    }
    const vector point = vector_add(g, matrix_apply(g, frame->turn, q->point), frame->offset);
    vector found;
    if (q->kind == QUANTITY_POINT) {
        found = outward_point(k, frame->segment, GROUND, point);
    } else {
        found = axes_of_body(k, frame, q->in_body, in_segment(k, q, point));
    }
    memcpy(parts, found.at, sizeof found.at);
}

/* The nodes in the place of the leaves. */
typedef struct answers {
    replacement points;   /* QUERY_PARTS of each question */
    replacement inertias; /* by NULL where none is asked for */
} answers;

static void replace(graph *g, node *roots, size_t count, void *context)
{
    answers *a = context;
    replace_more_leaves(g, roots, count, &a->points);
    if (a->inertias.by != NULL) {
        replace_more_leaves(g, roots, count, &a->inertias);
    }
}

void point_queries_resolve(graph *g, mechanism *m)
{
    const node *inertias = effective_inertias(g, m);
    bool any = m->queries.count > 0 || inertias != NULL;
    for (int i = 0; i < m->forces.applied_count; i++) {
        any = any || m->forces.applied[i].drive < 0;
    }
    if (!any) {
        return;
    }
    const kinematics k = kinematics_build(g, m);
    kinematics_velocities(&k);
    graph_section(g, "Points of effects, in the ground's frame");
    node *points = arena_take(g->memory, QUERY_PARTS * (size_t)m->queries.count + 1, sizeof *points);
    for (int i = 0; i < m->queries.count; i++) {
        for (int n = 0; n < QUERY_PARTS; n++) {
            points[QUERY_PARTS * i + n] = leaf(g, OP_QUERY, QUERY_PARTS * i + n);
        }
        if (!is_known_late(m->queries.all[i].kind)) {
            point_query_nodes(&k, &m->queries.all[i], &points[QUERY_PARTS * i]);
        }
    }
    answers all = {{.op = OP_QUERY, .by = points}, {.op = OP_INERTIA, .by = inertias}};
    graph_section(g, "Effects");
    for_roots(g, m, true, replace, &all);
    FOR_ALL (applied_force, f, m->forces.applied, m->forces.applied_count) {
        if (f->drive < 0) {
            f->force = f->in_ground ? inward_axes(&k, GROUND, f->segment, f->force) : f->force;
            f->moment = f->in_ground ? inward_axes(&k, GROUND, f->segment, f->moment) : f->moment;
        }
    }
}
