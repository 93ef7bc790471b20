/* Whether the method holds the plant with its step: eigenvalues of the Jacobian against the method's region. */
#ifndef ISOC_STABILITY_STABILITY_H
#define ISOC_STABILITY_STABILITY_H

#include "tools/isoc/plant/plant.h"

/* Looks at the start, at the start with all joints at rest, and from both at the steepest points of each effect. At the
 * first of these where a motion grows by the method alone, warns of each cause, one after the other. Notes a Jacobian
 * that is not finite, where the method needs it. A plant of more than 60 states is not checked, nor the sub-steps of
 * adams, which follow their error. */
void stability_check(source *s, const graph *g, const plant *p);

/* Adds a line to the summary where the size alone kept the plant from that. */
void stability_line(const plant *p, text *out);

/* switching.c: whether an effect switches faster than the step follows: a discontinuity within a step is misplaced by
 * up to half of it, whatever the order of the method. Follows the motion from the start, for up to 10 s or a bounded
 * number of operations, and warns of each effect whose formulas jump so often that half a step at each jump is more
 * than 1 % of their value; so with the comparisons in the `next` of memories, which a row sets. Not checked are
 * implicit methods, whose plant an explicit step does not follow, and adams. */
void switching_check(const source *s, const graph *g, const plant *p);

/* meetings.c: follows the motion likewise, with its events, at times to 1/1000 of a step. Warns of an event that
 * follows others within a step for which there is no slot left; and of one whose function comes down to zero and never
 * passes it. */
void meetings_check(const source *s, const graph *g, const plant *p);

/* course.c: the motion from the start, for up to 10 s or a bounded number of operations. */

/* Some functions of a graph, with their values in this step and in the one before. */
typedef struct functions {
    graph g;
    node *roots;
    bool *switches, any_switch;   /* [nodes] constant but for jumps; whether there is one */
    double *now, *before, *moved; /* [nodes] */
} functions;

typedef struct course {
    const mechanism *m;
    functions drives, plant; /* inputs and clocks; the derivatives, and what is looked at */
    functions nexts;         /* of the memories */
    double **past;           /* [memories][ticks] of those that show what was: the last rows */
    size_t states;
    double *x, *x_before, *u, *u_before, *parameters;
    uint64_t tick, earlier; /* of this step, and of the one before */
    double *stage, *sum;
    double step, evaluated; /* s, of a sub-step; nodes so far */
} course;

/* The motion at its start. roots[count]: the derivatives of the states, then what is looked at. */
course course_of(const graph *g, const plant *p, const node *roots, size_t count);
void course_free(course *w);

bool course_goes_on(const course *w, uint64_t step);

/* The begin of a step: inputs, clocks and tunables, and the values of all nodes there, w->plant.now. */
void course_begin(course *w, uint64_t step);

/* rk4 over a length, from states whose nodes stand in w->plant.now. Returns whether the new states are finite. */
bool course_move(course *w, double length);

/* The values of all nodes; those that switch are as in `kept`, where that is not NULL. */
void course_evaluate(course *w, const functions *f, const evaluation *at, const double *kept, double *numbers);

/* Those of the plant in this step. */
void course_plant(course *w, const double *x, double *numbers);

/* u from the values of the drives; and whether a node that switches has another value than in the step before. */
void course_inputs(const course *w, const double *numbers, double *u);
bool has_switched(const functions *f);

/* meetings.c: the same with its events, with `more` roots behind those of the events, the first of which is at *first.
 * A step from course_begin on: the number of its events, or -1 where states are not finite. */
typedef struct meetings meetings;
meetings *meetings_of(const graph *g, const plant *p, const node *more, size_t count, size_t *first);
course *meetings_course(meetings *k);
int meetings_step(meetings *k, uint64_t step);

/* compared.c: comparisons of a state in the `next` of a memory that the rate of this state reads: a switch that acts on
 * what it looks at, once a step. (That of a controller, which gives an effort, looks once a step by its nature.) */

typedef struct compared {
    bool *acts; /* [states][memories] whether such a memory acts on the rate of such a state */
    double *largest;
    int *near, *longest; /* [nodes of nexts] the steps in which both sides are near each other */
    double *since;       /* s */
} compared;

compared compared_of(const course *w, arena *memory);

/* Puts u[] of these memories back to the row before, where a comparison has changed; whether it has in any. And whether
 * it has in one that acts on this rate. */
bool compared_put_back(const compared *c, const course *w, double *u);
bool compared_has(const compared *c, const course *w, int number);

/* Keeps of each comparison how long its sides are near each other; warns of one whose sides come together, and never
 * pass each other. */
void compared_watch(compared *c, const course *w);
void compared_warn(const compared *c, const source *s, const course *w);

/* moments.c: what the states of one moment, the start or the end of a run, tell of the step and of the number type. */

/* The states at the end of a run of so many ticks, as `build/trace` writes them (state.txt). */
typedef struct moment {
    const char *when; /* at the start */
    const double *x;
    double ticks;
} moment;

/* Looks at the start. */
void pace_check(source *s, const graph *g, const plant *p);

/* Looks at the end of a run, which a file has. Returns false, with a message on stderr, where it is no such file. */
bool ended_check(source *s, graph *g, const plant *p, const char *path);

/* turns.c: warns of each joint that turns by more than half a radian in a step, where the motion depends on its angle.
 */
void turns_check(const source *s, const graph *g, const plant *p, const moment *at);

/* sums.c: warns of each state that changes steadily, and by so little in a step that rounding takes 1 % of it. */
void sums_check(const source *s, const graph *g, const plant *p, const moment *at);

/* energy.c: warns where the energy at the end of a run is another one than at its start, and the scene says that it is
 * not. */
void energy_check(const source *s, graph *g, const plant *p, const moment *end);

/* modes.c: the modes of x' = J x, and whether a method holds them with a step. */

/* slopes.c: the Jacobian of the derivatives as numbers. */

/* J[n n] row by row. A quaternion q counts as three: the rotation about the axes of its parent that moves it, dq = phi
 * q / 2, of which none lets a change of q itself grow; a change of its length is no part of the motion. */
typedef struct slopes {
    int n, positions; /* the first rows are of positions, the others of speeds */
    double *at;
    int infinite;  /* a state whose column is not finite, or -1 */
    bool *is_fast; /* [n] those that take sub-steps of their own, so many of them; 0 sub-steps: none does */
    int fast_count, substeps;
} slopes;

slopes slopes_at(const linearised *l, const double *x, const double *u);

typedef struct modes {
    slopes tangent;
    double *re, *im; /* [of.n] the eigenvalues */
    bool found;
} modes;

modes modes_of(arena *memory, slopes at);

/* The number of modes that grow by the method alone, not by themselves; and the fastest of these. */
int count_growing(const modes *m, unsigned recipe, double step, int *fastest);

/* The largest step without such a mode; infinite where there is no such limit. */
double largest_step(const modes *m, unsigned recipe);

/* The fastest growth by the method alone, however slow. */
typedef struct drift {
    double rate;      /* 1/s: by e in 1 / rate; 0 where nothing does */
    double frequency; /* rad/s */
} drift;

drift drift_of(const modes *m, unsigned recipe, double step);

/* causes.c: causes of stiffness: the effects, the damping and the springs of its joints, springs between points, and
 * the stabilisation of its closures; and the mechanism without one of them. */

typedef struct cause {
    const char *sort, *name; /* effect 'drive' */
    place at;
} cause;

int cause_count(const mechanism *m);

/* Whether there is something to leave out: not of a joint without damping and spring. */
bool is_cause(const graph *g, const mechanism *m, int which);

/* For -1 it is the mechanism itself. */
cause cause_of(const mechanism *m, int which);

/* A mechanism of its own that lacks it: the states of an effect stay, and rest. */
mechanism without_cause(const mechanism *m, graph *g, int which);

/* steepest.c: where an effect is steepest. */

/* The most points that are found for one effect. */
enum { STEEPEST_POINTS = 2 };

typedef struct formulas formulas;

/* The states beside a kink of an effect's formulas (of min, max, abs, sign, a comparison; one state is moved there from
 * x), at which its efforts, forces and rates have the largest slope by a position, and by a speed or a state of an
 * effect: those that are steeper than at x itself. */
typedef struct steepness {
    formulas *effect;
    double steepest[STEEPEST_POINTS]; /* these slopes, or those at x */
    double *points[STEEPEST_POINTS];
    int count; /* of the points */
} steepness;

/* u: inputs and memories. */
steepness *steepness_find(const graph *g, const mechanism *m, int effect, const double *x, const double *u);

/* Whether the way from x to these states, of which one is moved, passes a point of the effect: it is deeper in
 * something there than it need be, as the lower corner of a box is in the ground when an upper one touches it. */
bool is_passed(const steepness *s, const double *x, const double *there);

void steepness_free(steepness *s);

#endif
