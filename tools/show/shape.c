#include "tools/show/show.h"

#include <string.h>

#include "tools/isoc/scene/closure_kinds.h"
#include "tools/isoc/scene/joint_kinds.h"

/* The cells of a line are read one after the other. */
typedef struct cells {
    const table *source;
    size_t row, next;
} cells;

static const char *word(cells *c)
{
    return table_text(c->source, c->row, c->next++);
}

static double number(cells *c)
{
    return table_number(c->source, c->row, c->next++);
}

static vec vector(cells *c)
{
    const double x = number(c), y = number(c), z = number(c);
    return (vec){x, y, z};
}

static pose frame(cells *c)
{
    pose p;
    p.at = vector(c);
    for (int i = 0; i < 3; i++) {
        p.row[i] = vector(c);
    }
    return p;
}

static spot place(cells *c)
{
    const int body = (int)number(c);
    return (spot){body, frame(c)};
}

static void read_solid(shape *s, cells *c)
{
    shape_solid *to = &s->solid[s->solids++];
    to->at.body = (int)number(c);
    to->kind = word(c);
    to->at.frame = frame(c);
    for (int i = 0; i < 3; i++) {
        to->size[i] = number(c);
    }
}

static void read_lump(shape *s, cells *c)
{
    shape_lump *to = &s->lump[s->lumps++];
    to->body = (int)number(c);
    to->centre = vector(c);
    to->mass = number(c);
    for (int i = 0; i < 6; i++) {
        to->inertia[i] = number(c);
    }
}

/* By the moves of its chain. A joint that slides in several directions holds its child at no place. */
static marker marker_of_joint(joint_kind kind)
{
    const int slides = joint_parts_that(kind, JOINT_PRISMATIC), turns = joint_parts_that(kind, JOINT_REVOLUTE);
    return slides > 1                                                 ? MARKER_NONE
           : slides == 1                                              ? (turns == 0 ? MARKER_SLIDE : MARKER_SLEEVE)
           : turns > 1 || joint_parts_that(kind, JOINT_SPHERICAL) > 0 ? MARKER_BALL
           : turns == 1                                               ? MARKER_PIN
                                                                      : MARKER_BLOCK;
}

/* By what it holds. */
static marker marker_of_closure(closure_kind kind)
{
    const unsigned holds = closure_rows[kind].holds, turns = holds & (HOLDS_TURN | HOLDS_AXIS);
    return (holds & HOLDS_DISTANCE) != 0  ? MARKER_BAR
           : (holds & HOLDS_ROLLING) != 0 ? MARKER_WHEEL
           : turns == HOLDS_TURN          ? ((holds & HOLDS_ON_LINE) != 0 ? MARKER_SLIDE : MARKER_BLOCK)
           : (holds & HOLDS_ON_LINE) != 0 ? (turns == HOLDS_AXIS ? MARKER_SLEEVE : MARKER_PIN)
           : turns == HOLDS_AXIS          ? MARKER_PIN
                                          : MARKER_BALL;
}

/* Of a word in the tables of isoc. */
static marker read_marker(cells *c, bool is_closure)
{
    const char *kind = word(c);
    for (int i = 0; i < (is_closure ? (int)CLOSURE_ROWS : (int)JOINT_KINDS); i++) {
        if (strcmp(is_closure ? closure_rows[i].word : joint_rows[i].word, kind) == 0) {
            return is_closure ? marker_of_closure((closure_kind)i) : marker_of_joint((joint_kind)i);
        }
    }
    quit("show: no %s is called '%s'", is_closure ? "closure" : "joint", kind);
}

static void read_joint(shape *s, cells *c, bool is_closure)
{
    shape_joint *to = &s->joint[s->joints++];
    (void)word(c); /* its name */
    to->marker = read_marker(c, is_closure);
    to->parent = place(c);
    to->child = place(c);
    to->axis = vector(c);
    const double last = number(c);
    to->is_closure = is_closure;
    to->has_spring = !is_closure && last != 0.0;
    to->radius = is_closure ? last : 0.0;
    to->axle = vector(c);
}

static void read_effect(shape *s, cells *c)
{
    enum { CELLS_OF_A_PLACE = 13 };
    shape_effect *to = &s->effect[s->effects++];
    (void)word(c);
    to->kind = word(c);
    to->radius = number(c);
    while (c->next + CELLS_OF_A_PLACE <= table_cells(c->source, c->row) && to->points < MOST_POINTS) {
        to->at[to->points++] = place(c);
    }
}

static void read_line(shape *s, cells *c)
{
    const char *kind = word(c);
    if (strcmp(kind, "scene") == 0) {
        s->name = word(c);
    } else if (strcmp(kind, "gravity") == 0) {
        s->gravity = vector(c);
    } else if (strcmp(kind, "body") == 0) {
        s->body[s->bodies++] = word(c);
    } else if (strcmp(kind, "solid") == 0) {
        read_solid(s, c);
    } else if (strcmp(kind, "lump") == 0) {
        read_lump(s, c);
    } else if (strcmp(kind, "joint") == 0 || strcmp(kind, "closure") == 0) {
        read_joint(s, c, kind[0] == 'c');
    } else if (strcmp(kind, "spring") == 0) {
        (void)word(c);
        s->spring[s->springs].first = place(c);
        s->spring[s->springs++].second = place(c);
    } else if (strcmp(kind, "force") == 0) {
        shape_force *to = &s->force[s->forces++];
        (void)word(c);
        to->input = word(c);
        to->at = place(c);
        to->axis = vector(c);
        to->moment = number(c);
    } else if (strcmp(kind, "effect") == 0) {
        read_effect(s, c);
    } else if (strcmp(kind, "point") == 0) {
        s->point[s->points].name = word(c);
        s->point[s->points++].at = place(c);
    }
}

/* Each list has room for as many as there are lines. The words stay in the memory of the table. */
shape shape_read(const char *path)
{
    const table text = table_read(path, '\t');
    const size_t rows = text.rows + 1;
    shape s = {.name = NULL};
    s.body = memory_for(rows, sizeof *s.body);
    s.solid = memory_for(rows, sizeof *s.solid);
    s.lump = memory_for(rows, sizeof *s.lump);
    s.joint = memory_for(rows, sizeof *s.joint);
    s.spring = memory_for(rows, sizeof *s.spring);
    s.force = memory_for(rows, sizeof *s.force);
    s.effect = memory_for(rows, sizeof *s.effect);
    s.point = memory_for(rows, sizeof *s.point);
    for (size_t row = 0; row < text.rows; row++) {
        cells c = {&text, row, 0};
        read_line(&s, &c);
    }
    if (s.name == NULL || s.bodies == 0) {
        quit("show: %s has no bodies, so that nothing is to be shown; isochron plot draws the outputs", path);
    }
    return s;
}
