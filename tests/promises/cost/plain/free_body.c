/* models/rigid_body.scene with gravity: place, quaternion, velocity in the axes of the ground, spin in those of the
 * body. */
#define STATES 13
#define UNKNOWNS 6
#include "tests/promises/cost/plain/plain.h"

const size_t plain_states = STATES;
const double plain_start[STATES] = {[3] = 1.0, [10] = 0.01, [11] = 5.0, [12] = 0.01};

/* M v' = F, J w' = -w x J w, q' = q w / 2. */
static void derivative(double *const dx, const double *const x)
{
    static const double inertia[3] = {1.0, 2.0, 3.0};
    const double *const q = x + 3, *const w = x + 10;
    double mass[6][6] = {{0.0}}, a[6] = {0.0, 0.0, -9.81};
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        dx[i] = x[7 + i];
        mass[i][i] = 1.0;
        mass[3 + i][3 + i] = inertia[i];
        a[3 + i] = -(w[j] * (inertia[k] * w[k]) - w[k] * (inertia[j] * w[j]));
    }
    dx[3] = -0.5 * (q[1] * w[0] + q[2] * w[1] + q[3] * w[2]);
    dx[4] = 0.5 * (q[0] * w[0] + q[2] * w[2] - q[3] * w[1]);
    dx[5] = 0.5 * (q[0] * w[1] + q[3] * w[0] - q[1] * w[2]);
    dx[6] = 0.5 * (q[0] * w[2] + q[1] * w[1] - q[2] * w[0]);
    plain_solve(mass, a);
    for (int i = 0; i < 6; i++) {
        dx[7 + i] = a[i];
    }
}

void plain_step(double *const x)
{
    plain_rk4(x);
    const double length = sqrt(x[3] * x[3] + x[4] * x[4] + x[5] * x[5] + x[6] * x[6]);
    for (int i = 3; i < 7; i++) {
        x[i] /= length;
    }
}
