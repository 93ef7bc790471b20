/* The scope of a formula: the names of one effect, or those of the scene, and the path of the evaluation. */
#include <string.h>

#include "tools/isoc/effects/effects.h"
#include "tools/isoc/scene/names.h"

const effect_line *line_called(const effect_kind *kind, const char *called, bool is_output)
{
    FOR_ALL (const effect_line, line, kind->lines, kind->line_count) {
        const bool names = line->kind <= EFFECT_STATE || line->kind == EFFECT_MEMORY;
        if ((is_output ? line->kind == EFFECT_OUTPUT : names) && name_is(line->name, called)) {
            return line;
        }
    }
    return NULL;
}

const char *suggestion(source *s, const effect_kind *kind, const char *typed, effect_line_kind from,
                       effect_line_kind to)
{
    const char **names = arena_take(s->memory, kind->line_count + 1, sizeof *names);
    size_t count = 0;
    FOR_ALL (const effect_line, line, kind->lines, kind->line_count) {
        if (line->kind >= from && line->kind <= to && line->name.text != NULL) {
            names[count++] = line->name.text;
        }
    }
    return source_suggestion(s, typed, names, count);
}

const instance *enter(effect_scope *w, const instance *in)
{
    const instance *before = w->within;
    w->within = in;
    w->b->s->used_by = in == NULL ? NULL : &in->shown;
    return before;
}

const char *whole_name(const effect_scope *w, const char *called)
{
    return w->within == NULL ? called : arena_format(w->b->s->memory, "%s.%s", w->within->use->name.text, called);
}

value evaluate(effect_scope *w, const instance *in, const formula *f, const char *called)
{
    if (w->depth >= DEEPEST_EFFECT) {
        return REFUSED(w->b->s, f->at, "more than %d formulas that need one another", DEEPEST_EFFECT);
    }
    const instance *before = enter(w, in);
    const call_frame *frame = w->frame;
    w->frame = NULL;
    w->path[w->depth++] = called;
    const value found = value_any(&w->b->values, f);
    w->depth--;
    w->frame = frame;
    enter(w, before);
    return found;
}

value refuse_loop(effect_scope *w, place at, const char *called)
{
    int from = w->depth - 1;
    while (from > 0 && strcmp(w->path[from], called) != 0) {
        from--;
    }
    const char *path = called;
    for (int i = from + 1; i < w->depth; i++) {
        path = arena_format(w->b->s->memory, "%s, %s", path, w->path[i]);
    }
    return REFUSED(w->b->s, at, "an algebraic loop: %s, %s; a state, a memory or previous(x, START) breaks it", path,
                   called);
}

int segment_of(effect_scope *w, name n)
{
    const effect_line *line = w->within == NULL ? NULL : line_called(w->within->kind, n.text, false);
    if (w->within == NULL) {
        const int found = segment_called(&w->b->mechanism, n);
        return found >= 0 ? found : coordinate_of(w->b, n);
    }
    if (line == NULL || line->kind != EFFECT_JOINT) {
        source_problem(w->b->s, n.at, "'%s' is no joint of this effect: write 'joint %s' in it", n.text, n.text);
        return -1;
    }
    return w->within->bound[line - w->within->kind->lines].segment;
}

bool find_point(effect_scope *w, const char *called, int *which, vector *point)
{
    const scene *written = w->b->written;
    *point = vector_zero(w->b->g);
    *which = -1;
    if (w->within != NULL) {
        const effect_line *line = line_called(w->within->kind, called, false);
        const bool is = line != NULL && line->kind == EFFECT_BODY;
        if (is) {
            *which = w->within->bound[line - w->within->kind->lines].body;
            *point = w->within->bound[line - w->within->kind->lines].point;
        }
        return is;
    }
    const int own = INDEX_OF(written->bodies, called), frame = INDEX_OF(written->frames, called);
    *which = frame >= 0 ? (int)written->bodies.count + frame : own;
    return *which >= 0;
}
