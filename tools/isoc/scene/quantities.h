/* The quantities of a mechanism: one row for each. An output shows it, and a formula computes with it.
 * tools/isoc/plant/quantities.c has the nodes of each, and tools/isoc/tree/point_query.c those that efforts may read
 * too. */
#ifndef ISOC_SCENE_QUANTITIES_H
#define ISOC_SCENE_QUANTITIES_H

#include <stdbool.h>

#include "tools/isoc/scene/unit.h"

/* The owner of a quantity; from OF_COORDINATE on the scene names it. */
typedef enum operand {
    OF_MECHANISM,
    OF_CLOSURES, /* all of them */
    OF_STEP,
    OF_COORDINATE,   /* of a joint that has one, or of a part of a joint that has more */
    OF_BODY,         /* a point of it, its origin where no other is given */
    OF_CONNECTION,   /* a joint or a closure: its load on its child */
    OF_TRANSMISSION, /* a gear or a motion: its effort on its first joint */
    OF_EFFECT,
    OPERANDS
} operand;

/* Words that may stand behind the operand. */
typedef enum asking {
    ASKS_NOTHING,
    AT_POINT = 1,     /* at FORMULA */
    IN_AXES = 2,      /* in body, in ground; default: of the ground */
    OF_BODY_AXES = 4, /* the default is: of the body */
    AT_POINT_IN_AXES = AT_POINT + IN_AXES,
    IN_BODY_AXES = IN_AXES + OF_BODY_AXES,
    AT_POINT_IN_BODY_AXES = AT_POINT + IN_BODY_AXES,
} asking;

/* When a quantity is known, and so which formulas can read it. Outputs read all. */
typedef enum known_when {
    KNOWN_ALWAYS,       /* in the step: any formula */
    KNOWN_AT_START,     /* constant from then on: likewise */
    KNOWN_WITH_EFFORTS, /* it follows from all of them: the next of a memory, but no effort */
    KNOWN_AFTER_STEP,   /* likewise */
} known_when;

/* kind, word, operand, points and axes, components, unit, unit of a coordinate that turns, when it is known. A word may
 * stand in several rows, which differ in the operand. A quantity that is the largest of numbers of several units has no
 * unit, and is a plain number in formulas. */
#define QUANTITIES(ROW)                                                                                                \
    ROW(QUANTITY_POSITION, "position", OF_COORDINATE, ASKS_NOTHING, "", "m", "rad", KNOWN_ALWAYS)                      \
    ROW(QUANTITY_POINT, "position", OF_BODY, AT_POINT, "xyz", "m", "m", KNOWN_ALWAYS)                                  \
    ROW(QUANTITY_SPEED, "speed", OF_COORDINATE, ASKS_NOTHING, "", "m/s", "rad/s", KNOWN_ALWAYS)                        \
    ROW(QUANTITY_ACCELERATION, "acceleration", OF_COORDINATE, ASKS_NOTHING, "", "m/s^2", "rad/s^2",                    \
        KNOWN_WITH_EFFORTS)                                                                                            \
    ROW(QUANTITY_VELOCITY, "velocity", OF_BODY, AT_POINT_IN_AXES, "xyz", "m/s", "m/s", KNOWN_ALWAYS)                   \
    ROW(QUANTITY_TURNS, "turns", OF_COORDINATE, ASKS_NOTHING, "", "1", "1", KNOWN_AFTER_STEP)                          \
    ROW(QUANTITY_ORIENTATION, "orientation", OF_BODY, ASKS_NOTHING, "wxyz", "1", "1", KNOWN_ALWAYS)                    \
    ROW(QUANTITY_SPIN, "spin", OF_BODY, IN_BODY_AXES, "xyz", "rad/s", "rad/s", KNOWN_ALWAYS)                           \
    ROW(QUANTITY_X_AXIS, "x_axis", OF_BODY, ASKS_NOTHING, "xyz", "1", "1", KNOWN_ALWAYS)                               \
    ROW(QUANTITY_Y_AXIS, "y_axis", OF_BODY, ASKS_NOTHING, "xyz", "1", "1", KNOWN_ALWAYS)                               \
    ROW(QUANTITY_Z_AXIS, "z_axis", OF_BODY, ASKS_NOTHING, "xyz", "1", "1", KNOWN_ALWAYS)                               \
    ROW(QUANTITY_SPECIFIC_FORCE, "specific_force", OF_BODY, AT_POINT_IN_BODY_AXES, "xyz", "m/s^2", "m/s^2",            \
        KNOWN_WITH_EFFORTS)                                                                                            \
    ROW(QUANTITY_INERTIA, "inertia", OF_COORDINATE, ASKS_NOTHING, "", "kg", "kg*m^2", KNOWN_AT_START)                  \
    ROW(QUANTITY_INERTIA_OF_POINT, "inertia", OF_BODY, AT_POINT_IN_AXES, "xyz", "kg", "kg", KNOWN_AT_START)            \
    ROW(QUANTITY_FORCE, "force", OF_CONNECTION, ASKS_NOTHING, "xyz", "N", "N", KNOWN_WITH_EFFORTS)                     \
    ROW(QUANTITY_MOMENT, "moment", OF_CONNECTION, ASKS_NOTHING, "xyz", "N*m", "N*m", KNOWN_WITH_EFFORTS)               \
    ROW(QUANTITY_EFFORT, "effort", OF_TRANSMISSION, ASKS_NOTHING, "", "N", "N*m", KNOWN_WITH_EFFORTS)                  \
    ROW(QUANTITY_ENERGY, "energy", OF_MECHANISM, ASKS_NOTHING, "", "J", "J", KNOWN_AFTER_STEP)                         \
    ROW(QUANTITY_POWER, "power", OF_MECHANISM, ASKS_NOTHING, "", "W", "W", KNOWN_WITH_EFFORTS)                         \
    ROW(QUANTITY_BALANCE, "balance", OF_MECHANISM, ASKS_NOTHING, "", "W", "W", KNOWN_WITH_EFFORTS)                     \
    ROW(QUANTITY_EVENT_LOSS, "event_loss", OF_MECHANISM, ASKS_NOTHING, "", "J", "J", KNOWN_AFTER_STEP)                 \
    ROW(QUANTITY_LOCAL_ERROR, "local_error", OF_STEP, ASKS_NOTHING, "", "mixed", "mixed", KNOWN_AFTER_STEP)            \
    ROW(QUANTITY_RESIDUAL, "residual", OF_STEP, ASKS_NOTHING, "", "mixed", "mixed", KNOWN_AFTER_STEP)                  \
    ROW(QUANTITY_VIOLATION, "violation", OF_CLOSURES, ASKS_NOTHING, "", "m or rad", "m or rad", KNOWN_AFTER_STEP)      \
    ROW(QUANTITY_VIOLATION_RATE, "violation_rate", OF_CLOSURES, ASKS_NOTHING, "", "m/s or rad/s", "m/s or rad/s",      \
        KNOWN_AFTER_STEP)                                                                                              \
    ROW(QUANTITY_VIOLATION_ACCELERATION, "violation_acceleration", OF_CLOSURES, ASKS_NOTHING, "", "m/s^2 or rad/s^2",  \
        "m/s^2 or rad/s^2", KNOWN_WITH_EFFORTS)                                                                        \
    ROW(QUANTITY_POWER_OF_EFFECT, "power", OF_EFFECT, ASKS_NOTHING, "", "W", "W", KNOWN_WITH_EFFORTS)                  \
    ROW(QUANTITY_ENERGY_OF_EFFECT, "energy", OF_EFFECT, ASKS_NOTHING, "", "J", "J", KNOWN_WITH_EFFORTS)                \
    ROW(QUANTITY_LOSS, "loss", OF_EFFECT, ASKS_NOTHING, "", "W", "W", KNOWN_WITH_EFFORTS)                              \
    ROW(QUANTITY_WORK, "work", OF_EFFECT, ASKS_NOTHING, "", "W", "W", KNOWN_WITH_EFFORTS)

/* QUANTITY_ROWS: none of them, but a formula, where an output shows one. */
#define QUANTITY_KIND(kind, word, owner, asks, components, unit, turning_unit, known) kind,
typedef enum quantity_kind { QUANTITIES(QUANTITY_KIND) QUANTITY_ROWS } quantity_kind;
#undef QUANTITY_KIND

typedef struct quantity_row {
    const char *word;
    operand owner;
    asking asks;
    const char *components; /* one letter for each, the ending of its name in the trace; "": a scalar */
    const char *unit, *turning_unit;
    known_when known;
} quantity_row;

extern const quantity_row quantity_rows[QUANTITY_ROWS];

/* The phrase for each operand: a joint, a body, ... */
extern const char *const operand_phrases[OPERANDS];

/* The row of a word that is of this operand; QUANTITY_ROWS if there is none. */
quantity_kind quantity_called(const char *word, operand owner);

/* The row of a word that is of nothing: of the mechanism, its closures or the step; QUANTITY_ROWS if there is none. */
quantity_kind quantity_of_nothing(const char *word);

/* Whether `along` shows a component of it, and which; whether it is at a point. */
bool quantity_has_parts(const quantity_row *row);
int quantity_part(const quantity_row *row, const char *along);
bool quantity_has_point(const quantity_row *row);

/* The number of its components. */
int quantity_parts(const quantity_row *row);

/* Those for which is_listed holds, as a list: position or velocity of a body; force of a joint or a closure. */
const char *quantity_list(arena *memory, bool (*is_listed)(const quantity_row *row));

/* The words of the quantities of this operand, or of one of these two: its position, speed or acceleration. */
const char *quantity_words(arena *memory, operand owner, operand or_of);

/* The owners of a quantity that have a name: a joint or a body; NULL where no quantity is called so. */
const char *quantity_owners(arena *memory, const char *word);

/* The dimension of a unit such as kg*m^2; of "m or rad" none. */
dimension dimension_of_unit(const char *unit);

#endif
