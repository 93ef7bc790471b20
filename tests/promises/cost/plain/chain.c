/* A planar chain of RODS uniform rods of 1 m and 1 kg, as tools/lab/chain.py describes it, by the equations of
 * Lagrange in absolute angles th_i. */
#ifndef RODS
#define RODS 8
#endif
#define STATES (2 * RODS)
#define UNKNOWNS RODS
#include "tests/promises/cost/plain/plain.h"

enum { N = RODS };

const size_t plain_states = STATES;
const double plain_start[STATES] = {1.5707963267948966};

/* M_ij = m_ij cos(th_i - th_j), sum_j M_ij a_j = -sum_j m_ij sin(th_i - th_j) w_j^2 - (N - i - 1/2) g sin th_i. */
static void derivative(double *const dx, const double *const x)
{
    const double inertia = 1.0 / 12.0 + 0.01 * 0.01 / 4.0;
    double sine[N], cosine[N], speed[N], mass[N][N], a[N];
    double angle = 0.0, rate = 0.0;
    for (int i = 0; i < N; i++) {
        angle += x[i];
        rate += x[N + i];
        sine[i] = sin(angle);
        cosine[i] = cos(angle);
        speed[i] = rate;
    }
    for (int i = 0; i < N; i++) {
        a[i] = -9.81 * (N - i - 0.5) * sine[i];
        for (int j = 0; j < N; j++) {
            const int outer = i > j ? i : j;
            const double beyond = i == j ? inertia + 0.25 + (N - 1 - i) : 0.5 + (N - 1 - outer);
            mass[i][j] = beyond * (cosine[i] * cosine[j] + sine[i] * sine[j]);
            a[i] -= beyond * (sine[i] * cosine[j] - cosine[i] * sine[j]) * speed[j] * speed[j];
        }
    }
    plain_solve(mass, a);
    for (int i = 0; i < N; i++) {
        dx[i] = x[N + i];
        dx[N + i] = i == 0 ? a[0] : a[i] - a[i - 1];
    }
}

void plain_step(double *const x)
{
    plain_rk4(x);
}
