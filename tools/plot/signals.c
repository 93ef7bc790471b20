#include "tools/plot/signals.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/plot/gnuplot.h"

const char *const colours[MEMBERS_MOST] = {"#0067a5", "#d1590a", "#3c8d2f", "#8c8c8c"};

static table read_file(const char *const directory, const char *const name, const char separator)
{
    const size_t bytes = strlen(directory) + strlen(name) + 2;
    char *const path = table_memory(bytes, 1);
    snprintf(path, bytes, "%s/%s", directory, name);
    const table read = table_read(path, separator);
    free(path);
    return read;
}

double signal_at(const signals *const s, const size_t row, const size_t column)
{
    return s->value[row * s->columns + column];
}

static void take_values(signals *const s)
{
    s->columns = table_cells(&s->rows, 0);
    s->count = s->rows.rows - 1;
    s->value = table_memory(s->count * s->columns, sizeof *s->value);
    s->least = table_memory(s->columns, sizeof *s->least);
    s->most = table_memory(s->columns, sizeof *s->most);
    for (size_t column = 0; column < s->columns; column++) {
        s->least[column] = HUGE_VAL;
        s->most[column] = -HUGE_VAL;
        for (size_t row = 0; row < s->count; row++) {
            const double value = table_number(&s->rows, row + 1, column);
            s->value[row * s->columns + column] = value;
            s->least[column] = fmin(s->least[column], value);
            s->most[column] = fmax(s->most[column], value);
        }
    }
}

/* The column of this name and ending, 0 if there is none. */
static size_t column_named(const signals *const s, const char *const stem, const size_t length,
                           const char *const ending)
{
    for (size_t column = 1; column < s->columns; column++) {
        const char *const name = table_text(&s->rows, 0, column);
        if (strncmp(name, stem, length) == 0 && strcmp(name + length, ending) == 0) {
            return column;
        }
    }
    return 0;
}

/* Whether the columns from this one on are the components of one vector: their names end with _ and these letters. */
static bool are_components(const signals *const s, const size_t column, const char *const letters)
{
    const char *const name = table_text(&s->rows, 0, column);
    const size_t length = strlen(name);
    for (size_t i = 0; letters[i] != '\0'; i++) {
        const char ending[] = {'_', letters[i], '\0'};
        if (length < 3 || column + i >= s->columns || column_named(s, name, length - 2, ending) != column + i) {
            return false;
        }
    }
    return true;
}

/* How many columns from this one on share a panel. */
static size_t members_from(const signals *const s, const size_t column)
{
    return are_components(s, column, "wxyz") ? QUATERNION : are_components(s, column, "xyz") ? VECTOR : 1;
}

static void find_groups(signals *const s)
{
    s->groups = table_memory(s->columns, sizeof *s->groups);
    size_t column = 1;
    while (column < s->columns) {
        group *const g = &s->groups[s->group_count++];
        const char *const name = table_text(&s->rows, 0, column);
        g->members = members_from(s, column);
        snprintf(g->stem, sizeof g->stem, "%.*s", (int)(strlen(name) - (g->members > 1 ? 2 : 0)), name);
        g->unit = s->units.rows > 1 ? table_text(&s->units, 1, column) : "";
        for (size_t i = 0; i < g->members; i++) {
            g->column[i] = column++;
        }
    }
}

signals signals_read(const char *const directory)
{
    signals s = {
        .rows = read_file(directory, "trace.csv", ','),
        .units = read_file(directory, "units.csv", ','),
        .run = read_file(directory, "summary.txt", ' '),
    };
    if (s.rows.rows < 2) {
        fprintf(stderr, "plot: %s/trace.csv has no row\n", directory);
        exit(EXIT_FAILURE);
    }
    take_values(&s);
    find_groups(&s);
    return s;
}

void signals_choose(signals *const s, char *const *const names, const size_t count)
{
    group *const chosen = table_memory(count, sizeof *chosen);
    for (size_t i = 0; i < count; i++) {
        size_t at = 0;
        while (at < s->group_count && strcmp(s->groups[at].stem, names[i]) != 0) {
            at++;
        }
        if (at == s->group_count) {
            fprintf(stderr, "plot: no output is called '%s'\n", names[i]);
            exit(EXIT_FAILURE);
        }
        chosen[i] = s->groups[at];
    }
    free(s->groups);
    s->groups = chosen;
    s->group_count = count;
}

void signals_free(signals *const s)
{
    table_free(&s->rows);
    table_free(&s->units);
    table_free(&s->run);
    free(s->value);
    free(s->least);
    free(s->most);
    free(s->groups);
}

static const char *said(const signals *const s, const char *const word)
{
    for (size_t row = 0; row < s->run.rows; row++) {
        if (strcmp(table_text(&s->run, row, 0), word) == 0) {
            return table_text(&s->run, row, 1);
        }
    }
    return "";
}

void put_title(const signals *const s)
{
    char title[STEM_BYTES];
    snprintf(title, sizeof title, "%s: %s, step %.6g ms, %s", said(s, "scene"), said(s, "method"),
             1000 * strtod(said(s, "step"), NULL), said(s, "real"));
    gnuplot_text(title);
}

void put_label(const group *const g, const char *const before, const char *const name)
{
    const bool bare = g->unit[0] == '\0' || strcmp(g->unit, "1") == 0;
    char label[2 * STEM_BYTES];
    snprintf(label, sizeof label, "%s%s%s%s", before, name, bare ? "" : ", ", bare ? "" : g->unit);
    gnuplot_text(label);
}

static void put_point(const signals *const s, const size_t row, const size_t column, const double zero)
{
    printf("%s %.9g\n", table_text(&s->rows, row + 1, 0), signal_at(s, row, column) - zero);
}

void put_points(const signals *const s, const size_t column, const double zero, const size_t stretches)
{
    const size_t every = (s->count + stretches - 1) / stretches;
    for (size_t from = 0; from < s->count; from += every) {
        size_t least = from;
        size_t most = from;
        for (size_t row = from; row < s->count && row < from + every; row++) {
            least = signal_at(s, row, column) < signal_at(s, least, column) ? row : least;
            most = signal_at(s, row, column) > signal_at(s, most, column) ? row : most;
        }
        put_point(s, least < most ? least : most, column, zero);
        if (least != most) {
            put_point(s, least < most ? most : least, column, zero);
        }
    }
}

void put_column(const signals *const s, const size_t column, const double zero, const size_t stretches)
{
    printf("$column%zu << END\n", column);
    put_points(s, column, zero, stretches);
    puts("END");
}
