#include "tools/isoc/dynamics/dynamics.h"

#include <math.h>

#include "tools/isoc/base/numbers.h"

/* All in m or rad. The accuracy of a multiple root: the square root of the rounding. */
static const double found_to = 1e-5;
/* The length of a trial step, and the distance up to which two positions are the same. */
static const double probe = 1e-3, beside = 1e-4;
/* The largest gap of a closed loop, and the rounding of a coordinate that is zero. */
static const double closed = 1e-10, rounding = 1e-14;

static const double rank_limit = 1e-10; /* relative, of a singular value that is zero */

/* The constraints in the free coordinates, at c->x. */
typedef struct linear {
    const closing *c;
    bool rates;
    int *dofs; /* [columns] degrees of freedom */
    int rows, columns;
} linear;

/* Their Jacobian, and the directions in which it is as good as zero: they lead nowhere, or on, to second order. */
typedef struct split {
    decomposition a;
    bool *is_regular; /* [columns] the others */
    int *singular;    /* [count] */
    int count;
} split;

static linear linear_of(const closing *c, bool rates, const bool *is_free)
{
    linear result = {.c = c, .rates = rates, .rows = c->phi->count};
    result.dofs = arena_take(c->memory, (size_t)c->m->dof_count + 1, sizeof *result.dofs);
    for (int f = 0; f < c->m->dof_count; f++) {
        if (is_free == NULL || is_free[f]) {
            result.dofs[result.columns++] = f;
        }
    }
    return result;
}

static double *matrix_at(const linear *l)
{
    const closing *c = l->c;
    double *a = arena_take(c->memory, (size_t)(l->rows * l->columns) + 1, sizeof *a);
    for (int r = 0; r < l->rows; r++) {
        for (int j = 0; j < l->columns && closing_counts(c, l->rates, r); j++) {
            a[r * l->columns + j] = c->jacobian[r * c->m->dof_count + l->dofs[j]];
        }
    }
    return a;
}

static double distance(const closing *c, const double *from)
{
    double square = 0.0;
    for (int i = 0; i < c->m->position_count; i++) {
        square += (c->x[i] - from[i]) * (c->x[i] - from[i]);
    }
    return sqrt(square);
}

/* Moves by a change of the free coordinates. */
static void move_free(const linear *l, const double *by)
{
    double *all = arena_take(l->c->memory, (size_t)l->c->m->dof_count + 1, sizeof *all);
    for (int i = 0; i < l->columns; i++) {
        all[l->dofs[i]] = by[i];
    }
    closing_move(l->c, false, all);
    closing_evaluate(l->c);
}

/* Moves `by` times the j-th direction of a. */
static void move_along(const linear *l, const decomposition *a, int j, double by)
{
    double *change = arena_take(l->c->memory, (size_t)l->columns + 1, sizeof *change);
    for (int i = 0; i < l->columns; i++) {
        change[i] = by * a->v[i * l->columns + j];
    }
    move_free(l, change);
}

/* The change of the Jacobian along the j-th direction, per m or rad. */
static double *change_along(const linear *l, const decomposition *a, int j)
{
    const double *from = closing_keep(l->c);
    move_along(l, a, j, 0.1 * probe);
    double *change = matrix_at(l);
    closing_restore(l->c, from);
    move_along(l, a, j, -0.1 * probe);
    const double *behind = matrix_at(l);
    closing_restore(l->c, from);
    for (int i = 0; i < l->rows * l->columns; i++) {
        change[i] = (change[i] - behind[i]) / (0.2 * probe);
    }
    return change;
}

/* Whether the singular value is zero, or within found_to of where it may be. */
static bool is_singular(const linear *l, const decomposition *a, int j)
{
    if (a->value[j] <= rank_limit * a->largest) {
        return true;
    }
    if (a->value[j] > probe * fmax(a->largest, 1.0)) {
        return false;
    }
    const double *change = change_along(l, a, j);
    double square = 0.0;
    for (int i = 0; i < l->rows * l->columns; i++) {
        square += change[i] * change[i];
    }
    return a->value[j] <= found_to * sqrt(square);
}

static split split_at(const linear *l)
{
    arena *memory = l->c->memory;
    split result = {.a = decompose(memory, matrix_at(l), l->rows, l->columns)};
    result.singular = arena_take(memory, (size_t)l->columns + 1, sizeof *result.singular);
    result.is_regular = arena_take(memory, (size_t)l->columns + 1, sizeof *result.is_regular);
    for (int j = 0; j < l->columns; j++) {
        result.is_regular[j] = !is_singular(l, &result.a, j);
        if (!result.is_regular[j]) {
            result.singular[result.count++] = j;
        }
    }
    return result;
}

/* The freedoms of the closed loops beside this position; they are looked for from `by` times the directions i and j on.
 * 0 if they close only here. */
static int freedoms_beside(const linear *l, const bool *is_free, const decomposition *a, int i, int j, double by)
{
    const double *from = closing_keep(l->c);
    move_along(l, a, i, by);
    if (j != i) {
        move_along(l, a, j, fabs(by));
    }
    const gap left = closing_run(l->c, false, is_free);
    const int freedoms = left.size <= closed && distance(l->c, from) > beside ? split_at(l).count : 0;
    closing_restore(l->c, from);
    return freedoms;
}

/* The freedoms of the closed loops along the directions that the constraints do not resist here: tried alone and in
 * pairs, to both sides, until a way is found. */
static int find_freedoms(const linear *l, const bool *is_free, const split *s)
{
    int freedoms = 0;
    for (int i = 0; i < s->count; i++) {
        for (int j = i; j >= 0; j--) {
            for (int sign = -1; sign <= 1 && freedoms == 0; sign += 2) {
                freedoms = freedoms_beside(l, is_free, &s->a, s->singular[i], s->singular[j], sign * probe);
            }
        }
    }
    return freedoms;
}

/* by[columns], through the regular directions only: the least change with these images b[rows]. Takes the images that
 * it has out of b. */
static void reach_regular(const split *s, double *b, double *by)
{
    const decomposition *a = &s->a;
    for (int j = 0; j < a->columns; j++) {
        double along = 0.0;
        for (int i = 0; i < a->rows && s->is_regular[j]; i++) {
            along += a->u[i * a->columns + j] * b[i] / (a->value[j] * a->value[j]);
        }
        for (int i = 0; i < a->rows; i++) {
            b[i] -= a->u[i * a->columns + j] * along;
        }
        for (int i = 0; i < a->columns; i++) {
            by[i] += a->v[i * a->columns + j] * along;
        }
    }
}

/* to[rows]: `sign` times m times the j-th direction, less its part in the range of the regular directions. */
static void take_image(const linear *l, const split *s, const double *m, int j, double sign, double *to)
{
    double *by = arena_take(l->c->memory, (size_t)l->columns + 1, sizeof *by);
    for (int i = 0; i < l->rows; i++) {
        to[i] = 0.0;
        for (int n = 0; n < l->columns; n++) {
            to[i] += sign * m[i * l->columns + n] * s->a.v[n * l->columns + j];
        }
    }
    reach_regular(s, to, by);
}

/* Moves along the singular directions, of which there are `count`, to where their images are zero, which change in
 * proportion to the moves; then closes the gaps along the regular ones. Returns the largest move. */
static double approach(const linear *l, int count)
{
    arena *memory = l->c->memory;
    const split s = split_at(l);
    if (s.count != count) {
        return HUGE_VAL;
    }
    const int equations = l->rows * count;
    const double *here = matrix_at(l);
    double *slopes = arena_take(memory, (size_t)(equations * count) + 1, sizeof *slopes);
    double *images = arena_take(memory, (size_t)equations + 1, sizeof *images);
    double *image = arena_take(memory, (size_t)l->rows + 1, sizeof *image);
    double *moves = arena_take(memory, (size_t)count + 1, sizeof *moves);
    for (int j = 0; j < count; j++) {
        take_image(l, &s, here, s.singular[j], -1.0, images + j * l->rows);
    }
    for (int k = 0; k < count; k++) {
        const double *change = change_along(l, &s.a, s.singular[k]);
        for (int j = 0; j < count; j++) {
            take_image(l, &s, change, s.singular[j], 1.0, image);
            for (int i = 0; i < l->rows; i++) {
                slopes[(j * l->rows + i) * count + k] = image[i];
            }
        }
    }
    (void)least_squares(memory, slopes, equations, count, images, moves);
    double largest = 0.0;
    for (int k = 0; k < count; k++) {
        move_along(l, &s.a, s.singular[k], moves[k]);
        largest = fmax(largest, fabs(moves[k]));
    }
    return largest;
}

static double largest_gap(const closing *c)
{
    double largest = 0.0;
    for (int r = 0; r < c->phi->count; r++) {
        largest = closing_counts(c, false, r) ? fmax(largest, fabs(closing_gap(c, false, r))) : largest;
    }
    return largest;
}

/* Closes the gaps along the regular directions. */
static void close_regular(const linear *l)
{
    const closing *c = l->c;
    const split s = split_at(l);
    double *wanted = arena_take(c->memory, (size_t)l->rows + 1, sizeof *wanted);
    double *by = arena_take(c->memory, (size_t)l->columns + 1, sizeof *by);
    for (int r = 0; r < l->rows; r++) {
        wanted[r] = closing_counts(c, false, r) ? -closing_gap(c, false, r) : 0.0;
    }
    reach_regular(&s, wanted, by);
    move_free(l, by);
}

/* Moves to the multiple root. Returns whether there is one of the second order near here; else stays. */
static bool settle(const linear *l, int count)
{
    enum { ITERATIONS = 10 };
    const closing *c = l->c;
    const double *from = closing_keep(c), before = largest_gap(c);
    double move = 0.0;
    for (int i = 0; i < ITERATIONS && move <= probe; i++) {
        move = approach(l, count);
        close_regular(l);
    }
    if (!(move <= closed) || !(largest_gap(c) <= fmax(before, closed)) || !(distance(c, from) <= probe)) {
        closing_restore(c, from);
        return false;
    }
    for (int i = 0; i < c->m->position_count; i++) {
        c->x[i] = fabs(c->x[i]) < rounding ? 0.0 : c->x[i];
    }
    closing_evaluate(c);
    return true;
}

int branches_look(const closing *c, const bool *is_free, bool *meets)
{
    closing_evaluate(c);
    const linear l = linear_of(c, false, is_free);
    const split s = split_at(&l);
    const int freedoms = find_freedoms(&l, is_free, &s);
    const bool is_settled = s.count > 0 && freedoms == 0 && settle(&l, s.count);
    for (int k = 0; k < s.count && freedoms == 0; k++) {
        const bool is_multiple = is_settled || s.a.value[s.singular[k]] <= rank_limit * s.a.largest;
        for (int i = 0; i < l.columns && is_multiple; i++) {
            meets[l.dofs[i]] = meets[l.dofs[i]] || fabs(s.a.v[i * l.columns + s.singular[k]]) > found_to;
        }
    }
    return freedoms;
}

int branches_rank_nearby(const closing *c)
{
    const double *from = closing_keep(c);
    bool *all = arena_take(c->memory, (size_t)c->m->dof_count + 1, sizeof *all);
    double *by = arena_take(c->memory, (size_t)c->m->dof_count + 1, sizeof *by);
    for (int f = 0; f < c->m->dof_count; f++) {
        all[f] = true;
        by[f] = probe * (1.0 + sin(1.0 + f)); /* no two alike */
    }
    closing_move(c, false, by);
    (void)closing_run(c, false, all);
    const linear l = linear_of(c, true, NULL);
    const int rank = l.columns - split_at(&l).count;
    closing_restore(c, from);
    return rank;
}
