/* A bushing between two bodies in space. For small displacements and speeds its forces and moments are the products of
 * its stiffness, in all six components at once; for large ones energy and both momenta stay, and with damping the
 * energy falls. */
#include <float.h>
#include <math.h>
#include <string.h>

#include PLANT
#include "core/runtime/tick.h"
#include "tests/host/report.h"

#ifdef ISO_REAL_DOUBLE
#define ULP DBL_EPSILON
#else
#define ULP ((double)FLT_EPSILON)
#endif

enum { TICKS = 2000 };

static const int place[2] = {PLANT_X_FIRST_X, PLANT_X_SECOND_X},
                 turn[2] = {PLANT_X_FIRST_TURN_W, PLANT_X_SECOND_TURN_W},
                 speed[2] = {PLANT_X_FIRST_X_SPEED, PLANT_X_SECOND_X_SPEED},
                 spin[2] = {PLANT_X_FIRST_TURN_X_SPEED, PLANT_X_SECOND_TURN_X_SPEED};
static const double mass[2] = {1.0, 2.0}, inertia[2][3] = {{0.010, 0.012, 0.015}, {0.030, 0.040, 0.050}};
static const double stiff[3] = {500.0, 800.0, 1000.0}, turning[3] = {4.0, 6.0, 9.0}, time_constant = 10e-3;
static const iso_plant *plant;

static void cross(const double a[3], const double b[3], double made[3])
{
    for (int i = 0; i < 3; i++) {
        made[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    }
}

/* A vector in the axes of a body, in those of the ground: v + 2 q x (q x v + w v). */
static void turned(const int body, const double v[3], double made[3])
{
    const real *const q = &plant->x[turn[body]];
    const double along[3] = {(double)q[1], (double)q[2], (double)q[3]};
    double once[3], twice[3];
    cross(along, v, once);
    for (int i = 0; i < 3; i++) {
        once[i] += (double)q[0] * v[i];
    }
    cross(along, once, twice);
    for (int i = 0; i < 3; i++) {
        made[i] = v[i] + 2.0 * twice[i];
    }
}

/* Linear momentum, and angular momentum about the origin. */
static void momenta(double made[6])
{
    memset(made, 0, 6 * sizeof *made);
    for (int b = 0; b < 2; b++) {
        double of_spin[3], own[3], at[3], linear[3], orbital[3];
        for (int i = 0; i < 3; i++) {
            of_spin[i] = inertia[b][i] * (double)plant->x[spin[b] + i];
            at[i] = (double)plant->x[place[b] + i];
            linear[i] = mass[b] * (double)plant->x[speed[b] + i];
        }
        turned(b, of_spin, own);
        cross(at, linear, orbital);
        for (int i = 0; i < 3; i++) {
            made[i] += linear[i];
            made[3 + i] += own[i] + orbital[i];
        }
    }
}

/* The first body is moved by d and turned by phi, or has these speeds: what the derivative says of both bodies, against
 * F = -k d at its point and M = -k phi, in the axes of the second. */
static void check_small(const bool is_moving)
{
    static const double d[3] = {1e-3, -2e-3, 1.5e-3}, phi[3] = {2e-3, 1e-3, -3e-3};
    const double factor = is_moving ? time_constant : 1.0, lever[3] = {-0.1, 0.0, 0.0},
                 other_lever[3] = {0.2, 0.0, 0.0};
    double swing[3], force[3], moment[3], of_force[3], of_other[3], worst = 0.0;
    cross(phi, lever, swing);
    iso_plant_start(plant);
    plant->p[PLANT_P_DAMPING] = is_moving ? (real)time_constant : R(0.0);
    for (int b = 0; b < 2; b++) {
        for (int i = 0; i < 3; i++) {
            plant->x[place[b] + i] = plant->x[speed[b] + i] = plant->x[spin[b] + i] = R(0.0);
            plant->x[turn[b] + 1 + i] = R(0.0);
        }
        plant->x[turn[b]] = R(1.0);
    }
    plant->x[place[0]] = R(0.3);
    for (int i = 0; i < 3; i++) {
        plant->x[(is_moving ? speed : place)[0] + i] += (real)d[i];
        plant->x[is_moving ? spin[0] + i : turn[0] + 1 + i] = (real)(is_moving ? phi[i] : phi[i] / 2.0);
        force[i] = -stiff[i] * factor * (d[i] + swing[i]);
        moment[i] = -turning[i] * factor * phi[i];
    }
    real rate[PLANT_STATES];
    iso_the_derivative(rate, plant->x, plant->u, plant->p);
    cross(lever, force, of_force);
    cross(other_lever, force, of_other);
    for (int i = 0; i < 3; i++) {
        /* All of the order of 3 N and 0.3 N*m. */
        worst = fmax(worst, fabs((double)rate[speed[0] + i] - force[i] / mass[0]) / 3.0);
        worst = fmax(worst, fabs((double)rate[speed[1] + i] + force[i] / mass[1]) / 1.5);
        worst = fmax(worst, fabs((double)rate[spin[0] + i] * inertia[0][i] - of_force[i] - moment[i]) / 0.3);
        worst = fmax(worst, fabs((double)rate[spin[1] + i] * inertia[1][i] + of_other[i] + moment[i]) / 0.6);
    }
    /* What is left out: angles of 4 mrad to the second order, and products of spins. And the rounding of 0.3 m at 1
     * kN/m, over 3 N. */
    const double allowed = (is_moving ? 1e-6 : 8e-3) + 100.0 * ULP;
    report_ok(worst <= allowed, "small %s: %.2g off, at most %.2g", is_moving ? "speeds" : "displacements", worst,
              allowed);
}

/* Both turn as one body, with 3 rad/s about the origin: the damping does nothing. */
static void check_common(void)
{
    static const double omega[3] = {1.0, 2.0, -2.0};
    real rate[2][PLANT_STATES];
    double off = 0.0;
    iso_plant_start(plant);
    for (int b = 0; b < 2; b++) {
        double at[3], moves[3];
        for (int i = 0; i < 3; i++) {
            at[i] = (double)plant->x[place[b] + i];
        }
        cross(omega, at, moves);
        for (int i = 0; i < 3; i++) {
            plant->x[speed[b] + i] = (real)moves[i];
            plant->x[spin[b] + i] = (real)omega[i];
        }
    }
    for (int damped = 0; damped < 2; damped++) {
        plant->p[PLANT_P_DAMPING] = damped ? (real)time_constant : R(0.0);
        iso_the_derivative(rate[damped], plant->x, plant->u, plant->p);
    }
    for (int b = 0; b < 2; b++) {
        for (int i = 0; i < 3; i++) {
            off = fmax(off, fabs((double)(rate[1][speed[b] + i] - rate[0][speed[b] + i])));
            off = fmax(off, 0.03 * fabs((double)(rate[1][spin[b] + i] - rate[0][spin[b] + i])));
        }
    }
    /* Speeds of 1 m/s, times 1 kN/m and 10 ms. */
    report_ok(off <= 16.0 * ULP * 10.0, "a common turning is not damped: %.2g m/s^2", off);
}

static void check_large(const bool is_damped)
{
    double first[6], now[6], momenta_off = 0.0, energy_off = 0.0, rise = 0.0;
    iso_plant_start(plant);
    plant->p[PLANT_P_DAMPING] = is_damped ? (real)time_constant : R(0.0);
    plant->model->output(plant->memory);
    const double before = (double)plant->y[PLANT_Y_ENERGY];
    double last = before;
    momenta(first);
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        (void)iso_plant_tick(plant, tick);
        const double energy = (double)plant->y[PLANT_Y_ENERGY];
        momenta(now);
        for (int i = 0; i < 6; i++) {
            momenta_off = fmax(momenta_off, fabs(now[i] - first[i]));
        }
        energy_off = fmax(energy_off, fabs(energy - before) / before);
        rise = fmax(rise, (energy - last) / before);
        last = energy;
    }
    /* The fastest motion is below 100 rad/s; of it rk4 leaves out (100 h)^5 / 120 in a step. Places are rounded as 1 m,
     * against a force of 10 N. */
    const double left_out = pow(0.1, 5.0) / 120.0, rounding = 16.0 * ULP + 10.0 * ULP / before;
    report_ok(momenta_off <= TICKS * (left_out + rounding), "the momenta stay: %.2g off", momenta_off);
    if (is_damped) {
        report_ok(rise <= left_out + rounding && last < 0.9 * before,
                  "damping takes energy in every tick: %.3g is left, %.2g came", last / before, rise);
    } else {
        report_ok(energy_off <= TICKS * (left_out + rounding), "the energy stays: %.2g of it changes", energy_off);
    }
}

int main(void)
{
    plant = &iso_the_plant;
    check_small(false);
    check_small(true);
    check_common();
    check_large(false);
    check_large(true);
    return report_done();
}
