/* models/four_bar.scene without its motor: absolute angles of the crank, the coupler and the rocker, two closures,
 * Lagrange multipliers, and the states put onto the closures after each step. */
#define STATES 6
#define UNKNOWNS 5
#include "tests/promises/cost/plain/plain.h"

#include <string.h>

enum { RODS = 3, CLOSURES = 2 };

const size_t plain_states = STATES;
const double plain_start[STATES] = {1.5707963267948966, -1.176005207095135, 2.214297435588181, 21.0, -26.0, 8.0};

static const double length[RODS] = {0.10, 0.26, 0.25}, mass[RODS] = {0.2, 0.3, 0.25};

typedef struct linkage {
    double sine[RODS], cosine[RODS], speed[RODS];
    double jacobian[CLOSURES][RODS];
    double system[UNKNOWNS][UNKNOWNS]; /* M, Phi_q'; Phi_q, 0 */
} linkage;

/* The system stands for two right sides, and each elimination takes a copy. Its pivots are never zero in this order:
 * M is definite, and so is what is left of it for the closures. */
static void solve(const linkage *const at, double *const b)
{
    double a[UNKNOWNS][UNKNOWNS];
    memcpy(a, at->system, sizeof a);
    plain_solve(a, b);
}

static linkage linkage_at(const double *const x)
{
    linkage at = {.speed = {x[3], x[3] + x[4], x[5]}};
    const double angle[RODS] = {x[0], x[0] + x[1], x[2]}, sign[RODS] = {1.0, 1.0, -1.0};
    for (int i = 0; i < RODS; i++) {
        at.sine[i] = sin(angle[i]);
        at.cosine[i] = cos(angle[i]);
        at.jacobian[0][i] = -sign[i] * length[i] * at.sine[i];
        at.jacobian[1][i] = sign[i] * length[i] * at.cosine[i];
        at.system[i][i] = mass[i] * length[i] * length[i] / 3.0;
        for (int r = 0; r < CLOSURES; r++) {
            at.system[RODS + r][i] = at.system[i][RODS + r] = at.jacobian[r][i];
        }
    }
    at.system[0][0] += mass[1] * length[0] * length[0];
    at.system[0][1] = at.system[1][0] =
        mass[1] * length[0] * length[1] / 2.0 * (at.cosine[0] * at.cosine[1] + at.sine[0] * at.sine[1]);
    return at;
}

static void derivative(double *const dx, const double *const x)
{
    linkage at = linkage_at(x);
    const double turned = at.sine[0] * at.cosine[1] - at.cosine[0] * at.sine[1];
    const double coupling = mass[1] * length[0] * length[1] / 2.0 * turned, g = 9.81;
    double a[UNKNOWNS] = {-coupling * at.speed[1] * at.speed[1] -
                              (mass[0] / 2.0 + mass[1]) * g * length[0] * at.cosine[0],
                          coupling * at.speed[0] * at.speed[0] - mass[1] / 2.0 * g * length[1] * at.cosine[1],
                          -mass[2] / 2.0 * g * length[2] * at.cosine[2]};
    for (int i = 0; i < RODS; i++) {
        a[RODS] += at.jacobian[1][i] * at.speed[i] * at.speed[i];
        a[RODS + 1] -= at.jacobian[0][i] * at.speed[i] * at.speed[i];
    }
    plain_solve(at.system, a);
    dx[0] = x[3];
    dx[1] = x[4];
    dx[2] = x[5];
    dx[3] = a[0];
    dx[4] = a[1] - a[0];
    dx[5] = a[2];
}

/* Moves x[0..2] by what takes away `off` with the least motion, as the masses weigh it. */
static void project(double *const x, const linkage *const at, const double *const off)
{
    double move[UNKNOWNS] = {0.0, 0.0, 0.0, -off[0], -off[1]};
    solve(at, move);
    x[0] += move[0];
    x[1] += move[1] - move[0];
    x[2] += move[2];
}

void plain_step(double *const x)
{
    plain_rk4(x);
    const linkage at = linkage_at(x);
    project(x, &at,
            (const double[]){length[0] * at.cosine[0] + length[1] * at.cosine[1] - length[2] * at.cosine[2] - 0.39,
                             length[0] * at.sine[0] + length[1] * at.sine[1] - length[2] * at.sine[2]});
    const linkage put = linkage_at(x);
    double rate[CLOSURES] = {0.0, 0.0};
    for (int r = 0; r < CLOSURES; r++) {
        for (int i = 0; i < RODS; i++) {
            rate[r] += put.jacobian[r][i] * put.speed[i];
        }
    }
    project(x + RODS, &put, rate);
}
