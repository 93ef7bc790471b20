/* The plant as nodes: derivative, outputs, the matrix of an implicit method, and the corrections after a step. */
#ifndef ISOC_PLANT_PLANT_H
#define ISOC_PLANT_PLANT_H

#include "tools/isoc/base/text.h"
#include "tools/isoc/implicit/jacobian.h"

/* fast.c: the states that take sub-steps of their own in a step, and the other states that their derivatives read, for
 * core/methods/multirate.h. */

typedef struct fast_part {
    int *states;
    int count; /* 0: none do */
    int *reads;
    int read_count;
    node *derivatives; /* of these states */
} fast_part;

/* The fast part, from the derivatives of all states. */
fast_part fast_build(const graph *g, const mechanism *m, const node *derivatives);

/* held.c: values that do not change within a step stand in an array h for all evaluations of the derivative. Those that
 * follow from tunables alone are computed when a tunable changes; behind them are those that a step computes once, from
 * these, held inputs and memories. */

typedef struct held {
    node *values; /* h: of tunables, then of h, inputs and memories */
    int tuned;    /* how many are of tunables alone */
    int count;    /* 0: nothing is held, as that would not pay */
} held;

/* Puts leaves OP_HELD into the roots, where that pays in a step with so many evaluations of them. */
held held_build(graph *g, const mechanism *m, node *roots, size_t count, int evaluations);

/* The cost of the equations in each formulation that was tried, and which one is kept. */
typedef struct formulation_costs {
    formulation kept;
    bool tried[FORMULATIONS];
    operations costs[FORMULATIONS];
} formulation_costs;

/* The length of the run that isoc looks ahead for, s: that of `make run` for a scene that gives no other. */
static const double life = 10.0;

/* States and memories in the order in which they are set; those of one level follow from those of the levels before.
 * The numbers of memories begin behind those of the states. */
typedef struct row_order {
    int *all, *level;
    int count, levels;
} row_order;

/* The assignments of a row besides the memories of effects (tools/isoc/plant/plant.h). */
typedef struct row_plan {
    node *sees; /* [inputs] the value in the row of an input that is a function of time, within its limits, where a
                   memory or an output reads it; else -1 */
    bool *sees_again;      /* [inputs] such a value that differs from that of the step: by its limits, or by tunables */
    bool any;              /* there is one, or something is set at a time */
    row_order early, late; /* samples, before the memories of effects and after */
    row_rate *sees_at;     /* [inputs] the rows in which such a value is read */
    int *coming;           /* [memories] the place where its next value waits until all are known; -1: it need not */
    int coming_count;
    row_order starts;
} row_plan;

/* A plant on the lower rungs of a ladder that drops effects: on the memory of the whole, with a graph of its own. */
typedef struct reduced_plant {
    const struct plant *p;
    graph *g;
    const char *suffix; /* of the names of its functions: _without_rub */
} reduced_plant;

/* Its outputs, one for each component of the scene's outputs. */
typedef struct output_set {
    int count;
    const char **names, **units;
    const shown **shows; /* the output of the scene */
    node *roots;
} output_set;

/* Angles whose sines and cosines the derivative has. */
typedef struct sine_states {
    int *all;    /* [count] states */
    bool *spins; /* [count] of a continuous joint, which may turn far in a step */
    int count, spin_count;
    int unread; /* the number of first states that the derivative reads by sines and cosines alone, or not at all */
} sine_states;

/* Angles within a turn, and of which of them that is kept which rounding takes from them (turns.c). */
typedef struct rests {
    bool *kept; /* [segments] */
    int count;
    int turn_count; /* of all such angles */
} rests;

/* events.c: the events as nodes. */
typedef struct event_plan {
    node *functions; /* [2 events] of each its function, and its rate over the derivatives of the states */
    bool *moves;     /* [events] whether it sets something that its function reads */
    int *reads;      /* the states that the functions read, of one event after the other, */
    int *ends;       /* [events] and where those of each end */
    int set_count;
    int *states, *owners; /* [sets] a state, and the event that sets it to */
    node *values;         /* [sets] this */
    node *hold_numbers;   /* [ISO_HOLD_NUMBERS] of core/methods/hold.h, where there are holds */
} event_plan;

/* All that is known of a plant when its equations are nodes. */
typedef struct plant {
    const mechanism *m;
    const dynamics *d;
    formulation_costs formulations;
    rests rests;
    output_set outputs;
    node *derivatives; /* the derivative of each state */
    int rate_count;    /* of them those that semi_implicit evaluates again; 0: they are the speeds */
    settled after;     /* of a step */
    event_plan events;
    acceleration *accelerations; /* of the segments, where reactions of joints are shown */
    factoring factors;           /* as wanted */
    jacobian j;                  /* only for implicit methods */
    bool is_curved;              /* for rosenbrock: the derivatives are not affine in the smooth inputs */
    bool is_flat;                /* a step is small: its calls are inlined */
    held held;                   /* values that the step computes once */
    node *held_derivatives;      /* the derivatives by that; where nothing is held, themselves */
    sine_states angles;          /* where the method takes those of a stage from those of the start of the step */
    fast_part fast;              /* of these derivatives: the states with sub-steps of their own */
    row_plan rows;               /* the assignments of each row */
    node energy;                 /* -1 until something asks for it */
    node violation;              /* of the closures, where the loop counts it; else -1 */
    node broken;                 /* the number of conditions that the tunables break; -1: there are none */
    bool is_double;
    reduced_plant *reduced_plants; /* of a program: without the first drop of its ladder, without the first two, ... */
    int reduced_plant_count;
} plant;

/* Choices of the command line that replace those of isoc. */
typedef struct build_options {
    formulation formulation; /* FORMULATIONS: the cheapest */
    factoring factors;       /* FACTORINGS: that which suits the size */
} build_options;

/* The derivative of each state alone. */
const dynamics *derivatives_build(graph *g, const mechanism *m, formulation chosen, node *derivatives);

/* The nodes of derivative, outputs and all else. */
plant plant_build(graph *g, const mechanism *m, bool is_double, build_options wanted);

/* angles.c: the states whose sine or cosine these roots have; and those of them whose sines stages take from the start
 * of the step. */
const bool *turned_states(const graph *g, const mechanism *m, const node *roots, size_t count);
sine_states angles_build(const graph *g, const mechanism *m, const node *derivatives);

/* turns.c: which joints that turn without limit have a rest, where this is what a step puts right. */
rests rests_find(const graph *g, const mechanism *m, const settled *after);

/* kept.c: the projection after a step needs factors of the mass matrix and of the closures, which the last stage of the
 * step has computed at states that are near: where it can, it keeps them. */

/* Where it keeps them, p->after reads them, and lists them. */
void keep_factors(plant *p, graph *g);

/* outputs.c: the rates of outputs: which are computed in each tick, and which in every fourth. */

/* The outputs of one rate. */
typedef struct output_rate {
    row_rate rate;
    int *which;  /* [count] outputs of the plant */
    node *roots; /* [count] */
    int count;
} output_rate;

typedef struct output_rates {
    output_rate *all; /* the fastest first */
    int count;
} output_rates;

output_rates output_rates_of(const plant *p, arena *memory);

/* Whether some output is not computed in each tick; and the same of memories. */
bool has_slow_outputs(const mechanism *m);
bool has_slow_memories(const mechanism *m);

/* rates.c: what is computed at a rate slower than that of the rows. */

/* every_5_at_2, every_4 */
const char *rate_words(arena *memory, row_rate rate);

/* The operations of one rate, behind the step. */
typedef struct rate_cost {
    row_rate rate;
    operations in_a_row;
} rate_cost;

typedef LIST_OF(rate_cost) rate_costs;

/* Of each rate: memories and outputs. Those of each row are the first. */
rate_costs rate_costs_of(const plant *p, const graph *g, arena *memory);

/* Of so many rows, without row 0, the first with the most operations; and these. */
enum { MOST_ROWS = 100000 };

typedef struct dearest_row {
    double row;
    operations in_it;
} dearest_row;

dearest_row dearest_row_of(const rate_costs *all);

/* rows.c: the assignments of a row in their order: the functions of time, then the memories, then the outputs. Row k
 * is the time k h.
 *
 *     functions of time that a memory or an output reads, at the row
 *     values of previous and delay, from an earlier row
 *     samples that a next reads
 *     all memories of effects, by their next
 *     all other samples, of the memories as they are now
 *     values of the formulas in this row, which previous and delay will show
 *
 * At the start states and memories of effects get their starts, each after those that it reads, and so do the samples
 * and the pasts. */

/* Sets p->rows, and the starts as numbers. Of a reduced plant `whole` is the plant with
 * all effects, whose functions of time it reads; else NULL. Notes a start or a sample that needs itself. */
void rows_build(source *s, graph *g, plant *p, const plant *whole);

/* quantities.c: the nodes of quantities: of those that outputs show, and of those that formulas ask for and that are
 * known with the accelerations, or after a step. */

/* The numbers of a quantity. */
void quantity_nodes(plant *p, graph *g, const query *q, node parts[QUERY_PARTS]);

/* Puts those that are known late in the place of the leaves that stand for them. */
void late_queries_resolve(plant *p, graph *g);

/* outputs.c: the nodes of the outputs, with their names and units. Fills p->outputs from p->m and p->d. */
void outputs_build(plant *p, graph *g);

/* roots[states + outputs]: these derivatives, and so many outputs, which show them as accelerations. */
void list_roots(graph *g, const plant *p, const node *derivatives, int outputs, node *roots);

/* reduced_plant.c: the plant on the rungs of a ladder that drop effects. */

/* The plant on a rung, counted from 0; NULL where nothing is dropped. The recipe of its step, and the suffix of the
 * step's name: _heun_without_rub. */
const reduced_plant *reduced_plant_on_rung(const plant *p, int rung);
unsigned rung_recipe(const plant *p, int rung);
const char *rung_suffix(const plant *p, int rung, arena *memory);

/* linearised.c: the slopes of formulas by the states. */

/* The values of some nodes, as of the derivatives, and the change of each with the changes of the states, which are
 * inputs behind those of the plant. */
typedef struct linearised {
    const mechanism *m;
    graph g;
    node *values, *changes;
} linearised;

linearised linearise(const graph *g, const mechanism *m, const node *roots, size_t count);

/* The change of a state with one coordinate of a smaller set: a quaternion's four states with three rotations about the
 * axes of its parent, each other state with one coordinate. All that are not zero. */
typedef struct turning {
    int state, reduced;
    const segment *quaternion; /* of a segment that turns freely; else NULL */
    double factor, back;       /* and this one with it */
} turning;

typedef struct turnings {
    turning *all;
    int count, reduced; /* of them, and of the smaller set */
} turnings;

turnings turnings_at(const mechanism *m, arena *memory, const double *x);

/* shares.c: the formulas of shares, with the changes of the values in a step by the derivatives. How many of the
 * memories are shares, and the operations of them. */
void shares_build(const plant *p, graph *g);
int count_shares(const mechanism *m);
operations cost_of_shares(const plant *p, const graph *g);

/* Sets p->events. Evaluations of the derivative by the events of a step; and all operations of them. */
void event_plan_build(plant *p, graph *g);
int evaluations_of_events(const mechanism *m);
operations cost_of_events(const plant *p, const graph *g);

/* cost.c: the cost of a step: operations of the equations, of the method, and of the corrections after it. */

/* The cost of a step without the corrections after the method (tools/isoc/dynamics/dynamics.h); and of these. */
operations cost_of_step(const plant *p, const graph *g);
operations cost_of_settling(const plant *p, const graph *g);

/* The cost of solving with 1 - hb J, of an implicit method. */
typedef struct implicit_cost {
    operations factor, solve;
} implicit_cost;

implicit_cost cost_of_solving(const plant *p, const graph *g);

/* summary.c: the summaries of a plant and of the methods that isoc prints. */

/* Lines `key value...` about one plant. */
void write_summary(const plant *p, const graph *g, text *out);

/* One line for each method: order, evaluations, Jacobians and solutions a step, vectors of n reals kept from step to
 * step, without and with a check. */
void write_methods(text *out);

/* checks.c: the checks of a plant: that it is useful at its start. */

/* check_start.c: notes the joint whose motion moves no inertia, so that the mass matrix is singular and there is no
 * acceleration; and why the derivative at the start is not finite in the plant's own real: a closure that is lost by
 * rounding, or a joint whose derivative overflows. */
void pivots_check(source *s, const graph *g, const plant *p);
void start_check(source *s, const graph *g, const plant *p);

/* check_range.c: notes a constant of the equations that the plant's type cannot hold: a product of numbers that it can,
 * such as a mass and a square of a length. */
void range_check(source *s, const graph *g, const plant *p);

/* input_check.c: warns where held inputs lower the order of a method, as one with a history takes its inputs for
 * samples of a smooth curve: of the first input that is held there, or whose extrapolation the local error does not
 * see; and of the first function of time in a formula that the derivative depends on, by itself or through memories:
 * noise, say. */
void samples_check(const source *s, const graph *g, const scene *written, const plant *p);

#endif
