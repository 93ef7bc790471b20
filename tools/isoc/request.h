/* What the command line asks for, and the compilation of a scene for that. */
#ifndef ISOC_REQUEST_H
#define ISOC_REQUEST_H

#include "tools/isoc/effects/effects.h"
#include "tools/isoc/export/equations.h"
#include "tools/isoc/linear/linear.h"
#include "tools/isoc/sweep/sweep.h"

/* The products that isoc writes instead of a plant: the first of these that is asked for. */
typedef struct products {
    const char *files, *effects, *shape, *dot, *mjcf, *linear, *equations, *ended, *check;
} products;

/* Options that replace parts of the scene. */
typedef struct replacements {
    const char *step, *method, *tolerance, *set, *without, *inputs;
} replacements;

/* The text of each option: its value, or its own word where none follows; NULL where it is absent. Behind these the
 * values of some words. */
typedef struct request {
    const char *scene, *directory, *name;
    replacements in_place;
    products instead;
    linear_request linear;
    sweep_request sweep;
    const char *lock; /* of --xcp */
    const char *vary; /* tunables that runs set at their start */
    const char *standalone, *link, *python, *lanes, *fmu, *fmi, *exchange, *real, *formulation, *factors;
    bool is_double, is_standalone;
    int fmi_version; /* of an FMU; 0 where it is none */
    build_options wanted;
} request;

/* request.c: prints an error about an option, or about its argument where there is one. Returns false. */
bool complain(const char *message, const char *argument);

/* Replaces parts of the scene by --step, --method, --tolerance, --set, --without and --inputs; notes problems. */
void override_scene(const request *r, source *s, scene *written);

/* Whether the mechanism fits the request; else complains, where no problem is noted. Notes statements of the scene that
 * only the loop of core carries out, for a plant without it. */
bool request_fits(const request *r, source *s, const scene *written, const mechanism *m);

/* pipeline.c: the compiler, pass by pass. */

/* The groups of passes; each assumes those before it. */
typedef enum stage {
    STAGE_TEXT,      /* and its statements, as they are written */
    STAGE_SCENE,     /* with the command line's values in the place of the scene's */
    STAGE_BODIES,    /* names are found, units checked; bodies are parts of segments */
    STAGE_MECHANISM, /* formulas are nodes of a graph */
    STAGE_REQUEST,   /* of what the scene is, against what is asked for */
    STAGE_START,     /* numbers that satisfy the closures */
    STAGE_PLANT,     /* all that a tick computes, as nodes of states, inputs and tunables */
    STAGE_CHECKS,    /* that the plant is useful */
    STAGE_LADDER,    /* plants on the lower rungs of a ladder */
    STAGES
} stage;

typedef struct compilation {
    arena *memory;
    const request *r;
    source *s;
    scene written;
    graph g;
    builder b; /* b.mechanism is the mechanism */
    plant p;
    const char *joints; /* of --check: the kind of joint that definitions are tried with; else NULL */
    const plant *whole; /* with all effects, where the scene is that of a lower rung; else NULL */
    bool exchanges;     /* it is an FMU for model exchange too */
    bool is_over;       /* what is wrong lets no further pass begin */
} compilation;

/* products.c: what a request asks for: the last group of passes that it needs, and what writes it. */
typedef struct product {
    stage needs;
    bool (*write)(compilation *c); /* false after an error on stderr */
    const char *option;            /* NULL: a plant */
    bool is_list;                  /* it goes to standard output alone */
} product;

product product_of(const request *r);

/* Compiles a scene, or prints the answer to a request about it. Returns false after an error on stderr. */
bool compile(arena *memory, const request *r);

#endif
