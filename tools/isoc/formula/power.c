/* Powers in formulas: x^2, x^-1, x^1.5 by products, quotients and roots; x^0.7 and x^k by core/numbers/power.h. */
#include <math.h>
#include <stdlib.h>

#include "tools/isoc/formula/functions.h"
#include "tools/isoc/formula/scalar.h"

/* The value to the power of half of a whole number. */
static value power_of_halves(values *v, const formula *f, const value *base, int halves)
{
    graph *g = v->g;
    const int size = abs(halves);
    value root = *base, r = {.count = 1};
    if (size % 2 == 1) {
        dimension squared = base->dim;
        squared.rad = base->dim.rad % 4 == 0 || counts_angles(v) ? base->dim.rad : 0;
        if (!dimension_root(squared, &root.dim)) {
            return REFUSED(v->s, f->at, "the root of %s has no unit: there are roots, and no roots of roots",
                           dimension_text(v->s->memory, base->dim));
        }
        if (!keeps_not_below_zero(v, base->parts[0])) {
            return REFUSED(v->s, f->at, "the root of a negative number: %g", value_now(v, base->parts[0]));
        }
        root.parts[0] = function(g, OP_SQRT, base->parts[0], 0);
    }
    const bool is_known = v->around == NULL || is_constant(g, base->parts[0]);
    if (halves < 0 && is_known && value_now(v, base->parts[0]) == 0.0) {
        return REFUSED(v->s, f->at, "division by zero: a negative power of it");
    }
    const node whole = power(g, base->parts[0], size / 2),
               positive = size % 2 == 1 ? mul(g, whole, root.parts[0]) : whole;
    r.parts[0] = halves < 0 ? divide(g, constant(g, 1.0), positive) : positive;
    return multiply(v, f, &r.dim, base->dim, halves / 2) &&
                   (size % 2 == 0 || multiply(v, f, &r.dim, root.dim, halves < 0 ? -1 : 1))
               ? r
               : nothing;
}

static value power_of_number(values *v, const formula *f, const value *base, const value *exponent)
{
    const node x = base->parts[0], y = exponent->parts[0];
    if (!base->any && !agree(v, base->dim, plain)) {
        return REFUSED(v->s, f->at,
                       "only powers of halves have a unit, as x^2, x^-1 and x^1.5; this is %s to another: divide it by "
                       "a quantity, (x / 1 Pa)^0.7",
                       dimension_text(v->s->memory, base->dim));
    }
    if (!keeps_not_below_zero(v, x) ||
        (is_constant(v->g, y) && constant_value(v->g, y) < 0.0 && !keeps_above_zero(v, x))) {
        return REFUSED(v->s, f->at, "a power that is no whole number is of a number above zero%s; this is %g",
                       is_constant(v->g, y) && constant_value(v->g, y) < 0.0 ? "" : ", or of zero", value_now(v, x));
    }
    return scalar(function(v->g, OP_POWER, x, y), plain);
}

value power_of(values *v, const formula *f, const value *base, const value *exponent)
{
    const node y = exponent->parts[0];
    if (!exponent->any && !agree(v, exponent->dim, plain)) {
        return REFUSED(v->s, f->parts[1]->at, "a power is a plain number; this %s",
                       dimension_phrase(v->s->memory, exponent->dim));
    }
    const double halves = is_constant(v->g, y) ? 2.0 * constant_value(v->g, y) : (double)NAN;
    return halves == floor(halves) && fabs(halves) <= 2.0 * MOST_POWER ? power_of_halves(v, f, base, (int)halves)
                                                                       : power_of_number(v, f, base, exponent);
}
