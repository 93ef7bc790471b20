/* The kinds of joints: each is a chain of elementary joints, which slide along an axis, turn about an axis, or turn
 * freely. One row defines a kind; the properties of its joints follow from the chain. */
#ifndef ISOC_SCENE_JOINT_KINDS_H
#define ISOC_SCENE_JOINT_KINDS_H

#include <stdbool.h>
#include <stddef.h>

typedef enum joint_kind {
    JOINT_FIXED,
    JOINT_REVOLUTE,
    JOINT_PRISMATIC,
    JOINT_SCREW,
    JOINT_UNIVERSAL,
    JOINT_CYLINDRICAL,
    JOINT_PLANAR,
    JOINT_SPHERICAL,
    JOINT_FREE,
    JOINT_KINDS
} joint_kind;

/* The axis that a part slides along or turns about. */
typedef enum part_axis {
    NO_AXIS,
    ALONG_AXIS, /* the joint's `axis` */
    ALONG_SECOND,
    ACROSS_AXIS, /* the two directions that make a right-handed frame with `axis` */
    ACROSS_BOTH,
    ALONG_X, /* of the joint's frame on the parent */
    ALONG_Y,
    ALONG_Z,
} part_axis;

typedef struct joint_part {
    joint_kind kind; /* JOINT_PRISMATIC, JOINT_REVOLUTE or JOINT_SPHERICAL; JOINT_FIXED: the chain has ended */
    part_axis axis;
    const char *ending; /* of its name; NULL: _x, _y or _z, the axis of the joint's frame that it slides along */
    bool advances;      /* a turn that slides it along its axis, by the `pitch` of the joint */
} joint_part;

enum { PARTS_OF_A_JOINT = 4 };

typedef struct joint_row {
    const char *word;
    const char *start; /* an example of a start */
    joint_part parts[PARTS_OF_A_JOINT + 1];
} joint_row;

extern const joint_row joint_rows[JOINT_KINDS];

/* The number of parts, and of those of one elementary kind. */
int joint_parts_count(joint_kind kind);
int joint_parts_that(joint_kind kind, joint_kind elementary);

/* Whether it is an elementary joint of one coordinate. */
bool joint_has_one_coordinate(joint_kind kind);

/* The traits of a kind; a property needs one of them. */
enum {
    ANY_JOINT = 1,
    MOVES = 2,
    HAS_AXIS = 4,
    HAS_SECOND = 8,
    HAS_SPEED = 16, /* slides, or has one coordinate */
    HAS_SPIN = 32,  /* turns, and has more than one coordinate */
    HAS_ONE_COORDINATE = 64,
    TURNS_ROUND = 128, /* its only coordinate is an angle, and a whole turn changes nothing */
    HAS_PITCH = 256,
};

/* The traits of a kind, combined. */
unsigned joint_traits(size_t kind);

#endif
