#include "tools/isoc/linear/linear.h"

#include <math.h>
#include <string.h>

/* The change of all roots with one small coordinate, at a point: changes[roots]. */
static void column_at(const expansion *e, const chart *c, const point *at, int coordinate_index, double *changes)
{
    arena *memory = e->g.memory;
    double *along = arena_take(memory, (size_t)e->states + 1, sizeof *along);
    for (int i = 0; i < e->states; i++) {
        along[i] = c->turn[i * c->all + coordinate_index];
    }
    changes_at(e, at, along, changes);
}

void slopes_by_coordinates(const expansion *e, const chart *c, const point *at, double *slopes)
{
    double *column = arena_take(e->g.memory, (size_t)e->roots + 1, sizeof *column);
    for (int k = 0; k < c->all; k++) {
        column_at(e, c, at, k, column);
        for (int i = 0; i < e->roots; i++) {
            slopes[i * c->all + k] = column[i];
        }
    }
}

/* The rate of small angles: none of these changes it, for a turn of the frame that they stand in turns the rate too, and only
 * what the angular velocity changes by is left. */
double *reduced_rates(const expansion *e, const chart *c, arena *memory, const double *slopes)
{
    double *result = arena_take(memory, (size_t)(c->all * c->all) + 1, sizeof *result);
    for (int i = 0; i < c->all; i++) {
        for (int k = 0; k < c->all; k++) {
            const coordinate *row = &c->coordinates[i], *column = &c->coordinates[k];
            const bool is_turn = row->state < 0 && column->state < 0 && row->segment == column->segment;
            for (int s = 0; s < e->states && !is_turn; s++) {
                result[i * c->all + k] += c->back[i * c->states + s] * slopes[s * c->all + k];
            }
        }
    }
    return result;
}

/* --- kinks --- */

/* What both sides of a point have as slopes. */
typedef struct sides {
    double *below, *above;
} sides;

static const char *name_of_root(const expansion *e, arena *memory, int root)
{
    const plant *p = e->p;
    return root < e->states ? arena_format(memory, "the rate of %s", mechanism_states(p->m, memory)[root].about.name)
           : root < e->states + e->outputs ? p->outputs.names[root - e->states]
                                           : "a closure";
}

/* Where the sides differ, the mean of both stands in the place of the slope. */
static void take_mean(linear_model *l, const sides *two, const char *by, double *at, int stride)
{
    const expansion *e = l->e;
    double largest = 0.0;
    int found = -1;
    for (int i = 0; i < e->roots; i++) {
        const double apart = fabs(two->above[i] - two->below[i]);
        const double size = fabs(two->above[i]) + fabs(two->below[i]);
        if (apart > 1e-3 * size && apart > 1e-6) {
            at[i * stride] = 0.5 * (two->above[i] + two->below[i]);
            found = apart > largest ? i : found;
            largest = fmax(largest, apart);
        }
    }
    if (found >= 0) {
        l->kinks[l->kink_count++] =
            (kink){by, name_of_root(e, e->g.memory, found), two->below[found], two->above[found]};
    }
}

static double step_of(double x)
{
    return 1e-8 * (1.0 + fabs(x));
}

static point moved_copy(const expansion *e, const point *at)
{
    const size_t states = (size_t)e->states, held = (size_t)held_count(e->p->m);
    point result = {arena_take(e->g.memory, states + 1, sizeof *result.x),
                    arena_take(e->g.memory, held + 1, sizeof *result.u), at->p};
    memcpy(result.x, at->x, states * sizeof *result.x);
    memcpy(result.u, at->u, held * sizeof *result.u);
    return result;
}

static void find_kinks_of_coordinates(linear_model *l, sides *two, double *slopes)
{
    const expansion *e = l->e;
    const chart *c = &l->c;
    double *by = arena_take(e->g.memory, (size_t)c->all + 1, sizeof *by);
    for (int k = 0; k < c->all; k++) {
        const double step = c->coordinates[k].state < 0 ? 1e-8 : step_of(l->at.x[c->coordinates[k].state]);
        for (int side = 0; side < 2; side++) {
            point beside = moved_copy(e, &l->at);
            by[k] = side == 0 ? -step : step;
            chart_move(c, e->p->m, beside.x, by);
            by[k] = 0.0;
            column_at(e, c, &beside, k, side == 0 ? two->below : two->above);
        }
        take_mean(l, two, c->coordinates[k].name, slopes + k, c->all);
    }
}

static void find_kinks_of_inputs(linear_model *l, sides *two, double *slopes)
{
    const expansion *e = l->e;
    for (int k = 0; k < e->inputs; k++) {
        for (int side = 0; side < 2; side++) {
            point beside = moved_copy(e, &l->at);
            beside.u[k] += (side == 0 ? -1.0 : 1.0) * step_of(beside.u[k]);
            changes_by_input(e, &beside, k, side == 0 ? two->below : two->above);
        }
        take_mean(l, two, e->p->m->inputs.all[k].name, slopes + k, e->inputs);
    }
}

/* --- the model --- */

/* The rows of gaps and of their rates, less the first of constraints that are of speeds alone: their positions are no
 * numbers that must stay. */
static void choose(linear_model *l, arena *memory, const double *slopes)
{
    const expansion *e = l->e;
    chart *c = &l->c;
    const constraints *phi = &e->p->d->loops.phi;
    const size_t width = (size_t)c->all;
    double *rows = arena_take(memory, 2 * (size_t)e->gaps * width + 1, sizeof *rows);
    int count = 0;
    for (int i = 0; i < e->gaps; i++) {
        if (!is_zero(e->p->d->g, phi->all[i].position)) {
            memcpy(rows + width * (size_t)count++, slopes + width * (size_t)(e->states + e->outputs + i),
                   width * sizeof *rows);
        }
    }
    const int positions = count;
    for (int i = 0; i < e->gaps; i++) {
        memcpy(rows + width * (size_t)count++, slopes + width * (size_t)(e->states + e->outputs + e->gaps + i),
               width * sizeof *rows);
    }
    chart_choose(c, e->p->m, memory, rows, count, positions);
}

/* left[rows][all] times the basis. */
static double *in_basis(const chart *c, arena *memory, const double *left, int rows, const int *which)
{
    double *result = arena_take(memory, (size_t)(rows * c->count) + 1, sizeof *result);
    for (int i = 0; i < rows; i++) {
        const double *row = left + (which == NULL ? i : which[i]) * c->all;
        for (int j = 0; j < c->count; j++) {
            for (int k = 0; k < c->all; k++) {
                result[i * c->count + j] += row[k] * c->basis[k * c->count + j];
            }
        }
    }
    return result;
}

/* The independent coordinates of what states have: at[states][columns]. */
static double *in_chosen(const chart *c, arena *memory, const double *at, int columns)
{
    double *result = arena_take(memory, (size_t)(c->count * columns) + 1, sizeof *result);
    for (int i = 0; i < c->count; i++) {
        for (int k = 0; k < columns; k++) {
            for (int s = 0; s < c->states; s++) {
                result[i * columns + k] += c->back[c->chosen[i] * c->states + s] * at[s * columns + k];
            }
        }
    }
    return result;
}

static void check_finite(linear_model *l, const double *slopes, int columns)
{
    for (int i = 0; i < l->e->roots && l->not_finite == NULL; i++) {
        for (int k = 0; k < columns; k++) {
            if (!isfinite(slopes[i * columns + k])) {
                l->not_finite = name_of_root(l->e, l->e->g.memory, i);
                return;
            }
        }
    }
}

linear_model model_at(const expansion *e, const scene *written, point at)
{
    arena *memory = e->g.memory;
    const mechanism *m = e->p->m;
    const size_t roots = (size_t)e->roots + 1;
    linear_model l = {.e = e, .at = at, .c = chart_at(m, written, memory, at.x)};
    chart *c = &l.c;
    double *slopes = arena_take(memory, roots * ((size_t)c->all + 1), sizeof *slopes),
           *by_inputs = arena_take(memory, roots * ((size_t)e->inputs + 1), sizeof *by_inputs),
           *values = arena_take(memory, roots, sizeof *values), *column = arena_take(memory, roots, sizeof *column);
    sides two = {arena_take(memory, roots, sizeof *two.below), arena_take(memory, roots, sizeof *two.above)};
    l.kinks = arena_take(memory, (size_t)(c->all + e->inputs) + 1, sizeof *l.kinks);
    slopes_by_coordinates(e, c, &at, slopes);
    for (int k = 0; k < e->inputs; k++) {
        changes_by_input(e, &at, k, column);
        for (int i = 0; i < e->roots; i++) {
            by_inputs[i * e->inputs + k] = column[i];
        }
    }
    find_kinks_of_coordinates(&l, &two, slopes);
    find_kinks_of_inputs(&l, &two, by_inputs);
    check_finite(&l, slopes, c->all);
    check_finite(&l, by_inputs, e->inputs);
    choose(&l, memory, slopes);
    values_at(e, &at, values);
    l.rates = in_chosen(c, memory, values, 1);
    l.outputs = values + e->states;
    l.a = in_basis(c, memory, reduced_rates(e, c, memory, slopes), c->count, c->chosen);
    l.b = in_chosen(c, memory, by_inputs, e->inputs);
    l.cy = in_basis(c, memory, slopes + e->states * c->all, e->outputs, NULL);
    l.d = by_inputs + e->states * e->inputs;
    return l;
}

double *matrix_without(const linear_model *of, const expansion *other)
{
    arena *memory = other->g.memory;
    const chart *c = &of->c;
    double *slopes = arena_take(memory, (size_t)(other->roots * c->all) + 1, sizeof *slopes);
    slopes_by_coordinates(other, c, &of->at, slopes);
    return in_basis(c, memory, reduced_rates(other, c, memory, slopes), c->count, c->chosen);
}
