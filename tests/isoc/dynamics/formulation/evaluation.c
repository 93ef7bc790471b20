/* The plant in the file PLANT_FILE, as the evaluation EVALUATION. */
#include PLANT_FILE

#include "tests/isoc/dynamics/formulation/evaluation.h"

static void take_state(const double *const x)
{
    for (size_t i = 0; i < iso_the_plant.model->states; i++) {
        iso_the_plant.x[i] = (real)x[i];
    }
    iso_the_plant.model->output(iso_the_plant.memory);
}

static void give_state(double *const to, const real *const from)
{
    for (size_t i = 0; i < iso_the_plant.model->states; i++) {
        to[i] = (double)from[i];
    }
}

static size_t begin_plant(double *const x)
{
    iso_plant_start(&iso_the_plant);
    give_state(x, iso_the_plant.x);
    return iso_the_plant.model->states;
}

static void make_steps(double *const x, const int steps)
{
    take_state(x);
    for (int n = 0; n < steps; n++) {
        iso_the_plant.model->step(iso_the_plant.memory);
    }
    give_state(x, iso_the_plant.x);
}

static void give_derivatives(double *const dx, const double *const x)
{
    real made[STATES_MAX];
    take_state(x);
    iso_the_derivative(made, iso_the_plant.x, iso_the_plant.u, iso_the_plant.p);
    give_state(dx, made);
}

const evaluation EVALUATION = {.start = begin_plant, .step = make_steps, .derivatives = give_derivatives};
