/* The figure of a mechanism: its solids, or ellipsoids of inertia and links where it has none; markers of joints;
 * springs and forces. A figure is a list of parts. Each is a mesh that moves with a body, or that stands between two
 * points. */
#ifndef ISO_TOOLS_SHOW_FIGURE_H
#define ISO_TOOLS_SHOW_FIGURE_H

#include "tools/show/mesh.h"
#include "tools/show/record.h"

typedef enum part_kind {
    PART_OF_BODY, /* in the frame of the body */
    PART_BETWEEN, /* along z from 0 to 1 between two points */
    PART_FORCE,   /* the same from a point along an axis, as long as a column says */
} part_kind;

/* Bodies have the first inks in turn. */
enum { INKS_OF_BODIES = 8, INK_STEEL = INKS_OF_BODIES, INK_GROUND, INK_FORCE, INK_SPRING };

typedef struct part {
    part_kind kind;
    int ink;
    int body[2];
    vec point[2]; /* on the bodies; of a force the second is its axis */
    int column;   /* of a force; */
    double scale; /* and metres per unit of it */
    mesh shape;
} part;

typedef struct figure {
    part *all;
    size_t parts;
    double size; /* m: of the mechanism; what has no size of its own follows from it */
    bool has_floor;
    vec floor_point, floor_normal;
} figure;

figure figure_of(const shape *s, const record *r);

/* How a part stands in a frame. A mesh is carried by it; across a part between points the axes keep their length. */
pose part_pose(const part *p, const record *r, size_t frame);

/* The direction against gravity; z where there is none. */
vec up_of(const shape *s);

#endif
