/* Motors whose currents settle within a twentieth of a step, by sub-steps of these currents: the plant, which is PLANT,
 * against the closed form. A motor with its rotor is linear, y' = A y + b for current and speed, from rest.
 *
 * With x = step / (time in which the rotor runs up) a run-up is followed to x^4. What is left is the first tick, in
 * which the current jumps: the sub-steps that lead to the middle of the step know nothing yet of the acceleration, so
 * that the speed errs by at most H a, a being the largest acceleration, for a part of the tick. A current that follows
 * that is off by constant H a / resistance, at the end of the first tick only; the speed by x H a, for good.
 */
#include <float.h>
#include <math.h>
#include <stdio.h>

#include PLANT
#include "core/runtime/hash.h"
#include "core/runtime/tick.h"
#include "tests/host/report.h"

#ifdef ISO_REAL_DOUBLE
#define ULP DBL_EPSILON
#else
#define ULP FLT_EPSILON
#endif

enum { TICKS = 2000, PARTS = 64 };

static const long double tick_length = 1e-3L, resistance = 2.0L, inductance = 1e-4L, constant = 0.05L, inertia = 1e-3L,
                         volts = 6.0L, lag = 0.1L;

/* A tick, in parts short enough for the series of the exponential; and what is lagged, by the rule of the middle. */
static void advance_exactly(long double y[3])
{
    enum { TERMS = 20 };
    const long double h = tick_length / PARTS;
    for (int part = 0; part < PARTS; part++) {
        long double term[2] = {(volts - resistance * y[0] - constant * y[1]) / inductance, constant * y[0] / inertia};
        const long double before = y[0];
        for (int n = 1; n <= TERMS; n++) {
            const long double now[2] = {term[0] * h / (long double)n, term[1] * h / (long double)n};
            y[0] += now[0];
            y[1] += now[1];
            term[0] = (-resistance * now[0] - constant * now[1]) / inductance;
            term[1] = constant * now[0] / inertia;
        }
        const long double middle = (before + y[0]) / 2.0L;
        y[2] += h / lag * (resistance * middle * middle - y[2]) * (1.0L - h / lag / 2.0L);
    }
}

typedef struct worst {
    long double current, speed, warmth;
    long double current_later; /* from the tenth tick on */
    bool twins;                /* both motors have the same bits */
} worst;

static worst run(const real given)
{
    const iso_plant *const plant = &iso_the_plant;
    const real *const out = plant->y;
    long double y[3] = {0.0L};
    worst of = {.twins = true};
    iso_plant_start(plant);
    for (uint64_t tick = 0; tick < TICKS; tick++) {
        plant->u[PLANT_U_VOLTS] = given;
        (void)iso_plant_tick(plant, tick);
        advance_exactly(y);
        const long double off = fabsl((long double)out[PLANT_Y_CURRENT] - y[0]);
        of.current = fmaxl(of.current, off);
        of.current_later = tick >= 10 ? fmaxl(of.current_later, off) : 0.0L;
        of.speed = fmaxl(of.speed, fabsl((long double)out[PLANT_Y_SPEED] - y[1]));
        of.warmth = fmaxl(of.warmth, fabsl((long double)out[PLANT_Y_WARMTH] - y[2]));
        of.twins = of.twins && iso_bits_of(out[PLANT_Y_CURRENT]) == iso_bits_of(out[PLANT_Y_TWIN_CURRENT]) &&
                   iso_bits_of(out[PLANT_Y_SPEED]) == iso_bits_of(out[PLANT_Y_TWIN_SPEED]);
    }
    return of;
}

int main(void)
{
    const long double largest = volts / resistance, fastest = volts / constant;
    const long double most = constant * largest / inertia * tick_length; /* H a */
    const long double x = tick_length * constant * constant / (inertia * resistance);
    /* The sum of a speed rounds by half an epsilon in a tick, and is forgotten in 1 / x ticks; twice that, for what is
     * added. A current follows it, and rounds some dozens of times. */
    const long double rounding = (long double)ULP * fastest / x;
    const worst of = run((real)volts);
    const long double speed = x * most + rounding,
                      later = constant / resistance * speed + 64.0L * (long double)ULP * largest;
    const long double current = constant / resistance * most + later;
    report_ok(of.current <= current, "the current: %.2Lg A off, at most %.2Lg", of.current, current);
    report_ok(of.current_later <= later, "after ten ticks: %.2Lg A off, at most %.2Lg", of.current_later, later);
    report_ok(of.speed <= speed, "the speed: %.2Lg rad/s off, at most %.2Lg", of.speed, speed);
    /* What is not linear in the current takes its square at four points of the first tick: by a third of it wrong. */
    const long double warmth =
        tick_length / lag * resistance * largest * largest / 3.0L + 4.0L * resistance * largest * later;
    report_ok(of.warmth <= warmth, "what another effect makes of the current: %.2Lg off, at most %.2Lg", of.warmth,
              warmth);
    report_ok(of.twins, "two effects with sub-steps, apart from one another: the same bits");
    report_ok(run((real)(volts * 1.001L)).current_later > later, "found: a supply that is a thousandth higher");
    return report_done();
}
