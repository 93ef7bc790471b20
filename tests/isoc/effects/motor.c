/* A motor with its rotor is linear: y' = A y + b for current and speed, from rest. The plant, which is PLANT, is
 * compared
 *
 *   - with rk4's own map of a step, y + (1 + z/2 + z^2/6 + z^3/24) h (A y + b) with z = h A: nothing but rounding;
 *   - with the exact one, the whole series: also what rk4 leaves out, |z|^5 / 120 of |y| in a step.
 *
 * Then the circuit opens, by a fault: the current decays with 1 ms, and nothing else changes.
 */
#include <float.h>
#include <math.h>
#include <stdio.h>

#include PLANT
#include "core/runtime/tick.h"
#include "tests/host/report.h"

#ifdef ISO_REAL_DOUBLE
#define ULP DBL_EPSILON
#else
#define ULP FLT_EPSILON
#endif

enum { TICKS = 5000, OPEN_TICKS = 200 };

static const long double h = 1e-4L, resistance = 2.0L, inductance = 5e-3L, constant = 0.05L, damping = 2e-3L,
                         inertia = 1e-3L, volts = 6.0L;

/* y' at y: of the current, and of the speed. */
static void slope(const long double y[2], const bool is_open, long double d[2])
{
    d[0] = is_open ? -y[0] / 1e-3L : (volts - resistance * y[0] - constant * y[1]) / inductance;
    d[1] = (constant * y[0] - damping * y[1]) / inertia;
}

/* A step by so many terms of the series: the n-th derivative follows from the one before, as A does not change. */
static void advance_exactly(long double y[2], const bool is_open, const int terms)
{
    long double term[2], made[2] = {y[0], y[1]};
    slope(y, is_open, term);
    for (int n = 1; n <= terms; n++) {
        const long double step = h / (long double)n;
        const long double now[2] = {term[0] * step, term[1] * step};
        made[0] += now[0];
        made[1] += now[1];
        term[0] = is_open ? -now[0] / 1e-3L : (-resistance * now[0] - constant * now[1]) / inductance;
        term[1] = (constant * now[0] - damping * now[1]) / inertia;
    }
    y[0] = made[0];
    y[1] = made[1];
}

/* The largest difference from a series with so many terms, over the largest number. */
static long double compare(const iso_plant *const plant, const int terms, const int ticks, const bool is_open,
                           long double y[2])
{
    long double worst = 0.0L;
    for (int tick = 0; tick < ticks; tick++) {
        (void)iso_plant_tick(plant, (uint32_t)tick);
        advance_exactly(y, is_open, terms);
        const long double size[2] = {volts / resistance, volts / constant};
        const long double got[2] = {(long double)plant->y[PLANT_Y_CURRENT], (long double)plant->y[PLANT_Y_SPEED]};
        for (int i = 0; i < 2; i++) {
            const long double off = fabsl(got[i] - y[i]) / size[i];
            worst = off > worst ? off : worst;
        }
    }
    return worst;
}

int main(void)
{
    const iso_plant *const plant = &iso_the_plant;
    /* A tick rounds a dozen numbers of at most twice the size; errors decay with the motor, or add up. */
    const long double rounding = 24.0L * (long double)ULP * (long double)TICKS;
    /* |h A| is 0.04 of the current; (0.04)^5 / 120 in each tick of the 5 ms that the circuit remembers. */
    const long double truncation = 50.0L * powl(0.04L, 5.0L) / 120.0L;

    for (int terms = 4; terms <= 24; terms += 20) {
        long double y[2] = {0.0L, 0.0L};
        iso_plant_start(plant);
        plant->u[PLANT_U_VOLTS] = (real)volts;
        const long double off = compare(plant, terms, TICKS, false, y);
        report_ok(off <= rounding + (terms == 4 ? 0.0L : truncation),
                  "the motor runs up as %s says: %.2Lg off, at most %.2Lg",
                  terms == 4 ? "rk4's map" : "the closed form", off, rounding + (terms == 4 ? 0.0L : truncation));
    }
    report_ok(plant->y[PLANT_Y_TICKS] == R(5003.0) && plant->y[PLANT_Y_TICKS_BEFORE] == R(5002.0),
              "a memory is set once a tick, from the memories before: %g, %g", (double)plant->y[PLANT_Y_TICKS],
              (double)plant->y[PLANT_Y_TICKS_BEFORE]);
    const long double heat =
        resistance * (long double)plant->y[PLANT_Y_CURRENT] * (long double)plant->y[PLANT_Y_CURRENT];
    report_ok(fabsl((long double)plant->y[PLANT_Y_LOSS] - heat) <= 4.0L * (long double)ULP * heat,
              "a signal is its formula");

    long double y[2] = {(long double)plant->x[PLANT_X_DRIVE_CURRENT], (long double)plant->x[PLANT_X_SHAFT_SPEED]};
    plant->p[PLANT_P_DRIVE_OPEN] = R(1.0);
    const long double off = compare(plant, 4, OPEN_TICKS, true, y);
    report_ok(off <= rounding && fabs((double)plant->y[PLANT_Y_CURRENT]) < 1e-6, "a fault opens the circuit: %.2Lg off",
              off);

    /* The energy of the rotor is what the motor gives less what the damping takes, by the rule of the trapezoid: of a
     * power that changes with 2.5 ms it leaves out (h / 2.5 ms)^2 / 12 of the energy that has passed. */
    long double given = 0.0L, passed = 0.0L, before = 0.0L;
    iso_plant_start(plant);
    plant->u[PLANT_U_VOLTS] = (real)volts;
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        (void)iso_plant_tick(plant, tick);
        const long double speed = (long double)plant->y[PLANT_Y_SPEED];
        const long double now = (long double)plant->y[PLANT_Y_POWER] - damping * speed * speed;
        given += 0.5L * h * (before + now);
        passed += h * fabsl((long double)plant->y[PLANT_Y_POWER]);
        before = now;
    }
    const long double missing = (long double)plant->y[PLANT_Y_ENERGY] - given;
    const long double bound = (powl(h / 2.5e-3L, 2.0L) / 12.0L + (long double)ULP * TICKS) * passed;
    report_ok(fabsl(missing) <= bound && passed > 0.1L,
              "the account of energy: %.2Lg J of %.2Lg J are missing, at most %.2Lg", missing, passed, bound);

    /* The control: a motor of another constant is found. */
    iso_plant_start(plant);
    plant->u[PLANT_U_VOLTS] = (real)(volts * 1.05L);
    y[0] = y[1] = 0.0L;
    report_ok(compare(plant, 24, TICKS, false, y) > rounding + truncation,
              "found: a supply that is five per cent higher");
    return report_done();
}
