#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/measure/accuracy/accuracy.h"
#include "tools/table/table.h"

/* Cells of what was measured, and of the table of methods: | method | order | evaluations | Jacobians | ... */
enum { METHOD, DOUBLE_STEP_ERROR, STEP_ERROR, STEPS, TOLERANCE, INSTRUCTIONS, EVALUATIONS };
enum { NAME = 1, ORDER, STAGES, JACOBIANS, NAMED_CELLS };

typedef struct measurements {
    table methods;
    table rows;
    double time; /* s */
} measurements;

static void trim(char *const cell)
{
    const size_t blanks = strspn(cell, " ");
    memmove(cell, cell + blanks, strlen(cell + blanks) + 1);
    for (size_t n = strlen(cell); n > 0 && cell[n - 1] == ' '; n--) {
        cell[n - 1] = '\0';
    }
}

/* The text of a method in the table of methods; "" if there is none. */
static const char *of_method(const table *const methods, const char *const method, const size_t cell)
{
    for (size_t row = 0; row < methods->rows; row++) {
        if (table_cells(methods, row) > NAMED_CELLS && strcmp(table_text(methods, row, NAME), method) == 0) {
            return table_text(methods, row, cell);
        }
    }
    return "";
}

/* The longest step with the error, in s; 0 if none is known. */
static double longest(const measurements *const m, const size_t row)
{
    const double steps = table_number(&m->rows, row, STEPS);
    return steps > 0 ? m->time / steps : 0;
}

/* Instructions of a second of the plant's time with that step. */
static double cost(const measurements *const m, const size_t row)
{
    return table_number(&m->rows, row, INSTRUCTIONS) / longest(m, row);
}

static void put_error(const table *const rows, const size_t row, const size_t cell)
{
    if (strcmp(table_text(rows, row, cell), "-") == 0) {
        printf("- | ");
    } else {
        printf("%.2e | ", table_number(rows, row, cell));
    }
}

static void put_row(const measurements *const m, const size_t row)
{
    const char *const method = table_text(&m->rows, row, METHOD);
    printf("| %s | %s | ", method, of_method(&m->methods, method, ORDER));
    if (table_cells(&m->rows, row) > EVALUATIONS) {
        printf("%s | ", table_text(&m->rows, row, EVALUATIONS));
    } else {
        printf("%s%s | ", of_method(&m->methods, method, STAGES),
               strtod(of_method(&m->methods, method, JACOBIANS), NULL) > 0 ? " and a Jacobian" : "");
    }
    put_error(&m->rows, row, DOUBLE_STEP_ERROR);
    put_error(&m->rows, row, STEP_ERROR);
    if (longest(m, row) > 0) {
        printf("%.3g | %.0f | %.0f |\n", 1000 * longest(m, row), table_number(&m->rows, row, INSTRUCTIONS),
               cost(m, row));
    } else {
        printf("below 0.001 | %.0f | - |\n", table_number(&m->rows, row, INSTRUCTIONS));
    }
}

/* The line of a method; -1 if it was not measured. */
static int row_of(const measurements *const m, const char *const method)
{
    for (size_t row = 0; row < m->rows.rows; row++) {
        if (strcmp(table_text(&m->rows, row, METHOD), method) == 0) {
            return (int)row;
        }
    }
    return -1;
}

static void answer(const char *const subject, const double ratio, const char *const question, const bool yes)
{
    printf("- %s %.2f %s: %s.\n", subject, ratio, question, yes ? "yes" : "no");
}

/* Two methods at equal error, by the instructions of a second. */
static const struct {
    const char *method;
    const char *other;
    const char *subject;
    const char *question;
} pairs[] = {
    {"abm4", "ab4", "abm4 needs", "times the instructions of ab4 at equal error. Fewer"},
    {"abm4_pec", "abm4", "abm4_pec, without the last evaluation, needs", "times those of abm4. Fewer"},
    {"abm4_pecece", "abm4", "abm4_pecece, with a second correction, needs", "times those of abm4. Fewer"},
    {"ab4", "rk4", "ab4, with one evaluation instead of four, needs", "times the instructions of rk4. Fewer"},
    {"adams", "abm4", "adams, which varies step and order, needs", "times those of abm4. Fewer"},
};

/* Whether both have a step with the error; then where they stand. */
static bool both(const measurements *const m, const char *const a, const char *const b, size_t rows[2])
{
    const int first = row_of(m, a);
    const int second = row_of(m, b);
    if (first < 0 || second < 0) {
        return false;
    }
    rows[0] = (size_t)first;
    rows[1] = (size_t)second;
    return longest(m, rows[0]) > 0 && longest(m, rows[1]) > 0;
}

static void put_answers(const measurements *const m)
{
    size_t rows[2];
    if (both(m, "abm4", "ab4", rows)) {
        const double ratio = longest(m, rows[0]) / longest(m, rows[1]);
        answer("abm4 (PECE) has", ratio, "times the step of ab4 at equal error. More than twice", ratio > 2);
    }
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        if (both(m, pairs[i].method, pairs[i].other, rows)) {
            const double ratio = cost(m, rows[0]) / cost(m, rows[1]);
            answer(pairs[i].subject, ratio, pairs[i].question, ratio < 1);
        }
    }
    const int stiff = row_of(m, "bdf4");
    const int plain = row_of(m, "rk4");
    if (stiff >= 0 && plain >= 0) {
        const double ratio =
            table_number(&m->rows, (size_t)stiff, INSTRUCTIONS) / table_number(&m->rows, (size_t)plain, INSTRUCTIONS);
        answer("A step of bdf4 has", ratio, "times the instructions of a step of rk4. At most three times", ratio <= 3);
    }
}

int bench(const char *const methods_path, const char *const measured_path, const char *const time,
          const char *const step, const char *const error)
{
    measurements m = {table_read(methods_path, '|'), table_read(measured_path, ' '), strtod(time, NULL)};
    for (size_t i = 0; i < m.methods.first[m.methods.rows]; i++) {
        trim(m.methods.cell[i]);
    }
    printf("| method | order | evaluations | error, %g ms | error, %g ms | step for %s, ms | instructions | per second "
           "for %s |\n|---|--:|--:|--:|--:|--:|--:|--:|\n",
           2000 * strtod(step, NULL), 1000 * strtod(step, NULL), error, error);
    size_t best = m.rows.rows;
    for (size_t row = 0; row < m.rows.rows; row++) {
        put_row(&m, row);
        if (longest(&m, row) > 0 && (best == m.rows.rows || cost(&m, row) < cost(&m, best))) {
            best = row;
        }
    }
    const bool any = best < m.rows.rows;
    if (any) {
        putchar('\n');
        put_answers(&m);
        printf("- The fewest instructions for an error of %s: %s.\n", error, table_text(&m.rows, best, METHOD));
    }
    table_free(&m.methods);
    table_free(&m.rows);
    return any ? EXIT_SUCCESS : EXIT_FAILURE;
}
