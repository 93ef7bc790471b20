/* Shared by the files that make a figure. */
#ifndef ISO_TOOLS_SHOW_PARTS_H
#define ISO_TOOLS_SHOW_PARTS_H

#include "tools/show/show.h"

/* The sizes of parts without a size in the scene, over that of the mechanism. */
static const double link_radius = 0.011, marker_radius = 0.02, point_radius = 0.035, plate_thickness = 0.018,
                    longest_arrow = 0.3, spring_radius = 0.025, rotor_radius = 0.16;
/* A rod is in pieces, so that some can be before a solid that it passes through, and some behind it. */
enum { ROD_PIECES = 3, RAIL_PIECES = 16 };
enum { SIDES = 12, FEW_SIDES = 7, POINTS_OF_BODY = 48, TURNS = 7 };

/* figure.c: an empty part; one between two places; a rod on a body. */
part *add_part(figure *f, part_kind kind, int ink, int body);
part *add_between(figure *f, int ink, const spot *a, const spot *b);
void add_rod(figure *f, int ink, int body, vec from, vec to);

pose moved_along_z(pose at, double z);

/* Whether the joint holds its child nowhere. */
bool is_loose(const shape_joint *j);

/* bodies.c: solids, ellipsoids, links, rotors, balls and wheels. */
void add_bodies(figure *f, const shape *s);

/* connections.c: joints with their markers, springs, and forces as arrows. */
void add_connections(figure *f, const shape *s, const record *r);

#endif
