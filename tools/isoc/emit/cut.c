#include "tools/isoc/emit/code.h"

#include <string.h>

typedef struct cutter {
    const code_pieces *from;
    arena *memory;
    bool *is_of_states; /* [pieces] */
    bool *is_read[2];   /* [pieces] of these by the rest, and by others of these */
    const bool *turned; /* [states] */
    int *slots;         /* [pieces] of it in s[], or -1; a sine has its cosine behind it */
    int count;
} cutter;

/* Whether a piece declares a value that follows from the states and from such pieces alone. */
static bool follows_from_states(const cutter *s, const code_piece *c)
{
    bool result = c->declares != NULL;
    for (size_t i = 0; i < c->leaf_count; i++) {
        const operation op = s->from->g->nodes[c->leaves[i]].op;
        result = result && (op == OP_STATE || op == OP_CONSTANT);
    }
    for (size_t i = 0; i < c->read_count; i++) {
        result = result && s->is_of_states[c->reads[i]];
    }
    return result;
}

/* Whether a piece is a sine and cosine that both bodies are given. */
static bool is_given(const code_piece *c)
{
    return c->is_turn && c->read_count + c->leaf_count == 0;
}

/* The state of which a piece has sine and cosine, where they are asked for; else -1. */
static int turned_state(const cutter *s, const code_piece *c)
{
    const graph_node *angle = &s->from->g->nodes[c->angle];
    const bool keeps = c->is_turn && !is_given(c) && angle->op == OP_STATE && s->turned[angle->index];
    return keeps ? angle->index : -1;
}

/* The values of the states' pieces that the rest reads stand in s[]. */
static void find_slots(cutter *s)
{
    const code_pieces *p = s->from;
    for (size_t i = 0; i < p->count; i++) {
        s->is_of_states[i] = follows_from_states(s, &p->all[i]);
        s->slots[i] = turned_state(s, &p->all[i]) >= 0 ? 0 : -1;
        for (size_t n = 0; n < p->all[i].read_count; n++) {
            const size_t read = p->all[i].reads[n];
            s->is_read[s->is_of_states[i]][read] = s->is_of_states[read];
            if (!s->is_of_states[i]) {
                s->slots[read] = s->is_of_states[read] && !is_given(&p->all[read]) ? 0 : -1;
            }
        }
    }
    for (size_t i = 0; i < p->count; i++) {
        if (s->slots[i] == 0) {
            s->slots[i] = s->count;
            s->count += p->all[i].is_turn ? 2 : 1;
        }
    }
}

/* The declarations of the leaves that one of the bodies reads from arrays. */
static void declare_read(const cutter *s, bool of_states, text *out)
{
    const code_pieces *p = s->from;
    bool *is_read = arena_take(s->memory, p->g->count, sizeof *is_read);
    const char *quoted = NULL;
    for (size_t i = 0; i < p->count; i++) {
        for (size_t n = 0; n < p->all[i].leaf_count && s->is_of_states[i] == of_states; n++) {
            is_read[p->all[i].leaves[n]] = true;
        }
    }
    for (operation op = 0; op < OPERATIONS; op++) {
        for (size_t i = 0; i < p->g->count; i++) {
            if (p->g->nodes[i].op == op && is_read[i] && p->leaves[i] != NULL) {
                if (p->quotes[i] != NULL && (quoted == NULL || strcmp(p->quotes[i], quoted) != 0)) {
                    text_add(out, "    /* %s */\n", p->quotes[i]);
                    quoted = p->quotes[i];
                }
                text_add(out, "%s", p->leaves[i]);
            }
        }
    }
    arena_return(s->memory, is_read, p->g->count, sizeof *is_read);
}

/* The statements of one of the bodies, under their headings; those that set targets at the end. */
static void add_statements(const cutter *s, bool of_states, text *out)
{
    const code_pieces *p = s->from;
    int section = -1;
    for (int sets = 0; sets < 2; sets++) {
        text_add(out, "%s", sets && !of_states ? "\n" : "");
        for (size_t i = 0; i < p->count; i++) {
            const code_piece *c = &p->all[i];
            const bool is_here = is_given(c) ? s->is_read[of_states][i] : s->is_of_states[i] == of_states;
            if (!is_here || (c->declares == NULL) != sets) {
                continue;
            }
            if (!sets && c->section != section) {
                section = c->section;
                text_add(out, "\n    /* %s */\n", p->g->sections[section]);
            }
            code_add_piece(p, i, out);
        }
    }
}

/* Fills s[], or declares the values in it. */
static void add_slots(const cutter *s, bool fills, text *out)
{
    for (size_t i = 0; i < s->from->count; i++) {
        const char *name = s->from->all[i].declares;
        const int at = s->slots[i];
        if (at < 0 || !(fills || s->is_read[false][i])) {
            continue;
        }
        const bool is_turn = s->from->all[i].is_turn;
        if (is_turn && fills) {
            text_add(out, "    s[%d] = %s.sin;\n    s[%d] = %s.cos;\n", at, name, at + 1, name);
        } else if (is_turn) {
            text_add(out, "    const iso_sine_cosine %s = {s[%d], s[%d]};\n", name, at, at + 1);
        } else if (fills) {
            text_add(out, "    s[%d] = %s;\n", at, name);
        } else {
            text_add(out, "    const real %s = s[%d];\n", name, at);
        }
    }
}

/* Where the sines and cosines stand that are asked for. */
static int *places_of_turns(const cutter *s, int states)
{
    int *result = arena_take(s->memory, (size_t)states, sizeof *result);
    memset(result, -1, (size_t)states * sizeof *result);
    for (size_t i = 0; i < s->from->count; i++) {
        const int state = turned_state(s, &s->from->all[i]);
        if (state >= 0) {
            result[state] = s->slots[i];
        }
    }
    return result;
}

code_cut code_cut_by_states(const code_pieces *pieces, const bool *turned, int states)
{
    arena *memory = pieces->g->memory;
    cutter s = {.from = pieces, .memory = memory, .turned = turned};
    code_cut result = {.of_states = NULL};
    text of_states = {.memory = memory}, rest = {.memory = memory};
    s.is_of_states = arena_take(memory, pieces->count, sizeof *s.is_of_states);
    s.is_read[false] = arena_take(memory, pieces->count, sizeof *s.is_read[false]);
    s.is_read[true] = arena_take(memory, pieces->count, sizeof *s.is_read[true]);
    s.slots = arena_take(memory, pieces->count, sizeof *s.slots);
    find_slots(&s);
    declare_read(&s, true, &of_states);
    add_statements(&s, true, &of_states);
    text_add(&of_states, "\n");
    add_slots(&s, true, &of_states);
    declare_read(&s, false, &rest);
    add_slots(&s, false, &rest);
    add_statements(&s, false, &rest);
    for (size_t i = 0; i < pieces->count; i++) {
        result.statements += s.is_of_states[i];
    }
    result.of_states = of_states.bytes;
    result.rest = rest.bytes;
    result.count = s.count;
    result.turns = places_of_turns(&s, states);
    return result;
}
