/* The loads and stores of values in an order of statements. */
#include <stdint.h>

#include "tools/isoc/emit/code.h"

/* Registers, and of each value the next statement that reads it. A value is a quantity, or behind them a leaf. */
typedef struct registers {
    size_t *held; /* [most] values */
    size_t count, most;
    size_t *next; /* [values] */
    bool *is_held, *is_stored;
    int traffic; /* loads and stores */
} registers;

/* Operand n of a piece, or NONE where nothing stands in an array or a variable. */
static const size_t NONE = SIZE_MAX;

static size_t value_read(const code_pieces *from, const code_piece *c, size_t n)
{
    if (n < c->read_count) {
        return c->reads[n];
    }
    const node leaf = c->leaves[n - c->read_count];
    return from->leaves[leaf] == NULL ? NONE : from->count + (size_t)leaf;
}

/* Puts a value into a register: where none is free, into that whose value is read last (Belady 1966, "A study of
 * replacement algorithms for a virtual-storage computer", IBM Syst. J. 5, 78-101). */
static void hold(registers *r, size_t value)
{
    size_t place = r->count;
    if (r->count == r->most) {
        place = 0;
        for (size_t i = 1; i < r->count; i++) {
            place = r->next[r->held[i]] > r->next[r->held[place]] ? i : place;
        }
        const size_t out = r->held[place];
        r->traffic += !r->is_stored[out] && r->next[out] != NONE;
        r->is_stored[out] = true;
        r->is_held[out] = false;
    } else {
        r->count++;
    }
    r->held[place] = value;
    r->is_held[value] = true;
}

static void drop_dead(registers *r)
{
    for (size_t i = r->count; i-- > 0;) {
        if (r->next[r->held[i]] == NONE) {
            r->is_held[r->held[i]] = false;
            r->held[i] = r->held[--r->count];
        }
    }
}

/* later[]: for each operand of each statement, in their order, and then for the value that it declares, the next
 * statement that reads it. */
static size_t *next_reads(const code_pieces *from, const size_t *order, size_t *next, size_t values)
{
    size_t total = 0;
    for (size_t i = 0; i < from->count; i++) {
        total += from->all[i].read_count + from->all[i].leaf_count + 1;
    }
    size_t *later = arena_take(from->g->memory, total, sizeof *later);
    for (size_t v = 0; v < values; v++) {
        next[v] = NONE;
    }
    for (size_t t = from->count; t-- > 0;) {
        const code_piece *c = &from->all[order[t]];
        later[--total] = next[order[t]];
        for (size_t n = c->read_count + c->leaf_count; n-- > 0;) {
            const size_t value = value_read(from, c, n);
            later[--total] = value == NONE ? NONE : next[value];
            if (value != NONE) {
                next[value] = t;
            }
        }
    }
    return later;
}

int code_traffic(const code_pieces *from, const size_t *order, size_t most)
{
    arena *memory = from->g->memory;
    const size_t values = from->count + from->g->count;
    registers r = {arena_take(memory, most, sizeof *r.held),
                   0,
                   most,
                   arena_take(memory, values, sizeof *r.next),
                   arena_take(memory, values, sizeof *r.is_held),
                   arena_take(memory, values, sizeof *r.is_stored),
                   0};
    const size_t *later = next_reads(from, order, r.next, values);
    for (size_t v = 0; v < values; v++) {
        r.is_stored[v] = v >= from->count || from->all[v].is_turn;
    }
    for (size_t t = 0; t < from->count; t++) {
        const code_piece *c = &from->all[order[t]];
        for (size_t n = 0; n < c->read_count + c->leaf_count; n++, later++) {
            const size_t value = value_read(from, c, n);
            if (value != NONE && !c->is_turn && !r.is_held[value]) {
                r.traffic++;
                hold(&r, value);
            }
            if (value != NONE) {
                r.next[value] = *later;
            }
        }
        drop_dead(&r);
        r.next[order[t]] = *later++;
        if (c->declares != NULL && !c->is_turn && r.next[order[t]] != NONE) {
            hold(&r, order[t]);
        }
    }
    return r.traffic;
}
