/* Runs a plant from its start and prints the state that it reaches, with as many steps as one likes.
 *
 *     drive about                its step in seconds, its states and its inputs
 *     drive TIME STEPS...        for each number of steps a line: the steps, the time that they make with the step as a
 *                                real, and the state there
 *     drive pairs STEPS TIME...  for each number of steps and the time behind it such a line
 *     drive TIME TOLERANCE...    of adams, whose tick stays as it is; the steps are those of the ticks together
 *     drive held TIME STEPS...   the same in a loop: inputs change at every tick, which is the scene's step, and has as
 *                                many steps as make at least STEPS
 *     drive restarted ...        likewise; a method with a history begins anew at every tick
 *     drive smooth TIME STEPS... inputs are sampled at every step
 *     drive count STEPS          only runs: once it is under way, the STEPS in the function `steps` are to be counted
 *     drive rests TIME STEPS     `yes` if no state moves by more than 1e-6 (1 + |x|); else `no`
 *
 * The local error of single steps: the method's estimate, and the true error, by two plants in double, the first of
 * which has `checked yes`.
 *
 *     drive told TIME STEPS      makes these steps; of some, evenly spread, a line: the time before it, the step, the
 *                                error that the method estimates, and the states before and behind it
 *     drive true TIME            reads these lines; for each a line with the time, the method's estimate, and the error
 *
 * This error is the largest difference of any state to that behind PARTS steps of this plant in place of one.
 *
 * In a loop the inputs are those of tools/measure/signals.h, recorded in the file that is named in RECORDED if there is
 * one; else they keep the values that they have at the start, or with STEADY=yes those of signals_start. Memories of
 * effects keep theirs. Compiled with the plant under test, in its real; tools/measure/step.h makes the plant use
 * `report_step` and `report_tolerance`, but not where instructions are counted.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/runtime/plant.h"
#include "tools/measure/signals.h"
#include "tools/measure/step.h"

enum {
    START_STEPS = 8, /* after which every method is under way */
    SAMPLES = 64,    /* steps with a line at most */
    PARTS = 64,      /* steps of the reference in place of one: of order four it errs 64^4 times less */
    STATES_MOST = 512
};

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
        quit("drive: %s is no number of steps", text);
    }
    return count;
}

static signals loop;

static void put_states(const real *const x)
{
    for (size_t i = 0; i < plant->model->states; i++) {
        printf(" %.17g", (double)x[i]);
    }
}

static void put_end(const long count, const double time)
{
    printf("%ld %.17g", count, time);
    put_states(plant->x);
    printf("\n");
}

static void set_inputs(const double t)
{
    for (size_t i = 0; i < loop.inputs; i++) {
        plant->u[i] = (real)signals_at(&loop, i, t);
    }
}

/* In a loop, with `text` steps. */
static void run_loop(const bool is_smooth, const bool restarts, const double time, const char *const text)
{
    const long wanted = number(text), ticks = is_smooth ? wanted : (long)(time / loop.tick + 0.5);
    const long parts = (wanted + ticks - 1) / ticks;
    report_step = (real)(time / (double)(ticks * parts));
    iso_plant_start(plant);
    for (long tick = 0; tick < ticks; tick++) {
        set_inputs(time / (double)ticks * (double)tick);
        if (restarts && plant->model->prime != NULL) {
            plant->model->prime(plant->memory);
        }
        steps(parts);
    }
    put_end(ticks * parts, time);
}

/* The words are that of a loop, the time, and numbers of steps. */
static void run_loops(const int count, char **const words)
{
    const bool is_smooth = strcmp(words[0], "smooth") == 0, restarts = strcmp(words[0], "restarted") == 0;
    const double time = strtod(words[1], NULL);
    const char *const recorded = getenv("RECORDED");
    loop.inputs = plant->model->inputs;
    loop.tick = (double)plant->model->step_size;
    if (loop.inputs == 0 || loop.inputs > SIGNALS_MOST) {
        quit("drive: no inputs, or too many");
    }
    if (recorded != NULL && *recorded != '\0') {
        signals_recorded(&loop, recorded);
    } else {
        signals_waves(&loop, plant, time);
    }
    for (int i = 2; i < count; i++) {
        run_loop(is_smooth, restarts, time, words[i]);
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
    put_end(plant->adams == NULL ? count : (long)plant->adams->substeps, (double)count * (double)report_step);
}

/* Whether the plant rests for so long. */
static bool rests(const double time, const long count)
{
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

static void tell(const double time, const long count)
{
    const long apart = count / SAMPLES > 1 ? count / SAMPLES : 1;
    report_step = (real)(time / (double)count);
    signals_start(plant, time);
    for (long i = 1; i <= count; i++) {
        real before[STATES_MOST];
        memcpy(before, plant->x, plant->model->states * sizeof *before);
        plant->model->step(plant->memory);
        if (i % apart == 0) {
            printf("%.9g %.17g %.17g", (double)(i - 1) * (double)report_step, (double)report_step,
                   (double)plant->progress->local_error);
            put_states(before);
            put_states(plant->x);
            printf("\n");
        }
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

/* Reads the lines; returns how many numbers the last one has, which is cut off unless it has none. */
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
        plant->model->output(plant->memory);
        report_step = (real)(line[STEP] / (double)PARTS);
        steps(PARTS);
        printf("%.9g\t%.3e\t%.3e\n", line[TIME], line[ESTIMATE], error_to(line + STATES + states));
    }
    return count;
}

static bool is_loop(const char *const word)
{
    return strcmp(word, "held") == 0 || strcmp(word, "restarted") == 0 || strcmp(word, "smooth") == 0;
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
    } else if (argc >= 4 && argc % 2 == 0 && strcmp(argv[1], "pairs") == 0) {
        for (int i = 2; i < argc; i += 2) {
            run(strtod(argv[i + 1], NULL), argv[i]);
        }
    } else if (argc == 4 && strcmp(argv[1], "rests") == 0) {
        puts(rests(strtod(argv[2], NULL), number(argv[3])) ? "yes" : "no");
    } else if (argc == 4 && strcmp(argv[1], "told") == 0) {
        if (plant->progress == NULL || plant->model->states > STATES_MOST) {
            quit("drive: the plant tells no local error, or has too many states");
        }
        tell(strtod(argv[2], NULL), number(argv[3]));
    } else if (argc == 3 && strcmp(argv[1], "true") == 0) {
        if (plant->model->states > STATES_MOST || compare(strtod(argv[2], NULL)) != 0) {
            quit("drive: a line that is cut off, or too many states");
        }
    } else if (argc >= 4 && is_loop(argv[1])) {
        run_loops(argc - 1, argv + 1);
    } else if (argc >= 3) {
        for (int i = 2; i < argc; i++) {
            run(strtod(argv[1], NULL), argv[i]);
        }
    } else {
        quit("usage: drive about | drive TIME STEPS_OR_TOLERANCE... | drive pairs STEPS TIME... | "
             "drive held|restarted|smooth TIME STEPS... | drive count STEPS | drive rests TIME STEPS | "
             "drive told TIME STEPS | drive true TIME");
    }
    return EXIT_SUCCESS;
}
