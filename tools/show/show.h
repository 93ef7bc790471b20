/* Declarations shared by the files of `show`: from a shape and a run to a figure, and to its picture. */
#ifndef ISO_TOOLS_SHOW_SHOW_H
#define ISO_TOOLS_SHOW_SHOW_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "tools/show/space.h"
#include "tools/table/table.h"

/* shape.c: the shape of a mechanism, as read from the output of `isoc SCENE --shape`. */

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

/* How a joint, or a closure between bodies, is drawn: by what its kind moves or holds. */
typedef enum marker {
    MARKER_NONE, /* it holds its child at no place */
    MARKER_BLOCK,
    MARKER_PIN,
    MARKER_SLIDE,
    MARKER_SLEEVE, /* a slide that turns */
    MARKER_BALL,
    MARKER_BAR,
    MARKER_WHEEL, /* or a ball that rolls */
    MARKERS
} marker;

typedef struct shape_joint {
    marker marker;
    spot parent, child;
    vec axis;
    double radius; /* of a wheel or ball */
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
    double moment; /* m: about its line, for each newton; that of a rotor is not zero */
} shape_force;

/* An output that is the place of a point. */
typedef struct shape_point {
    const char *name;
    spot at;
} shape_point;

/* The points that an effect acts at. */
typedef struct shape_effect {
    const char *kind;
    double radius;
    size_t points;
    spot at[MOST_POINTS];
} shape_effect;

typedef struct shape {
    const char *name;
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
} shape;

/* Exits with a message if the file is no shape. */
shape shape_read(const char *path);

/* record.c: a run: the outputs of a plant at a number of frames, and their ranges between these. */

typedef struct record {
    char method[16], real[16];
    double tick, interval; /* s: of the plant; from frame to frame */
    size_t frames, columns;
    size_t outputs;      /* of the scene itself: the first columns; behind them stand those that the figure needs */
    char **name, **unit; /* [columns] */
    float *value;        /* [frames][columns] */
    float *least, *most; /* [frames][outputs] since the frame before */
    int *place;          /* [bodies]: the first column of their poses */
    double end;          /* s: when the run ended */
    char stopped[256];   /* why it ended too early; empty: it did not */
} record;

/* Runs the command, which writes a stream (core/application/stream.h). Exits with a message if there is no stream. */
record record_run(const char *command, size_t bodies);

/* A run that is kept in a folder: trace.csv, units.csv and summary.txt. It has no bodies. */
record record_kept(const char *folder);

/* The column of this name; -1 if there is none. */
int record_column(const record *r, const char *name);

/* The names in the recorded scene of the place and the turn of body i, and of the input of force i. Returns text. */
enum { RECORD_NAME_BYTES = 64 };
const char *record_name(char text[RECORD_NAME_BYTES], const char *what, size_t i);

/* Where body i is in a frame. */
pose record_pose(const record *r, size_t frame, int body);

/* ellipsoid.c: the ellipsoid of inertia of a body. */

typedef struct ellipsoid {
    pose at;   /* its centre and its axes, in the frame of the body */
    vec radii; /* along them; 0 of a point mass */
} ellipsoid;

/* Along each principal axis its radius is sqrt(3) times the deviation of the mass: so that of a uniform rod ends where
 * the rod ends. */
ellipsoid ellipsoid_of(const shape_lump *l);

/* mesh.c: surfaces of solids as polygons, whose corners turn left as seen from without. */

typedef struct mesh {
    size_t vertices, corners, faces;
    vec *vertex;
    size_t *corner; /* [corners] of all faces: vertices */
    size_t *end;    /* [faces] behind the last corner of each */
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

/* figure.c: the figure of a mechanism: its solids, or ellipsoids of inertia and links where it has none; markers of
 * joints; springs and forces. A figure is a list of parts. Each is a mesh that moves with a body, or that stands
 * between two points. */

typedef enum part_kind {
    PART_OF_BODY, /* in the frame of the body */
    PART_BETWEEN, /* along z from 0 to 1 between two points */
    PART_FORCE,   /* the same from a point along an axis, as long as a column says */
} part_kind;

/* Bodies have the first inks, one after another. */
enum { INKS_OF_BODIES = 8, INK_STEEL = INKS_OF_BODIES, INK_GROUND, INK_FORCE, INK_SPRING };

typedef struct part {
    part_kind kind;
    int ink;
    int body[2];
    vec point[2]; /* on the bodies; of a force the second is its axis */
    int column;   /* of a force */
    double scale; /* of a force: metres per unit */
    mesh shape;
} part;

typedef struct figure {
    part *all;
    size_t parts;
    double size; /* m: of the mechanism; parts without a size follow from it */
    bool has_floor;
    vec floor_point, floor_normal;
} figure;

figure figure_of(const shape *s, const record *r);

/* How a part stands in a frame. A mesh is carried by it; across a part between points the axes keep their length. */
pose part_pose(const part *p, const record *r, size_t frame);

/* The direction against gravity; z where there is none. */
vec up_of(const shape *s);

/* view.c: the camera: how a figure stands in a picture. The page has the same equations (tools/show/player.js), and a
 * test compares. */

typedef struct view {
    vec up, right, out;                       /* of a view from the front; `out` leads to the viewer */
    double yaw, pitch;                        /* of the viewer: around from there, about `up`; then upward */
    vec centre;                               /* of the picture; where it follows, from the middle of the bodies */
    double half_width, half_height, distance; /* m: of the visible part; of the viewer */
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

camera camera_of(const view *v, const record *r, size_t bodies, size_t frame, double width, double height);

seen camera_sees(const camera *c, vec p);

/* still.c: a figure at one time as SVG. */

/* The colours of the inks, red, green and blue. */
enum { INKS = INK_SPRING + 1 };
extern const int ink_colours[INKS][3];

void still_write(FILE *out, const shape *s, const record *r, const figure *f, const view *v, double seconds);

/* page.c: the page: a template with runs put in. */

/* A run with its label. */
typedef struct run {
    const char *label;
    shape shape;
    record record;
    figure figure;
} run;

/* The page: of a folder page.html, with page.css and the scripts in it. */
void page_write(FILE *out, const char *folder, const run *runs, size_t count);

#endif
