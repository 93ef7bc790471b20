#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/measure/accuracy/accuracy.h"
#include "tools/measure/accuracy/reference.h"

/* Cells of what was measured. */
enum { KIND, METHOD, INSTRUCTIONS, TOLERANCE, STEPS, TIME, STATE };

/* The line before, for the order to which the error fell from it. */
typedef struct previous {
    const char *kind;
    const char *method;
    double error;
    double fine; /* step or tolerance */
} previous;

/* The order that was observed, in the step or, where steps vary, in the tolerance; `-` unless both errors are well above
 * what the reference is sure of. */
static void put_order(const previous *const last, const double error, const double fine, const double unsure)
{
    if (isfinite(error) && isfinite(last->error) && error > 10 * unsure) {
        printf("%.2f\t", log(last->error / error) / log(last->fine / fine));
    } else {
        printf("-\t");
    }
}

static void put_error(const double error)
{
    printf(isfinite(error) ? "%.3e\t" : "%g\t", error);
}

static void put_row(const reference *const r, const int line, const table *const points, const size_t row,
                    previous *const last)
{
    const char *const kind = table_text(points, row, KIND);
    const char *const method = table_text(points, row, METHOD);
    const double step = table_number(points, row, TIME) / table_number(points, row, STEPS);
    const double error = reference_error(r, line, points, row, STATE);
    const char *const tolerance = table_text(points, row, TOLERANCE);
    const double fine = strcmp(tolerance, "-") == 0 ? step : strtod(tolerance, NULL);
    if (last->kind == NULL || strcmp(last->kind, kind) != 0 || strcmp(last->method, method) != 0) {
        last->error = HUGE_VAL;
    }
    printf("%s\t%s\t%.9g\t%s\t", kind, method, step, table_text(points, row, STEPS));
    put_error(error);
    put_order(last, error, fine, table_number(&r->lines, (size_t)line, REFERENCE_UNSURE));
    printf("%s\t%.6g\t%s\n", table_text(points, row, INSTRUCTIONS), table_number(points, row, INSTRUCTIONS) / step,
           tolerance);
    *last = (previous){kind, method, error, fine};
}

int errors(const char *const reference_path, const char *const points_path)
{
    reference r = reference_read(reference_path);
    table points = table_read(points_path, ' ');
    previous last = {.error = HUGE_VAL};
    int status = EXIT_SUCCESS;
    puts("kind\tmethod\tstep_s\tsteps\terror\torder\tinstructions_per_step\tinstructions_per_second\ttolerance");
    for (size_t row = 0; row < points.rows && status == EXIT_SUCCESS; row++) {
        const int line = reference_at(&r, table_text(&points, row, TIME));
        if (line < 0 || table_cells(&points, row) != STATE + r.states) {
            fprintf(stderr, "accuracy: %s:%zu: no reference for %s %s after %s s\n", points_path, row + 1,
                    table_text(&points, row, KIND), table_text(&points, row, METHOD), table_text(&points, row, TIME));
            status = EXIT_FAILURE;
        } else {
            put_row(&r, line, &points, row, &last);
        }
    }
    table_free(&points);
    table_free(&r.lines);
    return status;
}
