/* joint NAME KIND { ... } */
#include <stddef.h>

#include "tools/isoc/scene/formula.h"
#include "tools/isoc/scene/parser.h"
#include "tools/isoc/scene/pose.h"
#include "tools/isoc/scene/statements.h"

const char *const joint_kinds[] = {"fixed",       "revolute", "prismatic", "universal",
                                   "cylindrical", "planar",   "spherical", "free"};

enum {
    FIXED = 1 << JOINT_FIXED,
    REVOLUTE = 1 << JOINT_REVOLUTE,
    PRISMATIC = 1 << JOINT_PRISMATIC,
    UNIVERSAL = 1 << JOINT_UNIVERSAL,
    CYLINDRICAL = 1 << JOINT_CYLINDRICAL,
    PLANAR = 1 << JOINT_PLANAR,
    SPHERICAL = 1 << JOINT_SPHERICAL,
    FREE = 1 << JOINT_FREE,

    ONE_COORDINATE = REVOLUTE | PRISMATIC,
    WITH_AXIS = ONE_COORDINATE | UNIVERSAL | CYLINDRICAL | PLANAR,
    WITH_SPEED = ONE_COORDINATE | CYLINDRICAL | PLANAR | FREE,
    WITH_SPIN = UNIVERSAL | CYLINDRICAL | PLANAR | SPHERICAL | FREE,
};

/* What the start of each kind is made of. */
typedef struct start_form {
    bool coordinate, position, quaternion;
    bool own_axes; /* each turn names its axis; otherwise the joint has it */
    size_t most_turns;
    const char *example;
} start_form;

static const start_form forms[] = {
    [JOINT_REVOLUTE] = {.coordinate = true, .example = "start 10 deg"},
    [JOINT_PRISMATIC] = {.coordinate = true, .example = "start 10 mm"},
    [JOINT_UNIVERSAL] = {.most_turns = 2, .example = "start rotate 10 deg rotate 20 deg"},
    [JOINT_CYLINDRICAL] = {.position = true, .most_turns = 1, .example = "start at 10 mm rotate 20 deg"},
    [JOINT_PLANAR] = {.position = true, .most_turns = 1, .example = "start at (1, 2, 0) m rotate 20 deg"},
    [JOINT_SPHERICAL] = {.quaternion = true,
                         .own_axes = true,
                         .most_turns = SIZE_MAX,
                         .example = "start rotate 30 deg about x rotate 10 deg about z"},
    [JOINT_FREE] = {.position = true,
                    .quaternion = true,
                    .own_axes = true,
                    .most_turns = SIZE_MAX,
                    .example = "start at (0, 0, 1) m rotate 30 deg about x"},
};

/* The first part of a start that its joint cannot have; NULL: none. */
static const place *foreign_part(const start_form *form, const pose *start)
{
    if (start->coordinate != NULL && !form->coordinate) {
        return &start->coordinate->at;
    }
    if (start->position != NULL && !form->position) {
        return &start->position->at;
    }
    if (start->quaternion != NULL && !form->quaternion) {
        return &start->quaternion->at;
    }
    for (size_t i = 0; i < start->turn_count; i++) {
        const formula *axis = start->turns[i].axis;
        if (i >= form->most_turns) {
            return &start->turns[i].at;
        }
        if (axis != NULL && !form->own_axes) {
            return &axis->at;
        }
    }
    return NULL;
}

/* The slot is the joint; one of an unknown kind is broken, and may start in any way. */
static void read_start(parser *p, const token *word, void *slot)
{
    (void)word;
    joint *j = slot;
    const start_form *form = &forms[j->kind];
    const bool parts = next_is_word(p, "at") || next_is_word(p, "rotate") || next_is_word(p, "quaternion");
    if (parts) {
        j->start = parse_pose(p, form->own_axes);
    } else {
        j->start = (pose){.is_rough = take_word(p, "about")};
        j->start.coordinate = parse_formula(p);
    }
    const place *at = p->failed || j->broken ? NULL : foreign_part(form, &j->start);
    if (at != NULL) {
        source_problem(p->s, *at, "a %s joint starts like this: %s", joint_kinds[j->kind], form->example);
    }
    if (at != NULL || p->failed) {
        j->start = (pose){0};
    }
}

static void read_spring(parser *p, const token *word, void *slot)
{
    joint *j = slot;
    read_formula(p, word, &j->spring);
    if (!p->failed && take_word(p, "rest")) {
        read_formula(p, word, &j->rest);
    }
}

static void read_continuous(parser *p, const token *word, void *slot)
{
    (void)p;
    joint *j = slot;
    j->continuous = true;
    j->continuous_at = word->at;
}

#define IN(member) offsetof(joint, member)
static const property properties[] = {
    {"parent", read_placement, IN(parent), EVERY_KIND, "parent ground"},
    {"child", read_placement, IN(child), EVERY_KIND, "child BODY"},
    {"axis", read_axis, IN(axis), WITH_AXIS, "axis z"},
    {"second", read_axis, IN(second), UNIVERSAL, "second y"},
    {"start", read_start, 0, EVERY_KIND & ~FIXED, NULL},
    {"speed", read_formula, IN(speed), WITH_SPEED, NULL},
    {"spin", read_formula, IN(spin), WITH_SPIN, NULL},
    {"continuous", read_continuous, 0, REVOLUTE, NULL},
    {"damping", read_formula, IN(damping), WITH_SPEED, NULL},
    {"spin_damping", read_formula, IN(spin_damping), WITH_SPIN, NULL},
    {"spring", read_spring, 0, ONE_COORDINATE, NULL},
    {"drive", read_input, IN(drive), ONE_COORDINATE, NULL},
};
#undef IN

static const block joint_block = {"joint", joint_kinds, COUNT_OF(joint_kinds), properties, COUNT_OF(properties)};

void read_joint_statement(parser *p, const token *word, void *slot)
{
    (void)word;
    scene *made = slot;
    joint j = {.name = take_new_name(p, "expected a name for the joint"), .kind = JOINT_REVOLUTE};
    const size_t kind = p->failed ? joint_block.kind_count : parse_kind(p, &joint_block);
    const bool known = kind < joint_block.kind_count;
    j.kind = known ? (joint_kind)kind : j.kind;
    j.broken = !known;
    j.broken |= p->failed || !parse_block(p, &joint_block, kind, j.name, &j);
    if (!known) {
        /* What is unknown counts as a joint that moves. */
        made->broken = true;
        j = (joint){.name = j.name, .kind = j.kind, .parent = j.parent, .child = j.child, .broken = true};
    }
    made->joints = arena_grow(p->s->memory, made->joints, made->joint_count, &made->joint_room, sizeof j);
    made->joints[made->joint_count++] = j;
}
