/* spring NAME { between A at ... and B at ...; ... } and force NAME { body A at ...; ... } */
#include <stddef.h>

#include "tools/isoc/scene/take.h"

/* A point of a body. */
static void read_point(parser *p, placement *to, const char *fault_of_turn)
{
    read_placement(p, to);
    if (to->turns.count != 0) {
        source_problem(p->s, to->turns.all[0].at, "%s", fault_of_turn);
    }
}

/* The slot is the spring. */
static void read_between(parser *p, void *slot)
{
    static const char fault[] = "a spring ends at a point, which cannot be turned";
    spring_statement *to = slot;
    read_point(p, &to->first, fault);
    expect_word(p, "and", "expected 'and' and the other end: between BODY at (1, 0, 0) m and BODY");
    if (!p->failed) {
        read_point(p, &to->second, fault);
    }
}

#define IN(member) offsetof(spring_statement, member)
static const property spring_properties[] = {
    {"between", read_between, 0, EVERY_KIND, "between ground at (1, 0, 0) m and BODY"},
    {"stiffness", read_formula, IN(stiffness), EVERY_KIND, NULL},
    {"damping", read_formula, IN(damping), EVERY_KIND, NULL},
    {"length", read_formula, IN(length), EVERY_KIND, NULL},
};
#undef IN

static const block spring_block = {"spring", PROPERTIES(spring_properties)};

void read_spring_statement(parser *p, void *slot)
{
    scene *written = slot;
    spring_statement s = {.name = take_new_name(p, "expected a name for the spring")};
    s.broken = !parse_block(p, &spring_block, 0, s.name, &s);
    LIST_ADD(p->s->memory, written->springs, s);
}

/* The slot is the force. */
static void read_point_of_force(parser *p, void *slot)
{
    body_force *f = slot;
    read_point(p, &f->at, "a point cannot be turned: turn the axis of the force");
}

static const property force_properties[] = {
    {"body", read_point_of_force, 0, EVERY_KIND, "body BODY at (0.2, 0, 0) m"},
    {"axis", read_axis, offsetof(body_force, axis), EVERY_KIND, "axis z"},
    {"drive", read_input, offsetof(body_force, drive), EVERY_KIND, "drive INPUT"},
    {"moment", read_formula, offsetof(body_force, moment), EVERY_KIND, NULL},
};

static const block force_block = {"force", PROPERTIES(force_properties)};

void read_force(parser *p, void *slot)
{
    scene *written = slot;
    body_force f = {.name = take_new_name(p, "expected a name for the force")};
    f.broken = !parse_block(p, &force_block, 0, f.name, &f);
    LIST_ADD(p->s->memory, written->forces, f);
}
