/* The camera: how a figure stands in a picture. The page has the same equations (tools/show/player.js), and a test
 * compares. */
#ifndef ISO_TOOLS_SHOW_VIEW_H
#define ISO_TOOLS_SHOW_VIEW_H

#include "tools/show/figure.h"

typedef struct view {
    vec up, right, out;                       /* of a view from the front; `out` leads to the viewer, */
    double yaw, pitch;                        /* who goes around from there, about `up`, and then rises */
    vec centre;                               /* of the picture; where it follows, from the middle of the bodies */
    double half_width, half_height, distance; /* m: of what is seen, and of the viewer */
    bool follows;                             /* the middle of the bodies */
    bool is_flat;                             /* of a mechanism in a plane */
    bool has_floor;
    vec floor_point, floor_x, floor_y; /* level */
    double cell;                       /* m: of its grid */
} view;

typedef struct camera {
    vec right, up, out, centre;
    double distance, scale; /* pixels for a metre at the centre */
    double x, y;            /* pixels: where the centre is */
} camera;

typedef struct seen {
    double x, y, nearness; /* pixels, and m towards the viewer */
} seen;

view view_of(const shape *s, const record *r, const figure *f);

/* The middle of the bodies in a frame. */
vec middle_of(const record *r, size_t bodies, size_t frame);

camera camera_of(const view *v, const record *r, size_t bodies, size_t frame, double width, double height);

seen camera_sees(const camera *c, vec p);

#endif
