/* The shape of a mechanism: what `isoc SCENE --shape` prints, read again. */
#ifndef ISO_TOOLS_SHOW_SHAPE_H
#define ISO_TOOLS_SHOW_SHAPE_H

#include <stdbool.h>
#include <stddef.h>

#include "tools/show/space.h"
#include "tools/table/table.h"

enum { ON_GROUND = -1, MOST_POINTS = 8 };

/* A place on a body: its point and its axes. */
typedef struct spot {
    int body;
    pose frame;
} spot;

typedef struct shape_solid {
    const char *kind;
    spot at;
    double size[3];
} shape_solid;

/* Mass, centre and inertia about it, of a body without solids. */
typedef struct shape_lump {
    int body;
    vec centre;
    double mass, inertia[6]; /* xx, yy, zz, xy, xz, yz */
} shape_lump;

/* A joint, or a closure between bodies. */
typedef struct shape_joint {
    const char *name, *kind;
    spot parent, child;
    vec axis;
    double radius; /* of what rolls; */
    vec axle;      /* of a wheel; zero of a ball */
    bool has_spring, is_closure;
} shape_joint;

/* A spring between points. */
typedef struct shape_spring {
    spot first, second;
} shape_spring;

/* A force of an input along an axis of its place. */
typedef struct shape_force {
    const char *input;
    spot at;
    vec axis;
    double moment; /* m: about its line, for each newton */
} shape_force;

/* An output that is the place of a point. */
typedef struct shape_point {
    const char *name;
    spot at;
} shape_point;

/* The points that an effect acts at. */
typedef struct shape_effect {
    const char *name, *kind;
    double radius;
    size_t points;
    spot at[MOST_POINTS];
} shape_effect;

typedef struct shape {
    const char *name, *method;
    vec gravity;
    size_t bodies, solids, lumps, joints, springs, forces, effects, points;
    const char **body; /* names */
    shape_solid *solid;
    shape_lump *lump;
    shape_joint *joint;
    shape_spring *spring;
    shape_force *force;
    shape_effect *effect;
    shape_point *point;
    table text;
} shape;

/* Exits with a message where the file is none. */
shape shape_read(const char *path);

#endif
