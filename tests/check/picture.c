/* Reads a picture back as its reader does: every point through the labels of its axes, every curve by the legend.
 *
 *     picture FILE.svg                  prints each point: panel, curve, abscissa, ordinate, separated by tabs
 *     picture FILE.svg POINTS all       every point of POINTS (lines like those) is drawn, and every drawn one is there
 *     picture FILE.svg POINTS drawn     every drawn point is in POINTS, which may have more
 *     picture FILE.svg POINTS covered   every point of POINTS is drawn, and there may be more
 *
 * A panel is named TITLE|LABEL OF THE ABSCISSA; a curve that no legend names has an empty name. Whatever it is asked, no
 * text may leave the picture or lie on another one. Status 1, with a line for each thing that is wrong.
 *
 * Coordinates have two decimals, so that a point and the two labels that it is measured by are each at most RESOLUTION
 * off; with s the place of the point between the two, 0 and 1, that is RESOLUTION (1 + |s| + |1 - s|) in all.
 *
 * Input: what build/plot compact writes of gnuplot's drawing, with the axes of tools/plot/gnuplot.h.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define RESOLUTION 0.01
#define SLACK 0.2
#define AXIS_COLOUR "#555555"
#define GRID_COLOUR "#d4d4d4"
#define ROW 6.0    /* a legend's sample and its name are at most so far apart in height */
#define ABOVE 40.0 /* a panel's title and its own legend are at most so far above it */

enum { NAME_BYTES = 160, PLACES_MOST = 200000, ITEMS_MOST = 4000, PANELS_MOST = 64, LABELS_MOST = 16 };

typedef struct place {
    double x, y;
} place;

typedef struct words {
    place at;
    double size;
    char anchor; /* s, m or e: which end of it is there */
    bool upright;
    char text[NAME_BYTES];
} words;

/* A path, or a mark: then `mark` is its number and it has one place. */
typedef struct shape {
    char colour[8];
    int mark; /* -1 for a path */
    size_t first, places;
} shape;

typedef struct axis {
    size_t labels;
    double pixel[LABELS_MOST];
    double value[LABELS_MOST];
    bool powers; /* a label has a power of ten */
    bool logarithmic;
} axis;

typedef struct panel {
    double left, right, top, bottom;
    axis x, y;
    const char *title, *abscissa;
} panel;

typedef struct point {
    size_t panel;
    const char *curve;
    double x, y; /* of POINTS: the values */
    place at;    /* of the drawing */
} point;

static place places[PLACES_MOST];
static size_t place_count;
static words texts[ITEMS_MOST];
static size_t text_count;
static shape shapes[ITEMS_MOST];
static size_t shape_count;
static panel panels[PANELS_MOST];
static size_t panel_count;
static double width, height;
static int wrong;

_Noreturn static void fail(const char *const what)
{
    fprintf(stderr, "picture: %s\n", what);
    exit(EXIT_FAILURE);
}

static size_t one_more(size_t *const count, const size_t most, const char *const what)
{
    if (*count == most) {
        fail(what);
    }
    return (*count)++;
}

static char *read_all(const char *const path)
{
    FILE *const file = fopen(path, "r");
    if (file == NULL) {
        fail(path);
    }
    size_t room = 1 << 20;
    size_t used = 0;
    char *text = malloc(room);
    if (text == NULL) {
        fail("no memory");
    }
    for (;;) {
        used += fread(text + used, 1, room - 1 - used, file);
        if (used < room - 1) {
            break;
        }
        room *= 2;
        char *const larger = realloc(text, room);
        if (larger == NULL) {
            fail("no memory");
        }
        text = larger;
    }
    fclose(file);
    text[used] = '\0';
    return text;
}

/* --- The drawing --- */

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

/* Every part of a path that begins anew is a shape. */
static void read_path(const char *const element)
{
    const char *at = attribute(element, " d='");
    const char *const end = at == NULL ? NULL : strchr(at, '\'');
    if (attribute(element, " id=") != NULL || end == NULL) {
        return;
    }
    char colour[8];
    read_colour(element, "stroke='", colour);
    while (at < end) {
        double x = 0;
        double y = 0;
        if ((*at == 'M' || *at == 'L') && sscanf(at + 1, "%lf,%lf", &x, &y) == 2) {
            if (*at == 'M') {
                shape *const next = &shapes[one_more(&shape_count, ITEMS_MOST, "too many shapes")];
                *next = (shape){.mark = -1, .first = place_count};
                memcpy(next->colour, colour, sizeof colour);
            }
            places[one_more(&place_count, PLACES_MOST, "too many points")] = (place){x, y};
            shapes[shape_count - 1].places++;
        }
        at++;
    }
}

static void read_mark(const char *const element)
{
    const char *const number = attribute(element, "#gpPt");
    const char *const at = attribute(element, "translate(");
    double x = 0;
    double y = 0;
    if (number == NULL || at == NULL || sscanf(at, "%lf,%lf", &x, &y) != 2) {
        return;
    }
    shape *const mark = &shapes[one_more(&shape_count, ITEMS_MOST, "too many shapes")];
    *mark = (shape){.mark = atoi(number), .first = place_count, .places = 1};
    read_colour(element, " color='", mark->colour);
    places[one_more(&place_count, PLACES_MOST, "too many points")] = (place){x, y};
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
static void read_text(const char *const element, const words *const next)
{
    words *const read = &texts[one_more(&text_count, ITEMS_MOST, "too many texts")];
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
}

static bool same(const double a, const double b)
{
    return fabs(a - b) <= 2 * RESOLUTION;
}

/* The panel with this edge, the axes' corner of an L. */
static void add_panel(const place *const corner)
{
    for (size_t i = 0; i < panel_count; i++) {
        if (same(panels[i].left, corner[0].x) && same(panels[i].top, corner[0].y)) {
            return;
        }
    }
    panels[one_more(&panel_count, PANELS_MOST, "too many panels")] =
        (panel){.left = corner[1].x, .right = corner[2].x, .top = corner[0].y, .bottom = corner[1].y};
}

/* A text that follows a tic is its label; the panel may not be known yet, so that labels wait. */
typedef struct label {
    place tic;
    bool of_x;
    const words *text;
} label;
static label labels[ITEMS_MOST];
static size_t label_count;

static void add_label(const shape *const tic)
{
    const place *const end = &places[tic->first];
    labels[one_more(&label_count, ITEMS_MOST, "too many labels")] =
        (label){.tic = end[0], .of_x = same(end[0].x, end[1].x), .text = &texts[text_count - 1]};
}

static void read_drawing(const char *const svg)
{
    words next = {.size = 11, .anchor = 's'};
    const shape *tic = NULL;
    const char *const size = strstr(svg, "viewBox=\"0 0 ");
    if (size == NULL || sscanf(size, "viewBox=\"0 0 %lf %lf", &width, &height) != 2) {
        fail("this is no drawing");
    }
    for (const char *at = strchr(svg, '<'); at != NULL; at = strchr(at + 1, '<')) {
        if (strncmp(at, "<path ", 6) == 0) {
            const size_t before = shape_count;
            read_path(at);
            tic = NULL;
            for (const shape *path = &shapes[before]; path < &shapes[shape_count]; path++) {
                const bool of_axis = strcmp(path->colour, AXIS_COLOUR) == 0;
                tic = of_axis && path->places == 2 ? path : tic;
                if (of_axis && path->places > 2) {
                    add_panel(&places[path->first]);
                }
            }
        } else if (strncmp(at, "<use ", 5) == 0) {
            read_mark(at);
        } else if (strncmp(at, "<g ", 3) == 0) {
            read_group(at, &next);
        } else if (strncmp(at, "<text>", 6) == 0) {
            read_text(at, &next);
            if (tic != NULL) {
                add_label(tic);
                tic = NULL;
            }
        }
    }
}

/* --- What stands where --- */

/* Gnuplot draws a tic that is next to nothing beyond the end of its axis: SLACK. */
static bool inside(const panel *const p, const place at)
{
    return at.x >= p->left - SLACK && at.x <= p->right + SLACK && at.y >= p->top - SLACK && at.y <= p->bottom + SLACK;
}

/* The panel at this place, -1 if there is none. */
static int panel_at(const place at)
{
    for (size_t i = 0; i < panel_count; i++) {
        if (inside(&panels[i], at)) {
            return (int)i;
        }
    }
    return -1;
}

/* The number that a label says: like 2, 5e-3 or 10^-3. */
static bool label_value(const char *const text, double *const value, bool *const power)
{
    char *end = NULL;
    *power = strncmp(text, "10^", 3) == 0;
    *value = *power ? pow(10, strtod(text + 3, &end)) : strtod(text, &end);
    return end != text && *end == '\0';
}

static void place_labels(void)
{
    for (size_t i = 0; i < label_count; i++) {
        const int of = panel_at(labels[i].tic);
        if (of < 0) {
            printf("a tic without a panel: %s\n", labels[i].text->text);
            wrong = 1;
            continue;
        }
        axis *const its = labels[i].of_x ? &panels[of].x : &panels[of].y;
        bool power = false;
        if (its->labels == LABELS_MOST || !label_value(labels[i].text->text, &its->value[its->labels], &power)) {
            printf("no label of an axis: %s\n", labels[i].text->text);
            wrong = 1;
            continue;
        }
        its->powers = its->powers || power;
        its->pixel[its->labels++] = labels[i].of_x ? labels[i].tic.x : labels[i].tic.y;
    }
}

static double scaled(const double value, const bool logarithmic)
{
    return logarithmic ? log(value) : value;
}

/* Where a value stands on an axis: between its first and its last label, or beyond. */
static double pixel_of(const axis *const a, const double value, double *const tolerance)
{
    const size_t last = a->labels - 1;
    const double from = scaled(a->value[0], a->logarithmic);
    const double to = scaled(a->value[last], a->logarithmic);
    const double s = (scaled(value, a->logarithmic) - from) / (to - from);
    *tolerance = RESOLUTION * (1 + fabs(s) + fabs(1 - s));
    return a->pixel[0] + s * (a->pixel[last] - a->pixel[0]);
}

static double value_of(const axis *const a, const double pixel)
{
    const size_t last = a->labels - 1;
    const double from = scaled(a->value[0], a->logarithmic);
    const double to = scaled(a->value[last], a->logarithmic);
    const double read = from + (to - from) * (pixel - a->pixel[0]) / (a->pixel[last] - a->pixel[0]);
    return a->logarithmic ? exp(read) : read;
}

/* How far the labels are from a linear or logarithmic axis, in pixels. */
static double misfit(axis *const a, const bool logarithmic)
{
    double most = 0;
    a->logarithmic = logarithmic;
    for (size_t i = 0; i < a->labels; i++) {
        double tolerance = 0;
        if (logarithmic && a->value[i] <= 0) {
            return HUGE_VAL;
        }
        most = fmax(most, fabs(pixel_of(a, a->value[i], &tolerance) - a->pixel[i]));
    }
    return most;
}

/* Finds how an axis goes. One without labels has those of a panel beside it: `from`. */
static void read_axis(axis *const a, const char *const panel_title, const char *const which)
{
    if (a->labels < 2) {
        printf("%s: the %s axis has no two labels\n", panel_title, which);
        wrong = 1;
        return;
    }
    const double linear = misfit(a, false);
    const double logarithmic = misfit(a, true);
    a->logarithmic = a->labels == 2 ? a->powers : logarithmic < linear;
    if ((a->logarithmic ? logarithmic : linear) > 3 * RESOLUTION) {
        printf("%s: the labels of the %s axis agree neither with a linear nor with a logarithmic one\n", panel_title,
               which);
        wrong = 1;
    }
}

/* The text that stands nearest to a place, with its anchor in a window around it. */
static const char *text_near(const place at, const char anchor, const double left, const double up, const double down)
{
    const words *best = NULL;
    for (size_t i = 0; i < text_count; i++) {
        const words *const w = &texts[i];
        const bool fits = w->anchor == anchor && !w->upright && fabs(w->at.x - at.x) <= left && w->at.y >= at.y - up &&
                          w->at.y <= at.y + down && w->text[0] != '\0';
        if (fits && (best == NULL || fabs(w->at.y - at.y) < fabs(best->at.y - at.y))) {
            best = w;
        }
    }
    return best == NULL ? "" : best->text;
}

/* The label of an abscissa stands below the numbers: of the texts in the middle below the panel the lowest. */
static const char *abscissa_of(const panel *const p)
{
    const words *lowest = NULL;
    for (size_t i = 0; i < text_count; i++) {
        const words *const w = &texts[i];
        const bool fits = w->anchor == 'm' && !w->upright && same(w->at.x, (p->left + p->right) / 2) &&
                          w->at.y > p->bottom && w->at.y < p->bottom + 60;
        if (fits && (lowest == NULL || w->at.y > lowest->at.y)) {
            lowest = w;
        }
    }
    return lowest == NULL ? "" : lowest->text;
}

static void read_panels(void)
{
    place_labels();
    for (size_t i = 0; i < panel_count; i++) {
        panel *const p = &panels[i];
        p->title = text_near((place){p->left, p->top}, 's', 1, ABOVE, 0);
        p->abscissa = abscissa_of(p);
    }
    /* An axis without labels is that of the panel below, or on the left. */
    for (size_t i = 0; i < panel_count; i++) {
        panel *const p = &panels[i];
        const panel *below = NULL;
        const panel *beside = NULL;
        for (size_t j = 0; j < panel_count; j++) {
            const panel *const q = &panels[j];
            if (same(q->left, p->left) && same(q->right, p->right) && q->top > p->bottom && q->x.labels > 0 &&
                (below == NULL || q->top < below->top)) {
                below = q;
            }
            if (same(q->top, p->top) && same(q->bottom, p->bottom) && q->right < p->left && q->y.labels > 0 &&
                (beside == NULL || q->left > beside->left)) {
                beside = q;
            }
        }
        if (p->x.labels == 0 && below != NULL) {
            p->x = below->x;
            p->abscissa = below->abscissa;
        }
        if (p->y.labels == 0 && beside != NULL) {
            p->y = beside->y;
        }
    }
    for (size_t i = 0; i < panel_count; i++) {
        read_axis(&panels[i].x, panels[i].title, "x");
        read_axis(&panels[i].y, panels[i].title, "y");
    }
}

/* --- Curves and their names --- */

/* Whether marks of this colour are in the picture: then its paths only join them. */
static bool has_marks(const char *const colour)
{
    for (size_t i = 0; i < shape_count; i++) {
        if (shapes[i].mark >= 0 && strcmp(shapes[i].colour, colour) == 0) {
            return true;
        }
    }
    return false;
}

static bool is_curve(const shape *const s)
{
    return strcmp(s->colour, AXIS_COLOUR) != 0 && strcmp(s->colour, GRID_COLOUR) != 0 &&
           (s->mark >= 0 || !has_marks(s->colour));
}

/* Whether a sample of a legend stands just above the panel, as one that is its own. */
static bool own_sample(const panel *const p, const place at)
{
    return at.x >= p->left && at.x <= p->right && at.y < p->top && at.y > p->top - ABOVE;
}

/* The text in the row of a sample that begins or ends nearest to it. */
static const char *sample_name(const shape *const sample)
{
    const place from = places[sample->first];
    const place to = places[sample->first + sample->places - 1];
    const words *best = NULL;
    double nearest = HUGE_VAL;
    for (size_t i = 0; i < text_count; i++) {
        const double away = texts[i].anchor == 'e' ? fabs(texts[i].at.x - from.x) : fabs(texts[i].at.x - to.x);
        if (fabs(texts[i].at.y - from.y) <= ROW && away < nearest) {
            nearest = away;
            best = &texts[i];
        }
    }
    return best == NULL ? "" : best->text;
}

/* The name of a curve: of a sample that looks like it in the panel's own legend, else in that of the picture. */
static const char *curve_name(const panel *const p, const shape *const s)
{
    const char *name = "";
    for (size_t i = 0; i < shape_count; i++) {
        const shape *const sample = &shapes[i];
        const place at = places[sample->first];
        if (sample->places > 0 && is_curve(sample) && panel_at(at) < 0 && sample->mark == s->mark &&
            strcmp(sample->colour, s->colour) == 0) {
            if (own_sample(p, at)) {
                return sample_name(sample);
            }
            bool of_another = false;
            for (size_t j = 0; j < panel_count; j++) {
                of_another = of_another || own_sample(&panels[j], at);
            }
            name = of_another ? name : sample_name(sample);
        }
    }
    return name;
}

static point drawn[PLACES_MOST];
static size_t drawn_count;

static void read_points(void)
{
    for (size_t i = 0; i < shape_count; i++) {
        const shape *const s = &shapes[i];
        const int of = s->places > 0 ? panel_at(places[s->first]) : -1;
        if (of < 0 || !is_curve(s)) {
            continue;
        }
        const char *const name = curve_name(&panels[of], s);
        for (size_t k = 0; k < s->places; k++) {
            drawn[drawn_count++] = (point){.panel = (size_t)of, .curve = name, .at = places[s->first + k]};
        }
    }
}

/* --- Texts --- */

typedef struct box {
    double left, right, top, bottom;
} box;

/* What a text covers, if its letters are so wide, in parts of its size. */
static box box_of(const words *const w, const double letter)
{
    const double length = letter * w->size * (double)strlen(w->text);
    const double before = w->anchor == 's' ? 0 : w->anchor == 'm' ? length / 2 : length;
    if (w->upright) {
        return (box){w->at.x - 0.75 * w->size, w->at.x + 0.25 * w->size, w->at.y - (length - before), w->at.y + before};
    }
    return (box){w->at.x - before, w->at.x + length - before, w->at.y - 0.75 * w->size, w->at.y + 0.25 * w->size};
}

/* No text leaves the picture, for letters that are rather wide; no two are on each other, for some that are rather
 * narrow. */
static void check_texts(void)
{
    for (size_t i = 0; i < text_count; i++) {
        const box wide = box_of(&texts[i], 0.6);
        if (wide.left < 0 || wide.right > width || wide.top < 0 || wide.bottom > height) {
            printf("cut off: %s\n", texts[i].text);
            wrong = 1;
        }
        for (size_t j = 0; j < i; j++) {
            const box a = box_of(&texts[i], 0.5);
            const box b = box_of(&texts[j], 0.5);
            if (a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom) {
                printf("on each other: %s, %s\n", texts[i].text, texts[j].text);
                wrong = 1;
            }
        }
    }
}

/* --- The comparison --- */

static point *expected;
static size_t expected_count;

/* The next field of a line, up to a tab or the end. */
static char *field(char **const line)
{
    char *const start = *line;
    char *const end = start + strcspn(start, "\t");
    *line = *end == '\0' ? end : end + 1;
    *end = '\0';
    return start;
}

static size_t panel_named(const char *const name)
{
    for (size_t i = 0; i < panel_count; i++) {
        const size_t length = strlen(panels[i].title);
        if (strncmp(name, panels[i].title, length) == 0 && name[length] == '|' &&
            strcmp(name + length + 1, panels[i].abscissa) == 0) {
            return i;
        }
    }
    return PANELS_MOST;
}

static void read_expected(char *const text)
{
    char *line = text;
    size_t lines = 1;
    for (const char *c = text; *c != '\0'; c++) {
        lines += *c == '\n';
    }
    expected = calloc(lines, sizeof *expected);
    if (expected == NULL) {
        fail("no memory");
    }
    while (*line != '\0') {
        char *const end = line + strcspn(line, "\n");
        char *const next = *end == '\0' ? end : end + 1;
        *end = '\0';
        const char *const name = field(&line);
        const size_t of = panel_named(name);
        if (of == PANELS_MOST) {
            printf("no panel: %s\n", name);
            wrong = 1;
            return;
        }
        point *const p = &expected[expected_count++];
        p->panel = of;
        p->curve = field(&line);
        p->x = strtod(field(&line), NULL);
        p->y = strtod(field(&line), NULL);
        double tolerance = 0;
        p->at = (place){pixel_of(&panels[of].x, p->x, &tolerance), pixel_of(&panels[of].y, p->y, &tolerance)};
        line = next;
    }
}

/* Points by the pixel of their abscissa, so that each is compared with its neighbours alone. */
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

static void sort_points(sorted *const by_column, const point *const points, const size_t count)
{
    memset(by_column->head, 0, sizeof by_column->head);
    by_column->points = points;
    by_column->next = malloc((count + 1) * sizeof *by_column->next);
    if (by_column->next == NULL) {
        fail("no memory");
    }
    for (size_t i = 0; i < count; i++) {
        size_t *const head = &by_column->head[column_of(points[i].at.x)];
        by_column->next[i] = *head;
        *head = i + 1;
    }
}

/* Whether the point that is expected is where the other one is drawn. */
static bool meets(const point *const e, const point *const d)
{
    double x_off = 0;
    double y_off = 0;
    if (e->panel != d->panel || fabs(e->at.x - d->at.x) > 1 || fabs(e->at.y - d->at.y) > 1) {
        return false;
    }
    (void)pixel_of(&panels[e->panel].x, e->x, &x_off);
    (void)pixel_of(&panels[e->panel].y, e->y, &y_off);
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

/* Prints each point of the drawing that is not expected, or each that is expected and not drawn. */
static void compare(const bool of_drawing)
{
    static sorted others;
    const point *const these = of_drawing ? drawn : expected;
    const size_t count = of_drawing ? drawn_count : expected_count;
    sort_points(&others, of_drawing ? expected : drawn, of_drawing ? expected_count : drawn_count);
    for (size_t i = 0; i < count; i++) {
        if (!met(&these[i], of_drawing, &others)) {
            const panel *const p = &panels[these[i].panel];
            printf("%s: %s|%s, %s: %.6g %.6g\n", of_drawing ? "drawn, but it is not so" : "not drawn", p->title,
                   p->abscissa, these[i].curve, of_drawing ? value_of(&p->x, these[i].at.x) : these[i].x,
                   of_drawing ? value_of(&p->y, these[i].at.y) : these[i].y);
            wrong = 1;
        }
    }
    free(others.next);
}

int main(const int argc, char **const argv)
{
    const bool asked =
        argc == 4 && (strcmp(argv[3], "all") == 0 || strcmp(argv[3], "drawn") == 0 || strcmp(argv[3], "covered") == 0);
    if (argc != 2 && !asked) {
        fail("usage: picture FILE.svg [POINTS all|drawn|covered]");
    }
    char *const svg = read_all(argv[1]);
    read_drawing(svg);
    read_panels();
    read_points();
    check_texts();
    if (drawn_count == 0) {
        fail("there is no point");
    }
    if (asked) {
        char *const points = read_all(argv[2]);
        read_expected(points);
        if (expected_count == 0) {
            fail("no point is expected");
        }
        if (wrong == 0 && strcmp(argv[3], "covered") != 0) {
            compare(true);
        }
        if (wrong == 0 && strcmp(argv[3], "drawn") != 0) {
            compare(false);
        }
        free(points);
        free(expected);
    } else if (wrong == 0) {
        for (size_t i = 0; i < drawn_count; i++) {
            const panel *const p = &panels[drawn[i].panel];
            printf("%s|%s\t%s\t%.6g\t%.6g\n", p->title, p->abscissa, drawn[i].curve, value_of(&p->x, drawn[i].at.x),
                   value_of(&p->y, drawn[i].at.y));
        }
    }
    free(svg);
    return wrong;
}
