#include "tests/isoc/dynamics/linear.h"

#include <string.h>

/* What is left of the right-hand side where an equation follows from others, relative to the largest. */
#define CONTRADICTION 1e-7L

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

/* What is left to eliminate: rows and columns from k on. */
typedef struct elimination {
    linear_system *s;
    int k;
    int unknown[UNKNOWNS_MAX]; /* the one of each column */
    int largest[UNKNOWNS_MAX]; /* the column of each row's largest entry of those left */
} elimination;

static void find_largest(elimination *const e, const int row)
{
    const wide *const a = e->s->a[row];
    int largest = e->k;
    for (int c = e->k + 1; c < e->s->n; c++) {
        largest = fabsl(a[c]) > fabsl(a[largest]) ? c : largest;
    }
    e->largest[row] = largest;
}

static void swap_rows(elimination *const e, const int a, const int b)
{
    wide kept[UNKNOWNS_MAX + 1];
    const int largest = e->largest[a];
    memcpy(kept, e->s->a[a], sizeof kept);
    memcpy(e->s->a[a], e->s->a[b], sizeof kept);
    memcpy(e->s->a[b], kept, sizeof kept);
    e->largest[a] = e->largest[b];
    e->largest[b] = largest;
}

static void swap_columns(elimination *const e, const int a, const int b)
{
    const int unknown = e->unknown[a];
    e->unknown[a] = e->unknown[b];
    e->unknown[b] = unknown;
    for (int r = 0; r < e->s->n; r++) {
        const wide kept = e->s->a[r][a];
        e->s->a[r][a] = e->s->a[r][b];
        e->s->a[r][b] = kept;
        const int at = e->largest[r];
        e->largest[r] = at == a ? b : at == b ? a : at;
    }
}

/* Moves the largest entry of what is left to [k][k]; false if it is below `least`. */
static bool pivot(elimination *const e, const wide least)
{
    wide(*const a)[UNKNOWNS_MAX + 1] = e->s->a;
    int row = e->k;
    for (int r = e->k + 1; r < e->s->n; r++) {
        row = fabsl(a[r][e->largest[r]]) > fabsl(a[row][e->largest[row]]) ? r : row;
    }
    if (fabsl(a[row][e->largest[row]]) < least) {
        return false;
    }
    swap_rows(e, e->k, row);
    swap_columns(e, e->k, e->largest[e->k]);
    return true;
}

/* Takes column k from the rows below, which leaves those alone that have nothing in it. */
static void eliminate(elimination *const e)
{
    linear_system *const s = e->s;
    const wide *const above = s->a[e->k];
    const int column = e->k++;
    for (int r = e->k; r < s->n; r++) {
        const wide factor = s->a[r][column] / above[column];
        if (factor != 0.0L) {
            for (int c = column; c <= s->n; c++) {
                s->a[r][c] -= factor * above[c];
            }
            find_largest(e, r);
        }
    }
}

bool linear_solve(linear_system *const s, const wide least, wide *const x)
{
    static elimination e;
    wide scale[UNKNOWNS_MAX];
    wide y[UNKNOWNS_MAX];
    wide largest = 0.0L;
    wide left = 0.0L;
    equilibrate(s, scale);
    e.s = s;
    e.k = 0;
    for (int i = 0; i < s->n; i++) {
        e.unknown[i] = i;
        x[i] = 0.0L;
        find_largest(&e, i);
        largest = fmaxl(largest, fabsl(s->a[i][s->n]));
    }
    while (e.k < s->n && pivot(&e, least)) {
        eliminate(&e);
    }
    for (int r = e.k; r < s->n; r++) {
        left = fmaxl(left, fabsl(s->a[r][s->n]));
    }
    for (int k = e.k - 1; k >= 0; k--) {
        y[k] = s->a[k][s->n];
        for (int c = k + 1; c < e.k; c++) {
            y[k] -= s->a[k][c] * y[c];
        }
        y[k] /= s->a[k][k];
        x[e.unknown[k]] = y[k] / scale[e.unknown[k]];
    }
    return left <= CONTRADICTION * largest;
}
