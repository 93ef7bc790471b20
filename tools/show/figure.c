#include "tools/show/show.h"

#include "tools/show/parts.h"

vec up_of(const shape *s)
{
    return length_of(s->gravity) > 0.0 ? unit(times(-1.0, s->gravity)) : (vec){0, 0, 1};
}

pose part_pose(const part *p, const record *r, size_t frame)
{
    const pose first = record_pose(r, frame, p->body[0]);
    if (p->kind == PART_OF_BODY) {
        return first;
    }
    const vec from = placed(&first, p->point[0]);
    if (p->kind == PART_FORCE) {
        const double length = p->scale * (double)r->value[frame * r->columns + (size_t)p->column];
        return pose_between(from, plus(from, times(length, turned(&first, p->point[1]))));
    }
    const pose second = record_pose(r, frame, p->body[1]);
    return pose_between(from, placed(&second, p->point[1]));
}

part *add_part(figure *f, part_kind kind, int ink, int body)
{
    f->all[f->parts] = (part){.kind = kind, .ink = ink, .body = {body, body}};
    return &f->all[f->parts++];
}

part *add_between(figure *f, int ink, const spot *a, const spot *b)
{
    part *p = add_part(f, PART_BETWEEN, ink, a->body);
    p->body[1] = b->body;
    p->point[0] = a->frame.at;
    p->point[1] = b->frame.at;
    return p;
}

void add_rod(figure *f, int ink, int body, vec from, vec to)
{
    const pose at = pose_between(from, to);
    part *p = add_part(f, PART_OF_BODY, ink, body);
    mesh_bar(&p->shape, at, link_radius * f->size, 1.0, FEW_SIDES, ROD_PIECES);
}

pose moved_along_z(pose at, double z)
{
    at.at = placed(&at, (vec){0, 0, z});
    return at;
}

/* --- the size of the mechanism --- */

bool is_loose(const shape_joint *j)
{
    return j->marker == MARKER_NONE;
}

/* Adds a sphere about a point of a body to the box. */
static void include_round(box *b, const record *r, size_t frame, int body, vec at, double radius)
{
    const pose p = record_pose(r, frame, body);
    const vec centre = placed(&p, at), reach = {radius, radius, radius};
    include(b, minus(centre, reach));
    include(b, plus(centre, reach));
}

static void include_spot(box *b, const record *r, size_t frame, const spot *at)
{
    include_round(b, r, frame, at->body, at->frame.at, 0.0);
}

/* Adds all parts in a frame to the box. */
static void include_frame(box *b, const shape *s, const record *r, size_t frame)
{
    for (size_t i = 0; i < s->lumps; i++) {
        include_round(b, r, frame, s->lump[i].body, s->lump[i].centre, 0.0);
    }
    for (size_t i = 0; i < s->solids; i++) {
        const double *size = s->solid[i].size;
        include_round(b, r, frame, s->solid[i].at.body, s->solid[i].at.frame.at,
                      fmax(size[0], fmax(size[1], size[2])) / 2);
    }
    for (size_t i = 0; i < s->joints; i++) {
        if (!is_loose(&s->joint[i])) {
            include_spot(b, r, frame, &s->joint[i].parent);
            include_spot(b, r, frame, &s->joint[i].child);
        }
    }
    for (size_t i = 0; i < s->forces; i++) {
        include_spot(b, r, frame, &s->force[i].at);
    }
    for (size_t i = 0; i < s->points; i++) {
        include_spot(b, r, frame, &s->point[i].at);
    }
}

static bool any_loose(const shape *s)
{
    bool any = false;
    for (size_t i = 0; i < s->joints; i++) {
        any = any || is_loose(&s->joint[i]);
    }
    return any;
}

/* The largest diagonal at one time; without free bodies, at least a part of the diagonal of the whole motion. */
static double size_of(const shape *s, const record *r)
{
    enum { LOOKS = 40 };
    static const double least_part = 0.12;
    box all = {.any = false};
    double size = 0.0;
    for (size_t frame = 0; frame < r->frames; frame += r->frames / LOOKS + 1) {
        box once = {.any = false};
        include_frame(&once, s, r, frame);
        include_frame(&all, s, r, frame);
        size = fmax(size, diagonal(&once));
    }
    size = any_loose(s) ? size : fmax(size, least_part * diagonal(&all));
    for (size_t i = 0; i < s->lumps; i++) {
        const vec radii = ellipsoid_of(&s->lump[i]).radii;
        size = fmax(size, 2.0 * fmax(radii.x, fmax(radii.y, radii.z)));
    }
    return size > 0.0 ? size : 1.0;
}

figure figure_of(const shape *s, const record *r)
{
    enum { PARTS_OF_A_BODY = POINTS_OF_BODY + 1 };
    figure f = {.floor_normal = {0, 0, 1}, .size = size_of(s, r)};
    const size_t most = 2 * s->solids + s->lumps + PARTS_OF_A_BODY * s->bodies + 4 * s->joints + s->springs +
                        s->forces + 2 * s->effects + 1;
    f.all = memory_for(most, sizeof *f.all);
    add_bodies(&f, s);
    add_connections(&f, s, r);
    return f;
}
