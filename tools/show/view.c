#include "tools/show/show.h"

/* Frames that are checked for the extent of a picture. */
enum { FRAMES_LOOKED_AT = 150 };

static size_t stride_of(const record *r)
{
    return r->frames / FRAMES_LOOKED_AT + 1;
}

/* The middle of the bodies in a frame. */
static vec middle_of(const record *r, size_t bodies, size_t frame)
{
    vec sum = {0, 0, 0};
    for (size_t i = 0; i < bodies; i++) {
        sum = plus(sum, times(1.0 / (double)bodies, record_pose(r, frame, (int)i).at));
    }
    return sum;
}

/* --- the extent of a picture: a box in the axes of a camera --- */

/* All corners of the figure in a frame, from `origin`, by a camera or along the axes where it is NULL. */
static void hold_frame(box *b, const figure *f, const record *r, size_t frame, vec origin, const camera *by,
                       bool ground)
{
    for (size_t i = 0; i < f->parts; i++) {
        const part *p = &f->all[i];
        if (!ground && p->kind == PART_OF_BODY && p->body[0] == ON_GROUND) {
            continue;
        }
        const pose at = part_pose(p, r, frame);
        for (size_t n = 0; n < p->shape.vertices; n++) {
            const vec from = minus(placed(&at, p->shape.vertex[n]), origin);
            const seen s = by == NULL ? (seen){from.x, from.y, from.z} : camera_sees(by, from);
            include(b, (vec){s.x, s.y, s.nearness});
        }
    }
}

static box box_of(const shape *s, const figure *f, const record *r, const camera *by, bool follows)
{
    box b = {.any = false};
    for (size_t frame = 0; frame < r->frames; frame += stride_of(r)) {
        const vec origin = follows ? middle_of(r, s->bodies, frame) : (vec){0, 0, 0};
        hold_frame(&b, f, r, frame, origin, by, !follows);
    }
    return b;
}

/* The axis across which nothing moves: of a mechanism in a plane; -1 of one in space. */
static int flat_axis(const shape *s, const record *r)
{
    double most[3] = {0.0, 0.0, 0.0};
    for (size_t i = 0; i < s->bodies; i++) {
        const pose first = record_pose(r, 0, (int)i);
        for (size_t frame = 0; frame < r->frames; frame += stride_of(r)) {
            const pose at = record_pose(r, frame, (int)i);
            const vec move = minus(at.at, first.at);
            const double way[3] = {fabs(move.x), fabs(move.y), fabs(move.z)};
            for (int axis = 0; axis < 3; axis++) {
                const vec e = {axis == 0, axis == 1, axis == 2};
                const double tilt = length_of(minus(turned(&at, e), turned(&first, e)));
                most[axis] = fmax(most[axis], fmax(way[axis], tilt));
            }
        }
    }
    for (int axis = 0; axis < 3; axis++) {
        if (most[axis] < 1e-3) {
            return axis;
        }
    }
    return -1;
}

/* The front: of a flat mechanism its plane, so that the axis across shows to the right; else a view from a corner. */
static void face(view *v, const shape *s, const record *r)
{
    static const double flat_yaw = 0.3, flat_pitch = 0.2, corner_yaw = 0.6, corner_pitch = 0.35;
    const int flat = flat_axis(s, r);
    v->is_flat = flat >= 0;
    v->up = flat == 2 && length_of(s->gravity) == 0.0 ? (vec){0, 1, 0} : up_of(s);
    v->out = flat == 0 ? (vec){1, 0, 0} : flat == 2 ? (vec){0, 0, 1} : (vec){0, -1, 0};
    if (fabs(inner(v->up, v->out)) > 0.9) {
        v->out = fabs(v->up.x) > 0.9 ? (vec){0, -1, 0} : (vec){1, 0, 0};
        v->out = fabs(v->up.y) > 0.9 ? (vec){0, 0, 1} : v->out;
    }
    v->out = unit(minus(v->out, times(inner(v->out, v->up), v->up)));
    v->right = outer(v->up, v->out);
    v->yaw = flat >= 0 ? flat_yaw : corner_yaw;
    v->pitch = flat >= 0 ? flat_pitch : corner_pitch;
}

static camera turned_camera(const view *v)
{
    const double c = cos(v->yaw), s = sin(v->yaw);
    const vec level = plus(times(c, v->out), times(s, v->right));
    camera by = {.right = minus(times(c, v->right), times(s, v->out)), .scale = 1.0, .distance = v->distance};
    by.out = plus(times(cos(v->pitch), level), times(sin(v->pitch), v->up));
    by.up = outer(by.out, by.right);
    return by;
}

seen camera_sees(const camera *c, vec p)
{
    const vec d = minus(p, c->centre);
    const double nearness = inner(c->out, d), k = c->scale * c->distance / (c->distance - nearness);
    return (seen){c->x + k * inner(c->right, d), c->y - k * inner(c->up, d), nearness};
}

/* 1, 2 or 5 times a power of ten, not below x. */
static double round_length(double x)
{
    const double ten = pow(10.0, floor(log10(x)));
    return x <= ten ? ten : x <= 2.0 * ten ? 2.0 * ten : x <= 5.0 * ten ? 5.0 * ten : 10.0 * ten;
}

/* Where the scene has level ground; else below all of a mechanism in space that stands on the ground. */
static void lay_floor(view *v, const figure *f, const box *all, const record *r)
{
    v->cell = round_length(f->size / 4.0);
    v->has_floor = f->has_floor || (!v->is_flat && !v->follows && r->frames > 0);
    v->floor_point = f->floor_point;
    const vec normal = f->has_floor ? f->floor_normal : v->up;
    if (!f->has_floor) {
        const double low = inner(v->up, v->up.x + v->up.y + v->up.z > 0 ? all->least : all->most);
        v->floor_point = times(low, v->up);
    }
    v->floor_x = unit(minus(v->right, times(inner(v->right, normal), normal)));
    v->floor_y = outer(normal, v->floor_x);
}

view view_of(const shape *s, const record *r, const figure *f)
{
    view v = {.follows = false};
    static const double far = 3.5, viewer = 5.0;
    box once = {.any = false};
    hold_frame(&once, f, r, 0, (vec){0, 0, 0}, NULL, false);
    const box moving = box_of(s, f, r, NULL, true), all = box_of(s, f, r, NULL, false);
    face(&v, s, r);
    v.follows = diagonal(&all) > far * fmax(diagonal(&once), 0.6 * diagonal(&moving));
    const box *held = v.follows ? &moving : &all;
    v.centre = box_centre(held);
    v.distance = viewer * fmax(diagonal(held) / 2, 1e-9);
    camera by = turned_camera(&v);
    by.centre = v.centre;
    const box shown = box_of(s, f, r, &by, v.follows);
    const vec at = box_centre(&shown);
    v.centre = plus(v.centre, minus(times(at.x, by.right), times(at.y, by.up)));
    v.half_width = fmax((shown.most.x - shown.least.x) / 2, 1e-9);
    v.half_height = fmax((shown.most.y - shown.least.y) / 2, 1e-9);
    lay_floor(&v, f, &all, r);
    return v;
}

camera camera_of(const view *v, const record *r, size_t bodies, size_t frame, double width, double height)
{
    static const double margin = 0.9;
    camera by = turned_camera(v);
    by.centre = v->follows ? plus(v->centre, middle_of(r, bodies, frame)) : v->centre;
    by.scale = margin * fmin(width / (2.0 * v->half_width), height / (2.0 * v->half_height));
    by.x = width / 2.0;
    by.y = height / 2.0;
    return by;
}
