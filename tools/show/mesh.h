/* Surfaces of solids as polygons, whose corners turn left as seen from without. */
#ifndef ISO_TOOLS_SHOW_MESH_H
#define ISO_TOOLS_SHOW_MESH_H

#include <stddef.h>

#include "tools/show/space.h"

typedef struct mesh {
    size_t vertices, corners, faces;
    vec *vertex;
    size_t *corner; /* of all faces: vertices; */
    size_t *end;    /* [faces]: behind the last corner of each */
} mesh;

/* Each adds to the mesh, in the frame `at`. A prism and a cone stand along z from 0 to `length`. */
void mesh_box(mesh *to, pose at, vec edges);
void mesh_prism(mesh *to, pose at, double radius, double length, int sides);
void mesh_bar(mesh *to, pose at, double radius, double length, int sides, int pieces); /* a prism in pieces */
void mesh_cone(mesh *to, pose at, double radius, double length, int sides);
void mesh_ellipsoid(mesh *to, pose at, vec radii, int sides);

/* The sides `from` to `end` of a ring about z: its sizes are outer radius, inner radius and length; its centre is the
 * origin. */
void mesh_wedge(mesh *to, pose at, vec sizes, int sides, int from, int end);

/* A plate of some thickness whose outline goes around these points, which lie in a plane across `normal`. */
void mesh_plate(mesh *to, const vec *point, size_t points, vec normal, double thickness);

/* A helix along z from 0 to 1, as a line: a face that is not closed. */
void mesh_helix(mesh *to, double radius, int turns);

#endif
