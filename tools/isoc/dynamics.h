/* The equations of motion of a tree of links, as nodes: M(q) q'' + bias(q, q') = effort.
 *
 * Everything is said in link frames about link origins, after Khalil and Kleinfinger (1987), "Minimum operations and
 * minimum parameters of the dynamic models of tree structure robots", IEEE J. Robotics Automation 3(6): bias by
 * recursive Newton-Euler, mass matrix by composite bodies, and the factorisation M = L' D L of Featherstone (2008),
 * Rigid Body Dynamics Algorithms, ch. 6, which keeps the zeros between branches.
 */
#ifndef ISOC_DYNAMICS_H
#define ISOC_DYNAMICS_H

#include "tools/isoc/mechanism.h"

/* What each link's joint does: coordinate q, speed qd, sine and cosine of the turn, the origin's place. */
typedef struct motion {
    node q, qd;   /* states */
    node s, c;    /* of the turn about the link's axis; 0 and 1 for a prismatic joint */
    node rate;    /* sign * qd: along the link's axis */
    vector p;     /* the link's origin in the parent's frame */
    vector omega; /* angular velocity, in the link's axes */
    vector v;     /* velocity of the origin, in the link's axes; only for outputs */
} motion;

typedef struct dynamics {
    const mechanism *m;
    graph *g;
    motion *motions;
    node *acceleration; /* q'' of each link */
    node *inertias;     /* M_ii */
    node *pivots;       /* D of the factorisation: M_ii less what the joints beyond i take off */
} dynamics;

/* Makes the nodes of the accelerations. */
dynamics dynamics_build(graph *g, const mechanism *m);

/* A vector from link axes to the parent's axes and back. */
vector to_parent(const dynamics *d, int link, vector a);
vector from_parent(const dynamics *d, int link, vector a);

/* Position and velocity, in the ground's frame, of a point of a link; velocities need dynamics_velocities first. */
void dynamics_velocities(dynamics *d);
vector point_position(const dynamics *d, int link, vector point);
vector point_velocity(const dynamics *d, int link, vector point);

/* Kinetic energy, gravitational energy (zero at the ground's origin) and energy of the springs; needs
 * dynamics_velocities. */
node dynamics_energy(const dynamics *d);

#endif
