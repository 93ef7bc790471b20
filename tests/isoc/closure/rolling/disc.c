/* A thin disc that rolls on a plane, against its equations of motion written by hand, and its steady motions.
 *
 * In the axes u (level), e (up in the disc) and w (the axle), with w at the angle theta from the plane's normal n, the
 * angular velocity is (p, q, r), and these axes turn with (p, q, q cot theta); the lowest point is at -radius e from
 * the centre and rests, so that the centre's velocity is radius (-r, 0, p). Newton's and Euler's equations, without the
 * contact force, for the moments of inertia A across the axle and C about it (O'Reilly 1996, The dynamics of rolling
 * disks and sliding disks, Nonlinear Dynamics 10):
 *
 *     (A + m radius^2) p' = A q^2 cot theta - (C + m radius^2) q r - m g radius cos theta
 *     A q' = C p r - A p q cot theta
 *     (C + m radius^2) r' = m radius^2 p q
 *     theta' = p,  psi' = q / sin theta,  centre' = radius (-r u + p w)
 *
 * A motion is steady where p = 0 and the right side of the first is zero.
 *
 *     disc THETA P Q R NX NY NZ: the plant's start, in rad and rad/s, and the normal
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/runtime/tick.h"
#include "tests/host/report.h"
#include "tests/reference/named.h"

enum { THETA, PSI, P, Q, SPIN, X, Y, STATES };

static const double mass = 2.0, radius = 0.3, across = 0.045, about = 0.09, gravity = 9.81;

static void derivative(double *const dx, const double *const x)
{
    const double s = sin(x[THETA]), c = cos(x[THETA]), cot = c / s, mrr = mass * radius * radius;
    const double p = x[P], q = x[Q], r = x[SPIN];
    dx[THETA] = p;
    dx[PSI] = q / s;
    dx[P] = (across * q * q * cot - (about + mrr) * q * r - mass * gravity * radius * c) / (across + mrr);
    dx[Q] = (about * p * r - across * p * q * cot) / across;
    dx[SPIN] = mrr * p * q / (about + mrr);
    dx[X] = radius * (-r * cos(x[PSI]) + p * s * sin(x[PSI]));
    dx[Y] = radius * (-r * sin(x[PSI]) - p * s * cos(x[PSI]));
}

/* A step of the classical Runge-Kutta method. */
static void step(double *const x, const double h)
{
    static const double part[4] = {0.0, 0.5, 0.5, 1.0}, weight[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    double from[STATES], at[STATES], slope[STATES] = {0.0};
    memcpy(from, x, sizeof from);
    for (int stage = 0; stage < 4; stage++) {
        for (int i = 0; i < STATES; i++) {
            at[i] = from[i] + part[stage] * h * slope[i];
        }
        derivative(slope, at);
        for (int i = 0; i < STATES; i++) {
            x[i] += h * weight[stage] * slope[i];
        }
    }
}

static double energy_of(const double *const x)
{
    const double moving = mass * radius * radius * (x[P] * x[P] + x[SPIN] * x[SPIN]);
    const double turning = across * (x[P] * x[P] + x[Q] * x[Q]) + about * x[SPIN] * x[SPIN];
    return 0.5 * (moving + turning) + mass * gravity * radius * sin(x[THETA]);
}

/* The contact force: m (a + g n), by its square. */
static double force_of(const double *const x)
{
    const double p = x[P], q = x[Q], r = x[SPIN], cot = cos(x[THETA]) / sin(x[THETA]);
    double dx[STATES];
    derivative(dx, x);
    const double a[3] = {radius * (p * q - dx[SPIN]), -radius * (p * p + q * r * cot), radius * (dx[P] + q * r)};
    const double f[3] = {a[0], a[1] + gravity * sin(x[THETA]), a[2] + gravity * cos(x[THETA])};
    return mass * sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
}

static double output(const char *const name)
{
    return (double)iso_the_plant.y[find_output(name)];
}

/* The component along the normal. */
static double along(const double *const n, const double x, const double y, const double z)
{
    return n[0] * x + n[1] * y + n[2] * z;
}

static double length(const double x, const double y, const double z)
{
    return sqrt(x * x + y * y + z * z);
}

/* What does not depend on the axes of the scene. */
typedef struct look {
    double energy, height, tilt, gone, force;
} look;

static look look_at_plant(const double *const n, const double *const start)
{
    const double at[3] = {output("at_x"), output("at_y"), output("at_z")};
    look l = {.energy = output("energy"), .height = along(n, at[0], at[1], at[2])};
    l.tilt = along(n, output("axle_x") - at[0], output("axle_y") - at[1], output("axle_z") - at[2]);
    l.gone = length(at[0] - start[0], at[1] - start[1], at[2] - start[2]);
    l.force = length(output("contact_x"), output("contact_y"), output("contact_z"));
    return l;
}

static look look_at_equations(const double *const x, const double start_height)
{
    look l = {energy_of(x), radius * sin(x[THETA]), cos(x[THETA]), 0.0, force_of(x)};
    l.gone = length(x[X], x[Y], l.height - start_height);
    return l;
}

static double difference(const look *const a, const look *const b)
{
    const double d[] = {(a->energy - b->energy) / b->energy, a->height - b->height, a->tilt - b->tilt,
                        a->gone - b->gone, (a->force - b->force) / (mass * gravity)};
    double largest = 0.0;
    for (size_t i = 0; i < sizeof d / sizeof *d; i++) {
        largest = fmax(largest, fabs(d[i]));
    }
    return largest;
}

int main(const int count, char **const arguments)
{
    enum { FINER = 4, TICKS = 4000 };
    static const double tolerance = 1e-8; /* of the method: h^4 at 0.5 ms, and what rounding adds in 2 s */
    if (count < 8) {
        return EXIT_FAILURE;
    }
    double x[STATES] = {0.0};
    x[THETA] = atof(arguments[1]);
    x[P] = atof(arguments[2]);
    x[Q] = atof(arguments[3]);
    x[SPIN] = atof(arguments[4]);
    const double n[3] = {atof(arguments[5]), atof(arguments[6]), atof(arguments[7])};
    double slopes[STATES];
    derivative(slopes, x);
    const bool steady = x[P] == 0.0 && fabs(slopes[P]) < 1e-12;
    const double h = (double)iso_the_plant.model->step_size, first_height = radius * sin(x[THETA]);
    const double circle = radius * x[SPIN] / slopes[PSI], turned = slopes[PSI] * h * TICKS;

    iso_plant_start(&iso_the_plant);
    iso_the_plant.model->output(iso_the_plant.memory);
    const double start[3] = {output("at_x"), output("at_y"), output("at_z")};
    const look first = look_at_equations(x, first_height), begun = look_at_plant(n, start);
    report_ok(difference(&begun, &first) <= 1e-12, "the start agrees to %.1e", difference(&begun, &first));
    double worst = 0.0, drift = 0.0;
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        iso_plant_tick(&iso_the_plant, tick);
        for (int i = 0; i < FINER; i++) {
            step(x, h / FINER);
        }
        const look ours = look_at_plant(n, start), theirs = look_at_equations(x, first_height);
        worst = fmax(worst, difference(&ours, &theirs));
        drift = fmax(drift, fabs(ours.energy / first.energy - 1.0));
    }
    report_ok(worst <= tolerance, "the equations by hand agree to %.1e in 2 s", worst);
    report_ok(drift <= tolerance, "the energy is kept to %.1e", drift);
    if (steady) {
        const look ended = look_at_plant(n, start);
        const double chord = 2.0 * fabs(circle * sin(0.5 * turned));
        report_ok(fabs(ended.gone - chord) <= tolerance && fabs(ended.height - first_height) <= tolerance,
                  "it goes round a circle of %.3f m: %.1e m off", fabs(circle), fabs(ended.gone - chord));
    } else {
        report_ok(fabs(look_at_plant(n, start).height - first_height) > 0.01, "control: this motion is not steady");
    }
    return report_done();
}
