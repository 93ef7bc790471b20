/* A scene as it is written: the result of the parser, before names and units are resolved. */
#ifndef ISOC_SCENE_SCENE_H
#define ISOC_SCENE_SCENE_H

#include <string.h>

#include "tools/isoc/scene/closure_kinds.h"
#include "tools/isoc/scene/joint_kinds.h"
#include "tools/isoc/scene/quantities.h"
#include "tools/isoc/scene/source.h"

typedef enum formula_kind {
    FORMULA_NUMBER, /* number, scaled by unit */
    FORMULA_NAME,
    FORMULA_VECTOR, /* parts */
    FORMULA_NEGATE, /* parts[0] */
    FORMULA_SCALE,  /* parts[0] in unit: (1, 2, 3) mm */
    FORMULA_CHAIN,  /* of a first part and steps, from left to right: a + b - c */
    FORMULA_STEP,   /* sign parts[0] */
    FORMULA_POWER,  /* parts[0] to the power parts[1] */
    FORMULA_ORDER,  /* parts[0] sign parts[1]; with the number 1, also equal: a <= b; with the sign =: a == b */
    FORMULA_LOGIC,  /* conditions: parts[0] sign parts[1], the sign & or |; or ~ parts[0] */
    FORMULA_CALL,   /* name(parts); of a table or a ramp, pairs of time and value; with the number 1 after a quantity,
                     * with 2 after two quantities lines of places and of a place and values */
    FORMULA_FILE,   /* a column, number, of the file: pairs of time and value */
    FORMULA_OF,     /* name, a word such as speed, of the joint or body that parts[0] names; beside it by parts[1] */
} formula_kind;

/* Whether it is there, and is this word. */
static inline bool name_is(name n, const char *called)
{
    return n.text != NULL && called != NULL && strcmp(n.text, called) == 0;
}

typedef struct formula {
    formula_kind kind;
    place at;
    double number;
    unit unit;
    const char *name;
    char sign;
    bool is_smooth;     /* of a table */
    name beyond;        /* likewise: held, linear or error; NULL: held */
    const script *file; /* of FORMULA_FILE; its text stands at `text_at` */
    place text_at;
    name axes;  /* of FORMULA_OF: body or ground; NULL where none are given */
    name along; /* likewise: x, y or z; NULL: the whole vector */
    struct formula **parts;
    size_t count, room;
} formula;

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
    LIST_OF(turn) turns;
} placement;

/* A kind of solids; parse_body.c has all of them. */
typedef struct solid_row {
    const char *word, *example;
    int numbers; /* that its size has; 0: three or six */
    bool hollow; /* its second radius is within the first */
    /* The principal moments of inertia about the centre, over the mass, as factors of the squares of the size's
     * numbers: sum over n of [axis][n] size[n]^2. Those of a lump are its size. */
    double moments[3][3];
} solid_row;

/* A part of a body: a homogeneous solid of the kind that its word names, or a lump with an inertia of its own. */
typedef struct solid {
    const solid_row *kind;
    formula *size, *mass;
    placement at;     /* of its centre, on no body by name */
    bool is_as_given; /* of a lump: its inertia may be one that no body has */
} solid;

typedef struct body {
    name name;
    formula *mass, *com, *inertia;
    placement inertia_axes; /* turns only */
    bool is_as_given;       /* likewise */
    LIST_OF(solid) solids;  /* instead of the three */
} body;

/* A place on a body, with axes of its own, that can stand wherever a body can. */
typedef struct named_frame {
    name name;
    placement on; /* a body, the ground, or another frame */
} named_frame;

/* Where a joint starts: a coordinate alone, or a place and turns, or a place and a quaternion (w, x, y, z). */
typedef struct pose {
    formula *coordinate;
    bool is_rough;   /* about ...: the assembly searches from there */
    placement place; /* on no body by name; the axis of a turn is NULL where the joint has it */
    formula *quaternion;
} pose;

typedef struct joint {
    name name;
    joint_kind kind;
    placement parent, child;
    formula *axis, *second, *pitch;
    pose start;
    formula *speed, *spin; /* spin: angular velocity of a joint of several coordinates; speed: of all others */
    bool spin_in_ground;   /* in the axes of the ground, not of the child */
    place spin_axes_at;
    formula *damping, *spin_damping, *spring, *rest, *armature, *spin_armature;
    name drive;
    bool continuous;
    bool broken;
} joint;

/* A loop closure: a constraint between two bodies, or between two joints, beside the joints of the tree. */
typedef struct closure_statement {
    name name;
    closure_kind kind;
    placement parent, child;
    formula *axis, *length, *radius, *wheel, *ratio, *motion, *speed;
    name first, second; /* joints */
    bool broken;
} closure_statement;

/* A spring and damper between two points. */
typedef struct spring_statement {
    name name;
    placement first, second;
    formula *stiffness, *damping, *length;
    bool broken;
} spring_statement;

/* A force of an input on a point of a body, along an axis of the body; with `moment` metres of lever about that axis.
 */
typedef struct body_force {
    name name;
    placement at;
    formula *axis, *moment;
    name drive;
    bool broken;
} body_force;

/* The removal of the drift off the closures. */
typedef struct stabilisation {
    name kind;                     /* baumgarte, projection, lagrangian, none */
    formula *alpha, *beta;         /* 1/s, of baumgarte */
    formula *iterations;           /* of projection and lagrangian */
    formula *penalty, *omega, *mu; /* of lagrangian: kg, 1/s, a number */
    formula *limit;                /* of the violation, in m or rad: above it a tick is counted */
    name near;                     /* count, stop, hold: a tick near a singular position; NULL as text: count */
} stabilisation;

/* every PERIOD [at PHASE] { ... }: what stands in it is computed in the rows of this rate alone. */
typedef struct rate_block {
    place at;
    formula *period, *phase; /* NULL: no phase */
} rate_block;

typedef struct quantity {
    name name;
    formula *value;  /* of an input: NULL when nothing drives it */
    formula *stated; /* of a constant or tunable that --set sets: the scene's own value; else NULL */
    formula *jump;   /* of an input: the change that restarts a method, or NULL */
    unit unit;       /* of an input that has_unit */
    bool has_unit;
    formula *least, *most; /* of a tunable or an input: in LEAST to MOST, or NULL */
    formula *safe,
        *after; /* of an input: its safe value, and the number of ticks without a value from the link; or NULL */
    bool tunable;
    formula *point;          /* of an operand that is a body: NAME at POINT */
    bool smooth;             /* an input that is a sample of a continuous signal; otherwise it is held over a step */
    bool left_out;           /* a signal that nothing reads once effects are left out */
    const rate_block *block; /* of a signal: that it stands in, or NULL */
} quantity;

/* The kinds of lines of an effect. The operands come first. */
typedef enum effect_line_kind {
    EFFECT_JOINT,
    EFFECT_BODY,   /* a point of it */
    EFFECT_SIGNAL, /* a number that may change at any time */
    EFFECT_VALUE,  /* a constant or a tunable */
    EFFECT_FAULT,  /* a tunable of its own: 0 or 1 */
    EFFECT_LET,
    EFFECT_STATE,  /* value: at the start */
    EFFECT_RATE,   /* of the state that it names */
    EFFECT_MEMORY, /* value: at the start */
    EFFECT_NEXT,   /* of the memory that it names */
    EFFECT_EFFORT, /* on the joint that it names */
    EFFECT_FORCE,  /* on the body that it names, a vector in the axes of the ground */
    EFFECT_MOMENT,
    EFFECT_ENERGY, /* that it stores */
    EFFECT_LOSS,   /* the power that it turns into heat */
    EFFECT_WORK,   /* the power that it takes from outside the mechanism */
    EFFECT_OUTPUT,
    EFFECT_REQUIRE,  /* value and most: the second is not less than the first */
    EFFECT_MODE,     /* only while it is read: the line is a state without a rate, with the choices as lets */
    EFFECT_WHEN,     /* value: the condition */
    EFFECT_HOLD,     /* its mode is a line of its own */
    EFFECT_PART,     /* an effect in the effect */
    EFFECT_FUNCTION, /* of its arguments */
} effect_line_kind;

/* set NAME = VALUE; set speed of JOINT = VALUE, or its position. */
typedef struct set_statement {
    name what;         /* a mode or a state; or the joint or the body */
    const char *which; /* speed or position, of a joint; velocity, of a body; else NULL */
    formula *along;    /* of a velocity: which component */
    formula *value;
} set_statement;

/* when CONDITION { set ... } */
typedef struct when_statement {
    place at;
    formula *condition;
    LIST_OF(set_statement) sets;
} when_statement;

/* hold NAME on JOINT up to LIMIT then SLIDING; or between JOINT and JOINT */
typedef struct hold_statement {
    name name;
    name on, against;         /* against NULL: the joint alone */
    formula *limit, *sliding; /* sliding NULL: the same as limit */
} hold_statement;

typedef struct effect_line {
    effect_line_kind kind;
    name name;
    place at;
    name like, like_of; /* effort, speed or position, of a joint: its unit */
    int parts;          /* numbers: 1; of a state or a memory that starts with a vector 3 */
    bool is_mode;       /* of a state: a whole number, which events alone change */
    bool is_bounded;    /* of a joint: it must not be continuous */
    bool is_external;   /* of a signal: it asks nothing of the mechanism */
    bool in_body;       /* of a force or a moment: in the axes of the body, not of the ground */
    name against;       /* of a force or a moment: the body that it pushes the other way; or NULL */
    bool has_unit;
    unit unit;
    bool is_strict;          /* of a require: less than `most`, not equal */
    formula *value, *most;   /* NULL where none is given */
    when_statement *when;    /* of EFFECT_WHEN */
    struct effect_use *part; /* of EFFECT_PART: its use, as it is written */
    LIST_OF(name) arguments; /* of EFFECT_FUNCTION */
    bool is_constant;        /* of a let: it follows from constants alone */
    const rate_block *block; /* that it stands in, or NULL */
    hold_statement *hold;    /* of EFFECT_HOLD */
} effect_line;

/* The modes and the events of the scene, and what a step does about events: events NUMBER [rest METHOD]. */
typedef struct event_statements {
    LIST_OF(quantity) modes;
    LIST_OF(when_statement) whens;
    LIST_OF(hold_statement) holds; /* their modes are among the modes */
    formula *slots;                /* events in a step; NULL: 1 */
    name rest;                     /* the method of the rest of a step behind one */
} event_statements;

/* effect KIND { ... }: the equations of one effect. */
typedef struct effect_kind {
    name name;
    effect_line *lines;
    size_t line_count, line_room;
    bool broken;
} effect_kind;

/* effect NAME KIND { operand value ... }; or in a definition part NAME KIND { ... }, of which each use of the
 * definition makes a use of its own, EFFECT.NAME. */
typedef struct effect_use {
    name name;
    const char *symbol; /* the name with _ for each point */
    int outer;          /* of a part: the use that has it, before this one; -1: it is the scene's own */
    place used_at;      /* in the scene, by itself or by that which has it */
    name kind;
    quantity *operands; /* each with its name and value */
    size_t operand_count, operand_room;
    formula *substeps;       /* of its states in a step; NULL: none of its own */
    const rate_block *block; /* of the scene, that it stands in, or NULL */
    bool broken;
    bool is_trial; /* of a definition alone: its operands are any numbers, and need not be what it requires */
    bool left_out; /* it does nothing, and its quantities are zero */
    bool dropped;  /* the same for some rungs of a ladder: its states and memories stay where they are */
} effect_use;

/* at TIME set NAME = VALUE: the value of a tunable, or a fault, from then on. */
typedef struct setting {
    name what; /* begins a struct with a name: EFFECT.FAULT, or a tunable */
    formula *time, *value;
} setting;

typedef struct output {
    name name;
    formula *formula;        /* a quantity alone, or any other */
    formula *every;          /* ticks; NULL: each */
    const rate_block *block; /* likewise */
} output;

/* The policies of the loop on ticks that do not keep their time. */
typedef enum overrun_kind { OVERRUN_COUNT, OVERRUN_CATCH_UP, OVERRUN_STOP, OVERRUN_DEGRADE } overrun_kind;

typedef enum rung_kind { RUNG_METHOD, RUNG_DROP, RUNG_HOLD } rung_kind;

enum { MOST_RUNGS = 8 };

typedef struct policy_statement {
    overrun_kind overrun;
    place overrun_at, publish_at, histogram_at;
    formula *catch_up, *grace; /* ticks; NULL where none is given */
    name rungs[MOST_RUNGS];    /* of degrade, in their order: a method, an effect, or the word `hold` */
    rung_kind rung_kinds[MOST_RUNGS];
    size_t rung_count;
    formula *after; /* so many good ticks one rung up again */
    bool delayed;   /* outputs are published when the next tick begins */
    bool histogram; /* of execution times */
} policy_statement;

/* The options of the method, where the scene gives them. */
typedef struct method_options {
    bool compensated, checked;
    formula *iterations, *tolerance, *substeps;
} method_options;

typedef struct scene {
    const char *name;
    bool broken; /* a statement could not be read: a missing name may have been in it */
    formula *gravity, *step;
    name method;
    method_options options;
    stabilisation stabilisation;
    policy_statement policies;
    LIST_OF(body) bodies; /* all statements of a kind, in their order */
    LIST_OF(named_frame) frames;
    LIST_OF(spring_statement) springs;
    LIST_OF(joint) joints;
    LIST_OF(closure_statement) closures;
    LIST_OF(body_force) forces;
    LIST_OF(quantity) parameters;
    LIST_OF(quantity) inputs;
    LIST_OF(quantity) signals;
    LIST_OF(effect_kind) effect_kinds;
    LIST_OF(effect_use) effects;
    event_statements events;
    LIST_OF(setting) settings;
    LIST_OF(setting) fault_starts; /* without a time: faults that --set sets */
    LIST_OF(output) outputs;
    size_t left_input_count; /* behind the inputs: those that only effects read that are left out */
} scene;

#endif
