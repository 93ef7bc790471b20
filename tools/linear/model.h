/* A linear model as `isoc --linear` wrote it, with the point that it is about; and solutions with its matrices. */
#ifndef LINEAR_MODEL_H
#define LINEAR_MODEL_H

#include <complex.h>
#include <stdbool.h>
#include <stddef.h>

/* Names with their units. */
typedef struct labels {
    int count;
    char (*names)[80], (*units)[40];
} labels;

typedef struct model {
    int states, n;        /* of the plant, and of the model */
    int held, parameters; /* inputs with memories */
    double *x, *u, *p;    /* the point */
    labels rows, inputs, outputs;
    double *up, *down;       /* [states][n] and [n][states]: states of the plant by those of the model, and back */
    double *a, *b, *c, *d;   /* row by row */
    double *rates;           /* [n] at the point */
    double slowest, fastest; /* least and largest size of an eigenvalue that is not zero, rad/s; 0: none */
    double growth;           /* the largest real part, at least 0 */
} model;

/* Ends the program where the file is none. */
model model_read(const char *path);

/* b := m^-1 b by Gauss with the largest pivot of all; where m is singular, a solution of the regular rows, with zeros.
 */
void solve_complex(double complex *m, int n, double complex *b);

/* X of x = X e^(i w t) for an input e^(i w t): (i w - A)^-1 B. */
void response(const model *m, int input, double w, double complex *x);

/* The gain of an output over that input, with the x of `response`. */
double complex gain(const model *m, int input, int output, const double complex *x);

/* Whether nothing changes at the point, but positions that go on and on which nothing depends. */
bool is_steady(const model *m);

#endif
