#include "tools/plot/measured.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* An error beyond this means nothing, and is not drawn. */
#define ERROR_MOST 100

double cost_of(const measured *const m, const size_t row)
{
    return table_number(&m->rows, row, PER_SECOND);
}

static double error_of(const measured *const m, const size_t row)
{
    return table_number(&m->rows, row, ERROR);
}

double step_ms(const measured *const m, const size_t row)
{
    return table_number(&m->rows, row, STEP) * 1000;
}

bool is_drawn(const measured *const m, const size_t row, const char *const kind, const char *const method)
{
    return error_of(m, row) > 0 && error_of(m, row) <= ERROR_MOST &&
           (kind == NULL || strcmp(table_text(&m->rows, row, KIND), kind) == 0) &&
           (method == NULL || strcmp(table_text(&m->rows, row, METHOD), method) == 0);
}

bool has_points(const measured *const m, const char *const kind, const char *const method)
{
    for (size_t row = 1; row < m->rows.rows; row++) {
        if (is_drawn(m, row, kind, method)) {
            return true;
        }
    }
    return false;
}

double longest_fixed_step(const measured *const m)
{
    double longest = 0;
    for (size_t row = 1; row < m->rows.rows; row++) {
        const bool fixed = strcmp(table_text(&m->rows, row, TOLERANCE), "-") == 0;
        if (fixed && is_drawn(m, row, NULL, NULL)) {
            longest = fmax(longest, step_ms(m, row));
        }
    }
    return longest;
}

/* Adds the method unless it is there. */
static void add_method(measured *const m, const char *const name)
{
    for (size_t i = 0; i < m->count; i++) {
        if (strcmp(m->methods[i].method, name) == 0) {
            return;
        }
    }
    if (m->count == LOOKS_MOST) {
        fprintf(stderr, "%s: more than %d methods\n", m->rows.path, (int)LOOKS_MOST);
        exit(EXIT_FAILURE);
    }
    m->methods[m->count] = look_of(name, m->count);
    m->count++;
}

static void extend(double range[2], const double value)
{
    range[0] = fmin(range[0], value);
    range[1] = fmax(range[1], value);
}

measured read_measured(const char *const path)
{
    measured m = {.rows = table_read(path, '\t'), .error = {HUGE_VAL, 0}, .cost = {HUGE_VAL, 0}, .step = {HUGE_VAL, 0}};
    for (size_t row = 1; row < m.rows.rows; row++) {
        add_method(&m, table_text(&m.rows, row, METHOD));
        if (is_drawn(&m, row, NULL, NULL)) {
            extend(m.error, error_of(&m, row));
            extend(m.cost, cost_of(&m, row));
            extend(m.step, step_ms(&m, row));
        }
    }
    return m;
}

/* --- The Pareto front --- */

static bool better(const measured *const m, const size_t a, const size_t b)
{
    const double cost = cost_of(m, a) - cost_of(m, b);
    const double error = error_of(m, a) - error_of(m, b);
    return cost <= 0 && error <= 0 && (cost < 0 || error < 0);
}

static bool on_front(const measured *const m, const char *const kind, const size_t row)
{
    for (size_t other = 1; other < m->rows.rows; other++) {
        if (is_drawn(m, other, kind, NULL) && better(m, other, row)) {
            return false;
        }
    }
    return is_drawn(m, row, kind, NULL);
}

size_t next_on_front(const measured *const m, const char *const kind, const double cost)
{
    size_t next = 0;
    for (size_t row = 1; row < m->rows.rows; row++) {
        const double its = cost_of(m, row);
        if (its > cost && on_front(m, kind, row) && (next == 0 || its < cost_of(m, next))) {
            next = row;
        }
    }
    return next;
}
