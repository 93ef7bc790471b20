/* The equations of motion, as nodes: M(q) q'' + bias(q, q') + Phi_q' lambda = effort, Phi_q q'' = gamma.
 *
 * A tree of segments alone needs the first, which either formulation solves; closed loops need both, and the factors of M
 * (tools/isoc/closure/augmented.h).
 */
#ifndef ISOC_DYNAMICS_DYNAMICS_H
#define ISOC_DYNAMICS_DYNAMICS_H

#include "tools/isoc/closure/augmented.h"
#include "tools/isoc/dynamics/springs.h"

/* How the accelerations are found: from the factors of the mass matrix of composite bodies
 * (tools/isoc/tree/mass_matrix.h), or, of a tree, by articulated bodies (tools/isoc/tree/articulated.h). The closures
 * of loops, which are always composite, stand in the axes of their base, or of either side (tools/isoc/closure/side.h).
 */
typedef enum formulation {
    FORMULATION_COMPOSITE,
    FORMULATION_ARTICULATED,
    FORMULATION_PARENT_AXES,
    FORMULATION_CHILD_AXES,
    FORMULATIONS
} formulation;

extern const char *const formulation_names[FORMULATIONS];

/* Whether the formulation is possible: some are for trees, some for closed loops. */
bool formulation_fits(const mechanism *m, formulation f);

typedef struct dynamics {
    const mechanism *m;
    graph *g;
    kinematics k;
    mass_matrix mass;
    acceleration *accelerations; /* of the segments, at q'' = 0 */
    node *acceleration;          /* [degrees of freedom] q'' */
    const stretched *springs;    /* between points */
    augmented loops;             /* without constraints where nothing is closed */
} dynamics;

/* A lower bound of the products that composite bodies cost in the accelerations of a tree. The graph stays as it is. */
int composite_products(const graph *g, const mechanism *m);

/* Makes the nodes of the accelerations, in a formulation that fits. The parts have pointers to one another: the result
 * must not be copied. */
const dynamics *dynamics_build(graph *g, const mechanism *m, formulation chosen);

/* effort[degrees of freedom]: u - d q' - k (q - rest) + those of effects and of springs between points - bias. */
void efforts_less(const dynamics *d, const node *bias, node *effort);

#endif
