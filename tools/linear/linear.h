/* Declarations shared by the files of `isochron linear`. */
#ifndef ISO_TOOLS_LINEAR_LINEAR_H
#define ISO_TOOLS_LINEAR_LINEAR_H

#include <complex.h>
#include <stdbool.h>
#include <stddef.h>

#include "core/runtime/plant.h"

/* model.c: a linear model as `isoc --linear` wrote it, with the point that it is about; and solutions with its
 * matrices. */

/* Names with their units. */
typedef struct labels {
    int count;
    char (*names)[80], (*units)[40];
} labels;

typedef struct model {
    int states, n;        /* of the plant, and of the model */
    int held, parameters; /* inputs with memories */
    double *x, *u, *p;    /* the point */
    labels inputs, outputs;
    double *up, *down;       /* [states][n] and [n][states]: states of the plant by those of the model, and back */
    double *a, *b, *c, *d;   /* row by row */
    double *rates;           /* [n] at the point */
    double slowest, fastest; /* least and largest size of an eigenvalue that is not zero, rad/s; 0: none */
    double growth;           /* the largest real part, at least 0 */
} model;

/* Ends the program if the file is no linear model. */
model model_read(const char *path);

/* b := m^-1 b with the largest pivot of all; where m is singular, a solution of the regular rows, with zeros. */
void solve_complex(double complex *m, int n, double complex *b);

/* X of x = X e^(i w t) for an input e^(i w t): (i w - A)^-1 B. */
void response(const model *m, int input, double w, double complex *x);

/* The gain of an output over that input. */
double complex gain(const model *m, int input, int output, double w);

/* Whether the point is steady: every derivative is zero, but for those of positions on which nothing depends. */
bool is_steady(const model *m);

/* sine.c: the response of a plant to a sine, measured on the plant's own equations. */

typedef struct measured {
    double complex gain; /* the first harmonic of the output over the sine */
    double left;         /* how far the motion is from a periodic one, of its size */
    bool found;
} measured;

/* Drives the input with a sine of w rad/s beside its value at the point, and finds the periodic motion. Classical
 * Runge-Kutta steps of the plant's derivative make it, in parts of a period that Newton's method joins: so it is found
 * also where the plant is unstable. */
measured measure(const iso_plant *plant, const model *m, int input, int output, double w);

/* The lowest frequency, rad/s, at which the measurement does not take too long. */
double slowest_measured(const model *m);

#endif
