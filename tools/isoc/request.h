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

/* Whether the mechanism fits the request; else complains. */
bool request_fits(const request *r, const mechanism *m);

/* Replaces parts of the scene by --step, --method, --tolerance, --set, --without and --inputs. Returns false after
 * reporting problems of the first three; notes those of the others. */
bool override_scene(arena *memory, const request *r, source *s, scene *written);

/* pipeline.c: the compiler, pass by pass. */

/* Compiles a scene, or prints the answer to a request about it. Returns false after an error on stderr. */
bool compile(arena *memory, const request *r);

#endif
