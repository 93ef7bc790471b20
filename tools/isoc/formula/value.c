#include "tools/isoc/formula/value.h"

#include <math.h>

#include "tools/isoc/base/numbers.h"

bool check_range(const values *v, const formula *f, const char *what, double number)
{
    return real_holds(number, v->is_double) ||
           source_problem(v->s, f->at, "%s is %g in SI units; %s", what, number, real_advice(number, v->is_double));
}

/* Whether any constant so far is out of range: most scenes have none, and then there is nothing to look for. */
static bool has_foreign(values *v)
{
    for (; v->scanned < v->g->count; v->scanned++) {
        const node n = (node)v->scanned;
        v->is_foreign = v->is_foreign || (is_constant(v->g, n) && !real_holds(constant_value(v->g, n), v->is_double));
    }
    return v->is_foreign;
}

/* The same for all constants that a node depends on. */
static bool check_constants(values *v, const formula *f, const char *what, node n)
{
    if (is_constant(v->g, n) || !has_foreign(v)) {
        return !is_constant(v->g, n) || check_range(v, f, what, constant_value(v->g, n));
    }
    const char *part = arena_format(v->s->memory, "a number in %s", what);
    bool good = true;
    for (reached r = reach(v->g, &n, 1); reach_next(&r);) {
        good = good && (!is_constant(v->g, r.at) || check_range(v, f, part, r.n->value));
    }
    return good;
}

bool agree(const values *v, dimension a, dimension b)
{
    return counts_angles(v) ? dimension_equal(a, b) : dimension_equal_but_angle(a, b);
}

void gather(value *all, const value *next)
{
    if (all->any) {
        all->dim = next->dim;
    } else if (!next->any && all->dim.rad != next->dim.rad) {
        all->dim.rad = 0;
    }
    all->any = all->any && next->any;
}

bool multiply(values *v, const formula *f, dimension *a, dimension b, int n)
{
    dimension angle = {.rad = a->rad};
    const bool shows = dimension_times(&angle, (dimension){.rad = b.rad}, n), counts = counts_angles(v);
    a->rad = b.rad = 0;
    const bool fits = dimension_times(a, b, n) && (shows || !counts);
    a->rad = shows ? angle.rad : 0;
    return fits || source_problem(v->s, f->at, "a power of kg, m, s, rad, A or K is beyond %d", MOST_POWER);
}

static bool right_parts(int count, int parts)
{
    return parts == 0 ? count == 3 || count == 6 : count == parts;
}

static const char *form_of(int parts)
{
    static const char *const forms[] = {
        "(xx, yy, zz) or (xx, yy, zz; xy, xz, yz)",
        "one number",
        "two numbers (first, second)",
        "a vector (x, y, z)",
        "four numbers (w, x, y, z)",
    };
    return forms[parts];
}

value value_fitting(values *v, const formula *f, value r, dimension expected, int parts, const char *what)
{
    if (r.count == 0) {
        return r;
    }
    if (!right_parts(r.count, parts)) {
        const char *found = r.count == 1 ? "one number" : arena_format(v->s->memory, "%d numbers", r.count);
        return REFUSED(v->s, f->at, "%s is %s; this is %s", what, form_of(parts), found);
    }
    if (!r.any && !agree(v, r.dim, expected)) {
        return REFUSED(v->s, f->at, "%s %s; this %s", what, dimension_phrase(v->s->memory, expected),
                       dimension_phrase(v->s->memory, r.dim));
    }
    for (int i = 0; i < r.count; i++) {
        if (v->around == NULL && !isfinite(value_now(v, r.parts[i]))) {
            return REFUSED(v->s, f->at, "%s is not finite", what);
        }
        if (!check_constants(v, f, what, r.parts[i])) {
            return (value){0};
        }
    }
    r.dim = expected;
    return r;
}

double constant_fitting(values *v, const formula *f, const value *found, dimension expected, const char *what,
                        double fallback)
{
    const value r = value_fitting(v, f, *found, expected, 1, what);
    if (r.count == 0) {
        return fallback;
    }
    if (!is_constant(v->g, r.parts[0])) {
        source_problem(v->s, f->at,
                       uses_operation(v->g, r.parts, 1, OP_PARAMETER) ? "%s cannot depend on a tunable parameter"
                                                                      : "%s is a constant: it cannot change",
                       what);
        return fallback;
    }
    return constant_value(v->g, r.parts[0]);
}

double value_now(values *v, node n)
{
    const evaluation at = {.p = v->defaults};
    v->numbers = arena_grow(v->s->memory, v->numbers, v->g->count, &v->number_room, sizeof *v->numbers);
    graph_evaluate(v->g, v->number_count, &at, v->numbers);
    v->number_count = v->g->count;
    return v->numbers[n];
}

bool is_parametric(values *v, node n)
{
    bool found = true;
    for (reached r = reach(v->g, &n, 1); reach_next(&r);) {
        found = found && (operators[r.n->op].operands > 0 || r.n->op == OP_PARAMETER || r.n->op == OP_CONSTANT);
    }
    return found;
}

bool keeps(values *v, condition c)
{
    if (!is_parametric(v, c.least) || !is_parametric(v, c.most)) {
        return true;
    }
    const double least = value_now(v, c.least), most = value_now(v, c.most);
    bool is_new = !is_constant(v->g, c.least) || !is_constant(v->g, c.most);
    FOR_EACH (const condition, known, v->conditions) {
        is_new = is_new && (known->least != c.least || known->most != c.most || known->is_strict != c.is_strict);
    }
    if (is_new) {
        LIST_ADD(v->s->memory, v->conditions, c);
    }
    return c.is_strict ? least < most : least <= most;
}

bool keeps_above_zero(values *v, node n)
{
    return keeps(v, (condition){constant(v->g, 0.0), n, true});
}

bool keeps_not_below_zero(values *v, node n)
{
    return keeps(v, (condition){constant(v->g, 0.0), n, false});
}
