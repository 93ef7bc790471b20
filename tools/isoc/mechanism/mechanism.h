/* A scene understood: the tree of segments that the dynamics runs over, its closures, inputs, outputs, step and method.
 *
 * A segment is a body, or nothing, that moves by one elementary joint, with all that is welded to it. Its frame stands
 * on the joint: the joint turns it about, or moves it along, one of its own coordinate axes, so that it needs no more
 * than a plane rotation; or it turns freely, by a unit quaternion. Every other joint is a chain of these: a free one
 * slides along x, y and z, and then turns freely. The user's vectors in body frames are transformed into segment frames
 * here, at compile time.
 *
 * States are the positions of all segments, then their speeds. The speeds of a freely turning segment are its angular
 * velocity relative to its parent, in its own axes.
 */
#ifndef ISOC_MECHANISM_MECHANISM_H
#define ISOC_MECHANISM_MECHANISM_H

#include <math.h>

#include "core/methods/all.h"
#include "core/methods/table.h"
#include "tools/isoc/base/text.h"
#include "tools/isoc/formula/functions.h"
#include "tools/isoc/graph/vector.h"
#include "tools/isoc/scene/names.h"

enum { GROUND = -1 };

/* A body, or several rigidly connected bodies, in the frame of a segment or of the ground. */
typedef struct composite {
    node mass;
    vector ms;      /* first moment, about the frame's origin */
    tensor inertia; /* likewise */
} composite;

/* Where start and speed of a segment come from. */
typedef struct start_origin {
    bool start_given, speed_given;
    bool start_is_rough;           /* not given: the assembly searches from there */
    bool start_found, speed_found; /* moved by the assembly */
    bool start_meets;              /* two ways to assemble it meet at the start */
} start_origin;

typedef struct segment {
    const char *name; /* of the joint, or of its part */
    place at;         /* where it is declared */
    int parent;       /* a segment before this one, or GROUND */
    joint_kind kind;  /* JOINT_REVOLUTE, JOINT_PRISMATIC or JOINT_SPHERICAL */
    int position;     /* its first position among the states: 4 of a spherical joint, else 1 */
    int dof;          /* its first degree of freedom: 3 of a spherical joint, else 1 */
    int axis;         /* 0, 1, 2 */
    double sign;      /* the joint's axis is sign * e_axis */
    double lead;      /* displacement along the axis per radian of a turn */
    bool continuous;
    matrix turn;   /* constant: the segment's axes at coordinate zero, in the parent's axes */
    vector offset; /* the segment's origin at coordinate zero, in the parent's frame */

    composite own; /* with all welded bodies */

    node damping, spring, rest; /* zero where the scene names none */
    node armature;              /* likewise; an inertia to its own speed alone: kg*m^2, or kg */
    int drive;                  /* an input, or -1 */
    double start[4], speed[3];  /* a quaternion is w, x, y, z */
    start_origin origin;        /* of these */
} segment;

/* A degree of freedom: one way in which a segment moves relative to its parent. */
typedef struct dof {
    int segment, axis;
    int before; /* its parent degree of freedom, or GROUND */
    const char *name;
} dof;

/* A force on a segment: of an input along an axis, or of an effect. */
typedef struct applied_force {
    int body, segment;
    int drive;            /* the input, or -1 */
    int effect;           /* then the effect */
    vector point, axis;   /* constant, in the segment's frame */
    node lever;           /* the moment about the force's own line, per newton */
    vector force, moment; /* of an effect; when its motion is known, in the axes of the segment */
    bool in_ground;       /* until then in those of the ground */
} applied_force;

/* A quantity and its operand. In formulas a leaf OP_QUERY stands for each of its numbers, until
 * tools/isoc/tree/point_query.c or, where it is known later, tools/isoc/plant/plant.h puts its value in its place. */
typedef struct query {
    quantity_kind kind;
    int segment;  /* of a coordinate */
    int body;     /* of a body; of the child that a joint loads */
    int closure;  /* of a closure; -1: of none */
    int spring;   /* of a spring between points; -1: of none */
    int effect;   /* of an effect; -1: of none */
    int hold;     /* of a hold: its mode among the states of effects, or their number where it is left out; -1 */
    vector point; /* in the body's frame */
    bool in_body; /* in its axes, not those of the ground */
} query;

enum { QUERY_PARTS = 4 };

/* Whether efforts cannot read it. */
static inline bool is_known_late(quantity_kind kind)
{
    return quantity_rows[kind].known >= KNOWN_WITH_EFFORTS;
}

/* A point whose inertia formulas ask for: that of a body, moved by a vector in the same axes as the answer. A leaf
 * OP_INERTIA stands for each of three components, behind those of the degrees of freedom, until
 * tools/isoc/tree/point_query.c puts its value in its place. */
typedef struct inertia_query {
    int body;
    vector point, beside;
    bool in_body; /* in the axes of the body, not those of the ground */
} inertia_query;

/* One side of a closure: its frame on a segment. */
typedef struct closure_end {
    int body, segment; /* or GROUND */
    matrix turn;
    vector point;
} closure_end;

/* A spring and damper between two points. */
typedef struct point_spring {
    const char *name;
    place at;
    closure_end first, second;
    int base; /* the last common ancestor of both ends, or GROUND */
    node stiffness, damping, length;
} point_spring;

/* A function of the tick that motions depend on. It is a state, set at the beginning of each tick, with a constant rate
 * within it. */
typedef struct clock {
    node of_tick;
    double rate; /* per second */
    double start;
    const char *unit; /* rad or s */
    place at;         /* of the motion that needs it first */
} clock;

typedef struct clocks {
    clock *all;
    int count;
    size_t room;
    int first; /* index of the first one among the states */
} clocks;

/* A loop closure. */
typedef struct closure {
    const char *name;
    place at;
    closure_kind kind;
    closure_end parent, child; /* of a gear or a motion: only the segments, first and second */
    int base;                  /* the last common ancestor of both sides, or GROUND */
    int axis;                  /* 0, 1, 2: of the frames */
    double sign;               /* the closure's axis is sign * e_axis */
    node length;               /* distance; radius; offset of a gear or a motion at the start */
    bool is_disc;              /* of a rolling body: a thin disc, not a ball */
    vector wheel;              /* the axle of a disc, a unit vector in the child's segment */
    node ratio;
    node motion, motion_rate, motion_bias; /* of a motion, its rate and its second derivative */
    node whole;    /* with continuous joints: Phi times this is zero up to whole turns; zero: Phi itself is zero */
    bool in_speed; /* a gear or a motion that constrains only speeds */
} closure;

/* A body with its own mass, for the reactions of joints: without the terms that regroup.c moves between segments. */
typedef struct member {
    const char *joint; /* whose child it is */
    int parent;        /* the parent body, or GROUND */
    vector hinge;      /* the joint's frame on the body, in the segment's */
    composite own;     /* likewise */
} member;

/* Where a body's own frame stands in its segment's (or the ground's). */
typedef struct body_frame {
    int segment;
    matrix turn;
    vector offset;
    bool placed;
} body_frame;

/* The rows in which something is computed: row 0, and those whose number is `phase` more than a multiple of `every`,
 * with 0 <= phase < every. */
typedef struct row_rate {
    double every, phase; /* ticks */
} row_rate;

static const row_rate each_row = {1.0, 0.0};

static inline bool is_slow(row_rate r)
{
    return r.every > 1.0;
}

static inline bool is_same_rate(row_rate a, row_rate b)
{
    return !(a.every < b.every) && !(a.every > b.every) && !(a.phase < b.phase) && !(a.phase > b.phase);
}

/* The content of an output: a quantity, or where its kind is QUANTITY_ROWS a formula. */
typedef struct shown {
    name name;
    query content;
    int along; /* 0, 1, 2: only this component; -1: all */
    value formula;
    const char *unit; /* of a formula */
    row_rate rate;    /* of the rows in which it is computed */
} shown;

static inline bool shows_formula(const shown *o)
{
    return o->content.kind == QUANTITY_ROWS;
}

/* The endings of the names of a formula's numbers: of a vector, a quaternion, or one number. */
static inline const char *formula_components(const value *v)
{
    return v->count == 3 ? "xyz" : v->count == 4 ? "wxyz" : "";
}

/* A quantity of the plant as the header has it. */
typedef struct variable {
    const char *name;         /* in the header in capitals */
    const char *unit;         /* SI */
    const char *quote;        /* the scene's line that declares it; NULL where none does */
    double least, most;       /* infinite where there is no limit */
    double start;             /* of a parameter, its default; of an input of the port, the number nearest to zero */
    dimension dimension;      /* of a parameter */
    const char *display_name; /* of a fault: EFFECT.FAULT */
} variable;

/* A variable without limits. */
static inline variable unlimited(const char *called, const char *in, const char *quote)
{
    return (variable){.name = called, .unit = in, .quote = quote, .least = -HUGE_VAL, .most = HUGE_VAL};
}

/* A state of an effect, or a memory of one: its name, its start, and its rate, or its next. */
typedef struct effect_quantity {
    variable about; /* its start as a number: plant/rows.c */
    place at;       /* of the effect, or of the formula that it keeps */
    int effect;     /* its number */
    node begin, next;
    keeping kept;  /* of a memory */
    row_rate rate; /* likewise: of the rows in which it is set */
    double ticks;  /* the age of a value of a formula, in rows of its rate: 1 for previous */
    bool is_mode;  /* of a state: a whole number, whose rate is zero */
    bool lags; /* of a delay of a moving quantity in the equations: the memory is constant within a step all the same */
} effect_quantity;

/* Whether it is the value of a formula in an earlier row. */
static inline bool is_late(const effect_quantity *e)
{
    return e->kept >= KEPT_PREVIOUS;
}

/* The effort of an effect on a degree of freedom. */
typedef struct effect_effort {
    int effect, dof;
    node effort;
} effect_effort;

/* The energies of an effect; zeros of one that is left out. */
typedef struct effect_account {
    node power;      /* that it gives to the mechanism */
    node stored;     /* energy */
    node loss, work; /* the power that it turns into heat, and that it takes from without: where is_told */
    bool is_told;
} effect_account;

/* A number of an account: the power, the energy, the loss or the work of an effect. */
static inline node account_part(const effect_account *e, quantity_kind kind)
{
    return kind == QUANTITY_POWER_OF_EFFECT    ? e->power
           : kind == QUANTITY_ENERGY_OF_EFFECT ? e->stored
           : kind == QUANTITY_LOSS             ? e->loss
                                               : e->work;
}

/* The value of a parameter from a tick on. */
typedef struct switching {
    double tick;
    int parameter;
    double value;
} switching;

/* A function of time in a formula: its word, and the effect whose definition has it, or only where it stands. */
typedef struct time_input_origin {
    const char *word;
    name origin;
} time_input_origin;

/* An input that comes in over the link. */
typedef struct wire {
    int input;
    double safe, after; /* its value when so many ticks passed without one from the link; 0 ticks: never */
} wire;

/* How the loop runs the plant: core/runtime/policy.h. */
typedef struct policies {
    bool any;
    overrun_kind overrun;
    double catch_up, grace;     /* ticks */
    unsigned rungs[MOST_RUNGS]; /* of a ladder: methods, with the options of the recipe; ISO_METHODS: no step */
    int dropped[MOST_RUNGS];    /* so many of the drops are in force on a rung */
    int rung_count;
    int drops[MOST_RUNGS]; /* effects */
    int drop_count;
    double after; /* good ticks, one rung up again */
    bool delayed, histogram;
} policies;

/* Bodies and frames of the scene. */
typedef struct body_set {
    body_frame *frames; /* of the scene's bodies, then of its frames */
    member *members;    /* of the bodies */
    int count;
    node ground_mass; /* fixed to the ground; for the energy */
    bool vary;        /* states of effects give a mass */
    vector ground_moment;
} body_set;

/* Forces on bodies besides those of joints, closures and effects on joints. */
typedef struct force_set {
    vector gravity;
    point_spring *springs;
    int spring_count;
    applied_force *applied;
    int applied_count;
} force_set;

/* The stabilisation of closures. */
typedef struct drift_control {
    double alpha, beta; /* 1/s, of Baumgarte */
    bool is_redundant;  /* the Schur complement may be singular: augmented Lagrangian */
    double penalty;     /* kg, of the augmented Lagrangian; 0: from the rounding (tools/isoc/closure/augmented.c) */
    int multiplier_iterations; /* of the augmented Lagrangian; else 1 */
    int projections;           /* iterations of the projection after a step */
    double violation_limit;    /* m or rad; 0: none */
    bool near_stops;           /* the guard ends a tick near a singular position of the closures */
    bool near_holds;           /* a step there keeps the energy */
} drift_control;

/* Effects, and the memories of effects and of formulas. */
typedef struct effect_set {
    name *names;
    int *outer; /* [effects] of a part: that which has it, before it; else -1 */
    int count;
    effect_account *accounts; /* [effects] without those of parts */
    effect_quantity *states;  /* behind the clocks */
    int state_count, first_state;
    bool *is_fast;             /* [effects] those whose states take sub-steps in a step */
    int fast_substeps;         /* sub-steps; 0: no effect has any */
    effect_quantity *memories; /* numbers that a row sets, behind the inputs */
    int memory_count;
    node *efforts;         /* [degrees of freedom] of effects: */
    effect_effort *pushes; /* the sums of these */
    int push_count;
    LIST_OF(effect_quantity) derived; /* values of effects that follow from step, method and inertia */
} effect_set;

/* The queries of formulas. */
typedef struct query_set {
    query *all;
    int count;
    size_t room;
    LIST_OF(inertia_query) inertias;
} query_set;

typedef struct input_set {
    int count;
    variable *all;
    bool *driven;       /* inputs that are functions of time; the others are the port's */
    node *drives;       /* the inputs as functions of time, then the clocks */
    double *jumps;      /* the change of an input that restarts the method; 0: none */
    bool *smooth;       /* inputs, and delays in the equations, that are samples of continuous signals */
    int sampled_count;  /* so many of u can be smooth: the inputs; or all, where a delay is smooth */
    int *time_input_of; /* of an input for a function of time in a formula, its index; else -1 */
    time_input_origin *time_inputs;
    int time_input_count;
    wire *wires; /* inputs that come in over the link: all that are not driven, and those that have a safe value */
    int wire_count;
    bool *is_read; /* [inputs and memories that were written] */
    node *edges;   /* functions of the tick in held inputs without a `jump` that jump by themselves */
    int edge_count;
} input_set;

typedef struct parameter_set {
    int count;
    variable *all;
    const double *defaults, *at_start; /* at the start: the defaults, and what is set at 0 s */
    switching *changes;                /* at given ticks, in the order of time */
    int change_count;
    const condition *conditions; /* that a change of a tunable must keep */
    int condition_count;
    bool *is_built_in; /* [count] a number of the plant follows from the default, and stays when the tunable changes */
} parameter_set;

/* What an event sets: a state; a speed by an impulse on its joint, a velocity by one at the point of a body. */
typedef struct event_set {
    int state;  /* -1: of a velocity */
    int dof;    /* of a speed; else -1 */
    node speed; /* the component of a velocity; else -1 */
    node to;
    place at;
} event_set;

/* Whether it is an impulse, by which all speeds change. */
static inline bool is_impulse(const event_set *set)
{
    return set->dof >= 0 || set->speed >= 0;
}

/* It fires where its function falls below zero. */
typedef struct event {
    place at;
    node function;
    event_set *sets;
    int set_count;
    size_t set_room;
} event;

/* A speed, or the difference of two, that an effort up to a limit keeps at zero. */
typedef struct held_speed {
    const char *called;
    place at;
    int effect;          /* -1: of the scene */
    int state;           /* its mode: 0 stuck, 1 and -1 slipping forward and back */
    int dof, against;    /* against -1: the speed alone */
    node limit, sliding; /* efforts, not below zero: that by which it breaks, and that while it slips */
} held_speed;

typedef struct event_list {
    event *all;
    int count;
    size_t room;
    held_speed *holds;
    int hold_count;
    size_t hold_room;
    int slots;      /* events in a step */
    int loss_state; /* the energy that events have taken, where an output asks for it; else -1 */
    unsigned rest;  /* the method of the rest of a step behind one */
} event_list;

typedef struct method_choice {
    unsigned recipe;  /* method and options: core/methods/table.h */
    double tolerance; /* of adams */
    double substeps;  /* its budget in a tick; 0: unlimited */
    double step;      /* s, of a tick */
    int parts;        /* steps of the method in a tick, of equal length; 1 of adams, which has its own */
} method_choice;

typedef struct mechanism {
    const char *name;
    const source *source;
    bool is_double; /* the number type of the plant */
    segment *segments;
    dof *dofs;
    int segment_count, position_count, dof_count;
    body_set bodies;
    force_set forces;
    closure *closures;
    int closure_count;
    drift_control drift;
    clocks clocks; /* of motions: states between the segments' positions and the speeds */
    effect_set effects;
    query_set queries;
    input_set inputs;
    shown *outputs;
    size_t output_count;
    parameter_set parameters;
    policies policies;
    method_choice method;
    event_list events;
} mechanism;

/* Whether anything happens within a step; and where the first of it stands. */
static inline bool has_events(const mechanism *m)
{
    return m->events.count + m->events.hold_count > 0;
}

static inline place place_of_events(const mechanism *m)
{
    return m->events.count > 0 ? m->events.all[0].at : m->events.holds[0].at;
}

/* The step of the method, in s. */
static inline double method_step(const mechanism *m)
{
    return m->method.step / (double)m->method.parts;
}

/* The names of methods in a scene. */
extern const char *const method_names[ISO_METHODS];

/* Positions and degrees of freedom of an elementary joint. */
static inline int positions_of(joint_kind kind)
{
    return kind == JOINT_SPHERICAL ? 4 : 1;
}

static inline int dofs_of(joint_kind kind)
{
    return kind == JOINT_SPHERICAL ? 3 : 1;
}

static inline int state_count(const mechanism *m)
{
    return m->position_count + m->dof_count;
}

/* Whether this state takes sub-steps of its own. */
static inline bool is_fast_state(const mechanism *m, int state)
{
    const int i = state - m->effects.first_state;
    return m->effects.fast_substeps > 0 && i >= 0 && i < m->effects.state_count &&
           m->effects.is_fast[m->effects.states[i].effect];
}

/* Quantities that are constant within a step: inputs and memories. */
static inline int held_count(const mechanism *m)
{
    return m->inputs.count + m->effects.memory_count;
}

/* roots.c: a number of the account of an effect with all its parts. */
node account_with_parts(graph *g, const effect_set *all, int effect, quantity_kind kind);

/* Does something to each list of nodes that formulas of effects and outputs are. */
typedef void root_visitor(graph *g, node *roots, size_t count, void *context);
void for_roots(graph *g, const mechanism *m, bool with_memories, root_visitor *visit, void *context);

/* The unit of a quantity: a coordinate that turns has another than one that slides. */
const char *query_unit(const mechanism *m, const query *q);

/* states.c: the states of a plant, in their order, with the facts that the equations, the header, the guard and the
 * stream use. */

typedef enum state_kind {
    STATE_COORDINATE, /* of a joint: an angle or a distance */
    STATE_TURN,       /* an angle that is kept within a turn, its whole turns beside it */
    STATE_QUATERNION, /* a part of one: w, x, y, z */
    STATE_CLOCK,      /* that a motion is a function of; every tick sets it */
    STATE_OF_EFFECT,
    STATE_SPEED,
} state_kind;

typedef struct state {
    variable about; /* within its limits, or the guard stops the plant */
    state_kind kind;
    const char *symbol; /* in the equations */
    place at;           /* of the joint, the motion or the effect that has it */
} state;

/* All states: state_count(m). Their starts are the present ones: the assembly of closed loops moves them. */
const state *mechanism_states(const mechanism *m, arena *memory);

/* Their names, each where its owner is declared; and notes those that two of them have, or that differ only in case. */
name_list names_of_states(source *s, const mechanism *m);
void states_check(source *s, const mechanism *m);

/* Row 0. The states; the value of an input, for the number of its function of time, within its limits, or of the port;
 * the values of inputs and memories; all of these, with the tunables; and the numbers of all nodes by that. */
double *mechanism_start(const mechanism *m, arena *memory);
double input_in_row(const mechanism *m, int input, double drive);
double *inputs_at_start(const graph *g, const mechanism *m);
evaluation start_of(const graph *g, const mechanism *m);
double *numbers_at_start(const graph *g, const mechanism *m);

/* A number of the plant follows from the values of these nodes at the start: the tunables that they read are built in.
 */
void note_built_in(const graph *g, const mechanism *m, const node *roots, size_t count);

#endif
