/* The account of energy, as nodes: what the mechanism has, and the power of all that changes it.
 *
 *     E = T + V + what springs and effects store
 *     P = inputs - dampers + closures + effects
 *
 * In the motion E' = P. An effect counts with its work less its loss where it tells them, so that these, what it stores
 * and what it gives to the mechanism must fit; else with what it gives and what it stores. A closure has -lambda Phi_q q':
 * the power of a motion, and of any other that of a rate which is violated.
 *
 * All need kinematics_velocities.
 */
#ifndef ISOC_DYNAMICS_ACCOUNT_H
#define ISOC_DYNAMICS_ACCOUNT_H

#include "tools/isoc/dynamics/dynamics.h"

/* E: kinetic, of gravity (zero at the ground's origin), of the springs and of effects. */
node account_energy(const dynamics *d);

/* P. */
node account_power(const dynamics *d);

/* E' - P, with the derivatives of the states. */
node account_balance(const dynamics *d);

#endif
