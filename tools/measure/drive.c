/* Runs a plant from its start and prints the state that it reaches, with as many steps as one likes.
 *
 *     drive about                its step in seconds, its states and its inputs
 *     drive TIME STEPS...        for each number of steps a line: the steps, the time that they make with the step as a
 *                                real, and the state there
 *     drive TIME TOLERANCE...    of adams, whose tick stays as it is; the steps are those of the ticks together
 *     drive held TIME STEPS...   the same in a loop: inputs change at every tick, which is the scene's step, and has as
 *                                many steps as make at least STEPS
 *     drive restarted ...        likewise; a method with a history begins anew at every tick
 *     drive smooth TIME STEPS... inputs are sampled at every step
 *     drive count STEPS          only runs: once it is under way, the STEPS in the function `steps` are to be counted
 *     drive rests TIME STEPS     `yes` if no state moves by a millionth of what it may be, 1 + |x|; else `no`
 *
 * In a loop the inputs are those of tools/measure/signals.h, recorded in the file that is named in RECORDED if there is
 * one; else they keep the values that they have at the start, or with STEADY=yes those of signals_start. Memories of
 * effects keep theirs. Compiled with the plant under test, in its real; tools/measure/step.h has told the plant of
 * `report_step` and `report_tolerance`, but not where instructions are counted.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/runtime/plant.h"
#include "tools/measure/signals.h"
#include "tools/measure/step.h"

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

/* How inputs change. */
typedef enum reading { FROZEN, HELD, RESTARTED, SMOOTH, READINGS } reading;

static const char *const readings[READINGS] = {"", "held", "restarted", "smooth"};

static signals loop;

static void put_state(const long count, const double time)
{
    printf("%ld %.17g", count, time);
    for (size_t i = 0; i < plant->model->states; i++) {
        printf(" %.17g", (double)plant->x[i]);
    }
    printf("\n");
}

static void set_inputs(const double t)
{
    for (size_t i = 0; i < loop.inputs; i++) {
        plant->u[i] = (real)signals_at(&loop, i, t);
    }
}

/* In a loop, with `text` steps. */
static void run_loop(const reading as, const double time, const char *const text)
{
    const long wanted = number(text), ticks = as == SMOOTH ? wanted : (long)(time / loop.tick + 0.5);
    const long parts = (wanted + ticks - 1) / ticks;
    report_step = (real)(time / (double)(ticks * parts));
    iso_plant_start(plant);
    for (long tick = 0; tick < ticks; tick++) {
        set_inputs(time / (double)ticks * (double)tick);
        if (as == RESTARTED && plant->model->prime != NULL) {
            plant->model->prime(plant->memory);
        }
        steps(parts);
    }
    put_state(ticks * parts, time);
}

static void run_loops(const reading as, const int count, char **const arguments)
{
    const double time = strtod(arguments[0], NULL);
    const char *const recorded = getenv("RECORDED");
    loop.inputs = plant->model->inputs;
    loop.tick = (double)plant->model->step_size;
    if (loop.inputs == 0 || loop.inputs > SIGNALS_MOST) {
        fputs("drive: no inputs, or too many\n", stderr);
        exit(EXIT_FAILURE);
    }
    if (recorded != NULL && *recorded != '\0') {
        signals_recorded(&loop, recorded);
    } else {
        signals_waves(&loop, plant, time);
    }
    for (int i = 1; i < count; i++) {
        run_loop(as, time, arguments[i]);
    }
    free(loop.samples);
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
    signals_start(plant, time);
    counted(count);
    put_state(plant->adams == NULL ? count : (long)plant->adams->substeps, (double)count * (double)report_step);
}

/* Whether the plant rests for so long. */
static bool rests(const double time, const long count)
{
    enum { STATES_MOST = 512 };
    static double first[STATES_MOST];
    const size_t states = plant->model->states < STATES_MOST ? plant->model->states : STATES_MOST;
    report_step = (real)(time / (double)count);
    signals_start(plant, time);
    for (size_t i = 0; i < states; i++) {
        first[i] = (double)plant->x[i];
    }
    for (long k = 0; k < count; k++) {
        plant->model->step(plant->memory);
        for (size_t i = 0; i < states; i++) {
            if (!(fabs((double)plant->x[i] - first[i]) <= 1e-6 * (1 + fabs(first[i])))) {
                return false;
            }
        }
    }
    return true;
}

/* The reading that a word names; FROZEN if it names none. */
static reading reading_of(const char *const word)
{
    reading as = READINGS;
    while (--as > FROZEN && strcmp(word, readings[as]) != 0) {
    }
    return as;
}

int main(const int argc, char **const argv)
{
    if (argc == 2 && strcmp(argv[1], "about") == 0) {
        printf("%s %u %u\n", plant->model->step_text, (unsigned)plant->model->states, (unsigned)plant->model->inputs);
    } else if (argc == 3 && strcmp(argv[1], "count") == 0) {
        report_step = plant->model->step_size;
        iso_plant_start(plant);
        for (int i = 0; i < START_STEPS; i++) {
            plant->model->step(plant->memory);
        }
        counted(number(argv[2]));
        printf("%s\n", argv[2]);
    } else if (argc == 4 && strcmp(argv[1], "rests") == 0) {
        puts(rests(strtod(argv[2], NULL), number(argv[3])) ? "yes" : "no");
    } else if (argc >= 4 && reading_of(argv[1]) != FROZEN) {
        run_loops(reading_of(argv[1]), argc - 2, argv + 2);
    } else if (argc >= 3) {
        for (int i = 2; i < argc; i++) {
            run(strtod(argv[1], NULL), argv[i]);
        }
    } else {
        fputs("usage: drive about | drive TIME STEPS_OR_TOLERANCE... | drive held|restarted|smooth TIME STEPS... | "
              "drive count STEPS | drive rests TIME STEPS\n",
              stderr);
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
