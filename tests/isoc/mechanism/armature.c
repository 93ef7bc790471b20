/* The plants of armature.scene by both formulations and both ways to the factors of an implicit method, and with
 * flywheels on the ground, geared to the joints, instead of the armatures. */
#include <math.h>
#include <stdio.h>

#include "tests/host/report.h"

#include "articulated.h"
#include "composite.h"
#include "full.h"
#include "thin.h"
#include "wheels.h"

enum { ENERGY, BALANCE, ACCELERATIONS, JOINTS = 3, TICKS = 1000 };

/* The largest difference of numbers. */
static double apart(const real *a, const real *b, int n)
{
    double most = 0.0;
    for (int i = 0; i < n; i++) {
        most = fmax(most, fabs(a[i] - b[i]));
    }
    return most;
}

static void run(const iso_plant *p, int ticks, double *balance)
{
    *balance = 0.0;
    for (int i = 0; i < ticks; i++) {
        p->model->step(p->memory);
        p->model->output(p->memory);
        *balance = fmax(*balance, fabs(p->y[BALANCE]));
    }
}

int main(void)
{
    static composite_memory of_composite;
    static articulated_memory of_articulated;
    static wheels_memory of_wheels;
    static full_memory of_full;
    static thin_memory of_sparse;
    const iso_plant composite = composite_plant(&of_composite), articulated = articulated_plant(&of_articulated);
    const iso_plant wheels = wheels_plant(&of_wheels), full = full_plant(&of_full), sparse = thin_plant(&of_sparse);
    const iso_plant *const all[] = {&composite, &articulated, &wheels, &full, &sparse};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        (void)iso_plant_start(all[i]);
        all[i]->model->output(all[i]->memory);
    }
    const double by_wheels = apart(composite.y + ACCELERATIONS, wheels.y + ACCELERATIONS, JOINTS);
    report_ok(by_wheels < 1e-12, "an armature is a flywheel that the joint turns: the accelerations differ by %.2g",
              by_wheels);
    const double energy = fabs(composite.y[ENERGY] - wheels.y[ENERGY]);
    report_ok(energy < 1e-12, "and their energies by %.2g J", energy);
    const double by_way = apart(composite.y + ACCELERATIONS, articulated.y + ACCELERATIONS, JOINTS);
    report_ok(by_way < 1e-12, "both formulations: the accelerations differ by %.2g", by_way);
    double balance, other, implicit[2];
    run(&composite, TICKS, &balance);
    run(&articulated, TICKS, &other);
    report_ok(balance < 1e-11 && other < 1e-11, "the rate of the energy is the power, to %.2g W and %.2g W", balance,
              other);
    run(&full, TICKS, &implicit[0]);
    run(&sparse, TICKS, &implicit[1]);
    const double by_factors = apart(full.x, sparse.x, FULL_STATES);
    report_ok(by_factors < 1e-9, "both ways to the factors: after %d ticks the states differ by %.2g", TICKS,
              by_factors);
    return report_done();
}
