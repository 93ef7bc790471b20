/* A mechanism as MJCF, the file of MuJoCo: bodies, joints, drives, springs, closures and effects that this has too. The
 * others stand in a comment at the head. https://mujoco.readthedocs.io/en/stable/XMLreference.html */
#include "tools/isoc/export/mjcf.h"

/* --- drives, forces and springs --- */

static bool has_spring(const mjcf_writer *w, const point_spring *s)
{
    return mjcf_has_frame(w, s->first.segment) && mjcf_has_frame(w, s->second.segment);
}

static void put_drives(mjcf_writer *w)
{
    const mechanism *m = w->m;
    FOR_ALL (const segment, l, m->segments, m->segment_count) {
        if (l->drive >= 0) {
            text_add(&w->actuators, "<motor name=\"%s_on_%s\" joint=\"%s\"/>\n", m->inputs.all[l->drive].name, l->name,
                     l->name);
        }
    }
    for (int i = 0; i < m->forces.applied_count; i++) {
        const applied_force *f = &m->forces.applied[i];
        if (f->drive < 0 || !mjcf_has_frame(w, f->segment)) {
            continue;
        }
        double gear[6];
        for (int k = 0; k < 3; k++) {
            gear[k] = w->numbers[f->axis.at[k]];
            gear[k + 3] = w->numbers[f->lever] * gear[k];
        }
        const char *input = m->inputs.all[f->drive].name;
        text_add(&w->actuators, "<motor name=\"%s_force%d\" site=\"%s_site%d\" gear=\"%s\"/>\n", input, i, input, i,
                 mjcf_numbers(w, gear, 6));
    }
    FOR_ALL (const point_spring, s, m->forces.springs, m->forces.spring_count) {
        if (has_spring(w, s)) {
            text_add(&w->tendons,
                     "<spatial name=\"%s\" stiffness=\"%s\" damping=\"%s\" springlength=\"%s\">"
                     "<site site=\"%s_first\"/><site site=\"%s_second\"/></spatial>\n",
                     s->name, mjcf_number(w, w->numbers[s->stiffness]), mjcf_number(w, w->numbers[s->damping]),
                     mjcf_number(w, w->numbers[s->length]), s->name, s->name);
        }
    }
}

/* --- closures --- */

/* The closures that MuJoCo has as equalities, all from the start on, where they hold: a hinge is two points on its
 * axis, and a line across a plane mechanism, along which nothing moves, is a point. */
static bool is_closed(const mjcf_writer *w, const closure *c)
{
    double along;
    switch (c->kind) {
    case CLOSE_GEAR:
        return true;
    case CLOSE_SPHERICAL:
    case CLOSE_FIXED:
    case CLOSE_REVOLUTE:
    case CLOSE_DISTANCE:
    case CLOSE_LINE:
        return mjcf_has_frame(w, c->parent.segment) && mjcf_has_frame(w, c->child.segment) &&
               (c->kind != CLOSE_LINE || mjcf_stays_along(w, c, &along));
    default:
        return false;
    }
}

static void put_between(mjcf_writer *w, const closure *c, const char *word, const char *ending, const char *more)
{
    text_add(&w->equalities, "<%s name=\"%s%s\" body1=\"%s\" body2=\"%s\"%s/>\n", word, c->name, ending,
             mjcf_body_name(w, c->parent.segment), mjcf_body_name(w, c->child.segment), more);
}

/* A point of the parent's, from the origin of its frame so far along the axis. */
static void put_connect(mjcf_writer *w, const closure *c, const char *ending, double along)
{
    double at[3];
    for (int k = 0; k < 3; k++) {
        at[k] = w->numbers[c->parent.point.at[k]] + along * w->numbers[c->parent.turn.at[k][c->axis]];
    }
    put_between(w, c, "connect", ending, arena_format(w->g->memory, " anchor=\"%s\"", mjcf_numbers(w, at, 3)));
}

static void put_closure(mjcf_writer *w, const closure *c)
{
    double along = 0.0;
    switch (c->kind) {
    case CLOSE_GEAR:
        text_add(&w->equalities, "<joint name=\"%s\" joint1=\"%s\" joint2=\"%s\" polycoef=\"0 %s 0 0 0\"/>\n", c->name,
                 w->m->segments[c->parent.segment].name, w->m->segments[c->child.segment].name,
                 mjcf_number(w, w->numbers[c->ratio]));
        break;
    case CLOSE_FIXED:
        put_between(w, c, "weld", "", "");
        break;
    case CLOSE_DISTANCE:
        text_add(&w->tendons, "<spatial name=\"%s\"><site site=\"%s_first\"/><site site=\"%s_second\"/></spatial>\n",
                 c->name, c->name, c->name);
        text_add(&w->equalities, "<tendon name=\"%s\" tendon1=\"%s\"/>\n", c->name, c->name);
        break;
    case CLOSE_REVOLUTE:
        put_connect(w, c, "", 0.0);
        put_connect(w, c, "_axis", 1.0);
        break;
    case CLOSE_LINE:
        (void)mjcf_stays_along(w, c, &along);
        put_connect(w, c, "", along);
        break;
    default:
        put_connect(w, c, "", 0.0);
    }
}

/* --- the file --- */

static void put_unsaid(const mjcf_writer *w)
{
    const mechanism *m = w->m;
    text_add(w->out, "<!-- %s.scene, by isoc. Not said here: methods, outputs, what inputs are%s", m->name,
             m->bodies.vary ? ", how masses change" : "");
    for (int i = 0; i < w->count; i++) {
        if (mjcf_is_beyond(&w->bodies[i])) {
            text_add(w->out, "; the inertia of %s, whose largest moment is cut to the sum of the others",
                     mjcf_body_name(w, w->bodies[i].last));
        }
    }
    for (int i = 0; i < m->effects.count; i++) {
        if (!w->is_said[i]) {
            text_add(w->out, "; the effect %s", m->effects.names[i].text);
        }
    }
    FOR_ALL (const closure, c, m->closures, m->closure_count) {
        if (!is_closed(w, c)) {
            text_add(w->out, "; the closure %s", c->name);
        }
    }
    FOR_ALL (const point_spring, s, m->forces.springs, m->forces.spring_count) {
        if (!has_spring(w, s)) {
            text_add(w->out, "; the spring %s", s->name);
        }
    }
    FOR_ALL (const applied_force, f, m->forces.applied, m->forces.applied_count) {
        if (f->drive >= 0 && !mjcf_has_frame(w, f->segment)) {
            text_add(w->out, "; the force of %s", m->inputs.all[f->drive].name);
        }
    }
    text_add(w->out, ". -->\n");
}

static void put_group(const mjcf_writer *w, const char *called, const text *members)
{
    if (members->length > 0) {
        text_add(w->out, "<%s>\n%s</%s>\n", called, members->bytes, called);
    }
}

const char *emit_mjcf(graph *g, const mechanism *m, text *out)
{
    const size_t n = (size_t)m->segment_count;
    const text empty = {.memory = g->memory};
    mjcf_writer w = {.g = g, .m = m, .out = out, .tendons = empty, .actuators = empty, .equalities = empty};
    w.numbers = numbers_at_start(g, m);
    w.start = mechanism_start(m, g->memory);
    w.bodies = arena_take(g->memory, n, sizeof *w.bodies);
    w.body_of = arena_take(g->memory, n, sizeof *w.body_of);
    w.bounds = arena_take(g->memory, n, sizeof *w.bounds);
    w.is_said = arena_take(g->memory, (size_t)m->effects.count + 1, sizeof *w.is_said);
    for (size_t i = 0; i < n; i++) {
        if (m->segments[i].lead != 0.0) {
            return "MuJoCo has no screw";
        }
    }
    if (!mjcf_join_segments(&w)) {
        return "MuJoCo has no body without mass at the end of a chain, or with several behind it";
    }
    mjcf_say_effects(&w);
    put_drives(&w);
    FOR_ALL (const closure, c, m->closures, m->closure_count) {
        if (is_closed(&w, c)) {
            put_closure(&w, c);
        }
    }
    put_unsaid(&w);
    text_add(out,
             "<mujoco model=\"%s\">\n<compiler angle=\"radian\" boundinertia=\"2e-15\"/>\n"
             "<option timestep=\"%s\" gravity=\"%s\"/>\n<worldbody>\n",
             m->name, mjcf_number(&w, m->method.step), mjcf_vector(&w, m->forces.gravity));
    mjcf_put_bodies(&w);
    text_add(out, "</worldbody>\n");
    put_group(&w, "equality", &w.equalities);
    put_group(&w, "tendon", &w.tendons);
    put_group(&w, "actuator", &w.actuators);
    text_add(out, "</mujoco>\n");
    return NULL;
}
