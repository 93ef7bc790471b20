#include "tools/show/show.h"

#include <stdlib.h>
#include <string.h>

const int ink_colours[INKS][3] = {
    {91, 143, 201}, {224, 147, 74},  {99, 173, 111},  {184, 137, 201}, {217, 178, 63}, {216, 115, 111},
    {95, 179, 179}, {160, 148, 132}, {146, 153, 162}, {112, 119, 129}, {214, 52, 63},  {125, 139, 153},
};

/* Light from the left above the viewer, in the axes of the camera. */
static const vec light = {-0.35, 0.62, 0.70};
static const double dark = 0.58, bright = 0.46;
enum { WIDTH = 560, HEIGHT = 380, GRID = 6 };

/* A polygon, or an open line, of the picture. */
typedef struct drawn {
    double nearness;
    size_t first, corners; /* in the list of points */
    int colour[3];
    bool is_line;
} drawn;

typedef struct picture {
    drawn *all;
    size_t count, points;
    seen *point;
} picture;

static int by_nearness(const void *a, const void *b)
{
    const drawn *x = a, *y = b;
    const int nearer = (x->nearness > y->nearness) - (x->nearness < y->nearness);
    return nearer != 0 ? nearer : (x->first > y->first) - (x->first < y->first);
}

/* Twice the area of a polygon in the picture; below zero where it is seen from without, y leading down. */
static double area_of(const seen *p, size_t count)
{
    double sum = 0.0;
    for (size_t i = 0; i < count; i++) {
        const seen *next = &p[(i + 1) % count];
        sum += p[i].x * next->y - next->x * p[i].y;
    }
    return sum;
}

static void shade(int colour[3], int ink, const vec *corner, const camera *by)
{
    const vec n = unit(outer(minus(corner[1], corner[0]), minus(corner[2], corner[0])));
    const vec seen_normal = {inner(by->right, n), inner(by->up, n), inner(by->out, n)};
    const double lit = dark + bright * fmax(0.0, inner(seen_normal, light));
    for (int i = 0; i < 3; i++) {
        colour[i] = (int)fmin(255.0, floor(lit * ink_colours[ink][i] + 0.5));
    }
}

static void add_face(picture *to, const part *p, const pose *at, const camera *by, size_t from, size_t end)
{
    const bool is_line = p->ink == INK_SPRING;
    const size_t corners = end - from;
    drawn *face = &to->all[to->count];
    *face = (drawn){.first = to->points, .corners = corners, .is_line = is_line};
    vec first[3] = {{0, 0, 0}};
    for (size_t i = 0; i < corners; i++) {
        const vec q = placed(at, p->shape.vertex[p->shape.corner[from + i]]);
        const seen s = camera_sees(by, q);
        to->point[to->points + i] = s;
        face->nearness += s.nearness / (double)corners;
        /* A corner that lies on the one before gives no direction. */
        first[i < 3 ? i : 2] = i < 3 ? q : first[2];
    }
    if (is_line) {
        memcpy(face->colour, ink_colours[p->ink], sizeof face->colour);
    } else if (area_of(to->point + to->points, corners) < 0.0) {
        shade(face->colour, p->ink, first, by);
    } else {
        return;
    }
    to->points += corners;
    to->count++;
}

/* The pen is at a point of the grid of tenths of pixels; each point is written relative to the one before. */
typedef struct pen {
    long x, y;
    bool is_down;
} pen;

static void draw_to(FILE *out, pen *at, const seen *p)
{
    const long x = lround(10.0 * p->x), y = lround(10.0 * p->y);
    if (!at->is_down) {
        fprintf(out, "M%ld %ldl", x, y);
    } else if (x != at->x || y != at->y) {
        fprintf(out, "%ld%s%ld ", x - at->x, y < at->y ? "" : " ", y - at->y);
    }
    *at = (pen){x, y, true};
}

static void write_points(FILE *out, const seen *p, size_t count)
{
    pen at = {.is_down = false};
    for (size_t i = 0; i < count; i++) {
        draw_to(out, &at, &p[i]);
    }
}

/* The grid of the floor, around the centre of the picture. */
static void write_floor(FILE *out, const view *v, const camera *by)
{
    const vec from = minus(by->centre, v->floor_point);
    const double x = v->cell * floor(inner(from, v->floor_x) / v->cell + 0.5),
                 y = v->cell * floor(inner(from, v->floor_y) / v->cell + 0.5);
    fputs("<path fill='none' stroke='#d4d9df' stroke-width='8' d='", out);
    for (int i = -GRID; i <= GRID; i++) {
        for (int way = 0; way < 2; way++) {
            seen line[2];
            for (int end = 0; end < 2; end++) {
                const double along = v->cell * (end == 0 ? -GRID : GRID), across = v->cell * i;
                const vec p = plus(v->floor_point, plus(times(x + (way == 0 ? along : across), v->floor_x),
                                                        times(y + (way == 0 ? across : along), v->floor_y)));
                line[end] = camera_sees(by, p);
            }
            write_points(out, line, 2);
        }
    }
    fputs("'/>\n", out);
}

/* The ways of the points that outputs show, over the whole run. */
static void write_ways(FILE *out, const shape *s, const record *r, const camera *by)
{
    enum { MOST = 300 };
    const size_t stride = r->frames / MOST + 1;
    for (size_t i = 0; i < s->points; i++) {
        char name[RECORD_NAME_BYTES];
        snprintf(name, sizeof name, "%.60s_x", s->point[i].name);
        const int column = record_column(r, name);
        if (column < 0) {
            continue;
        }
        fputs("<path fill='none' stroke='#e2574c' stroke-width='10' stroke-opacity='.55' d='", out);
        pen on = {.is_down = false};
        for (size_t frame = 0; frame < r->frames; frame += stride) {
            const float *p = r->value + frame * r->columns + (size_t)column;
            const seen at = camera_sees(by, (vec){(double)p[0], (double)p[1], (double)p[2]});
            draw_to(out, &on, &at);
        }
        fputs("'/>\n", out);
    }
}

void still_write(FILE *out, const shape *s, const record *r, const figure *f, const view *v, double seconds)
{
    const double at = floor(seconds / r->interval + 0.5);
    const size_t frame = at >= (double)r->frames ? r->frames - 1 : (size_t)at;
    const camera by = camera_of(v, r, s->bodies, frame, WIDTH, HEIGHT);
    size_t faces = 1, corners = 1;
    for (size_t i = 0; i < f->parts; i++) {
        faces += f->all[i].shape.faces;
        corners += f->all[i].shape.corners;
    }
    picture all = {.all = memory_for(faces, sizeof *all.all), .point = memory_for(corners, sizeof *all.point)};
    for (size_t i = 0; i < f->parts; i++) {
        const part *p = &f->all[i];
        const pose stands = part_pose(p, r, frame);
        for (size_t n = 0; n < p->shape.faces; n++) {
            add_face(&all, p, &stands, &by, n == 0 ? 0 : p->shape.end[n - 1], p->shape.end[n]);
        }
    }
    qsort(all.all, all.count, sizeof *all.all, by_nearness);
    fprintf(out, "<svg xmlns='http://www.w3.org/2000/svg' class='still' width='%d' height='%d' viewBox='0 0 %d %d'>\n",
            WIDTH, HEIGHT, 10 * WIDTH, 10 * HEIGHT);
    fprintf(out, "<title>%s at %g s</title>\n<rect width='100%%' height='100%%' fill='#fff'/>\n", s->name,
            (double)frame * r->interval);
    if (v->has_floor) {
        write_floor(out, v, &by);
    }
    write_ways(out, s, r, &by);
    fputs("<g stroke-width='6' stroke-linejoin='round' fill='currentColor' stroke='currentColor'>\n", out);
    for (size_t i = 0; i < all.count; i++) {
        const drawn *d = &all.all[i];
        fprintf(out, "<path%s color='#%02x%02x%02x' d='", d->is_line ? " fill='none' stroke-width='18'" : "",
                (unsigned)d->colour[0], (unsigned)d->colour[1], (unsigned)d->colour[2]);
        write_points(out, all.point + d->first, d->corners);
        fputs(d->is_line ? "'/>\n" : "z'/>\n", out);
    }
    fputs("</g>\n</svg>\n", out);
    free(all.all);
    free(all.point);
}
