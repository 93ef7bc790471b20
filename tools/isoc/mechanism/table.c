#include "tools/isoc/mechanism/table.h"

static const value nothing = {0};

/* The part of a stretch that lies before x: (x - from) / length, limited to [0, 1]. No branch and no index depends on x, so
 * each stretch is computed for every x. */
static node part_before(graph *g, node x, double from, double length)
{
    const node since = sub(g, x, constant(g, from));
    const node limited = function(g, OP_MIN, larger(g, since, constant(g, 0.0)), constant(g, length));
    return divide(g, limited, constant(g, length));
}

/* The value of a point; it has the dimension of those before it. */
static value value_at_point(values *v, const formula *f, const value *before)
{
    const value here = value_any(v, f);
    if (here.count == 0) {
        return nothing;
    }
    if (here.count != 1 || (!here.any && !before->any && !agree(v, here.of, before->of))) {
        source_problem(v->s, f->at, "the values of a table must be numbers of the same dimension");
        return nothing;
    }
    return here;
}

value table_of_formula(values *v, const formula *f)
{
    graph *g = v->g;
    if (f->count < 5 || f->count % 2 != 1) {
        source_problem(v->s, f->at,
                       "a table of a quantity needs pairs of place and value: table(x, 0 m: 0 N, 1 m: 8 N)");
        return nothing;
    }
    const value x = value_any(v, f->parts[0]);
    if (x.count != 1) {
        if (x.count > 1) {
            source_problem(v->s, f->parts[0]->at, "a table is of a number; this is a vector");
        }
        return nothing;
    }
    const value none = {.count = 1, .any = true};
    value sum = value_at_point(v, f->parts[2], &none), last = sum;
    double from = value_constant(v, f->parts[1], x.of, "a place of the table", 0.0);
    for (size_t i = 3; i < f->count && sum.count > 0; i += 2) {
        const double to = value_constant(v, f->parts[i], x.of, "a place of the table", 0.0);
        const value here = value_at_point(v, f->parts[i + 1], &sum);
        if (here.count == 0) {
            return nothing;
        }
        if (!(to > from)) {
            source_problem(v->s, f->parts[i]->at, "the places of a table must increase");
            return nothing;
        }
        const node rise = sub(g, here.parts[0], last.parts[0]);
        sum.parts[0] = add(g, sum.parts[0], mul(g, rise, part_before(g, x.parts[0], from, to - from)));
        sum.of = sum.any ? here.of : sum.of;
        sum.any = sum.any && here.any;
        last = here;
        from = to;
    }
    return sum;
}
