/* How nodes are made of nodes: one row for each operation of tools/isoc/graph/operators.h. */
#ifndef ISOC_GRAPH_RULES_H
#define ISOC_GRAPH_RULES_H

#include "tools/isoc/graph/operators.h"

struct graph;

/* The derivative of node i, with those of its operands; and the same operation on others. NULL of leaves and functions
 * of the tick. */
typedef struct operator_rules {
    node (*derivative)(struct graph *g, node i, node da, node db);
    node (*again)(struct graph *g, node a, node b);
} operator_rules;

extern const operator_rules rules[OPERATIONS];

#endif
