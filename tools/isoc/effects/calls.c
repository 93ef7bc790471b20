/* function NAME(a, b) = FORMULA in definitions: a call has the value of the formula, with the values of its arguments
 * for their names. The formula sees besides them what the definition has. */
#include "tools/isoc/effects/effects.h"

#include <string.h>

/* The function of the present definition with this name; NULL: there is none. */
static const effect_line *function_of(const effect_scope *w, const char *called)
{
    const effect_kind *kind = w->within == NULL ? NULL : w->within->kind;
    for (size_t i = 0; kind != NULL && i < kind->line_count; i++) {
        if (kind->lines[i].kind == EFFECT_FUNCTION && name_is(kind->lines[i].name, called)) {
            return &kind->lines[i];
        }
    }
    return NULL;
}

static bool is_open(const effect_scope *w, const effect_line *function)
{
    const call_frame *frame = w->frame;
    while (frame != NULL && frame->function != function) {
        frame = frame->outer;
    }
    return frame != NULL;
}

bool call_value(void *context, const formula *f, value *found)
{
    effect_scope *w = context;
    const effect_line *line = function_of(w, f->name);
    if (line == NULL) {
        return false;
    }
    call_frame frame = {.function = line, .outer = w->frame};
    *found = nothing;
    if (f->count != line->arguments.count || f->count > MOST_ARGUMENTS) {
        source_problem(w->b->s, f->at, "'%s' has %zu arguments; here are %zu", f->name, line->arguments.count,
                       f->count);
        return true;
    }
    if (is_open(w, line)) {
        source_problem(w->b->s, f->at, "the function '%s' needs itself", f->name);
        return true;
    }
    for (size_t i = 0; i < f->count; i++) {
        frame.arguments[i] = value_any(&w->b->values, f->parts[i]);
        if (frame.arguments[i].count == 0) {
            return true;
        }
    }
    w->frame = &frame;
    *found = line->value == NULL ? nothing : value_any(&w->b->values, line->value);
    w->frame = frame.outer;
    return true;
}

bool find_argument(const effect_scope *w, const char *called, value *found)
{
    for (size_t i = 0; w->frame != NULL && i < w->frame->function->arguments.count; i++) {
        if (name_is(w->frame->function->arguments.all[i], called)) {
            *found = w->frame->arguments[i];
            return true;
        }
    }
    return false;
}

bool refuse_in_function(const effect_scope *w, const formula *f)
{
    return w->frame != NULL &&
           !source_problem(w->b->s, f->at,
                           "each '%s' is one number, and a function may be called often: give it as an argument",
                           f->name);
}

void check_function(effect_scope *w, const effect_line *line)
{
    if (line->name.text != NULL && function_called(line->name.text) != NULL) {
        source_problem(w->b->s, line->name.at, "'%s' is a function already: choose another name", line->name.text);
    }
}
