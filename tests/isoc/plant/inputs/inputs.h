/* The plant of a test of inputs, and its equations with a Jacobian. */
#ifndef ISO_TESTS_INPUTS_INPUTS_H
#define ISO_TESTS_INPUTS_INPUTS_H

#include "core/runtime/plant.h"

extern const iso_equations *const the_equations;

#endif
