#include "tools/isoc/formula/timing.h"

#include <math.h>
#include <string.h>

static const dimension plain = {0, 0, 0, 0, 0, 0, 0}, second = {0, 0, 1, 0, 0, 0, 0};
static const double pi = 3.14159265358979323846;

static const double most_ticks = 4e9; /* of 2^32 */

static const value nothing = {0};

static value scalar(node n, dimension expected)
{
    return (value){.count = 1, .parts = {n}, .of = expected};
}

bool is_time_input(const values *v)
{
    return v->around != NULL && !v->time_allowed;
}

bool refuses_time(values *v, const formula *f)
{
    if (!v->time_allowed) {
        source_problem(v->s, f->at, "'%s' depends on time: only an input or a motion can", f->name);
    }
    return !v->time_allowed;
}

value time_of_formula(values *v, const formula *f)
{
    if (is_time_input(v)) {
        return v->around->time_input(v->around->of, f);
    }
    return refuses_time(v, f) ? nothing : scalar(timed(v->g, OP_TIME, 0.0, v->step), second);
}

bool turns_in_tick(values *v, const formula *f, double *turns)
{
    static const dimension hertz = {0, 0, -1, 0, 0, 0, 0}, speed = {0, 0, -1, 1, 0, 0, 0};
    value frequency = value_any(v, f);
    if (frequency.count == 1 && dimension_equal(frequency.of, speed)) {
        frequency.parts[0] = divide(v->g, frequency.parts[0], constant(v->g, 2 * pi));
        frequency.of = hertz;
    }
    if (frequency.count == 0) {
        return false;
    }
    if (frequency.count != 1 || !dimension_equal(frequency.of, hertz) || !is_constant(v->g, frequency.parts[0])) {
        source_problem(v->s, f->at, "expected a constant frequency in Hz or rad/s");
        return false;
    }
    *turns = constant_value(v->g, frequency.parts[0]) * v->step;
    if (fabs(*turns) > 0.5) {
        source_problem(v->s, f->at, "more than half a period in a step: use a shorter step");
        return false;
    }
    return true;
}

/* A phase that grows with the ticks. */
value wave_of_formula(values *v, const formula *f)
{
    static const dimension radian = {0, 0, 0, 1, 0, 0, 0};
    if (refuses_time(v, f)) {
        return nothing;
    }
    if (f->count != 1 && f->count != 2) {
        source_problem(v->s, f->at, "%s needs a frequency, and may have a phase: %s(3 Hz, 90 deg)", f->name, f->name);
        return nothing;
    }
    double turns;
    if (!turns_in_tick(v, f->parts[0], &turns)) {
        return nothing;
    }
    const double phase = f->count == 2 ? value_constant(v, f->parts[1], radian, "the phase", 0.0) : 0.0;
    const node angle = timed(v->g, OP_PHASE, turns, phase / (2 * pi));
    return scalar(strcmp(f->name, "sin") == 0 ? sine(v->g, angle) : cosine(v->g, angle), plain);
}

bool noise_seed(values *v, const formula *f, uint32_t *seed)
{
    static const double largest = 4294967295.0;
    const double given = value_constant(v, f->parts[0], plain, "the seed", 0.0);
    const bool is_seed = given >= 0.0 && given <= largest && given == floor(given);
    if (!is_seed) {
        source_problem(v->s, f->parts[0]->at, "the seed of noise is a whole number from 0 to %.0f", largest);
    }
    *seed = is_seed ? (uint32_t)given : 0;
    return is_seed;
}

node noise_of_seed(graph *g, uint32_t seed)
{
    return timed(g, OP_NOISE, seed, 0.0);
}

/* noise(7): a number for each tick, with mean 0 and variance 1, for the seed 7. */
value noise_of_formula(values *v, const formula *f)
{
    uint32_t seed;
    if (is_time_input(v)) {
        return v->around->time_input(v->around->of, f);
    }
    if (refuses_time(v, f)) {
        return nothing;
    }
    if (v->is_smooth) {
        source_problem(v->s, f->at, "a motion must be smooth, and noise is not");
        return nothing;
    }
    return noise_seed(v, f, &seed) ? scalar(noise_of_seed(v->g, seed), plain) : nothing;
}

/* The part of a smooth curve that is done. With c = (tick - from) / ticks, limited to [0, 1], it is c^3 (10 - 15 c + 6
 * c^2), whose first and second derivatives are zero at both ends (the 3-4-5 polynomial of cams). With d = c - 1/2 it is
 * 1/2 + d (15/8 - d^2 (5 - 6 d^2)), which has a tenth of the rounding error. `first` is the tick at which the first
 * curve of the ramp begins. */
static node smooth_part(values *v, double first, double from, double ticks)
{
    graph *g = v->g;
    const node since = timed(g, OP_SINCE, first, v->step);
    const node part = divide(g, sub(g, since, constant(g, (from - first) * v->step)), constant(g, ticks * v->step));
    const node below = larger(g, neg(g, part), constant(g, -1.0)), c = larger(g, constant(g, 0.0), neg(g, below));
    const node d = sub(g, c, constant(g, 0.5)), square = mul(g, d, d);
    const node inner = sub(g, constant(g, 5.0), mul(g, constant(g, 6.0), square));
    const node outer = sub(g, constant(g, 1.875), mul(g, square, inner));
    return add(g, constant(g, 0.5), mul(g, d, outer));
}

/* A table has straight lines between the points, a ramp smooth curves; outside both have the end values. */
value points_of_formula(values *v, const formula *f)
{
    const bool is_smooth = strcmp(f->name, "ramp") == 0;
    if (v->is_smooth && !is_smooth) {
        source_problem(v->s, f->at, "a motion must be smooth, and a table has corners: use ramp");
        return nothing;
    }
    if (refuses_time(v, f)) {
        return nothing;
    }
    if (f->count < 2 || f->count % 2 != 0) {
        source_problem(v->s, f->at, "a %s needs pairs of time and value: %s(0 s: 0 N, 1 s: 8 N)", f->name, f->name);
        return nothing;
    }
    const char *a_time = arena_format(v->s->memory, "a time of the %s", f->name);
    value sum = value_any(v, f->parts[1]), last = sum;
    const double first = value_constant(v, f->parts[0], second, a_time, 0.0) / v->step;
    double last_time = first;
    for (size_t i = 2; i < f->count && sum.count > 0; i += 2) {
        const double time = value_constant(v, f->parts[i], second, a_time, 0.0) / v->step;
        const value here = value_any(v, f->parts[i + 1]);
        if (here.count == 0) {
            return nothing;
        }
        if (here.count != 1 || last.count != 1 || (!here.any && !last.any && !agree(v, here.of, last.of))) {
            source_problem(v->s, f->parts[i + 1]->at, "the values of a %s must be numbers of the same dimension",
                           f->name);
            return nothing;
        }
        if (!(time > last_time) || last_time < 0.0) {
            source_problem(v->s, f->parts[i]->at, "the times of a %s must begin at 0 or later, and increase", f->name);
            return nothing;
        }
        if (time > most_ticks) {
            source_problem(v->s, f->parts[i]->at, "a time of a %s is at most %g s with this step (%g ticks)", f->name,
                           most_ticks * v->step, most_ticks);
            return nothing;
        }
        const node rise = sub(v->g, here.parts[0], last.parts[0]);
        const double ticks = time - last_time;
        const node weight = is_smooth ? rise : divide(v->g, rise, constant(v->g, ticks));
        const node part = is_smooth ? smooth_part(v, first, last_time, ticks) : timed(v->g, OP_RAMP, last_time, ticks);
        sum.parts[0] = add(v->g, sum.parts[0], mul(v->g, weight, part));
        gather(&sum, &here);
        last = here;
        last.of = sum.of;
        last.any = sum.any;
        last_time = time;
    }
    return sum;
}
