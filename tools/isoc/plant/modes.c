#include "tools/isoc/plant/modes.h"

#include <math.h>

#include "tools/isoc/base/eigenvalues.h"
#include "tools/isoc/base/elementary.h"
#include "tools/isoc/mechanism/growth.h"
#include "tools/isoc/plant/two_rates.h"

/* Growth per step that is none: as in tests/stability. */
static const double slack = 1e-3;

/* An oscillation counts as damped by so much with a method that lets every undamped one grow; a mode whose rate is more than
 * this part of its size grows by itself. */
static const double usual_damping = 0.1, own_growth = 0.01;

/* No region of an explicit method reaches so far. */
static const double beyond = 50.0;

modes modes_of(arena *memory, slopes of)
{
    modes made = {.of = of};
    made.re = arena_take(memory, (size_t)of.n + 1, sizeof *made.re);
    made.im = arena_take(memory, (size_t)of.n + 1, sizeof *made.im);
    made.found = eigenvalues(memory, of.at, of.n, made.re, made.im);
    return made;
}

static double size_of(double re, double im)
{
    return sqrt(re * re + im * im);
}

static double exponential(double x)
{
    return elementary_exp(x < 700.0 ? x : 700.0);
}

/* Whether it lets an undamped oscillation grow however small the step is. */
static bool grows_on_axis(unsigned recipe)
{
    return growth_of(recipe, 0.05 * GROWTH_I) > 1.0 + 1e-12;
}

/* The growth per step of what grows fastest by itself, at least 1: a method is blamed for no less. */
static double own_growth_of(const modes *m, double step)
{
    double rate = 0.0;
    for (int i = 0; i < m->of.n; i++) {
        rate = fmax(rate, m->re[i]);
    }
    return exponential(step * rate);
}

static bool is_growing(unsigned recipe, double re, double im, double own)
{
    const double size = size_of(re, im);
    if (re > own_growth * size) {
        return false;
    }
    if (size > beyond && !ISO_IS_IMPLICIT(recipe)) {
        return true;
    }
    const bool is_lenient = im != 0.0 && grows_on_axis(recipe);
    const double missing = is_lenient ? fmax(usual_damping * size + fmin(re, 0.0), 0.0) : 0.0;
    return growth_of(recipe, re + im * GROWTH_I) > own * exponential(missing) + slack;
}

/* What semi_implicit does to speeds and positions: v += h (J_vq q + J_vv v), then q += h (J_qq q + J_qv v). */
static double *semi_implicit_map(arena *memory, const slopes *s, double h)
{
    const int n = s->n;
    double *map = arena_take(memory, (size_t)(n * n) + 1, sizeof *map);
    for (int row = n - 1; row >= 0; row--) {
        for (int column = 0; column < n; column++) {
            double sum = row == column ? 1.0 : 0.0;
            if (row >= s->positions || column < s->positions) {
                sum += h * s->at[row * n + column];
            }
            for (int v = s->positions; row < s->positions && v < n; v++) {
                sum += h * s->at[row * n + v] * map[v * n + column];
            }
            map[row * n + column] = sum;
        }
    }
    return map;
}

/* Whether some states take sub-steps of their own. */
static bool has_two_rates(const modes *m, unsigned recipe)
{
    return m->of.substeps > 0 && ISO_TAKES_SUBSTEPS(recipe);
}

/* Such a map has eigenvalues of its own, which are not those of J one by one: a spring and its damper count together. */
static int count_growing_maps(arena *memory, const modes *m, unsigned recipe, double step)
{
    const int n = m->of.n;
    const size_t size = (size_t)(n * n) + 1;
    const bool is_lenient = grows_on_axis(recipe) || ISO_IS(recipe, ISO_SEMI_IMPLICIT);
    double *map = has_two_rates(m, recipe)
                      ? two_rates_map(memory, m->of.at, n, m->of.is_fast, m->of.substeps, recipe, step)
                      : semi_implicit_map(memory, &m->of, step);
    double *re = arena_take(memory, (size_t)n + 1, sizeof *re), *im = arena_take(memory, (size_t)n + 1, sizeof *im);
    const double own = own_growth_of(m, step);
    int count = 0;
    if (eigenvalues(memory, map, n, re, im)) {
        for (int i = 0; i < n; i++) {
            /* Forces that follow the speeds across, as of a gyroscope, are those of euler. */
            const double turned = im[i] == 0.0 || !is_lenient ? 0.0 : usual_damping * size_of(re[i] - 1.0, im[i]);
            count += size_of(re[i], im[i]) > own * exponential(turned) + slack;
        }
    }
    arena_return(memory, map, size, sizeof *map);
    return count;
}

/* The fastest of the modes that decay, but so many; -1 where there is none. */
static int fastest_but(const modes *m, int others)
{
    int found = -1;
    double below = HUGE_VAL;
    for (int skipped = 0; skipped <= others; skipped++) {
        double largest = -1.0;
        found = -1;
        for (int i = 0; i < m->of.n; i++) {
            const double size = size_of(m->re[i], m->im[i]);
            if (m->re[i] <= own_growth * size && size > largest && size < below) {
                largest = size;
                found = i;
            }
        }
        below = largest;
    }
    return found;
}

/* The mode that a map is told by. With two rates, one that is too fast for a sub-step; or, as those of the fast states are
 * not, the next. */
static int mode_of_map(const modes *m, unsigned recipe, double step)
{
    const int first = fastest_but(m, 0), next = fastest_but(m, m->of.fast_count);
    const double part = step / (double)(m->of.substeps > 0 ? m->of.substeps : 1);
    const bool is_told = !has_two_rates(m, recipe) || next < 0 ||
                         (first >= 0 && is_growing(recipe, part * m->re[first], part * m->im[first], 1.0));
    return is_told ? first : next;
}

int count_growing(arena *memory, const modes *m, unsigned recipe, double step, int *fastest)
{
    const bool is_map = ISO_IS(recipe, ISO_SEMI_IMPLICIT) || has_two_rates(m, recipe);
    const double own = own_growth_of(m, step);
    int count = 0;
    double largest = -1.0;
    if (is_map) {
        const int told = mode_of_map(m, recipe, step);
        *fastest = told >= 0 ? told : *fastest;
        return count_growing_maps(memory, m, recipe, step);
    }
    for (int i = 0; i < m->of.n; i++) {
        const double size = size_of(m->re[i], m->im[i]);
        if (is_growing(recipe, step * m->re[i], step * m->im[i], own)) {
            count++;
            *fastest = size > largest ? i : *fastest;
            largest = fmax(largest, size);
        }
    }
    return count;
}

double largest_step(arena *memory, const modes *m, unsigned recipe)
{
    enum { HALVINGS = 12 };
    const double least = 0.01, factor = 1.1;
    double fastest = 0.0;
    int which;
    for (int i = 0; i < m->of.n; i++) {
        fastest = fmax(fastest, size_of(m->re[i], m->im[i]));
    }
    const double reach = has_two_rates(m, recipe) ? beyond * (double)m->of.substeps : beyond;
    double low = 0.0, high = least / fastest;
    while (count_growing(memory, m, recipe, high, &which) == 0) {
        low = high;
        high *= factor;
        if (!(high * fastest < reach)) {
            return HUGE_VAL;
        }
    }
    for (int i = 0; i < HALVINGS; i++) {
        const double middle = 0.5 * (low + high);
        *(count_growing(memory, m, recipe, middle, &which) == 0 ? &low : &high) = middle;
    }
    return low;
}
