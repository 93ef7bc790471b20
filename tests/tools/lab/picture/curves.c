#include "tests/tools/lab/picture/curves.h"

#include <math.h>
#include <string.h>

#include "tests/tools/lab/picture/file.h"

#define ROW 6.0 /* a legend's sample and its name are at most so far apart in height */

/* Whether marks of this colour are in the picture: then its paths only join them. */
static bool has_marks(const drawing *const d, const char *const colour)
{
    for (size_t i = 0; i < d->shape_count; i++) {
        if (d->shapes[i].mark >= 0 && strcmp(d->shapes[i].colour, colour) == 0) {
            return true;
        }
    }
    return false;
}

static bool is_curve(const drawing *const d, const shape *const s)
{
    return strcmp(s->colour, AXIS_COLOUR) != 0 && strcmp(s->colour, GRID_COLOUR) != 0 &&
           (s->mark >= 0 || !has_marks(d, s->colour));
}

/* Whether a sample of a legend stands just above the panel, as one that is its own. */
static bool own_sample(const panel *const p, const place at)
{
    return at.x >= p->left && at.x <= p->right && at.y < p->top && at.y > p->top - ABOVE;
}

/* The text in the row of a sample that begins or ends nearest to it. */
static const char *sample_name(const drawing *const d, const shape *const sample)
{
    const place from = d->places[sample->first];
    const place to = d->places[sample->first + sample->places - 1];
    const words *best = NULL;
    double nearest = HUGE_VAL;
    for (size_t i = 0; i < d->text_count; i++) {
        const words *const w = &d->texts[i];
        const double away = w->anchor == 'e' ? fabs(w->at.x - from.x) : fabs(w->at.x - to.x);
        if (fabs(w->at.y - from.y) <= ROW && away < nearest) {
            nearest = away;
            best = w;
        }
    }
    return best == NULL ? "" : best->text;
}

/* The name of a curve: of a sample that looks like it in the panel's own legend, else in that of the picture. */
static const char *curve_name(const drawing *const d, const panels *const of, const panel *const p,
                              const shape *const s)
{
    const char *name = "";
    for (size_t i = 0; i < d->shape_count; i++) {
        const shape *const sample = &d->shapes[i];
        const place at = d->places[sample->first];
        if (sample->places > 0 && is_curve(d, sample) && panel_at(of, at) < 0 && sample->mark == s->mark &&
            strcmp(sample->colour, s->colour) == 0) {
            if (own_sample(p, at)) {
                return sample_name(d, sample);
            }
            bool of_another = false;
            for (size_t j = 0; j < of->count; j++) {
                of_another = of_another || own_sample(&of->all[j], at);
            }
            name = of_another ? name : sample_name(d, sample);
        }
    }
    return name;
}

points read_points(const drawing *const d, const panels *const of)
{
    points read = {.all = memory_of(d->place_count + 1, sizeof *read.all)};
    for (size_t i = 0; i < d->shape_count; i++) {
        const shape *const s = &d->shapes[i];
        const int its = s->places > 0 ? panel_at(of, d->places[s->first]) : -1;
        if (its < 0 || !is_curve(d, s)) {
            continue;
        }
        const panel *const p = &of->all[its];
        const char *const name = curve_name(d, of, p, s);
        for (size_t k = 0; k < s->places; k++) {
            read.all[read.count++] = (point){.panel = p, .curve = name, .at = d->places[s->first + k]};
        }
    }
    return read;
}
