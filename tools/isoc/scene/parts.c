/* Parts: an effect in an effect. Each use of a definition makes uses of its parts, which follow it; their operands have
 * the names of that definition. So a part has states, outputs, faults and a price as any other effect. */
#include "tools/isoc/scene/parser.h"

typedef LIST_OF(effect_use) use_list;

/* arm has drive, drive has gear, gear has arm */
static const char *path_of(arena *memory, const use_list *all, const effect_use *part)
{
    const char *path = "", *inner = part->kind.text;
    int i = part->outer;
    do {
        path = arena_format(memory, "%s has %s%s%s", all->all[i].kind.text, inner, path[0] == '\0' ? "" : ", ", path);
        inner = all->all[i].kind.text;
        i = all->all[i].outer;
    } while (!name_is(part->kind, inner));
    return path;
}

/* Notes a part that has itself as a part. */
static bool recurs(source *s, const use_list *all, const effect_use *part)
{
    for (int i = part->outer; i >= 0; i = all->all[i].outer) {
        if (name_is(part->kind, all->all[i].kind.text)) {
            source_problem(s, part->kind.at, "an effect cannot be a part of itself: %s", path_of(s->memory, all, part));
            return true;
        }
    }
    return false;
}

/* The use of a part of this use, as it is written. */
static effect_use part_of(arena *memory, const effect_use *use, int outer, const effect_use *written)
{
    effect_use part = *written;
    part.outer = outer;
    part.used_at = use->used_at;
    part.is_trial = use->is_trial;
    part.name.text = arena_format(memory, "%s.%s", use->name.text, written->name.text);
    part.symbol = arena_format(memory, "%s_%s", use->symbol, written->name.text);
    part.substeps = written->substeps == NULL ? use->substeps : written->substeps;
    return part;
}

/* A use, and behind it those of its parts. */
static void add_use(source *s, const scene *written, use_list *to, effect_use use)
{
    enum { MOST_USES = 65535 };
    const effect_kind *kind = use.kind.text == NULL ? NULL : find_effect_kind(written, use.kind);
    const int at = (int)to->count;
    LIST_ADD(s->memory, *to, use);
    for (size_t i = 0; kind != NULL && use.name.text != NULL && i < kind->line_count; i++) {
        const effect_use *part = kind->lines[i].part;
        if (part == NULL || part->name.text == NULL || part->kind.text == NULL) {
            continue;
        }
        const effect_use inner = part_of(s->memory, &use, at, part);
        if (to->count >= MOST_USES) {
            source_problem(s, use.used_at, "too many effects with all their parts: at most %d", MOST_USES);
            return;
        }
        if (!recurs(s, to, &inner)) {
            add_use(s, written, to, inner);
        }
    }
}

void expand_parts(source *s, scene *written)
{
    use_list all = {0};
    FOR_EACH (const effect_use, use, written->effects) {
        add_use(s, written, &all, *use);
    }
    written->effects.all = all.all;
    written->effects.count = all.count;
    written->effects.room = all.room;
}

bool is_within_use(const scene *written, int use, int outer)
{
    while (use >= 0 && use != outer) {
        use = written->effects.all[use].outer;
    }
    return use >= 0;
}

const quantity *operand_in_scene(const scene *written, const effect_use *use, const char *called)
{
    const quantity *found = operand_called(use, called);
    while (found != NULL && use->outer >= 0 && found->value != NULL && found->value->kind == FORMULA_NAME) {
        use = &written->effects.all[use->outer];
        found = operand_called(use, found->value->name);
    }
    return use->outer < 0 ? found : NULL;
}
