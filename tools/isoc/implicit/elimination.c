#include "tools/isoc/implicit/jacobian.h"

#include <string.h>

enum { WORD = 64 };

pattern pattern_start(arena *memory, int count)
{
    pattern p = {.memory = memory, .count = count, .words = ((size_t)count + WORD - 1) / WORD};
    p.rows = arena_take(memory, (size_t)count * p.words, sizeof *p.rows);
    return p;
}

static uint64_t *row_of(const pattern *p, int row)
{
    return p->rows + (size_t)row * p->words;
}

static bool has(const pattern *p, int row, int column)
{
    return (row_of(p, row)[column / WORD] >> (column % WORD) & 1) != 0;
}

void pattern_add(pattern *p, int row, int column)
{
    row_of(p, row)[column / WORD] |= UINT64_C(1) << (column % WORD);
}

/* The number of these columns that a row has. */
static long columns_in(const pattern *p, int row, const uint64_t *columns)
{
    long count = 0;
    for (size_t word = 0; word < p->words; word++) {
        for (uint64_t bits = row_of(p, row)[word] & columns[word]; bits != 0; bits &= bits - 1) {
            count++;
        }
    }
    return count;
}

/* The number of remaining rows that have this column. */
static long rows_with(const pattern *p, int column, const int *turns)
{
    long count = 0;
    for (int row = 0; row < p->count; row++) {
        count += turns[row] < 0 && has(p, row, column);
    }
    return count;
}

/* The unknown of a group whose elimination changes the fewest places, (rows - 1) (columns - 1); the last of equals.
 * Markowitz (1957), The elimination form of the inverse and its application to linear programming, Management Science
 * 3; of symmetric matrices the minimum degree of Tinney and Walker (1967), Proc. IEEE 55. */
static int cheapest(const pattern *p, const int *groups, int group, const int *turns, const uint64_t *left)
{
    int best = -1;
    long least = 0;
    for (int i = p->count - 1; i >= 0; i--) {
        if (groups[i] == group && turns[i] < 0) {
            const long cost = (rows_with(p, i, turns) - 1) * (columns_in(p, i, left) - 1);
            best = best < 0 || cost < least ? i : best;
            least = best == i ? cost : least;
        }
    }
    return best;
}

/* The rows that are left and have the pivot's column get the columns of its row that are left. */
static void eliminate(pattern *p, int pivot, const int *turns, uint64_t *left)
{
    left[pivot / WORD] &= ~(UINT64_C(1) << (pivot % WORD));
    for (int row = 0; row < p->count; row++) {
        if (turns[row] < 0 && has(p, row, pivot)) {
            for (size_t word = 0; word < p->words; word++) {
                row_of(p, row)[word] |= row_of(p, pivot)[word] & left[word];
            }
        }
    }
}

static void find_order(pattern *p, elimination *e, const int *groups)
{
    uint64_t *left = arena_take(p->memory, p->words, sizeof *left);
    int group = 0;
    memset(left, -1, p->words * sizeof *left);
    memset(e->place, -1, (size_t)p->count * sizeof *e->place);
    for (int i = 0; i < p->count; i++) {
        group = groups[i] > group ? groups[i] : group;
    }
    for (int result = 0; result < p->count; group--) {
        for (int pivot; (pivot = cheapest(p, groups, group, e->place, left)) >= 0; result++) {
            e->order[result] = pivot;
            e->place[pivot] = result;
            eliminate(p, pivot, e->place, left);
        }
    }
}

/* The rows one after the other, each from left to right in the order of the elimination. */
static void make_tables(const pattern *p, elimination *e)
{
    size_t room = 0;
    for (int i = 0; i < p->count; i++) {
        e->row[i] = e->nonzeros;
        for (int j = 0; j < p->count; j++) {
            if (has(p, e->order[i], e->order[j])) {
                ADD_TO(p->memory, e->column, e->nonzeros, room, j);
                e->beyond[i] = j <= i ? e->nonzeros : e->beyond[i];
                e->lower += j < i;
            }
        }
    }
    e->row[p->count] = e->nonzeros;
}

/* Row i less a multiple of row k, for each k that it has before its diagonal. */
static void find_targets(arena *memory, elimination *e)
{
    size_t room = 0;
    for (int i = 0; i < e->count; i++) {
        for (int at = e->row[i]; at + 1 < e->beyond[i]; at++) {
            const int k = e->column[at];
            for (int from = e->beyond[k], to = at; from < e->row[k + 1]; from++) {
                while (e->column[to] != e->column[from]) {
                    to++;
                }
                ADD_TO(memory, e->target, e->products, room, to - e->row[i]);
            }
        }
    }
}

elimination elimination_of(pattern *p, const int *groups)
{
    const size_t count = (size_t)p->count;
    elimination e = {.count = p->count};
    e.order = arena_take(p->memory, count, sizeof *e.order);
    e.place = arena_take(p->memory, count, sizeof *e.place);
    e.row = arena_take(p->memory, count + 1, sizeof *e.row);
    e.beyond = arena_take(p->memory, count, sizeof *e.beyond);
    find_order(p, &e, groups);
    make_tables(p, &e);
    find_targets(p->memory, &e);
    return e;
}

int elimination_index(const elimination *e, int row, int column)
{
    int at = e->row[e->place[row]];
    while (e->column[at] != e->place[column]) {
        at++;
    }
    return at;
}
