/* Conditions of events as functions. */
#include "tools/isoc/formula/condition.h"
#include "tools/isoc/formula/scalar.h"

/* A < B and A <= B: A - B; A > B: B - A; A == B: |A - B| - 1/2. */
static value function_of_order(values *v, const formula *f)
{
    graph *g = v->g;
    const value a = value_any(v, f->parts[0]), b = value_any(v, f->parts[1]);
    if (a.count == 0 || b.count == 0) {
        return nothing;
    }
    if (a.count != 1 || b.count != 1) {
        return REFUSED(v->s, f->at, "a comparison takes numbers; this is a vector");
    }
    if (!a.any && !b.any && !agree(v, a.dim, b.dim)) {
        return REFUSED(v->s, f->at, "a comparison of %s and of %s: they must have the same unit",
                       dimension_text(v->s->memory, a.dim), dimension_text(v->s->memory, b.dim));
    }
    value both = a;
    gather(&both, &b);
    if (f->sign == '=' && equality_of(v, f, &both, a.parts[0], b.parts[0]).count == 0) {
        return nothing;
    }
    const node apart = f->sign == '>' ? sub(g, b.parts[0], a.parts[0]) : sub(g, a.parts[0], b.parts[0]);
    return scalar(f->sign == '=' ? sub(g, magnitude(g, apart), constant(g, 0.5)) : apart, both.dim);
}

value condition_function(values *v, const formula *f)
{
    graph *g = v->g;
    if (f->kind == FORMULA_ORDER) {
        return function_of_order(v, f);
    }
    if (f->kind != FORMULA_LOGIC) {
        return REFUSED(v->s, f->at, "an event has a comparison, as in: when x < 0 m { ... }; of a mode: on == 1");
    }
    const value a = condition_function(v, f->parts[0]);
    const value b = f->count == 1 ? a : condition_function(v, f->parts[1]);
    if (a.count == 0 || b.count == 0) {
        return nothing;
    }
    const node one = a.parts[0], other = b.parts[0];
    return scalar(f->sign == '~'   ? neg(g, one)
                  : f->sign == '&' ? larger(g, one, other)
                                   : function(g, OP_MIN, one, other),
                  plain);
}
