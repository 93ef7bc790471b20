#include "tools/isoc/stability/stability.h"

#include <float.h>
#include <math.h>

/* The part of its growth that a sum may lose; and what it may lose besides, in units of its last place times the root
 * of the number of its steps: four times what roundings in both directions come to. */
static const double most_lost = 2e-3, most_at_random = 2.0;

/* A sum is followed for so many steps from a moment; one that does not leave its last place, for so few. */
enum { FOLLOWED = 10000, STUCK = 100 };

static double *rates_at(const graph *g, const plant *p, const double *x)
{
    const size_t states = (size_t)state_count(p->m);
    double *numbers = arena_take(g->memory, g->count, sizeof *numbers);
    double *rates = arena_take(g->memory, states + 1, sizeof *rates);
    graph_evaluate(g, 0, &(evaluation){.x = x, .u = inputs_at_start(g, p->m), .p = p->m->parameters.defaults}, numbers);
    for (size_t i = 0; i < states; i++) {
        rates[i] = numbers[p->derivatives[i]];
    }
    return rates;
}

/* Whether a state is a plain sum of increments whose rate is known at this moment: that of a coordinate is a state, and
 * any other reads inputs and memories, which are known at the start. */
static bool is_sum(const plant *p, const state *which, bool is_start)
{
    return which->kind == STATE_COORDINATE ||
           ((which->kind == STATE_SPEED || which->kind == STATE_OF_EFFECT) && (is_start || held_count(p->m) == 0));
}

/* A sum in float: its growth in a step on average, and the part of it that is lost, of either sign. */
typedef struct growth {
    double grown, lost;
} growth;

/* Adds increments in float, while their rate changes evenly from one value to another. */
static growth follow_sum(double from, double rate, double later, double step)
{
    float sum = (float)from;
    double grown = 0.0;
    for (int i = 0; i < FOLLOWED; i++) {
        const double increment = step * (rate + (later - rate) * (double)i / FOLLOWED);
        sum = (float)(sum + (float)increment);
        grown += increment;
    }
    return (growth){grown / FOLLOWED, (grown - ((double)sum - (double)(float)from)) / FOLLOWED};
}

/* Whether one is between half and twice the other. */
static bool is_alike(double rate, double other)
{
    return rate / other > 0.5 && rate / other < 2.0;
}

/* Whether the sum loses what is not random. */
static bool is_losing(const growth *sum, double size)
{
    const double lost = fabs(sum->lost), last_place = (double)FLT_EPSILON * fabs(size);
    return lost > most_lost * fabs(sum->grown) && FOLLOWED * lost > most_at_random * sqrt(FOLLOWED) * last_place;
}

/* Whether no step of the next ones leaves the last place of the sum, while its rate stays alike, and is more than a
 * small part of that on average: what creeps between leaps loses its way. */
static bool is_stuck(double from, double rate, double soon, double mean, double step)
{
    const float sum = (float)from;
    const bool stays = sum + (float)(step * rate) == sum && sum + (float)(step * soon) == sum;
    return stays && is_alike(rate, soon) && fabs(rate) > most_lost * fabs(mean);
}

static double *rates_ahead(const graph *g, const plant *p, const moment *at, const double *rates, int steps)
{
    const size_t count = (size_t)state_count(p->m);
    double *ahead = list_copy(g->memory, at->x, count, sizeof *ahead);
    for (size_t i = 0; i < count; i++) {
        ahead[i] += steps * method_step(p->m) * rates[i];
    }
    return rates_at(g, p, ahead);
}

void sums_check(const source *s, const graph *g, const plant *p, const moment *at)
{
    const mechanism *m = p->m;
    const size_t count = (size_t)state_count(m);
    if (p->is_double || ISO_IS_COMPENSATED(m->method.recipe)) {
        return;
    }
    const state *states = mechanism_states(m, g->memory);
    const double *first = mechanism_start(m, g->memory), *begun = rates_at(g, p, first), *rates = rates_at(g, p, at->x);
    const double *later = rates_ahead(g, p, at, rates, FOLLOWED), *soon = rates_ahead(g, p, at, rates, STUCK);
    for (size_t i = 0; i < count; i++) {
        const double step = method_step(m) / (is_fast_state(m, (int)i) ? (double)m->effects.fast_substeps : 1.0);
        const double mean = (at->x[i] - first[i]) / (at->ticks * m->method.step);
        const bool is_steady =
            is_alike(rates[i], later[i]) && (is_alike(rates[i], begun[i]) || is_alike(rates[i], mean));
        const bool stuck = states[i].kind == STATE_COORDINATE && is_stuck(at->x[i], rates[i], soon[i], mean, step);
        const growth sum =
            stuck ? (growth){step * rates[i], step * rates[i]} : follow_sum(at->x[i], rates[i], later[i], step);
        if (stuck || (is_steady && is_sum(p, &states[i], at->ticks == 0.0) && is_losing(&sum, at->x[i]))) {
            source_warn(s, states[i].at,
                        "'%s' is %.4g %s %s and grows by %.3g %s in a step of %.4g ms, of which rounding in float "
                        "takes %.3g %%; take `compensated yes`, or --real double",
                        states[i].about.name, at->x[i], states[i].about.unit, at->when, sum.grown, states[i].about.unit,
                        1e3 * step, 100.0 * sum.lost / sum.grown);
        }
    }
}
