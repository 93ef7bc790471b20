/* closure NAME KIND { ... }, or close NAME KIND { ... } */
#include <stddef.h>

#include "tools/isoc/scene/take.h"

#define IN(member) offsetof(closure_statement, member)
static const property closure_properties[] = {
    {"parent", read_placement, IN(parent), BETWEEN_BODIES, "parent ground"},
    {"child", read_placement, IN(child), BETWEEN_BODIES, "child BODY"},
    {"axis", read_axis, IN(axis), WITH_AXIS, "axis z"},
    {"length", read_formula, IN(length), WITH_LENGTH, NULL},
    {"radius", read_formula, IN(radius), WITH_RADIUS, "radius 5 cm"},
    {"wheel", read_axis, IN(wheel), WITH_RADIUS, NULL},
    {"first", read_joint, IN(first), ALONG_JOINTS, "first JOINT"},
    {"second", read_joint, IN(second), WITH_RATIO, "second JOINT"},
    {"ratio", read_formula, IN(ratio), WITH_RATIO, "ratio -2"},
    {"motion", read_formula, IN(motion), WITH_MOTION, NULL},
    {"speed", read_formula, IN(speed), WITH_MOTION, NULL},
};
#undef IN

static const block closure_block = {"closure", KINDS(closure_rows), closure_traits, PROPERTIES(closure_properties)};

void read_closure(parser *p, void *slot)
{
    scene *written = slot;
    closure_statement c = {.name = take_new_name(p, "expected a name for the closure")};
    const size_t kind = p->failed ? closure_block.kind_count : parse_kind(p, &closure_block);
    c.broken = p->failed || kind == closure_block.kind_count;
    c.kind = c.broken ? CLOSE_FIXED : (closure_kind)kind;
    written->broken |= c.broken;
    c.broken |= !parse_block(p, &closure_block, kind, c.name, &c);
    LIST_ADD(p->s->memory, written->closures, c);
}
