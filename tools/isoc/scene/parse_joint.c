/* joint NAME KIND { ... } */
#include <stddef.h>
#include <stdint.h>

#include "tools/isoc/scene/take.h"

/* Whether each turn of a start names its axis, where otherwise the joint has it; or the start is a quaternion. */
static bool starts_as_ball(joint_kind kind)
{
    return joint_parts_that(kind, JOINT_SPHERICAL) > 0;
}

/* The first part of a start that its kind of joint cannot have; NULL if there is none. */
static const place *foreign_part(joint_kind kind, const pose *start)
{
    const bool single = joint_has_one_coordinate(kind), is_ball = starts_as_ball(kind);
    const size_t most_turns = is_ball ? SIZE_MAX : single ? 0 : (size_t)joint_parts_that(kind, JOINT_REVOLUTE);
    if (start->coordinate != NULL && !single) {
        return &start->coordinate->at;
    }
    if (start->place.position != NULL && (single || joint_parts_that(kind, JOINT_PRISMATIC) == 0)) {
        return &start->place.position->at;
    }
    if (start->quaternion != NULL && !is_ball) {
        return &start->quaternion->at;
    }
    for (size_t i = 0; i < start->place.turns.count; i++) {
        const formula *axis = start->place.turns.all[i].axis;
        if (i >= most_turns) {
            return &start->place.turns.all[i].at;
        }
        if (axis != NULL && !is_ball) {
            return &axis->at;
        }
    }
    return NULL;
}

/* The slot is the joint; one of an unknown kind is broken, and may start in any way. */
static void read_start(parser *p, void *slot)
{
    joint *j = slot;
    const bool parts = next_is_word(p, "at") || next_is_word(p, "rotate") || next_is_word(p, "quaternion");
    if (parts) {
        j->start = parse_pose(p, starts_as_ball(j->kind), true);
    } else {
        j->start = (pose){.is_rough = take_word(p, "about")};
        j->start.coordinate = parse_formula(p);
    }
    const place *at = p->failed || j->broken ? NULL : foreign_part(j->kind, &j->start);
    if (at != NULL) {
        source_problem(p->s, *at, "a %s joint starts like this: %s", joint_rows[j->kind].word,
                       joint_rows[j->kind].start);
    }
    if (at != NULL || p->failed) {
        j->start = (pose){0};
    }
}

static void read_spring(parser *p, void *slot)
{
    joint *j = slot;
    read_formula(p, &j->spring);
    if (take_option(p, "rest")) {
        read_formula(p, &j->rest);
    }
}

/* spin (0, 0, 10) rad/s in ground */
static void read_spin(parser *p, void *slot)
{
    joint *j = slot;
    read_formula(p, &j->spin);
    if (take_option(p, "in")) {
        static const char *const axes[] = {"ground"};
        j->spin_axes_at = p->next->at;
        j->spin_in_ground = take_one_of(p, axes, COUNT_OF(axes)) == 0;
    }
}

static void read_continuous(parser *p, void *slot)
{
    bool *is = slot;
    (void)p;
    *is = true;
}

#define IN(member) offsetof(joint, member)
static const property joint_properties[] = {
    {"parent", read_placement, IN(parent), EVERY_KIND, "parent ground"},
    {"child", read_placement, IN(child), EVERY_KIND, "child BODY"},
    {"axis", read_axis, IN(axis), HAS_AXIS, "axis z"},
    {"second", read_axis, IN(second), HAS_SECOND, "second y"},
    {"pitch", read_formula, IN(pitch), HAS_PITCH, "pitch 5 mm"},
    {"start", read_start, 0, MOVES, NULL},
    {"speed", read_formula, IN(speed), HAS_SPEED, NULL},
    {"spin", read_spin, 0, HAS_SPIN, NULL},
    {"continuous", read_continuous, IN(continuous), TURNS_ROUND, NULL},
    {"damping", read_formula, IN(damping), HAS_SPEED, NULL},
    {"spin_damping", read_formula, IN(spin_damping), HAS_SPIN, NULL},
    {"spring", read_spring, 0, HAS_ONE_COORDINATE, NULL},
    {"armature", read_formula, IN(armature), HAS_SPEED, NULL},
    {"spin_armature", read_formula, IN(spin_armature), HAS_SPIN, NULL},
    {"drive", read_input, IN(drive), HAS_ONE_COORDINATE, NULL},
};
#undef IN

static const block joint_block = {"joint", KINDS(joint_rows), joint_traits, PROPERTIES(joint_properties)};

void read_joint_statement(parser *p, void *slot)
{
    scene *written = slot;
    joint j = {.name = take_new_name(p, "expected a name for the joint"), .kind = JOINT_REVOLUTE};
    const size_t kind = p->failed ? joint_block.kind_count : parse_kind(p, &joint_block);
    const bool known = kind < joint_block.kind_count;
    j.kind = known ? (joint_kind)kind : j.kind;
    j.broken = !known;
    j.broken |= !parse_block(p, &joint_block, kind, j.name, &j);
    if (!known) {
        /* An unknown kind counts as a joint that moves. */
        written->broken = true;
        j = (joint){.name = j.name, .kind = j.kind, .parent = j.parent, .child = j.child, .broken = true};
    }
    LIST_ADD(p->s->memory, written->joints, j);
}
