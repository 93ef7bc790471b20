/* Accelerations of planar mechanisms by formulas derived by hand, in long double; each program links one. */
#ifndef ISO_TESTS_DYNAMICS_CLOSED_FORM_H
#define ISO_TESTS_DYNAMICS_CLOSED_FORM_H

#include "tests/isoc/dynamics/jet.h"

/* a[j] of the joints at positions q, speeds v and inputs u, as the scene names and orders them. */
void closed_form(wide *a, const wide *q, const wide *v, const wide *u);

#endif
