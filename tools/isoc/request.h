/* The request of the command line. */
#ifndef ISOC_REQUEST_H
#define ISOC_REQUEST_H

#include "tools/isoc/emit/equations.h"
#include "tools/isoc/linear/linear.h"
#include "tools/isoc/sweep/sweep.h"

/* What isoc writes: a plant, a linear model or a plan of runs into a folder, or a text. */
typedef enum product {
    PRODUCT_FILES,
    PRODUCT_EFFECTS,
    PRODUCT_SHAPE,
    PRODUCT_DRAWING,
    PRODUCT_MJCF,
    PRODUCT_LINEAR,
    PRODUCT_SWEEP,
    PRODUCT_EQUATIONS,
    PRODUCT_PLANT
} product;

/* An option that is not given is NULL. */
typedef struct request {
    const char *scene, *directory, *name;
    const char *method, *step, *tolerance, *set, *without, *inputs; /* in place of the scene's */
    const char *lock;                                               /* of --xcp */
    linear_request linear;
    sweep_request sweep;
    const char *vary; /* tunables that runs set at their start */
    product product;
    equations_style style;
    bool is_double, is_standalone, is_linked, is_python, is_exchanged, has_lanes;
    int fmi_version; /* of an FMU; 0 where it is none */
    build_options wanted;
} request;

/* Prints an error about an option, or about its argument where there is one. Returns false. */
bool complain(const char *message, const char *argument);

/* Whether the mechanism fits the request; else complains. */
bool request_fits(const request *r, const mechanism *m);

/* Replaces parts of the scene by --step, --method, --tolerance, --set, --without and --inputs. Returns false after
 * reporting problems of the first three; notes those of the others. */
bool override_scene(arena *memory, const request *r, source *s, scene *written);

/* pipeline.c: the compiler, pass by pass. */

/* Compiles a scene, or prints the answer to a request about it. Returns false after an error on stderr. */
bool compile(arena *memory, const request *r);

#endif
