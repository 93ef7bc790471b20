/* The kinds of closures: one row for each, with its properties and its constraints
 * (tools/isoc/closure/constraints.c). */
#ifndef ISOC_SCENE_CLOSURE_KINDS_H
#define ISOC_SCENE_CLOSURE_KINDS_H

#include <stdbool.h>
#include <stddef.h>

/* The kinds of closures that have a property. */
enum {
    ANY_CLOSURE = 1,
    BETWEEN_BODIES = 2,
    ALONG_JOINTS = 4, /* constrains coordinates of joints, not bodies */
    WITH_AXIS = 8,
    WITH_LENGTH = 16,
    WITH_RADIUS = 32,
    WITH_RATIO = 64, /* between two joints */
    WITH_MOTION = 128,
};

/* The constraints of a closure between bodies: on the child's frame relative to the parent's, where `axis` is an axis
 * of both. The constraints are made in this order. */
enum {
    HOLDS_ORIGIN = 1,   /* at the parent's */
    HOLDS_ON_LINE = 2,  /* on the parent's axis */
    HOLDS_DISTANCE = 4, /* from the parent's origin */
    HOLDS_ROLLING = 8,  /* a ball about the child's origin, on the plane across the parent's axis */
    HOLDS_AXIS = 16,    /* parallel to the parent's */
    HOLDS_TURN = 32,    /* no relative rotation */
};

/* kind, word, properties, constraints */
#define CLOSURE_KINDS(ROW)                                                                                             \
    ROW(CLOSE_FIXED, "fixed", BETWEEN_BODIES, HOLDS_ORIGIN | HOLDS_TURN)                                               \
    ROW(CLOSE_REVOLUTE, "revolute", BETWEEN_BODIES | WITH_AXIS, HOLDS_ORIGIN | HOLDS_AXIS)                             \
    ROW(CLOSE_PRISMATIC, "prismatic", BETWEEN_BODIES | WITH_AXIS, HOLDS_ON_LINE | HOLDS_TURN)                          \
    ROW(CLOSE_SPHERICAL, "spherical", BETWEEN_BODIES, HOLDS_ORIGIN)                                                    \
    ROW(CLOSE_LINE, "line", BETWEEN_BODIES | WITH_AXIS, HOLDS_ON_LINE)                                                 \
    ROW(CLOSE_DISTANCE, "distance", BETWEEN_BODIES | WITH_LENGTH, HOLDS_DISTANCE)                                      \
    ROW(CLOSE_GEAR, "gear", ALONG_JOINTS | WITH_RATIO, 0)                                                              \
    ROW(CLOSE_ROLLING, "rolling", BETWEEN_BODIES | WITH_AXIS | WITH_RADIUS, HOLDS_ROLLING)                             \
    ROW(CLOSE_MOTION, "motion", ALONG_JOINTS | WITH_MOTION, 0)

#define CLOSURE_KIND(kind, word, traits, holds) kind,
typedef enum closure_kind { CLOSURE_KINDS(CLOSURE_KIND) CLOSURE_ROWS } closure_kind;
#undef CLOSURE_KIND

typedef struct closure_row {
    const char *word;
    unsigned traits, holds;
} closure_row;

extern const closure_row closure_rows[CLOSURE_ROWS];

unsigned closure_traits(size_t kind);

bool acts_along_joints(closure_kind kind);

#endif
