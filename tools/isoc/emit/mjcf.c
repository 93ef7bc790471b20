/* A mechanism as MJCF, the file of MuJoCo: bodies, joints, drives, springs and closures that this has too. What it has
 * not stands in a comment at the head. https://mujoco.readthedocs.io/en/stable/XMLreference.html */
#include <math.h>
#include <string.h>

#include "tools/isoc/base/numbers.h"
#include "tools/isoc/emit/emit.h"

/* A frame in another: its origin, and its axes as columns. */
typedef struct seat {
    double at[3], turn[3][3];
} seat;

/* A body of MuJoCo: the segments from `first` to `last`, of which only the last one has mass. */
typedef struct solid_body {
    int first, last, parent; /* parent: a body, or GROUND */
    seat place;              /* in the parent's */
    double mass, centre[3], inertia[6];
} solid_body;

typedef struct writer {
    const graph *g;
    const mechanism *m;
    const double *numbers; /* of all nodes at the start */
    solid_body *bodies;
    int count;
    int *of; /* [segments] their bodies */
    text *out;
} writer;

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

/* The rows of a seat, from outer axes to its own. */
static void inward_of(const seat *p, const double v[3], double result[3])
{
    for (int j = 0; j < 3; j++) {
        result[j] = p->turn[0][j] * v[0] + p->turn[1][j] * v[1] + p->turn[2][j] * v[2];
    }
}

static seat seat_of(const writer *w, matrix axes, vector at)
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

static seat still(void)
{
    return (seat){{0.0, 0.0, 0.0}, {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
}

static void put_numbers(const writer *w, const char *called, const double *x, int count)
{
    text_add(w->out, " %s=\"", called);
    for (int i = 0; i < count; i++) {
        text_add(w->out, i > 0 ? " %.17g" : "%.17g", x[i] + 0.0);
    }
    text_add(w->out, "\"");
}

static void put_turn(const writer *w, double turn[3][3])
{
    double q[4];
    quaternion_of_matrix(turn, q);
    put_numbers(w, "quat", q, 4);
}

static void put_seat(const writer *w, seat *p)
{
    put_numbers(w, "pos", p->at, 3);
    put_turn(w, p->turn);
}

/* --- bodies --- */

/* What is left of an inertia without size, about its centre. */
static const double rounding = 1e-15;

/* All that stands on a segment, from the bodies of the scene: regroup.c moves none of it. About its centre of mass. */
static void weigh(const writer *w, solid_body *b)
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

/* By principal axes: MuJoCo's own are exact to 1e-6 only. A moment larger than the sum of the others is one by
 * rounding, as that of a flat body, and MuJoCo refuses it. */
static void put_inertia(const writer *w, const solid_body *b)
{
    double moments[3], axes[3][3];
    principal_axes(b->inertia, moments, axes);
    for (int i = 0; i < 3; i++) {
        moments[i] = fmax(moments[i], 0.0);
    }
    for (int i = 0; i < 3; i++) {
        moments[i] = fmin(moments[i], moments[(i + 1) % 3] + moments[(i + 2) % 3]);
    }
    text_add(w->out, "<inertial");
    put_numbers(w, "mass", &b->mass, 1);
    put_numbers(w, "pos", b->centre, 3);
    put_turn(w, axes);
    put_numbers(w, "diaginertia", moments, 3);
    text_add(w->out, "/>\n");
}

static bool is_heavy(const writer *w, int at)
{
    double mass = 0.0;
    for (int i = 0; i < w->m->bodies.count; i++) {
        mass += w->m->bodies.frames[i].segment == at ? w->numbers[w->m->bodies.members[i].own.mass] : 0.0;
    }
    return mass > 0.0;
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

/* Returns false where a chain ends without mass: MuJoCo has no such body. */
static bool join_segments(writer *w)
{
    const mechanism *m = w->m;
    for (int i = 0; i < m->segment_count; i++) {
        const segment *l = &m->segments[i];
        const seat own = seat_of(w, l->turn, l->offset);
        const int parent = l->parent == GROUND ? GROUND : w->of[l->parent];
        if (parent != GROUND && w->bodies[parent].last == l->parent && !is_heavy(w, l->parent) &&
            only_child(m, l->parent) == i) {
            solid_body *b = &w->bodies[parent];
            b->place = then(&b->place, &own);
            b->last = i;
            w->of[i] = parent;
            continue;
        }
        w->of[i] = w->count;
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

/* The frame of a segment in that of its body, where all coordinates are zero. */
static seat in_body(const writer *w, int at)
{
    const int last = w->bodies[w->of[at]].last;
    seat outer = still();
    for (int i = last; i != at; i = w->m->segments[i].parent) {
        const seat own = seat_of(w, w->m->segments[i].turn, w->m->segments[i].offset);
        outer = then(&own, &outer);
    }
    seat result = still();
    double minus[3];
    for (int i = 0; i < 3; i++) {
        minus[i] = -outer.at[i];
        for (int j = 0; j < 3; j++) {
            result.turn[i][j] = outer.turn[j][i];
        }
    }
    inward_of(&outer, minus, result.at);
    return result;
}

static void put_joint(const writer *w, int i)
{
    static const char *const kinds[JOINT_KINDS] = {
        [JOINT_REVOLUTE] = "hinge", [JOINT_PRISMATIC] = "slide", [JOINT_SPHERICAL] = "ball"};
    const segment *l = &w->m->segments[i];
    const seat p = in_body(w, i);
    const double given[4] = {w->numbers[l->damping], w->numbers[l->spring], w->numbers[l->rest],
                             w->numbers[l->armature]};
    static const char *const names[4] = {"damping", "stiffness", "springref", "armature"};
    text_add(w->out, "<joint name=\"%s\" type=\"%s\"", l->name, kinds[l->kind]);
    put_numbers(w, "pos", p.at, 3);
    if (l->kind != JOINT_SPHERICAL) {
        const double axis[3] = {l->sign * p.turn[0][l->axis], l->sign * p.turn[1][l->axis],
                                l->sign * p.turn[2][l->axis]};
        put_numbers(w, "axis", axis, 3);
    }
    for (int k = 0; k < 4; k++) {
        if (given[k] != 0.0) {
            put_numbers(w, names[k], &given[k], 1);
        }
    }
    text_add(w->out, "/>\n");
}

/* A place on a segment or the ground, as a site. */
static void put_site(const writer *w, const char *called, const char *ending, int at, int on, vector point)
{
    if (on != (at == GROUND ? GROUND : w->of[at])) {
        return;
    }
    const seat own = {{w->numbers[point.at[0]], w->numbers[point.at[1]], w->numbers[point.at[2]]},
                      {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
    const seat base = at == GROUND ? still() : in_body(w, at);
    seat site = then(&base, &own);
    text_add(w->out, "<site name=\"%s%s\"", called, ending);
    put_seat(w, &site);
    text_add(w->out, "/>\n");
}

static void put_sites(const writer *w, int on)
{
    for (int i = 0; i < w->m->forces.spring_count; i++) {
        const point_spring *s = &w->m->forces.springs[i];
        put_site(w, s->name, "_first", s->first.segment, on, s->first.point);
        put_site(w, s->name, "_second", s->second.segment, on, s->second.point);
    }
    for (int i = 0; i < w->m->forces.applied_count; i++) {
        const applied_force *f = &w->m->forces.applied[i];
        if (f->drive >= 0) {
            put_site(w, w->m->inputs.all[f->drive].name, arena_format(w->g->memory, "_site%d", i), f->segment, on,
                     f->point);
        }
    }
}

/* Bodies, each within its parent: in their order, with the ends of those that it does not stand in. */
static void put_bodies(const writer *w)
{
    int *open = arena_take(w->g->memory, (size_t)w->count + 1, sizeof *open), depth = 0;
    bool *done = arena_take(w->g->memory, (size_t)w->count + 1, sizeof *done);
    open[0] = GROUND;
    put_sites(w, GROUND);
    for (;;) {
        int next = 0;
        while (next < w->count && (done[next] || w->bodies[next].parent != open[depth])) {
            next++;
        }
        if (next == w->count) {
            if (depth == 0) {
                return;
            }
            text_add(w->out, "</body>\n");
            depth--;
            continue;
        }
        solid_body *b = &w->bodies[next];
        done[next] = true;
        open[++depth] = next;
        text_add(w->out, "<body name=\"of_%s\"", w->m->segments[b->last].name);
        put_seat(w, &b->place);
        text_add(w->out, ">\n");
        put_inertia(w, b);
        for (int i = b->first; i <= b->last; i++) {
            if (w->of[i] == next) {
                put_joint(w, i);
            }
        }
        put_sites(w, next);
    }
}

/* --- what acts --- */

static void put_actuators(const writer *w)
{
    const mechanism *m = w->m;
    text_add(w->out, "<actuator>\n");
    for (int i = 0; i < m->segment_count; i++) {
        if (m->segments[i].drive >= 0) {
            text_add(w->out, "<motor name=\"%s_on_%s\" joint=\"%s\"/>\n", m->inputs.all[m->segments[i].drive].name,
                     m->segments[i].name, m->segments[i].name);
        }
    }
    for (int i = 0; i < m->forces.applied_count; i++) {
        const applied_force *f = &m->forces.applied[i];
        if (f->drive < 0) {
            continue;
        }
        const seat p = in_body(w, f->segment);
        double gear[6];
        for (int k = 0; k < 3; k++) {
            gear[k] = 0.0;
            for (int j = 0; j < 3; j++) {
                gear[k] += p.turn[k][j] * w->numbers[f->axis.at[j]];
            }
            gear[k + 3] = w->numbers[f->lever] * gear[k];
        }
        const char *input = m->inputs.all[f->drive].name;
        text_add(w->out, "<motor name=\"%s_force%d\" site=\"%s_site%d\"", input, i, input, i);
        put_numbers(w, "gear", gear, 6);
        text_add(w->out, "/>\n");
    }
    text_add(w->out, "</actuator>\n<tendon>\n");
    for (int i = 0; i < m->forces.spring_count; i++) {
        const point_spring *s = &m->forces.springs[i];
        text_add(w->out, "<spatial name=\"%s\"", s->name);
        put_numbers(w, "stiffness", &w->numbers[s->stiffness], 1);
        put_numbers(w, "damping", &w->numbers[s->damping], 1);
        put_numbers(w, "springlength", &w->numbers[s->length], 1);
        text_add(w->out, "><site site=\"%s_first\"/><site site=\"%s_second\"/></spatial>\n", s->name, s->name);
    }
    text_add(w->out, "</tendon>\n");
}

/* A gear that constrains positions; other closures MuJoCo has not, or holds softly where it draws them. */
static bool is_said(const closure *c)
{
    return c->kind == CLOSE_GEAR && !c->in_speed;
}

static void put_gears(const writer *w)
{
    text_add(w->out, "<equality>\n");
    for (int i = 0; i < w->m->closure_count; i++) {
        const closure *c = &w->m->closures[i];
        if (is_said(c)) {
            const double powers[5] = {w->numbers[c->length], w->numbers[c->ratio], 0.0, 0.0, 0.0};
            text_add(w->out, "<joint name=\"%s\" joint1=\"%s\" joint2=\"%s\"", c->name,
                     w->m->segments[c->parent.segment].name, w->m->segments[c->child.segment].name);
            put_numbers(w, "polycoef", powers, 5);
            text_add(w->out, "/>\n");
        }
    }
    text_add(w->out, "</equality>\n");
}

static void put_unsaid(const writer *w)
{
    text_add(w->out, "<!-- %s.scene, by isoc. Not said here: methods, outputs, what inputs are, starts", w->m->name);
    for (int i = 0; i < w->m->effects.count; i++) {
        text_add(w->out, "; the effect %s", w->m->effects.names[i].text);
    }
    for (int i = 0; i < w->m->closure_count; i++) {
        if (!is_said(&w->m->closures[i])) {
            text_add(w->out, "; the closure %s", w->m->closures[i].name);
        }
    }
    text_add(w->out, ". -->\n");
}

const char *emit_mjcf(const graph *g, const mechanism *m, text *out)
{
    const size_t n = (size_t)m->segment_count;
    writer w = {.g = g, .m = m, .numbers = numbers_at_start(g, m), .out = out};
    w.bodies = arena_take(g->memory, n, sizeof *w.bodies);
    w.of = arena_take(g->memory, n, sizeof *w.of);
    for (size_t i = 0; i < n; i++) {
        if (m->segments[i].lead != 0.0) {
            return "MuJoCo has no screw";
        }
    }
    if (!join_segments(&w)) {
        return "MuJoCo has no body without mass at the end of a chain, or with several behind it";
    }
    const double gravity[3] = {w.numbers[m->forces.gravity.at[0]], w.numbers[m->forces.gravity.at[1]],
                               w.numbers[m->forces.gravity.at[2]]};
    put_unsaid(&w);
    text_add(out, "<mujoco model=\"%s\">\n<compiler angle=\"radian\" boundinertia=\"2e-15\"/>\n<option", m->name);
    put_numbers(&w, "timestep", &m->method.step, 1);
    put_numbers(&w, "gravity", gravity, 3);
    text_add(out, "/>\n<worldbody>\n");
    put_bodies(&w);
    text_add(out, "</worldbody>\n");
    put_gears(&w);
    put_actuators(&w);
    text_add(out, "</mujoco>\n");
    return NULL;
}
