/* A planar plant, and the independent dynamics, against formulas derived by hand. Linked with one of each. */
#include <string.h>

#include "core/runtime/plant.h"
#include "tests/host/report.h"
#include "tests/isoc/dynamics/closed_form.h"
#include "tests/isoc/dynamics/random.h"
#include "tests/isoc/dynamics/tables.h"

enum { STATES = 100, JOINTS_MAX = 2 };

/* Some tens of terms of 2^-53 and of 2^-64, and a mass matrix of condition below 100. */
#define PLANT_TOLERANCE 1e-13L
#define SOLVER_TOLERANCE 1e-16L

/* |a - b| / |b| in the 2-norm. */
static wide relative(const wide *const a, const wide *const b, const int n)
{
    wide error = 0.0L;
    wide size = 0.0L;
    for (int i = 0; i < n; i++) {
        error += (a[i] - b[i]) * (a[i] - b[i]);
        size += b[i] * b[i];
    }
    return sqrtl(error / size);
}

int main(void)
{
    const int joints = iso_the_plant.model->states / 2;
    sequence random = {UINT64_C(0xD1B54A32D192ED03)};
    wide plant_worst = 0.0L;
    wide solver_worst = 0.0L;
    bool solved = true;

    if (!report_ok(joints == the_table.mechanism.bodies && joints <= JOINTS_MAX, "the plant has the joints")) {
        return report_done();
    }
    for (int k = 0; k < STATES; k++) {
        double x[2 * JOINTS_MAX];
        double dx[2 * JOINTS_MAX];
        joint_motion motion = {{{0.0L}}, {{0.0L}}, {{0.0L}}};
        wide q[JOINTS_MAX];
        wide qd[JOINTS_MAX];
        wide exact[JOINTS_MAX];
        wide got[JOINTS_MAX];
        wide solver[JOINTS_MAX] = {0.0L};
        for (int i = 0; i < joints; i++) {
            x[i] = sequence_next(&random, 3.14159265358979);
            x[joints + i] = sequence_next(&random, 10.0);
            motion.q[i][0] = q[i] = (wide)x[i];
            motion.v[i][0] = qd[i] = (wide)x[joints + i];
        }
        const double u[1] = {sequence_next(&random, 10.0)};
        const wide wide_u[1] = {(wide)u[0]};
        iso_the_derivative(dx, x, u, iso_the_plant.model->defaults);
        for (int i = 0; i < joints; i++) {
            got[i] = (wide)dx[joints + i];
        }
        closed_form(exact, q, qd, wide_u);
        plant_worst = fmaxl(plant_worst, relative(got, exact, joints));
        plant_worst = memcmp(dx, x + joints, (size_t)joints * sizeof *x) == 0 ? plant_worst : HUGE_VALL;

        solution s;
        solved = solved && mechanism_solve(&the_table.mechanism, &motion, wide_u, &s);
        for (int i = 0; i < joints; i++) {
            solver[i] = s.a[i][0];
        }
        solver_worst = fmaxl(solver_worst, relative(solver, exact, joints));
    }
    report_ok(plant_worst <= PLANT_TOLERANCE, "plant against the formula: %.2Le <= %.0Le", plant_worst,
              PLANT_TOLERANCE);
    report_ok(solved && solver_worst <= SOLVER_TOLERANCE, "independent dynamics against the formula: %.2Le <= %.0Le",
              solver_worst, SOLVER_TOLERANCE);
    return report_done();
}
