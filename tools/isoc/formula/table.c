#include "tools/isoc/formula/ticks.h"

#include <math.h>
#include <string.h>

#include "tools/isoc/formula/scalar.h"

typedef enum beyond { HELD, LINEAR, ERROR } beyond;

static beyond beyond_of(const formula *f)
{
    const char *word = f->beyond.text;
    return word == NULL || strcmp(word, "held") == 0 ? HELD : strcmp(word, "linear") == 0 ? LINEAR : ERROR;
}

/* The places of a table, from the first to the last. */
typedef struct places {
    size_t count;
    double *at; /* [count] */
} places;

/* The part of a stretch that lies before x: (x - from) / length, limited to [0, 1]; with `beyond linear` the first one
 * has no lower limit, the last one no upper. No branch and no index depends on x, so each stretch is computed for
 * every x. */
static node part_before(graph *g, node x, const places *of, size_t i, beyond end)
{
    const double length = of->at[i + 1] - of->at[i];
    const bool is_open_below = end == LINEAR && i == 0, is_open_above = end == LINEAR && i + 2 == of->count;
    const node since = sub(g, x, constant(g, of->at[i]));
    const node positive = is_open_below ? since : larger(g, since, constant(g, 0.0));
    const node limited = is_open_above ? positive : function(g, OP_MIN, positive, constant(g, length));
    return divide(g, limited, constant(g, length));
}

/* With `beyond error` no number beyond the places. */
static value within_places(values *v, const formula *f, const value *x, const places *of, value result)
{
    graph *g = v->g;
    const node at = x->parts[0], first = constant(g, of->at[0]), last = constant(g, of->at[of->count - 1]);
    if (beyond_of(f) != ERROR) {
        return result;
    }
    if (!keeps(v, (condition){first, at, false}) || !keeps(v, (condition){at, last, false})) {
        return REFUSED(v->s, f->beyond.at, "the table is from %g to %g, and this is %g", of->at[0],
                       of->at[of->count - 1], value_now(v, at));
    }
    const node behind = above(g, at, last);
    const node outside = larger(g, above(g, first, at), behind);
    result.parts[0] = function(g, OP_ONLY, sub(g, constant(g, 1.0), outside), result.parts[0]);
    return result;
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

/* The slopes of a curve through points, of which none is steeper than three times the flatter of the lines beside it:
 * between two points it stays between them (Fritsch and Butland 1984, A method for constructing local monotone
 * piecewise cubic interpolants, SIAM J. Sci. Stat. Comput. 5(2); at the ends by three points). */
static double end_slope(double h, double other, double d, double next)
{
    const double slope = ((2.0 * h + other) * d - h * next) / (h + other);
    return slope * d <= 0.0 ? 0.0 : d * next <= 0.0 && fabs(slope) > 3.0 * fabs(d) ? 3.0 * d : slope;
}

static double *slopes_of(arena *memory, const places *of, const double *y)
{
    const size_t last = of->count - 1;
    double *d = arena_take(memory, of->count, sizeof *d), *h = arena_take(memory, of->count, sizeof *h);
    double *slope = arena_take(memory, of->count, sizeof *slope);
    for (size_t i = 0; i < last; i++) {
        h[i] = of->at[i + 1] - of->at[i];
        d[i] = (y[i + 1] - y[i]) / h[i];
    }
    for (size_t i = 1; i < last; i++) {
        const double left = 2.0 * h[i] + h[i - 1], right = h[i] + 2.0 * h[i - 1];
        slope[i] = d[i - 1] * d[i] <= 0.0 ? 0.0 : (left + right) / (left / d[i - 1] + right / d[i]);
    }
    slope[0] = last == 1 ? d[0] : end_slope(h[0], h[1], d[0], d[1]);
    slope[last] = last == 1 ? d[0] : end_slope(h[last - 1], h[last - 2], d[last - 1], d[last - 2]);
    return slope;
}

/* The values of a table that is smooth: numbers; NULL after noting that one is none. */
static double *numbers_of(values *v, const formula *f, const places *of, const node *points)
{
    double *y = arena_take(v->g->memory, of->count, sizeof *y);
    for (size_t i = 0; i < of->count; i++) {
        if (!is_constant(v->g, points[i])) {
            source_problem(v->s, f->parts[2 * i + 2]->at,
                           "the values of a smooth table are constants: its slopes follow from them");
            return NULL;
        }
        y[i] = constant_value(v->g, points[i]);
    }
    return y;
}

/* Each stretch adds its rise r on the curve t (a + t (b + t c)) of its part t, with the slopes at its ends; beyond the
 * ends, with `beyond linear`, the slopes there go on. */
static node curve_along(graph *g, const places *of, const double *y, node x, beyond end)
{
    const double *slope = slopes_of(g->memory, of, y);
    const size_t last = of->count - 1;
    node sum = constant(g, y[0]);
    for (size_t i = 0; i < last; i++) {
        const double h = of->at[i + 1] - of->at[i], rise = y[i + 1] - y[i];
        const double a = h * slope[i], to = h * slope[i + 1], b = 3.0 * rise - 2.0 * a - to, c = a + to - 2.0 * rise;
        const node t = part_before(g, x, of, i, HELD);
        const node inner = add(g, constant(g, b), mul(g, t, constant(g, c)));
        sum = add(g, sum, mul(g, t, add(g, constant(g, a), mul(g, t, inner))));
    }
    if (end == LINEAR) {
        const node below = function(g, OP_MIN, sub(g, x, constant(g, of->at[0])), constant(g, 0.0));
        const node beyond_last = larger(g, sub(g, x, constant(g, of->at[last])), constant(g, 0.0));
        sum = add(g, sum, mul(g, constant(g, slope[0]), below));
        sum = add(g, sum, mul(g, constant(g, slope[last]), beyond_last));
    }
    return sum;
}

/* The parts of all stretches that lie before x. */
static node *parts_before(graph *g, node x, const places *of, beyond end)
{
    node *parts = arena_take(g->memory, of->count, sizeof *parts);
    for (size_t i = 0; i + 1 < of->count; i++) {
        parts[i] = part_before(g, x, of, i, end);
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
    places of = {f->count / 2, arena_take(g->memory, f->count / 2, sizeof *of.at)};
    node *points = arena_take(g->memory, of.count, sizeof *points);
    value all = {.count = 1, .any = true};
    for (size_t i = 0; i < of.count; i++) {
        if (!next_place(v, f->parts[2 * i + 1], x.dim, i == 0 ? NULL : &of.at[i - 1], &of.at[i])) {
            return nothing;
        }
        const value here = value_at_point(v, f->parts[2 * i + 2], &all);
        if (here.count == 0) {
            return nothing;
        }
        points[i] = here.parts[0];
        gather(&all, &here);
    }
    const double *y = f->is_smooth ? numbers_of(v, f, &of, points) : NULL;
    if (f->is_smooth && y == NULL) {
        return nothing;
    }
    const beyond end = beyond_of(f);
    all.parts[0] = f->is_smooth ? curve_along(g, &of, y, x.parts[0], end)
                                : along(g, points, of.count, parts_before(g, x.parts[0], &of, end));
    return within_places(v, f, &x, &of, all);
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

/* Places, which increase. */
static bool read_places(values *v, const value *x, const formula *const *written, places *to)
{
    to->at = arena_take(v->g->memory, to->count, sizeof *to->at);
    for (size_t i = 0; i < to->count; i++) {
        if (!next_place(v, written[i], x->dim, i == 0 ? NULL : &to->at[i - 1], &to->at[i])) {
            return false;
        }
    }
    return true;
}

value grid_of_formula(values *v, const formula *f)
{
    graph *g = v->g;
    const size_t rows = f->count < 3 ? 0 : f->count - 3, columns = f->count < 3 ? 0 : f->parts[2]->count;
    if (f->count < 5 || columns < 2) {
        return REFUSED(v->s, f->at,
                       "a table of two quantities needs two places and two rows at least: table(x, y; 0 m, 1 m; 0 s: 1 "
                       "N, 2 N; 1 s: "
                       "3 N, 5 N)");
    }
    if (f->is_smooth) {
        return REFUSED(v->s, f->at, "a smooth table is of one quantity");
    }
    const value x = argument_of_table(v, f->parts[0]), y = argument_of_table(v, f->parts[1]);
    if (x.count == 0 || y.count == 0) {
        return nothing;
    }
    const formula **of_rows = arena_take(g->memory, rows, sizeof *of_rows);
    for (size_t j = 0; j < rows; j++) {
        of_rows[j] = f->parts[3 + j]->parts[0];
    }
    value sum;
    places across = {.count = columns}, down = {.count = rows};
    if (!read_places(v, &x, (const formula *const *)f->parts[2]->parts, &across) ||
        !read_places(v, &y, of_rows, &down)) {
        return nothing;
    }
    const beyond end = beyond_of(f);
    const node *const in_row = parts_before(g, x.parts[0], &across, end);
    const node *const in_column = parts_before(g, y.parts[0], &down, end);
    const node *const cells = values_of_grid(v, f, columns, &sum);
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
    sum = within_places(v, f, &x, &across, sum);
    return sum.count == 0 ? nothing : within_places(v, f, &y, &down, sum);
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
