#include "tools/isoc/formula/ticks.h"

#include <math.h>
#include <string.h>

#include "tools/isoc/formula/scalar.h"

/* The part of a stretch that lies before x: (x - from) / length, limited to [0, 1]. No branch and no index depends on
 * x, so each stretch is computed for every x. */
static node part_before(graph *g, node x, double from, double length)
{
    const node since = sub(g, x, constant(g, from));
    const node limited = function(g, OP_MIN, larger(g, since, constant(g, 0.0)), constant(g, length));
    return divide(g, limited, constant(g, length));
}

/* The value of a point; it has the dimension of all before it. */
static value value_at_point(values *v, const formula *f, const value *all)
{
    const value here = value_any(v, f);
    if (here.count == 0) {
        return nothing;
    }
    if (here.count != 1 || (!here.any && !all->any && !agree(v, here.dim, all->dim))) {
        return REFUSED(v->s, f->at, "the values of a table must be numbers of the same dimension");
    }
    return here;
}

/* The argument of a table: a number. */
static value argument_of_table(values *v, const formula *f)
{
    const value x = value_any(v, f);
    if (x.count > 1) {
        source_problem(v->s, f->at, "a table takes a number; this is a vector");
    }
    return x.count == 1 ? x : nothing;
}

/* A place, which must be above the one before it. Returns whether it is. */
static bool next_place(values *v, const formula *f, dimension expected, const double *before, double *to)
{
    *to = value_constant(v, f, expected, "a place of the table", (double)NAN);
    if (before != NULL && *to <= *before) {
        source_problem(v->s, f->at, "the places of a table must increase");
    }
    return before == NULL ? !isnan(*to) : *to > *before;
}

value table_of_formula(values *v, const formula *f)
{
    graph *g = v->g;
    if (f->count < 5 || f->count % 2 != 1) {
        return REFUSED(v->s, f->at,
                       "a table of a quantity needs pairs of place and value: table(x, 0 m: 0 N, 1 m: 8 N)");
    }
    const value x = argument_of_table(v, f->parts[0]);
    if (x.count == 0) {
        return nothing;
    }
    const value none = {.count = 1, .any = true};
    value sum = value_at_point(v, f->parts[2], &none), last = sum;
    double from = 0.0, to;
    bool rises = next_place(v, f->parts[1], x.dim, NULL, &from);
    for (size_t i = 3; i < f->count && sum.count > 0; i += 2) {
        rises = rises && next_place(v, f->parts[i], x.dim, &from, &to);
        const value here = value_at_point(v, f->parts[i + 1], &sum);
        if (here.count == 0 || !rises) {
            return nothing;
        }
        const node rise = sub(g, here.parts[0], last.parts[0]);
        sum.parts[0] = add(g, sum.parts[0], mul(g, rise, part_before(g, x.parts[0], from, to - from)));
        gather(&sum, &here);
        last = here;
        from = to;
    }
    return sum;
}

/* The part of each stretch between the places that lies before x. */
static node *parts_before(values *v, const value *x, const formula *const *places, size_t count)
{
    node *parts = arena_take(v->g->memory, count, sizeof *parts);
    double from = 0.0, to;
    for (size_t i = 0; i < count; i++) {
        if (!next_place(v, places[i], x->dim, i == 0 ? NULL : &from, &to)) {
            return NULL;
        }
        if (i > 0) {
            parts[i - 1] = part_before(v->g, x->parts[0], from, to - from);
        }
        from = to;
    }
    return parts;
}

/* first + sum of (next - one before) * part, over the stretches. */
static node along(graph *g, const node *points, size_t count, const node *parts)
{
    node sum = points[0];
    for (size_t i = 1; i < count; i++) {
        const node rise = sub(g, points[i], points[i - 1]);
        sum = add(g, sum, mul(g, rise, parts[i - 1]));
    }
    return sum;
}

/* The values of the rows, one after the other, each as many as there are places; the dimension of all in *of. */
static node *values_of_grid(values *v, const formula *f, size_t columns, value *all)
{
    const size_t rows = f->count - 3;
    node *cells = arena_take(v->g->memory, rows * columns, sizeof *cells);
    *all = (value){.count = 1, .any = true};
    for (size_t j = 0; j < rows; j++) {
        const formula *row = f->parts[3 + j];
        if (row->count != columns + 1) {
            source_problem(v->s, row->at,
                           "a row of this table has a place and %zu values, one for each place of the first line",
                           columns);
            return NULL;
        }
        for (size_t i = 0; i < columns; i++) {
            const value here = value_at_point(v, row->parts[1 + i], all);
            if (here.count == 0) {
                return NULL;
            }
            cells[j * columns + i] = here.parts[0];
            gather(all, &here);
        }
    }
    return cells;
}

value grid_of_formula(values *v, const formula *f)
{
    graph *g = v->g;
    const size_t rows = f->count - 3, columns = f->parts[2]->count;
    if (f->count < 5 || columns < 2) {
        return REFUSED(v->s, f->at,
                       "a table of two quantities needs two places and two rows at least: table(x, y; 0 m, 1 m; 0 s: 1 "
                       "N, 2 N; 1 s: "
                       "3 N, 5 N)");
    }
    const value x = argument_of_table(v, f->parts[0]), y = argument_of_table(v, f->parts[1]);
    if (x.count == 0 || y.count == 0) {
        return nothing;
    }
    const formula **places = arena_take(g->memory, rows, sizeof *places);
    for (size_t j = 0; j < rows; j++) {
        places[j] = f->parts[3 + j]->parts[0];
    }
    value sum;
    const node *const in_row = parts_before(v, &x, (const formula *const *)f->parts[2]->parts, columns);
    const node *const in_column = in_row == NULL ? NULL : parts_before(v, &y, places, rows);
    const node *const cells = in_column == NULL ? NULL : values_of_grid(v, f, columns, &sum);
    if (cells == NULL) {
        return nothing;
    }
    /* The first row, and for each stretch of y the rise from row to row, which is a row itself. */
    sum.parts[0] = along(g, cells, columns, in_row);
    node *rises = arena_take(g->memory, columns, sizeof *rises);
    for (size_t j = 1; j < rows; j++) {
        for (size_t i = 0; i < columns; i++) {
            rises[i] = sub(g, cells[j * columns + i], cells[(j - 1) * columns + i]);
        }
        const node rise = along(g, rises, columns, in_row);
        sum.parts[0] = add(g, sum.parts[0], mul(g, rise, in_column[j - 1]));
    }
    return sum;
}

/* The part of a smooth curve that is done. With c = (tick - from) / ticks, limited to [0, 1], it is c^3 (10 - 15 c + 6
 * c^2), whose first and second derivatives are zero at both ends (the 3-4-5 polynomial of cams). With d = c - 1/2 it is
 * 1/2 + d (15/8 - d^2 (5 - 6 d^2)), which has a tenth of the rounding error. `first` is the tick at which the first
 * curve of the ramp begins. */
static node smooth_part(values *v, double first, double from, double ticks)
{
    graph *g = v->g;
    const node since = timed(g, OP_SINCE, first, v->step);
    const node part = divide(g, sub(g, since, constant(g, (from - first) * v->step)), constant(g, ticks * v->step));
    const node below = larger(g, neg(g, part), constant(g, -1.0)), c = larger(g, constant(g, 0.0), neg(g, below));
    const node d = sub(g, c, constant(g, 0.5)), square = mul(g, d, d);
    const node inner = sub(g, constant(g, 5.0), mul(g, constant(g, 6.0), square));
    const node outer = sub(g, constant(g, 1.875), mul(g, square, inner));
    return add(g, constant(g, 0.5), mul(g, d, outer));
}

/* A table has straight lines between the points, a ramp smooth curves; outside both have the end values. */
value points_of_formula(values *v, const formula *f)
{
    const bool is_smooth = strcmp(f->name, "ramp") == 0;
    if (v->is_smooth && !is_smooth) {
        return REFUSED(v->s, f->at, "a motion must be smooth, and a table has corners: use ramp");
    }
    if (!allows_time(v, f)) {
        return nothing;
    }
    if (f->count < 2 || f->count % 2 != 0) {
        return REFUSED(v->s, f->at, "a %s needs pairs of time and value: %s(0 s: 0 N, 1 s: 8 N)", f->name, f->name);
    }
    const char *a_time = arena_format(v->s->memory, "a time of the %s", f->name);
    value sum = value_any(v, f->parts[1]), last = sum;
    const double first = value_constant(v, f->parts[0], second, a_time, 0.0) / v->step;
    double last_time = first;
    for (size_t i = 2; i < f->count && sum.count > 0; i += 2) {
        const double time = value_constant(v, f->parts[i], second, a_time, 0.0) / v->step;
        const value here = value_any(v, f->parts[i + 1]);
        if (here.count == 0) {
            return nothing;
        }
        if (here.count != 1 || last.count != 1 || (!here.any && !last.any && !agree(v, here.dim, last.dim))) {
            return REFUSED(v->s, f->parts[i + 1]->at, "the values of a %s must be numbers of the same dimension",
                           f->name);
        }
        if (!(time > last_time) || last_time < 0.0) {
            return REFUSED(v->s, f->parts[i]->at, "the times of a %s must begin at 0 or later, and increase", f->name);
        }
        if (time > most_ticks) {
            return REFUSED(v->s, f->parts[i]->at, "a time of a %s is at most %g s with this step (%g ticks)", f->name,
                           most_ticks * v->step, most_ticks);
        }
        const node rise = sub(v->g, here.parts[0], last.parts[0]);
        const double ticks = time - last_time;
        const node weight = is_smooth ? rise : divide(v->g, rise, constant(v->g, ticks));
        const node part = is_smooth ? smooth_part(v, first, last_time, ticks) : timed(v->g, OP_RAMP, last_time, ticks);
        sum.parts[0] = add(v->g, sum.parts[0], mul(v->g, weight, part));
        gather(&sum, &here);
        last = here;
        last.dim = sum.dim;
        last.any = sum.any;
        last_time = time;
    }
    return sum;
}
