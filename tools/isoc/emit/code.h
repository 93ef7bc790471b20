/* From nodes to straight-line C: one `const real` per quantity that has a name or more than one use, in the order in
 * which the equations were written, under their headings. */
#ifndef ISOC_EMIT_CODE_H
#define ISOC_EMIT_CODE_H

#include "tools/isoc/base/text.h"
#include "tools/isoc/graph/graph.h"

/* The name of a leaf in the code. */
typedef struct leaf_name {
    const char *symbol; /* in the equations */
    const char *place;  /* in its array */
    const char *quote;  /* the scene's line that declares it, or NULL */
} leaf_name;

typedef struct leaf_names {
    const leaf_name *states, *inputs, *parameters;
} leaf_names;

/* A line of the scene that stands above the first quantity that has this name in its own. */
typedef struct mark {
    const char *name, *quote;
} mark;

/* One function's worth of statements: `targets[i] = roots[i]`. */
typedef struct code {
    graph *g;
    leaf_names names;
    bool is_double;
    const char *const *targets;
    const node *roots;
    size_t count;
    bool can_order;   /* the statements may have another order */
    bool in_place;    /* a target may be a place that the statements read */
    const char *zero; /* the text that sets a target to zero; NULL: the number */
    size_t kept; /* so many of the last targets are set together, where `kept` is not NULL, as soon as all are known */
    const char *const *quotes; /* the scene's lines, above the targets that they make; or NULL */
    bool quotes_leaves;        /* and above the leaves that the function reads */
    const mark *marks;
    size_t mark_count;
    const char *const
        *turns; /* [states] the expressions of its sine and cosine, where they stand in an array, or NULL; or NULL */
} code;

/* Adds the statements, indented by four spaces. Like the next, sets *out_of_range_value to a constant that leaves the
 * range of real; without one it stays. */
void code_emit(const code *c, text *out, double *out_of_range_value);

/* A piece of statements: it ends in the text where the next begins. */
typedef struct code_piece {
    size_t body; /* where it begins behind the heading that stands before it */
    size_t end;
    int section;
    int mark;             /* of its name, or -1 */
    const char *declares; /* a quantity, or NULL: the piece sets a target */
    bool is_turn;         /* the quantity is a sine and a cosine */
    node angle;           /* of that; one that stands somewhere reads nothing */
    size_t *reads;        /* [read_count] pieces whose quantities it reads */
    size_t read_count;
    node *leaves; /* [leaf_count] */
    size_t leaf_count;
} code_piece;

/* The same statements piece by piece, without the declarations of values that arrays hold; each target is set as soon
 * as it is known, so that no target may be a place that the statements read. */
typedef struct code_pieces {
    const graph *g;
    text text;
    code_piece *all;
    size_t count, room;
    const char **leaves; /* [nodes] the declaration of a leaf, or NULL where it needs none */
    const char **quotes; /* [nodes] the scene's line of a leaf, or NULL */
    const mark *marks;
    bool *is_marked; /* [marks] whether its line stands in a text */
} code_pieces;

code_pieces code_in_pieces(const code *c, double *out_of_range_value);

/* The number of them and of the values that they read from arrays. */
size_t code_length(const code_pieces *from);

/* Adds the statement of a piece, under the line of its mark if that stands nowhere yet. */
void code_add_piece(const code_pieces *from, size_t i, text *out);

/* The same statements as nodes: their graph, and in it the roots, which nodes are needed, and the names of those that
 * are declared, or NULL. */
typedef struct code_nodes {
    const graph *g;
    const node *roots; /* [count of the code] */
    const bool *needed;
    const char *const *names;
} code_nodes;

code_nodes code_in_nodes(const code *c);

/* The shortest decimal that reads back as the same real; likewise as C, e.g. 20.0, with zero for a number below the
 * normal ones; and as a literal R(20.0). */
const char *shortest_decimal(arena *memory, double value, bool is_double);
const char *code_decimal(arena *memory, double value, bool is_double);
const char *code_literal(arena *memory, double value, bool is_double);

/* A fraction of a turn as C; 2^64 is one. */
const char *code_phase(arena *memory, double turns);

/* order.c: the same statements in an order in which few values go to memory and back, without headings. */
const char *code_in_order(const code_pieces *pieces);

/* traffic.c: the loads and stores that the pieces take in this order, [count of them], with so many registers. */
int code_traffic(const code_pieces *from, const size_t *order, size_t most);

/* split.c: a long body in functions of bounded size: the time and the memory of a compiler grow faster than a
 * function. */

typedef struct code_parts {
    const char **bodies; /* [count] */
    int count;
    int carried; /* reals of v[] */
} code_parts;

/* Parts of at most so many statements and values that they read. A value that one part declares and a later one reads
 * stands in v[]. */
code_parts code_split(const code_pieces *pieces, int most);

/* cut.c: a body in two: the part that follows from the states alone, and the rest, which reads its values from s[]. */

typedef struct code_cut {
    const char *of_states, *rest; /* NULL where the body stays whole, and is given sines and cosines alone */
    int count;                    /* reals of s[] */
    int *turns;                   /* [states] the place in s[] of sine and cosine, or -1 */
    int statements;               /* of the states alone */
    double out_of_range_value;    /* a constant that leaves the range of real; else 0 */
} code_cut;

/* s[] has also the sines and cosines of these of so many states, where the derivative computes them. */
code_cut code_cut_by_states(const code_pieces *pieces, const bool *turned, int states);

#endif
