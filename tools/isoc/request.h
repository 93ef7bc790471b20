/* The request of the command line. */
#ifndef ISOC_REQUEST_H
#define ISOC_REQUEST_H

#include "tools/isoc/export/equations.h"
#include "tools/isoc/linear/linear.h"
#include "tools/isoc/sweep/sweep.h"

/* The products that isoc writes instead of a plant: the first of these that is asked for. */
typedef struct products {
    const char *files, *effects, *shape, *dot, *mjcf, *linear, *equations, *ended;
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

/* Prints an error about an option, or about its argument where there is one. Returns false. */
bool complain(const char *message, const char *argument);

/* Replaces parts of the scene by --step, --method, --tolerance, --set, --without and --inputs; notes problems. */
void override_scene(const request *r, source *s, scene *written);

/* Whether the mechanism fits the request; else complains, where no problem is noted. Notes statements of the scene that
 * only the loop of core carries out, for a plant without it. */
bool request_fits(const request *r, source *s, const scene *written, const mechanism *m);

#endif
