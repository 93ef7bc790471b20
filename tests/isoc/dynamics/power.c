/* Energy over a second of a plant's motion, from its start and driven as its scene says: the plant's own energy output
 * changes by the work of its inputs less that of its dampers. Linked with the plant and with its table, in double.
 *
 * The power is one more state of the integration by rk4, so the residual of the balance is of order h^4: halving the
 * step divides it by 16. Inputs are held over a tick in both.
 */
#include <math.h>
#include <string.h>

#include "core/methods/rk4.h"
#include "core/runtime/plant.h"
#include "tests/host/report.h"
#include "tests/isoc/dynamics/tables.h"
#include "tests/one_step.h"

enum { STATES_MAX = 2 * BODIES_MAX + 1, NUMBERS_MAX = 3 * OUTPUTS_MAX };

/* Relative to the size of the energies: truncation of a step of the scene, and rounding of a sum of some thousand. */
#define TRUNCATION 1e-8
#define ROUNDING 1e-13

/* Positive control: all accelerations times this. */
static double off = 1.0;

/* The plant's derivative, and behind its states the power of inputs and dampers. */
static void derivative(double *restrict const dx, const double *restrict const x, const double *restrict const u,
                       const double *restrict const p)
{
    const mechanism *const m = &the_table.mechanism;
    const int states = iso_the_plant.model->states;
    const double *speed = x + states / 2;
    iso_the_derivative(dx, x, u, p);
    for (int i = states / 2; i < states; i++) {
        dx[i] *= off;
    }
    dx[states] = 0.0;
    for (int j = 0; j < m->bodies; j++) {
        const tree_joint *const joint = &m->joint[j];
        if (joint->kind != FIXED) {
            const double drive = joint->input == 0 ? 0.0 : u[joint->input - 1];
            dx[states] += (drive - (double)joint->damping * *speed) * *speed;
            speed++;
        }
    }
}

/* The last of every scene's outputs. */
static double energy(const double *const x)
{
    const iso_model *const model = iso_the_plant.model;
    memcpy(iso_the_plant.x, x, model->states * sizeof *x);
    model->output(iso_the_plant.memory);
    return iso_the_plant.y[model->outputs - 1];
}

typedef struct balance {
    double residual; /* J */
    double size;     /* J: all the work, without signs, and the joule that the scenes start with or swing about */
} balance;

/* Over a second, with so many steps in a tick. */
static balance run(const int steps)
{
    const size_t n = (size_t)iso_the_plant.model->states + 1;
    const double h = iso_the_plant.model->step_size / steps;
    const uint32_t ticks = UINT32_C(1000000000) / iso_the_plant.model->period_ns;
    double x[STATES_MAX] = {0.0};
    double work[ISO_EXPLICIT_VECTORS * STATES_MAX];
    const iso_history history = {.n = n, .x = x};
    iso_plant_start(&iso_the_plant);
    memcpy(x, iso_the_plant.model->start, (n - 1) * sizeof *x);
    const double before = energy(x);
    balance b = {0.0, 1.0};
    for (uint32_t tick = 0; tick < ticks; tick++) {
        const double done = x[n - 1];
        if (iso_the_plant.model->drive != NULL) {
            iso_the_plant.model->drive(iso_the_plant.memory, tick);
        }
        for (int i = 0; i < steps; i++) {
            (void)one_explicit_step(&iso_tableau_rk4, &history, derivative, h, iso_the_plant.u,
                                    iso_the_plant.model->defaults, work);
        }
        b.size += fabs(x[n - 1] - done);
    }
    b.residual = fabs(energy(x) - before - x[n - 1]);
    return b;
}

int main(void)
{
    const balance whole = run(1);
    const balance half = run(2);
    const double limit = fmax(whole.residual / 12.0, ROUNDING * whole.size);
    report_ok(whole.residual <= TRUNCATION * whole.size, "energy - work: %.2e J of %.3g J, relative limit %.0e",
              whole.residual, whole.size, TRUNCATION);
    report_ok(half.residual <= limit, "energy - work at half the step: %.2e J <= %.2e J", half.residual, limit);
    off = 1.0 + 1e-6;
    const balance wrong = run(1);
    report_ok(wrong.residual > TRUNCATION * wrong.size, "control: accelerations off by 1e-6 are seen: %.2e J",
              wrong.residual);
    return report_done();
}
