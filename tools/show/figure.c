#include "tools/show/figure.h"

#include <string.h>

#include "tools/show/ellipsoid.h"

/* The sizes of what has none of its own, over that of the mechanism. */
static const double link_radius = 0.011, marker_radius = 0.02, point_radius = 0.035, plate_thickness = 0.018,
                    longest_arrow = 0.3, spring_radius = 0.025, rotor_radius = 0.16;
enum { SIDES = 14, FEW_SIDES = 7, POINTS_OF_BODY = 48, TURNS = 7 };

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

static part *add_part(figure *f, part_kind kind, int ink, int body)
{
    f->all[f->parts] = (part){.kind = kind, .ink = ink, .body = {body, body}};
    return &f->all[f->parts++];
}

static part *add_between(figure *f, int ink, const spot *a, const spot *b)
{
    part *p = add_part(f, PART_BETWEEN, ink, a->body);
    p->body[1] = b->body;
    p->point[0] = a->frame.at;
    p->point[1] = b->frame.at;
    return p;
}

static void add_rod(figure *f, int ink, int body, vec from, vec to)
{
    const pose at = pose_between(from, to);
    part *p = add_part(f, PART_OF_BODY, ink, body);
    mesh_prism(&p->shape, at, link_radius * f->size, 1.0, FEW_SIDES);
}

static pose moved_along_z(pose at, double z)
{
    at.at = placed(&at, (vec){0, 0, z});
    return at;
}

/* --- the size of the mechanism --- */

static bool is_loose(const shape_joint *j)
{
    return strcmp(j->kind, "free") == 0 || strcmp(j->kind, "planar") == 0;
}

typedef struct bounds {
    vec least, most;
    bool any;
} bounds;

static void include(bounds *b, vec p)
{
    b->least = b->any ? (vec){fmin(b->least.x, p.x), fmin(b->least.y, p.y), fmin(b->least.z, p.z)} : p;
    b->most = b->any ? (vec){fmax(b->most.x, p.x), fmax(b->most.y, p.y), fmax(b->most.z, p.z)} : p;
    b->any = true;
}

static void include_spot(bounds *b, const record *r, size_t frame, const spot *at)
{
    const pose p = record_pose(r, frame, at->body);
    include(b, placed(&p, at->frame.at));
}

static void include_round(bounds *b, const record *r, size_t frame, int body, vec at, double radius)
{
    const pose p = record_pose(r, frame, body);
    const vec middle = placed(&p, at), reach = {radius, radius, radius};
    include(b, minus(middle, reach));
    include(b, plus(middle, reach));
}

/* All that stands in a frame. */
static void include_frame(bounds *b, const shape *s, const record *r, size_t frame)
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
}

static double diagonal(const bounds *b)
{
    return b->any ? length_of(minus(b->most, b->least)) : 0.0;
}

static bool any_loose(const shape *s)
{
    bool any = false;
    for (size_t i = 0; i < s->joints; i++) {
        any = any || is_loose(&s->joint[i]);
    }
    return any;
}

/* The diagonal of what stands at one time; of what is not free to go anywhere not less than a part of where it goes. */
static double size_of(const shape *s, const record *r)
{
    enum { LOOKS = 40 };
    static const double least_part = 0.12;
    bounds all = {.any = false};
    double size = 0.0;
    for (size_t frame = 0; frame < r->frames; frame += r->frames / LOOKS + 1) {
        bounds once = {.any = false};
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

/* --- bodies --- */

/* A quarter of what is round about z has another ink, which shows that it turns. */
static void add_ring_of(figure *f, const shape_solid *solid, int ink, vec sizes)
{
    enum { ROUND = 2 * SIDES, QUARTER = ROUND / 4 };
    const int body = solid->at.body;
    mesh_wedge(&add_part(f, PART_OF_BODY, INK_STEEL, body)->shape, solid->at.frame, sizes, ROUND, 0, QUARTER);
    mesh_wedge(&add_part(f, PART_OF_BODY, ink, body)->shape, solid->at.frame, sizes, ROUND, QUARTER, ROUND);
}

static void add_solid(figure *f, const shape_solid *solid, int ink)
{
    const double *size = solid->size;
    const pose at = solid->at.frame;
    if (strcmp(solid->kind, "cylinder") == 0) {
        add_ring_of(f, solid, ink, (vec){size[0], 0.0, size[1]});
        return;
    }
    if (strcmp(solid->kind, "tube") == 0) {
        add_ring_of(f, solid, ink, (vec){size[0], size[1], size[2]});
        return;
    }
    part *p = add_part(f, PART_OF_BODY, ink, solid->at.body);
    if (strcmp(solid->kind, "box") == 0) {
        mesh_box(&p->shape, at, (vec){size[0], size[1], size[2]});
    } else if (strcmp(solid->kind, "rod") == 0) {
        mesh_prism(&p->shape, moved_along_z(at, -size[0] / 2), link_radius * f->size, size[0], FEW_SIDES);
    } else {
        const double radius = size[0] > 0.0 ? size[0] : point_radius * f->size;
        mesh_ellipsoid(&p->shape, at, (vec){radius, radius, radius}, SIDES);
    }
}

static double largest_mass(const shape *s)
{
    double most = 0.0;
    for (size_t i = 0; i < s->lumps; i++) {
        most = fmax(most, s->lump[i].mass);
    }
    return most;
}

/* Whether a joint slides the body, and does nothing else. */
static bool slides(const shape *s, int body)
{
    bool any = false;
    for (size_t i = 0; i < s->joints; i++) {
        const shape_joint *j = &s->joint[i];
        any = any || (!j->is_closure && j->child.body == body && strcmp(j->kind, "prismatic") == 0);
    }
    return any;
}

/* Whether the force has a rotor: it turns the body about its line. */
static bool has_rotor(const shape_force *x)
{
    return x->moment != 0.0;
}

static bool flies(const shape *s, int body)
{
    bool any = false;
    for (size_t i = 0; i < s->forces; i++) {
        any = any || (s->force[i].at.body == body && has_rotor(&s->force[i]));
    }
    for (size_t i = 0; i < s->effects; i++) {
        any = any || (s->effect[i].points == 1 && s->effect[i].at[0].body == body &&
                      strcmp(s->effect[i].kind, "propeller") == 0);
    }
    return any;
}

/* An ellipsoid of inertia, of what flies by rotors at half its size, so that its arms show; of a point mass a ball that follows its mass, or a block where it slides. */
static void add_lump(figure *f, const shape *s, const shape_lump *l, int ink)
{
    const ellipsoid e = ellipsoid_of(l);
    const double least = link_radius * f->size;
    const double ball = point_radius * f->size * fmax(0.5, cbrt(l->mass / largest_mass(s)));
    if (l->mass <= 0.0) {
        return;
    }
    part *p = add_part(f, PART_OF_BODY, ink, l->body);
    if (fmax(e.radii.x, fmax(e.radii.y, e.radii.z)) > least) {
        const double part_of = flies(s, l->body) ? 0.5 : 1.0;
        const vec radii = {fmax(part_of * e.radii.x, least), fmax(part_of * e.radii.y, least),
                           fmax(part_of * e.radii.z, least)};
        mesh_ellipsoid(&p->shape, e.at, radii, SIDES);
    } else if (slides(s, l->body)) {
        pose at = no_pose;
        at.at = l->centre;
        mesh_box(&p->shape, at, (vec){3.2 * ball, 2.4 * ball, 2.0 * ball});
    } else {
        mesh_ellipsoid(&p->shape, e.at, (vec){ball, ball, ball}, SIDES);
    }
}

/* --- links: what holds the points of a body together that has no solids there --- */

typedef struct point_list {
    vec all[POINTS_OF_BODY];
    size_t count;
} point_list;

static void add_point(point_list *l, vec p, double apart)
{
    for (size_t i = 0; i < l->count; i++) {
        if (length_of(minus(l->all[i], p)) <= apart) {
            return;
        }
    }
    if (l->count < POINTS_OF_BODY) {
        l->all[l->count++] = p;
    }
}

static void add_if_on(point_list *l, int body, const spot *at, double apart)
{
    if (at->body == body) {
        add_point(l, at->frame.at, apart);
    }
}

static point_list points_of(const shape *s, int body, double apart)
{
    point_list l = {.count = 0};
    for (size_t i = 0; i < s->joints; i++) {
        if (!is_loose(&s->joint[i]) && s->joint[i].radius <= 0.0) {
            add_if_on(&l, body, &s->joint[i].parent, apart);
            add_if_on(&l, body, &s->joint[i].child, apart);
        }
    }
    for (size_t i = 0; i < s->springs; i++) {
        add_if_on(&l, body, &s->spring[i].first, apart);
        add_if_on(&l, body, &s->spring[i].second, apart);
    }
    for (size_t i = 0; i < s->forces; i++) {
        add_if_on(&l, body, &s->force[i].at, apart);
    }
    for (size_t i = 0; i < s->effects; i++) {
        for (size_t n = 0; n < s->effect[i].points; n++) {
            add_if_on(&l, body, &s->effect[i].at[n], apart);
        }
    }
    for (size_t i = 0; i < s->points; i++) {
        add_if_on(&l, body, &s->point[i].at, apart);
    }
    return l;
}

/* The two points that are farthest from each other. */
static void find_ends(const point_list *l, size_t *from, size_t *to)
{
    *from = *to = 0;
    for (size_t i = 0; i < l->count; i++) {
        for (size_t j = i + 1; j < l->count; j++) {
            if (length_of(minus(l->all[i], l->all[j])) > length_of(minus(l->all[*from], l->all[*to]))) {
                *from = i;
                *to = j;
            }
        }
    }
}

/* The direction across the plane of all points; zero if they lie on a line, or in no plane. */
static vec normal_of(const point_list *l, size_t from, size_t to, bool *is_flat, bool *is_straight)
{
    const vec way = minus(l->all[to], l->all[from]);
    vec normal = {0, 0, 0};
    for (size_t i = 0; i < l->count; i++) {
        const vec n = outer(way, minus(l->all[i], l->all[from]));
        normal = length_of(n) > length_of(normal) ? n : normal;
    }
    const double apart = length_of(way);
    *is_straight = length_of(normal) < 1e-3 * apart * apart;
    normal = unit(normal);
    *is_flat = true;
    for (size_t i = 0; i < l->count; i++) {
        *is_flat = *is_flat && fabs(inner(normal, minus(l->all[i], l->all[from]))) < 1e-2 * apart;
    }
    return normal;
}

/* The body's own centre of mass, where it is a lump alone. */
static const shape_lump *lump_of(const shape *s, int body)
{
    for (size_t i = 0; i < s->lumps; i++) {
        if (s->lump[i].body == body && s->lump[i].mass > 0.0) {
            return &s->lump[i];
        }
    }
    return NULL;
}

static bool flies(const shape *s, int body)
{
    bool any = false;
    for (size_t i = 0; i < s->joints; i++) {
        any = any ||
              (!s->joint[i].is_closure && s->joint[i].child.body == body && is_loose(&s->joint[i]) && s->forces > 0);
    }
    return any;
}

static void add_links(figure *f, const shape *s, int body, int ink)
{
    const double apart = 1e-3 * f->size;
    const shape_lump *lump = lump_of(s, body);
    point_list l = points_of(s, body, apart);
    if (l.count < 2 && lump != NULL) {
        add_point(&l, lump->centre, apart);
    }
    size_t from, to;
    bool is_flat = false, is_straight = true;
    find_ends(&l, &from, &to);
    if (l.count < 2) {
        return;
    }
    const vec normal = normal_of(&l, from, to, &is_flat, &is_straight);
    if (is_straight) {
        add_rod(f, ink, body, l.all[from], l.all[to]);
    } else if (is_flat && !flies(s, body)) {
        part *p = add_part(f, PART_OF_BODY, ink, body);
        mesh_plate(&p->shape, l.all, l.count, normal, plate_thickness * f->size);
    } else {
        const vec middle = lump != NULL ? lump->centre : l.all[0];
        for (size_t i = 0; i < l.count; i++) {
            if (length_of(minus(l.all[i], middle)) > apart) {
                add_rod(f, ink, body, middle, l.all[i]);
            }
        }
    }
}

/* Rotors are thin discs, above what carries them. */
static void add_rotor(figure *f, const spot *at, vec axis)
{
    const double radius = rotor_radius * f->size, thick = 0.5 * link_radius * f->size;
    const pose across =
        pose_between(plus(at->frame.at, times(2.0 * thick, axis)), plus(at->frame.at, times(4.0 * thick, axis)));
    mesh_prism(&add_part(f, PART_OF_BODY, INK_STEEL, at->body)->shape, across, radius, 1.0, 2 * SIDES);
}

static void add_rotors(figure *f, const shape *s)
{
    for (size_t i = 0; i < s->forces; i++) {
        if (has_rotor(&s->force[i])) {
            add_rotor(f, &s->force[i].at, unit(turned(&s->force[i].at.frame, s->force[i].axis)));
        }
    }
    for (size_t i = 0; i < s->effects; i++) {
        if (s->effect[i].points == 1 && strcmp(s->effect[i].kind, "propeller") == 0) {
            add_rotor(f, &s->effect[i].at[0], (vec){0, 0, 1});
        }
    }
}

/* A ball on level ground whose body has nothing round there, and a wheel that rolls. */
static void add_round(figure *f, const shape *s)
{
    for (size_t i = 0; i < s->effects; i++) {
        const shape_effect *e = &s->effect[i];
        f->has_floor = f->has_floor || strcmp(e->kind, "contact") == 0;
        if (strcmp(e->kind, "contact") == 0 && e->radius > 0.0 && lump_of(s, e->at[0].body) != NULL) {
            part *p = add_part(f, PART_OF_BODY, INK_STEEL, e->at[0].body);
            mesh_ellipsoid(&p->shape, e->at[0].frame, (vec){e->radius, e->radius, e->radius}, SIDES);
        }
    }
    for (size_t i = 0; i < s->joints; i++) {
        const shape_joint *j = &s->joint[i];
        if (j->radius <= 0.0) {
            continue;
        }
        f->has_floor = true;
        f->floor_point = j->parent.frame.at;
        f->floor_normal = unit(turned(&j->parent.frame, j->axis));
        part *p = add_part(f, PART_OF_BODY, j->child.body % INKS_OF_BODIES, j->child.body);
        if (length_of(j->axle) > 0.0) {
            const vec half = times(link_radius * f->size, unit(turned(&j->child.frame, j->axle)));
            const pose at = pose_between(minus(j->child.frame.at, half), plus(j->child.frame.at, half));
            mesh_prism(&p->shape, at, j->radius, 1.0, 2 * SIDES);
        } else {
            mesh_ellipsoid(&p->shape, j->child.frame, (vec){j->radius, j->radius, j->radius}, SIDES);
        }
    }
}

static bool rolls(const shape *s, int body)
{
    bool any = false;
    for (size_t i = 0; i < s->joints; i++) {
        any = any || (s->joint[i].radius > 0.0 && s->joint[i].child.body == body);
    }
    return any;
}

static bool has_solids(const shape *s, int body)
{
    bool any = false;
    for (size_t i = 0; i < s->solids; i++) {
        any = any || s->solid[i].at.body == body;
    }
    return any;
}

static void add_bodies(figure *f, const shape *s)
{
    for (size_t i = 0; i < s->solids; i++) {
        add_solid(f, &s->solid[i], s->solid[i].at.body % INKS_OF_BODIES);
    }
    for (size_t i = 0; i < s->lumps; i++) {
        if (!rolls(s, s->lump[i].body)) {
            add_lump(f, s, &s->lump[i], s->lump[i].body % INKS_OF_BODIES);
        }
    }
    for (size_t i = 0; i < s->bodies; i++) {
        if (!has_solids(s, (int)i)) {
            add_links(f, s, (int)i, (int)i % INKS_OF_BODIES);
        }
    }
    add_rotors(f, s);
    add_round(f, s);
}

/* --- joints --- */

/* The way of a slide on the ground, as a rail. */
static void add_rail(figure *f, const record *r, const shape_joint *j)
{
    const vec axis = unit(turned(&j->parent.frame, j->axis));
    double least = 0.0, most = 0.0;
    for (size_t frame = 0; frame < r->frames; frame++) {
        const pose child = record_pose(r, frame, j->child.body);
        const double way = inner(axis, minus(placed(&child, j->child.frame.at), j->parent.frame.at));
        least = fmin(least, way);
        most = fmax(most, way);
    }
    const double beyond = 0.06 * f->size;
    add_rod(f, INK_GROUND, ON_GROUND, plus(j->parent.frame.at, times(least - beyond, axis)),
            plus(j->parent.frame.at, times(most + beyond, axis)));
}

static void add_slide(figure *f, const record *r, const shape_joint *j)
{
    if (j->has_spring) {
        mesh_helix(&add_between(f, INK_SPRING, &j->parent, &j->child)->shape, spring_radius * f->size, TURNS);
    }
    if (j->parent.body == ON_GROUND) {
        add_rail(f, r, j);
    } else if (!j->is_closure) {
        mesh_prism(&add_between(f, INK_STEEL, &j->parent, &j->child)->shape, no_pose, 0.7 * link_radius * f->size, 1.0,
                   FEW_SIDES);
    }
}

/* What the ground holds: a cone whose tip is the joint. */
static void add_mount(figure *f, const shape *s, const shape_joint *j)
{
    const double height = 2.6 * marker_radius * f->size;
    const vec tip = j->parent.frame.at, foot = minus(tip, times(height, up_of(s)));
    const pose at = pose_between(foot, tip);
    part *p = add_part(f, PART_OF_BODY, INK_GROUND, ON_GROUND);
    mesh_cone(&p->shape, at, 0.7 * height, 1.0, 4);
}

static void add_joint(figure *f, const shape *s, const record *r, const shape_joint *j)
{
    const double radius = marker_radius * f->size;
    const bool hinges = strcmp(j->kind, "revolute") == 0 || strcmp(j->kind, "line") == 0,
               slides_too = strcmp(j->kind, "prismatic") == 0 || strcmp(j->kind, "cylindrical") == 0,
               is_ball = strcmp(j->kind, "spherical") == 0 || strcmp(j->kind, "universal") == 0;
    if (slides_too) {
        add_slide(f, r, j);
    } else if (strcmp(j->kind, "distance") == 0) {
        mesh_prism(&add_between(f, INK_STEEL, &j->parent, &j->child)->shape, no_pose, link_radius * f->size, 1.0,
                   FEW_SIDES);
    } else if (hinges || is_ball) {
        part *p = add_part(f, PART_OF_BODY, INK_STEEL, j->parent.body);
        if (is_ball) {
            mesh_ellipsoid(&p->shape, j->parent.frame, (vec){radius, radius, radius}, SIDES - 4);
        } else {
            const vec half = times(1.4 * radius, unit(turned(&j->parent.frame, j->axis)));
            const pose at = pose_between(minus(j->parent.frame.at, half), plus(j->parent.frame.at, half));
            mesh_prism(&p->shape, at, radius, 1.0, SIDES - 4);
        }
        if (j->parent.body == ON_GROUND) {
            add_mount(f, s, j);
        }
    }
}

/* --- forces --- */

static void add_springs(figure *f, const shape *s)
{
    for (size_t i = 0; i < s->springs; i++) {
        part *p = add_between(f, INK_SPRING, &s->spring[i].first, &s->spring[i].second);
        mesh_helix(&p->shape, spring_radius * f->size, TURNS);
    }
    /* What acts between two points and is no solid: a cable, say. */
    for (size_t i = 0; i < s->effects; i++) {
        if (s->effect[i].points == 2) {
            part *p = add_between(f, INK_STEEL, &s->effect[i].at[0], &s->effect[i].at[1]);
            mesh_prism(&p->shape, no_pose, 0.4 * link_radius * f->size, 1.0, FEW_SIDES);
        }
    }
}

static void add_arrows(figure *f, const shape *s, const record *r)
{
    double most = 0.0;
    for (int pass = 0; pass < 2; pass++) {
        for (size_t i = 0; i < s->forces; i++) {
            char name[RECORD_NAME_BYTES];
            record_name(name, "force", i);
            const int column = record_column(r, name);
            for (size_t frame = 0; pass == 0 && column >= 0 && frame < r->frames; frame++) {
                most = fmax(most, fabs((double)r->value[frame * r->columns + (size_t)column]));
            }
            if (pass == 0 || column < 0 || !(most > 0.0)) {
                continue;
            }
            const double thick = link_radius * f->size;
            part *p = add_part(f, PART_FORCE, INK_FORCE, s->force[i].at.body);
            p->point[0] = s->force[i].at.frame.at;
            p->point[1] = unit(turned(&s->force[i].at.frame, s->force[i].axis));
            p->column = column;
            p->scale = longest_arrow * f->size / most;
            mesh_prism(&p->shape, no_pose, 0.7 * thick, 0.75, FEW_SIDES);
            mesh_cone(&p->shape, moved_along_z(no_pose, 0.75), 2.0 * thick, 0.25, FEW_SIDES);
        }
    }
}

figure figure_of(const shape *s, const record *r)
{
    enum { PARTS_OF_A_BODY = POINTS_OF_BODY + 1 };
    figure f = {.floor_normal = {0, 0, 1}, .size = size_of(s, r)};
    const size_t most = 2 * s->solids + s->lumps + PARTS_OF_A_BODY * s->bodies + 4 * s->joints + s->springs +
                        s->forces + 2 * s->effects + 1;
    f.all = table_memory(most, sizeof *f.all);
    add_bodies(&f, s);
    for (size_t i = 0; i < s->joints; i++) {
        add_joint(&f, s, r, &s->joint[i]);
    }
    add_springs(&f, s);
    add_arrows(&f, s, r);
    return f;
}
