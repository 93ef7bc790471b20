/* Shared by the files that write a mechanism as MJCF. MuJoCo's zero is the start of the scene, where closures hold:
 * `ref` makes its coordinates those of the scene; a ball's is the turn from the start. */
#ifndef ISOC_EXPORT_MJCF_H
#define ISOC_EXPORT_MJCF_H

#include "tools/isoc/export/export.h"

/* A frame in another: its origin, and its axes as columns. */
typedef struct seat {
    double at[3], turn[3][3];
} seat;

/* A body of MuJoCo: the segments from `first` to `last`, of which only the last one has mass. */
typedef struct solid_body {
    int first, last, parent; /* parent: a body, or GROUND */
    seat place;              /* in the parent's, at the start */
    double mass, centre[3], inertia[6];
} solid_body;

/* Limits and dry friction of effects, which are attributes of a joint in MuJoCo. */
typedef struct joint_bounds {
    bool is_limited;
    double lower, upper;
    double friction; /* Coulomb's, N m or N */
} joint_bounds;

typedef struct mjcf_writer {
    graph *g;
    const mechanism *m;
    const double *numbers; /* of all nodes at the start */
    const double *start;   /* of all states */
    solid_body *bodies;
    int count;
    int *body_of;         /* [segments] their bodies */
    joint_bounds *bounds; /* [segments] */
    bool *is_said;        /* [effects] */
    text tendons, actuators, equalities;
    text *out;
} mjcf_writer;

/* mjcf_bodies.c: bodies within each other, with joints, inertia, and sites for forces and ends of springs. */

/* Makes the bodies of the segments. False where a chain ends without mass: MuJoCo has no such body. */
bool mjcf_join_segments(mjcf_writer *w);
void mjcf_put_bodies(const mjcf_writer *w);

/* Whether the inertia of a body is beyond the triangle inequality, by more than rounding: MuJoCo refuses that. */
bool mjcf_is_beyond(const solid_body *b);

/* Whether MuJoCo has a frame for points of the segment `at`: the other segments of a body move against it. */
bool mjcf_has_frame(const mjcf_writer *w, int at);

/* Whether the child's origin stays where it is along the parent's axis, also where the closure does not hold: all moves
 * in one plane. */
bool mjcf_stays_along(const mjcf_writer *w, const closure *c, double *result);

/* Numbers as the value of an attribute; and those of a vector. */
const char *mjcf_numbers(const mjcf_writer *w, const double *x, int count);
const char *mjcf_number(const mjcf_writer *w, double x);
const char *mjcf_vector(const mjcf_writer *w, vector v);

const char *mjcf_body_name(const mjcf_writer *w, int at);

/* mjcf_effects.c: marks the effects that MuJoCo can express, and writes them. */
void mjcf_say_effects(mjcf_writer *w);

#endif
