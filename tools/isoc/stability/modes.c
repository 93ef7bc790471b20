#include "tools/isoc/stability/stability.h"

#include <math.h>

#include "tools/isoc/base/numbers.h"
#include "tools/isoc/method/growth.h"
#include "tools/isoc/method/step_map.h"

/* The growth per step that counts as none: as in tests/isoc/stability. */
static const double slack = 1e-3;

/* An oscillation counts as damped by so much with a method that lets every undamped one grow; a mode whose rate is more
 * than this part of its size grows by itself. */
static const double usual_damping = 0.1, own_growth = 0.01;

/* No region of an explicit method reaches so far. */
static const double beyond = 50.0;

modes modes_of(arena *memory, slopes at)
{
    modes result = {.tangent = at};
    result.re = arena_take(memory, (size_t)at.n + 1, sizeof *result.re);
    result.im = arena_take(memory, (size_t)at.n + 1, sizeof *result.im);
    result.found = eigenvalues(memory, at.at, at.n, result.re, result.im);
    return result;
}

static double exponential(double x)
{
    return elementary_exp(x < 700.0 ? x : 700.0);
}

/* Whether it lets an undamped oscillation grow however small the step is. */
static bool grows_on_axis(arena *memory, unsigned recipe)
{
    return growth_of(memory, recipe, 0.0, 0.05) > 1.0 + 1e-12;
}

/* The growth per step of the fastest growing mode of the plant itself, at least 1: growth below it is not the method's.
 */
static double own_growth_of(const modes *m, double step)
{
    double rate = 0.0;
    for (int i = 0; i < m->tangent.n; i++) {
        rate = fmax(rate, m->re[i]);
    }
    return exponential(step * rate);
}

/* The standard for a method: growth per step of the plant's own modes, and whether all undamped oscillations grow. */
typedef struct scale {
    unsigned recipe;
    double own;
    bool is_lenient;
} scale;

static bool is_growing(arena *memory, const scale *by, double re, double im)
{
    const double size = modulus(re, im);
    if (size == 0.0 || re > own_growth * size) {
        return false;
    }
    if (size > beyond && !ISO_IS_IMPLICIT(by->recipe)) {
        return true;
    }
    const double missing = by->is_lenient && im != 0.0 ? fmax(usual_damping * size + fmin(re, 0.0), 0.0) : 0.0;
    return growth_of(memory, by->recipe, re, im) > by->own * exponential(missing) + slack;
}

/* Whether some states take sub-steps of their own. */
static bool has_two_rates(const modes *m, unsigned recipe)
{
    return m->tangent.substeps > 0 && ISO_IS_EXPLICIT(recipe);
}

/* Whether a step is looked at as a whole. */
static bool has_map(const modes *m, unsigned recipe)
{
    return ISO_IS(recipe, ISO_SEMI_IMPLICIT) || has_two_rates(m, recipe);
}

/* Such a step has eigenvalues of its own, which are not those of J one by one: a spring and its damper count together.
 */
static modes modes_of_map(arena *memory, const modes *m, unsigned recipe, double step)
{
    const linear_plant l = {m->tangent.at, m->tangent.n, m->tangent.positions};
    slopes s = m->tangent;
    s.at = has_two_rates(m, recipe) ? two_rates_map(memory, recipe, &l, m->tangent.is_fast, m->tangent.substeps, step)
                                    : step_map(memory, ISO_METHOD_OF(recipe), &l, step, &s.n);
    return modes_of(memory, s);
}

static int count_growing_maps(arena *memory, const modes *m, unsigned recipe, double step)
{
    const bool is_lenient = grows_on_axis(memory, recipe) || ISO_IS(recipe, ISO_SEMI_IMPLICIT);
    const modes map = modes_of_map(memory, m, recipe, step);
    const double own = own_growth_of(m, step);
    int count = map.found ? 0 : 1; /* as in growth_of_map: eigenvalues that are not found count as growing */
    for (int i = 0; map.found && i < map.tangent.n; i++) {
        /* Forces that follow the speeds across, as of a gyroscope, are those of euler. */
        const double turned =
            map.im[i] == 0.0 || !is_lenient ? 0.0 : usual_damping * modulus(map.re[i] - 1.0, map.im[i]);
        count += modulus(map.re[i], map.im[i]) > own * exponential(turned) + slack;
    }
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
        for (int i = 0; i < m->tangent.n; i++) {
            const double size = modulus(m->re[i], m->im[i]);
            if (m->re[i] <= own_growth * size && size > largest && size < below) {
                largest = size;
                found = i;
            }
        }
        below = largest;
    }
    return found;
}

/* The mode that is reported for a map. With two rates, one that is too fast for a sub-step; or, where those of the fast
 * states are not, the next. */
static int mode_of_map(arena *memory, const modes *m, unsigned recipe, double step)
{
    const int first = fastest_but(m, 0), next = fastest_but(m, m->tangent.fast_count);
    const double part = step / (double)(m->tangent.substeps > 0 ? m->tangent.substeps : 1);
    const scale by = {recipe, 1.0, grows_on_axis(memory, recipe)};
    const bool is_told = !has_two_rates(m, recipe) || next < 0 ||
                         (first >= 0 && is_growing(memory, &by, part * m->re[first], part * m->im[first]));
    return is_told ? first : next;
}

/* One after the other; both of a pair. */
static int count_growing_modes(arena *memory, const modes *m, unsigned recipe, double step, int *fastest)
{
    const scale by = {recipe, own_growth_of(m, step), grows_on_axis(memory, recipe)};
    int count = 0;
    double largest = -1.0;
    for (int i = 0; i < m->tangent.n; i++) {
        const double size = modulus(m->re[i], m->im[i]);
        if (m->im[i] >= 0.0 && is_growing(memory, &by, step * m->re[i], step * m->im[i])) {
            count += m->im[i] > 0.0 ? 2 : 1;
            *fastest = size > largest ? i : *fastest;
            largest = fmax(largest, size);
        }
    }
    return count;
}

int count_growing(const modes *m, unsigned recipe, double step, int *fastest)
{
    arena *memory = arena_new();
    int count;
    if (has_map(m, recipe)) {
        const int index = mode_of_map(memory, m, recipe, step);
        *fastest = index >= 0 ? index : *fastest;
        count = count_growing_maps(memory, m, recipe, step);
    } else {
        count = count_growing_modes(memory, m, recipe, step, fastest);
    }
    arena_free(memory);
    return count;
}

/* The faster of two growths per step beyond the plant's own growth. */
static drift faster(drift than, double growth, double frequency, double own, double step)
{
    const double rate = growth > own ? elementary_log(growth / own) / step : 0.0;
    return rate > than.rate ? (drift){rate, frequency} : than;
}

drift drift_of(const modes *m, unsigned recipe, double step)
{
    arena *memory = arena_new();
    const bool is_map = has_map(m, recipe);
    const modes all = is_map ? modes_of_map(memory, m, recipe, step) : *m;
    const double own = own_growth_of(m, step);
    drift found = {0.0, 0.0};
    for (int i = 0; all.found && i < all.tangent.n; i++) {
        const double re = all.re[i], im = all.im[i], size = modulus(re, im);
        if (im > 0.0 && is_map) {
            found = faster(found, size, elementary_atan2(im, re) / step, own, step);
        } else if (im > 0.0 && re <= own_growth * size) {
            found = faster(found, growth_of(memory, recipe, step * re, step * im), im, own, step);
        }
    }
    arena_free(memory);
    return found;
}

/* The modes without decays that are slower than another: with a step that grows, a method first loses the fastest. */
static modes without_slow_decays(arena *memory, const modes *m)
{
    modes result = *m;
    double fastest = 0.0;
    int count = 0;
    for (int i = 0; i < m->tangent.n; i++) {
        fastest = m->im[i] == 0.0 ? fmin(fastest, m->re[i]) : fastest;
    }
    result.re = list_copy(memory, m->re, (size_t)m->tangent.n, sizeof *m->re);
    result.im = list_copy(memory, m->im, (size_t)m->tangent.n, sizeof *m->im);
    for (int i = 0; i < m->tangent.n; i++) {
        if (m->im[i] != 0.0 || m->re[i] > 0.0 || m->re[i] == fastest) {
            result.re[count] = m->re[i];
            result.im[count++] = m->im[i];
        }
    }
    result.tangent.n = count;
    return result;
}

double largest_step(const modes *m, unsigned recipe)
{
    enum { HALVINGS = 12 };
    const double least = 0.01, factor = 1.1;
    arena *memory = arena_new();
    const modes looked_at = has_map(m, recipe) ? *m : without_slow_decays(memory, m);
    double fastest = 0.0;
    int which;
    for (int i = 0; i < m->tangent.n; i++) {
        fastest = fmax(fastest, modulus(m->re[i], m->im[i]));
    }
    const double reach = has_two_rates(m, recipe) ? beyond * (double)m->tangent.substeps : beyond;
    double low = 0.0, high = least / fastest;
    while (high * fastest < reach && count_growing(&looked_at, recipe, high, &which) == 0) {
        low = high;
        high *= factor;
    }
    const bool is_limited = high * fastest < reach;
    for (int i = 0; i < HALVINGS && is_limited; i++) {
        const double middle = 0.5 * (low + high);
        *(count_growing(&looked_at, recipe, middle, &which) == 0 ? &low : &high) = middle;
    }
    arena_free(memory);
    return is_limited ? low : HUGE_VAL;
}
