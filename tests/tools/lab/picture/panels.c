#include "tests/tools/lab/picture/panels.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tests/tools/lab/picture/file.h"

/* Gnuplot draws a tic that is next to nothing beyond the end of its axis. */
#define SLACK 0.2

/* The label of an abscissa is at most so far below the panel. */
#define BELOW 60.0

static bool inside(const panel *const p, const place at)
{
    return at.x >= p->left - SLACK && at.x <= p->right + SLACK && at.y >= p->top - SLACK && at.y <= p->bottom + SLACK;
}

int panel_at(const panels *const of, const place at)
{
    for (size_t i = 0; i < of->count; i++) {
        if (inside(&of->all[i], at)) {
            return (int)i;
        }
    }
    return -1;
}

int panel_named(const panels *const of, const char *const name)
{
    for (size_t i = 0; i < of->count; i++) {
        const panel *const p = &of->all[i];
        const size_t length = strlen(p->title);
        if (strncmp(name, p->title, length) == 0 && name[length] == '|' &&
            strcmp(name + length + 1, p->abscissa) == 0) {
            return (int)i;
        }
    }
    return -1;
}

/* Adds the panel with this edge, the axes' corner of an L, unless it is there. */
static void add_panel(panels *const of, const place *const corner)
{
    for (size_t i = 0; i < of->count; i++) {
        if (same(of->all[i].left, corner[0].x) && same(of->all[i].top, corner[0].y)) {
            return;
        }
    }
    of->all[one_more(&of->count, PANELS_MOST, "too many panels")] =
        (panel){.left = corner[1].x, .right = corner[2].x, .top = corner[0].y, .bottom = corner[1].y};
}

static bool place_labels(panels *const of, const drawing *const d)
{
    bool right = true;
    for (size_t i = 0; i < d->label_count; i++) {
        const label *const l = &d->labels[i];
        const int its = panel_at(of, l->tic);
        if (its < 0) {
            printf("a tic without a panel: %s\n", l->text->text);
            right = false;
        } else if (!axis_label(l->of_x ? &of->all[its].x : &of->all[its].y, l->of_x ? l->tic.x : l->tic.y,
                               l->text->text)) {
            printf("no label of an axis: %s\n", l->text->text);
            right = false;
        }
    }
    return right;
}

/* The title begins at the left edge, above the panel: of the texts there the nearest. */
static const char *title_of(const drawing *const d, const panel *const p)
{
    const words *nearest = NULL;
    for (size_t i = 0; i < d->text_count; i++) {
        const words *const w = &d->texts[i];
        const bool fits = w->anchor == 's' && !w->upright && fabs(w->at.x - p->left) <= 1 &&
                          w->at.y >= p->top - ABOVE && w->at.y <= p->top && w->text[0] != '\0';
        if (fits && (nearest == NULL || w->at.y > nearest->at.y)) {
            nearest = w;
        }
    }
    return nearest == NULL ? "" : nearest->text;
}

/* The label of an abscissa stands below the numbers: of the texts in the middle below the panel the lowest. */
static const char *abscissa_of(const drawing *const d, const panel *const p)
{
    const words *lowest = NULL;
    for (size_t i = 0; i < d->text_count; i++) {
        const words *const w = &d->texts[i];
        const bool fits = w->anchor == 'm' && !w->upright && same(w->at.x, (p->left + p->right) / 2) &&
                          w->at.y > p->bottom && w->at.y < p->bottom + BELOW;
        if (fits && (lowest == NULL || w->at.y > lowest->at.y)) {
            lowest = w;
        }
    }
    return lowest == NULL ? "" : lowest->text;
}

/* An axis without labels is that of the next panel below, or on the left. */
static void share_axes(const panels *const of, panel *const p)
{
    const panel *below = NULL;
    const panel *beside = NULL;
    for (size_t i = 0; i < of->count; i++) {
        const panel *const q = &of->all[i];
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

bool read_panels(panels *const of, const drawing *const d)
{
    for (size_t i = 0; i < d->shape_count; i++) {
        const shape *const s = &d->shapes[i];
        if (strcmp(s->colour, AXIS_COLOUR) == 0 && s->places > 2) {
            add_panel(of, &d->places[s->first]);
        }
    }
    bool right = place_labels(of, d);
    for (size_t i = 0; i < of->count; i++) {
        of->all[i].title = title_of(d, &of->all[i]);
        of->all[i].abscissa = abscissa_of(d, &of->all[i]);
    }
    for (size_t i = 0; i < of->count; i++) {
        share_axes(of, &of->all[i]);
    }
    for (size_t i = 0; i < of->count; i++) {
        panel *const p = &of->all[i];
        right = axis_scale(&p->x, p->title, "x") && right;
        right = axis_scale(&p->y, p->title, "y") && right;
    }
    return right;
}
