#include "tools/isoc/formula/table.h"

#include <math.h>

static const value nothing = {0};

/* The part of a stretch that lies before x: (x - from) / length, limited to [0, 1]. No branch and no index depends on x, so
 * each stretch is computed for every x. */
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
    if (here.count != 1 || (!here.any && !all->any && !agree(v, here.of, all->of))) {
        source_problem(v->s, f->at, "the values of a table must be numbers of the same dimension");
        return nothing;
    }
    return here;
}

/* What the table is of: a number. */
static value argument_of_table(values *v, const formula *f)
{
    const value x = value_any(v, f);
    if (x.count > 1) {
        source_problem(v->s, f->at, "a table is of a number; this is a vector");
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
        source_problem(v->s, f->at,
                       "a table of a quantity needs pairs of place and value: table(x, 0 m: 0 N, 1 m: 8 N)");
        return nothing;
    }
    const value x = argument_of_table(v, f->parts[0]);
    if (x.count == 0) {
        return nothing;
    }
    const value none = {.count = 1, .any = true};
    value sum = value_at_point(v, f->parts[2], &none), last = sum;
    double from = 0.0, to;
    bool rises = next_place(v, f->parts[1], x.of, NULL, &from);
    for (size_t i = 3; i < f->count && sum.count > 0; i += 2) {
        rises = rises && next_place(v, f->parts[i], x.of, &from, &to);
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

/* What of each stretch between the places lies before x. */
static node *parts_before(values *v, const value *x, const formula *const *places, size_t count)
{
    node *parts = arena_take(v->g->memory, count, sizeof *parts);
    double from = 0.0, to;
    for (size_t i = 0; i < count; i++) {
        if (!next_place(v, places[i], x->of, i == 0 ? NULL : &from, &to)) {
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
static node *values_of_grid(values *v, const formula *f, size_t columns, value *of)
{
    const size_t rows = f->count - 3;
    node *cells = arena_take(v->g->memory, rows * columns, sizeof *cells);
    *of = (value){.count = 1, .any = true};
    for (size_t j = 0; j < rows; j++) {
        const formula *row = f->parts[3 + j];
        if (row->count != columns + 1) {
            source_problem(v->s, row->at,
                           "a row of this table has a place and %zu values, one for each place of the first line",
                           columns);
            return NULL;
        }
        for (size_t i = 0; i < columns; i++) {
            const value here = value_at_point(v, row->parts[1 + i], of);
            if (here.count == 0) {
                return NULL;
            }
            cells[j * columns + i] = here.parts[0];
            gather(of, &here);
        }
    }
    return cells;
}

value grid_of_formula(values *v, const formula *f)
{
    graph *g = v->g;
    const size_t rows = f->count - 3, columns = f->parts[2]->count;
    if (f->count < 5 || columns < 2) {
        source_problem(v->s, f->at,
                       "a table of two quantities needs two places and two rows at least: table(x, y; 0 m, 1 m; 0 s: 1 "
                       "N, 2 N; 1 s: "
                       "3 N, 5 N)");
        return nothing;
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
