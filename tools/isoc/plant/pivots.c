#include "tools/isoc/plant/pivots.h"
#include "tools/isoc/mechanism/states.h"

void pivots_check(source *s, const graph *g, const plant *p)
{
    static const char *const about[] = {" about its x axis", " about its y axis", " about its z axis"};
    const mechanism *m = p->m;
    double *numbers = arena_take(g->memory, g->count, sizeof *numbers);
    const evaluation at = {.x = mechanism_start(m, g->memory), .p = m->defaults};
    graph_evaluate(g, 0, &at, numbers);
    /* From the tips inward, in the order of the elimination: all pivots after a bad one are bad too. */
    for (int f = m->dof_count - 1; f >= 0; f--) {
        const double pivot = numbers[p->d->mass.pivots[f]], inertia = numbers[p->d->mass.diagonal[f]];
        const link *l = &m->links[m->dofs[f].link];
        if (!(inertia > 0.0) || !(pivot > 1e-10 * inertia)) {
            const bool is_ball = l->kind == JOINT_SPHERICAL;
            source_problem(s, l->at,
                           "the joint '%s' moves no inertia%s at the start (singular mass matrix): give a body beyond "
                           "it an inertia%s",
                           l->name, is_ball ? about[f - l->dof] : "",
                           is_ball ? "" : " or a centre of mass off its axis");
            return;
        }
    }
}
