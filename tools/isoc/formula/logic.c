/* The values of conditions: 1 where they hold, else 0. */
#include "tools/isoc/formula/condition.h"
#include "tools/isoc/formula/functions.h"
#include "tools/isoc/formula/scalar.h"

value logic_of(values *v, const formula *f, const value *arguments)
{
    graph *g = v->g;
    for (size_t i = 0; i < f->count; i++) {
        if (arguments[i].count != 1 || !agree(v, arguments[i].dim, plain)) {
            return REFUSED(v->s, f->parts[i]->at, "a condition is a comparison, or a number that is 1 or 0");
        }
    }
    const node a = arguments[0].parts[0], b = arguments[f->count - 1].parts[0];
    return scalar(f->sign == '~'   ? sub(g, constant(g, 1.0), a)
                  : f->sign == '&' ? mul(g, a, b)
                                   : larger(g, a, b),
                  plain);
}

value equality_of(values *v, const formula *f, const value *both, node a, node b)
{
    graph *g = v->g;
    if (!both->any && !agree(v, both->dim, plain)) {
        return REFUSED(v->s, f->at, "== compares whole numbers, such as modes; this %s: take < or >",
                       dimension_phrase(v->s->memory, both->dim));
    }
    const node apart = magnitude(g, sub(g, a, b));
    return scalar(above(g, constant(g, 0.5), apart), plain);
}
