/* A screw, by each way to solve for its acceleration, moves as a cylindrical joint whose slide a gear couples to its
 * turn, and the joint below it bears the same. A screw in a closed loop moves as its equation says. */
#include <math.h>

#include "articulated.h"
#include "composite.h"
#include "core/runtime/tick.h"
#include "gear.h"
#include "lead_rk4.h"
#include "lead_rosenbrock.h"
#include "tests/host/report.h"

static double differs(const double *const a, const double *const b, const int from, const int to)
{
    double most = 0.0;
    for (int i = from; i < to; i++) {
        most = fmax(most, fabs(a[i] - b[i]));
    }
    return most;
}

enum { TICKS = 2000 };

/* The lead screw of lead_screw.scene after so many ticks of 1 ms. */
static void check_lead(const iso_plant *const plant, const char *const method)
{
    const double lead = 0.1 / (2.0 * 3.14159265358979323846), accelerated = 0.5 / (0.002 + 4.0 * lead * lead);
    const double time = 0.001 * TICKS, angle = 0.5 * accelerated * time * time;
    (void)iso_plant_start(plant);
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        (void)iso_plant_tick(plant, tick);
    }
    const double off = fabs(plant->y[LEAD_RK4_Y_ANGLE] / angle - 1.0);
    const double slid = fabs(plant->y[LEAD_RK4_Y_PLACE_Z] / (-lead * angle) - 1.0);
    report_ok(off < 1e-10 && slid < 1e-10, "a nut on a guide, by %s: angle and place are off by %.1e and %.1e of them",
              method, off, slid);
}

int main(void)
{
    static composite_memory of_composite;
    static articulated_memory of_articulated;
    static gear_memory of_gear;
    const iso_plant a = composite_plant(&of_composite), b = articulated_plant(&of_articulated),
                    c = gear_plant(&of_gear);
    (void)iso_plant_start(&a);
    (void)iso_plant_start(&b);
    (void)iso_plant_start(&c);
    const double energy = a.y[COMPOSITE_Y_ENERGY], angle = a.y[COMPOSITE_Y_ANGLE];
    double solved = 0.0, moved = 0.0, held = 0.0, turned = 0.0;
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        (void)iso_plant_tick(&a, tick);
        (void)iso_plant_tick(&b, tick);
        (void)iso_plant_tick(&c, tick);
        solved = fmax(solved, differs(a.y, b.y, 0, COMPOSITE_OUTPUTS));
        moved = fmax(moved, differs(a.y, c.y, COMPOSITE_Y_TIP_X, COMPOSITE_Y_RATE + 1));
        held = fmax(held, differs(a.y, c.y, COMPOSITE_Y_HELD_X, COMPOSITE_Y_HELD_Z + 1));
        turned = fmax(turned, fabs(a.y[COMPOSITE_Y_ANGLE] - angle));
    }
    report_ok(turned > 1.0, "the screw turns by %.2g rad", turned);
    report_ok(solved < 1e-9, "composite and articulated bodies differ by %.1e", solved);
    report_ok(moved < 1e-6, "from a cylindrical joint with a gear the motion differs by %.1e", moved);
    report_ok(held < 1e-5, "the moment of the joint below by %.1e N m", held);
    report_ok(energy > a.y[COMPOSITE_Y_ENERGY], "damping takes %.2g J", energy - a.y[COMPOSITE_Y_ENERGY]);
    static lead_rk4_memory of_rk4;
    static lead_rosenbrock_memory of_rosenbrock;
    const iso_plant by_rk4 = lead_rk4_plant(&of_rk4), by_rosenbrock = lead_rosenbrock_plant(&of_rosenbrock);
    check_lead(&by_rk4, "rk4");
    check_lead(&by_rosenbrock, "rosenbrock");
    return report_done();
}
