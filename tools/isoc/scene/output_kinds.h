/* What a scene can show: one row for each kind of output. tools/isoc/plant/outputs.c has the nodes of each. */
#ifndef ISOC_SCENE_OUTPUT_KINDS_H
#define ISOC_SCENE_OUTPUT_KINDS_H

#include <stdbool.h>

#include "tools/isoc/base/arena.h"

/* What an output belongs to; from OF_COORDINATE on the scene names it. */
typedef enum operand {
    OF_MECHANISM,
    OF_CLOSURES, /* all of them */
    OF_STEP,
    OF_COORDINATE,   /* of a joint that has one, or of a part of a joint that has more */
    OF_BODY,         /* a point of it, its origin where no other is given */
    OF_CONNECTION,   /* a joint or a closure: what it gives to its child */
    OF_TRANSMISSION, /* a gear or a motion: what it gives to its first joint */
    OPERANDS
} operand;

/* kind, word, operand, whether it is at a point, components, unit, unit of a coordinate that turns. A word may stand in
 * several rows, which differ in the operand. */
#define OUTPUT_KINDS(ROW)                                                                                              \
    ROW(OUTPUT_POSITION, "position", OF_COORDINATE, false, "", "m", "rad")                                             \
    ROW(OUTPUT_POINT, "position", OF_BODY, true, "xyz", "m", "m")                                                      \
    ROW(OUTPUT_SPEED, "speed", OF_COORDINATE, false, "", "m/s", "rad/s")                                               \
    ROW(OUTPUT_ACCELERATION, "acceleration", OF_COORDINATE, false, "", "m/s^2", "rad/s^2")                             \
    ROW(OUTPUT_VELOCITY, "velocity", OF_BODY, true, "xyz", "m/s", "m/s")                                               \
    ROW(OUTPUT_TURNS, "turns", OF_COORDINATE, false, "", "1", "1")                                                     \
    ROW(OUTPUT_ORIENTATION, "orientation", OF_BODY, false, "wxyz", "1", "1")                                           \
    ROW(OUTPUT_SPIN, "spin", OF_BODY, false, "xyz", "rad/s", "rad/s")                                                  \
    ROW(OUTPUT_FORCE, "force", OF_CONNECTION, false, "xyz", "N", "N")                                                  \
    ROW(OUTPUT_MOMENT, "moment", OF_CONNECTION, false, "xyz", "N*m", "N*m")                                            \
    ROW(OUTPUT_EFFORT, "effort", OF_TRANSMISSION, false, "", "N", "N*m")                                               \
    ROW(OUTPUT_ENERGY, "energy", OF_MECHANISM, false, "", "J", "J")                                                    \
    ROW(OUTPUT_POWER, "power", OF_MECHANISM, false, "", "W", "W")                                                      \
    ROW(OUTPUT_BALANCE, "balance", OF_MECHANISM, false, "", "W", "W")                                                  \
    ROW(OUTPUT_LOCAL_ERROR, "local_error", OF_STEP, false, "", "mixed", "mixed")                                       \
    ROW(OUTPUT_RESIDUAL, "residual", OF_STEP, false, "", "mixed", "mixed")                                             \
    ROW(OUTPUT_VIOLATION, "violation", OF_CLOSURES, false, "", "m or rad", "m or rad")                                 \
    ROW(OUTPUT_VIOLATION_RATE, "violation_rate", OF_CLOSURES, false, "", "m/s or rad/s", "m/s or rad/s")               \
    ROW(OUTPUT_VIOLATION_ACCELERATION, "violation_acceleration", OF_CLOSURES, false, "", "m/s^2 or rad/s^2",           \
        "m/s^2 or rad/s^2")                                                                                            \
    ROW(OUTPUT_FORMULA, "", OF_MECHANISM, false, "", "", "")

#define OUTPUT_KIND(kind, word, of, is_of_point, components, unit, turning_unit) kind,
typedef enum output_kind { OUTPUT_KINDS(OUTPUT_KIND) OUTPUT_ROWS } output_kind;
#undef OUTPUT_KIND

typedef struct output_row {
    const char *word;
    operand of;
    bool is_of_point;       /* at FORMULA */
    const char *components; /* one letter for each, the ending of its name in the trace; "": a scalar */
    const char *unit, *turning_unit;
} output_row;

extern const output_row output_rows[OUTPUT_ROWS];

/* A joint, a body, ...: what the scene names. */
extern const char *const operand_phrases[OPERANDS];

/* The kind of the same word that is of this operand; OUTPUT_ROWS if there is none. */
output_kind output_of(output_kind kind, operand of);

/* Whether it is a vector, of which `along` shows a component. */
bool output_is_vector(const output_row *row);

/* The outputs that are such, as a list: position or velocity of a body; force of a joint or a closure. */
const char *output_list(arena *memory, bool (*is_listed)(const output_row *row));

#endif
