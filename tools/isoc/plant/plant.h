/* The plant as nodes: derivative, outputs, what an implicit method solves with, and what follows a step. */
#ifndef ISOC_PLANT_PLANT_H
#define ISOC_PLANT_PLANT_H

#include "tools/isoc/dynamics/dynamics.h"
#include "tools/isoc/dynamics/settled.h"
#include "tools/isoc/graph/operations.h"
#include "tools/isoc/implicit/jacobian.h"
#include "tools/isoc/plant/fast.h"
#include "tools/isoc/plant/held.h"

/* The cost of the equations in each formulation that was tried, and which one is kept. */
typedef struct choice {
    formulation kept;
    bool tried[FORMULATIONS];
    operations of[FORMULATIONS];
} choice;

/* How long a run is that isoc looks ahead for, s: as long as `make run` runs a scene that does not say otherwise. */
static const double life = 10.0;

/* States and memories in the order in which they are set; those of one level follow from those of the levels before. A memory
 * is told from a state by its number, which begins behind those of the states. */
typedef struct row_order {
    int *all, *level;
    int count, levels;
} row_order;

/* The assignments of a row besides the memories of effects (tools/isoc/plant/rows.h). */
typedef struct row_plan {
    node *sees; /* [inputs] what an input that is a function of time is in the row, within its limits, where a memory or
                         an output reads it; else -1 */
    bool *
        sees_again; /* [inputs] one of these that is not what the step gets: that checks its limits or reads tunables */
    bool any;       /* there is one, or something is set at a time */
    row_order early, late; /* samples, before the memories of effects and after */
    row_order starts;
} row_plan;

/* A plant on the lower rungs of a ladder that drops effects: on the memory of the whole, with a graph of its own. */
typedef struct reduced_plant {
    const struct plant *p;
    graph *g;
    const char *suffix; /* of the names of its functions: _without_rub */
} reduced_plant;

/* Its outputs, one for each component of what the scene shows. */
typedef struct output_set {
    int count;
    const char **names, **units;
    const shown **shows; /* what of */
    node *roots;
} output_set;

/* All that is known of a plant when its equations are nodes. */
typedef struct plant {
    const mechanism *m;
    const dynamics *d;
    choice formulations;
    int turn_count;
    output_set outputs;
    node *derivatives;           /* the derivative of each state */
    int rate_count;              /* of them those that semi_implicit evaluates again; 0: they are the speeds */
    settled after;               /* of a step */
    acceleration *accelerations; /* of the segments, where reactions of joints are shown */
    factoring factors;           /* as wanted */
    jacobian j;                  /* only for implicit methods */
    bool is_curved;              /* for rosenbrock: the derivatives are not affine in the smooth inputs */
    bool is_flat;                /* a step is small: its calls are inlined */
    held held;                   /* what the step computes once */
    node *held_derivatives;      /* the derivatives by that; where nothing is held, themselves */
    fast_part fast;              /* of these derivatives: the states with sub-steps of their own */
    row_plan rows;               /* what each row sets */
    node energy;                 /* -1 until something asks for it */
    node violation;              /* of the closures, where the loop counts it; else -1 */
    node broken;                 /* how many conditions the tunables break; -1: there are none */
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

#endif
