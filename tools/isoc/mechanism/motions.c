/* Joints whose coordinate is a function of time. */
#include <math.h>

#include "tools/isoc/mechanism/builder.h"

static const double two_pi = 6.28318530717958648;

/* The state that stands for this function of the tick. Within a step it is integrated with the other states, so that a
 * method keeps its order. */
static node clock_of(builder *b, node of_tick, place at)
{
    clocks *c = &b->mechanism.clocks;
    int i = 0;
    while (i < c->count && c->all[i].of_tick != of_tick) {
        i++;
    }
    if (i == c->count) {
        const graph_node n = b->g->nodes[of_tick];
        const double start = operators[n.op].value(b->g, &n, &(evaluation){.tick = 0}, 0.0, 0.0);
        const clock result = n.op == OP_PHASE
                                 ? (clock){of_tick, two_pi * n.value / b->mechanism.method.step, start, "rad", at}
                                 : (clock){of_tick, 1.0, start, "s", at};
        ADD_TO(b->s->memory, c->all, c->count, c->room, result);
    }
    return leaf(b->g, OP_STATE, c->first + i);
}

/* Puts states in the place of functions of the tick. */
static node with_clocks(builder *b, node moving, place at)
{
    for (reached r = reach(b->g, &moving, 1); reach_next(&r);) {
        if (is_timed(b->g, r.at)) {
            moving = replace_leaf(b->g, moving, r.at, clock_of(b, r.at, at));
        }
    }
    return moving;
}

/* The rate of a function of clocks. */
static node rate_of_motion(builder *b, node moving)
{
    node sum = constant(b->g, 0.0);
    for (int i = 0; i < b->mechanism.clocks.count; i++) {
        node derivative;
        differentiate(b->g, &moving, 1, leaf(b->g, OP_STATE, b->mechanism.clocks.first + i), &derivative);
        sum = add(b->g, sum, mul(b->g, constant(b->g, b->mechanism.clocks.all[i].rate), derivative));
    }
    return sum;
}

/* A motion at constant speed, as a phase within one turn plus the rest: it stays as exact after a day as after a
 * second. */
static node as_phase(builder *b, const closure_statement *written, node moving)
{
    graph *g = b->g;
    const node time = timed(g, OP_TIME, 0.0, b->mechanism.method.step);
    node speed;
    differentiate(g, &moving, 1, time, &speed);
    if (!is_constant(g, speed)) {
        source_problem(b->s, written->motion->at,
                       "the motion of the continuous joint '%s' must grow at a constant speed, as in 60 rpm * time; "
                       "for any other, write its speed",
                       written->first.text);
        return moving;
    }
    const double turns = constant_value(g, speed) * b->mechanism.method.step / two_pi;
    if (fabs(turns) > 0.5) {
        source_problem(b->s, written->motion->at,
                       "the motion turns by more than half a turn in a step: use a shorter step");
    }
    const node rest = replace_leaf(g, moving, time, constant(g, 0.0));
    return turns == 0.0 ? rest : add(g, rest, timed(g, OP_PHASE, turns, 0.0));
}

/* The formula as a function of clocks. */
static node function_of_time(builder *b, const formula *f, dimension expected, const char *what)
{
    b->values.time_allowed = b->values.is_smooth = true;
    const node result = scalar_value(b, f, expected, what);
    b->values.time_allowed = b->values.is_smooth = false;
    return result;
}

bool build_motion(builder *b, const closure_statement *written, closure *result)
{
    result->parent.segment = result->child.segment = coordinate_of(b, written->first);
    if ((written->motion == NULL) == (written->speed == NULL)) {
        return source_problem(b->s, written->motion == NULL ? written->name.at : written->speed->at,
                              written->motion == NULL
                                  ? "the closure '%s' has no motion: motion 0.3 rad * sin(2 Hz), or speed 60 rpm"
                                  : "the closure '%s' has a motion, which gives its speed: leave out one of them",
                              written->name.text);
    }
    if (result->parent.segment < 0) {
        return false;
    }
    const segment *first = &b->mechanism.segments[result->parent.segment];
    dimension expected = coordinate_dimension(first);
    if (written->speed != NULL) {
        dimension_times(&expected, second, -1);
        result->in_speed = true;
        result->motion_rate =
            with_clocks(b, function_of_time(b, written->speed, expected, "the speed of this joint"), written->name.at);
    } else {
        result->motion = function_of_time(b, written->motion, expected, "the motion of this joint");
        result->motion = first->continuous ? as_phase(b, written, result->motion) : result->motion;
        result->motion = with_clocks(b, result->motion, written->name.at);
        result->whole = constant(b->g, first->continuous ? 1.0 : 0.0);
        result->motion_rate = rate_of_motion(b, result->motion);
    }
    result->motion_bias = rate_of_motion(b, result->motion_rate);
    return true;
}
