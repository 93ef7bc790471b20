/* The tree of a mechanism as bodies of MuJoCo. */
#include <math.h>
#include <string.h>

#include "core/numbers/sincos.h"
#include "tools/isoc/base/numbers.h"
#include "tools/isoc/export/mjcf.h"

static const seat still = {{0.0, 0.0, 0.0}, {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

static seat then(const seat *a, const seat *b)
{
    seat result;
    for (int i = 0; i < 3; i++) {
        result.at[i] = a->at[i];
        for (int j = 0; j < 3; j++) {
            result.at[i] += a->turn[i][j] * b->at[j];
            result.turn[i][j] =
                a->turn[i][0] * b->turn[0][j] + a->turn[i][1] * b->turn[1][j] + a->turn[i][2] * b->turn[2][j];
        }
    }
    return result;
}

static seat seat_of(const mjcf_writer *w, matrix axes, vector at)
{
    seat result;
    for (int i = 0; i < 3; i++) {
        result.at[i] = w->numbers[at.at[i]];
        for (int j = 0; j < 3; j++) {
            result.turn[i][j] = w->numbers[axes.at[i][j]];
        }
    }
    return result;
}

static void matrix_of_quaternion(const double q[4], double r[3][3])
{
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const double rows[3][3] = {{w * w + x * x - y * y - z * z, 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)},
                               {2.0 * (x * y + w * z), w * w - x * x + y * y - z * z, 2.0 * (y * z - w * x)},
                               {2.0 * (x * z - w * y), 2.0 * (y * z + w * x), w * w - x * x - y * y + z * z}};
    memcpy(r, rows, sizeof rows);
}

/* The motion of a segment's frame by its coordinate, or its quaternion. */
static seat moved(const segment *l, const double *q)
{
    seat result = still;
    const int i = (l->axis + 1) % 3, j = (l->axis + 2) % 3;
    if (l->kind == JOINT_PRISMATIC) {
        result.at[l->axis] = l->sign * q[0];
    } else if (l->kind == JOINT_REVOLUTE) {
        result.turn[i][i] = result.turn[j][j] = iso_sincos(q[0]).cos;
        result.turn[j][i] = l->sign * iso_sincos(q[0]).sin;
        result.turn[i][j] = -result.turn[j][i];
    } else {
        matrix_of_quaternion(q, result.turn);
    }
    return result;
}

/* A segment's frame in its parent's. */
static seat seat_in_state(const mjcf_writer *w, const segment *l, const double *x)
{
    const seat zero = seat_of(w, l->turn, l->offset), move = moved(l, x + l->position);
    return then(&zero, &move);
}

const char *mjcf_numbers(const mjcf_writer *w, const double *x, int count)
{
    text result = {.memory = w->g->memory};
    for (int i = 0; i < count; i++) {
        text_add(&result, i > 0 ? " %.17g" : "%.17g", x[i] + 0.0);
    }
    return result.bytes;
}

const char *mjcf_number(const mjcf_writer *w, double x)
{
    return mjcf_numbers(w, &x, 1);
}

const char *mjcf_vector(const mjcf_writer *w, vector v)
{
    return mjcf_numbers(w, (const double[]){w->numbers[v.at[0]], w->numbers[v.at[1]], w->numbers[v.at[2]]}, 3);
}

static const char *turn_numbers(const mjcf_writer *w, double axes[3][3])
{
    double q[4];
    quaternion_of_matrix(axes, q);
    return mjcf_numbers(w, q, 4);
}

/* --- bodies --- */

/* The largest rounding of a zero inertia about the centre, relative to the moments of inertia. */
static const double rounding = 1e-15;

/* The mass and the centred inertia on a segment, from the bodies of the scene, which regroup.c does not move. */
static void weigh(const mjcf_writer *w, solid_body *b)
{
    double ms[3] = {0}, about[6] = {0};
    for (int i = 0; i < w->m->bodies.count; i++) {
        const composite *own = &w->m->bodies.members[i].own;
        if (w->m->bodies.frames[i].segment != b->last) {
            continue;
        }
        const node all[6] = {own->inertia.xx, own->inertia.yy, own->inertia.zz,
                             own->inertia.xy, own->inertia.xz, own->inertia.yz};
        b->mass += w->numbers[own->mass];
        for (int k = 0; k < 6; k++) {
            about[k] += w->numbers[all[k]];
            ms[k % 3] += k < 3 ? w->numbers[own->ms.at[k]] : 0.0;
        }
    }
    for (int k = 0; k < 3; k++) {
        b->centre[k] = b->mass > 0.0 ? ms[k] / b->mass : 0.0;
    }
    const double *c = b->centre, square = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
    static const int rows[6] = {0, 1, 2, 0, 0, 1}, columns[6] = {0, 1, 2, 1, 2, 2};
    for (int k = 0; k < 6; k++) {
        const double own = about[k] - b->mass * ((k < 3 ? square : 0.0) - c[rows[k]] * c[columns[k]]);
        b->inertia[k] = fabs(own) < rounding * (about[0] + about[1] + about[2]) ? 0.0 : own;
    }
}

bool mjcf_is_beyond(const solid_body *b)
{
    static const double rounded = 1e-9;
    double m[3], axes[3][3];
    principal_axes(b->inertia, m, axes);
    return fmax(m[0], fmax(m[1], m[2])) > (0.5 + rounded) * (m[0] + m[1] + m[2]);
}

/* By principal axes: MuJoCo's own are exact to 1e-6 only. It refuses a moment larger than the sum of the others, as
 * that of a flat body is by rounding; one that is by more is told (put_unsaid). */
static void put_inertia(const mjcf_writer *w, const solid_body *b)
{
    double moments[3], axes[3][3];
    principal_axes(b->inertia, moments, axes);
    for (int i = 0; i < 3; i++) {
        moments[i] = fmax(moments[i], 0.0);
    }
    for (int i = 0; i < 3; i++) {
        moments[i] = fmin(moments[i], moments[(i + 1) % 3] + moments[(i + 2) % 3]);
    }
    text_add(w->out, "<inertial mass=\"%s\" pos=\"%s\" quat=\"%s\" diaginertia=\"%s\"/>\n", mjcf_number(w, b->mass),
             mjcf_numbers(w, b->centre, 3), turn_numbers(w, axes), mjcf_numbers(w, moments, 3));
}

static bool is_heavy(const mjcf_writer *w, int at)
{
    solid_body b = {.last = at};
    weigh(w, &b);
    return b.mass > 0.0;
}

/* The segment behind one without mass, if that is the only one; else -1. */
static int only_child(const mechanism *m, int at)
{
    int found = -1, count = 0;
    for (int i = at + 1; i < m->segment_count; i++) {
        found = m->segments[i].parent == at ? i : found;
        count += m->segments[i].parent == at;
    }
    return count == 1 ? found : -1;
}

bool mjcf_join_segments(mjcf_writer *w)
{
    const mechanism *m = w->m;
    for (int i = 0; i < m->segment_count; i++) {
        const segment *l = &m->segments[i];
        const seat own = seat_in_state(w, l, w->start);
        const int parent = l->parent == GROUND ? GROUND : w->body_of[l->parent];
        if (parent != GROUND && w->bodies[parent].last == l->parent && !is_heavy(w, l->parent) &&
            only_child(m, l->parent) == i) {
            solid_body *b = &w->bodies[parent];
            b->place = then(&b->place, &own);
            b->last = i;
            w->body_of[i] = parent;
            continue;
        }
        w->body_of[i] = w->count;
        w->bodies[w->count++] = (solid_body){i, i, parent, own, .mass = 0.0};
    }
    for (int i = 0; i < w->count; i++) {
        weigh(w, &w->bodies[i]);
        if (w->bodies[i].mass <= 0.0) {
            return false;
        }
    }
    return true;
}

/* The frame of a segment in that of one before it, or in the ground's. */
static seat seat_in(const mjcf_writer *w, int outer, int at, const double *x)
{
    seat result = still;
    for (int i = at; i != outer; i = w->m->segments[i].parent) {
        const seat own = seat_in_state(w, &w->m->segments[i], x);
        result = then(&own, &result);
    }
    return result;
}

/* The frame of a segment in that of its body, at the start. */
static seat in_body(const mjcf_writer *w, int at)
{
    const seat outer = seat_in(w, at, w->bodies[w->body_of[at]].last, w->start);
    seat result;
    for (int i = 0; i < 3; i++) {
        result.at[i] = 0.0;
        for (int j = 0; j < 3; j++) {
            result.turn[i][j] = outer.turn[j][i];
            result.at[i] -= outer.turn[j][i] * outer.at[j];
        }
    }
    return result;
}

static seat end_in_ground(const mjcf_writer *w, const closure_end *end, const double *x)
{
    const seat frame = seat_in(w, GROUND, end->segment, x), local = seat_of(w, end->turn, end->point);
    return then(&frame, &local);
}

static double along_axis(const mjcf_writer *w, const closure *c, const double *x)
{
    const seat from = end_in_ground(w, &c->parent, x), to = end_in_ground(w, &c->child, x);
    double along = 0.0;
    for (int k = 0; k < 3; k++) {
        along += from.turn[k][c->axis] * (to.at[k] - from.at[k]);
    }
    return along;
}

bool mjcf_stays_along(const mjcf_writer *w, const closure *c, double *result)
{
    enum { TRIALS = 5 };
    static const double golden = 0.6180339887498949;
    double *x = arena_take(w->g->memory, (size_t)state_count(w->m) + 1, sizeof *x), next = golden;
    *result = along_axis(w, c, w->start);
    bool stays = true;
    for (int trial = 0; trial < TRIALS; trial++) {
        FOR_ALL (const segment, l, w->m->segments, w->m->segment_count) {
            double size = 0.0;
            for (int k = 0; k < positions_of(l->kind); k++) {
                next += golden;
                next -= next >= 1.0 ? 1.0 : 0.0;
                x[l->position + k] = w->start[l->position + k] + next - 0.5;
                size += x[l->position + k] * x[l->position + k];
            }
            for (int k = 0; k < positions_of(l->kind) && l->kind == JOINT_SPHERICAL; k++) {
                x[l->position + k] /= sqrt(size);
            }
        }
        stays = stays && fabs(along_axis(w, c, x) - *result) < 1e-12 * (1.0 + fabs(*result));
    }
    return stays;
}

static void put_joint(const mjcf_writer *w, int i)
{
    static const char *const kinds[JOINT_KINDS] = {
        [JOINT_REVOLUTE] = "hinge", [JOINT_PRISMATIC] = "slide", [JOINT_SPHERICAL] = "ball"};
    const segment *l = &w->m->segments[i];
    const seat p = in_body(w, i);
    const joint_bounds *b = &w->bounds[i];
    const double ref = l->kind == JOINT_SPHERICAL ? 0.0 : l->start[0];
    const double attributes[6] = {
        ref, w->numbers[l->damping], w->numbers[l->spring], w->numbers[l->rest], w->numbers[l->armature], b->friction};
    static const char *const names[6] = {"ref", "damping", "stiffness", "springref", "armature", "frictionloss"};
    text_add(w->out, "<joint name=\"%s\" type=\"%s\" pos=\"%s\"", l->name, kinds[l->kind], mjcf_numbers(w, p.at, 3));
    if (l->kind != JOINT_SPHERICAL) {
        const double axis[3] = {l->sign * p.turn[0][l->axis], l->sign * p.turn[1][l->axis],
                                l->sign * p.turn[2][l->axis]};
        text_add(w->out, " axis=\"%s\"", mjcf_numbers(w, axis, 3));
    }
    for (int k = 0; k < 6; k++) {
        if (attributes[k] != 0.0) {
            text_add(w->out, " %s=\"%s\"", names[k], mjcf_number(w, attributes[k]));
        }
    }
    if (b->is_limited) {
        text_add(w->out, " range=\"%s\" limited=\"true\"", mjcf_numbers(w, (const double[]){b->lower, b->upper}, 2));
    }
    text_add(w->out, "/>\n");
}

bool mjcf_has_frame(const mjcf_writer *w, int at)
{
    return at == GROUND || w->bodies[w->body_of[at]].last == at;
}

const char *mjcf_body_name(const mjcf_writer *w, int at)
{
    return at == GROUND ? "world"
                        : arena_format(w->g->memory, "of_%s", w->m->segments[w->bodies[w->body_of[at]].last].name);
}

/* A place on the last segment of a body, or on the ground, as a site: its axes are the body's. */
static void put_site(const mjcf_writer *w, const char *called, const char *ending, int at, int on, vector point)
{
    if (on == (at == GROUND ? GROUND : w->body_of[at])) {
        text_add(w->out, "<site name=\"%s%s\" pos=\"%s\"/>\n", called, ending, mjcf_vector(w, point));
    }
}

/* The sites of both ends of a straight element between two bodies. */
static void put_ends(const mjcf_writer *w, const char *called, const closure_end *first, const closure_end *second,
                     int on)
{
    if (mjcf_has_frame(w, first->segment) && mjcf_has_frame(w, second->segment)) {
        put_site(w, called, "_first", first->segment, on, first->point);
        put_site(w, called, "_second", second->segment, on, second->point);
    }
}

static void put_sites(const mjcf_writer *w, int on)
{
    FOR_ALL (const point_spring, s, w->m->forces.springs, w->m->forces.spring_count) {
        put_ends(w, s->name, &s->first, &s->second, on);
    }
    FOR_ALL (const closure, c, w->m->closures, w->m->closure_count) {
        if (c->kind == CLOSE_DISTANCE) {
            put_ends(w, c->name, &c->parent, &c->child, on);
        }
    }
    for (int i = 0; i < w->m->forces.applied_count; i++) {
        const applied_force *f = &w->m->forces.applied[i];
        if (f->drive >= 0 && mjcf_has_frame(w, f->segment)) {
            put_site(w, w->m->inputs.all[f->drive].name, arena_format(w->g->memory, "_site%d", i), f->segment, on,
                     f->point);
        }
    }
}

/* Bodies, each within its parent: in their order, with the ends of those that it does not stand in. */
void mjcf_put_bodies(const mjcf_writer *w)
{
    bool *done = arena_take(w->g->memory, (size_t)w->count + 1, sizeof *done);
    int open = GROUND;
    put_sites(w, GROUND);
    for (;;) {
        int next = 0;
        while (next < w->count && (done[next] || w->bodies[next].parent != open)) {
            next++;
        }
        if (next == w->count && open == GROUND) {
            return;
        }
        if (next == w->count) {
            text_add(w->out, "</body>\n");
            open = w->bodies[open].parent;
            continue;
        }
        solid_body *b = &w->bodies[next];
        done[next] = true;
        open = next;
        text_add(w->out, "<body name=\"%s\" pos=\"%s\" quat=\"%s\">\n", mjcf_body_name(w, b->last),
                 mjcf_numbers(w, b->place.at, 3), turn_numbers(w, b->place.turn));
        put_inertia(w, b);
        for (int i = b->first; i <= b->last; i++) {
            if (w->body_of[i] == next) {
                put_joint(w, i);
            }
        }
        put_sites(w, next);
    }
}
