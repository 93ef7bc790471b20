#include "tools/isoc/stability/modes.h"

#include <math.h>

#include "core/numbers/noise.h"
#include "core/numbers/waveform.h"

static const double whole_turn = 6.283185307179586476925;

static double fraction(double turns)
{
    return turns - floor(turns);
}

/* The phase of a sweep in turns: from its end on, the last frequency. */
static double turns_of_chirp(const tick_table *t, double tick)
{
    const double within = fmin(tick, t->ticks);
    return within * t->first + within * within * t->curve + (tick - within) * t->last;
}

static double value_of_lines(const tick_table *t, uint64_t tick)
{
    return iso_on_lines(tick, &(iso_lines){t->words, t->values, t->slopes, (uint32_t)t->count});
}

double tick_function(const mechanism *m, const graph_node *n, uint64_t tick)
{
    const double now = (double)tick, first = n->value, second = n->second;
    const uint32_t whole = (uint32_t)floor(first), other = (uint32_t)floor(second);
    switch (n->op) {
    case OP_PHASE:
        return whole_turn * (fraction(second + now * first + 0.5) - 0.5);
    case OP_RAMP:
        return fmin(fmax(now - first, 0.0), second);
    case OP_NOISE:
        return iso_noise(tick, whole);
    case OP_TIME:
        return second * now;
    case OP_FROM:
        return iso_from(tick, whole);
    case OP_SQUARE:
        return iso_square(tick, whole, other, (uint32_t)n->index);
    case OP_SQUARE_OF_PHASE:
        return fraction(second + now * first) < 0.5 ? 1.0 : -1.0;
    case OP_PRBS:
        return iso_prbs(tick, m->inputs.tables[n->index].words, whole, other);
    case OP_CHIRP:
        return whole_turn * (fraction(turns_of_chirp(&m->inputs.tables[n->index], now) + 0.5) - 0.5);
    case OP_LINES:
        return value_of_lines(&m->inputs.tables[n->index], tick);
    case OP_SINCE:
        return second * iso_since(tick, whole, first - floor(first));
    default:
        return 0.0;
    }
}
