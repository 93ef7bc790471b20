#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/measure/accuracy/accuracy.h"
#include "tools/measure/accuracy/reference.h"

/* The means of the search: the program, the time, and what its states are compared with. */
typedef struct search {
    const char *drive;
    const char *time;
    double error; /* at most */
    reference r;
    int line;
} search;

/* The program run with numbers of steps, or with tolerances. */
typedef struct run {
    char **argument;
    size_t count, room;
    double *steps;
    double *error; /* as a table tells it: of four digits */
} run;

enum { STEPS, TIME, STATE }; /* of a line of the program */

static search search_begin(const char *const drive, const char *const time, const char *const error,
                           const char *const reference_path)
{
    search s = {.drive = drive, .time = time, .error = strtod(error, NULL), .r = reference_read(reference_path)};
    s.line = reference_at(&s.r, time);
    if (s.line < 0) {
        fprintf(stderr, "accuracy: %s: no reference after %s s\n", reference_path, time);
        exit(EXIT_FAILURE);
    }
    return s;
}

/* An argument for the program's next run. */
static void add(run *const r, const char *const format, const double value)
{
    enum { BYTES = 32 };
    if (r->count == r->room) {
        r->room = 2 * r->room + 16;
        r->argument = realloc(r->argument, r->room * sizeof *r->argument);
        if (r->argument == NULL) {
            fputs("accuracy: no memory\n", stderr);
            exit(EXIT_FAILURE);
        }
    }
    r->argument[r->count] = table_memory(BYTES, 1);
    snprintf(r->argument[r->count++], BYTES, format, value);
}

static void clear(run *const r)
{
    for (size_t i = 0; i < r->count; i++) {
        free(r->argument[i]);
    }
    free(r->argument);
    free(r->steps);
    free(r->error);
    *r = (run){.count = 0};
}

/* The output of the program, a line for each argument. */
static table start(const search *const s, const run *const r)
{
    size_t bytes = strlen(s->drive) + strlen(s->time) + 8;
    for (size_t i = 0; i < r->count; i++) {
        bytes += strlen(r->argument[i]) + 1;
    }
    char *const command = table_memory(bytes, 1);
    size_t used = (size_t)snprintf(command, bytes, "'%s' %s", s->drive, s->time);
    for (size_t i = 0; i < r->count; i++) {
        used += (size_t)snprintf(command + used, bytes - used, " %s", r->argument[i]);
    }
    FILE *const output = popen(command, "r");
    if (output == NULL) {
        perror(s->drive);
        exit(EXIT_FAILURE);
    }
    const table lines = table_take(output, s->drive, ' ');
    if (pclose(output) != 0 || lines.rows != r->count) {
        fprintf(stderr, "accuracy: %s does not run\n", s->drive);
        exit(EXIT_FAILURE);
    }
    free(command);
    return lines;
}

static double as_told(const double error)
{
    char said[32];
    snprintf(said, sizeof said, "%.3e", error);
    return strtod(said, NULL);
}

/* Runs the program and compares: fills steps and error. */
static void measure(const search *const s, run *const r)
{
    table lines = start(s, r);
    r->steps = table_memory(r->count, sizeof *r->steps);
    r->error = table_memory(r->count, sizeof *r->error);
    for (size_t i = 0; i < r->count; i++) {
        r->steps[i] = table_number(&lines, i, STEPS);
        r->error[i] = as_told(reference_error(&s->r, s->line, &lines, i, STATE));
    }
    table_free(&lines);
}

static double error_with(const search *const s, const long steps)
{
    run one = {.count = 0};
    add(&one, "%.0f", (double)steps);
    measure(s, &one);
    const double error = one.error[0];
    clear(&one);
    return error;
}

/* The first argument from which on all errors are small enough: `count` if there is none. */
static size_t first_within(const search *const s, const run *const r)
{
    size_t first = r->count;
    while (first > 0 && r->error[first - 1] <= s->error) {
        first--;
    }
    return first;
}

/* Doubles the steps until the error is far below, goes back over a grid of sixteen to a doubling to the first that is
 * small enough, and halves the interval before it. */
static long search_fewest(const search *const s, const long coarsest)
{
    const long most = (long)(strtod(s->time, NULL) * 1e6);
    long steps = coarsest;
    while (!(error_with(s, steps) <= s->error / 16)) {
        steps *= 2;
        if (steps > most) {
            steps = most;
            break;
        }
    }
    run grid = {.count = 0};
    for (double n = fmax(1, floor((double)steps / 256)); n < (double)steps; n = fmax(n * pow(2, 1.0 / 16), n + 1)) {
        add(&grid, "%.0f", floor(n));
    }
    add(&grid, "%.0f", (double)steps);
    measure(s, &grid);
    const size_t first = first_within(s, &grid);
    long few = first == 0 ? 0 : (long)grid.steps[first - 1];
    long enough = first == grid.count ? 0 : (long)grid.steps[first];
    clear(&grid);
    while (enough - few > 1) {
        const long middle = (few + enough) / 2;
        if (error_with(s, middle) <= s->error) {
            enough = middle;
        } else {
            few = middle;
        }
    }
    return enough;
}

int fewest(const char *const drive, const char *const time, const char *const coarsest, const char *const error,
           const char *const reference_path)
{
    search s = search_begin(drive, time, error, reference_path);
    const long steps = strtol(coarsest, NULL, 10);
    printf("%.3e %.3e ", error_with(&s, 2 * steps), error_with(&s, 4 * steps));
    printf("%ld -\n", search_fewest(&s, steps));
    table_free(&s.r.lines);
    return EXIT_SUCCESS;
}

/* A grid of tolerances, four to a doubling. */
int loosest(const char *const drive, const char *const time, const char *const error, const char *const reference_path)
{
    search s = search_begin(drive, time, error, reference_path);
    run grid = {.count = 0};
    for (double tolerance = 1e-2; tolerance > 1e-13; tolerance /= pow(2, 1.0 / 4)) {
        add(&grid, "%.3g", tolerance);
    }
    measure(&s, &grid);
    const size_t first = first_within(&s, &grid);
    const bool found = first < grid.count;
    printf("- - %.0f %s\n", found ? grid.steps[first] : 0, found ? grid.argument[first] : "0");
    clear(&grid);
    table_free(&s.r.lines);
    return EXIT_SUCCESS;
}
