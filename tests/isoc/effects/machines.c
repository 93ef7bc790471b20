/* The effects between joints and of bodies in space, tick by tick against closed forms: angles counted, impacts, a
 * linear gear, a body that is caught, flight against the air, a propeller that speeds up. */
#include <float.h>
#include <math.h>

#include PLANT
#include "core/numbers/noise.h"
#include "core/runtime/tick.h"
#include "tests/host/report.h"
#include "tests/isoc/effects/impact.h"

#ifdef ISO_REAL_DOUBLE
#define ULP DBL_EPSILON
#else
#define ULP ((double)FLT_EPSILON)
#endif

enum { TICKS = 3000, JAM_AT = 1000, PUSH_AT = 2000 };

static const double h = 1e-3;
static const iso_plant *plant;

static double shown(const int output)
{
    return (double)plant->y[output];
}

static double larger_off(const double worst, const double off)
{
    return off > worst || isnan(off) ? off : worst;
}

/* --- encoder --- */

/* The angle is 50 deg + 60 t - 30 t^2: forth by 4.8 turns, and back by more. */
static double miscounts, codes_off;

static void check_encoders(const double t)
{
    const double per_radian = 400.0 / 6.283185307179586, angle = 0.8726646259971648 + 60.0 * t - 30.0 * t * t;
    const double count = shown(PLANT_Y_COUNT), wound = shown(PLANT_Y_WOUND);
    /* The angle by the formula is that of a speed of at most 120 rad/s, which is rounded in each tick. */
    const double rounded = TICKS * ULP / 2.0 * 120.0 * t * per_radian;
    miscounts = larger_off(miscounts, (fabs(count + 0.5 - angle * per_radian) - 0.5) / rounded);
    /* Within the turn, and without the wrap, it is the angle of the state itself. */
    const double within = (double)plant->x[PLANT_X_WHEEL] * per_radian, whole = count + 0.5 - within;
    miscounts = larger_off(miscounts, (fabs(whole - 400.0 * round(whole / 400.0)) - 0.5) / (16.0 * ULP * 200.0));
    miscounts = larger_off(miscounts, (fabs(wound + 0.5 - shown(PLANT_Y_TURNED) * per_radian) - 0.5) /
                                          (4.0 * ULP * (fabs(wound) + 1.0)));
    const double turn = count - 400.0 * floor(count / 400.0);
    codes_off = larger_off(codes_off, fabs(shown(PLANT_Y_INDEX) - (turn == 0.0 ? 1.0 : 0.0)));
    codes_off = larger_off(codes_off, fabs(shown(PLANT_Y_ANGLE) - count / per_radian) / (4.0 * ULP * 100.0));
}

/* --- impacts --- */

static int impacts;
static double last_rate = 10.0, impacts_off, momentum_off;

/* Free within the gap, with the other sign of the speed: an impact is over. */
static void check_backlash(void)
{
    const double apart = shown(PLANT_Y_APART), rate = shown(PLANT_Y_APART_RATE);
    if (fabs(apart) < 0.05 && rate * last_rate < 0.0) {
        const double expected = speed_after(fabs(last_rate), damping_of(0.8) / 10.0);
        impacts_off = larger_off(impacts_off, fabs(fabs(rate) - expected) / expected);
        last_rate = rate;
        impacts++;
    }
    momentum_off = larger_off(momentum_off, fabs(shown(PLANT_Y_MOMENTUM) - 20.0));
}

static double tension_off;

static void check_cable(void)
{
    const double z = shown(PLANT_Y_HEIGHT), rate = shown(PLANT_Y_SPEED) * (z < 0.0 ? -1.0 : 1.0);
    const double stretch = fmax(fabs(z) - 1.0, 0.0);
    tension_off = larger_off(tension_off, fabs(shown(PLANT_Y_TENSION) - 2000.0 * stretch * (1.0 + 0.3 * rate)));
}

/* --- the gear, which is linear --- */

static void slope_of_gear(const double y[3], const double torque, double d[3])
{
    const double slip = y[0] / 10.0 - y[2], effort = 20.0 * y[1] + 0.05 * slip;
    d[0] = (torque - effort / 10.0) / 1e-5;
    d[1] = slip;
    d[2] = effort / 2e-3;
}

static double gear[3], gear_off;

/* A step of rk4 by the series of a linear system, whose next derivative is the map of the last one. */
static void check_gear(const double torque)
{
    double term[3], made[3] = {gear[0], gear[1], gear[2]};
    slope_of_gear(gear, torque, term);
    for (int n = 1; n <= 4; n++) {
        double now[3];
        for (int i = 0; i < 3; i++) {
            now[i] = term[i] * h / n;
            made[i] += now[i];
        }
        slope_of_gear(now, 0.0, term);
    }
    for (int i = 0; i < 3; i++) {
        gear[i] = made[i];
    }
    /* A rounding of the common turning stays; the fastest state is the rotor, the twist ends within 26 ticks. */
    const double most = 1000.0;
    gear_off = larger_off(gear_off, fabs((double)plant->x[PLANT_X_GEAR_SPEED] - gear[0]) / (TICKS * ULP * most));
    gear_off = larger_off(gear_off, fabs((double)plant->x[PLANT_X_GEAR_TWIST] - gear[1]) / (26.0 * ULP));
    gear_off =
        larger_off(gear_off, fabs((double)plant->x[PLANT_X_OUTPUT_SPEED] - gear[2]) / (TICKS * ULP * most / 10.0));
}

/* --- a slide, its sensor, and a jam --- */

static double sensed_off, walked, jam_off, caught_at, caught_speed;

static void check_slide(const uint32_t tick, const double push)
{
    const double rate = (double)JAM_RATE;
    if (tick > 0 && tick < JAM_AT) {
        const double force = push / 2.0 + 0.1, noise = (double)iso_noise(tick + 1, 1);
        sensed_off = larger_off(sensed_off, fabs(shown(PLANT_Y_FORCE_X) - force) / (16.0 * ULP));
        sensed_off = larger_off(sensed_off, fabs(shown(PLANT_Y_FORCE_Y) - 0.1 - 0.5 * noise) / (16.0 * ULP));
        sensed_off = larger_off(sensed_off, fabs(shown(PLANT_Y_FORCE_Z) - 0.1 - walked) / ((16.0 + 0.5 * tick) * ULP));
        sensed_off = larger_off(sensed_off, fabs(shown(PLANT_Y_SPIN_Y) - 0.2) / (16.0 * ULP));
    } else if (tick >= JAM_AT && tick < PUSH_AT) {
        /* Caught with critical damping: x = v t exp(-rate t). rk4 leaves out (rate h)^5 / 120 of it in a step. */
        const double t = h * (tick + 1 - JAM_AT), way = caught_speed / rate;
        const double expected = caught_at + caught_speed * t * exp(-rate * t);
        jam_off = larger_off(jam_off, fabs(shown(PLANT_Y_SLIDE) - expected) / way);
    }
    walked += 0.2 * sqrt(h) * (double)iso_noise(tick + 1, 1);
    if (tick + 1 == JAM_AT) {
        caught_at = shown(PLANT_Y_SLIDE);
        caught_speed = (double)plant->x[PLANT_X_RAIL_SPEED];
    }
}

/* --- in the air --- */

static double flight_off, rotor_off;

static void check_flight(const double t)
{
    /* m v' = -c v^2 in the air, which moves with 1 m/s: v = v0 / (1 + c v0 t / m), with v0 = 5 m/s in the direction (3,
     * 4). */
    const double c = 1.2 / 2.0 * 200e-4, v = 5.0 / (1.0 + c * 5.0 * t / 0.5), rounding = TICKS * ULP * 5.0;
    flight_off = larger_off(flight_off, fabs(shown(PLANT_Y_FLOWN_X) - 1.0 - 0.6 * v) / rounding);
    flight_off = larger_off(flight_off, fabs(shown(PLANT_Y_FLOWN_Y) - 0.8 * v) / rounding);
    flight_off = larger_off(flight_off, fabs(shown(PLANT_Y_FLOWN_Z)) / rounding);
    flight_off = larger_off(flight_off, fabs(shown(PLANT_Y_LOSS) - c * v * v * v) / (c * 75.0 * 4.0 * rounding));
    /* The speed is s (1 - e), e = exp(-t / lag); the integral of its square is that of the thrust. */
    const double lag = 50e-3, e = exp(-t / lag),
                 square = 400.0 * 400.0 * (t - 2.0 * lag * (1.0 - e) + lag / 2.0 * (1.0 - e * e));
    const double rounded = TICKS * ULP + pow(h / lag, 5.0) / 120.0 * TICKS;
    rotor_off = larger_off(rotor_off, fabs(shown(PLANT_Y_LIFT) - 1e-5 * square / 0.4) / (rounded * 12.0));
    rotor_off = larger_off(rotor_off, fabs(shown(PLANT_Y_YAW) - 16e-3 * 1e-5 * square / 2e-3) / (rounded * 40.0));
}

static void report(void)
{
    report_ok(miscounts <= 1.0, "the encoders count both ways, through the wrap and without one: %.2g", miscounts);
    report_ok(codes_off <= 1.0, "the index is at whole turns, the angle is that of the count");
    /* What an impact falls short of with rk4 at most (models/README.md), over a rest of 0.8. */
    report_ok(impacts > 4 && impacts_off <= 0.0065, "%d impacts of the gear play leave what the law says: %.2g off",
              impacts, impacts_off);
    report_ok(momentum_off <= TICKS * ULP * 20.0, "they leave the momentum: %.2g of 20 off", momentum_off);
    /* The places are known to 2 ULP, the tension is 2000 N/m times as much. */
    report_ok(tension_off <= 2600.0 * 4.0 * ULP, "the tension of the cable follows its stretch: %.2g N off",
              tension_off);
    /* It throws the bob back on both sides. Where it gets taut within a step, the force is off for a step by k v h. */
    const double back = shown(PLANT_Y_SPEED), expected = speed_after(speed_after(1.0, 0.3), 0.3);
    report_ok(fabs(back - expected) <= 2000.0 * h * h / 0.5, "it throws the bob back twice, to %.4g m/s: %.4g",
              expected, back);
    report_ok(gear_off <= 1.0, "the gear: %.2g of what rounding allows", gear_off);
    report_ok(sensed_off <= 1.0, "the unit senses forces, with bias and noise: %.2g of what is allowed", sensed_off);
    report_ok(jam_off <= pow((double)JAM_RATE * h, 5.0) / 120.0 * 8.0 + 16.0 * ULP / 1e-3,
              "a jam catches the slide with critical damping: %.2g of the way off", jam_off);
    const double given = shown(PLANT_Y_SLIDE) - caught_at, stiff = 1000.0 / (double)JAM_STIFFNESS;
    report_ok(fabs(given - stiff) <= 1e-6 * stiff + 4.0 * ULP, "against 1 kN it gives way by %.4g m", given);
    report_ok(flight_off <= 1.0, "the drag in the wind: %.2g of what rounding allows", flight_off);
    report_ok(rotor_off <= 1.0, "the propeller lifts and turns its craft: %.2g of what is allowed", rotor_off);
}

int main(void)
{
    plant = &iso_the_plant;
    iso_plant_start(plant);
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        const double torque = (double)(real)(0.1 * sin(0.02 * tick));
        const double push = tick < PUSH_AT ? (tick < JAM_AT ? (double)(real)(2.0 * sin(0.01 * tick)) : 0.0) : 1000.0;
        plant->u[PLANT_U_BRAKE] = R(-0.06);
        plant->u[PLANT_U_TORQUE] = (real)torque;
        plant->u[PLANT_U_PUSH] = (real)push;
        plant->p[PLANT_P_JAM_ACTIVE] = tick >= JAM_AT ? R(1.0) : R(0.0);
        (void)iso_plant_tick(plant, tick);
        check_encoders(h * (tick + 1));
        check_backlash();
        check_cable();
        check_gear(torque);
        check_slide(tick, push);
        check_flight(h * (tick + 1));
    }
    report();
    return report_done();
}
