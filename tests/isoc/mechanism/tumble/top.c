/* The heavy symmetric top, models/top.scene: what Lagrange's integrals keep. */
#include <math.h>

#include "core/runtime/plant.h"
#include "tests/host/report.h"

/* About the tip: 22.5e-6 + 0.1 kg (40 mm)^2 across the stem, 45e-6 kg m^2 along it. */
static const double across = 182.5e-6, along = 45e-6;

/* The outputs of the scene: stem, orientation, spin, energy. */
enum { STEM_Z = 2, W, X, Y, Z, SPIN_X, SPIN_Y, SPIN_Z, ENERGY };

typedef struct integrals {
    double energy, vertical, spin;
} integrals;

/* The momentum about the vertical is that of the body along the ground's z, which stands in its axes as R' z. */
static integrals now(void)
{
    const real *const y = iso_the_plant.y;
    iso_the_plant.model->output(iso_the_plant.memory);
    const double w = (double)y[W], i = (double)y[X];
    const double j = (double)y[Y], k = (double)y[Z];
    const double up[3] = {2.0 * (i * k - w * j), 2.0 * (j * k + w * i), 1.0 - 2.0 * (i * i + j * j)};
    return (integrals){(double)y[ENERGY],
                       across * ((double)y[SPIN_X] * up[0] + (double)y[SPIN_Y] * up[1]) +
                           along * (double)y[SPIN_Z] * up[2],
                       (double)y[SPIN_Z]};
}

/* Over 10 s at 0.5 ms. The top turns by 0.1 rad a step, of which rk4 misses (0.1 / 2)^5 / 5! in its quaternion; were
 * all of 20,000 steps off to the same side, the integrals would be by no more than their sum. */
int main(void)
{
    const double most = 20000.0 * pow(0.05, 5.0) / 120.0;
    iso_plant_start(&iso_the_plant);
    const integrals first = now();
    double energy = 0.0, vertical = 0.0, spin = 0.0, lowest = 1.0;
    for (int n = 0; n < 20000; n++) {
        iso_the_plant.model->step(iso_the_plant.memory);
        const integrals after = now();
        energy = fmax(energy, fabs(after.energy / first.energy - 1.0));
        vertical = fmax(vertical, fabs(after.vertical / first.vertical - 1.0));
        spin = fmax(spin, fabs(after.spin / first.spin - 1.0));
        lowest = fmin(lowest, (double)iso_the_plant.y[STEM_Z]);
    }
    report_ok(energy <= most, "the energy changes by %.2e, at most %.0e", energy, most);
    report_ok(vertical <= most, "the momentum about the vertical by %.2e, at most %.0e", vertical, most);
    report_ok(spin <= 1e-12, "the spin about the stem by %.2e, at most 1e-12", spin);

    /* From a cusp at u0 = cos 30 deg the height u obeys u'^2 = a (u0 - u) (1 - u^2) - b^2 (u0 - u)^2 with
     * a = 2 m g l / across and b = along spin / across, since the precession begins at zero: it turns back where
     * a (1 - u^2) = b^2 (u0 - u) (Goldstein 1980, Classical Mechanics, sec. 5-7). */
    const double a = 2.0 * 0.1 * 9.81 * 0.04 / across, b = along * 200.0 / across, u0 = sqrt(0.75);
    const double half = b * b / (2.0 * a), turn = half - sqrt(half * half - 2.0 * half * u0 + 1.0);
    report_ok(fabs(lowest - turn) <= 1e-5, "it nutates down to a height of %.7f; Lagrange's %.7f within 1e-5", lowest,
              turn);
    return report_done();
}
