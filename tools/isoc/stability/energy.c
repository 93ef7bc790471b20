#include "tools/isoc/stability/stability.h"

#include <float.h>
#include <math.h>

/* The energy may change by the first part of the energy of motion at the start, or by the second of that at the end,
 * which may come from a long fall; and by the rounding of states that are as large as these energies, which adds up
 * like a random walk. */
static const double part_of_first = 1e-2, part_of_last = 1e-3, rounding_of_state = 4.0;

/* At one moment, in J. */
typedef struct energies {
    double all, motion;
    double largest; /* that of motion, and of gravity over the whole distance from the ground's origin */
} energies;

static double length_of(const vector *v, const double *numbers)
{
    const double x = numbers[v->at[0]], y = numbers[v->at[1]], z = numbers[v->at[2]];
    return sqrt(x * x + y * y + z * z);
}

static energies energies_at(graph *g, const plant *p, const double *x)
{
    const node kinetic = account_motion(p->d);
    const vector first_moment = composite_of_all(&p->d->k).ms;
    double *numbers = arena_take(g->memory, g->count, sizeof *numbers);
    graph_evaluate(g, 0, &(evaluation){.x = x, .p = p->m->parameters.defaults}, numbers);
    const double gravity = length_of(&p->m->forces.gravity, numbers) * length_of(&first_moment, numbers);
    return (energies){numbers[p->energy], numbers[kinetic], numbers[kinetic] + gravity};
}

void energy_check(const source *s, graph *g, const plant *p, const moment *end)
{
    const mechanism *m = p->m;
    const energy_course expected = account_course(p->d);
    const energies first = energies_at(g, p, mechanism_start(m, g->memory)), last = energies_at(g, p, end->x);
    const double ulp = p->is_double ? DBL_EPSILON : (double)FLT_EPSILON;
    const double rounding = rounding_of_state * ulp * sqrt(end->ticks) * fmax(first.largest, last.largest);
    const double most = fmax(part_of_first * first.motion, part_of_last * last.motion) + rounding;
    const double change = last.all - first.all;
    if (expected == ENERGY_STAYS ? fabs(change) > most : expected == ENERGY_FALLS && change > most) {
        const cause c = cause_of(m, -1);
        source_warn(s, c.at,
                    "the energy is %.4g J at the end of the run, and was %.4g J at its start, though nothing in the "
                    "scene %s: %s with a step of %.4g ms does not follow the motion; take a shorter step, more "
                    "`substeps`, or another method%s",
                    last.all, first.all, expected == ENERGY_STAYS ? "gives or takes any" : "gives any",
                    method_names[ISO_METHOD_OF(m->method.recipe)], 1e3 * m->method.step,
                    p->is_double ? "" : ", or in float `compensated yes`");
    }
}
