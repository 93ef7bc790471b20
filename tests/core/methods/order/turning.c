/* Semi-implicit Euler on a body that turns freely, where positions are more than speeds: its order, and its energy. The
 * last positions are a quaternion; the last three states are the angular velocity omega, in axes in which the body's
 * inertia J is diagonal.
 *
 * A step adds h omega' to omega and turns by h times the new omega, to h^3. With the torque tau = J omega' + omega x
 * J omega of a potential it changes the energy by
 *
 *     h^2 / 2 (omega'.J omega' - 2 tau.omega' - tau'.omega) = -h^2 / 2 ((omega x J omega).omega' + (tau.omega)')
 *
 * and terms of h^3. So the energy is not kept, as an oscillator's is: after 1 s it is off by h times a number L that
 * the exact motion gives, and by terms of h^2.
 */
#include <math.h>
#include <string.h>

#include "core/methods/all.h"
#include "core/methods/method.h"
#include "tests/core/methods/order/order.h"
#include "tests/host/report.h"

enum { COARSEST = 10, HALVINGS = 3, STATES_MAX = 13 };

static const double inertia[3] = {2.0, 3.0, 4.0};

/* log2 of the ratio of two errors is 1 + D h / (2 ln 2), D the rate at which the motion changes: below 50 / s, */
#define ORDER_TOLERANCE (50.0 * 0x1p-10 / (2.0 * 0.6931))
/* and what is left of the energy's error over h, when its term of h is taken off, is D^2 h^2. */
#define ENERGY_TOLERANCE (50.0 * 50.0 * 0x1p-24)

typedef struct motion {
    double x[STATES_MAX];
    double limit; /* L */
} motion;

static void normalise(double *const q)
{
    const double norm = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (int i = 0; i < 4; i++) {
        q[i] /= norm;
    }
}

/* (omega x J omega).omega' and omega.J omega', which is tau.omega. */
static void rates_of_energy(const double *const x, double *const gyroscopic, double *const power)
{
    double dx[STATES_MAX];
    the_equations->derivative(dx, x, NULL, NULL);
    const double *const omega = x + iso_the_plant.model->states - 3;
    const double *const alpha = dx + iso_the_plant.model->states - 3;
    *gyroscopic = *power = 0.0;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        *gyroscopic += alpha[i] * omega[j] * omega[k] * (inertia[k] - inertia[j]);
        *power += alpha[i] * omega[i] * inertia[i];
    }
}

/* To 1 s by steps of 2^-k s; L by the trapezoidal rule. */
static motion run(const unsigned recipe, const iso_equations *const eq, const int k)
{
    const size_t n = iso_the_plant.model->states;
    const double h = ldexp(1.0, -k);
    double work[ISO_EXPLICIT_VECTORS * STATES_MAX], gyroscopic, next, power;
    motion made = {.limit = 0.0};
    memcpy(made.x, iso_the_plant.model->start, n * sizeof *made.x);
    rates_of_energy(made.x, &gyroscopic, &power);
    made.limit = 0.5 * power;
    for (long step = 0; step < 1L << k; step++) {
        iso_method_step(recipe, n, eq, h, made.x, NULL, NULL, NULL, work, NULL);
        normalise(made.x + the_equations->positions - 4);
        rates_of_energy(made.x, &next, &power);
        made.limit -= 0.25 * h * (gyroscopic + next);
        gyroscopic = next;
    }
    made.limit -= 0.5 * power;
    return made;
}

static double distance(const double *const a, const double *const b)
{
    double square = 0.0;
    for (int i = 0; i < iso_the_plant.model->states; i++) {
        square += (a[i] - b[i]) * (a[i] - b[i]);
    }
    return sqrt(square);
}

static double energy_of(const double *const x)
{
    memcpy(iso_the_plant.x, x, iso_the_plant.model->states * sizeof *x);
    iso_the_plant.model->output(iso_the_plant.memory);
    return iso_the_plant.y[0];
}

static void test_order(const motion *const exact)
{
    double worst = 0.0;
    double coarse = distance(run(ISO_SEMI_IMPLICIT, the_equations, COARSEST).x, exact->x);
    for (int k = COARSEST + 1; k <= COARSEST + HALVINGS; k++) {
        const double fine = distance(run(ISO_SEMI_IMPLICIT, the_equations, k).x, exact->x);
        report_note("h = 2^-%d to 2^-%d s: error %.3e to %.3e", k - 1, k, coarse, fine);
        worst = fmax(worst, fabs(log2(coarse / fine) - 1.0));
        coarse = fine;
    }
    report_ok(worst <= ORDER_TOLERANCE, "the order is 1: off by %.4f <= %.4f over %d halvings", worst, ORDER_TOLERANCE,
              HALVINGS);
}

/* The energy's error over h at 1 s, without its term of h, relative to what is derived. */
static double energy_off(const unsigned recipe, const motion *const exact)
{
    const double begin = energy_of(iso_the_plant.model->start);
    const double h = ldexp(1.0, -COARSEST);
    const double coarse = (energy_of(run(recipe, the_equations, COARSEST).x) - begin) / h;
    const double fine = (energy_of(run(recipe, the_equations, COARSEST + 1).x) - begin) / (h / 2.0);
    return fabs((2.0 * fine - coarse) / exact->limit - 1.0);
}

int main(void)
{
    const size_t n = iso_the_plant.model->states;
    if (!report_ok(n <= STATES_MAX && iso_the_plant.model->outputs == 1 && the_equations->rates != NULL &&
                       the_equations->positions == (n + 1) / 2,
                   "the plant has rates of its own, and one position more than speeds")) {
        return report_done();
    }
    const motion exact = run(ISO_RK4, the_equations, COARSEST + HALVINGS);
    const iso_equations halved = {.derivative = the_equations->derivative};
    test_order(&exact);
    const double off = energy_off(ISO_SEMI_IMPLICIT, &exact);
    report_ok(off <= ENERGY_TOLERANCE, "the energy is off by h times %.4f J/s, as derived, to %.1e <= %.1e",
              exact.limit, off, ENERGY_TOLERANCE);
    report_ok(energy_off(ISO_HEUN, &exact) > ENERGY_TOLERANCE, "control: that of heun is not");
    const double away = distance(run(ISO_SEMI_IMPLICIT, &halved, COARSEST).x, exact.x);
    report_ok(away > 0.1, "control: halves taken for positions and speeds end elsewhere, by %.1e", away);
    return report_done();
}
