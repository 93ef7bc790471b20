#include "tools/isoc/value.h"

#include <math.h>
#include <string.h>

static const dimension plain = {0, 0, 0, 0}, second = {0, 0, 1, 0};
static const double pi = 3.14159265358979323846;

static value evaluate(values *v, const formula *f);

void values_start(values *v, source *s, graph *g, const scene *written)
{
    *v = (values){.s = s, .g = g, .scene = written};
    const size_t room = written->parameter_count + 1;
    v->parameters = arena_take(s->memory, room, sizeof *v->parameters);
    v->resolving = arena_take(s->memory, room, sizeof *v->resolving);
    v->defaults = arena_take(s->memory, room, sizeof *v->defaults);
    for (size_t i = 0; i < written->parameter_count; i++) {
        v->tunables += written->parameters[i].tunable;
    }
}

static value nothing(void)
{
    return (value){0};
}

static value scalar(node n, dimension of)
{
    return (value){.count = 1, .parts = {n}, .of = of};
}

/* The position of parameter i among the tunables. */
static int tunable_index(const scene *written, size_t i)
{
    int index = 0;
    for (size_t j = 0; j < i; j++) {
        index += written->parameters[j].tunable;
    }
    return index;
}

static value resolve(values *v, size_t i, place used_at)
{
    const quantity *q = &v->scene->parameters[i];
    if (v->resolving[i] == 1) {
        source_problem(v->s, used_at, "'%s' depends on itself", q->name.text);
        return nothing();
    }
    if (v->resolving[i] == 2) {
        return v->parameters[i];
    }
    v->resolving[i] = 1;
    value result = q->value == NULL ? nothing() : evaluate(v, q->value);
    if (result.count > 0 && q->tunable) {
        const int index = tunable_index(v->scene, i);
        if (result.count != 1 || !is_constant(v->g, result.parts[0])) {
            source_problem(v->s, q->value->at, "a tunable parameter is one number that no other tunable is part of");
            result = nothing();
        } else {
            v->defaults[index] = constant_value(v->g, result.parts[0]);
            result.parts[0] = leaf(v->g, OP_PARAMETER, index);
            result.any = false;
        }
    }
    v->parameters[i] = result;
    v->resolving[i] = 2;
    return result;
}

void values_resolve(values *v)
{
    for (size_t i = 0; i < v->scene->parameter_count; i++) {
        resolve(v, i, v->scene->parameters[i].name.at);
    }
}

/* Whether a formula may not depend on time, which it notes. */
static bool refuses_time(values *v, const formula *f)
{
    if (!v->time_allowed) {
        source_problem(v->s, f->at, "'%s' is a function of time: only an input or a motion can be one", f->name);
    }
    return !v->time_allowed;
}

static value evaluate_name(values *v, const formula *f)
{
    const size_t count = v->scene->parameter_count;
    if (strcmp(f->name, "pi") == 0) {
        return scalar(constant(v->g, pi), plain);
    }
    if (strcmp(f->name, "time") == 0) {
        return refuses_time(v, f) ? nothing() : scalar(timed(v->g, OP_TIME, 0.0, v->step), second);
    }
    const char **names = arena_take(v->s->memory, count + 1, sizeof *names);
    for (size_t i = 0; i < count; i++) {
        const char *text = v->scene->parameters[i].name.text;
        names[i] = text == NULL ? "" : text;
        if (strcmp(names[i], f->name) == 0) {
            return resolve(v, i, f->at);
        }
    }
    source_problem(v->s, f->at, "no constant or tunable is called '%s'%s", f->name,
                   source_suggestion(v->s, f->name, names, count));
    return nothing();
}

static value evaluate_number(values *v, const formula *f)
{
    const double number = f->number * f->unit.numerator / f->unit.denominator;
    value r = scalar(constant(v->g, isfinite(number) ? number : 0.0), f->unit.of);
    if (!isfinite(number)) {
        source_problem(v->s, f->at, "the number is too large in SI units: a double ends at 1.8e308");
        return nothing();
    }
    r.any = f->number == 0.0 && dimension_equal(f->unit.of, plain);
    return r;
}

/* Parts of one dimension, but for plain zeros. */
static value evaluate_vector(values *v, const formula *f)
{
    value r = {.any = true};
    if (f->count > VALUE_PARTS) {
        source_problem(v->s, f->at, "%zu parts: a vector has three (x, y, z), and nothing has more than six", f->count);
        return nothing();
    }
    for (size_t i = 0; i < f->count; i++) {
        const value part = evaluate(v, f->parts[i]);
        if (part.count == 0) {
            return nothing();
        }
        if (part.count != 1) {
            source_problem(v->s, f->parts[i]->at, "a part of a vector is one number");
            return nothing();
        }
        if (!part.any && !r.any && !dimension_equal(part.of, r.of)) {
            source_problem(v->s, f->parts[i]->at, "%s beside %s in one vector", dimension_text(v->s->memory, part.of),
                           dimension_text(v->s->memory, r.of));
            return nothing();
        }
        if (!part.any) {
            r.of = part.of;
            r.any = false;
        }
        r.parts[r.count++] = part.parts[0];
    }
    return r;
}

static value evaluate_scale(values *v, const formula *f)
{
    value r = evaluate(v, f->parts[0]);
    if (r.count > 0 && !dimension_equal(r.of, plain)) {
        source_problem(v->s, f->at, "a unit after a parenthesis that has units inside");
        return nothing();
    }
    for (int i = 0; i < r.count; i++) {
        const node scaled = mul(v->g, r.parts[i], constant(v->g, f->unit.numerator));
        r.parts[i] = is_constant(v->g, scaled) ? constant(v->g, constant_value(v->g, scaled) / f->unit.denominator)
                                               : divide(v->g, scaled, constant(v->g, f->unit.denominator));
    }
    r.of = f->unit.of;
    r.any = false;
    return r;
}

static value evaluate_sum(values *v, const formula *f, value a, value b)
{
    if (a.count != b.count) {
        source_problem(v->s, f->at, "a vector and a number cannot be added");
        return nothing();
    }
    if (!a.any && !b.any && !dimension_equal(a.of, b.of)) {
        source_problem(v->s, f->at, "%s and %s cannot be added", dimension_text(v->s->memory, a.of),
                       dimension_text(v->s->memory, b.of));
        return nothing();
    }
    value r = a.any ? b : a;
    for (int i = 0; i < a.count; i++) {
        r.parts[i] = f->sign == '+' ? add(v->g, a.parts[i], b.parts[i]) : sub(v->g, a.parts[i], b.parts[i]);
    }
    return r;
}

static value evaluate_product(values *v, const formula *f, value a, value b)
{
    if ((a.count != 1 && b.count != 1) || (f->sign == '/' && b.count != 1)) {
        source_problem(v->s, f->at, "a product has at most one vector, and none below a fraction");
        return nothing();
    }
    if (f->sign == '/' && value_now(v, b.parts[0]) == 0.0) {
        source_problem(v->s, f->at, "division by zero");
        return nothing();
    }
    const value wide = a.count != 1 ? a : b;
    value r = {.count = wide.count, .of = a.of};
    for (int i = 0; i < r.count; i++) {
        const node left = a.parts[a.count == 1 ? 0 : i], right = b.parts[b.count == 1 ? 0 : i];
        r.parts[i] = f->sign == '*' ? mul(v->g, left, right) : divide(v->g, left, right);
    }
    if (!dimension_times(&r.of, b.of, f->sign == '*' ? 1 : -1)) {
        source_problem(v->s, f->at, "a power of a unit beyond 9");
        return nothing();
    }
    return r;
}

static value evaluate_binary(values *v, const formula *f)
{
    const value a = evaluate(v, f->parts[0]), b = evaluate(v, f->parts[1]);
    if (a.count == 0 || b.count == 0) {
        return nothing();
    }
    return f->sign == '+' || f->sign == '-' ? evaluate_sum(v, f, a, b) : evaluate_product(v, f, a, b);
}

static value evaluate_power(values *v, const formula *f)
{
    value r = evaluate(v, f->parts[0]);
    if (r.count > 1) {
        source_problem(v->s, f->at, "a vector has no power");
        return nothing();
    }
    if (r.count == 1) {
        const dimension of = r.of;
        r.parts[0] = power(v->g, r.parts[0], (int)f->number);
        r.of = plain;
        r.any = false;
        if (!dimension_times(&r.of, of, (int)f->number)) {
            source_problem(v->s, f->at, "a power of a unit beyond 9");
            return nothing();
        }
    }
    return r;
}

/* sin(3 Hz), sin(3 Hz, 90 deg), sin(2 rad/s): a phase that grows with the ticks. */
static value evaluate_wave(values *v, const formula *f)
{
    static const dimension hertz = {0, 0, -1, 0}, radian = {0, 0, 0, 1}, speed = {0, 0, -1, 1};
    if (f->count != 1 && f->count != 2) {
        source_problem(v->s, f->at, "%s takes a frequency and, if wanted, a phase: %s(3 Hz, 90 deg)", f->name, f->name);
        return nothing();
    }
    value frequency = evaluate(v, f->parts[0]);
    if (frequency.count == 1 && dimension_equal(frequency.of, speed)) {
        frequency.parts[0] = divide(v->g, frequency.parts[0], constant(v->g, 2 * pi));
        frequency.of = hertz;
    }
    if (frequency.count == 0) {
        return nothing();
    }
    if (frequency.count != 1 || !dimension_equal(frequency.of, hertz) || !is_constant(v->g, frequency.parts[0])) {
        source_problem(v->s, f->parts[0]->at, "expected a constant frequency in Hz or rad/s");
        return nothing();
    }
    const double phase = f->count == 2 ? value_constant(v, f->parts[1], radian, "the phase", 0.0) : 0.0;
    const double turns = constant_value(v->g, frequency.parts[0]) * v->step;
    if (fabs(turns) > 0.5) {
        source_problem(v->s, f->parts[0]->at, "more than half a period in a step: the wave cannot be seen");
        return nothing();
    }
    const node angle = timed(v->g, OP_PHASE, turns, phase / (2 * pi));
    return scalar(strcmp(f->name, "sin") == 0 ? sine(v->g, angle) : cosine(v->g, angle), plain);
}

/* How far time is from tick `from` on, as a part of so many ticks, limited to [0, 1], on the way of a smooth curve:
 * c^3 (10 - 15 c + 6 c^2), whose slope and curvature are zero at both ends (the 3-4-5 polynomial of cams). `first` is the
 * tick at which the curve begins. */
static node smooth_part(values *v, double first, double from, double ticks)
{
    graph *g = v->g;
    const node since = timed(g, OP_SINCE, first, v->step);
    const node part = divide(g, sub(g, since, constant(g, (from - first) * v->step)), constant(g, ticks * v->step));
    const node below = larger(g, neg(g, part), constant(g, -1.0)), c = larger(g, constant(g, 0.0), neg(g, below));
    const node inner = sub(g, mul(g, constant(g, 6.0), c), constant(g, 15.0));
    const node cube = power(g, c, 3), outer = add(g, constant(g, 10.0), mul(g, c, inner));
    return mul(g, cube, outer);
}

/* table(0 s: 0 N, 1 s: 8 N, ...): straight lines between the points, ramp(0 s: 0 N, 1 s: 8 N, ...): smooth curves; the end
 * values outside. */
static value evaluate_points(values *v, const formula *f)
{
    const bool is_smooth = strcmp(f->name, "ramp") == 0;
    if (f->count < 2 || f->count % 2 != 0) {
        source_problem(v->s, f->at, "a %s is pairs of time and value: %s(0 s: 0 N, 1 s: 8 N)", f->name, f->name);
        return nothing();
    }
    const char *a_time = arena_format(v->s->memory, "a time of the %s", f->name);
    value sum = evaluate(v, f->parts[1]), last = sum;
    const double first = value_constant(v, f->parts[0], second, a_time, 0.0) / v->step;
    double last_time = first;
    for (size_t i = 2; i < f->count && sum.count > 0; i += 2) {
        const double time = value_constant(v, f->parts[i], second, a_time, 0.0) / v->step;
        const value here = evaluate(v, f->parts[i + 1]);
        if (here.count == 0) {
            return nothing();
        }
        if (here.count != 1 || last.count != 1 || (!here.any && !last.any && !dimension_equal(here.of, last.of))) {
            source_problem(v->s, f->parts[i + 1]->at, "the values of a %s are numbers of one dimension", f->name);
            return nothing();
        }
        if (!(time > last_time) || last_time < 0.0 || time > 4e9) {
            source_problem(v->s, f->parts[i]->at, "the times of a %s begin at 0 or later and rise", f->name);
            return nothing();
        }
        const node rise = sub(v->g, here.parts[0], last.parts[0]);
        const double ticks = time - last_time;
        const node weight = is_smooth ? rise : divide(v->g, rise, constant(v->g, ticks));
        const node part = is_smooth ? smooth_part(v, first, last_time, ticks) : timed(v->g, OP_RAMP, last_time, ticks);
        sum.parts[0] = add(v->g, sum.parts[0], mul(v->g, weight, part));
        sum.of = here.any ? last.of : here.of;
        sum.any = here.any && last.any;
        last = here;
        last.of = sum.of;
        last.any = sum.any;
        last_time = time;
    }
    return sum;
}

static value evaluate_call(values *v, const formula *f)
{
    static const char *const functions[] = {"sin", "cos", "table", "ramp"};
    const size_t count = sizeof functions / sizeof functions[0];
    size_t which = 0;
    while (which < count && strcmp(f->name, functions[which]) != 0) {
        which++;
    }
    if (which == count) {
        source_problem(v->s, f->at, "no function is called '%s'%s", f->name,
                       source_suggestion(v->s, f->name, functions, count));
        return nothing();
    }
    if (v->is_smooth && strcmp(f->name, "table") == 0) {
        source_problem(v->s, f->at, "a motion is smooth, and a table has corners: ramp has none");
        return nothing();
    }
    if (refuses_time(v, f)) {
        return nothing();
    }
    return which < 2 ? evaluate_wave(v, f) : evaluate_points(v, f);
}

static value evaluate(values *v, const formula *f)
{
    value r;
    switch (f->kind) {
    case FORMULA_NUMBER:
        return evaluate_number(v, f);
    case FORMULA_NAME:
        return evaluate_name(v, f);
    case FORMULA_VECTOR:
        return evaluate_vector(v, f);
    case FORMULA_SCALE:
        return evaluate_scale(v, f);
    case FORMULA_BINARY:
        return evaluate_binary(v, f);
    case FORMULA_POWER:
        return evaluate_power(v, f);
    case FORMULA_CALL:
        return evaluate_call(v, f);
    case FORMULA_NEGATE:
        break;
    }
    r = evaluate(v, f->parts[0]);
    for (int i = 0; i < r.count; i++) {
        r.parts[i] = neg(v->g, r.parts[i]);
    }
    return r;
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

value value_of(values *v, const formula *f, dimension of, int parts, const char *what)
{
    value r = evaluate(v, f);
    if (r.count == 0) {
        return r;
    }
    if (!right_parts(r.count, parts)) {
        const char *found = r.count == 1 ? "one number" : arena_format(v->s->memory, "%d numbers", r.count);
        source_problem(v->s, f->at, "%s is %s; this is %s", what, form_of(parts), found);
        return nothing();
    }
    if (!r.any && !dimension_equal(r.of, of)) {
        source_problem(v->s, f->at, "%s %s; this %s", what, dimension_phrase(v->s->memory, of),
                       dimension_phrase(v->s->memory, r.of));
        return nothing();
    }
    for (int i = 0; i < r.count; i++) {
        if (!isfinite(value_now(v, r.parts[i]))) {
            source_problem(v->s, f->at, "%s is beyond the finite numbers", what);
            return nothing();
        }
    }
    r.of = of;
    return r;
}

double value_constant(values *v, const formula *f, dimension of, const char *what, double fallback)
{
    if (f == NULL) {
        return fallback;
    }
    const value r = value_of(v, f, of, 1, what);
    if (r.count == 0) {
        return fallback;
    }
    if (!is_constant(v->g, r.parts[0])) {
        source_problem(v->s, f->at, "%s cannot depend on a tunable parameter", what);
        return fallback;
    }
    return constant_value(v->g, r.parts[0]);
}

double value_displacement(values *v, const formula *f, const char *what, double fallback)
{
    static const dimension metre = {0, 1, 0, 0}, radian = {0, 0, 0, 1};
    const value found = f == NULL ? nothing() : evaluate(v, f);
    const dimension of = dimension_equal(found.of, radian) ? radian : metre;
    return found.count == 0 ? fallback : value_constant(v, f, of, what, fallback);
}

double value_now(const values *v, node n)
{
    double *numbers = arena_take(v->s->memory, v->g->count, sizeof *numbers);
    graph_evaluate(v->g, NULL, NULL, v->defaults, numbers);
    return numbers[n];
}
