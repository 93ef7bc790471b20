/* The linear model of a plant about a point: d' = A d + B v, w = C d + D v, with d, v and w the deviations of states,
 * inputs and outputs. Memories, and states that are time itself, keep the values that they have at the point.
 *
 * d stands in coordinates that are independent: three small angles in the place of a quaternion, and in closed loops
 * only those positions and speeds from which the others follow. */
#ifndef ISOC_LINEAR_LINEAR_H
#define ISOC_LINEAR_LINEAR_H

#include "tools/isoc/plant/plant.h"

/* A point: states, inputs with memories behind them, tunables. */
typedef struct point {
    double *x, *u, *p;
} point;

/* expansion.c: the formulas of a plant and their derivatives, as nodes and as numbers. */

typedef struct expansion {
    const plant *p;
    int states, inputs, outputs, gaps; /* gaps: of the closures, positions */
    int roots;                         /* rates of the states, outputs, gaps, rates of the gaps */
    linearised l;                      /* of them */
    node *by_input;                    /* [inputs][roots] */
} expansion;

/* All roots; without `is_whole` the rates alone, of these derivatives, which may be those of another mechanism. */
expansion expand(const graph *g, const plant *p, const node *derivatives, bool is_whole);

point point_copy(arena *memory, const expansion *e, const point *at);

/* numbers[roots] at a point of e->l.values, of their changes with an input at e->by_input + input * roots, or of
 * e->l.changes with the states along[states]; NULL: there are none in the nodes. */
void numbers_at(const expansion *e, const point *at, const double *along, const node *nodes, double *numbers);

/* chart.c: the small coordinates of the states, and of these the independent ones. */

/* One small coordinate. */
typedef struct coordinate {
    const char *name, *unit;
    const char *meaning;
    const char *whose; /* body 'rod', effect 'drive' */
    int state;         /* -1: a small angle */
    int segment;       /* -1: of an effect */
    bool is_speed;
} coordinate;

typedef struct chart {
    int states, all, count;  /* states, small coordinates, and the independent ones of these */
    coordinate *coordinates; /* [all] */
    int *chosen;             /* [count] which of them */
    double *turn, *back;     /* [states][all] and [all][states]: states by small coordinates, and the other way */
    double *basis;           /* [all][count]: small coordinates by the independent ones */
} chart;

/* The chart at a point; `count` is that of all until chart_choose. */
chart chart_at(const mechanism *m, const scene *written, arena *memory, const double *x);

/* Chooses independent coordinates: slopes[rows][all] are those of the constraints, of which the first `positions` rows
 * are of positions alone. Joints that an input or an effect moves stay independent where they can. */
void chart_choose(chart *c, const mechanism *m, arena *memory, double *slopes, int rows, int positions);

/* Moves the states by small coordinates[all], which need not be small. */
void chart_move(const chart *c, const mechanism *m, double *x, const double *by);

/* slopes.c: the model. */

/* A formula that is not smooth at the point: the model takes the mean of the slopes on both sides. */
typedef struct kink {
    const char *by, *target; /* the coordinate or the input, and a state or an output */
    double below, above;
} kink;

typedef struct linear_model {
    const expansion *e;
    point at;
    chart c;
    double *up, *down;      /* [states][c.count] and [c.count][states]: states by coordinates, and the other way */
    double *rates;          /* [c.count] of the coordinates at the point */
    double *outputs;        /* [outputs] */
    double *a, *b, *cy, *d; /* [count][count], [count][inputs], [outputs][count], [outputs][inputs] */
    kink *kinks;
    int kink_count;
    const char *not_finite; /* the name of a quantity without a slope; NULL */
} linear_model;

/* The slopes of all roots by all small coordinates: at[roots][all]. */
void slopes_by_coordinates(const expansion *e, const chart *c, const point *at, double *slopes);

/* Row i of the rates of small coordinates: sum over the states. */
double *reduced_rates(const chart *c, arena *memory, const double *slopes);

linear_model model_at(const expansion *e, const scene *written, point at);

/* A of other derivatives of the same states, in the coordinates of a model. */
double *matrix_without(const linear_model *model, const expansion *other);

/* trim.c: equilibria. */

/* A condition on the equilibrium: an input, an output or a state has a value; or an input is free. */
typedef enum trim_sort { TRIM_INPUT, TRIM_OUTPUT, TRIM_STATE } trim_sort;

typedef struct trim_condition {
    place at;
    const char *name;
    trim_sort sort;
    int index; /* of the input, output, state */
    bool is_free;
    double value;
    const char *unit;
} trim_condition;

typedef LIST_OF(trim_condition) trim_conditions;

/* The names and the units of a list. */
typedef struct labels {
    const char **names, **units;
    int count;
} labels;

/* conditions.c: the names and units of all inputs, outputs or states. */
labels labels_of(const plant *p, arena *memory, trim_sort sort);

/* Reads conditions: 'rest', or parts such as `theta = 10 deg`, `input force = 0`, `free force`. Notes problems. */
trim_conditions trim_conditions_read(source *s, graph *g, const scene *written, const plant *p, const script *list);

/* Moves the point to the nearest equilibrium that meets the conditions. False after noting the largest residual, and
 * its body. */
bool trim(source *s, const expansion *e, const scene *written, const trim_conditions *w, point *at);

/* eigenvectors.c: the modes of the model. */

typedef struct mode {
    double re, im;   /* im >= 0 */
    bool is_neutral; /* re is zero within rounding */
    double *part;    /* [count] of the coordinates in it; their sum is 1 */
    const char *by;  /* the effect, spring or damping that it follows from most; NULL */
} mode;

typedef struct mode_list {
    mode *all; /* the fastest growing first */
    int count;
    bool found;
} mode_list;

mode_list modes_find(const graph *g, const linear_model *l);

/* doubles every 0.19 s */
const char *mode_words(arena *memory, const mode *m);

/* report.c: files and text. */

/* The request of isoc --linear. */
typedef struct linear_request {
    const char *state, *trim; /* a file with the point, and conditions; NULL */
    const char *folder;
} linear_request;

/* Writes the model into the folder, and a summary to standard output. */
bool linear_write(source *s, const graph *g, const plant *p, const linear_model *l, const linear_request *r);

/* linear.c: the whole of isoc --linear. */
bool linear_run(source *s, graph *g, const scene *written, const plant *p, const linear_request *r);

#endif
