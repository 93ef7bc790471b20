/* Bodies: their solids, or ellipsoids of inertia and links where they have none. */
#include <string.h>

#include "tools/show/parts.h"
#include "tools/show/show.h"

/* A quarter of a ring about z has another ink, which shows its rotation. */
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
    const bool is_tube = strcmp(solid->kind, "tube") == 0;
    if (is_tube || strcmp(solid->kind, "cylinder") == 0) {
        add_ring_of(f, solid, ink, is_tube ? (vec){size[0], size[1], size[2]} : (vec){size[0], 0.0, size[1]});
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
        any = any || (!j->is_closure && j->child.body == body && j->marker == MARKER_SLIDE);
    }
    return any;
}

/* Whether the force has a rotor: it turns the body about its line. */
static bool has_rotor(const shape_force *x)
{
    return x->moment != 0.0;
}

/* Whether the body flies by rotors, of forces or of propellers. */
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

/* An ellipsoid of inertia, at half its size for a body that flies by rotors, so that its arms show; for a point mass a
 * ball whose size follows from its mass, or a block where it slides. */
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

/* --- links between the points of a body that has no solids there --- */

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

/* How points lie: the two that are farthest from each other; the direction across the plane of all. */
typedef struct layout {
    vec from, to, normal;
    bool is_flat, is_straight;
} layout;

static layout layout_of(const point_list *l)
{
    layout a = {.from = l->all[0], .to = l->all[0], .is_flat = true};
    for (size_t i = 0; i < l->count; i++) {
        for (size_t j = i + 1; j < l->count; j++) {
            if (length_of(minus(l->all[i], l->all[j])) > length_of(minus(a.from, a.to))) {
                a.from = l->all[i];
                a.to = l->all[j];
            }
        }
    }
    const vec way = minus(a.to, a.from);
    const double apart = length_of(way);
    for (size_t i = 0; i < l->count; i++) {
        const vec n = outer(way, minus(l->all[i], a.from));
        a.normal = length_of(n) > length_of(a.normal) ? n : a.normal;
    }
    a.is_straight = length_of(a.normal) < 1e-3 * apart * apart;
    a.normal = unit(a.normal);
    for (size_t i = 0; i < l->count; i++) {
        a.is_flat = a.is_flat && fabs(inner(a.normal, minus(l->all[i], a.from))) < 1e-2 * apart;
    }
    return a;
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

static void add_links(figure *f, const shape *s, int body, int ink)
{
    const double apart = 1e-3 * f->size;
    const shape_lump *lump = lump_of(s, body);
    point_list l = points_of(s, body, apart);
    if (l.count < 2 && lump != NULL) {
        add_point(&l, lump->centre, apart);
    }
    if (l.count < 2) {
        return;
    }
    const layout a = layout_of(&l);
    if (a.is_straight) {
        add_rod(f, ink, body, a.from, a.to);
    } else if (a.is_flat && !flies(s, body)) {
        part *p = add_part(f, PART_OF_BODY, ink, body);
        mesh_plate(&p->shape, l.all, l.count, a.normal, plate_thickness * f->size);
    } else {
        const vec middle = lump != NULL ? lump->centre : l.all[0];
        for (size_t i = 0; i < l.count; i++) {
            if (length_of(minus(l.all[i], middle)) > apart) {
                add_rod(f, ink, body, middle, l.all[i]);
            }
        }
    }
}

/* Rotors are thin discs, above the body that carries them. */
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

/* Whether the plate of a body has its ellipsoid in it, which is thinner. */
static bool lies_in_plate(const figure *f, const shape *s, const shape_lump *l)
{
    const point_list points = points_of(s, l->body, 1e-3 * f->size);
    const layout a = layout_of(&points);
    const vec r = ellipsoid_of(l).radii;
    const double middle = fmax(fmin(r.x, r.y), fmin(fmax(r.x, r.y), r.z));
    return points.count >= 3 && a.is_flat && !a.is_straight && middle <= plate_thickness * f->size &&
           !flies(s, l->body) && !has_solids(s, l->body);
}

void add_bodies(figure *f, const shape *s)
{
    for (size_t i = 0; i < s->solids; i++) {
        add_solid(f, &s->solid[i], s->solid[i].at.body % INKS_OF_BODIES);
    }
    for (size_t i = 0; i < s->lumps; i++) {
        if (!rolls(s, s->lump[i].body) && !lies_in_plate(f, s, &s->lump[i])) {
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
