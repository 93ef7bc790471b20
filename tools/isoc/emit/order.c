/* An order of statements in which few values go to memory and back. Three orders are tried: as written; by a list
 * schedule from the first statement on, which of those that can come next takes the one that ends more lives of values
 * than it begins (Goodman and Hsu 1988, "Code scheduling and register allocation in large basic blocks", ICS '88); and
 * by the same from the last statement back. The one with the least traffic is kept; of equal ones the first. */
#include <limits.h>

#include "tools/isoc/emit/code.h"

typedef struct schedule {
    const code_pieces *from;
    size_t *order; /* [count] pieces, as they stand in the text */
    size_t count;
    int *readers;     /* [pieces] the number of pieces not yet placed that read it */
    bool *is_written; /* [pieces] */
    size_t *since;    /* [pieces] from the end back: the number from there of the nearest that reads it; 0: none does */
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

static schedule schedule_begin(const code_pieces *from)
{
    arena *memory = from->g->memory;
    const size_t count = from->count;
    const schedule s = {.from = from,
                        .order = arena_take(memory, count, sizeof *s.order),
                        .readers = arena_take(memory, count, sizeof *s.readers),
                        .is_written = arena_take(memory, count, sizeof *s.is_written),
                        .since = arena_take(memory, count, sizeof *s.since)};
    FOR_ALL (const code_piece, c, from->all, count) {
        for (size_t n = 0; n < c->read_count; n++) {
            s.readers[c->reads[n]] += is_first(c, n);
        }
    }
    return s;
}

/* A sine and a cosine that stand in memory. */
static bool stands_in_memory(const code_piece *c)
{
    return c->is_turn && c->read_count == 0;
}

static schedule as_written(const code_pieces *from)
{
    schedule s = schedule_begin(from);
    for (size_t i = 0; i < from->count; i++) {
        s.order[s.count++] = i;
    }
    return s;
}

/* --- from the first statement on --- */

static void append(schedule *s, size_t i)
{
    const code_piece *c = &s->from->all[i];
    s->order[s->count++] = i;
    s->is_written[i] = true;
    for (size_t n = 0; n < c->read_count; n++) {
        s->readers[c->reads[n]] -= is_first(c, n);
    }
}

static bool can_follow(const schedule *s, size_t i)
{
    bool result = !s->is_written[i];
    for (size_t n = 0; n < s->from->all[i].read_count && result; n++) {
        result = s->is_written[s->from->all[i].reads[n]];
    }
    return result;
}

/* Values alive behind a piece less those before it. Sines and cosines stand in memory. */
static int growth_behind(const schedule *s, size_t i)
{
    const code_piece *c = &s->from->all[i];
    int result = c->declares != NULL;
    for (size_t n = 0; n < c->read_count; n++) {
        result -= is_first(c, n) && s->readers[c->reads[n]] == 1 && !s->from->all[c->reads[n]].is_turn;
    }
    return result;
}

static schedule from_the_first_on(const code_pieces *from)
{
    schedule s = schedule_begin(from);
    for (size_t i = 0; i < from->count; i++) {
        if (from->all[i].is_turn && can_follow(&s, i)) {
            append(&s, i);
        }
    }
    for (size_t begin = 0; s.count < from->count;) {
        size_t best = from->count;
        int least = INT_MAX;
        while (s.is_written[begin]) {
            begin++;
        }
        for (size_t i = begin; i < from->count; i++) {
            const int growth = can_follow(&s, i) ? growth_behind(&s, i) : INT_MAX;
            if (growth < least) {
                best = i;
                least = growth;
            }
        }
        append(&s, best);
    }
    return s;
}

/* --- from the last statement back --- */

static void prepend(schedule *s, size_t i)
{
    const code_piece *c = &s->from->all[i];
    s->count++;
    s->order[s->from->count - s->count] = i;
    s->is_written[i] = true;
    for (size_t n = 0; n < c->read_count; n++) {
        if (is_first(c, n)) {
            s->readers[c->reads[n]]--;
            s->since[c->reads[n]] = s->count;
        }
    }
}

static bool can_precede(const schedule *s, size_t i)
{
    return !s->is_written[i] && s->readers[i] == 0 && !stands_in_memory(&s->from->all[i]);
}

/* Values alive before a piece less those behind it. */
static int growth_before(const schedule *s, size_t i)
{
    const code_piece *c = &s->from->all[i];
    int result = -(c->declares != NULL);
    for (size_t n = 0; n < c->read_count; n++) {
        result += is_first(c, n) && s->since[c->reads[n]] == 0 && !s->from->all[c->reads[n]].is_turn;
    }
    return result;
}

static schedule from_the_last_back(const code_pieces *from)
{
    schedule s = schedule_begin(from);
    size_t standing = 0;
    for (size_t i = 0; i < from->count; i++) {
        standing += stands_in_memory(&from->all[i]);
    }
    for (size_t end = from->count; s.count + standing < from->count;) {
        size_t best = from->count;
        int least = INT_MAX;
        while (s.is_written[end - 1]) {
            end--;
        }
        for (size_t i = end; i-- > 0;) {
            const int growth = can_precede(&s, i) ? growth_before(&s, i) : INT_MAX;
            /* Of two that let as many values live, the one that was read last. */
            if (growth < least || (growth == least && best < from->count && s.since[i] > s.since[best])) {
                best = i;
                least = growth;
            }
        }
        prepend(&s, best);
    }
    for (size_t i = from->count; i-- > 0;) {
        if (stands_in_memory(&from->all[i])) {
            prepend(&s, i);
        }
    }
    return s;
}

/* --- values of arrays --- */

/* The leaf to which a piece sets a target, and does nothing else; -1 for any other piece. */
static node leaf_copied(const code_piece *c)
{
    return c->declares == NULL && c->read_count == 0 && c->leaf_count == 1 ? c->leaves[0] : -1;
}

/* For each leaf, whether a piece reads it that does more than copy it. */
static bool *find_used_leaves(const code_pieces *from)
{
    bool *is_used = arena_take(from->g->memory, from->g->count, sizeof *is_used);
    for (size_t i = 0; i < from->count; i++) {
        for (size_t n = 0; n < from->all[i].leaf_count && leaf_copied(&from->all[i]) < 0; n++) {
            is_used[from->all[i].leaves[n]] = true;
        }
    }
    return is_used;
}

/* The pieces that copy a leaf, as lists: one more than the first of each leaf, and than the next of a piece; 0: none.
 */
typedef struct copies {
    size_t *first, *next; /* [nodes], [pieces] */
} copies;

static copies find_copies(const code_pieces *from)
{
    arena *memory = from->g->memory;
    const copies result = {arena_take(memory, from->g->count, sizeof *result.first),
                           arena_take(memory, from->count, sizeof *result.next)};
    for (size_t i = from->count; i-- > 0;) {
        const node leaf = leaf_copied(&from->all[i]);
        if (leaf >= 0) {
            result.next[i] = result.first[leaf];
            result.first[leaf] = i + 1;
        }
    }
    return result;
}

/* The copies of the leaves that this piece is the first to read. */
static void append_copies(schedule *s, const code_piece *c, copies lists)
{
    for (size_t n = 0; n < c->leaf_count; n++) {
        for (size_t *copy = &lists.first[c->leaves[n]]; *copy > 0; *copy = lists.next[*copy - 1]) {
            if (!s->is_written[*copy - 1]) {
                append(s, *copy - 1);
            }
        }
    }
}

/* The same order where each value of an array is read, and copied, only before the first statement that needs it: read
 * at once, those of a long function would go to the stack. */
static schedule with_late_reads(const schedule *early)
{
    const code_pieces *from = early->from;
    const bool *is_used = find_used_leaves(from);
    const copies lists = find_copies(from);
    schedule s = schedule_begin(from);
    for (size_t t = 0; t < from->count; t++) {
        const size_t i = early->order[t];
        const code_piece *c = &from->all[i];
        if (stands_in_memory(c) || (leaf_copied(c) >= 0 && is_used[leaf_copied(c)])) {
            continue;
        }
        for (size_t n = 0; n < c->read_count; n++) {
            if (stands_in_memory(&from->all[c->reads[n]]) && !s.is_written[c->reads[n]]) {
                append_copies(&s, &from->all[c->reads[n]], lists);
                append(&s, c->reads[n]);
            }
        }
        append_copies(&s, c, lists);
        if (!s.is_written[i]) {
            append(&s, i);
        }
    }
    return s;
}

/* --- the text --- */

/* Writes a piece, with the declarations of the leaves that no piece before reads. */
static void write_piece(const code_pieces *from, size_t i, bool *is_declared, text *out)
{
    const code_piece *c = &from->all[i];
    for (size_t n = 0; n < c->leaf_count; n++) {
        const node leaf = c->leaves[n];
        text_add(out, "%s", is_declared[leaf] || from->leaves[leaf] == NULL ? "" : from->leaves[leaf]);
        is_declared[leaf] = true;
    }
    code_add_piece(from, i, out);
}

const char *code_in_order(const code_pieces *pieces)
{
    /* The registers that the code of a plant leaves free, of the 16 of an x86-64 and of the 32 of a Cortex-M4F. */
    static const size_t few = 13, many = 26;
    const schedule early[] = {as_written(pieces), from_the_first_on(pieces), from_the_last_back(pieces)};
    const schedule tried[] = {with_late_reads(&early[0]), with_late_reads(&early[1]), with_late_reads(&early[2])};
    const schedule *best = tried;
    int least = INT_MAX;
    for (size_t i = 0; i < COUNT_OF(tried); i++) {
        const int both = code_traffic(pieces, tried[i].order, few) + code_traffic(pieces, tried[i].order, many);
        best = both < least ? &tried[i] : best;
        least = both < least ? both : least;
    }
    text out = {.memory = pieces->g->memory};
    bool *is_declared = arena_take(pieces->g->memory, pieces->g->count, sizeof *is_declared);
    for (size_t i = 0; i < pieces->count; i++) {
        write_piece(pieces, best->order[i], is_declared, &out);
    }
    return out.bytes;
}
