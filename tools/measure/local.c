/* The local error of single steps: the method's estimate, and the true error. Compiled in double, as drive.c is, with
 * two plants: one whose method is under test, with `checked yes`, and that of a reference.
 *
 *     local told TIME STEPS    makes these steps; of some, evenly spread, a line: the time before it, the step, what
 *                              the method tells behind it, and the states before and behind it
 *     local true TIME          reads these lines; for each one with the time, what the method tells, and the error: the
 *                              largest difference of any state to that behind PARTS steps of this plant in place of one
 *
 * Inputs are those of drive.c.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/runtime/plant.h"
#include "tools/measure/signals.h"
#include "tools/measure/step.h"

/* Steps with a line at most, and steps of the reference in place of one: of order four it errs 64^4 times less. */
enum { SAMPLES = 64, PARTS = 64, STATES_MOST = 256 };

real report_step;
real report_tolerance;

static const iso_plant *const plant = &iso_the_plant;

static void put_state(const real *const x)
{
    for (size_t i = 0; i < plant->model->states; i++) {
        printf(" %.17g", (double)x[i]);
    }
}

static void tell(const double time, const long steps)
{
    const long apart = steps / SAMPLES > 1 ? steps / SAMPLES : 1;
    report_step = (real)(time / (double)steps);
    signals_start(plant, time);
    for (long i = 1; i <= steps; i++) {
        if (i % apart != 0) {
            plant->model->step(plant->memory);
            continue;
        }
        real before[STATES_MOST];
        memcpy(before, plant->x, plant->model->states * sizeof *before);
        plant->model->step(plant->memory);
        printf("%.9g %.17g %.17g", (double)(i - 1) * (double)report_step, (double)report_step,
               (double)plant->progress->local_error);
        put_state(before);
        put_state(plant->x);
        printf("\n");
    }
}

/* The largest difference of the states; angles counted down to a turn may be a turn apart. */
static double error_to(const double *const states)
{
    double error = 0.0;
    for (size_t i = 0; i < plant->model->states; i++) {
        const double apart = states[i] - (double)plant->x[i];
        error = fmax(error, fabs(fabs(apart) > 6.0 ? remainder(apart, 8.0 * atan(1.0)) : apart));
    }
    return error;
}

/* Reads lines of numbers; returns how many the last one has, which is cut off unless it has none. */
static size_t compare(const double whole)
{
    enum { TIME, STEP, ESTIMATE, STATES };
    static double line[STATES + 2 * STATES_MOST];
    const size_t states = plant->model->states, numbers = STATES + 2 * states;
    size_t count = 0;
    while (scanf("%lf", &line[count]) == 1) {
        if (++count < numbers) {
            continue;
        }
        count = 0;
        signals_start(plant, whole);
        for (size_t i = 0; i < states; i++) {
            plant->x[i] = (real)line[STATES + i];
        }
        report_step = (real)(line[STEP] / PARTS);
        for (int i = 0; i < PARTS; i++) {
            plant->model->step(plant->memory);
        }
        printf("%.9g\t%.3e\t%.3e\n", line[TIME], line[ESTIMATE], error_to(line + STATES + states));
    }
    return count;
}

int main(const int argc, char **const argv)
{
    if (argc == 4 && strcmp(argv[1], "told") == 0) {
        const long steps = strtol(argv[3], NULL, 10);
        if (plant->progress == NULL || plant->model->states > STATES_MOST || steps < 1) {
            fputs("local: the plant tells no local error, or has too many states\n", stderr);
            return EXIT_FAILURE;
        }
        tell(strtod(argv[2], NULL), steps);
    } else if (argc == 3 && strcmp(argv[1], "true") == 0) {
        if (plant->model->states > STATES_MOST || compare(strtod(argv[2], NULL)) != 0) {
            fputs("local: a line that is cut off, or too many states\n", stderr);
            return EXIT_FAILURE;
        }
    } else {
        fputs("usage: local told TIME STEPS | local true TIME\n", stderr);
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
