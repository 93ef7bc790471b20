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

/* How far a plant in float is off what the first says in double at the same states, x[n] as floats hold them: there a
 * quaternion's length is off one, which formulations feel. */
static inline double error_in_float(const evaluation *const plant, const double *const x, const size_t n)
{
    double single[STATES_MAX], exact[STATES_MAX], rough[STATES_MAX];
    for (size_t i = 0; i < n; i++) {
        single[i] = (double)(float)x[i];
    }
    first_double.derivatives(exact, single);
    plant->derivatives(rough, single);
    return difference(rough, exact, n);
}

#endif
