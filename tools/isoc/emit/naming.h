/* The names in generated files: with a prefix, so that several plants can stand in one program. */
#ifndef ISOC_EMIT_NAMING_H
#define ISOC_EMIT_NAMING_H

#include "tools/isoc/emit/code.h"
#include "tools/isoc/mechanism/states.h"
#include "tools/isoc/plant/plant.h"

typedef struct naming {
    const char *prefix;   /* of functions, types and files: cart */
    const char *capitals; /* of constants: CART */
    bool is_program;      /* the plant is iso_the_plant, that of the program */
    const state *states;
    leaf_names leaves; /* states, inputs with memories behind them, parameters: CART_X_RAIL, CART_U_PUSH, CART_P_MASS */
    const variable *about_states, *about_held, *about_outputs; /* in the same order */
    const leaf_name *outputs;                                  /* CART_Y_ANGLE */
} naming;

/* With this prefix, or as the plant of the program where it is NULL. */
naming naming_of(const plant *p, arena *memory, const char *prefix);

/* A word in capitals. */
const char *capitals_of(arena *memory, const char *word);

#endif
