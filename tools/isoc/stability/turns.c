#include "tools/isoc/stability/stability.h"

#include <math.h>
#include <string.h>

/* The most that a joint may turn in a step, rad: there are 12 steps in a turn, and in each rk4 changes the size of an
 * oscillation of that frequency by 0.5^6 / 144 = 1.1e-4, which is e in 9000 steps. */
static const double most_turn = 0.5;

/* rad/s, in all directions. */
static double turning_speed(const mechanism *m, const segment *l, const double *x)
{
    const double *speed = x + m->position_count + l->dof;
    double square = 0.0;
    for (int i = 0; i < dofs_of(l->kind) && l->kind != JOINT_PRISMATIC; i++) {
        square += speed[i] * speed[i];
    }
    return sqrt(square);
}

/* x with one joint moved by an angle, and the others so that the closures hold; NULL where they cannot. */
static const double *with_angle(const plant *p, arena *memory, const double *x, const segment *l, double by)
{
    static const double enough = 1e-9; /* m or rad */
    const size_t dofs = (size_t)p->m->dof_count;
    bool *is_free = arena_take(memory, dofs + 1, sizeof *is_free);
    for (size_t f = 0; f < dofs; f++) {
        is_free[f] = f != (size_t)l->dof;
    }
    const closing c = closing_start(memory, p->d);
    memcpy(c.x, x, (size_t)state_count(p->m) * sizeof *x);
    c.x[l->position] += by;
    return closing_run(&c, false, is_free).size < enough ? c.x : NULL;
}

/* Whether the motion depends on the angle of a joint: not on that of a wheel that is round and balanced. It does where
 * a derivative differs between three angles, of which no two are half a turn apart. */
static bool is_seen(const graph *g, const plant *p, const double *x, const segment *l)
{
    static const double angles[] = {0.0, 1.0, 2.5}, rounding = 1e-9;
    arena *memory = g->memory;
    const size_t states = (size_t)state_count(p->m);
    const double *u = inputs_at_start(g, p->m);
    double *numbers = arena_take(memory, g->count, sizeof *numbers);
    double *first = arena_take(memory, states + 1, sizeof *first), largest = 0.0, difference = 0.0;
    for (size_t k = 0; k < COUNT_OF(angles); k++) {
        const double *moved = with_angle(p, memory, x, l, angles[k]);
        if (moved == NULL) {
            return true;
        }
        graph_evaluate(g, 0, &(evaluation){.x = moved, .u = u, .p = p->m->parameters.defaults}, numbers);
        for (size_t i = 0; i < states; i++) {
            const double now = numbers[p->derivatives[i]];
            first[i] = k == 0 ? now : first[i];
            largest = fmax(largest, fabs(first[i]));
            difference = fmax(difference, fabs(now - first[i]));
        }
    }
    return difference > rounding * largest;
}

void turns_check(const source *s, const graph *g, const plant *p, const moment *at)
{
    const mechanism *m = p->m;
    const double step = method_step(m);
    FOR_ALL (const segment, l, m->segments, m->segment_count) {
        const double rate = turning_speed(m, l, at->x);
        if (rate * step > most_turn && (l->kind == JOINT_SPHERICAL || is_seen(g, p, at->x, l))) {
            source_warn(
                s, l->at,
                "the joint '%s' turns by %.3g rad in a step of %.4g ms %s, and the motion depends on its angle; "
                "%s follows up to %g rad: take a step of %.3g ms, or `substeps %.0f`",
                l->name, rate * step, 1e3 * step, at->when, method_names[ISO_METHOD_OF(m->method.recipe)], most_turn,
                1e3 * most_turn / rate, ceil(m->method.step * rate / most_turn));
        }
    }
}
