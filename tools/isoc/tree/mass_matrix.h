/* The mass matrix of a tree of segments, as nodes, factorised.
 *
 * Composite bodies in segment frames, after Khalil and Kleinfinger (1987), "Minimum operations and minimum parameters
 * of the dynamic models of tree structure robots", IEEE J. Robotics Automation 3(6); and the factorisation M = L' D L
 * of Featherstone (2008), Rigid Body Dynamics Algorithms, ch. 6, which keeps the zeros between branches.
 */
#ifndef ISOC_TREE_MASS_MATRIX_H
#define ISOC_TREE_MASS_MATRIX_H

#include "tools/isoc/tree/wrench.h"

typedef struct mass_matrix {
    const kinematics *k;
    int n;
    node *entries; /* [n n] of M, where one degree of freedom is an ancestor of the other: below the diagonal, and on it
                    */
    node *at;      /* [n n]: L below the diagonal, after the factorisation */
    node *pivots;  /* D_i: M_ii less the parts of the degrees of freedom beyond i */
    node *inverse; /* 1 / D_i */
} mass_matrix;

/* M itself; then its factors. */
mass_matrix mass_matrix_build(const kinematics *k);
void mass_matrix_factorise(mass_matrix *m);

/* The number of products of variables in the factorisation, from the zeros of M and the fill. */
int mass_matrix_products(const mass_matrix *m);

/* x := L'^-1 x, from the tips to the root; and x := L^-1 x, from the root to the tips. [n] */
void mass_matrix_inward(const mass_matrix *m, node *x);
void mass_matrix_outward(const mass_matrix *m, node *x);

/* x := D^-1 x; a division, if nothing else needs the inverse of the pivot. */
void mass_matrix_scale(const mass_matrix *m, node *x);

/* The whole mechanism as one body about the ground's origin. */
composite composite_of_all(const kinematics *k);

#endif
