/* The equations of a scene for a reader, as text and as LaTeX: those that plant.c computes, by its names and under its
 * headings. Both are written by one walk over the nodes, with two tables of spellings. */
#ifndef ISOC_EXPORT_EQUATIONS_H
#define ISOC_EXPORT_EQUATIONS_H

#include "tools/isoc/emit/emit.h"

typedef enum equations_style { EQUATIONS_TEXT, EQUATIONS_LATEX, EQUATIONS_STYLES } equations_style;

extern const char *const equations_styles[EQUATIONS_STYLES];

void describe_equations(const plant *p, graph *g, const naming *names, const scene *written, equations_style style,
                        text *out);

/* The document so far. */
typedef struct equations_document {
    const plant *p;
    graph *g;
    const naming *names;
    equations_style style;
    bool *is_asked; /* [OPERATIONS] operators that stand in it */
    text *out;
} equations_document;

/* spelling.c: an expression in the style of a document. */

/* The expressions of all nodes, each with the names of the declared nodes that it reads; of a declared node the right
 * side of its declaration. */
const char *const *spell_nodes(const equations_document *to, const code_nodes *nodes);

/* A name of plant.c. A word of the scene, and a unit, as they stand in the list of quantities. */
const char *spell_name(const equations_document *to, const char *word);
const char *spell_words(const equations_document *to, const char *words);
const char *spell_unit(const equations_document *to, const char *symbols);
const char *spell_number(arena *memory, equations_style style, double number, bool is_double);

/* The meaning of an operator that is not in common use, or NULL. */
const char *spell_meaning(operation op);

#endif
