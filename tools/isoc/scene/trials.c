/* --check: definitions of effects without a scene. Each gets a body on a joint, an input for each signal, and 1 for
 * each value, in the units that it declares. */
#include <string.h>

#include "tools/isoc/scene/parser.h"

/* The unit of an operand: its own, or that of a quantity of the joint. */
static const char *unit_of_operand(source *s, const effect_line *line, bool slides)
{
    static const struct {
        const char *word, *of_turn, *of_slide;
    } rows[] = {{"effort", "N*m", "N"},
                {"speed", "rad/s", "m/s"},
                {"position", "rad", "m"},
                {"stiffness", "N*m/rad", "N/m"},
                {"damping", "N*m*s/rad", "N*s/m"}};
    for (size_t i = 0; i < COUNT_OF(rows); i++) {
        if (name_is(line->like, rows[i].word)) {
            return slides ? rows[i].of_slide : rows[i].of_turn;
        }
    }
    return line->has_unit ? dimension_unit(s->memory, line->unit.dim) : "1";
}

/* An operand of trial i, which is value `number` if it is one, and in *more the statement of its input. */
static const char *operand_of_trial(source *s, const effect_line *line, int i, int number, bool slides,
                                    const char **more)
{
    const char *in = unit_of_operand(s, line, slides), *called = line->name.text;
    const bool is_plain = strcmp(in, "1") == 0;
    *more = "";
    if (line->kind == EFFECT_JOINT || line->kind == EFFECT_BODY) {
        return arena_format(s->memory, "%s trial_%s_%d; ", called, line->kind == EFFECT_JOINT ? "joint" : "body", i);
    }
    if (line->value != NULL) {
        return "";
    }
    if (line->kind == EFFECT_VALUE) {
        return arena_format(s->memory, "%s %d%s%s; ", called, number, is_plain ? "" : " ", is_plain ? "" : in);
    }
    *more = arena_format(s->memory, "input trial_%d_%s %s\n", i, called, in);
    return arena_format(s->memory, "%s trial_%d_%s; ", called, i, called);
}

const char *trial_statements(source *s, const scene *written, const char *joints)
{
    const bool slides = strcmp(joints, "prismatic") == 0;
    const char *all = written->step == NULL ? "step 1 ms\n" : "";
    for (int i = 0; i < (int)written->effect_kinds.count; i++) {
        const effect_kind *kind = &written->effect_kinds.all[i];
        const char *operands = "";
        int values = 0;
        FOR_ALL (const effect_line, line, kind->lines, kind->line_count) {
            const char *more = "";
            values += line->kind == EFFECT_VALUE;
            if (line->kind <= EFFECT_VALUE && line->name.text != NULL) {
                operands =
                    arena_format(s->memory, "%s%s", operands, operand_of_trial(s, line, i, values, slides, &more));
            }
            all = arena_format(s->memory, "%s%s", all, more);
        }
        all = arena_format(s->memory,
                           "%sbody trial_body_%d { box (1, 1, 1) m of 1 kg }\njoint trial_joint_%d %s { parent ground; "
                           "child trial_body_%d; axis z }\noutput trial_%d = position of trial_joint_%d\n"
                           "effect %s_alone %s { %s}\n",
                           all, i, i, joints, i, i, i, kind->name.text, kind->name.text, operands);
    }
    return all;
}
