/* Functions of time to second order, f(t) = c[0] + c[1] t + c[2] t^2, in long double; and vectors and matrices of them.
 *
 * A motion q(t) = q + q' t + q'' t^2 / 2 put through sums, products, sines and cosines gives velocities and
 * accelerations of everything that depends on it, without a formula for either.
 */
#ifndef ISO_TESTS_DYNAMICS_JET_H
#define ISO_TESTS_DYNAMICS_JET_H

#include <math.h>

typedef long double wide;

typedef struct jet {
    wide c[3];
} jet;

typedef struct jet3 {
    jet x[3];
} jet3;

typedef struct jet33 {
    jet m[3][3];
} jet33;

static inline jet jet_constant(const wide a)
{
    return (jet){{a, 0.0L, 0.0L}};
}

static inline jet jet_add(const jet a, const jet b)
{
    return (jet){{a.c[0] + b.c[0], a.c[1] + b.c[1], a.c[2] + b.c[2]}};
}

static inline jet jet_scale(const wide k, const jet a)
{
    return (jet){{k * a.c[0], k * a.c[1], k * a.c[2]}};
}

static inline jet jet_sub(const jet a, const jet b)
{
    return jet_add(a, jet_scale(-1.0L, b));
}

static inline jet jet_mul(const jet a, const jet b)
{
    return (jet){{
        a.c[0] * b.c[0],
        a.c[0] * b.c[1] + a.c[1] * b.c[0],
        a.c[0] * b.c[2] + a.c[1] * b.c[1] + a.c[2] * b.c[0],
    }};
}

static inline jet jet_sin(const jet a)
{
    const wide s = sinl(a.c[0]);
    const wide c = cosl(a.c[0]);
    return (jet){{s, c * a.c[1], c * a.c[2] - s * a.c[1] * a.c[1] / 2.0L}};
}

static inline jet jet_cos(const jet a)
{
    const wide s = sinl(a.c[0]);
    const wide c = cosl(a.c[0]);
    return (jet){{c, -s * a.c[1], -s * a.c[2] - c * a.c[1] * a.c[1] / 2.0L}};
}

/* f'(t), known to first order only: its second-order coefficient is set to zero and must not be used. */
static inline jet jet_rate(const jet a)
{
    return (jet){{a.c[1], 2.0L * a.c[2], 0.0L}};
}

static inline jet3 jet3_constant(const wide a[3])
{
    return (jet3){{jet_constant(a[0]), jet_constant(a[1]), jet_constant(a[2])}};
}

static inline jet3 jet3_add(const jet3 a, const jet3 b)
{
    return (jet3){{jet_add(a.x[0], b.x[0]), jet_add(a.x[1], b.x[1]), jet_add(a.x[2], b.x[2])}};
}

static inline jet3 jet3_scale(const wide k, const jet3 a)
{
    return (jet3){{jet_scale(k, a.x[0]), jet_scale(k, a.x[1]), jet_scale(k, a.x[2])}};
}

static inline jet3 jet3_rate(const jet3 a)
{
    return (jet3){{jet_rate(a.x[0]), jet_rate(a.x[1]), jet_rate(a.x[2])}};
}

static inline jet jet3_dot(const jet3 a, const jet3 b)
{
    return jet_add(jet_add(jet_mul(a.x[0], b.x[0]), jet_mul(a.x[1], b.x[1])), jet_mul(a.x[2], b.x[2]));
}

static inline jet3 jet3_cross(const jet3 a, const jet3 b)
{
    jet3 r;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        r.x[i] = jet_sub(jet_mul(a.x[j], b.x[k]), jet_mul(a.x[k], b.x[j]));
    }
    return r;
}

static inline jet33 jet33_mul(const jet33 *const a, const jet33 *const b)
{
    jet33 r;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            r.m[i][j] = jet_add(jet_add(jet_mul(a->m[i][0], b->m[0][j]), jet_mul(a->m[i][1], b->m[1][j])),
                                jet_mul(a->m[i][2], b->m[2][j]));
        }
    }
    return r;
}

static inline jet33 jet33_transposed(const jet33 *const a)
{
    jet33 r;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            r.m[i][j] = a->m[j][i];
        }
    }
    return r;
}

static inline jet3 jet33_apply(const jet33 *const a, const jet3 b)
{
    jet3 r;
    for (int i = 0; i < 3; i++) {
        r.x[i] = jet3_dot((jet3){{a->m[i][0], a->m[i][1], a->m[i][2]}}, b);
    }
    return r;
}

#endif
