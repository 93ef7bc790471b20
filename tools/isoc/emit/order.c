/* An order of statements that keeps few values alive at a time, so that few of them go to the stack and back: of those
 * that can come next, the one that ends more lives of values than it begins; of several the first one as written. A
 * list schedule by register pressure: Goodman and Hsu (1988), "Code scheduling and register allocation in large basic
 * blocks", ICS '88. */
#include "tools/isoc/emit/code.h"

typedef struct schedule {
    const code_pieces *from;
    int *readers;     /* [pieces] how many read it that do not stand yet */
    bool *is_written; /* [pieces] */
    text out;
} schedule;

/* Whether a piece reads a quantity for the first time: an expression may have it twice. */
static bool is_first(const code_piece *c, size_t n)
{
    bool result = true;
    for (size_t i = 0; i < n; i++) {
        result = result && c->reads[i] != c->reads[n];
    }
    return result;
}

static void write_piece(schedule *s, size_t i)
{
    const code_piece *c = &s->from->all[i];
    text_add(&s->out, "%.*s", (int)(c->end - c->body), s->from->text.bytes + c->body);
    s->is_written[i] = true;
    for (size_t n = 0; n < c->read_count; n++) {
        s->readers[c->reads[n]] -= is_first(c, n);
    }
}

static bool is_ready(const schedule *s, size_t i)
{
    bool result = !s->is_written[i];
    for (size_t n = 0; n < s->from->all[i].read_count && result; n++) {
        result = s->is_written[s->from->all[i].reads[n]];
    }
    return result;
}

/* Values alive behind a piece less those before it. Sines and cosines stand in memory. */
static int growth_by(const schedule *s, size_t i)
{
    const code_piece *c = &s->from->all[i];
    int result = c->declares != NULL;
    for (size_t n = 0; n < c->read_count; n++) {
        result -= is_first(c, n) && s->readers[c->reads[n]] == 1 && !s->from->all[c->reads[n]].is_turn;
    }
    return result;
}

/* The piece to come next; behind the last there is none. */
static size_t next_piece(const schedule *s)
{
    const size_t count = s->from->count;
    size_t best = count;
    int least = 0;
    for (size_t i = 0; i < count; i++) {
        if (is_ready(s, i) && (best == count || growth_by(s, i) < least)) {
            best = i;
            least = growth_by(s, i);
        }
    }
    return best;
}

static void write_leaves(schedule *s)
{
    const graph *g = s->from->g;
    for (operation op = 0; op < OPERATIONS; op++) {
        for (size_t i = 0; i < g->count; i++) {
            if (g->nodes[i].op == op && s->from->leaves[i] != NULL) {
                text_add(&s->out, "%s", s->from->leaves[i]);
            }
        }
    }
    text_add(&s->out, "\n");
}

const char *code_in_order(const code_pieces *pieces)
{
    arena *memory = pieces->g->memory;
    const size_t count = pieces->count;
    schedule s = {.from = pieces, .out = {.memory = memory}};
    s.readers = arena_take(memory, count, sizeof *s.readers);
    s.is_written = arena_take(memory, count, sizeof *s.is_written);
    for (size_t i = 0; i < count; i++) {
        for (size_t n = 0; n < pieces->all[i].read_count; n++) {
            s.readers[pieces->all[i].reads[n]] += is_first(&pieces->all[i], n);
        }
    }
    write_leaves(&s);
    for (size_t i = 0; i < count; i++) {
        if (pieces->all[i].is_turn && is_ready(&s, i)) {
            write_piece(&s, i);
        }
    }
    for (size_t next; (next = next_piece(&s)) < count;) {
        write_piece(&s, next);
    }
    return s.out.bytes;
}
