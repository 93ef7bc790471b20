/* The equations of motion, as nodes: M(q) q'' + bias(q, q') + Phi_q' lambda = effort, Phi_q q'' = gamma.
 *
 * A tree of links alone needs the first; closed loops need both (tools/isoc/augmented.h).
 */
#ifndef ISOC_DYNAMICS_H
#define ISOC_DYNAMICS_H

#include "tools/isoc/augmented.h"

typedef struct dynamics {
    const mechanism *m;
    graph *g;
    kinematics k;
    mass_matrix mass;
    acceleration *accelerations; /* of the links, at q'' = 0 */
    node *acceleration;          /* [freedoms] q'' */
    augmented loops;             /* without constraints where nothing is closed */
} dynamics;

/* Makes the nodes of the accelerations. Its parts point to one another: it stays where it is. */
const dynamics *dynamics_build(graph *g, const mechanism *m);

/* Kinetic energy, gravitational energy (zero at the ground's origin) and energy of the springs; needs
 * kinematics_velocities. */
node dynamics_energy(const dynamics *d);

#endif
