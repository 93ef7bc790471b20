#include "tools/isoc/linear/linear.h"

#include <math.h>
#include <string.h>

#include "tools/isoc/base/numbers.h"

void slopes_by_coordinates(const expansion *e, const chart *c, const point *at, double *slopes)
{
    arena *memory = e->l.g.memory;
    double *along = arena_take(memory, (size_t)e->states + 1, sizeof *along),
           *column = arena_take(memory, (size_t)e->roots + 1, sizeof *column);
    for (int k = 0; k < c->all; k++) {
        for (int i = 0; i < e->states; i++) {
            along[i] = c->turn[i * c->all + k];
        }
        numbers_at(e, at, along, e->l.changes, column);
        for (int i = 0; i < e->roots; i++) {
            slopes[i * c->all + k] = column[i];
        }
    }
}

/* The rate of small angles: it depends on none of them, for a turn of their frame turns the rate too, and only the
 * change of the angular velocity remains. */
double *reduced_rates(const chart *c, arena *memory, const double *slopes)
{
    double *result = product_of_matrices(memory, c->back, c->all, c->states, slopes, c->all);
    for (int i = 0; i < c->all; i++) {
        for (int k = 0; k < c->all; k++) {
            const coordinate *row = &c->coordinates[i], *column = &c->coordinates[k];
            if (row->state < 0 && column->state < 0 && row->segment == column->segment) {
                result[i * c->all + k] = 0.0;
            }
        }
    }
    return result;
}

/* --- kinks --- */

/* The slopes of all roots on both sides of a point. */
typedef struct sides {
    double *below, *above;
} sides;

static const char *name_of_root(const expansion *e, int root)
{
    const plant *p = e->p;
    arena *memory = e->l.g.memory;
    return root < e->states ? arena_format(memory, "the rate of %s", mechanism_states(p->m, memory)[root].about.name)
           : root < e->states + e->outputs ? p->outputs.names[root - e->states]
                                           : "a closure";
}

/* Where to look: along an independent coordinate, or an input. */
typedef struct direction {
    const linear_model *l;
    int coordinate, input; /* one of them is -1 */
} direction;

/* The slopes at a distance from the point. */
static void slopes_beside(const direction *d, double distance, double *slopes)
{
    const expansion *e = d->l->e;
    const point beside = point_copy(e->l.g.memory, e, &d->l->at);
    if (d->input >= 0) {
        beside.u[d->input] += distance * (1.0 + fabs(beside.u[d->input]));
        numbers_at(e, &beside, NULL, e->by_input + d->input * e->roots, slopes);
        return;
    }
    double *along = arena_take(e->l.g.memory, (size_t)e->states + 1, sizeof *along);
    for (int i = 0; i < e->states; i++) {
        along[i] = d->l->up[i * d->l->c.count + d->coordinate];
        beside.x[i] += distance * along[i];
    }
    numbers_at(e, &beside, along, e->l.changes, slopes);
}

static sides sides_at(const direction *d, double distance)
{
    const expansion *e = d->l->e;
    const size_t roots = (size_t)e->roots + 1;
    const sides result = {arena_take(e->l.g.memory, roots, sizeof *result.below),
                          arena_take(e->l.g.memory, roots, sizeof *result.above)};
    slopes_beside(d, -distance, result.below);
    slopes_beside(d, distance, result.above);
    return result;
}

/* Both sides of a kink differ by as much four times nearer to it; those of a curve by a quarter of that. */
static bool is_kink(const sides *far, const sides *near, int root)
{
    const double apart = fabs(far->above[root] - far->below[root]);
    const double nearer = fabs(near->above[root] - near->below[root]);
    return apart > 1e-3 * (fabs(far->above[root]) + fabs(far->below[root])) && apart > 1e-9 && nearer > 0.6 * apart;
}

/* Puts the mean of both sides in the place of the slopes at[root * stride] that have a kink. */
static void take_means(linear_model *l, const direction *d, const char *by, double *at, int stride)
{
    const expansion *e = l->e;
    const double distance = 1e-8;
    const sides far = sides_at(d, distance), near = sides_at(d, 0.25 * distance);
    double largest = 0.0;
    int found = -1;
    for (int i = 0; i < e->states + e->outputs; i++) {
        if (is_kink(&far, &near, i)) {
            const double apart = fabs(near.above[i] - near.below[i]);
            at[i * stride] = 0.5 * (near.above[i] + near.below[i]);
            found = apart > largest ? i : found;
            largest = fmax(largest, apart);
        }
    }
    if (found >= 0) {
        l->kinks[l->kink_count++] = (kink){by, name_of_root(e, found), near.below[found], near.above[found]};
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

/* The rows of the independent coordinates among those of all. */
static double *chosen_rows(const chart *c, arena *memory, const double *all, int columns)
{
    double *result = arena_take(memory, (size_t)(c->count * columns) + 1, sizeof *result);
    for (int i = 0; i < c->count; i++) {
        memcpy(result + i * columns, all + c->chosen[i] * columns, (size_t)columns * sizeof *result);
    }
    return result;
}

/* A, where nothing has a kink. */
static double *smooth_matrix(const chart *c, arena *memory, const double *slopes)
{
    const double *rates = chosen_rows(c, memory, reduced_rates(c, memory, slopes), c->all);
    return product_of_matrices(memory, rates, c->count, c->all, c->basis, c->count);
}

static void check_finite(linear_model *l, const double *slopes, int columns)
{
    for (int i = 0; i < l->e->roots && l->not_finite == NULL; i++) {
        for (int k = 0; k < columns; k++) {
            if (!isfinite(slopes[i * columns + k])) {
                l->not_finite = name_of_root(l->e, i);
                return;
            }
        }
    }
}

/* A and C: the slopes in the basis, and the changes of these by kinks. */
static void fill_by_coordinates(linear_model *l, arena *memory, const double *slopes)
{
    const expansion *e = l->e;
    const chart *c = &l->c;
    double *smooth = product_of_matrices(memory, slopes, e->roots, c->all, c->basis, c->count);
    double *kinked = list_copy(memory, smooth, (size_t)(e->roots * c->count), sizeof *smooth);
    for (int j = 0; j < c->count; j++) {
        take_means(l, &(direction){l, j, -1}, c->coordinates[c->chosen[j]].name, kinked + j, c->count);
    }
    for (int i = 0; i < e->roots * c->count; i++) {
        kinked[i] -= smooth[i];
    }
    const double *moved = product_of_matrices(memory, l->down, c->count, c->states, kinked, c->count);
    l->a = smooth_matrix(c, memory, slopes);
    l->cy = smooth + e->states * c->count;
    for (int i = 0; i < c->count * c->count; i++) {
        l->a[i] += moved[i];
    }
    for (int i = 0; i < e->outputs * c->count; i++) {
        l->cy[i] += kinked[e->states * c->count + i];
    }
}

/* B and D. */
static void fill_by_inputs(linear_model *l, arena *memory)
{
    const expansion *e = l->e;
    const size_t roots = (size_t)e->roots + 1;
    double *slopes = arena_take(memory, roots * ((size_t)e->inputs + 1), sizeof *slopes),
           *column = arena_take(memory, roots, sizeof *column);
    for (int k = 0; k < e->inputs; k++) {
        numbers_at(e, &l->at, NULL, e->by_input + k * e->roots, column);
        for (int i = 0; i < e->roots; i++) {
            slopes[i * e->inputs + k] = column[i];
        }
        take_means(l, &(direction){l, -1, k}, e->p->m->inputs.all[k].name, slopes + k, e->inputs);
    }
    check_finite(l, slopes, e->inputs);
    l->b = product_of_matrices(memory, l->down, l->c.count, e->states, slopes, e->inputs);
    l->d = slopes + e->states * e->inputs;
}

linear_model model_at(const expansion *e, const scene *written, point at)
{
    arena *memory = e->l.g.memory;
    const size_t roots = (size_t)e->roots + 1;
    linear_model l = {.e = e, .at = at, .c = chart_at(e->p->m, written, memory, at.x)};
    double *slopes = arena_take(memory, roots * ((size_t)l.c.all + 1), sizeof *slopes),
           *now = arena_take(memory, roots, sizeof *now);
    l.kinks = arena_take(memory, (size_t)(l.c.all + e->inputs) + 1, sizeof *l.kinks);
    slopes_by_coordinates(e, &l.c, &at, slopes);
    check_finite(&l, slopes, l.c.all);
    choose(&l, memory, slopes);
    l.up = product_of_matrices(memory, l.c.turn, e->states, l.c.all, l.c.basis, l.c.count);
    l.down = chosen_rows(&l.c, memory, l.c.back, e->states);
    numbers_at(e, &at, NULL, e->l.values, now);
    l.rates = product_of_matrices(memory, l.down, l.c.count, e->states, now, 1);
    l.outputs = now + e->states;
    fill_by_coordinates(&l, memory, slopes);
    fill_by_inputs(&l, memory);
    return l;
}

double *matrix_without(const linear_model *model, const expansion *other)
{
    arena *memory = other->l.g.memory;
    const chart *c = &model->c;
    double *slopes = arena_take(memory, (size_t)(other->roots * c->all) + 1, sizeof *slopes);
    slopes_by_coordinates(other, c, &model->at, slopes);
    return smooth_matrix(c, memory, slopes);
}
