#include "tools/isoc/formula/ticks.h"

#include <math.h>

#include "tools/isoc/formula/scalar.h"

static const double most_repeated = 16777216.0; /* ticks, of core/numbers/waveform.h */

/* A time in ticks, from `least` on. */
static bool ticks_of(values *v, const formula *f, const value *argument, const char *what, double least, double *ticks)
{
    const size_t before = v->s->problem_count;
    *ticks = constant_fitting(v, f, argument, second, what, 0.0) / v->step;
    return v->s->problem_count == before && ((*ticks >= least && *ticks <= most_ticks) ||
                                             source_problem(v->s, f->at, "%s is from %g to %g s with this step", what,
                                                            least * v->step, most_ticks * v->step));
}

static bool whole_ticks_of(values *v, const formula *f, const value *argument, const char *what, double *ticks)
{
    if (!ticks_of(v, f, argument, what, 1.0, ticks)) {
        return false;
    }
    if (!is_whole_tick(*ticks)) {
        return source_problem(v->s, f->at, "%s is a whole number of steps; this is %.6g", what, *ticks);
    }
    *ticks = round(*ticks);
    return true;
}

value step_of(values *v, const formula *f, const value *arguments)
{
    double ticks;
    return ticks_of(v, f->parts[0], &arguments[0], "the time of a step", 0.0, &ticks)
               ? scalar(timed(v->g, OP_FROM, first_tick_of(ticks), 0.0), plain)
               : nothing;
}

/* With a period of a whole number of ticks by counting them, so that no rounding moves an edge: with o ticks of the
 * period over at tick 0, `at` and a rest r < 1, tick n is in the first half where (n + at) mod period < period / 2 - r.
 * Any other period by a phase: an edge that falls on a tick is there and not behind it, as long as the phase is exact
 * to the guard, a part of a turn. */
value square_of(values *v, const formula *f, const value *arguments)
{
    static const double guard = 1e-9;
    const size_t before = v->s->problem_count;
    double turns;
    const double phase =
        f->count == 2 ? constant_fitting(v, f->parts[1], &arguments[1], radian, "the phase", 0.0) / (2 * pi) : 0.0;
    if (!turns_in_tick(v, f->parts[0], arguments[0], &turns) || v->s->problem_count > before) {
        return nothing;
    }
    if (!(turns > 0.0)) {
        return REFUSED(v->s, f->parts[0]->at, "the frequency of a square is larger than zero");
    }
    const double period = 1.0 / turns;
    if (!is_whole_tick(period) || period >= most_repeated) {
        return scalar(timed(v->g, OP_SQUARE_OF_PHASE, turns, phase + guard), plain);
    }
    const double whole = round(period), over = (phase - floor(phase)) * whole;
    const double at = is_whole_tick(over) ? round(over) : floor(over), rest = is_whole_tick(over) ? 0.0 : over - at;
    const double high = first_tick_of(0.5 * whole - rest);
    return scalar(timed_by_index(v->g, OP_SQUARE, whole, fmod(at, whole), (int)high), plain);
}

/* Registers with feedback from two places (ITU-T O.150; of 10, Golomb 1967, Shift Register Sequences). */
static const struct {
    unsigned order, other;
} registers[] = {{7, 6}, {9, 5}, {10, 7}, {11, 9}, {15, 14}};

/* The sequence that the register gives from this state on, of 2^order - 1 bits. */
static uint32_t *bits_of_register(values *v, unsigned order, unsigned other, uint32_t state)
{
    const uint32_t length = (1U << order) - 1;
    uint32_t *words = arena_take(v->s->memory, length / 32 + 1, sizeof *words);
    for (uint32_t i = 0; i < length; i++) {
        const uint32_t last = (state >> (order - 1)) & 1;
        words[i / 32] |= last << (i % 32);
        state = ((state << 1) | (last ^ ((state >> (other - 1)) & 1))) & length;
    }
    return words;
}

value prbs_of(values *v, const formula *f, const value *arguments)
{
    const size_t before = v->s->problem_count;
    const double seed = constant_fitting(v, f->parts[0], &arguments[0], plain, "the seed", 1.0);
    const double order =
        f->count == 3 ? constant_fitting(v, f->parts[2], &arguments[2], plain, "the order", 11.0) : 11.0;
    double hold = 1.0;
    if ((f->count > 1 && !whole_ticks_of(v, f->parts[1], &arguments[1], "the time of a bit", &hold)) ||
        v->s->problem_count > before) {
        return nothing;
    }
    size_t index = 0;
    while (index < COUNT_OF(registers) && registers[index].order != order) {
        index++;
    }
    if (index == COUNT_OF(registers)) {
        return REFUSED(v->s, f->parts[2]->at, "the order of a prbs is 7, 9, 10, 11 or 15");
    }
    const double length = ldexp(1.0, (int)order) - 1.0;
    if (!(seed >= 1.0 && seed <= length && seed == floor(seed))) {
        return REFUSED(v->s, f->parts[0]->at, "the seed of this prbs is a whole number from 1 to %.0f", length);
    }
    if (hold * length >= most_repeated) {
        return REFUSED(v->s, f->parts[1]->at, "the time of a bit is too long: %.0f of them are at most %.0f steps",
                       length, most_repeated - 1.0);
    }
    node root;
    tick_table *result = table_new(v, OP_PRBS, hold, length, &root);
    result->words = bits_of_register(v, registers[index].order, registers[index].other, (uint32_t)seed);
    result->count = (size_t)length / 32 + 1;
    return value_with_table(v, f, root);
}

/* The sine of a phase of n first + n^2 curve turns, up to the end of the sweep; from there on the last frequency. */
value chirp_of(values *v, const formula *f, const value *arguments)
{
    double first, last, ticks;
    if (!turns_in_tick(v, f->parts[0], arguments[0], &first) || !turns_in_tick(v, f->parts[1], arguments[1], &last) ||
        !whole_ticks_of(v, f->parts[2], &arguments[2], "the duration of a chirp", &ticks)) {
        return nothing;
    }
    node angle;
    tick_table *result = table_new(v, OP_CHIRP, 0.0, 0.0, &angle);
    result->first = first;
    result->last = last;
    result->ticks = ticks;
    result->curve = (last - first) / (2.0 * ticks);
    return value_with_table(v, f, sine(v->g, angle));
}
