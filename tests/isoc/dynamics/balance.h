/* Balances of energy and momentum with the accelerations of the plant. */
#ifndef ISO_TESTS_DYNAMICS_BALANCE_H
#define ISO_TESTS_DYNAMICS_BALANCE_H

#include "tests/isoc/dynamics/sample.h"

/* The worst over some states, each relative to its terms. */
typedef struct balances {
    wide energy; /* dE/dt = power of drives and applied forces - power of dampers */
    wide dof;    /* momentum of all that hangs on a joint, along each of its degrees of freedom */
    wide ground; /* momentum of the whole, all six components */
} balances;

/* With every acceleration of the plant times 1 + off. */
balances balances_of(const sample s[STATES], wide off);

/* The momentum of what hangs on each joint, all six components, with the reactions of s->exact: the worst. */
wide balance_of_reactions(const sample *s);

#endif
