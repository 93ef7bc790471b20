#include <math.h>
#include <string.h>

#include "tools/isoc/base/text.h"
#include "tools/isoc/mechanism/builder.h"

static const double rounding = 1e-12; /* of a decimal number in s, relative */

const char *const method_names[ISO_METHODS] = ISO_METHOD_NAMES;

const char *explicit_methods(arena *memory)
{
    const char *words[ISO_METHODS];
    size_t count = 0;
    for (unsigned method = 0; method < ISO_METHODS; method++) {
        if (ISO_IS_EXPLICIT(method)) {
            words[count++] = method_names[method];
        }
    }
    return listed(memory, words, count, "and");
}

unsigned find_method(builder *b, name word)
{
    if (word.text == NULL) {
        return ISO_RK4;
    }
    const size_t found = index_of_word(word.text, method_names, ISO_METHODS);
    if (found < ISO_METHODS) {
        return (unsigned)found;
    }
    source_problem(b->s, word.at, "no method is called '%s'%s; take %s", word.text,
                   source_suggestion(b->s, word.text, method_names, ISO_METHODS),
                   alternatives(b->s->memory, method_names, ISO_METHODS));
    return ISO_RK4;
}

/* Sub-steps of a method of a fixed step: parts of a tick. Features that sample once a tick, or compare single steps,
 * are refused with them. */
static void build_parts(builder *b, unsigned recipe)
{
    const formula *f = b->written->options.substeps;
    method_choice *to = &b->mechanism.method;
    const double ns = floor(to->step * 1e9 + 0.5), parts = to->substeps;
    to->parts = 1;
    if (f == NULL || ISO_IS_VARYING(recipe) || !(parts > 1.0)) {
        return;
    }
    if (parts > 1000.0 || fmod(ns, parts) != 0.0) {
        source_problem(b->s, f->at,
                       "a step of %.0f ns has no %.0f sub-steps of whole nanoseconds; their number is at most 1000", ns,
                       parts);
        return;
    }
    if (ISO_IS_CHECKED(recipe)) {
        source_problem(b->s, f->at,
                       "the local error is that of a tick of one step: leave out substeps, or checked yes");
    }
    for (size_t i = 0; i < b->written->inputs.count; i++) {
        if (b->written->inputs.all[i].smooth) {
            source_problem(b->s, b->written->inputs.all[i].name.at,
                           "a smooth input is for ticks of one step: leave out substeps, or let the input be held");
        }
    }
    to->parts = (int)parts;
}

/* The limits of adams in a tick: a tolerance, and a budget of sub-steps. */
static void build_adams(builder *b)
{
    const method_options *written = &b->written->options;
    method_choice *to = &b->mechanism.method;
    to->tolerance = value_constant(&b->values, written->tolerance, no_unit, "a tolerance", 1e-6);
    to->substeps = whole_number(b, written->substeps, "the number of sub-steps", "", ISO_ADAMS_BUDGET, 1.0, 1e6);
    if (!(to->tolerance > 0.0)) {
        source_problem(b->s, written->tolerance->at, "a tolerance must be larger than zero");
    }
}

/* The method with its options: an output of the local error asks for the check as `checked yes` does. */
void build_method(builder *b)
{
    const scene *written = b->written;
    unsigned recipe = find_method(b, written->method);
    recipe |= written->options.compensated ? ISO_COMPENSATED : 0U;
    recipe |= written->options.checked ? ISO_CHECKED : 0U;
    FOR_EACH (const output, o, written->outputs) {
        const bool is_error = o->formula->kind == FORMULA_NAME && strcmp(o->formula->name, "local_error") == 0;
        recipe |= is_error ? ISO_CHECKED : 0U;
    }
    if (written->options.iterations != NULL) {
        const double count =
            whole_number(b, written->options.iterations, "the number of iterations", "", 2.0, 1.0, 10.0);
        recipe |= ISO_ITERATIONS((unsigned)count);
    }
    b->mechanism.method.recipe = recipe;
    build_adams(b);
    build_parts(b, recipe);
}

void build_step(builder *b)
{
    const formula *f = b->written->step;
    double step = value_constant(&b->values, f, second, "the step", 1e-3);
    const double ns = step * 1e9, whole = floor(ns + 0.5);
    if (f != NULL && !(step >= 1e-6 && step <= 1.0)) {
        source_problem(b->s, f->at, "the step must be between 1 us and 1 s");
        step = 1e-3;
    } else if (f != NULL && fabs(ns - whole) > rounding * ns) {
        source_problem(b->s, f->at, "the step must be a whole number of nanoseconds, such as %.0f ns or %.0f ns",
                       floor(ns), ceil(ns));
    }
    b->values.step = b->mechanism.method.step = step;
}
