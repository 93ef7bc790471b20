/* The response of a plant to a sine, measured on the plant's own equations. */
#ifndef LINEAR_SINE_H
#define LINEAR_SINE_H

#include "core/runtime/plant.h"
#include "tools/linear/model.h"

/* Puts the plant to the point of a model. */
void plant_at(const iso_plant *plant, const model *m);

typedef struct measured {
    double complex gain; /* the first harmonic of the output over the sine */
    double left;         /* how far the motion is from a periodic one, of its size */
    bool found;
} measured;

/* Drives the input with a sine of w rad/s beside its value at the point, and finds the motion that repeats itself. It
 * is one of classical Runge-Kutta steps of the plant's derivative, in parts of a period that Newton's method joins: so
 * it is found also where the plant is unstable. */
measured measure(const iso_plant *plant, const model *m, int input, int output, double w);

/* The lowest frequency, rad/s, of which that does not take too long. */
double slowest_measured(const model *m);

#endif
