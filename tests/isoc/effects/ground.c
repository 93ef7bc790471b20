/* Balls on the ground: impacts leave the speed of their law, a ball that slides ends by rolling with 5/7 of its speed,
 * and what stands on the ground falls freely when the ground goes. */
#include <float.h>
#include <math.h>

#include PLANT
#include "core/runtime/tick.h"
#include "tests/host/report.h"
#include "tests/isoc/effects/impact.h"

#ifdef ISO_REAL_DOUBLE
#define ULP DBL_EPSILON
#else
#define ULP ((double)FLT_EPSILON)
#endif

enum { TICKS = 2300, DROP_AT = 2000 };

static const double h = 1e-3, g = 9.81;
static const iso_plant *plant;

static double shown(const int output)
{
    return (double)plant->y[output];
}

/* The speed with which the ball meets the ground, and left it, by its height and speed in flight. */
static double impacts_off;
static int impacts;

static void check_bounce(void)
{
    static double last = 0.0;
    const double z = shown(PLANT_Y_FALLEN_Z) - 0.05, v = shown(PLANT_Y_FALLING),
                 at_ground = sqrt(fmax(v * v + 2.0 * g * z, 0.0));
    if (z > 0.0) {
        if (v > 0.0 && last < 0.0 && impacts < 3) {
            const double expected = speed_after(-last, damping_of(0.8) / 2.0);
            impacts_off = fmax(impacts_off, fabs(at_ground - expected) / expected);
            impacts++;
        }
        last = v < 0.0 ? -at_ground : at_ground;
    }
}

/* While it slides, friction is 0.3 m g against its way; the slip, of 1 m/s, falls by 7/2 as much. */
static double sliding_off;

static void check_slide(const double t)
{
    if (1.0 - 3.5 * 0.3 * g * t > 0.05) {
        const double v = 1.0 - 0.3 * g * t;
        sliding_off = fmax(sliding_off, fabs(shown(PLANT_Y_ROLLING_X) - 0.8 * v));
        sliding_off = fmax(sliding_off, fabs(shown(PLANT_Y_ROLLING_Y) - 0.6 * v));
    }
}

/* From the tick in which the ground goes. */
static double falling_off, stood_at, stood_speed;

static void check_fall(const uint32_t tick)
{
    if (tick + 1 == DROP_AT) {
        stood_at = shown(PLANT_Y_STOOD);
        stood_speed = (double)plant->x[PLANT_X_LIFT_Z_SPEED];
    } else if (tick >= DROP_AT) {
        const double t = h * (tick + 1 - DROP_AT), expected = stood_at + stood_speed * t - 0.5 * g * t * t;
        falling_off = fmax(falling_off, fabs(shown(PLANT_Y_STOOD) - expected));
    }
}

int main(void)
{
    plant = &iso_the_plant;
    double rise = 0.0, first = 0.0, last = 0.0;
    iso_plant_start(plant);
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        plant->u[PLANT_U_LEVEL] = tick < DROP_AT ? R(0.05) : R(-1.0);
        (void)iso_plant_tick(plant, tick);
        check_bounce();
        check_slide(h * (tick + 1));
        check_fall(tick);
        if (tick == 0) {
            first = last = shown(PLANT_Y_ENERGY);
        }
        /* Where the ground goes, what it has stored is lost. In an impact the account of a tick is as good as rk4. */
        if (shown(PLANT_Y_FALLEN_Z) > 0.05) {
            rise = tick == DROP_AT ? rise : fmax(rise, shown(PLANT_Y_ENERGY) - last);
            last = shown(PLANT_Y_ENERGY);
        }
    }
    /* As in tests/isoc/effects/stop.c; and gravity takes up to 7 g h of the 1.3 m/s and more that are left. */
    report_ok(impacts == 3 && impacts_off <= 0.0065 + 7.0 * g * h / 1.3,
              "three impacts leave what the law says: %.2g off", impacts_off);
    /* The weight rests on the ground to the rounding of 5 cm at 20 kN/m: a part of it, of the speed as well. */
    const double weight = 4.0 * ULP * 0.05 * 20e3 / (0.3 * g);
    report_ok(sliding_off <= weight + TICKS * ULP + 1e-6, "friction is 0.3 of the weight: %.2g m/s off", sliding_off);
    const double left = 5.0 / 7.0 * 0.8, radius = 0.05;
    report_ok(fabs(shown(PLANT_Y_ROLLING_X) - left) <= weight + TICKS * ULP + 1e-6 &&
                  fabs(shown(PLANT_Y_SPINNING_Y) * radius - left) <= weight + TICKS * ULP + 1e-6,
              "a ball ends by rolling with 5/7 of its speed: %.6g of 0.8 m/s", shown(PLANT_Y_ROLLING_X));
    report_ok(fabs(stood_at - (0.05 - 0.1 * g / 10e3)) <= 1e-6 + 4.0 * ULP, "a point stands on the ground: at %.6g m",
              stood_at);
    report_ok(falling_off <= 4.0 * 300.0 * ULP, "it falls freely when the ground goes: %.2g m off", falling_off);
    /* What rk4 leaves out of the point's oscillation with 316 rad/s and at most the 0.1 J of its fall. */
    const double left_out = pow(sqrt(10e3 / 0.1) * h, 5.0) / 120.0 * 0.1;
    report_ok(rise <= 16.0 * ULP * first + left_out, "no impact gives energy: %.2g J of %.2g J", rise, first);
    return report_done();
}
