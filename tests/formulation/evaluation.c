/* The plant whose symbol was renamed to PLANT, and that of its derivative to SLOPE, as the evaluation EVALUATION. */
#include "tests/formulation/evaluation.h"

#include "core/runtime/plant.h"

extern const iso_plant PLANT;
extern iso_derivative *const SLOPE;

static void take(const double *const x)
{
    for (size_t i = 0; i < PLANT.model->states; i++) {
        PLANT.x[i] = (real)x[i];
    }
}

static void give(double *const to, const real *const from)
{
    for (size_t i = 0; i < PLANT.model->states; i++) {
        to[i] = (double)from[i];
    }
}

static size_t start(double *const x)
{
    iso_plant_start(&PLANT);
    give(x, PLANT.x);
    return PLANT.model->states;
}

static void step(double *const x, const int steps)
{
    take(x);
    for (int n = 0; n < steps; n++) {
        PLANT.model->step(PLANT.memory);
    }
    give(x, PLANT.x);
}

static void derivatives(double *const dx, const double *const x)
{
    real made[STATES_MAX];
    take(x);
    SLOPE(made, PLANT.x, PLANT.u, PLANT.p);
    give(dx, made);
}

const evaluation EVALUATION = {.start = start, .step = step, .derivatives = derivatives};
