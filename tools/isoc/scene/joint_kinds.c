#include "tools/isoc/scene/joint_kinds.h"

/* A part, named by its first member: members that are not named behind it are zero. */
#define SLIDE .kind = JOINT_PRISMATIC
#define TURN .kind = JOINT_REVOLUTE
#define BALL .kind = JOINT_SPHERICAL
const joint_row joint_rows[JOINT_KINDS] = {
    [JOINT_FIXED] = {"fixed", NULL, {{0}}},
    [JOINT_REVOLUTE] = {"revolute", "start 10 deg", {{TURN, ALONG_AXIS, ""}}},
    [JOINT_PRISMATIC] = {"prismatic", "start 10 mm", {{SLIDE, ALONG_AXIS, ""}}},
    [JOINT_SCREW] = {"screw", "start 10 deg", {{TURN, ALONG_AXIS, "", .advances = true}}},
    [JOINT_UNIVERSAL] = {"universal",
                         "start rotate 10 deg rotate 20 deg",
                         {{TURN, ALONG_AXIS, "_first"}, {TURN, ALONG_SECOND, "_second"}}},
    [JOINT_CYLINDRICAL] = {"cylindrical",
                           "start at 10 mm rotate 20 deg",
                           {{SLIDE, ALONG_AXIS, "_slide"}, {TURN, ALONG_AXIS, "_turn"}}},
    [JOINT_PLANAR] = {"planar",
                      "start at (1, 2, 0) m rotate 20 deg",
                      {{SLIDE, ACROSS_AXIS, NULL}, {SLIDE, ACROSS_BOTH, NULL}, {TURN, ALONG_AXIS, "_turn"}}},
    [JOINT_SPHERICAL] = {"spherical", "start rotate 30 deg about x rotate 10 deg about z", {{BALL, NO_AXIS, ""}}},
    [JOINT_FREE] = {"free",
                    "start at (0, 0, 1) m rotate 30 deg about x",
                    {{SLIDE, ALONG_X, "_x"}, {SLIDE, ALONG_Y, "_y"}, {SLIDE, ALONG_Z, "_z"}, {BALL, NO_AXIS, "_turn"}}},
};
#undef SLIDE
#undef TURN
#undef BALL

int joint_parts_count(joint_kind kind)
{
    int count = 0;
    while (joint_rows[kind].parts[count].kind != JOINT_FIXED) {
        count++;
    }
    return count;
}

int joint_parts_that(joint_kind kind, joint_kind elementary)
{
    int count = 0;
    for (const joint_part *part = joint_rows[kind].parts; part->kind != JOINT_FIXED; part++) {
        count += part->kind == elementary;
    }
    return count;
}

bool joint_has_one_coordinate(joint_kind kind)
{
    return joint_parts_count(kind) == 1 && joint_rows[kind].parts[0].kind != JOINT_SPHERICAL;
}

unsigned joint_traits(size_t kind)
{
    const bool single = joint_has_one_coordinate((joint_kind)kind);
    unsigned traits = ANY_JOINT | (single ? HAS_ONE_COORDINATE | HAS_SPEED : 0U);
    for (const joint_part *part = joint_rows[kind].parts; part->kind != JOINT_FIXED; part++) {
        const bool slides = part->kind == JOINT_PRISMATIC;
        traits |= MOVES | (slides ? HAS_SPEED : !single ? HAS_SPIN : part->advances ? 0U : TURNS_ROUND);
        traits |= part->advances ? HAS_PITCH : 0U;
        traits |= part->axis == ALONG_SECOND ? HAS_SECOND : 0U;
        traits |= part->axis == ALONG_AXIS || part->axis == ACROSS_AXIS || part->axis == ACROSS_BOTH ? HAS_AXIS : 0U;
    }
    return traits;
}
