/* spring NAME { between A at ... and B at ...; stiffness ...; damping ...; length ... } */
#include <stddef.h>

#include "tools/isoc/scene/take.h"

static void read_end(parser *p, placement *to)
{
    read_placement(p, to);
    if (to->turns.count != 0) {
        source_problem(p->s, to->turns.all[0].at, "a spring ends at a point, which cannot be turned");
    }
}

/* The slot is the spring. */
static void read_between(parser *p, void *slot)
{
    spring_statement *to = slot;
    read_end(p, &to->first);
    expect_word(p, "and", "expected 'and' and the other end: between BODY at (1, 0, 0) m and BODY");
    if (!p->failed) {
        read_end(p, &to->second);
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

static const block spring_block = {
    .what = "spring", .properties = spring_properties, .property_count = COUNT_OF(spring_properties)};

void read_spring_statement(parser *p, void *slot)
{
    scene *written = slot;
    spring_statement s = {.name = take_new_name(p, "expected a name for the spring")};
    s.broken = !parse_block(p, &spring_block, 0, s.name, &s);
    LIST_ADD(p->s->memory, written->springs, s);
}
