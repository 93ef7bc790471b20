#include "tools/isoc/formula/ticks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tools/isoc/base/numbers.h"
#include "tools/isoc/formula/scalar.h"

enum { MOST_POINTS = 65535, SHOWN = 40 };

static const char digits[] = "0123456789+-."; /* the first character of a number */
static const char ends[] = ",;\n\r";          /* of a field, as the end of the text */

/* The points of a file. */
typedef struct point {
    double tick, value;
} point;

typedef LIST_OF(point) points;

static const char *skip_blanks(const char *c)
{
    return c + strspn(c, " \t");
}

/* A field that is a decimal number and nothing else. */
static bool number_of_field(const char *from, double *number)
{
    char *end;
    const char *c = skip_blanks(from);
    if (strchr(digits, *c) == NULL || *c == '\0' || (c[0] == '0' && (c[1] | 32) == 'x')) {
        return false;
    }
    *number = strtod(c, &end);
    return end > c && strchr(ends, *skip_blanks(end)) != NULL && isfinite(*number);
}

/* The field of this number, from 1 on; NULL where the line has none. */
static const char *field_of(const char *line, int number)
{
    for (; number > 1; number--) {
        line += strcspn(line, ends);
        if (*line != ',' && *line != ';') {
            return NULL;
        }
        line++;
    }
    return line;
}

/* Returns false. */
static bool refuse_field(values *v, const formula *f, const char *field, const char *what)
{
    const char *c = skip_blanks(field);
    size_t length = strcspn(c, ends);
    length = length < SHOWN ? length : SHOWN;
    return source_problem(v->s, f->text_at + (size_t)(c - f->file->text), "expected a number, %s; found '%.*s'", what,
                          (int)length, c);
}

/* Adds the point of a line; false after noting a problem. */
static bool add_point(values *v, const formula *f, points *all, const char *line)
{
    double time, number;
    const char *field = field_of(line, (int)f->number);
    const place at = f->text_at + (size_t)(skip_blanks(line) - f->file->text);
    if (!number_of_field(line, &time)) {
        return refuse_field(v, f, line, "the time in s");
    }
    if (field == NULL) {
        return source_problem(v->s, at, "this line has no column %.0f", f->number);
    }
    if (!number_of_field(field, &number)) {
        return refuse_field(v, f, field, "a value");
    }
    const double ticks = time / v->step;
    if (ticks < 0.0 || ticks > most_ticks || (all->count > 0 && !(ticks > all->all[all->count - 1].tick))) {
        return source_problem(v->s, at, "the times of a file increase, from 0 or later to %g s at most with this step",
                              most_ticks * v->step);
    }
    if (!real_holds(number, v->is_double)) {
        return source_problem(v->s, f->text_at + (size_t)(skip_blanks(field) - f->file->text), "the value is %g; %s",
                              number, real_advice(number, v->is_double));
    }
    if (all->count == MOST_POINTS) {
        return source_problem(v->s, at, "more than %d points", MOST_POINTS);
    }
    LIST_ADD(v->s->memory, *all, ((point){ticks, number}));
    return true;
}

/* Every line has a point, but for empty ones, comments, and a first one of names. */
static bool read_points(values *v, const formula *f, points *all)
{
    bool is_first = true;
    for (const char *line = f->file->text; *line != '\0';) {
        const char *begins = skip_blanks(line);
        const bool is_empty = *begins == '#' || *begins == '\n' || *begins == '\r' || *begins == '\0';
        const bool is_heading = is_first && strchr(digits, *begins) == NULL;
        if (!is_empty && !is_heading && !add_point(v, f, all, line)) {
            return false;
        }
        is_first = is_first && is_empty;
        line += strcspn(line, "\n");
        line += *line == '\n';
    }
    return all->count > 0 ||
           source_problem(v->s, f->at, "'%s' has no points: lines of time and value, with a comma between",
                          f->file->path);
}

static void add_line(tick_table *to, double first, double x, double slope)
{
    to->words[to->count] = (uint32_t)first;
    to->values[to->count] = x;
    to->slopes[to->count++] = slope;
}

/* Each line from the first tick that is not before its beginning, unless the next begins by then. */
static void lines_of_points(values *v, const points *all, tick_table *to)
{
    to->words = arena_take(v->s->memory, all->count + 1, sizeof *to->words);
    to->values = arena_take(v->s->memory, all->count + 1, sizeof *to->values);
    to->slopes = arena_take(v->s->memory, all->count + 1, sizeof *to->slopes);
    const point *last = &all->all[all->count - 1];
    if (first_tick_of(all->all[0].tick) > 0.0) {
        add_line(to, 0.0, all->all[0].value, 0.0);
    }
    for (const point *p = all->all; p < last; p++) {
        const double slope = (p[1].value - p->value) / (p[1].tick - p->tick), begins = first_tick_of(p->tick);
        const double late = is_whole_tick(p->tick) ? 0.0 : begins - p->tick;
        if (first_tick_of(p[1].tick) > begins) {
            add_line(to, begins, p->value + slope * late, slope);
        }
    }
    add_line(to, first_tick_of(last->tick), last->value, 0.0);
}

value file_of_formula(values *v, const formula *f, const value *arguments)
{
    points all = {0};
    (void)arguments;
    if (!read_points(v, f, &all)) {
        return nothing;
    }
    node root;
    lines_of_points(v, &all, table_new(v, OP_LINES, 0.0, 0.0, &root));
    return value_with_table(v, f, root);
}
