/* A scene understood: the tree of links that the dynamics runs over, its inputs, outputs, step and method.
 *
 * A link is a body that moves by one joint coordinate, with all that is welded to it. Its frame stands on the joint:
 * the joint turns it about, or moves it along, one of its own coordinate axes, so that no joint needs more than a
 * plane rotation. What a user wrote about bodies is carried into link frames here, at compile time.
 */
#ifndef ISOC_MECHANISM_H
#define ISOC_MECHANISM_H

#include "core/method.h"
#include "tools/isoc/value.h"
#include "tools/isoc/vector.h"

enum { GROUND = -1 };

typedef struct link {
    const char *name; /* of the joint */
    place at;         /* where it is declared */
    int parent;       /* a link before this one, or GROUND */
    joint_kind kind;  /* JOINT_REVOLUTE or JOINT_PRISMATIC */
    int axis;         /* 0, 1, 2 */
    double sign;      /* the joint's axis is sign * e_axis */
    bool continuous;
    matrix turn;   /* constant: the link's axes at coordinate zero, in the parent's axes */
    vector offset; /* the link's origin at coordinate zero, in the parent's frame */

    node mass; /* with all welded bodies, about the link's origin, in its axes */
    vector first_moment;
    tensor inertia;

    node damping, spring, rest; /* zero where the scene names none */
    int drive;                  /* an input, or -1 */
    double start, speed;
} link;

/* Where a body's own frame stands in its link's (or the ground's). */
typedef struct body_frame {
    int link;
    matrix turn;
    vector offset;
    bool placed;
} body_frame;

typedef struct mechanism {
    const char *name;
    link *links;
    int link_count;
    body_frame *frames; /* of the scene's bodies */
    vector gravity;
    node ground_mass; /* welded to the ground; for the energy */
    vector ground_moment;

    int input_count;
    const char **input_names;
    node *drives;  /* the inputs as functions of time */
    double *jumps; /* the changes of inputs that start a method anew; 0: none does */

    const output *outputs;
    size_t output_count;
    vector *points;   /* of the outputs, in their body's frame */
    int *output_link; /* the joint's, or -1 for a body */
    int *output_body;

    int parameter_count;
    const char **parameter_names;
    const double *defaults;

    unsigned recipe;  /* method and options: core/method.h */
    double tolerance; /* of adams */
    double substeps;  /* its budget in a tick; 0: as good as none */
    double step;      /* s */
} mechanism;

/* Resolves names, units and places; notes problems. The result is whole only if there are none. */
/* How a scene calls a method. */
extern const char *const method_names[ISO_METHODS + 1];

mechanism mechanism_build(source *s, graph *g, const scene *written);

/* Only the method and the step, for a scene that says nothing else; notes problems. */
void mechanism_method_and_step(source *s, graph *g, const scene *written);

#endif
