#include "tools/isoc/closure/closure.h"

#include <math.h>

/* At the start the pivot of each constraint is at least this part of its diagonal: the square of the sine of its angle
 * to those before it, in the metric of M^-1. */
static const double least_part = 0.01;

/* The number of closures that each degree of freedom moves, itself or by those that it carries. */
static int *count_closures(const mass_matrix *mass, const constraints *phi)
{
    const mechanism *m = mass->k->m;
    arena *memory = mass->k->g->memory;
    int *result = arena_take(memory, (size_t)mass->n, sizeof *result);
    int *last = arena_take(memory, (size_t)mass->n, sizeof *last);
    for (int r = 0; r < phi->count; r++) {
        for (int f = 0; f < mass->n; f++) {
            for (int j = is_zero(mass->k->g, phi->all[r].row[f]) ? GROUND : f; j != GROUND; j = m->dofs[j].before) {
                result[j] += last[j] != phi->all[r].closure + 1;
                last[j] = phi->all[r].closure + 1;
            }
        }
    }
    return result;
}

/* a[size size] = L D L', below the diagonal. Whether the rows from `first` on, which are constraints, are far from
 * dependent ones. */
static bool are_independent(double *a, int size, int first)
{
    bool result = true;
    for (int k = 0; k < size; k++) {
        double diagonal = 0.0, pivot = a[k * size + k];
        for (int j = 0; j < k; j++) {
            double *entry = &a[k * size + j], sum = *entry;
            for (int i = 0; i < j; i++) {
                sum -= a[k * size + i] * a[j * size + i] * a[i * size + i];
            }
            *entry = sum / a[j * size + j];
            pivot -= *entry * sum;
            diagonal -= j < first ? *entry * sum : 0.0;
        }
        a[k * size + k] = pivot;
        result = result && (k < first || pivot < least_part * diagonal);
    }
    return result;
}

/* Whether the constraints are independent in the degrees of freedom that are not shared: by [M Phi_q'; Phi_q 0] without
 * the shared ones. */
static bool is_regular(const mass_matrix *mass, const constraints *phi, const double *numbers, const bool *is_shared)
{
    arena *memory = mass->k->g->memory;
    const int n = mass->n, size = n + phi->count;
    double *a = arena_take(memory, (size_t)(size * size), sizeof *a);
    for (int f = 0; f < n; f++) {
        a[f * size + f] = 1.0;
        for (int j = is_shared[f] ? GROUND : f; j != GROUND && !is_shared[j]; j = mass->k->m->dofs[j].before) {
            a[f * size + j] = numbers[mass->entries[f * n + j]];
        }
        for (int r = 0; r < phi->count && !is_shared[f]; r++) {
            a[(n + r) * size + f] = numbers[phi->all[r].row[f]];
        }
    }
    const bool result = are_independent(a, size, n);
    arena_return(memory, a, (size_t)(size * size), sizeof *a);
    return result;
}

const bool *find_shared(const mass_matrix *mass, const constraints *phi)
{
    const mechanism *m = mass->k->m;
    arena *memory = mass->k->g->memory;
    const int *closures = count_closures(mass, phi);
    const double *numbers = numbers_at_start(mass->k->g, m);
    bool *is_shared = arena_take(memory, (size_t)mass->n + 1, sizeof *is_shared);
    for (int least = 2; least <= m->closure_count; least++) {
        bool is_any = false;
        for (int f = 0; f < mass->n; f++) {
            is_shared[f] = closures[f] >= least;
            is_any = is_any || is_shared[f];
        }
        if (is_any && is_regular(mass, phi, numbers, is_shared)) {
            return is_shared;
        }
    }
    return NULL;
}

double *least_pivots(const augmented *a, const double *numbers, double part)
{
    double *result = arena_take(a->mass->k->g->memory, (size_t)a->phi.count, sizeof *result);
    for (int r = 0; r < a->phi.count; r++) {
        int rows = 0;
        for (int s = 0; s < a->phi.count; s++) {
            const bool is_same = a->phi.all[s].closure == a->phi.all[r].closure;
            for (int i = a->phi.count; i < a->size && is_same; i++) {
                const double entry = numbers[a->schur[i * a->size + s]];
                result[r] -= part * entry * entry / numbers[a->schur[i * a->size + i]];
            }
            rows += is_same;
        }
        result[r] /= rows;
    }
    return result;
}

/* Whether a segment turns about an axis parallel to that which its parent turns about. */
static bool is_knee(const graph *g, const mechanism *m, const segment *l)
{
    const segment *parent = l->parent == GROUND ? l : &m->segments[l->parent];
    return parent != l && l->kind == JOINT_REVOLUTE && parent->kind == JOINT_REVOLUTE &&
           fabs(constant_value(g, l->turn.at[parent->axis][l->axis])) > 1.0 - 1e-9;
}

bool have_knees(const mass_matrix *mass)
{
    const mechanism *m = mass->k->m;
    FOR_ALL (const segment, l, m->segments, m->segment_count) {
        if (!mass->is_left[l->dof] && is_knee(mass->k->g, m, l)) {
            return true;
        }
    }
    return false;
}
