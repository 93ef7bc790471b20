/* A plant with a solution known at one time; the program links one of each. */
#ifndef ISO_TESTS_ORDER_ORDER_H
#define ISO_TESTS_ORDER_ORDER_H

#include "core/runtime/plant.h"

enum { ORDER_STATES_MAX = 6, ORDER_INPUTS_MAX = 1 };

typedef struct order_problem {
    int states;
    double start[ORDER_STATES_MAX];
    double input[ORDER_INPUTS_MAX];                                         /* held */
    void (*exact)(long double y[ORDER_STATES_MAX], const double *defaults); /* at 1 s; of the plant's parameters */
} order_problem;

extern const order_problem the_problem;

/* The plant's, with its Jacobian. */
extern const iso_equations *const the_equations;

#endif
