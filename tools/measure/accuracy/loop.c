#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/measure/accuracy/accuracy.h"
#include "tools/table/table.h"

/* Cells of what was measured: of held inputs, then of smooth ones, as `fewest` tells them; the instructions of a step. */
enum { METHOD, HELD = 1, SMOOTH = 5, INSTRUCTIONS = 9, READINGS = 2 };
enum { STEP_ERROR = 1, STEPS = 2 }; /* from the first cell of a reading on */

typedef struct loops {
    table rows;
    double time, step; /* s; a tick is a step of the scene */
} loops;

static double number(const loops *const l, const size_t row, const size_t cell)
{
    const char *const text = table_text(&l->rows, row, cell);
    return strcmp(text, "-") == 0 ? HUGE_VAL : table_number(&l->rows, row, cell);
}

/* Steps for the error in the time; with held inputs as many in every tick. Infinite if there are not enough. */
static double steps(const loops *const l, const size_t row, const size_t reading)
{
    const double ticks = floor(l->time / l->step + 0.5);
    const double found = number(l, row, (reading == 0 ? HELD : SMOOTH) + STEPS);
    return !(found > 0) || isinf(found) ? HUGE_VAL : reading == 0 ? ticks * ceil(found / ticks) : found;
}

/* Instructions of a second with them. */
static double cost(const loops *const l, const size_t row, const size_t reading)
{
    return number(l, row, INSTRUCTIONS + reading) * steps(l, row, reading) / l->time;
}

static void put(const char *const format, const double value)
{
    if (isfinite(value)) {
        printf(format, value);
    } else {
        printf(" -");
    }
    printf(" |");
}

static void put_row(const loops *const l, const size_t row)
{
    printf("| %s |", table_text(&l->rows, row, METHOD));
    for (size_t reading = 0; reading < READINGS; reading++) {
        const double needed = steps(l, row, reading);
        put(" %.2e", number(l, row, (reading == 0 ? HELD : SMOOTH) + STEP_ERROR));
        put(" %.3g", reading == 0 ? needed * l->step / l->time : 1000 * l->time / needed);
        put(" %.0f", number(l, row, INSTRUCTIONS + reading));
        put(" %.0f", cost(l, row, reading));
    }
    putchar('\n');
}

/* The method with the least of a value; none is the number of rows. */
static size_t least(const loops *const l, double (*const value)(const loops *, size_t, size_t), const size_t reading)
{
    size_t best = l->rows.rows;
    for (size_t row = 0; row < l->rows.rows; row++) {
        const double its = value(l, row, reading);
        if (isfinite(its) && (best == l->rows.rows || its < value(l, best, reading))) {
            best = row;
        }
    }
    return best;
}

static double error_of(const loops *const l, const size_t row, const size_t reading)
{
    return number(l, row, (reading == 0 ? HELD : SMOOTH) + STEP_ERROR);
}

int loop(const char *const measured_path, const char *const time, const char *const step, const char *const error)
{
    static const char *const names[READINGS] = {"held", "smooth"};
    loops l = {table_read(measured_path, ' '), strtod(time, NULL), strtod(step, NULL)};
    bool any = false;
    printf(
        "| method | held: error, %g ms | steps a tick for %s | instructions | per second | smooth: error, %g ms | step "
        "for %s, ms | instructions | per second |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|\n",
        1000 * l.step, error, 1000 * l.step, error);
    for (size_t row = 0; row < l.rows.rows; row++) {
        put_row(&l, row);
    }
    putchar('\n');
    for (size_t reading = 0; reading < READINGS; reading++) {
        const size_t exact = least(&l, error_of, reading), cheap = least(&l, cost, reading);
        if (exact < l.rows.rows) {
            printf("- Inputs %s: the least error with one step a tick: %s.\n", names[reading],
                   table_text(&l.rows, exact, METHOD));
        }
        if (cheap < l.rows.rows) {
            any = true;
            printf("- Inputs %s: the fewest instructions for an error of %s: %s.\n", names[reading], error,
                   table_text(&l.rows, cheap, METHOD));
        }
    }
    table_free(&l.rows);
    return any ? EXIT_SUCCESS : EXIT_FAILURE;
}
