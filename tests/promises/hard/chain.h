/* A planar chain of point masses on massless rods of one length, hanging from the origin, by the tensions of its rods:
 * a formulation other than isoc's mass matrix, and linear in the number of links.
 *
 * States: the angles q_i of the rods from the downward vertical, then their rates. p: gravity, the length l, the
 * masses' inverses w_i. With D_i = sin(q_(i+1) - q_i) and C_i its cosine, the rods keep their length where
 *
 *     (w_i + w_(i-1)) T_i - w_i C_i T_(i+1) - w_(i-1) C_(i-1) T_(i-1) = l q_i'^2,   w_0 = 0,
 *
 * and + g cos q_1 on the right of the first: a symmetric system with three diagonals, dominated by the middle one. Then
 *
 *     l q_i'' = w_i D_i T_(i+1) - w_(i-1) D_(i-1) T_(i-1),
 *
 * and - g sin q_1 in the first.
 */
#ifndef ISO_TESTS_HARD_CHAIN_H
#define ISO_TESTS_HARD_CHAIN_H

#include "tests/promises/hard/hard.h"

enum { CHAIN_LINKS_MAX = HARD_STATES_MAX / 2, CHAIN_GRAVITY = 0, CHAIN_LENGTH, CHAIN_INVERSE_MASSES };

/* Of so many links. */
extern const iso_equations chain_of_1;
extern const iso_equations chain_of_2;
extern const iso_equations chain_of_3;
extern const iso_equations chain_of_10;

/* Its energy, zero where it hangs straight down at rest. */
double chain_energy(const hard_run *run);

#endif
