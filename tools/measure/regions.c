/* The edges of the regions of stability of all methods: where growth_of (tools/isoc/method/growth.h), the growth of the
 * kernel's own step, is one. Prints a table: the method, and points of the plane of step times eigenvalue, in pieces of
 * curves that go from point to point. For adams it is that of a sub-step.
 *
 * A rectangle of the upper half plane is divided into squares, whose corners are stable or not; on each side of a
 * square between a stable and an unstable corner the edge is found by halving. Two such sides of a square are
 * neighbours on a curve: Lorensen, Cline (1987), Marching Cubes, SIGGRAPH 21, 163-169, in the plane. The lower half
 * plane is its mirror image. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/methods/all.h"
#include "core/methods/table.h"
#include "tools/isoc/method/growth.h"

enum {
    COLUMNS = 131,
    ROWS = 75,
    CORNERS = COLUMNS * ROWS,
    SIDES = 2 * CORNERS, /* of each corner that to the right, and that upwards */
    HALVINGS = 14,
    NONE = -1,
};

/* The squares; a corner on the real axis is just above it, where a motion still oscillates. */
static const double left = -4.4, above = 1e-4, side = 0.05;

/* The rounding error of a growth of one: the root of that of a number, where two eigenvalues meet. */
static const double rounding = 1e-6;

typedef struct point {
    double re, im;
} point;

typedef struct map {
    unsigned method;
    bool stable[CORNERS];
    point edge[SIDES];
    int next[SIDES][2]; /* sides on the same curve */
    bool drawn[SIDES];
} map;

static bool is_stable(const unsigned method, const point z)
{
    arena *const memory = arena_new();
    const double growth = growth_of(memory, method, z.re, z.im);
    arena_free(memory);
    return growth <= 1.0 + rounding;
}

static point corner(const int at)
{
    return (point){left + side * (at % COLUMNS), above + side * (double)(at / COLUMNS)};
}

static int other_end(const int of_side)
{
    return of_side / 2 + (of_side % 2 == 0 ? 1 : COLUMNS);
}

static bool is_edge(const map *const m, const int of_side)
{
    return m->stable[of_side / 2] != m->stable[other_end(of_side)];
}

static point edge_of(const map *const m, const int of_side)
{
    const bool first = m->stable[of_side / 2];
    point stable = corner(first ? of_side / 2 : other_end(of_side)),
          not_stable = corner(first ? other_end(of_side) : of_side / 2);
    for (int i = 0; i < HALVINGS; i++) {
        const point middle = {0.5 * (stable.re + not_stable.re), 0.5 * (stable.im + not_stable.im)};
        *(is_stable(m->method, middle) ? &stable : &not_stable) = middle;
    }
    return stable;
}

static void join(map *const m, const int a, const int b)
{
    m->next[a][m->next[a][0] != NONE] = b;
    m->next[b][m->next[b][0] != NONE] = a;
}

/* The square whose lower left corner this is: its sides in turn. Where all four have an edge, those at the two stable
 * corners belong together. */
static void join_sides(map *const m, const int at)
{
    const int sides[] = {2 * at, 2 * (at + 1) + 1, 2 * (at + COLUMNS), 2 * at + 1};
    int found[4], count = 0;
    for (int i = 0; i < 4; i++) {
        if (is_edge(m, sides[i])) {
            found[count++] = sides[i];
        }
    }
    if (count == 2) {
        join(m, found[0], found[1]);
    } else if (count == 4) {
        const int first = m->stable[at] ? 3 : 1;
        join(m, sides[0], sides[first]);
        join(m, sides[2], sides[4 - first]);
    }
}

static void fill_map(map *const m, const unsigned method)
{
    memset(m, 0, sizeof *m);
    m->method = method;
    for (int i = 0; i < CORNERS; i++) {
        m->stable[i] = is_stable(method, corner(i));
    }
    for (int i = 0; i < SIDES; i++) {
        m->next[i][0] = m->next[i][1] = NONE;
    }
    for (int row = 0; row + 1 < ROWS; row++) {
        for (int column = 0; column + 1 < COLUMNS; column++) {
            join_sides(m, row * COLUMNS + column);
        }
    }
    for (int i = 0; i < SIDES; i++) {
        if (m->next[i][0] != NONE) {
            m->edge[i] = edge_of(m, i);
        }
    }
}

/* The curve from this side on; returns how many it passes. */
static int follow(map *const m, const int from, int *const along)
{
    int count = 0;
    for (int at = from, before = NONE; at != NONE;) {
        const int onwards = m->next[at][0] != before ? m->next[at][0] : m->next[at][1];
        m->drawn[at] = true;
        along[count++] = at;
        before = at;
        at = onwards != NONE && m->drawn[onwards] ? NONE : onwards;
    }
    return count;
}

/* With its image: where it begins on the real axis, this goes before, and the two are one piece. Returns the next
 * piece. */
static int put_curve(map *const m, const int from, const char *const name, const int piece)
{
    static int along[SIDES];
    const int count = follow(m, from, along), next = piece + (from < 2 * COLUMNS ? 0 : 1);
    for (int i = count - 1; i >= 0; i--) {
        printf("%s\t%.6g\t%.6g\t%d\n", name, m->edge[along[i]].re, -m->edge[along[i]].im, piece);
    }
    for (int i = 0; i < count; i++) {
        printf("%s\t%.6g\t%.6g\t%d\n", name, m->edge[along[i]].re, m->edge[along[i]].im, next);
    }
    return next + 1;
}

/* Curves that begin on the border, first those on the real axis; then closed ones. */
static void put_map(map *const m, const char *const name)
{
    int piece = 1;
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; i < SIDES; i++) {
            if (m->next[i][0] != NONE && !m->drawn[i] && (pass > 0 || m->next[i][1] == NONE)) {
                piece = put_curve(m, i, name, piece);
            }
        }
    }
}

int main(void)
{
    static const char *const names[ISO_METHODS] = ISO_METHOD_NAMES;
    static map m;
    puts("what\tre\tim\tpiece");
    for (unsigned method = 0; method < ISO_METHODS; method++) {
        fill_map(&m, method);
        put_map(&m, names[method]);
    }
    return EXIT_SUCCESS;
}
