/* Impacts of stops, bumpers, backlash and contacts leave the rest that is written, and none of them pulls: a table of
 * rest.py, whose exact rests are from the equation in the text of the effects, solved there.
 *
 * What rk4 makes of the corner at the begin of an impact: in a step whose part r is before it the force is off by
 * (1 - r)^2 / 2 - max(1 / 2 - r, 0) 2 / 3 - (1 - r) / 6 of (1 + d) (w h)^2 times the speed, at most 1 / 24 of it; at
 * its end by as much or less. The speed after an impact changes by less than that before it. In float a speed is
 * rounded in each step.
 *
 * The depth a lead of 0.0091 h later takes a part of at most LEFT_OUT = 1 - exp(-pi ANGLE 0.0091 / 2) besides. */
#include <float.h>
#include <math.h>

#include PLANT
#include "core/runtime/tick.h"
#include "tests/host/report.h"

typedef struct impact {
    const char *effect;
    double rest, speed; /* 0: it leaves at this speed */
    int sign;           /* of its pushes */
    double damping;
} impact;

typedef struct places {
    int speed, push, loss;
} places;

#include "table.h"

#ifdef ISO_REAL_DOUBLE
#define ULP DBL_EPSILON
#else
#define ULP ((double)FLT_EPSILON)
#endif

#define LEFT_OUT (0.5 * 3.1416 * 0.0091 * ANGLE)

enum { TICKS = 6000, COUNT = sizeof impacts / sizeof impacts[0] };

static double pulled[COUNT], gained[COUNT], pushed[COUNT];

int main(void)
{
    const iso_plant *const plant = &iso_the_plant;
    double balance = 0.0, power = 0.0;
    iso_plant_start(plant);
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        (void)iso_plant_tick(plant, tick);
        balance = fmax(balance, fabs((double)plant->y[PLANT_Y_BALANCE]));
        for (int i = 0; i < COUNT; i++) {
            const double push = (double)plant->y[outputs[i].push] * impacts[i].sign;
            pulled[i] = fmax(pulled[i], -push);
            pushed[i] = fmax(pushed[i], push);
            const double loss = (double)plant->y[outputs[i].loss];
            gained[i] = fmax(gained[i], -loss);
            /* The terms of the account: what is pushed and what is lost; what is stored is at most both. */
            power = fmax(power, fabs(push * (double)plant->y[outputs[i].speed]) + fabs(loss));
        }
    }
    for (int i = 0; i < COUNT; i++) {
        const impact *of = &impacts[i];
        const double after = -(double)plant->y[outputs[i].speed] / of->speed;
        if (of->rest > 0.0) {
            /* A speed of v0 is rounded by half an ulp in each of rk4's sums and by one in its slopes' sum. */
            const double allowed = 2.0 * ANGLE * ANGLE / 24.0 + TICKS * ULP;
            const double short_of = of->rest - after;
            report_ok(short_of <= allowed + LEFT_OUT * of->rest && -short_of <= allowed && pushed[i] > 0.0,
                      "%s: a rest of %g is %.7g, %.2g short, at most %.2g", of->effect, of->rest, after, short_of,
                      allowed + LEFT_OUT * of->rest);
        }
        const double scale = pushed[i] * fabs(of->speed);
        report_ok(pulled[i] <= 0.0 && gained[i] <= 4.0 * ULP * scale, "%s: it never pulls, and gives no power",
                  of->effect);
    }
    report_ok(balance <= COUNT * 8.0 * ULP * power, "the account of energy closes: %.2g of %.2g W", balance, power);
    return report_done();
}
