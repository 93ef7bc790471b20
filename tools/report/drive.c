/* Runs a plant from its start and prints the state that it reaches, with as many steps as one likes.
 *
 *     drive about                its step in seconds, and its states
 *     drive TIME STEPS...        for each number of steps a line: the steps, the time that they make with the step as a
 *                                real, and the state there
 *     drive TIME TOLERANCE...    of adams, whose tick stays as it is; the steps are those of the ticks together
 *     drive count STEPS          only runs: once it is under way, the STEPS in the function `steps` are to be counted
 *
 * Inputs keep the values that they have at the start, so that what is seen is the method's error and not that of an
 * input held over a step. Compiled with the plant under test, in its real; tools/report/step.h has told the plant of
 * `report_step` and `report_tolerance`, but not where instructions are counted.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/runtime/plant.h"
#include "tools/report/step.h"

/* Steps after which every method is under way. */
enum { START_STEPS = 8 };

real report_step;
real report_tolerance;

static const iso_plant *const plant = &iso_the_plant;

static void steps(const long count)
{
    for (long i = 0; i < count; i++) {
        plant->model->step(plant->memory);
    }
}

/* Called, not inlined. */
static void (*volatile const counted)(long) = steps;

static long number(const char *const text)
{
    char *end = NULL;
    const long count = strtol(text, &end, 10);
    if (end == text || *end != '\0' || count < 1) {
        fprintf(stderr, "drive: %s is no number of steps\n", text);
        exit(EXIT_FAILURE);
    }
    return count;
}

/* With `text` steps, or as tolerance. */
static void run(const double time, const char *const text)
{
    long count;
    if (plant->adams == NULL) {
        count = number(text);
        report_step = (real)(time / (double)count);
    } else {
        report_tolerance = (real)strtod(text, NULL);
        report_step = plant->model->step_size;
        count = (long)(time / (double)report_step + 0.5);
    }
    iso_plant_start(plant);
    counted(count);
    printf("%ld %.17g", plant->adams == NULL ? count : (long)plant->adams->substeps,
           (double)count * (double)report_step);
    for (size_t i = 0; i < plant->model->states; i++) {
        printf(" %.17g", (double)plant->x[i]);
    }
    printf("\n");
}

int main(const int argc, char **const argv)
{
    if (argc == 2 && strcmp(argv[1], "about") == 0) {
        printf("%s %u\n", plant->model->step_text, (unsigned)plant->model->states);
    } else if (argc == 3 && strcmp(argv[1], "count") == 0) {
        report_step = plant->model->step_size;
        iso_plant_start(plant);
        for (int i = 0; i < START_STEPS; i++) {
            plant->model->step(plant->memory);
        }
        counted(number(argv[2]));
        printf("%s\n", argv[2]);
    } else if (argc >= 3) {
        for (int i = 2; i < argc; i++) {
            run(strtod(argv[1], NULL), argv[i]);
        }
    } else {
        fputs("usage: drive about | drive TIME STEPS_OR_TOLERANCE... | drive count STEPS\n", stderr);
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
