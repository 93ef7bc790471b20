#include "tests/tools/lab/picture/svg.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/tools/lab/picture/file.h"

bool same(const double a, const double b)
{
    return fabs(a - b) <= 2 * RESOLUTION;
}

/* The value of an attribute of the element that begins here, NULL if it has none. */
static const char *attribute(const char *const element, const char *const name)
{
    const char *const end = strchr(element, '>');
    const char *const at = strstr(element, name);
    return at != NULL && at < end ? at + strlen(name) : NULL;
}

static void read_colour(const char *const element, const char *const name, char colour[8])
{
    const char *const value = attribute(element, name);
    snprintf(colour, 8, "%s", value == NULL ? "" : value);
}

static shape *add_shape(drawing *const d, const int mark)
{
    shape *const next = &d->shapes[one_more(&d->shape_count, ITEMS_MOST, "too many shapes")];
    *next = (shape){.mark = mark, .first = d->place_count};
    return next;
}

/* Adds a place to the last shape. */
static void add_place(drawing *const d, const place at)
{
    d->places[one_more(&d->place_count, PLACES_MOST, "too many points")] = at;
    d->shapes[d->shape_count - 1].places++;
}

/* Every part of a path that begins anew is a shape. */
static void read_path(drawing *const d, const char *const element)
{
    const char *at = attribute(element, " d='");
    const char *const end = at == NULL ? NULL : strchr(at, '\'');
    if (attribute(element, " id=") != NULL || end == NULL) {
        return;
    }
    while (at < end) {
        place next = {0, 0};
        if ((*at == 'M' || *at == 'L') && sscanf(at + 1, "%lf,%lf", &next.x, &next.y) == 2) {
            if (*at == 'M') {
                read_colour(element, "stroke='", add_shape(d, -1)->colour);
            }
            add_place(d, next);
        }
        at++;
    }
}

static void read_mark(drawing *const d, const char *const element)
{
    const char *const number = attribute(element, "#gpPt");
    const char *const position = attribute(element, "translate(");
    place at = {0, 0};
    if (number == NULL || position == NULL || sscanf(position, "%lf,%lf", &at.x, &at.y) != 2) {
        return;
    }
    read_colour(element, " color='", add_shape(d, atoi(number))->colour);
    add_place(d, at);
}

/* Where the texts that follow stand. */
static void read_group(const char *const element, words *const next)
{
    const char *const at = attribute(element, "translate(");
    const char *const anchor = attribute(element, "text-anchor=\"");
    const char *const size = attribute(element, "font-size=\"");
    if (at != NULL && sscanf(at, "%lf,%lf", &next->at.x, &next->at.y) == 2) {
        next->anchor = anchor == NULL ? 's' : *anchor;
        next->size = size == NULL ? 11 : atof(size);
        next->upright = attribute(element, "rotate(") != NULL;
    }
}

/* A text without its elements; what is raised has a ^ before it. */
static const words *read_text(drawing *const d, const char *const element, const words *const next)
{
    words *const read = &d->texts[one_more(&d->text_count, ITEMS_MOST, "too many texts")];
    const char *const end = strstr(element, "</text>");
    size_t length = 0;
    *read = *next;
    for (const char *at = element; at < end && length < NAME_BYTES - 2; at++) {
        if (*at == '<') {
            if (attribute(at, "dy=\"-") != NULL) {
                read->text[length++] = '^';
            }
            at = strchr(at, '>');
        } else {
            read->text[length++] = *at;
        }
    }
    read->text[length] = '\0';
    return read;
}

/* The last tic among the shapes from this one on, NULL if there is none: a line of two places in the colour of the
 * axes. */
static const shape *last_tic(const drawing *const d, const size_t from)
{
    const shape *tic = NULL;
    for (const shape *path = &d->shapes[from]; path < &d->shapes[d->shape_count]; path++) {
        tic = strcmp(path->colour, AXIS_COLOUR) == 0 && path->places == 2 ? path : tic;
    }
    return tic;
}

static void add_label(drawing *const d, const shape *const tic, const words *const text)
{
    const place *const end = &d->places[tic->first];
    d->labels[one_more(&d->label_count, ITEMS_MOST, "too many labels")] =
        (label){.tic = end[0], .of_x = same(end[0].x, end[1].x), .text = text};
}

void read_drawing(drawing *const d, const char *const svg)
{
    words next = {.size = 11, .anchor = 's'};
    const shape *tic = NULL;
    const char *const size = strstr(svg, "viewBox=\"0 0 ");
    if (size == NULL || sscanf(size, "viewBox=\"0 0 %lf %lf", &d->width, &d->height) != 2) {
        fail("this is no drawing");
    }
    for (const char *at = strchr(svg, '<'); at != NULL; at = strchr(at + 1, '<')) {
        if (strncmp(at, "<path ", 6) == 0) {
            const size_t before = d->shape_count;
            read_path(d, at);
            tic = last_tic(d, before);
        } else if (strncmp(at, "<use ", 5) == 0) {
            read_mark(d, at);
        } else if (strncmp(at, "<g ", 3) == 0) {
            read_group(at, &next);
        } else if (strncmp(at, "<text>", 6) == 0) {
            const words *const text = read_text(d, at, &next);
            if (tic != NULL) {
                add_label(d, tic, text);
                tic = NULL;
            }
        }
    }
}
