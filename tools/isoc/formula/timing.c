#include "tools/isoc/formula/ticks.h"

#include <math.h>

#include "tools/isoc/formula/scalar.h"

value time_of_formula(values *v, const formula *f)
{
    if (is_time_input(v)) {
        return v->around->time_input(v->around->context, f);
    }
    return allows_time(v, f) ? scalar(timed(v->g, OP_TIME, 0.0, v->step), second) : nothing;
}

bool turns_in_tick(values *v, const formula *f, value frequency, double *turns)
{
    if (frequency.count == 1 && dimension_equal(frequency.dim, radian_per_second)) {
        frequency.parts[0] = divide(v->g, frequency.parts[0], constant(v->g, 2 * pi));
        frequency.dim = hertz;
    }
    if (frequency.count != 1 || !dimension_equal(frequency.dim, hertz) || !is_constant(v->g, frequency.parts[0])) {
        return source_problem(v->s, f->at, "expected a constant frequency in Hz or rad/s");
    }
    *turns = constant_value(v->g, frequency.parts[0]) * v->step;
    return fabs(*turns) <= 0.5 || source_problem(v->s, f->at, "more than half a period in a step: use a shorter step");
}

/* A phase that grows with the ticks. */
value wave_of_formula(values *v, const formula *f, const value *arguments, node (*of_angle)(graph *g, node angle))
{
    double turns;
    if (!allows_time(v, f) || !turns_in_tick(v, f->parts[0], arguments[0], &turns)) {
        return nothing;
    }
    const double phase =
        f->count == 2 ? constant_fitting(v, f->parts[1], &arguments[1], radian, "the phase", 0.0) : 0.0;
    const node angle = timed(v->g, OP_PHASE, turns, phase / (2 * pi));
    return scalar(of_angle(v->g, angle), plain);
}

bool noise_seed(values *v, const formula *f, const value *arguments, uint32_t *seed)
{
    static const double largest = 4294967295.0;
    const double number = constant_fitting(v, f->parts[0], arguments, plain, "the seed", 0.0);
    const bool is_seed = number >= 0.0 && number <= largest && number == floor(number);
    *seed = is_seed ? (uint32_t)number : 0;
    return is_seed ||
           source_problem(v->s, f->parts[0]->at, "the seed of noise is a whole number from 0 to %.0f", largest);
}

node noise_of_seed(graph *g, uint32_t seed)
{
    return timed(g, OP_NOISE, seed, 0.0);
}

/* noise(7): a number for each tick, with mean 0 and variance 1, for the seed 7. */
value noise_of(values *v, const formula *f, const value *arguments)
{
    uint32_t seed;
    return noise_seed(v, f, arguments, &seed) ? scalar(noise_of_seed(v->g, seed), plain) : nothing;
}
