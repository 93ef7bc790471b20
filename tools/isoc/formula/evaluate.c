/* From formulas to values. */
#include <math.h>
#include <string.h>

#include "tools/isoc/formula/condition.h"
#include "tools/isoc/formula/functions.h"
#include "tools/isoc/formula/scalar.h"
#include "tools/isoc/formula/ticks.h"
#include "tools/isoc/scene/names.h"

void values_start(values *v, source *s, graph *g, const scene *written, size_t more, bool is_double)
{
    *v = (values){.s = s, .g = g, .scene = written, .is_double = is_double};
    const size_t room = written->parameters.count + 1;
    v->parameters = arena_take(s->memory, room, sizeof *v->parameters);
    v->progress = arena_take(s->memory, room, sizeof *v->progress);
    v->default_room = room + more;
    v->defaults = arena_take(s->memory, v->default_room, sizeof *v->defaults);
    v->tunable_index = arena_take(s->memory, room, sizeof *v->tunable_index);
    v->names = (dictionary){.memory = s->memory};
    for (size_t i = 0; i < written->parameters.count; i++) {
        const quantity *q = &written->parameters.all[i];
        v->tunable_index[i] = v->tunables;
        v->tunables += q->tunable;
        if (q->name.text != NULL && dictionary_find(&v->names, q->name.text) == NULL) {
            dictionary_put(&v->names, q->name.text, (int)i);
        }
    }
}

/* A value of --set for a parameter: one of the same unit and as many components as the value in the scene. */
static value check_set(values *v, const quantity *q, value set)
{
    v->is_parameter = true;
    const value stated = value_any(v, q->stated);
    v->is_parameter = false;
    if (set.count == 0 || stated.count == 0) {
        return nothing;
    }
    if (set.count != stated.count) {
        return REFUSED(v->s, q->value->at, "'%s' %s; this %s", q->name.text,
                       stated.count == 1 ? "is one number" : "is a vector (x, y, z)",
                       set.count == 1 ? "is one number" : "is a vector");
    }
    if (!set.any && !stated.any && !dimension_equal(set.dim, stated.dim)) {
        return REFUSED(v->s, q->value->at, "'%s' %s in the scene; this %s", q->name.text,
                       dimension_phrase(v->s->memory, stated.dim), dimension_phrase(v->s->memory, set.dim));
    }
    set.dim = set.any ? stated.dim : set.dim;
    return set;
}

/* A parameter, from its formula; those that this names have their values. */
static void evaluate_parameter(values *v, size_t i)
{
    const quantity *q = &v->scene->parameters.all[i];
    v->is_parameter = true;
    value result = q->value == NULL ? nothing : value_any(v, q->value);
    v->is_parameter = false;
    result = q->stated == NULL ? result : check_set(v, q, result);
    const char *called = q->name.text;
    if (result.count > 1 && called != NULL && called[0] >= 'x' && called[0] <= 'z' && called[1] == '\0') {
        source_problem(v->s, q->name.at, "a vector '%s' would be read as the axis: choose another name", called);
        result = nothing;
    }
    if (result.count > 0 && q->tunable) {
        const int index = v->tunable_index[i];
        if (result.count != 1 || !is_constant(v->g, result.parts[0])) {
            source_problem(v->s, q->value->at,
                           "a tunable parameter must be one number that depends on no other tunable");
            result = nothing;
        } else if (!check_range(v, q->value, "this parameter", constant_value(v->g, result.parts[0]))) {
            result = nothing;
        } else {
            v->defaults[index] = constant_value(v->g, result.parts[0]);
            result.parts[0] = leaf(v->g, OP_PARAMETER, index);
            result.any = false;
        }
    }
    v->parameters[i] = result;
    v->progress[i] = DONE;
}

/* Parameters that wait for one another, the last for nobody. */
typedef LIST_OF(size_t) queue;

static void wait_for(values *v, queue *q, size_t i)
{
    if (v->progress[i] == NOT_YET) {
        LIST_ADD(v->s->memory, *q, i);
    }
}

/* Queues the parameters that a formula names and that have no value yet; the first of them comes last. */
static void wait_for_names(values *v, queue *q, const formula *f)
{
    const int *i = f->kind == FORMULA_NAME ? dictionary_find(&v->names, f->name) : NULL;
    if (i != NULL) {
        wait_for(v, q, (size_t)*i);
    }
    for (size_t n = f->count; n-- > 0;) {
        wait_for_names(v, q, f->parts[n]);
    }
}

/* The parameters that a parameter depends on come first, by a queue and not by recursion: a chain of them may be long.
 */
static void resolve(values *v, size_t wanted)
{
    queue q = {0};
    for (wait_for(v, &q, wanted); q.count > 0;) {
        const size_t i = q.all[q.count - 1];
        const formula *f = v->scene->parameters.all[i].value;
        if (v->progress[i] == NOT_YET && f != NULL) {
            v->progress[i] = STARTED;
            wait_for_names(v, &q, f);
            if (v->scene->parameters.all[i].stated != NULL) {
                wait_for_names(v, &q, v->scene->parameters.all[i].stated);
            }
        } else {
            if (v->progress[i] != DONE) {
                evaluate_parameter(v, i);
            }
            q.count--;
        }
    }
}

void values_resolve(values *v)
{
    for (size_t i = 0; i < v->scene->parameters.count; i++) {
        resolve(v, i);
    }
}

/* Notes that a formula changes with time, so that it has no constant value. */
static value refuse_changing(values *v, const formula *f, const char *called)
{
    return REFUSED(v->s, f->at, "'%s' changes with time: only an effect, a signal or an output can use it", called);
}

/* Notes that a signal or an input stands where a number is constant but for what sets it between ticks. */
static value refuse_moving(values *v, const formula *f, const char *sort)
{
    return REFUSED(v->s, f->at,
                   "'%s' is %s, which changes with time, and this does not: a constant or a tunable stands here; the "
                   "program, or 'at 1 s set NAME = VALUE', sets a tunable",
                   f->name, sort);
}

static value refuse_name(values *v, const formula *f)
{
    if (v->around == NULL && quantity_of_nothing(f->name) < QUANTITY_ROWS) {
        return refuse_changing(v, f, f->name);
    }
    if (v->around == NULL && (INDEX_OF(v->scene->signals, f->name) >= 0 || INDEX_OF(v->scene->inputs, f->name) >= 0)) {
        return refuse_moving(v, f, INDEX_OF(v->scene->signals, f->name) >= 0 ? "a signal" : "an input");
    }
    const char *owners = quantity_owners(v->s->memory, f->name);
    if (owners != NULL) {
        return REFUSED(v->s, f->at, "'%s' is of %s: %s of NAME", f->name, owners, f->name);
    }
    return REFUSED(v->s, f->at, "no constant%s is called '%s'%s",
                   v->around == NULL ? " or tunable" : ", tunable, input or signal", f->name,
                   suggest_number(v->s, v->scene, f->name, v->around != NULL));
}

/* 1024 / rev: a unit, where nothing has its name. */
static value evaluate_unit(values *v, const formula *f)
{
    unit u;
    if (!unit_find(f->name, &u)) {
        return refuse_name(v, f);
    }
    return u.zero == 0.0 ? scalar(constant(v->g, u.numerator / u.denominator), u.dim)
                         : REFUSED(v->s, f->at, "'%s' stands alone behind a number, as in 20 %s", f->name, f->name);
}

static value evaluate_name(values *v, const formula *f)
{
    value found;
    if (v->around != NULL && v->around->find(v->around->context, f, &found)) {
        return found;
    }
    if (strcmp(f->name, "pi") == 0) {
        return scalar(constant(v->g, pi), plain);
    }
    if (strcmp(f->name, "time") == 0) {
        return time_of_formula(v, f);
    }
    const int *i = dictionary_find(&v->names, f->name);
    if (i == NULL) {
        return evaluate_unit(v, f);
    }
    if (v->progress[*i] == STARTED) {
        return REFUSED(v->s, f->at, "'%s' depends on itself", f->name);
    }
    resolve(v, (size_t)*i);
    return v->parameters[*i];
}

static value evaluate_number(values *v, const formula *f)
{
    const double multiple = f->number * f->unit.numerator / f->unit.denominator;
    const double number = f->unit.zero == 0.0 ? multiple : (multiple * 100 + f->unit.zero) / 100;
    value r = scalar(constant(v->g, isfinite(number) ? number : 0.0), f->unit.dim);
    if (!isfinite(number)) {
        return REFUSED(v->s, f->at, "the number is too large in SI units: a double ends at 1.8e308");
    }
    r.any = f->number == 0.0 && dimension_equal(f->unit.dim, plain);
    r.on_scale = f->unit.zero != 0.0;
    return r;
}

/* Parts of one dimension, but for plain zeros. */
static value evaluate_vector(values *v, const formula *f)
{
    value r = {.any = true};
    if (f->count > VALUE_PARTS) {
        return REFUSED(v->s, f->at, "%zu parts: a vector has three (x, y, z), an inertia three or six", f->count);
    }
    for (size_t i = 0; i < f->count; i++) {
        const value part = value_any(v, f->parts[i]);
        if (part.count == 0) {
            return nothing;
        }
        if (part.count != 1) {
            return REFUSED(v->s, f->parts[i]->at, "a part of a vector must be one number");
        }
        if (!part.any && !r.any && !agree(v, part.dim, r.dim)) {
            return REFUSED(v->s, f->parts[i]->at, "%s and %s in one vector: its parts must have the same unit",
                           dimension_text(v->s->memory, part.dim), dimension_text(v->s->memory, r.dim));
        }
        gather(&r, &part);
        r.parts[r.count++] = part.parts[0];
    }
    return r;
}

static value evaluate_scale(values *v, const formula *f)
{
    value r = value_any(v, f->parts[0]);
    if (r.count > 0 && !agree(v, r.dim, plain)) {
        return REFUSED(v->s, f->at, "units inside the parentheses and after them: write only one of both");
    }
    for (int i = 0; i < r.count; i++) {
        const node scaled = mul(v->g, r.parts[i], constant(v->g, f->unit.numerator));
        r.parts[i] = is_constant(v->g, scaled) ? constant(v->g, constant_value(v->g, scaled) / f->unit.denominator)
                                               : divide(v->g, scaled, constant(v->g, f->unit.denominator));
    }
    for (int i = 0; i < r.count && f->unit.zero != 0.0; i++) {
        r.parts[i] = add(v->g, r.parts[i], constant(v->g, f->unit.zero / 100));
    }
    r.dim = f->unit.dim;
    r.any = false;
    r.on_scale = f->unit.zero != 0.0;
    return r;
}

/* The meaning of 2 * 20 degC and 20 degC + 5 degC depends on the zero of the scale. Returns false after noting such a
 * problem. */
static bool is_free_of_scale(values *v, const formula *f, bool on_scale)
{
    return !on_scale || source_problem(v->s, f->at,
                                       "a temperature in degC is no factor, power or term of a sum of two, and has no "
                                       "minus before its parentheses: give a difference in K");
}

static value evaluate_sum(values *v, const formula *f, value a, value b)
{
    if (a.count != b.count) {
        return REFUSED(v->s, f->at, "a vector and a number cannot be added");
    }
    if (!a.any && !b.any && !agree(v, a.dim, b.dim)) {
        return REFUSED(v->s, f->at, "%s and %s cannot be added", dimension_text(v->s->memory, a.dim),
                       dimension_text(v->s->memory, b.dim));
    }
    if (!is_free_of_scale(v, f, f->sign == '+' && a.on_scale && b.on_scale)) {
        return nothing;
    }
    value r = a;
    gather(&r, &b);
    r.on_scale = f->sign == '+' ? a.on_scale || b.on_scale : a.on_scale && !b.on_scale;
    for (int i = 0; i < a.count; i++) {
        r.parts[i] = f->sign == '+' ? add(v->g, a.parts[i], b.parts[i]) : sub(v->g, a.parts[i], b.parts[i]);
    }
    return r;
}

static value evaluate_product(values *v, const formula *f, value a, value b)
{
    if ((a.count != 1 && b.count != 1) || (f->sign == '/' && b.count != 1)) {
        return REFUSED(v->s, f->at, "a vector cannot be multiplied by a vector, nor divide");
    }
    const bool is_known = v->around == NULL || is_constant(v->g, b.parts[0]);
    if (f->sign == '/' && is_known && value_now(v, b.parts[0]) == 0.0) {
        return REFUSED(v->s, f->at, "division by zero");
    }
    if (!is_free_of_scale(v, f, a.on_scale || b.on_scale)) {
        return nothing;
    }
    const value wide = a.count != 1 ? a : b;
    value r = {.count = wide.count, .dim = a.dim};
    for (int i = 0; i < r.count; i++) {
        const node left = a.parts[a.count == 1 ? 0 : i], right = b.parts[b.count == 1 ? 0 : i];
        r.parts[i] = f->sign == '*' ? mul(v->g, left, right) : divide(v->g, left, right);
    }
    return multiply(v, f, &r.dim, b.dim, f->sign == '*' ? 1 : -1) ? r : nothing;
}

static value evaluate_chain(values *v, const formula *f)
{
    value r = value_any(v, f->parts[0]);
    for (size_t i = 1; i < f->count; i++) {
        const formula *step = f->parts[i];
        const value right = value_any(v, step->parts[0]);
        if (r.count == 0 || right.count == 0) {
            r = nothing;
        } else if (step->sign == '+' || step->sign == '-') {
            r = evaluate_sum(v, step, r, right);
        } else {
            r = evaluate_product(v, step, r, right);
        }
    }
    return r;
}

static value evaluate_power(values *v, const formula *f)
{
    const value base = value_any(v, f->parts[0]), exponent = value_any(v, f->parts[1]);
    if (base.count > 1 || exponent.count > 1) {
        return REFUSED(v->s, f->at, "a vector cannot be raised to a power, nor be one");
    }
    if (base.count == 0 || exponent.count == 0 || !is_free_of_scale(v, f, base.on_scale)) {
        return nothing;
    }
    return power_of(v, f, &base, &exponent);
}

/* Points of a function of time, or of one or two quantities. */
static value evaluate_points(values *v, const formula *f)
{
    if (f->number == 0.0 || strcmp(f->name, "table") != 0) {
        return points_of_formula(v, f);
    }
    const value result = f->number > 1.0 ? grid_of_formula(v, f) : table_of_formula(v, f);
    return result.count > 0 && refuses_corner(v, f, &result, 1) ? nothing : result;
}

/* A function of time: in the formula of an input its nodes, once for each call; elsewhere an input of its own. */
static value function_of_time(values *v, const formula *f, function_call *call, const value *arguments)
{
    if (is_time_input(v)) {
        return v->around->time_input(v->around->context, f);
    }
    const table_call *before = table_made(v, f);
    if (!is_in_input(v, f)) {
        return nothing;
    }
    return before != NULL ? scalar(before->root, plain) : call(v, f, arguments);
}

static value evaluate_call(values *v, const formula *f)
{
    value own;
    if (v->around != NULL && v->around->call(v->around->context, f, &own)) {
        return own;
    }
    const function_row *row = find_function(v, f);
    if (row == NULL) {
        return nothing;
    }
    if (row->kind == OF_POINTS) {
        return evaluate_points(v, f);
    }
    if (f->count < row->least || f->count > row->most) {
        return REFUSED(v->s, f->at, "%s is written like this: %s", f->name, row->example);
    }
    if (row->kind == OF_PAST) { /* of a formula that is not evaluated yet */
        return v->around == NULL ? refuse_changing(v, f, f->name) : v->around->history_memory(v->around->context, f);
    }
    value arguments[MOST_ARGUMENTS];
    for (size_t i = 0; i < f->count; i++) {
        arguments[i] = value_any(v, f->parts[i]);
        if (arguments[i].count == 0) {
            return nothing;
        }
        if (arguments[i].count != row->parts) {
            return REFUSED(v->s, f->parts[i]->at, "%s takes %s; this is %s", f->name,
                           row->parts == 1 ? "numbers" : "vectors", row->parts == 1 ? "a vector" : "a number");
        }
    }
    return row->kind == OF_VALUES ? row->call(v, f, arguments) : function_of_time(v, f, row->call, arguments);
}

static value evaluate_order(values *v, const formula *f)
{
    const value first = value_any(v, f->parts[0]);
    const value arguments[] = {first, value_any(v, f->parts[1])};
    return arguments[0].count == 0 || arguments[1].count == 0 ? nothing : order_of(v, f, arguments);
}

static value evaluate_logic(values *v, const formula *f)
{
    value arguments[2] = {nothing, nothing};
    for (size_t i = 0; i < f->count; i++) {
        arguments[i] = value_any(v, f->parts[i]);
        if (arguments[i].count == 0) {
            return nothing;
        }
    }
    return logic_of(v, f, arguments);
}

static value quantity_of_formula(values *v, const formula *f)
{
    return v->around != NULL
               ? v->around->quantity(v->around->context, f)
               : refuse_changing(v, f, arena_format(v->s->memory, "%s of %s", f->name, f->parts[0]->name));
}

value value_any(values *v, const formula *f)
{
    value r;
    switch (f->kind) {
    case FORMULA_NUMBER:
        return evaluate_number(v, f);
    case FORMULA_NAME:
    case FORMULA_CALL:
        r = f->kind == FORMULA_NAME ? evaluate_name(v, f) : evaluate_call(v, f);
        r.on_scale = false;
        return r;
    case FORMULA_VECTOR:
        return evaluate_vector(v, f);
    case FORMULA_SCALE:
        return evaluate_scale(v, f);
    case FORMULA_CHAIN:
        return evaluate_chain(v, f);
    case FORMULA_POWER:
        return evaluate_power(v, f);
    case FORMULA_OF:
        return quantity_of_formula(v, f);
    case FORMULA_ORDER:
        return evaluate_order(v, f);
    case FORMULA_LOGIC:
        return evaluate_logic(v, f);
    case FORMULA_FILE:
        return function_of_time(v, f, file_of_formula, NULL);
    case FORMULA_STEP:
    case FORMULA_NEGATE:
        break;
    }
    r = value_any(v, f->parts[0]);
    if (!is_free_of_scale(v, f, r.on_scale)) {
        return nothing;
    }
    for (int i = 0; i < r.count; i++) {
        r.parts[i] = neg(v->g, r.parts[i]);
    }
    return r;
}

value value_of(values *v, const formula *f, dimension expected, int parts, const char *what)
{
    return value_fitting(v, f, value_any(v, f), expected, parts, what);
}

double value_constant(values *v, const formula *f, dimension expected, const char *what, double fallback)
{
    if (f == NULL) {
        return fallback;
    }
    const value found = value_any(v, f);
    return constant_fitting(v, f, &found, expected, what, fallback);
}
