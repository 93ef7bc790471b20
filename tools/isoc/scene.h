/* A scene as it is written: what the parser understood, before names and units are looked at. */
#ifndef ISOC_SCENE_H
#define ISOC_SCENE_H

#include "tools/isoc/source.h"
#include "tools/isoc/unit.h"

typedef enum formula_kind {
    FORMULA_NUMBER, /* number, scaled by unit */
    FORMULA_NAME,
    FORMULA_VECTOR, /* parts */
    FORMULA_NEGATE, /* parts[0] */
    FORMULA_SCALE,  /* parts[0] in unit: (1, 2, 3) mm */
    FORMULA_BINARY, /* parts[0] sign parts[1] */
    FORMULA_POWER,  /* parts[0] to the number */
    FORMULA_CALL,   /* name(parts); of a table, pairs of time and value */
} formula_kind;

typedef struct formula {
    formula_kind kind;
    place at;
    double number;
    unit unit;
    const char *name;
    char sign;
    struct formula **parts;
    size_t count, room;
} formula;

/* A name as used or declared. */
typedef struct name {
    const char *text; /* NULL when it is absent */
    place at;
} name;

/* Rotations one after the other, each about an axis of the frame that the last one gave. */
typedef struct turn {
    place at;
    formula *angle;
    formula *axis;
} turn;

/* A joint's frame on a body: moved to `at`, then turned. */
typedef struct placement {
    name body;
    formula *position; /* NULL: at the body's origin */
    turn *turns;
    size_t turn_count, turn_room;
} placement;

typedef struct body {
    name name;
    formula *mass, *com, *inertia;
    bool broken; /* a property could not be read */
} body;

typedef enum joint_kind { JOINT_FIXED, JOINT_REVOLUTE, JOINT_PRISMATIC } joint_kind;

typedef struct joint {
    name name;
    joint_kind kind;
    placement parent, child;
    formula *axis, *start, *speed;
    formula *damping, *spring, *rest;
    name drive;
    bool continuous;
    place continuous_at;
    bool broken;
} joint;

typedef struct quantity {
    name name;
    formula *value; /* of an input: NULL when nothing drives it */
    formula *jump;  /* of an input: the change that starts a method anew, or NULL */
    bool tunable;
} quantity;

typedef enum output_kind {
    OUTPUT_POSITION,
    OUTPUT_SPEED,
    OUTPUT_ACCELERATION,
    OUTPUT_VELOCITY,
    OUTPUT_TURNS,
    OUTPUT_ENERGY,
    OUTPUT_LOCAL_ERROR,
    OUTPUT_RESIDUAL,
} output_kind;

typedef struct output {
    name name;
    output_kind kind;
    place kind_at;
    name of;        /* a joint or a body */
    formula *point; /* in the body's frame; NULL: its origin */
    int along;      /* 0, 1, 2: only x, y or z; -1: all three */
    place along_at;
} output;

typedef struct scene {
    const char *name;
    bool broken; /* a statement could not be read: what is missing may have stood there */
    formula *gravity, *step;
    name method, compensated, checked; /* the last two: yes or no */
    formula *iterations, *tolerance, *substeps;
    body *bodies;
    joint *joints;
    quantity *parameters, *inputs;
    output *outputs;
    size_t body_count, joint_count, parameter_count, input_count, output_count;
    size_t body_room, joint_room, parameter_room, input_room, output_room;
} scene;

#endif
