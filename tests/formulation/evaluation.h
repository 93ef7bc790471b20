/* One plant among several in a program, each in its formulation and its real: what the others need of it, in double. */
#ifndef ISO_TESTS_FORMULATION_EVALUATION_H
#define ISO_TESTS_FORMULATION_EVALUATION_H

#include <math.h>
#include <stddef.h>

enum { STATES_MAX = 128 };

typedef struct evaluation {
    size_t (*start)(double *x);                       /* their number */
    void (*step)(double *x, int steps);               /* with the inputs of tick 0 */
    void (*derivatives)(double *dx, const double *x); /* likewise */
} evaluation;

/* |a - b| / |b|, 2-norms. */
static inline double difference(const double *const a, const double *const b, const size_t n)
{
    double sum = 0.0, square = 0.0;
    for (size_t i = 0; i < n; i++) {
        sum += (a[i] - b[i]) * (a[i] - b[i]);
        square += b[i] * b[i];
    }
    return sqrt(sum / square);
}

extern const evaluation first_float, first_double, second_float, second_double;

#endif
