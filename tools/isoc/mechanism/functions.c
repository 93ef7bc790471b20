#include "tools/isoc/mechanism/functions.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "tools/isoc/base/elementary.h"
#include "tools/isoc/mechanism/timing.h"

static const dimension plain = {0, 0, 0, 0, 0, 0}, radian = {0, 0, 0, 1, 0, 0};
static const double largest_angle = 1e4; /* rad: the domain of core/numbers/sincos.h */
static const double half_pi = 1.57079632679489661923;
static const value nothing = {0};

/* A function: what it takes, and its value for arguments that are numbers. A problem of its own is noted at the call. */
typedef struct function_row {
    const char *name, *example;
    size_t least, most; /* arguments */
    value (*call)(values *v, const formula *f, const value *given);
} function_row;

static value scalar(node n, dimension of)
{
    return (value){.count = 1, .parts = {n}, .of = of};
}

/* The number of an argument, where the function is of constants only. False after noting a problem. */
static bool number_of(values *v, const formula *f, size_t i, const value *given, double *number)
{
    const node n = given[i].parts[0];
    if (!is_constant(v->g, n)) {
        source_problem(v->s, f->parts[i]->at, "%s is of constants only: this depends on a tunable parameter or on time",
                       f->name);
        return false;
    }
    *number = constant_value(v->g, n);
    return true;
}

static bool has_dimension(values *v, const formula *f, size_t i, const value *given, dimension of)
{
    if (!given[i].any && !dimension_equal(given[i].of, of)) {
        source_problem(v->s, f->parts[i]->at, "%s %s; this %s", arena_format(v->s->memory, "what %s is of", f->name),
                       dimension_phrase(v->s->memory, of), dimension_phrase(v->s->memory, given[i].of));
        return false;
    }
    return true;
}

/* All arguments have one dimension, but for plain zeros. */
static bool share_dimension(values *v, const formula *f, const value *given, value *made)
{
    *made = given[0];
    for (size_t i = 1; i < f->count; i++) {
        if (!given[i].any && !made->any && !dimension_equal(given[i].of, made->of)) {
            source_problem(v->s, f->parts[i]->at, "%s of %s and of %s: they must have the same unit", f->name,
                           dimension_text(v->s->memory, made->of), dimension_text(v->s->memory, given[i].of));
            return false;
        }
        made->of = made->any ? given[i].of : made->of;
        made->any = made->any && given[i].any;
    }
    return true;
}

/* --- of angles --- */

static bool depends_on_time(values *v, node n)
{
    bool *needed = arena_take(v->s->memory, v->g->count, sizeof *needed), found = false;
    graph_reach(v->g, &n, 1, needed);
    for (size_t i = 0; i < v->g->count; i++) {
        found = found || (needed[i] && is_timed(v->g, (node)i));
    }
    arena_return(v->s->memory, needed, v->g->count, sizeof *needed);
    return found;
}

/* The sine and the cosine of an angle. One that is a whole number of quarter turns, to the rounding of its unit and of
 * pi (2 ulp), counts as exactly that. */
static bool turn_of(values *v, const formula *f, const value *given, node *sine_made, node *cosine_made)
{
    static const double sines[] = {0.0, 1.0, 0.0, -1.0};
    const node angle = given[0].parts[0];
    const double now = value_now(v, angle), quarters = floor(now / half_pi + 0.5);
    if (!(fabs(now) <= largest_angle)) {
        source_problem(v->s, f->parts[0]->at, "an angle must be within %g rad", largest_angle);
        return false;
    }
    if (!is_constant(v->g, angle) && depends_on_time(v, angle)) {
        source_problem(v->s, f->parts[0]->at, "an angle that depends on time is given by its frequency: %s(3 Hz)",
                       f->name);
        return false;
    }
    const bool exact = is_constant(v->g, angle) && fabs(now - quarters * half_pi) <= 2 * DBL_EPSILON * fabs(now);
    const int quadrant = (int)quarters & 3;
    *sine_made = exact ? constant(v->g, sines[quadrant]) : sine(v->g, angle);
    *cosine_made = exact ? constant(v->g, sines[(quadrant + 1) & 3]) : cosine(v->g, angle);
    return true;
}

static bool is_angle(const value *given)
{
    return given[0].any || dimension_equal(given[0].of, radian);
}

static bool is_frequency(const value *given)
{
    static const dimension hertz = {0, 0, -1, 0, 0, 0}, speed = {0, 0, -1, 1, 0, 0};
    return dimension_equal(given[0].of, hertz) || dimension_equal(given[0].of, speed);
}

/* Of an angle; of a frequency it is a wave, which may have a phase. */
static value call_sine(values *v, const formula *f, const value *given)
{
    node s, c;
    if (f->count == 2 || is_frequency(given)) {
        return wave_of_formula(v, f);
    }
    if (!is_angle(given)) {
        source_problem(v->s, f->parts[0]->at, "%s is of an angle, as in %s(30 deg), or of a frequency; this %s",
                       f->name, f->name, dimension_phrase(v->s->memory, given[0].of));
        return nothing;
    }
    return turn_of(v, f, given, &s, &c) ? scalar(f->name[0] == 's' ? s : c, plain) : nothing;
}

static value call_tangent(values *v, const formula *f, const value *given)
{
    node s, c;
    if (!has_dimension(v, f, 0, given, radian) || !turn_of(v, f, given, &s, &c)) {
        return nothing;
    }
    if (value_now(v, c) == 0.0) {
        source_problem(v->s, f->parts[0]->at, "the tangent of a quarter turn is infinite");
        return nothing;
    }
    return scalar(divide(v->g, s, c), plain);
}

/* asin and acos: beyond 1 only by the rounding of what gave the argument. */
static value call_inverse(values *v, const formula *f, const value *given)
{
    double x;
    if (!has_dimension(v, f, 0, given, plain) || !number_of(v, f, 0, given, &x)) {
        return nothing;
    }
    if (!(fabs(x) <= 1.0 + 4 * DBL_EPSILON)) {
        source_problem(v->s, f->parts[0]->at, "%s is of a number from -1 to 1; this is %g", f->name, x);
        return nothing;
    }
    x = fmax(-1.0, fmin(x, 1.0));
    return scalar(constant(v->g, f->name[1] == 's' ? elementary_asin(x) : elementary_acos(x)), radian);
}

static value call_direction(values *v, const formula *f, const value *given)
{
    double y, x;
    value both;
    if (!share_dimension(v, f, given, &both) || !number_of(v, f, 0, given, &y) || !number_of(v, f, 1, given, &x)) {
        return nothing;
    }
    if (y == 0.0 && x == 0.0) {
        source_problem(v->s, f->at, "atan2 of 0 and 0: that point has no direction");
        return nothing;
    }
    return scalar(constant(v->g, elementary_atan2(y, x)), radian);
}

/* --- of plain numbers, and of any --- */

static value call_root(values *v, const formula *f, const value *given)
{
    double x;
    const dimension of = given[0].of;
    if (!number_of(v, f, 0, given, &x)) {
        return nothing;
    }
    if (of.kg % 2 != 0 || of.m % 2 != 0 || of.s % 2 != 0 || of.rad % 2 != 0 || of.A % 2 != 0 || of.K % 2 != 0) {
        source_problem(v->s, f->parts[0]->at, "the root of %s has no unit: each power must be even",
                       dimension_text(v->s->memory, of));
        return nothing;
    }
    if (!(x >= 0.0)) {
        source_problem(v->s, f->parts[0]->at, "the root of a negative number: %g", x);
        return nothing;
    }
    value made = given[0];
    made.parts[0] = constant(v->g, sqrt(x));
    made.of = (dimension){of.kg / 2, of.m / 2, of.s / 2, of.rad / 2, of.A / 2, of.K / 2};
    return made;
}

static value call_exp(values *v, const formula *f, const value *given)
{
    static const double largest = 700.0; /* e^709.8 is the largest double */
    double x;
    if (!has_dimension(v, f, 0, given, plain) || !number_of(v, f, 0, given, &x)) {
        return nothing;
    }
    if (!(fabs(x) <= largest)) {
        source_problem(v->s, f->parts[0]->at, "exp is of a number from -%g to %g; this is %g", largest, largest, x);
        return nothing;
    }
    return scalar(constant(v->g, elementary_exp(x)), plain);
}

static value call_log(values *v, const formula *f, const value *given)
{
    double x;
    if (!has_dimension(v, f, 0, given, plain) || !number_of(v, f, 0, given, &x)) {
        return nothing;
    }
    if (!(x >= DBL_MIN)) {
        source_problem(v->s, f->parts[0]->at, "log is of a number larger than zero; this is %g", x);
        return nothing;
    }
    return scalar(constant(v->g, elementary_log(x)), plain);
}

/* What has a corner is no function of time in a motion. */
static bool refuses_corner(values *v, const formula *f, const value *given)
{
    for (size_t i = 0; i < f->count; i++) {
        if (v->is_smooth && depends_on_time(v, given[i].parts[0])) {
            source_problem(v->s, f->at, "a motion must be smooth, and %s has a corner", f->name);
            return true;
        }
    }
    return false;
}

static value call_abs(values *v, const formula *f, const value *given)
{
    value made = given[0];
    if (refuses_corner(v, f, given)) {
        return nothing;
    }
    made.parts[0] = magnitude(v->g, made.parts[0]);
    return made;
}

/* min(a, b) is -max(-a, -b). */
static value call_extreme(values *v, const formula *f, const value *given)
{
    const bool largest = f->name[1] == 'a';
    value made;
    if (!share_dimension(v, f, given, &made) || refuses_corner(v, f, given)) {
        return nothing;
    }
    for (size_t i = 0; i < f->count; i++) {
        const node next = largest ? given[i].parts[0] : neg(v->g, given[i].parts[0]);
        made.parts[0] = i == 0 ? next : larger(v->g, made.parts[0], next);
    }
    made.parts[0] = largest ? made.parts[0] : neg(v->g, made.parts[0]);
    return made;
}

/* --- all of them --- */

enum { ANY_NUMBER = 64 };

static const function_row functions[] = {
    {"sqrt", "sqrt(2)", 1, 1, call_root},
    {"sin", "sin(30 deg), or in an input sin(3 Hz, 90 deg)", 1, 2, call_sine},
    {"cos", "cos(30 deg), or in an input cos(3 Hz, 90 deg)", 1, 2, call_sine},
    {"tan", "tan(30 deg)", 1, 1, call_tangent},
    {"asin", "asin(0.5)", 1, 1, call_inverse},
    {"acos", "acos(0.5)", 1, 1, call_inverse},
    {"atan2", "atan2(3 mm, 4 mm)", 2, 2, call_direction},
    {"exp", "exp(-1)", 1, 1, call_exp},
    {"log", "log(2)", 1, 1, call_log},
    {"min", "min(1 m, 2 m)", 2, ANY_NUMBER, call_extreme},
    {"max", "max(1 m, 2 m)", 2, ANY_NUMBER, call_extreme},
    {"abs", "abs(-1 m)", 1, 1, call_abs},
    {"table", NULL, 0, 0, NULL},
    {"ramp", NULL, 0, 0, NULL},
};
enum { FUNCTIONS = sizeof functions / sizeof functions[0] };

static const function_row *find_function(values *v, const formula *f)
{
    const char *names[FUNCTIONS];
    for (size_t i = 0; i < FUNCTIONS; i++) {
        names[i] = functions[i].name;
        if (strcmp(f->name, names[i]) == 0) {
            return &functions[i];
        }
    }
    source_problem(v->s, f->at, "no function is called '%s'%s", f->name,
                   source_suggestion(v->s, f->name, names, FUNCTIONS));
    return NULL;
}

value call_of_formula(values *v, const formula *f)
{
    const function_row *row = find_function(v, f);
    if (row == NULL) {
        return nothing;
    }
    if (row->call == NULL) {
        return points_of_formula(v, f);
    }
    if (f->count < row->least || f->count > row->most) {
        source_problem(v->s, f->at, "%s is written like this: %s", f->name, row->example);
        return nothing;
    }
    value given[ANY_NUMBER];
    for (size_t i = 0; i < f->count; i++) {
        given[i] = value_any(v, f->parts[i]);
        if (given[i].count == 0) {
            return nothing;
        }
        if (given[i].count != 1) {
            source_problem(v->s, f->parts[i]->at, "%s is of numbers; this is a vector", f->name);
            return nothing;
        }
    }
    return row->call(v, f, given);
}
