/* A compilation as far as its passes have come, and what is written at its end. */
#ifndef ISOC_PIPELINE_H
#define ISOC_PIPELINE_H

#include "tools/isoc/effects/effects.h"
#include "tools/isoc/request.h"

/* The groups of passes; each assumes those before it. */
typedef enum stage {
    STAGE_TEXT,       /* of the scene's file */
    STAGE_STATEMENTS, /* as they are written */
    STAGE_SCENE,      /* with the command line's values in the place of the scene's */
    STAGE_BODIES,     /* names are found, units checked; bodies are parts of segments */
    STAGE_MECHANISM,  /* formulas are nodes of a graph */
    STAGE_REQUEST,    /* of what the scene is, against what is asked for */
    STAGE_START,      /* numbers that satisfy the closures */
    STAGE_PLANT,      /* all that a tick computes, as nodes of states, inputs and tunables */
    STAGE_CHECKS,     /* that the plant is useful */
    STAGE_WARNINGS,   /* of inputs and effects that the step does not follow */
    STAGE_LADDER,     /* plants on the lower rungs of a ladder */
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
    const plant *whole; /* with all effects, where the scene is that of a lower rung; else NULL */
    bool exchanges;     /* it is an FMU for model exchange too */
    bool is_over;       /* what is wrong lets no further pass begin */
} compilation;

/* products.c: what a request asks for: the last group of passes that it needs, and what writes it. */
typedef struct product {
    stage needs;
    bool (*write)(compilation *c); /* false after an error on stderr */
} product;

product product_of(const request *r);

/* Compiles a scene, or prints the answer to a request about it. Returns false after an error on stderr. */
bool compile(arena *memory, const request *r);

#endif
