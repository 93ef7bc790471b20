/* How near a run comes to singular positions of closed loops, and how far these come apart. Compiled with a plant that
 * tools/measure/pivots.h was read before, in its real, whose last output is the violation.
 *
 *     nearness TICKS ROWS
 *
 * It runs as isochron run does, and prints a table of at most so many rows, each of as many ticks: the time of its end;
 * the least pivot, over the largest that the same pivot has in the run; the largest factor by which one changed in a
 * step; and the largest violation.
 */
#include <float.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/runtime/tick.h"
#include "tools/file/file.h"
#include "tools/measure/pivots.h"
#include "tools/trace/decimal.h"

real report_pivots[REPORT_PIVOTS_MOST];
size_t report_pivot_count;

static const iso_plant *const plant = &iso_the_plant;

typedef struct run {
    real *pivots;     /* [ticks count] */
    real *violations; /* [ticks + 1], from the start on */
    size_t ticks, count;
    real largest[REPORT_PIVOTS_MOST];
} run;

static void note(run *const r)
{
    const size_t count = report_pivot_count;
    if (count == 0) {
        quit("nearness: no pivots are watched");
    }
    if (r->pivots == NULL) {
        r->pivots = memory_for(r->ticks * count, sizeof *r->pivots);
        r->count = count;
        r->ticks = 0;
    }
    memcpy(r->pivots + r->ticks * count, report_pivots, count * sizeof *report_pivots);
    for (size_t k = 0; k < count; k++) {
        r->largest[k] = report_pivots[k] > r->largest[k] ? report_pivots[k] : r->largest[k];
    }
    r->violations[++r->ticks] = plant->y[plant->model->outputs - 1];
}

static run run_for(const size_t ticks)
{
    run r = {.ticks = ticks, .violations = memory_for(ticks + 1, sizeof(real))};
    iso_plant_start(plant);
    (void)iso_plant_output(plant);
    r.violations[0] = plant->y[plant->model->outputs - 1];
    uint16_t guard = plant->model->states;
    for (uint64_t tick = 0; tick < ticks && guard == plant->model->states; tick++) {
        guard = iso_plant_tick(plant, tick);
        note(&r);
    }
    return r;
}

/* How many times as large the larger of two pivots is; infinite where one is not above zero. */
static double change(const real a, const real b)
{
    if (!(a > R(0.0) && b > R(0.0))) {
        return DBL_MAX;
    }
    return a > b ? (double)a / (double)b : (double)b / (double)a;
}

static void put_row(const run *const r, const size_t first, const size_t end)
{
    char time[DECIMAL_BYTES], violation[DECIMAL_BYTES];
    double least = 1.0, most = 1.0;
    real apart = first == 0 ? r->violations[0] : R(0.0);
    for (size_t tick = first; tick < end; tick++) {
        apart = iso_max(apart, r->violations[tick + 1]);
        const real *const now = r->pivots + tick * r->count;
        for (size_t k = 0; k < r->count; k++) {
            const double part = (double)now[k] / (double)r->largest[k];
            const double changed = tick == 0 ? 1.0 : change(now[k], (now - r->count)[k]);
            least = part < least ? part : least;
            most = changed > most ? changed : most;
        }
    }
    printf("%s\t%.6g\t%.6g\t%s\n",
           decimal_of((double)end * strtod(plant->model->step_text, NULL), sizeof(double), time), least, most,
           decimal_of((double)(float)apart, sizeof(float), violation));
}

int main(const int argc, char **const argv)
{
    const size_t ticks = argc == 3 ? strtoul(argv[1], NULL, 10) : 0, rows = argc == 3 ? strtoul(argv[2], NULL, 10) : 0;
    if (ticks == 0 || rows == 0) {
        quit("nearness: usage: nearness TICKS ROWS, both above 0");
    }
    const run r = run_for(ticks);
    puts("time_s\tleast_pivot\tlargest_change\tviolation");
    const size_t each = (ticks + rows - 1) / rows;
    for (size_t first = 0; first < r.ticks; first += each) {
        put_row(&r, first, first + each < r.ticks ? first + each : r.ticks);
    }
    free(r.pivots);
    free(r.violations);
    return EXIT_SUCCESS;
}
