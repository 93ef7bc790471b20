/* models/cart_pole.scene, whose parameters may change, at rest of its force. */
#define STATES 4
#define UNKNOWNS 2
#include "tests/promises/cost/plain/plain.h"

double plain_rod_mass = 0.2, plain_half_length = 0.25, plain_rail_damping = 0.1, plain_force = 0.0;

const size_t plain_states = STATES;
const double plain_start[STATES] = {0.0, 0.087266462599716474, 0.0, 0.0};

static void derivative(double *const dx, const double *const x)
{
    const double m = plain_rod_mass, l = plain_half_length, s = sin(x[1]), c = cos(x[1]);
    double mass[2][2] = {{1.0 + m, m * l * c}, {m * l * c, m * l * l + m * l * l / 3.0}};
    double a[2] = {plain_force - plain_rail_damping * x[2] + m * l * s * x[3] * x[3], m * 9.81 * l * s - 0.002 * x[3]};
    plain_solve(mass, a);
    dx[0] = x[2];
    dx[1] = x[3];
    dx[2] = a[0];
    dx[3] = a[1];
}

void plain_step(double *const x)
{
    plain_rk4(x);
}
