/* 1 - hb J of a tree as a sparse matrix: its unknowns are, beside the changes of the states, those of all that recursive
 * Newton-Euler hands on from segment to segment. Each row then has what a segment and its neighbours have, so that a chain has a
 * number of entries, and of products of their factorisation, in proportion to its length; J itself is full. */
#ifndef ISOC_IMPLICIT_EXTENDED_H
#define ISOC_IMPLICIT_EXTENDED_H

#include "tools/isoc/dynamics/dynamics.h"
#include "tools/isoc/implicit/elimination.h"

typedef struct extended {
    elimination e;
    node *entries; /* [e.places] zero where it fills in */
    int *given;    /* [states] the row that has the right side of a state, in the order of the elimination */
    int *found;    /* [states] the unknown that the state is, likewise */
} extended;

const extended *extended_build(graph *g, const dynamics *d, const node *derivatives);

#endif
