/* Constant factors, moved to where they take the fewest multiplications.
 *
 * A value may be computed as a constant multiple of itself: what is computed, times the scale, is the value. A product
 * has the product of its factors' scales, at no cost. A sum chooses its scale, and each term of another takes a
 * multiplication. A product may as well take a factor at a scale at which others ask for it. What leaves the graph and
 * the arguments of functions have the scale 1.
 */
#ifndef ISOC_SCALES_H
#define ISOC_SCALES_H

#include "tools/isoc/graph.h"

/* A node as so many times another one, which is no multiple of a further one. */
typedef struct multiple {
    double times;
    node of;
} multiple;

/* A use of a node, `times` that, by a sum, a product, or what takes the value as it is. */
typedef struct use {
    node by;   /* or WHOLE */
    int which; /* of its two operands */
    double times;
    int next; /* another use of the same node, or -1 */
} use;

enum { WHOLE = -1 };

typedef struct scales {
    const graph *g;
    bool *needed;
    multiple *as;  /* [nodes] */
    double *scale; /* [nodes] of a node that is no multiple: positive */
    double *taken; /* [nodes 2] at which scale a product takes its factors; 0: at the factor's own */
    int *first;    /* [nodes] of its uses, or -1 */
    use *uses;
    size_t use_count, use_room;

    /* Nodes that the change which is tried can give another price. */
    node *touched;
    size_t touched_count;
    int *mark, marks;
    bool *awake; /* [nodes] to be tried again */
} scales;

/* The cheapest scales that a local search finds. */
scales scales_choose(const graph *g, const node *roots, size_t count);

/* At which scale a product takes a factor. */
double scale_taken(const scales *s, node product, int which);

/* Operands of a node, 0 to 2; and one of them. */
int operands(const graph_node *n);
node operand_at(const graph_node *n, int which);

bool is_sum(const graph_node *n);
bool is_product(const graph_node *n);

/* Whether a ratio of scales is 1 but for the rounding of the few constants that made it. */
bool is_one(double ratio);

#endif
