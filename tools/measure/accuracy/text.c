#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/measure/accuracy/accuracy.h"
#include "tools/table/table.h"

/* Columns of the table that errors.c writes. */
enum { KIND, METHOD, STEP, STEPS, ERROR, ORDER, PER_STEP, PER_SECOND, TOLERANCE };

enum { STEPS_MOST = 64 };

/* The steps that methods of a fixed step have, in seconds; a float's differs from a double's in its last digits only. */
typedef struct widths {
    double step[STEPS_MOST];
    size_t count;
} widths;

static bool is_step(const table *const rows, const size_t row, const double step)
{
    return fabs(table_number(rows, row, STEP) / step - 1) < 0.001;
}

static bool is_fixed(const table *const rows, const size_t row)
{
    return strcmp(table_text(rows, row, TOLERANCE), "-") == 0;
}

static bool same(const table *const rows, const size_t a, const size_t b, const size_t column)
{
    return strcmp(table_text(rows, a, column), table_text(rows, b, column)) == 0;
}

static widths find_widths(const table *const rows)
{
    widths w = {.count = 0};
    for (size_t row = 1; row < rows->rows; row++) {
        size_t i = 0;
        while (i < w.count && !is_step(rows, row, w.step[i])) {
            i++;
        }
        if (is_fixed(rows, row) && i == w.count && i < STEPS_MOST) {
            w.step[w.count++] = table_number(rows, row, STEP);
        }
    }
    return w;
}

static void put_head(const widths *const w, const char *const first)
{
    printf("  %-14s %8s", "", first);
    for (size_t i = 0; i < w->count; i++) {
        char label[32];
        snprintf(label, sizeof label, "%.4g ms", w->step[i] * 1000);
        printf(" %15s", label);
    }
    putchar('\n');
}

static const char *short_error(const table *const rows, const size_t row, char said[16])
{
    snprintf(said, 16, isfinite(table_number(rows, row, ERROR)) ? "%.1e" : "%g", table_number(rows, row, ERROR));
    return said;
}

/* The text of a point: in the table over instructions, or in that over the step. */
static void put_cell(const table *const rows, const size_t row, const bool over_cost)
{
    char said[16];
    char cell[64];
    if (over_cost) {
        snprintf(cell, sizeof cell, "%.4g %7s", table_number(rows, row, PER_SECOND) / 1e6,
                 short_error(rows, row, said));
    } else {
        snprintf(cell, sizeof cell, "%9s %5s", table_text(rows, row, ERROR), table_text(rows, row, ORDER));
    }
    printf(" %15s", cell);
}

/* The first line of a method in a kind begins its row. */
static bool begins_row(const table *const rows, const size_t row)
{
    for (size_t before = 1; before < row; before++) {
        if (same(rows, row, before, KIND) && same(rows, row, before, METHOD)) {
            return false;
        }
    }
    return is_fixed(rows, row);
}

static void put_row(const table *const rows, const size_t first, const widths *const w, const bool over_cost)
{
    printf("  %-14s %8s", table_text(rows, first, METHOD), over_cost ? table_text(rows, first, PER_STEP) : "");
    for (size_t i = 0; i < w->count; i++) {
        size_t row = first;
        while (row < rows->rows &&
               !(same(rows, row, first, KIND) && same(rows, row, first, METHOD) && is_step(rows, row, w->step[i]))) {
            row++;
        }
        if (row < rows->rows) {
            put_cell(rows, row, over_cost);
        } else {
            printf(" %15s", "-");
        }
    }
    putchar('\n');
}

static const char *title_of(const char *const kind)
{
    return strcmp(kind, "float") == 0         ? "float, instructions of the Cortex-M4F"
           : strcmp(kind, "held") == 0        ? "held inputs, double, instructions of this machine"
           : strcmp(kind, "smooth") == 0      ? "smooth inputs, double, instructions of this machine"
           : strcmp(kind, "compensated") == 0 ? "float with compensated sums, instructions of the Cortex-M4F"
                                              : "double, instructions of this machine";
}

/* A table for each kind. */
static void put_tables(const table *const rows, const widths *const w, const bool over_cost)
{
    size_t last = 0;
    for (size_t row = 1; row < rows->rows; row++) {
        if (begins_row(rows, row)) {
            if (last == 0 || !same(rows, row, last, KIND)) {
                const char *const kind = table_text(rows, row, KIND);
                printf("\n%s\n", over_cost ? title_of(kind) : kind);
                put_head(w, over_cost ? "a step" : "");
            }
            put_row(rows, row, w, over_cost);
            last = row;
        }
    }
}

/* The lines of a method whose steps vary, of which the means are told. */
static void put_varied(const table *const rows, const bool first)
{
    bool any = false;
    for (size_t row = 1; row < rows->rows; row++) {
        if (!is_fixed(rows, row)) {
            char step[32];
            char said[16];
            if (!any) {
                printf(
                    "%sadams, whose steps vary: their mean, the instructions of one, millions of them in a second of\n"
                    "the plant's time, the error, and its order in the tolerance\n\n",
                    first ? "" : "\n");
                printf("  %-14s %9s %12s %12s %12s %9s %6s\n", "", "tolerance", "a step", "instructions", "millions",
                       "error", "order");
                any = true;
            }
            snprintf(step, sizeof step, "%.4g ms", table_number(rows, row, STEP) * 1000);
            printf("  %-14s %9s %12s %12s %12.4g %9s %6s\n", table_text(rows, row, KIND),
                   table_text(rows, row, TOLERANCE), step, table_text(rows, row, PER_STEP),
                   table_number(rows, row, PER_SECOND) / 1e6, short_error(rows, row, said),
                   table_text(rows, row, ORDER));
        }
    }
}

int text(const char *const table_path)
{
    table rows = table_read(table_path, '\t');
    const widths w = find_widths(&rows);
    if (w.count > 0) {
        puts("Error over instructions: the instructions of a step, then at each step millions of them in a second of "
             "the\nplant's time and the error");
        put_tables(&rows, &w, true);
        puts("\nError over the step, with the order observed from the step before");
        put_tables(&rows, &w, false);
    }
    put_varied(&rows, w.count == 0);
    table_free(&rows);
    return EXIT_SUCCESS;
}
