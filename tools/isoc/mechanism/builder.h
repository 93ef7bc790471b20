/* Shared by the files that build a mechanism: the scene as written, its values, and the mechanism so far. */
#ifndef ISOC_MECHANISM_BUILDER_H
#define ISOC_MECHANISM_BUILDER_H

#include <stddef.h>

#include "tools/isoc/mechanism/mechanism.h"

static const dimension no_unit = DIMENSION(0, 0, 0, 0, 0, 0), kilogram = DIMENSION(1, 0, 0, 0, 0, 0),
                       metre = DIMENSION(0, 1, 0, 0, 0, 0), second = DIMENSION(0, 0, 1, 0, 0, 0),
                       radian = DIMENSION(0, 0, 0, 1, 0, 0), newton = DIMENSION(1, 1, -2, 0, 0, 0),
                       newton_metre = DIMENSION(1, 2, -2, 0, 0, 0), joule = DIMENSION(1, 2, -2, 0, 0, 0),
                       watt = DIMENSION(1, 2, -3, 0, 0, 0), moment_of_inertia = DIMENSION(1, 2, 0, 0, 0, 0);

static const double largest_angle = 1e4;      /* rad: the domain of core/numbers/sincos.h */
static const double last_tick = 4294967295.0; /* that a scene can name: 2^32 - 1 */

/* A part of a body. */
typedef struct lump {
    node mass;
    vector com;
    tensor inertia; /* about the centre of mass, in the body's axes */
} lump;

/* The contribution of a body to its segment. */
typedef struct weight {
    lump *lumps;
    size_t lump_count;
    int joint; /* whose child it is, or -1 */
} weight;

/* The past of a formula: the call, in which effect, and the memory that keeps it. */
typedef struct history_memory {
    const formula *call;
    const void *within;
    int memory;
    dimension in;
    row_rate rate; /* in which its formula is evaluated */
    bool has_start, is_done;
} history_memory;

/* A function of time outside of the inputs, and the effect whose definition has it; NULL: the scene. */
typedef struct time_input {
    const formula *call;
    const effect_use *within;
    value drive; /* the leaf of its input, when it is known; else count 0 */
} time_input;

typedef struct builder {
    source *s;
    graph *g;
    const scene *written;
    values values;
    weight *weights;
    int *parents, *children;              /* of the joints: bodies; -2 the ground, -1 unknown */
    dimension *input_dimensions;          /* of the scene's inputs */
    bool *is_input_used, *is_input_known; /* and whether their dimension is */
    LIST_OF(variable) faults;             /* of effects: tunables behind those of the scene */
    size_t edge_room, memory_room, applied_room, push_room;
    LIST_OF(history_memory) history_memories;
    LIST_OF(const formula *) masses; /* that effects give: the formula of each leaf OP_MASS */
    time_input *time_inputs;         /* each an input behind those of the scene */
    int time_input_count;
    size_t time_input_room;
    bool is_effect_broken;      /* one of them: its inputs seem to have no use */
    const surroundings *around; /* the names for effects, signals and outputs */
    const mechanism *whole;     /* with all effects, whose memory this one has; NULL: it is that */
    mechanism mechanism;        /* so far */
} builder;

/* mechanism.c: a mechanism without values, with room for all items of the scene. Of a scene in which effects are
 * dropped, `whole` is the mechanism with them: both have the same states, inputs, memories and parameters. Else it is
 * NULL. */
builder builder_of(source *s, graph *g, const scene *written, bool is_double, const mechanism *whole);

/* The bodies that each joint connects, of which a body is the child of one; then the tree of them; and in the end
 * whether the scene has the statements that each must have. */
void connect_joints(builder *b);
void build_tree(builder *b);
void check_whole(builder *b);

/* lookup.c: the value of a formula; zero if there is none, or if it is wrong. */
vector vector_value(builder *b, const formula *f, dimension expected, const char *what);
node scalar_value(builder *b, const formula *f, dimension expected, const char *what);

/* A constant whole number, of ticks or the like, within these limits; the fallback if there is none, or if it is wrong.
 */
double whole_number(builder *b, const formula *f, const char *what, const char *units, double fallback, double least,
                    double most);

/* The segment of a joint of one coordinate, or of a part of a joint; -1 if there is none. The same, or -1 after noting
 * a problem. */
int segment_called(const mechanism *m, name n);
int coordinate_of(builder *b, name n);

/* The child of a joint, or a closure between bodies, and -1 for the other; false after noting a problem. */
bool find_connection(builder *b, name n, int *child, int *loop);

/* A gear, a motion or a spring, as a closure or a spring, and -1 for the other; false after noting a problem. */
bool find_transmission(builder *b, name n, int *loop, int *spring);

/* The dimension of the coordinate of a joint; and of a quantity of it. */
dimension coordinate_dimension(const segment *l);
dimension quantity_dimension(quantity_kind kind, const segment *l);

/* For turns: whether the joint counts them; for a quantity of the whole plant: whether the plant has it. False after
 * noting a problem. */
bool counts_turns(builder *b, const query *q, place at);
bool is_of_plant(builder *b, quantity_kind kind, place at);

/* joints.c: the chain of segments that a joint stands for, beginning at the parent, each with its axes in the joint's
 * frame; returns their number. And the degrees of freedom of all segments. */
int joint_segments(builder *b, const joint *j, segment segments[PARTS_OF_A_JOINT], matrix aligned[PARTS_OF_A_JOINT]);
void list_dofs(builder *b);

/* closures.c: loop closures and their stabilisation. */
void build_closures(builder *b);

/* forces.c: springs and dampers between points, and forces of inputs on bodies. */
void build_springs(builder *b);

/* motions.c: a joint whose coordinate is a function of time; returns false after noting a problem. */
bool build_motion(builder *b, const closure_statement *written, closure *result);
void build_applied_forces(builder *b);

/* bodies.c: masses and inertias of the bodies; gravity. */
void build_bodies(builder *b);

/* masses.c: masses that states of effects give, such as that of fuel. What leaves a body, or comes into it, has the
 * velocity of the body there: it takes its momentum along, and pushes nothing. */

/* Whether a formula reads a signal or an output of an effect. A leaf in its place, until effects are known. */
bool is_of_effects(const builder *b, const formula *f);
node mass_of_effects(builder *b, const formula *f);

/* The formulas in the place of the leaves, in all bodies. */
void build_masses(builder *b);

/* placement.c: the unit vector of an axis, false if there is none; the joint's frame on a body; a frame in which the
 * axis is the coordinate axis *k times *sign (the identity for x, y, z, -x, -y, -z). */
bool unit_axis(builder *b, const formula *f, double axis[3]);
void place_joint(builder *b, const placement *p, matrix *turn_made, vector *origin);

/* The same on the body that a placement's frames stand on, and that body: -2 the ground, -1 unknown. Then, when all
 * bodies are placed, the frames as the bodies are. */
int stand_on(builder *b, const placement *p, matrix *turn_made, vector *origin);
void build_frames(builder *b);

/* The frame of a body of that number, or of the ground. */
body_frame frame_on(const builder *b, int on);

matrix align(graph *g, const double a[3], int *k, double *sign);

/* The frame of a placement, turned by `aligned`, on its segment; false if there is none. The last common ancestor of
 * two segments. */
bool place_end(builder *b, const placement *p, matrix aligned, closure_end *end);
int common_segment(const mechanism *m, int a, int b);

/* shape.c: the data of a picture, when bodies and joints are built: bodies with their solids, joints, closures,
 * springs, forces, points of effects, and outputs that are points, a line of cells for each. Places are in the frames
 * of bodies.
 */
void shape_cells(builder *b, text *out);

/* regroup.c: moves to the parents the mass parameters that the joints' motion does not change. */
void regroup(builder *b);

/* lookup.c: the jumps at known ticks in a function of time. */
void find_edges(builder *b, node drive);

/* inputs.c: inputs and tunable parameters. The inputs are checked when all that can use them is built. */
void build_inputs(builder *b);
void check_inputs(builder *b);
void build_changes(builder *b);
void build_parameters(builder *b);

/* method.c: the method with its options, and the step. A method by its name; rk4 after noting a problem. The names of
 * explicit methods of one step, as a person lists them. */
void build_method(builder *b);
void build_step(builder *b);
unsigned find_method(builder *b, name word);
const char *explicit_methods(arena *memory);

/* ladder.c: how the loop runs the plant. */
void build_policies(builder *b);

#endif
