/* What a definition has, for its reader. */
#include "tools/isoc/effects/effects.h"

static void describe_line(builder *b, const instance *in, const effect_line *line, text *out)
{
    static const char *const words[] = {
        [EFFECT_JOINT] = "joint", [EFFECT_BODY] = "body",   [EFFECT_SIGNAL] = "signal", [EFFECT_VALUE] = "value",
        [EFFECT_FAULT] = "fault", [EFFECT_STATE] = "state", [EFFECT_MEMORY] = "memory", [EFFECT_OUTPUT] = "output",
        [EFFECT_PART] = "part",   [EFFECT_FUNCTION] = NULL,
    };
    const char *word = words[line->kind];
    const bool has_value = line->kind > EFFECT_BODY && line->kind != EFFECT_PART && line->kind != EFFECT_FAULT;
    if (word == NULL || line->name.text == NULL) {
        return;
    }
    if (!has_value) {
        text_add(out, "%s %s%s%s\n", word, line->name.text, line->part == NULL ? "" : " ",
                 line->part == NULL ? "" : line->part->kind.text);
        return;
    }
    const value found = line_value(b->around->context, in, line);
    text_add(out, "%s %s %s%s\n", line->is_mode ? "mode" : word, line->name.text,
             dimension_unit(b->s->memory, found.dim), found.count == 3 ? " vector" : "");
}

void describe_trials(builder *b, text *out)
{
    effect_scope *w = b->around->context;
    FOR_ALL (const instance, in, w->all, b->written->effects.count) {
        if (in->kind == NULL || !in->use->is_trial || in->outer != NULL) {
            continue;
        }
        text_add(out, "effect %s\n", in->kind->name.text);
        for (size_t i = 0; i < in->kind->line_count; i++) {
            describe_line(b, in, &in->kind->lines[i], out);
        }
    }
}
