#include "tests/tools/lab/picture/compare.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/tools/lab/picture/file.h"

/* --- What is expected --- */

/* The next field of a line, up to a tab or the end. */
static char *field(char **const line)
{
    char *const start = *line;
    char *const end = start + strcspn(start, "\t");
    *line = *end == '\0' ? end : end + 1;
    *end = '\0';
    return start;
}

bool read_expected(points *const expected, const panels *const of, char *const text)
{
    char *line = text;
    size_t lines = 1;
    for (const char *c = text; *c != '\0'; c++) {
        lines += *c == '\n';
    }
    *expected = (points){.all = memory_of(lines, sizeof *expected->all)};
    while (*line != '\0') {
        char *const end = line + strcspn(line, "\n");
        char *const next = *end == '\0' ? end : end + 1;
        *end = '\0';
        const char *const name = field(&line);
        const int its = panel_named(of, name);
        if (its < 0) {
            printf("no panel: %s\n", name);
            return false;
        }
        point *const p = &expected->all[expected->count++];
        p->panel = &of->all[its];
        p->curve = field(&line);
        p->x = strtod(field(&line), NULL);
        p->y = strtod(field(&line), NULL);
        double tolerance = 0;
        p->at = (place){pixel_of(&p->panel->x, p->x, &tolerance), pixel_of(&p->panel->y, p->y, &tolerance)};
        line = next;
    }
    return true;
}

/* --- Points by the pixel of their abscissa, so that each is compared with its neighbours alone --- */

enum { COLUMNS = 4096 };

typedef struct sorted {
    const point *points;
    size_t head[COLUMNS]; /* the number of a point plus one; 0 for none */
    size_t *next;
} sorted;

static size_t column_of(const double x)
{
    return (size_t)fmin(fmax(x, 0), COLUMNS - 1);
}

/* To be freed: `next`. */
static sorted sort_points(const points *const these)
{
    sorted by_column = {.points = these->all, .next = memory_of(these->count + 1, sizeof *by_column.next)};
    for (size_t i = 0; i < these->count; i++) {
        size_t *const head = &by_column.head[column_of(these->all[i].at.x)];
        by_column.next[i] = *head;
        *head = i + 1;
    }
    return by_column;
}

/* --- The comparison --- */

/* Whether the point that is expected is where the other one is drawn. */
static bool meets(const point *const e, const point *const d)
{
    double x_off = 0;
    double y_off = 0;
    if (e->panel != d->panel || fabs(e->at.x - d->at.x) > 1 || fabs(e->at.y - d->at.y) > 1) {
        return false;
    }
    (void)pixel_of(&e->panel->x, e->x, &x_off);
    (void)pixel_of(&e->panel->y, e->y, &y_off);
    return fabs(e->at.x - d->at.x) <= x_off && fabs(e->at.y - d->at.y) <= y_off && strcmp(e->curve, d->curve) == 0;
}

/* Whether a point is met by one of the others. */
static bool met(const point *const p, const bool of_drawing, const sorted *const others)
{
    const size_t column = column_of(p->at.x);
    for (size_t c = column == 0 ? 0 : column - 1; c <= column + 1 && c < COLUMNS; c++) {
        for (size_t i = others->head[c]; i > 0; i = others->next[i - 1]) {
            const point *const other = &others->points[i - 1];
            if (of_drawing ? meets(other, p) : meets(p, other)) {
                return true;
            }
        }
    }
    return false;
}

bool all_expected(const points *const drawn, const points *const expected)
{
    const sorted others = sort_points(expected);
    bool right = true;
    for (size_t i = 0; i < drawn->count; i++) {
        const point *const d = &drawn->all[i];
        if (!met(d, true, &others)) {
            printf("drawn, but it is not so: %s|%s, %s: %.6g %.6g\n", d->panel->title, d->panel->abscissa, d->curve,
                   value_of(&d->panel->x, d->at.x), value_of(&d->panel->y, d->at.y));
            right = false;
        }
    }
    free(others.next);
    return right;
}

bool all_drawn(const points *const expected, const points *const drawn)
{
    const sorted others = sort_points(drawn);
    bool right = true;
    for (size_t i = 0; i < expected->count; i++) {
        const point *const e = &expected->all[i];
        if (!met(e, false, &others)) {
            printf("not drawn: %s|%s, %s: %.6g %.6g\n", e->panel->title, e->panel->abscissa, e->curve, e->x, e->y);
            right = false;
        }
    }
    free(others.next);
    return right;
}
