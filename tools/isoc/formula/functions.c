#include "tools/isoc/formula/functions.h"
#include "tools/isoc/formula/condition.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "tools/isoc/base/numbers.h"
#include "tools/isoc/formula/scalar.h"
#include "tools/isoc/formula/ticks.h"
#include "tools/isoc/graph/vector.h"

static const double largest_angle = 1e4; /* rad: the domain of core/numbers/sincos.h */
static const double half_pi = 1.57079632679489661923;

/* Whether the function is called by this word: two words share one call. */
static bool is_called(const formula *f, const char *word)
{
    return strcmp(f->name, word) == 0;
}

/* Whether the first argument has this dimension; else a problem is noted. */
static bool has_dimension(values *v, const formula *f, const value *arguments, dimension expected)
{
    return arguments[0].any || agree(v, arguments[0].dim, expected) ||
           source_problem(v->s, f->parts[0]->at, "%s takes %s%s; this %s", f->name,
                          dimension_equal(expected, plain) ? "" : "a quantity in ",
                          dimension_text(v->s->memory, expected), dimension_phrase(v->s->memory, arguments[0].dim));
}

/* All arguments from this one on have one dimension, but for plain zeros. */
static bool share_dimension(values *v, const formula *f, size_t first, const value *arguments, value *result)
{
    *result = arguments[first];
    for (size_t i = first + 1; i < f->count; i++) {
        if (!arguments[i].any && !result->any && !agree(v, arguments[i].dim, result->dim)) {
            return source_problem(v->s, f->parts[i]->at, "%s of %s and of %s: they must have the same unit", name_of(f),
                                  dimension_text(v->s->memory, result->dim),
                                  dimension_text(v->s->memory, arguments[i].dim));
        }
        gather(result, &arguments[i]);
    }
    return true;
}

/* Whether a number stays within these limits, as far as tunables and constants show. */
static bool stays_within(values *v, node x, double least, double most)
{
    const node low = constant(v->g, least), high = constant(v->g, most);
    const bool is_above = keeps(v, (condition){low, x, false}), is_below = keeps(v, (condition){x, high, false});
    return is_above && is_below;
}

/* Whether the argument is a plain number within these limits; `domain` says which. */
static bool is_in_domain(values *v, const formula *f, const value *arguments, double least, double most,
                         const char *domain)
{
    const node x = arguments[0].parts[0];
    return has_dimension(v, f, arguments, plain) &&
           (stays_within(v, x, least, most) ||
            source_problem(v->s, f->parts[0]->at, "%s takes %s; this is %g", f->name, domain, value_now(v, x)));
}

/* --- of angles --- */

/* The sine and the cosine of an angle. One that is a whole number of quarter turns, to the rounding of its unit and of
 * pi (2 ulp), counts as exactly that. */
static bool turn_of(values *v, const formula *f, const value *arguments, node *sine_made, node *cosine_made)
{
    static const double sines[] = {0.0, 1.0, 0.0, -1.0};
    const node angle = arguments[0].parts[0];
    const double now = value_now(v, angle), quarters = floor(now / half_pi + 0.5);
    if (!stays_within(v, angle, -largest_angle, largest_angle)) {
        return source_problem(v->s, f->parts[0]->at, "an angle must be within %g rad", largest_angle);
    }
    if (!is_constant(v->g, angle) && uses_time(v->g, &angle, 1)) {
        return source_problem(v->s, f->parts[0]->at,
                              "an angle that depends on time is given by its frequency: %s(3 Hz)", f->name);
    }
    const bool exact = is_constant(v->g, angle) && fabs(now - quarters * half_pi) <= 2 * DBL_EPSILON * fabs(now);
    const int quadrant = (int)quarters & 3;
    *sine_made = exact ? constant(v->g, sines[quadrant]) : sine(v->g, angle);
    *cosine_made = exact ? constant(v->g, sines[(quadrant + 1) & 3]) : cosine(v->g, angle);
    return true;
}

/* sin and cos: of an angle; of a frequency it is a wave, which may have a phase. */
static value call_wave(values *v, const formula *f, const value *arguments)
{
    const bool is_sine = is_called(f, "sin");
    node s, c;
    if (f->count == 2 || agree(v, arguments[0].dim, hertz) || agree(v, arguments[0].dim, radian_per_second)) {
        return wave_of_formula(v, f, arguments, is_sine ? sine : cosine);
    }
    if (!arguments[0].any && !agree(v, arguments[0].dim, radian)) {
        return REFUSED(v->s, f->parts[0]->at, "%s takes an angle, as in %s(30 deg), or a frequency; this %s", f->name,
                       f->name, dimension_phrase(v->s->memory, arguments[0].dim));
    }
    return turn_of(v, f, arguments, &s, &c) ? scalar(is_sine ? s : c, plain) : nothing;
}

static value call_tangent(values *v, const formula *f, const value *arguments)
{
    node s, c;
    if (!has_dimension(v, f, arguments, radian) || !turn_of(v, f, arguments, &s, &c)) {
        return nothing;
    }
    if (is_parametric(v, c) && value_now(v, c) == 0.0) {
        return REFUSED(v->s, f->parts[0]->at, "the tangent of a quarter turn is infinite");
    }
    return scalar(divide(v->g, s, c), plain);
}

/* asin and acos: only rounding brings an argument beyond 1. asin x is the angle of (sqrt(1 - x^2), x). */
static value call_inverse(values *v, const formula *f, const value *arguments)
{
    const bool is_sine = is_called(f, "asin");
    const node x = arguments[0].parts[0], one = constant(v->g, 1.0);
    if (!is_in_domain(v, f, arguments, -1.0 - 4 * DBL_EPSILON, 1.0 + 4 * DBL_EPSILON, "a number from -1 to 1")) {
        return nothing;
    }
    if (is_constant(v->g, x)) {
        const double limited = fmax(-1.0, fmin(constant_value(v->g, x), 1.0));
        return scalar(constant(v->g, is_sine ? elementary_asin(limited) : elementary_acos(limited)), radian);
    }
    const node less = sub(v->g, one, x), more = add(v->g, one, x);
    const node other = function(v->g, OP_SQRT, mul(v->g, less, more), 0);
    return scalar(is_sine ? function(v->g, OP_ATAN2, x, other) : function(v->g, OP_ATAN2, other, x), radian);
}

static value call_direction(values *v, const formula *f, const value *arguments)
{
    const node y = arguments[0].parts[0], x = arguments[1].parts[0];
    value both;
    if (!share_dimension(v, f, 0, arguments, &both)) {
        return nothing;
    }
    if (is_parametric(v, y) && is_parametric(v, x) && value_now(v, y) == 0.0 && value_now(v, x) == 0.0) {
        return REFUSED(v->s, f->at, "atan2 of 0 and 0: that point has no direction");
    }
    return scalar(function(v->g, OP_ATAN2, y, x), radian);
}

/* The angle whose tangent is x: that of the point (1, x). */
static value call_arctangent(values *v, const formula *f, const value *arguments)
{
    return has_dimension(v, f, arguments, plain)
               ? scalar(function(v->g, OP_ATAN2, arguments[0].parts[0], constant(v->g, 1.0)), radian)
               : nothing;
}

/* --- of plain numbers, and of any --- */

static value call_root(values *v, const formula *f, const value *arguments)
{
    const dimension expected = arguments[0].dim;
    const node x = arguments[0].parts[0];
    dimension squared = expected, root;
    squared.rad = expected.rad % 4 == 0 || counts_angles(v) ? expected.rad : 0;
    if (!dimension_root(squared, &root)) {
        return REFUSED(v->s, f->parts[0]->at, "the root of %s has no unit: there are roots, and no roots of roots",
                       dimension_text(v->s->memory, expected));
    }
    if (!keeps_not_below_zero(v, x)) {
        return REFUSED(v->s, f->parts[0]->at, "the root of a negative number: %g", value_now(v, x));
    }
    value result = arguments[0];
    result.parts[0] = function(v->g, OP_SQRT, x, 0);
    result.dim = root;
    return result;
}

/* e^709.8 is the largest double. */
static value call_exp(values *v, const formula *f, const value *arguments)
{
    return is_in_domain(v, f, arguments, -700.0, 700.0, "a number from -700 to 700")
               ? scalar(function(v->g, OP_EXP, arguments[0].parts[0], 0), plain)
               : nothing;
}

static value call_log(values *v, const formula *f, const value *arguments)
{
    const node x = arguments[0].parts[0];
    if (!has_dimension(v, f, arguments, plain)) {
        return nothing;
    }
    if (!keeps_above_zero(v, x)) {
        return REFUSED(v->s, f->parts[0]->at, "log takes a number larger than zero; this is %g", value_now(v, x));
    }
    return scalar(function(v->g, OP_LOG, x, 0), plain);
}

static value call_tanh(values *v, const formula *f, const value *arguments)
{
    return has_dimension(v, f, arguments, plain) ? scalar(function(v->g, OP_TANH, arguments[0].parts[0], 0), plain)
                                                 : nothing;
}

static value call_impact(values *v, const formula *f, const value *arguments)
{
    return is_in_domain(v, f, arguments, LEAST_RESTITUTION, 1.0, "a restitution from 0.01 to 1")
               ? scalar(impact_damping(v->g, arguments[0].parts[0]), plain)
               : nothing;
}

static value call_abs(values *v, const formula *f, const value *arguments)
{
    value result = arguments[0];
    if (refuses_corner(v, f, arguments, f->count)) {
        return nothing;
    }
    result.parts[0] = magnitude(v->g, result.parts[0]);
    return result;
}

static value call_extreme(values *v, const formula *f, const value *arguments)
{
    value result;
    if (!share_dimension(v, f, 0, arguments, &result) || refuses_corner(v, f, arguments, f->count)) {
        return nothing;
    }
    for (size_t i = 1; i < f->count; i++) {
        const node next = arguments[i].parts[0];
        result.parts[0] =
            is_called(f, "max") ? larger(v->g, result.parts[0], next) : function(v->g, OP_MIN, result.parts[0], next);
    }
    return result;
}

static value call_clamp(values *v, const formula *f, const value *arguments)
{
    value result;
    const node least = arguments[1].parts[0], most = arguments[2].parts[0];
    if (!share_dimension(v, f, 0, arguments, &result) || refuses_corner(v, f, arguments, f->count)) {
        return nothing;
    }
    if (!keeps(v, (condition){least, most, false})) {
        return REFUSED(v->s, f->parts[1]->at, "the limits are in the wrong order: clamp(x, LEAST, MOST)");
    }
    result.parts[0] = function(v->g, OP_MIN, larger(v->g, result.parts[0], least), most);
    return result;
}

static value call_sign(values *v, const formula *f, const value *arguments)
{
    return refuses_corner(v, f, arguments, f->count) ? nothing
                                                     : scalar(function(v->g, OP_SIGN, arguments[0].parts[0], 0), plain);
}

static value call_whole(values *v, const formula *f, const value *arguments)
{
    if (!has_dimension(v, f, arguments, plain) || refuses_corner(v, f, arguments, f->count)) {
        return nothing;
    }
    return scalar(function(v->g, is_called(f, "floor") ? OP_FLOOR : OP_ROUND, arguments[0].parts[0], 0), plain);
}

/* mod(x, y): x - y floor(x / y), from 0 to y. */
static value call_modulus(values *v, const formula *f, const value *arguments)
{
    graph *g = v->g;
    const node x = arguments[0].parts[0], y = arguments[1].parts[0];
    value result;
    if (!share_dimension(v, f, 0, arguments, &result) || refuses_corner(v, f, arguments, f->count)) {
        return nothing;
    }
    if (!keeps_above_zero(v, y)) {
        return REFUSED(v->s, f->parts[1]->at, "mod takes a number larger than zero behind the comma; this is %g",
                       value_now(v, y));
    }
    result.parts[0] = sub(g, x, mul(g, y, function(g, OP_FLOOR, divide(g, x, y), 0)));
    return result;
}

/* if(condition, a, b): a where the condition is 1, b where it is 0. Exactly one of both is added to zero. */
static value call_if(values *v, const formula *f, const value *arguments)
{
    value result;
    if (!has_dimension(v, f, arguments, plain) || !share_dimension(v, f, 1, arguments, &result) ||
        refuses_corner(v, f, arguments, f->count)) {
        return nothing;
    }
    const node holds = function(v->g, OP_WHERE, arguments[0].parts[0], arguments[1].parts[0]);
    const node fails = function(v->g, OP_UNLESS, arguments[0].parts[0], arguments[2].parts[0]);
    result.parts[0] = add(v->g, holds, fails);
    return result;
}

value order_of(values *v, const formula *f, const value *arguments)
{
    value both;
    if (arguments[0].count != 1 || arguments[1].count != 1) {
        return REFUSED(v->s, f->at, "a comparison takes numbers; this is a vector");
    }
    if (!share_dimension(v, f, 0, arguments, &both) || refuses_corner(v, f, arguments, f->count)) {
        return nothing;
    }
    const node a = arguments[0].parts[0], b = arguments[1].parts[0];
    const bool or_equal = f->number > 0.0;
    if (f->sign == '=') {
        return equality_of(v, f, &both, a, b);
    }
    /* a <= b where a is not above b. */
    const node is_above = (f->sign == '>') != or_equal ? above(v->g, a, b) : above(v->g, b, a);
    return scalar(or_equal ? sub(v->g, constant(v->g, 1.0), is_above) : is_above, plain);
}

/* --- of vectors --- */

static vector vector_of_value(const value *v)
{
    return (vector){{v->parts[0], v->parts[1], v->parts[2]}};
}

static value call_dot(values *v, const formula *f, const value *arguments)
{
    dimension expected = arguments[0].dim;
    if (!multiply(v, f, &expected, arguments[1].dim, 1)) {
        return nothing;
    }
    return scalar(vector_dot(v->g, vector_of_value(&arguments[0]), vector_of_value(&arguments[1])), expected);
}

static value call_cross(values *v, const formula *f, const value *arguments)
{
    value result = {.count = 3, .dim = arguments[0].dim};
    if (!multiply(v, f, &result.dim, arguments[1].dim, 1)) {
        return nothing;
    }
    const vector product = vector_cross(v->g, vector_of_value(&arguments[0]), vector_of_value(&arguments[1]));
    memcpy(result.parts, product.at, sizeof product.at);
    return result;
}

/* A number far below any useful value in the unit keeps the derivative finite at zero. */
static node length_of(graph *g, vector a)
{
    static const double least = 1e-30;
    return function(g, OP_SQRT, add(g, vector_dot(g, a, a), constant(g, least)), 0);
}

static value call_norm(values *v, const formula *f, const value *arguments)
{
    (void)f;
    return scalar(length_of(v->g, vector_of_value(&arguments[0])), arguments[0].dim);
}

/* hypot(a, b): the length of the vector (a, b). */
static value call_length(values *v, const formula *f, const value *arguments)
{
    value result;
    if (!share_dimension(v, f, 0, arguments, &result)) {
        return nothing;
    }
    const node third = f->count > 2 ? arguments[2].parts[0] : constant(v->g, 0.0);
    result.parts[0] = length_of(v->g, (vector){{arguments[0].parts[0], arguments[1].parts[0], third}});
    return result;
}

/* --- all of them --- */

static const function_row functions[] = {
    {"sqrt", "sqrt(2)", 1, 1, 1, call_root, OF_VALUES, KEPT_NEXT},
    {"sin", "sin(30 deg), or in an input sin(3 Hz, 90 deg)", 1, 2, 1, call_wave, OF_VALUES, KEPT_NEXT},
    {"cos", "cos(30 deg), or in an input cos(3 Hz, 90 deg)", 1, 2, 1, call_wave, OF_VALUES, KEPT_NEXT},
    {"tan", "tan(30 deg)", 1, 1, 1, call_tangent, OF_VALUES, KEPT_NEXT},
    {"asin", "asin(0.5)", 1, 1, 1, call_inverse, OF_VALUES, KEPT_NEXT},
    {"acos", "acos(0.5)", 1, 1, 1, call_inverse, OF_VALUES, KEPT_NEXT},
    {"atan2", "atan2(3 mm, 4 mm)", 2, 2, 1, call_direction, OF_VALUES, KEPT_NEXT},
    {"exp", "exp(-1)", 1, 1, 1, call_exp, OF_VALUES, KEPT_NEXT},
    {"log", "log(2)", 1, 1, 1, call_log, OF_VALUES, KEPT_NEXT},
    {"min", "min(1 m, 2 m)", 2, MOST_ARGUMENTS, 1, call_extreme, OF_VALUES, KEPT_NEXT},
    {"max", "max(1 m, 2 m)", 2, MOST_ARGUMENTS, 1, call_extreme, OF_VALUES, KEPT_NEXT},
    {"abs", "abs(-1 m)", 1, 1, 1, call_abs, OF_VALUES, KEPT_NEXT},
    {"tanh", "tanh(0.5)", 1, 1, 1, call_tanh, OF_VALUES, KEPT_NEXT},
    {"impact_damping", "impact_damping(0.8), of a restitution", 1, 1, 1, call_impact, OF_VALUES, KEPT_NEXT},
    {"sign", "sign(-1 m)", 1, 1, 1, call_sign, OF_VALUES, KEPT_NEXT},
    {"floor", "floor(2.5)", 1, 1, 1, call_whole, OF_VALUES, KEPT_NEXT},
    {"round", "round(2.5)", 1, 1, 1, call_whole, OF_VALUES, KEPT_NEXT},
    {"clamp", "clamp(x, -1 m, 1 m)", 3, 3, 1, call_clamp, OF_VALUES, KEPT_NEXT},
    {"if", "if(x > 0, 1 m, 2 m)", 3, 3, 1, call_if, OF_VALUES, KEPT_NEXT},
    {"dot", "dot(a, b), of two vectors", 2, 2, 3, call_dot, OF_VALUES, KEPT_NEXT},
    {"cross", "cross(a, b), of two vectors", 2, 2, 3, call_cross, OF_VALUES, KEPT_NEXT},
    {"atan", "atan(0.5)", 1, 1, 1, call_arctangent, OF_VALUES, KEPT_NEXT},
    {"hypot", "hypot(3 m, 4 m)", 2, 3, 1, call_length, OF_VALUES, KEPT_NEXT},
    {"mod", "mod(x, 1 m)", 2, 2, 1, call_modulus, OF_VALUES, KEPT_NEXT},
    {"norm", "norm(a), of a vector", 1, 1, 3, call_norm, OF_VALUES, KEPT_NEXT},
    {"noise", "noise(7), with a seed", 1, 1, 1, noise_of, OF_TIME, KEPT_NEXT},
    {"step", "step(0.5 s)", 1, 1, 1, step_of, OF_JUMPS, KEPT_NEXT},
    {"square", "square(2 Hz), or with a phase square(2 Hz, 90 deg)", 1, 2, 1, square_of, OF_JUMPS, KEPT_NEXT},
    {"prbs", "prbs(7), with a seed; or with the time of a bit and their order, prbs(7, 10 ms, 9)", 1, 3, 1, prbs_of,
     OF_JUMPS, KEPT_NEXT},
    {"chirp", "chirp(1 Hz, 50 Hz, 10 s), from one frequency to another, and how long it takes", 3, 3, 1, chirp_of,
     OF_TIME, KEPT_NEXT},
    {"previous", "previous(x), or with a start previous(x, 0 V)", 1, 2, 0, NULL, OF_PAST, KEPT_PREVIOUS},
    {"delay", "delay(x, 5 ms), or with a start delay(x, 5 ms, 0 V)", 2, 3, 0, NULL, OF_PAST, KEPT_DELAY},
    {"sample", "sample(x, every 5 ms), or with a start sample(x, every 5 ms, 0 V)", 2, 3, 0, NULL, OF_PAST,
     KEPT_SAMPLE},
    {"share", "share(x < 1 mm)", 1, 1, 0, NULL, OF_PAST, KEPT_SHARE},
    {"pwm", "pwm(duty, 1 ms), or with a phase pwm(duty, 1 ms, 90 deg)", 2, 3, 0, NULL, OF_PAST, KEPT_SHARE},
    {"table", NULL, 0, 0, 1, NULL, OF_POINTS, KEPT_NEXT},
    {"ramp", NULL, 0, 0, 1, NULL, OF_POINTS, KEPT_NEXT},
};

const function_row *function_called(const char *word)
{
    for (size_t i = 0; i < COUNT_OF(functions); i++) {
        if (strcmp(word, functions[i].name) == 0) {
            return &functions[i];
        }
    }
    return NULL;
}

const function_row *find_function(values *v, const formula *f)
{
    const char *names[COUNT_OF(functions)];
    const function_row *found = function_called(f->name);
    if (found != NULL) {
        return found;
    }
    for (size_t i = 0; i < COUNT_OF(functions); i++) {
        names[i] = functions[i].name;
    }
    source_problem(v->s, f->at, "no function is called '%s'%s", f->name,
                   source_suggestion(v->s, f->name, names, COUNT_OF(names)));
    return NULL;
}
