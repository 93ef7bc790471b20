/* models/squeezer.scene in the tables of the independent dynamics: Andrews' seven bodies, and the two of the spring's
 * leg, whose eye is 5 g of the plate's 23.73 g. */
#include "tests/isoc/dynamics/tables.h"

enum { CRANK, COUPLER, PLATE, UPPER_ROCKER, UPPER_ROD, LOWER_ROCKER, LOWER_ROD, HUB, EYE };
enum { PLATE_PIN, UPPER_PIN, LOWER_PIN, SPRING_PIN };

#define AT(body_index) .mechanism.body[body_index]
#define ON(joint_index) .mechanism.joint[joint_index]
#define Z_AXIS .axis = {0.0L, 0.0L, 1.0L}
#define ANCHOR .at = {-0.06934L, -0.00227L, 0.0L}
#define SQUEEZED .on_child = {.at = {-0.028L, 0.0L, 0.0L}}

/* A thin plate with its centre of mass at x, y. */
#define THIN(mass, x, y, izz)                                                                                          \
    {                                                                                                                  \
        mass, {x, y, 0.0L},                                                                                            \
        {                                                                                                              \
            (izz) / 2.0L, (izz) / 2.0L, izz, 0.0L, 0.0L, 0.0L                                                          \
        }                                                                                                              \
    }

/* What is left of the plate: m3 c3 = m c + m_eye d for the centres, and by Steiner for the moment of inertia. */
#define M3 0.02373L
#define EYE_MASS 0.005L
#define PLATE_MASS (M3 - EYE_MASS)
#define PLATE_X ((M3 * 0.01043L - EYE_MASS * 0.020L) / PLATE_MASS)
#define PLATE_Y ((M3 * -0.01874L - EYE_MASS * -0.018L) / PLATE_MASS)
#define SQUARE(a) ((a) * (a))
#define PLATE_INERTIA                                                                                                  \
    (5.255e-6L + M3 * (SQUARE(0.01043L) + SQUARE(0.01874L)) - EYE_MASS * (SQUARE(0.020L) + SQUARE(0.018L)) -           \
     PLATE_MASS * (SQUARE(PLATE_X) + SQUARE(PLATE_Y)))

const table the_table =
    {
        .mechanism.bodies = 9,

        AT(CRANK) = THIN(0.04325L, 0.00092L, 0.0L, 2.194e-6L),
        AT(COUPLER) = THIN(0.00365L, -0.0115L, 0.0L, 4.410e-7L),
        AT(PLATE) = THIN(PLATE_MASS, PLATE_X, PLATE_Y, PLATE_INERTIA),
        AT(UPPER_ROCKER) = THIN(0.07050L, 0.02308L, 0.00916L, 1.169e-5L),
        AT(UPPER_ROD) = THIN(0.00706L, 0.0L, 0.01421L - 0.02L, 5.667e-7L),
        AT(LOWER_ROCKER) = THIN(0.05498L, 0.00449L, -0.01228L, 1.912e-5L),
        AT(LOWER_ROD) = THIN(0.00706L, 0.02L - 0.01421L, 0.0L, 5.667e-7L),
        AT(HUB) = {.mass = 0.001L},
        AT(EYE) = {.mass = EYE_MASS},

        ON(CRANK) = {REVOLUTE, GROUND, Z_AXIS, .input = 1},
        ON(COUPLER) = {REVOLUTE, CRANK, {.at = {0.007L, 0.0L, 0.0L}}, Z_AXIS},
        ON(PLATE) = {REVOLUTE, GROUND, {.at = {-0.03635L, 0.03273L, 0.0L}}, Z_AXIS},
        ON(UPPER_ROCKER) = {REVOLUTE, GROUND, {ANCHOR}, Z_AXIS},
        ON(UPPER_ROD) = {REVOLUTE, UPPER_ROCKER, {.at = {0.040L, 0.0L, 0.0L}}, Z_AXIS},
        ON(LOWER_ROCKER) = {REVOLUTE, GROUND, {ANCHOR}, Z_AXIS},
        ON(LOWER_ROD) = {REVOLUTE, LOWER_ROCKER, {.at = {0.0L, -0.040L, 0.0L}}, Z_AXIS},
        ON(HUB) = {REVOLUTE, GROUND, {.at = {0.014L, 0.072L, 0.0L}}, Z_AXIS},
        ON(EYE) = {PRISMATIC, HUB, .axis = {1.0L, 0.0L, 0.0L}, .stiffness = 4530.0L, .rest = 0.07785L},

        .mechanism.closures = 4,
        .mechanism.closure =
            {
                [PLATE_PIN] = {LINE, PLATE, COUPLER, {.at = {0.0L, -0.035L, 0.0L}}, SQUEEZED, Z_AXIS},
                [UPPER_PIN] = {LINE, UPPER_ROD, COUPLER, {.at = {0.0L, -0.020L, 0.0L}}, SQUEEZED, Z_AXIS},
                [LOWER_PIN] = {LINE, LOWER_ROD, COUPLER, {.at = {0.020L, 0.0L, 0.0L}}, SQUEEZED, Z_AXIS},
                [SPRING_PIN] = {LINE, PLATE, EYE, {.at = {0.020L, -0.018L, 0.0L}}, Z_AXIS},
            },
        .inputs = 1,

        .spread = 0.5,

        .mechanism.outputs = 9,
        .mechanism.output =
            {
                {.kind = POSITION, .of = CRANK},
                {.kind = POSITION, .of = COUPLER},
                {.kind = POSITION, .of = PLATE},
                {.kind = POSITION, .of = UPPER_ROD},
                {.kind = POSITION, .of = UPPER_ROCKER},
                {.kind = POSITION, .of = LOWER_ROD},
                {.kind = POSITION, .of = LOWER_ROCKER},
                {.kind = VIOLATION},
                {.kind = ENERGY},
            },

        .controls = 5,
        .control =
            {
                {"Izz of the coupler", offsetof(mechanism, body[COUPLER].inertia[2])},
                {"mass of the eye", offsetof(mechanism, body[EYE].mass)},
                {"spring", offsetof(mechanism, joint[EYE].stiffness)},
                {"length of the coupler", offsetof(mechanism, closure[UPPER_PIN].on_child.at[0])},
                {"length of the upper rocker", offsetof(mechanism, joint[UPPER_ROD].on_parent.at[0])},
            },
};
