#include "tests/dynamics/linear.h"

#include <string.h>

/* Entries are of size 1 after scaling. A pivot below this is what rounding leaves of zero, 2^-64 times some growth; it is
 * also how near to a singular configuration a state may be. */
#define RANK_TOLERANCE 1e-13L

/* What is left of the right-hand side where an equation follows from others, relative to the largest. */
#define CONTRADICTION 1e-9L

/* Divides each row by its largest entry, then each column: pivots are chosen among like numbers. */
static void equilibrate(linear_system *const s, wide scale[UNKNOWNS_MAX])
{
    for (int r = 0; r < s->n; r++) {
        wide largest = 0.0L;
        for (int c = 0; c < s->n; c++) {
            largest = fmaxl(largest, fabsl(s->a[r][c]));
        }
        for (int c = 0; c <= s->n && largest > 0.0L; c++) {
            s->a[r][c] /= largest;
        }
    }
    for (int c = 0; c < s->n; c++) {
        scale[c] = 0.0L;
        for (int r = 0; r < s->n; r++) {
            scale[c] = fmaxl(scale[c], fabsl(s->a[r][c]));
        }
        for (int r = 0; r < s->n && scale[c] > 0.0L; r++) {
            s->a[r][c] /= scale[c];
        }
    }
}

static void swap_rows(linear_system *const s, const int a, const int b)
{
    wide kept[UNKNOWNS_MAX + 1];
    memcpy(kept, s->a[a], sizeof kept);
    memcpy(s->a[a], s->a[b], sizeof kept);
    memcpy(s->a[b], kept, sizeof kept);
}

static void swap_columns(linear_system *const s, int order[UNKNOWNS_MAX], const int a, const int b)
{
    for (int r = 0; r < s->n; r++) {
        const wide kept = s->a[r][a];
        s->a[r][a] = s->a[r][b];
        s->a[r][b] = kept;
    }
    const int kept = order[a];
    order[a] = order[b];
    order[b] = kept;
}

/* Moves the largest entry of what is left to [k][k]; false if there is none. */
static bool pivot(linear_system *const s, int order[UNKNOWNS_MAX], const int k)
{
    int row = k;
    int column = k;
    for (int r = k; r < s->n; r++) {
        for (int c = k; c < s->n; c++) {
            if (fabsl(s->a[r][c]) > fabsl(s->a[row][column])) {
                row = r;
                column = c;
            }
        }
    }
    if (fabsl(s->a[row][column]) < RANK_TOLERANCE) {
        return false;
    }
    swap_rows(s, k, row);
    swap_columns(s, order, k, column);
    return true;
}

bool linear_solve(linear_system *const s, wide *const x)
{
    const int n = s->n;
    int order[UNKNOWNS_MAX] = {0};
    wide scale[UNKNOWNS_MAX];
    wide y[UNKNOWNS_MAX];
    int rank = 0;
    wide largest = 0.0L;
    wide left = 0.0L;
    equilibrate(s, scale);
    for (int k = 0; k < n; k++) {
        order[k] = k;
        x[k] = 0.0L;
        largest = fmaxl(largest, fabsl(s->a[k][n]));
    }
    while (rank < n && pivot(s, order, rank)) {
        const wide *const above = s->a[rank];
        for (int r = rank + 1; r < n; r++) {
            const wide factor = s->a[r][rank] / above[rank];
            for (int c = rank; c <= n && factor != 0.0L; c++) {
                s->a[r][c] -= factor * above[c];
            }
        }
        rank++;
    }
    for (int r = rank; r < n; r++) {
        left = fmaxl(left, fabsl(s->a[r][n]));
    }
    for (int k = rank - 1; k >= 0; k--) {
        y[k] = s->a[k][n];
        for (int c = k + 1; c < rank; c++) {
            y[k] -= s->a[k][c] * y[c];
        }
        y[k] /= s->a[k][k];
        x[order[k]] = y[k] / scale[order[k]];
    }
    return left <= CONTRADICTION * largest;
}
