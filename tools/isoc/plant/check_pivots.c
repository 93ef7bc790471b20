#include "tools/isoc/plant/checks.h"

/* M = L' D L of the numbers, as of the nodes (tools/isoc/tree/mass_matrix.c): D on the diagonal. */
static void factorise(const mechanism *m, double *at)
{
    const int n = m->dof_count;
    for (int i = n - 1; i >= 0; i--) {
        for (int j = m->dofs[i].before; j != GROUND; j = m->dofs[j].before) {
            const double factor = at[i * n + j] / at[i * n + i];
            for (int k = j; k != GROUND; k = m->dofs[k].before) {
                at[j * n + k] -= factor * at[i * n + k];
            }
        }
    }
}

void pivots_check(source *s, const graph *g, const plant *p)
{
    static const char *const about[] = {" about its x axis", " about its y axis", " about its z axis"};
    const mechanism *m = p->m;
    const int n = m->dof_count;
    const node *entries = p->d->mass.entries;
    const double *numbers = numbers_at_start(g, m);
    double *factors = arena_take(g->memory, (size_t)(n * n), sizeof *factors);
    for (int i = 0; i < n * n; i++) {
        factors[i] = numbers[entries[i]];
    }
    factorise(m, factors);
    /* From the tips inward, in the order of the elimination: all pivots after a bad one are bad too. */
    for (int f = n - 1; f >= 0; f--) {
        const double pivot = factors[f * n + f], inertia = numbers[entries[f * n + f]];
        const segment *l = &m->segments[m->dofs[f].segment];
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
