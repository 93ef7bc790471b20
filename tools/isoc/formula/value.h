/* The value of a formula: nodes with a dimension. */
#ifndef ISOC_FORMULA_VALUE_H
#define ISOC_FORMULA_VALUE_H

#include "tools/isoc/base/dictionary.h"
#include "tools/isoc/graph/graph.h"
#include "tools/isoc/scene/scene.h"

enum { VALUE_PARTS = 6 };

typedef struct value {
    int count; /* of parts: 1 a scalar, 3 a vector, 2, 4 or 6; 0: a problem has been noted */
    node parts[VALUE_PARTS];
    dimension dim;
    bool any;      /* a plain zero, which is zero in every unit */
    bool on_scale; /* written in degC: not to be multiplied */
} value;

static const value nothing = {0};

/* Notes a problem, as source_problem; the formula then has no value. */
#define REFUSED(...) (source_problem(__VA_ARGS__), nothing)

/* The progress of the evaluation of a parameter. */
typedef enum progress { NOT_YET, STARTED, DONE } progress;

/* The names that effects and signals have besides parameters. There numbers change with the states, and a radian is the
 * number one. */
typedef struct surroundings {
    void *context;
    bool (*find)(void *context, const formula *f, value *found); /* false: there is no such name */
    bool (*call)(void *context, const formula *f, value *found); /* false: there is no such function */
    value (*quantity)(void *context, const formula *f);          /* position of JOINT */
    value (*history_memory)(void *context, const formula *f);    /* previous(x), sample(x, every T), delay(x, T) */
    value (*time_input)(void *context, const formula *f); /* a function of time: noise(SEED), step(0.5 s), time */
} surroundings;

/* A call of a function with a table of the tick, and its node. */
typedef struct table_call {
    const formula *call;
    node root;
} table_call;

/* A condition on tunables: least <= most, or with is_strict least < most. */
typedef struct condition {
    node least, most;
    bool is_strict;
} condition;

/* The scene's parameters and the graph that formulas become nodes of. */
typedef struct values {
    source *s;
    graph *g;
    const scene *scene;
    bool is_double;             /* the number type of the plant */
    size_t scanned;             /* nodes that were looked at for constants out of its range */
    bool is_foreign;            /* one of them is */
    double step;                /* s; functions of time need it */
    bool time_allowed;          /* in the formula of an input or a motion */
    bool is_smooth;             /* of a motion */
    bool is_parameter;          /* in the formula of a constant or of a tunable */
    const surroundings *around; /* NULL: nothing else */
    value *parameters;          /* of the scene's, where resolved */
    progress *progress;
    dictionary names;   /* of the parameters */
    int *tunable_index; /* of a parameter: how many tunables are before it */
    double *defaults;   /* of the tunables, by index */
    int tunables;
    size_t default_room;
    double *numbers; /* of the nodes so far, with the tunables at their defaults */
    size_t number_count, number_room;
    LIST_OF(table_call) table_calls;
    LIST_OF(condition) conditions; /* that tunables could break */
} values;

/* value.c: whether an angle is a dimension of its own, in these surroundings. In formulas of effects, signals, outputs,
 * constants and tunables a radian is the number one, and is never a reason to refuse a formula. It is kept for the
 * units that are shown, and for what a constant stands in. */
static inline bool counts_angles(const values *v)
{
    return v->around == NULL && !v->is_parameter;
}

/* Whether two dimensions are the same there. */
bool agree(const values *v, dimension a, dimension b);

/* Gives `all` the common dimension of two values that agree: without radians where the two differ in them. A plain zero
 * takes the dimension of the other value. */
void gather(value *all, const value *next);

/* a times b to the power n, of the formula f. False after noting that a power is beyond MOST_POWER. */
bool multiply(values *v, const formula *f, dimension *a, dimension b, int n);

/* Notes a number that the plant's type cannot hold. */
bool check_range(const values *v, const formula *f, const char *what, double number);

/* The results of value_of and value_constant for a value of f. */
value value_fitting(values *v, const formula *f, value r, dimension expected, int parts, const char *what);
double constant_fitting(values *v, const formula *f, const value *found, dimension expected, const char *what,
                        double fallback);

/* The number that a node has with the tunables at their defaults. */
double value_now(values *v, node n);

/* Whether a number follows from constants and tunables alone. */
bool is_parametric(values *v, node n);

/* Whether a condition holds with the tunables at their defaults; true if it depends on more than tunables. A condition
 * that a tunable could break is kept: a plant refuses a change that breaks it. */
bool keeps(values *v, condition c);

/* The same for the condition that a number is above zero, or not below it. */
bool keeps_above_zero(values *v, node n);
bool keeps_not_below_zero(values *v, node n);

/* --- evaluate.c: all kinds of formulas, each by a function --- */

/* Starts with room for `more` tunables besides those of the scene. */
void values_start(values *v, source *s, graph *g, const scene *written, size_t more, bool is_double);

/* All parameters, in the order of the scene; notes their problems. */
void values_resolve(values *v);

/* The value of f, whatever it is. Count 0 after noting a problem. */
value value_any(values *v, const formula *f);

/* The value of f, which must have this dimension and number of parts (1 to 4; 0 for an inertia, which has 3 or 6).
 * `what` names the quantity in messages. Returns count 0 after noting a problem. */
value value_of(values *v, const formula *f, dimension expected, int parts, const char *what);

/* A constant scalar; `fallback` where f is NULL or wrong. */
double value_constant(values *v, const formula *f, dimension expected, const char *what, double fallback);

#endif
