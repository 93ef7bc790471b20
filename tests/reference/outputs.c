/* The outputs of a plant's own run against a reference solution in a text file.
 *
 *     outputs FILE CASE DEMAND ENERGY [EFFORT OUTPUT]
 *                        TAP: the error of every row is at most DEMAND; at every step the energy is off by at most
 * ENERGY (J) what it was at the start and what a constant EFFORT (N m) on the angle OUTPUT has added outputs FILE CASE
 * the errors alone, one on a line
 *
 * The error of a row is the largest of its columns, of |y| where that is above 1. A file has `case NAME ...`, `columns`
 * with the names of outputs, and `row` with the time and the values.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/runtime/plant.h"
#include "tests/host/report.h"
#include "tests/reference/named.h"

enum { COLUMNS_MAX = 16, LINE_MAX_LENGTH = 2048 };

typedef struct table {
    int columns, output[COLUMNS_MAX];
} table;

/* The energy less the work of an effort, and how far off its first value it was at most. */
typedef struct balance {
    int energy, angle; /* outputs; -1: none */
    double effort, first, worst;
} balance;

static bool read_columns(char *const line, table *const t)
{
    t->columns = 0;
    for (const char *word = strtok(line, " \n"); word != NULL; word = strtok(NULL, " \n")) {
        t->output[t->columns] = find_output(word);
        if (t->output[t->columns++] < 0 || t->columns == COLUMNS_MAX) {
            return false;
        }
    }
    return true;
}

static double balance_now(const balance *const b)
{
    iso_the_plant.model->output(iso_the_plant.memory);
    const double energy = b->energy < 0 ? 0.0 : (double)iso_the_plant.y[b->energy];
    return energy - (b->angle < 0 ? 0.0 : b->effort * (double)iso_the_plant.y[b->angle]);
}

/* Runs to the time of a row and compares. */
static double error_of_row(char *const line, const table *const t, balance *const b, uint32_t *const tick,
                           double *const time)
{
    double largest = 0.0;
    char *at;
    *time = strtod(line, &at);
    const double ticks = *time / (double)iso_the_plant.model->step_size;
    while (*tick < (uint32_t)lround(ticks)) {
        if (iso_the_plant.model->drive != NULL) {
            iso_the_plant.model->drive(iso_the_plant.memory, *tick);
        }
        iso_the_plant.model->step(iso_the_plant.memory);
        ++*tick;
        const double off = fabs(balance_now(b) - b->first);
        b->worst = off <= b->worst ? b->worst : off; /* what is not a number stays */
    }
    for (int i = 0; i < t->columns; i++) {
        const double wanted = strtod(at, &at);
        const double error = fabs((double)iso_the_plant.y[t->output[i]] - wanted) / fmax(1.0, fabs(wanted));
        largest = error <= largest ? largest : error;
    }
    return largest;
}

static void compare(const char *const name, const double time, const double error, const char *const demand)
{
    if (demand == NULL) {
        printf("%.3e\n", error);
        return;
    }
    const double most = strtod(demand, NULL);
    report_ok(error <= most, "%s, t = %g s: error %.2e, %.1f digits; at most %.1e", name, time, error, -log10(error),
              most);
}

int main(int count, char **arguments)
{
    static char line[LINE_MAX_LENGTH];
    FILE *const file = count >= 3 ? fopen(arguments[1], "r") : NULL;
    const char *const demand = count > 3 ? arguments[3] : NULL;
    bool here = false, read = file != NULL;
    uint32_t tick = 0;
    table t = {0};
    balance b = {.energy = find_output("energy"), .angle = count > 6 ? find_output(arguments[6]) : -1};
    b.effort = count > 6 ? strtod(arguments[5], NULL) : 0.0;
    while (file != NULL && fgets(line, sizeof line, file) != NULL) {
        if (strncmp(line, "case ", 5) == 0) {
            const size_t length = strcspn(line + 5, " \n");
            here = length == strlen(arguments[2]) && strncmp(line + 5, arguments[2], length) == 0;
            if (here) {
                iso_plant_start(&iso_the_plant);
                b.first = balance_now(&b);
            }
        } else if (here && strncmp(line, "columns ", 8) == 0) {
            read = read_columns(line + 8, &t) && read;
        } else if (here && strncmp(line, "row ", 4) == 0) {
            double time;
            const double error = error_of_row(line + 4, &t, &b, &tick, &time);
            compare(arguments[2], time, error, demand);
        }
    }
    if (file != NULL) {
        (void)fclose(file);
    }
    if (demand == NULL) {
        return read && tick > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
    }
    const double most = count > 4 ? strtod(arguments[4], NULL) : 0.0;
    report_ok(b.energy >= 0 && b.worst <= most, "%s: at every step the energy is off by at most %.2e J; allowed %.1e",
              arguments[2], b.worst, most);
    report_ok(read && tick > 0, "%s: the reference is read, and its columns are outputs", arguments[2]);
    return report_done();
}
