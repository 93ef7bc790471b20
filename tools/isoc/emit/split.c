#include "tools/isoc/emit/code.h"

#include <string.h>

typedef struct splitter {
    const code_pieces *from;
    arena *memory;
    int most;
    int *last;                   /* [pieces] the last part that reads it */
    int *slots;                  /* [pieces] of it in v[]; a sine has its cosine behind it */
    int *free[2], free_count[2]; /* slots that are read no more, of one real and of two */
    int carried;
} splitter;

static int part_of(const splitter *s, size_t piece)
{
    return (int)piece / s->most;
}

/* A slot that is free, or one more. */
static int take_slot(splitter *s, bool is_turn)
{
    if (s->free_count[is_turn] > 0) {
        return s->free[is_turn][--s->free_count[is_turn]];
    }
    s->carried += is_turn ? 2 : 1;
    return s->carried - (is_turn ? 2 : 1);
}

/* The declarations of the values that a part reads: from arrays, and from parts before, whose slots are then free if no
 * later part reads them. */
static void declare(splitter *s, size_t begin, size_t end, code_part *part, text *out)
{
    const code_pieces *p = s->from;
    bool *is_declared = arena_take(s->memory, p->g->count, sizeof *is_declared);
    bool *is_loaded = arena_take(s->memory, p->count, sizeof *is_loaded);
    for (size_t i = begin; i < end; i++) {
        for (size_t n = 0; n < p->all[i].leaf_count; n++) {
            const node read = p->all[i].leaves[n];
            part->reads[p->g->nodes[read].op] = true;
            if (!is_declared[read] && p->leaves[read] != NULL) {
                text_add(out, "%s", p->leaves[read]);
            }
            is_declared[read] = true;
        }
    }
    for (size_t i = begin; i < end; i++) {
        for (size_t n = 0; n < p->all[i].read_count; n++) {
            const size_t read = p->all[i].reads[n];
            const code_piece *c = &p->all[read];
            const int at = s->slots[read];
            if (read >= begin || is_loaded[read]) {
                continue;
            }
            is_loaded[read] = part->carries = true;
            if (c->is_turn) {
                text_add(out, "    const iso_sine_cosine %s = {v[%d], v[%d]};\n", c->declares, at, at + 1);
            } else {
                text_add(out, "    const real %s = v[%d];\n", c->declares, at);
            }
            if (s->last[read] == part_of(s, begin)) {
                s->free[c->is_turn][s->free_count[c->is_turn]++] = at;
            }
        }
    }
    arena_return(s->memory, is_declared, p->g->count, sizeof *is_declared);
    arena_return(s->memory, is_loaded, p->count, sizeof *is_loaded);
}

/* The values of this part that later ones read. */
static void carry(splitter *s, size_t begin, size_t end, code_part *part, text *out)
{
    for (size_t i = begin; i < end; i++) {
        const code_piece *c = &s->from->all[i];
        if (s->last[i] > part_of(s, i)) {
            const int at = s->slots[i] = take_slot(s, c->is_turn);
            part->carries = true;
            if (c->is_turn) {
                text_add(out, "    v[%d] = %s.sin;\n    v[%d] = %s.cos;\n", at, c->declares, at + 1, c->declares);
            } else {
                text_add(out, "    v[%d] = %s;\n", at, c->declares);
            }
        }
    }
}

static code_part part_between(splitter *s, size_t begin, size_t end)
{
    const code_pieces *p = s->from;
    const size_t first = begin == 0 ? strlen("{\n") : p->all[begin - 1].end;
    code_part part = {.body = NULL};
    text result = {.memory = s->memory};
    declare(s, begin, end, &part, &result);
    text_add(&result, "%.*s", (int)(p->all[end - 1].end - first), p->text.bytes + first);
    carry(s, begin, end, &part, &result);
    part.body = result.bytes;
    return part;
}

code_parts code_split(const code_pieces *pieces, int most)
{
    const size_t count = pieces->count;
    arena *memory = pieces->g->memory;
    splitter s = {.from = pieces, .memory = memory, .most = most};
    code_parts result = {.all = arena_take(memory, count / (size_t)most + 1, sizeof *result.all)};
    s.last = arena_take(memory, count, sizeof *s.last);
    s.slots = arena_take(memory, count, sizeof *s.slots);
    s.free[false] = arena_take(memory, count, sizeof *s.free[false]);
    s.free[true] = arena_take(memory, count, sizeof *s.free[true]);
    for (size_t i = 0; i < count; i++) {
        for (size_t n = 0; n < pieces->all[i].read_count; n++) {
            s.last[pieces->all[i].reads[n]] = part_of(&s, i);
        }
    }
    for (size_t begin = 0; begin < count; begin += (size_t)most) {
        const size_t end = begin + (size_t)most < count ? begin + (size_t)most : count;
        result.all[result.count++] = part_between(&s, begin, end);
    }
    result.carried = s.carried;
    return result;
}
