#include "tools/isoc/plant/accelerations.h"

#include "tools/isoc/dynamics/reaction.h"
#include "tools/isoc/graph/differentiate.h"

/* With the ground accelerated by -gravity, as the accelerations of the links are. */
static vector specific_force(const plant *p, graph *g, const asked *of)
{
    const kinematics *k = &p->d->k;
    const body_frame *frame = &p->m->frames[of->body];
    if (frame->link == GROUND) {
        const vector up = vector_sub(g, vector_zero(g), p->m->gravity);
        return of->in_body ? matrix_apply(g, matrix_transpose(frame->turn), up) : up;
    }
    const acceleration *now = &p->accelerations[frame->link];
    const vector point = vector_add(g, matrix_apply(g, frame->turn, of->point), frame->offset);
    const vector moved = swing(g, k->motions[frame->link].omega, now->alpha, point);
    const vector in_link = vector_add(g, now->a, moved);
    return of->in_body ? matrix_apply(g, matrix_transpose(frame->turn), in_link)
                       : outward_axes(k, frame->link, GROUND, in_link);
}

static bool any_asks(const mechanism *m)
{
    bool any = false;
    for (int i = 0; i < m->asked_count; i++) {
        any = any || m->asked[i].kind == ASKED_SPECIFIC_FORCE;
    }
    return any;
}

void specific_forces_resolve(plant *p, graph *g)
{
    const mechanism *m = p->m;
    if (!any_asks(m)) {
        return;
    }
    p->accelerations = p->accelerations == NULL ? reaction_accelerations(p->d) : p->accelerations;
    graph_section(g, "Specific forces");
    node *answers = arena_take(g->memory, 3 * (size_t)m->asked_count, sizeof *answers);
    for (int i = 0; i < m->asked_count; i++) {
        const bool is_asked = m->asked[i].kind == ASKED_SPECIFIC_FORCE;
        const vector force = is_asked ? specific_force(p, g, &m->asked[i]) : vector_zero(g);
        for (int n = 0; n < 3; n++) {
            answers[3 * i + n] = force.at[n];
        }
    }
    for (int i = 0; i < m->memory_count; i++) {
        replace_leaves(g, &m->memories[i].next, 1, OP_ASKED, answers);
    }
    for (size_t i = 0; i < m->output_count; i++) {
        if (m->outputs[i].kind == OUTPUT_FORMULA) {
            replace_leaves(g, &m->outputs[i].formula, 1, OP_ASKED, answers);
        }
    }
}
