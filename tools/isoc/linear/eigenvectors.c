#include "tools/isoc/linear/linear.h"

#include <complex.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "tools/isoc/base/numbers.h"
#include "tools/isoc/stability/stability.h"

static const double log_2 = 0.69314718055994530942, tau = 6.28318530717958647692;

/* --- vectors --- */

/* a = L U in place, with rows in the order `row`; a pivot that is lost becomes `least`. */
static void factorise_shifted(double complex *a, int n, int *row, double least)
{
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int i = k + 1; i < n; i++) {
            best = cabs(a[i * n + k]) > cabs(a[best * n + k]) ? i : best;
        }
        for (int j = 0; j < n && best != k; j++) {
            const double complex kept = a[k * n + j];
            a[k * n + j] = a[best * n + j];
            a[best * n + j] = kept;
        }
        row[k] = best;
        a[k * n + k] = cabs(a[k * n + k]) < least ? least : a[k * n + k];
        for (int i = k + 1; i < n; i++) {
            a[i * n + k] /= a[k * n + k];
            for (int j = k + 1; j < n; j++) {
                a[i * n + j] -= a[i * n + k] * a[k * n + j];
            }
        }
    }
}

static void solve_shifted(const double complex *a, int n, const int *row, double complex *b)
{
    for (int k = 0; k < n; k++) {
        const double complex kept = b[k];
        b[k] = b[row[k]];
        b[row[k]] = kept;
        for (int i = k + 1; i < n; i++) {
            b[i] -= a[i * n + k] * b[k];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int j = i + 1; j < n; j++) {
            b[i] -= a[i * n + j] * b[j];
        }
        b[i] /= a[i * n + i];
    }
    double largest = 0.0;
    for (int i = 0; i < n; i++) {
        largest = fmax(largest, cabs(b[i]));
    }
    for (int i = 0; i < n; i++) {
        b[i] /= largest;
    }
}

/* The vector of an eigenvalue of a, or of its transpose, by inverse iteration beside it. */
static double complex *eigenvector_of(arena *memory, const double *a, int n, double complex eigenvalue, bool transposed)
{
    enum { ITERATIONS = 3 };
    double complex *shifted = arena_take(memory, (size_t)(n * n) + 1, sizeof *shifted),
                   *result = arena_take(memory, (size_t)n + 1, sizeof *result);
    int *row = arena_take(memory, (size_t)n + 1, sizeof *row);
    const double largest = largest_of(a, n * n);
    const double complex beside = eigenvalue * (1.0 + 1e-10) + 1e-14 * largest;
    for (int i = 0; i < n; i++) {
        result[i] = 1.0 + 0.1 * (double)(7 * i % 5);
        for (int j = 0; j < n; j++) {
            shifted[i * n + j] = transposed ? a[j * n + i] : a[i * n + j];
        }
        shifted[i * n + i] -= beside;
    }
    factorise_shifted(shifted, n, row, 1e-18 * largest + DBL_MIN);
    for (int i = 0; i < ITERATIONS; i++) {
        solve_shifted(shifted, n, row, result);
    }
    return result;
}

/* --- the causes of a mode --- */

/* The causes that may matter: effects, and joints with a spring or a damper. */
static bool is_possible_cause(const graph *g, const mechanism *m, int which)
{
    const int at_joint = which - m->effects.count;
    if (at_joint < 0 || at_joint >= m->segment_count + m->forces.spring_count) {
        return at_joint < 0;
    }
    return at_joint >= m->segment_count || !is_zero(g, m->segments[at_joint].damping) ||
           !is_zero(g, m->segments[at_joint].spring);
}

/* A without a cause. */
static double *matrix_without_cause(const graph *g, const linear_model *l, int which)
{
    const plant *p = l->e->p;
    graph copy = graph_copy(g);
    const mechanism less = without_cause(p->m, &copy, which);
    node *derivatives = arena_take(g->memory, (size_t)state_count(p->m) + 1, sizeof *derivatives);
    derivatives_build(&copy, &less, p->formulations.kept, derivatives);
    expansion e = expand(&copy, p, derivatives, false);
    double *result = matrix_without(l, &e);
    graph_free(&e.l.g);
    graph_free(&copy);
    return result;
}

/* The change of a mode by the difference of two matrices, to first order. */
static double share_of(const double *a, const double *without, int n, const double complex *left,
                       const double complex *right)
{
    double complex moved = 0.0;
    double size = 0.0;
    for (int i = 0; i < n; i++) {
        size += cabs(left[i] * right[i]);
        for (int j = 0; j < n; j++) {
            moved += left[i] * (a[i * n + j] - without[i * n + j]) * right[j];
        }
    }
    return cabs(moved) / size;
}

/* --- modes --- */

static void find_parts(mode *to, int n, const double complex *left, const double complex *right)
{
    double sum = 0.0;
    for (int i = 0; i < n; i++) {
        sum += to->part[i] = cabs(left[i] * right[i]);
    }
    for (int i = 0; i < n; i++) {
        to->part[i] /= sum;
    }
}

/* Whether rounding of A moves the eigenvalue across zero: its condition is one over the product of both vectors. */
static bool is_neutral(const double *a, int n, const mode *eigenmode, const double complex *left,
                       const double complex *right)
{
    double complex product = 0.0;
    double squares[2] = {0.0, 0.0}, moved = 0.0;
    for (int i = 0; i < n; i++) {
        product += left[i] * right[i];
        squares[0] += creal(left[i] * conj(left[i]));
        squares[1] += creal(right[i] * conj(right[i]));
        for (int j = 0; j < n; j++) {
            moved += cabs(left[i]) * fabs(a[i * n + j]) * cabs(right[j]);
        }
    }
    const double rounding = 1e3 * DBL_EPSILON * (moved + DBL_EPSILON * sqrt(squares[0] * squares[1]));
    return fabs(eigenmode->re) <= rounding / fmax(cabs(product), DBL_EPSILON) ||
           fabs(eigenmode->re) <= 1e-9 * modulus(eigenmode->re, eigenmode->im);
}

/* Growing before decaying, then by speed. */
static int by_growth(const void *first, const void *second)
{
    const mode *a = first, *b = second;
    const double x = a->is_neutral ? 0.0 : a->re, y = b->is_neutral ? 0.0 : b->re;
    return (x < y) - (x > y);
}

static void name_causes(const graph *g, const linear_model *l, const mode_list *list, double complex **left,
                        double complex **right)
{
    const mechanism *m = l->e->p->m;
    double *best = arena_take(g->memory, (size_t)list->count + 1, sizeof *best);
    for (int which = 0; which < cause_count(m); which++) {
        if (!is_possible_cause(g, m, which)) {
            continue;
        }
        const double *without = matrix_without_cause(g, l, which);
        const cause c = cause_of(m, which);
        for (int i = 0; i < list->count; i++) {
            mode *eigenmode = &list->all[i];
            const double share = share_of(l->a, without, l->c.count, left[i], right[i]);
            const double size = modulus(eigenmode->re, eigenmode->im);
            if (!(eigenmode->is_neutral && !(eigenmode->im > 0.0)) && share > 0.1 * size && share > best[i]) {
                best[i] = share;
                eigenmode->by = arena_format(g->memory, "%s '%s'", c.sort, c.name);
            }
        }
    }
}

/* Puts zeros in the place of eigenvalues that are the rounding of the largest. */
static void clear_rounding(double *re, double *im, int n)
{
    double largest = 0.0;
    for (int i = 0; i < n; i++) {
        largest = fmax(largest, modulus(re[i], im[i]));
    }
    for (int i = 0; i < n; i++) {
        if (modulus(re[i], im[i]) <= 1e-13 * largest) {
            re[i] = im[i] = 0.0;
        }
    }
}

mode_list modes_find(const graph *g, const linear_model *l)
{
    arena *memory = g->memory;
    const int n = l->c.count;
    const size_t room = (size_t)n + 1;
    double *re = arena_take(memory, room, sizeof *re), *im = arena_take(memory, room, sizeof *im);
    double complex **left = arena_take(memory, room, sizeof *left), **right = arena_take(memory, room, sizeof *right);
    mode_list list = {.all = arena_take(memory, room, sizeof *list.all)};
    list.found = eigenvalues(memory, l->a, n, re, im);
    clear_rounding(re, im, n);
    for (int i = 0; i < n && list.found; i++) {
        if (im[i] < 0.0) {
            continue;
        }
        mode *to = &list.all[list.count];
        *to = (mode){.re = re[i], .im = im[i], .part = arena_take(memory, room, sizeof *to->part)};
        const double complex eigenvalue = re[i] + im[i] * (double complex)_Complex_I;
        left[list.count] = eigenvector_of(memory, l->a, n, eigenvalue, true);
        right[list.count] = eigenvector_of(memory, l->a, n, eigenvalue, false);
        find_parts(to, n, left[list.count], right[list.count]);
        to->is_neutral = is_neutral(l->a, n, to, left[list.count], right[list.count]);
        list.count++;
    }
    name_causes(g, l, &list, left, right);
    qsort(list.all, (size_t)list.count, sizeof *list.all, by_growth);
    return list;
}

const char *mode_words(arena *memory, const mode *m)
{
    const double size = modulus(m->re, m->im);
    const char *swings = m->im > 0.0 ? arena_format(memory, "swings at %.4g Hz, ", m->im / tau) : "";
    if (m->is_neutral) {
        return m->im > 0.0 ? arena_format(memory, "%sneither grows nor decays", swings)
                           : "neutral: nothing brings it back";
    }
    const char *damping = m->im > 0.0 && m->re < 0.0 ? arena_format(memory, "damping ratio %.3g, ", -m->re / size) : "";
    return arena_format(memory, "%s%s%s every %.3g s", swings, damping, m->re > 0.0 ? "doubles" : "halves",
                        log_2 / fabs(m->re));
}
