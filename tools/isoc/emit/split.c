#include <string.h>

#include "tools/isoc/emit/code.h"

typedef struct splitter {
    const code_pieces *from;
    arena *memory;
    size_t *begins;              /* [parts + 1] their first pieces, and the end of the last */
    int count;                   /* of the parts */
    int *part;                   /* [pieces] in which it stands */
    int *last;                   /* [pieces] the last part that reads it */
    int *slots;                  /* [pieces] of it in v[]; a sine has its cosine behind it */
    int *free[2], free_count[2]; /* slots that are read no more, of one real and of two */
    int carried;
    int *leaf_in, *value_in; /* [nodes], [pieces] the last part in which a leaf or a value is read, from 1 */
} splitter;

/* Whether the part is the first to read a leaf that stands in an array, or a value of an earlier part; from here on it
 * is not. */
static bool loads_leaf(splitter *s, int part, node leaf)
{
    const bool result = s->leaf_in[leaf] != part + 1 && s->from->leaves[leaf] != NULL;
    s->leaf_in[leaf] = part + 1;
    return result;
}

static bool loads_value(splitter *s, int part, size_t piece)
{
    const bool result = piece < s->begins[part] && s->value_in[piece] != part + 1;
    s->value_in[piece] = part + 1;
    return result;
}

static int count_loads(splitter *s, int part, size_t i)
{
    const code_piece *c = &s->from->all[i];
    int result = 0;
    for (size_t n = 0; n < c->leaf_count; n++) {
        result += loads_leaf(s, part, c->leaves[n]);
    }
    for (size_t n = 0; n < c->read_count; n++) {
        result += loads_value(s, part, c->reads[n]);
    }
    return result;
}

/* Begins a part where the one before would have more than `most` statements and loads. */
static void find_parts(splitter *s, int most)
{
    const code_pieces *p = s->from;
    int size = 0;
    s->count = 1;
    for (size_t i = 0; i < p->count; i++) {
        size += 1 + count_loads(s, s->count - 1, i);
        if (size > most && i > s->begins[s->count - 1]) {
            s->begins[s->count++] = i;
            size = 1 + count_loads(s, s->count - 1, i);
        }
        s->part[i] = s->count - 1;
    }
    s->begins[s->count] = p->count;
    memset(s->leaf_in, 0, p->g->count * sizeof *s->leaf_in);
    memset(s->value_in, 0, p->count * sizeof *s->value_in);
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
static void declare(splitter *s, int part, text *out)
{
    const code_pieces *p = s->from;
    const size_t begin = s->begins[part], end = s->begins[part + 1];
    for (size_t i = begin; i < end; i++) {
        for (size_t n = 0; n < p->all[i].leaf_count; n++) {
            const node read = p->all[i].leaves[n];
            text_add(out, "%s", loads_leaf(s, part, read) ? p->leaves[read] : "");
        }
    }
    for (size_t i = begin; i < end; i++) {
        for (size_t n = 0; n < p->all[i].read_count; n++) {
            const size_t read = p->all[i].reads[n];
            const code_piece *c = &p->all[read];
            const int at = s->slots[read];
            if (!loads_value(s, part, read)) {
                continue;
            }
            if (c->is_turn) {
                text_add(out, "    const iso_sine_cosine %s = {v[%d], v[%d]};\n", c->declares, at, at + 1);
            } else {
                text_add(out, "    const real %s = v[%d];\n", c->declares, at);
            }
            if (s->last[read] == part) {
                s->free[c->is_turn][s->free_count[c->is_turn]++] = at;
            }
        }
    }
}

/* The values of this part that later ones read. */
static void carry(splitter *s, int part, text *out)
{
    for (size_t i = s->begins[part]; i < s->begins[part + 1]; i++) {
        const code_piece *c = &s->from->all[i];
        if (s->last[i] > part) {
            const int at = s->slots[i] = take_slot(s, c->is_turn);
            if (c->is_turn) {
                text_add(out, "    v[%d] = %s.sin;\n    v[%d] = %s.cos;\n", at, c->declares, at + 1, c->declares);
            } else {
                text_add(out, "    v[%d] = %s;\n", at, c->declares);
            }
        }
    }
}

static const char *body_of_part(splitter *s, int part)
{
    const code_pieces *p = s->from;
    const size_t begin = s->begins[part], first = begin == 0 ? strlen("{\n") : p->all[begin - 1].end;
    text result = {.memory = s->memory};
    declare(s, part, &result);
    text_add(&result, "%.*s", (int)(p->all[s->begins[part + 1] - 1].end - first), p->text.bytes + first);
    carry(s, part, &result);
    return result.bytes;
}

code_parts code_split(const code_pieces *pieces, int most)
{
    const size_t count = pieces->count;
    arena *memory = pieces->g->memory;
    splitter s = {.from = pieces, .memory = memory};
    s.begins = arena_take(memory, count + 1, sizeof *s.begins);
    s.part = arena_take(memory, count, sizeof *s.part);
    s.last = arena_take(memory, count, sizeof *s.last);
    s.slots = arena_take(memory, count, sizeof *s.slots);
    s.free[false] = arena_take(memory, count, sizeof *s.free[false]);
    s.free[true] = arena_take(memory, count, sizeof *s.free[true]);
    s.leaf_in = arena_take(memory, pieces->g->count, sizeof *s.leaf_in);
    s.value_in = arena_take(memory, count, sizeof *s.value_in);
    find_parts(&s, most);
    for (size_t i = 0; i < count; i++) {
        for (size_t n = 0; n < pieces->all[i].read_count; n++) {
            s.last[pieces->all[i].reads[n]] = s.part[i];
        }
    }
    code_parts result = {.bodies = arena_take(memory, (size_t)s.count, sizeof *result.bodies), .count = s.count};
    for (int i = 0; i < s.count; i++) {
        result.bodies[i] = body_of_part(&s, i);
    }
    result.carried = s.carried;
    return result;
}
