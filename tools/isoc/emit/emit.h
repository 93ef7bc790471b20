/* The generated plant: a header that names the elements of its arrays, and a source that computes them. */
#ifndef ISOC_EMIT_EMIT_H
#define ISOC_EMIT_EMIT_H

#include "tools/isoc/emit/code.h"
#include "tools/isoc/emit/write.h"
#include "tools/isoc/plant/plant.h"

/* naming.c: the names in generated files: with a prefix, so that several plants can stand in one program. */

/* The quantities of an array. */
typedef struct quantities {
    const leaf_name *leaves; /* CART_X_RAIL, CART_U_PUSH, CART_P_MASS, CART_Y_ANGLE */
    const variable *all;
    int count;
} quantities;

typedef struct naming {
    const char *prefix;   /* of functions, types and files: cart */
    const char *capitals; /* of constants: CART */
    bool is_program;      /* the plant is iso_the_plant, that of the program */
    bool is_checked;      /* its start checks the build, which may be a stranger's */
    bool is_fmu;          /* its importer sets the inputs before the start */
    bool has_lanes;       /* it can be compiled with -DISO_LANES (core/numbers/lanes.h) */
    const state *states;
    quantities x, u, memories, p, y; /* states, inputs, memories (in u behind them), parameters, outputs */
    leaf_names leaves;               /* the same in equations: inputs with memories behind them */
    const code_cut *cut; /* the derivative in two, where a step prepares the next one: prepared.c; else NULL */
} naming;

/* The names with this prefix, or those of the plant of the program where it is NULL. */
naming naming_of(const plant *p, arena *memory, const char *prefix);

/* prepared.c: outputs and the first evaluation of the next step have the states in common. Sines of these, and where
 * outputs ask for accelerations all that follows from the states alone, are computed once, at the end of a step, and
 * stand behind them in the memory. Returns the derivative in two parts for that; NULL where nothing is shared. */
const code_cut *cut_of(const plant *p, graph *g, const naming *names);

/* A word in capitals. */
const char *capitals_of(arena *memory, const char *word);

void emit_header(const plant *p, const naming *names, text *out);

/* Returns false, with *out_of_range_value, if a constant leaves the range of real. */
bool emit_source(const plant *p, graph *g, const naming *names, text *out, double *out_of_range_value);

/* prefix.c: the name of a plant in other firmware: of its files, and the beginning of all its identifiers. Why isoc
 * cannot make files and identifiers with this prefix; NULL where it can. */
const char *prefix_fault(const char *prefix, arena *memory);

/* standalone.c: the files of core that a plant needs, so that its folder compiles alone. Adds the files of core that
 * those in the list include, and those that firmware calls and that need no port. They find each other by relative
 * paths, and in double they need no flag that says so. With packages the folder is also one of build systems. */
void standalone_files(file_list *files, const naming *names, bool is_double, bool has_packages);

#endif
