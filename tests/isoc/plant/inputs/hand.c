/* A plant by hand whose input is smooth: x' = u, u = sin(t)^4, which is at rest at the start. Prints its error at 2 s.
 */
#define ISO_HAS_SMOOTH_INPUTS
#include "core/runtime/handwritten.h"
#include "core/runtime/tick.h"

#include <math.h>
#include <stdio.h>

ISO_PLANT_MEMORY(1, 1, 0, 1);

static const real start[1] = {R(0.0)};
static const bool smooth[1] = {true};

static void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                       const real *restrict const p)
{
    (void)x;
    (void)p;
    dx[0] = u[0];
}

static void output(real *restrict const y, const real *restrict const x, const real *restrict const u,
                   const real *restrict const p)
{
    (void)u;
    (void)p;
    y[0] = x[0];
}

static void drive(void *const instance, const uint64_t tick)
{
    plant_memory *const memory = instance;
    memory->u[0] = (real)pow(sin((double)tick * (double)ISO_STEP_SIZE), 4.0);
}

static const iso_equations equations = {.derivative = derivative, .held = 1, .inputs = 1, .smooth = smooth};

ISO_PLANT(1, 1, 0, 1, .name = "hand", .output_names = "x", .drive = drive);

int main(void)
{
    const double end = 2.0;
    iso_plant_start(&iso_the_plant);
    for (uint32_t tick = 0; tick < (uint32_t)lround(end / (double)ISO_STEP_SIZE); tick++) {
        (void)iso_plant_tick(&iso_the_plant, tick);
    }
    printf("%.3e\n", fabs((double)iso_the_plant.x[0] - (0.375 * end - sin(2.0 * end) / 4.0 + sin(4.0 * end) / 32.0)));
    return 0;
}
