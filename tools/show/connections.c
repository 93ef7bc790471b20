/* Connections of bodies, and loads on them: joints, springs, forces. */
#include "tools/show/parts.h"

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
    const pose at = pose_between(plus(j->parent.frame.at, times(least - beyond, axis)),
                                 plus(j->parent.frame.at, times(most + beyond, axis)));
    mesh_bar(&add_part(f, PART_OF_BODY, INK_GROUND, ON_GROUND)->shape, at, 0.8 * link_radius * f->size, 1.0, FEW_SIDES,
             RAIL_PIECES);
}

static void add_slide(figure *f, const record *r, const shape_joint *j)
{
    if (j->has_spring) {
        mesh_helix(&add_between(f, INK_SPRING, &j->parent, &j->child)->shape, spring_radius * f->size, TURNS);
    }
    if (j->parent.body == ON_GROUND) {
        add_rail(f, r, j);
    } else {
        mesh_prism(&add_between(f, INK_STEEL, &j->parent, &j->child)->shape, no_pose, 0.7 * link_radius * f->size, 1.0,
                   FEW_SIDES);
    }
}

/* The mount of a joint on the ground: a cone whose tip is the joint. */
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
    if (j->marker == MARKER_SLIDE || j->marker == MARKER_SLEEVE) {
        add_slide(f, r, j);
    } else if (j->marker == MARKER_BAR) {
        mesh_prism(&add_between(f, INK_STEEL, &j->parent, &j->child)->shape, no_pose, link_radius * f->size, 1.0,
                   FEW_SIDES);
    } else if (j->marker == MARKER_PIN || j->marker == MARKER_BALL || j->marker == MARKER_BLOCK) {
        part *p = add_part(f, PART_OF_BODY, INK_STEEL, j->parent.body);
        if (j->marker == MARKER_BALL) {
            mesh_ellipsoid(&p->shape, j->parent.frame, (vec){radius, radius, radius}, SIDES - 4);
        } else if (j->marker == MARKER_BLOCK) {
            mesh_box(&p->shape, j->parent.frame, times(2.0 * radius, (vec){1, 1, 1}));
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
    /* Effects between two points without a solid, such as a cable. */
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
            const int column = record_column(r, record_name(name, "force", i));
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

void add_connections(figure *f, const shape *s, const record *r)
{
    for (size_t i = 0; i < s->joints; i++) {
        add_joint(f, s, r, &s->joint[i]);
    }
    add_springs(f, s);
    add_arrows(f, s, r);
}
