/* Shares of a step. A function g of a condition that holds where g < 0 goes, to second order, on a straight line from g
 * at the begin of the step to g + h g' at its end. So the part of the step in which it holds is
 *
 *     s = (max(-begin, 0) + max(-end, 0)) / (|begin| + |end|),
 *
 * exactly 1 or 0 where g does not pass zero: the last s of the step where g falls, else the first. */
#include "tools/isoc/formula/condition.h"

#include <math.h>
#include <string.h>

#include "tools/isoc/formula/scalar.h"
#include "tools/isoc/formula/ticks.h"

static node end_of(graph *g, node f)
{
    return add(g, f, function(g, OP_CHANGE, f, f));
}

static node part_below_zero(graph *g, node begin, node end)
{
    static const double least = 1e-30; /* where both ends are zero it does not hold */
    const node below = function(g, OP_POSITIVE, neg(g, begin), 0);
    const node part = add(g, below, function(g, OP_POSITIVE, neg(g, end), 0));
    const node size = magnitude(g, begin);
    const node all = add(g, size, magnitude(g, end));
    return divide(g, part, larger(g, all, constant(g, least)));
}

/* Adds them to those before; -1 after noting a problem. */
static int add_functions(values *v, const formula *f, int count, node *functions)
{
    if (f->kind == FORMULA_LOGIC && f->sign == '&') {
        const int left = add_functions(v, f->parts[0], count, functions);
        return left < 0 ? -1 : add_functions(v, f->parts[1], left, functions);
    }
    if (f->kind != FORMULA_ORDER || f->sign == '=' || count == MOST_COMPARED) {
        source_problem(v->s, f->at,
                       "a share is of comparisons by < or >, up to %d joined by 'and': share(x < 1 mm and y > 0 m); of "
                       "two that exclude each other it is the sum of two shares, and of 'not' 1 - share",
                       MOST_COMPARED);
        return -1;
    }
    const value found = condition_function(v, f);
    functions[count] = found.parts[0];
    return found.count == 0 ? -1 : count + 1;
}

int share_functions(values *v, const formula *f, node *functions)
{
    return add_functions(v, f, 0, functions);
}

/* Where the part of each begins and ends; they hold together from the last begin to the first end. */
node share_of(graph *g, const node *functions, int count)
{
    const node one = constant(g, 1.0);
    node from = constant(g, 0.0), to = one;
    for (int i = 0; i < count; i++) {
        const node end = end_of(g, functions[i]), part = part_below_zero(g, functions[i], end);
        if (count == 1) {
            return part;
        }
        const node falls = above(g, functions[i], end);
        const node begin = function(g, OP_WHERE, falls, sub(g, one, part));
        const node rising = function(g, OP_UNLESS, falls, part);
        from = larger(g, from, begin);
        to = function(g, OP_MIN, to, add(g, rising, function(g, OP_WHERE, falls, one)));
    }
    return function(g, OP_POSITIVE, sub(g, to, from), 0);
}

/* The duty as a number of steps. */
static node high_steps(graph *g, node duty, double period)
{
    const node limited = function(g, OP_MIN, function(g, OP_POSITIVE, duty, 0), constant(g, 1.0));
    return mul(g, constant(g, period), limited);
}

/* On up to the duty of this period, and from the begin of the next one up to the duty of that. */
node share_of_wave(graph *g, node duty, node over, double period)
{
    const node high = high_steps(g, duty, period), high_at_end = high_steps(g, end_of(g, duty), period);
    const node next = sub(g, over, constant(g, period)), end = end_of(g, over), next_end = end_of(g, next);
    const node low = sub(g, over, high), next_low = sub(g, next, high);
    const node here = part_below_zero(g, low, sub(g, end, high_at_end));
    const node there = part_below_zero(g, next_low, sub(g, next_end, high_at_end));
    const node before = part_below_zero(g, next, next_end);
    return add(g, here, sub(g, there, before));
}

bool is_wave(const formula *f)
{
    return f->kind == FORMULA_CALL && strcmp(f->name, "pwm") == 0;
}

double wave_period(values *v, const formula *f)
{
    const size_t before = v->s->problem_count;
    const double ticks = value_constant(v, f->parts[1], second, "the period of a pwm", v->step) / v->step;
    if (v->s->problem_count > before) {
        return 0.0;
    }
    if (!(ticks >= 1.0 || is_whole_tick(ticks)) || !(ticks <= most_ticks)) {
        source_problem(
            v->s, f->parts[1]->at,
            "the period of a pwm is a step of %g s or longer: what switches faster acts by its mean, the duty",
            v->step);
        return 0.0;
    }
    return is_whole_tick(ticks) ? round(ticks) : ticks;
}

value wave_over(values *v, const formula *f)
{
    const double period = wave_period(v, f);
    const double phase = f->count == 3 ? value_constant(v, f->parts[2], radian, "the phase", 0.0) / (2 * pi) : 0.0;
    const node part = timed(v->g, OP_CYCLE, period > 0.0 ? 1.0 / period : 1.0, phase);
    return period > 0.0 ? scalar(mul(v->g, constant(v->g, period), part), plain) : nothing;
}
