/* models/bricard.scene in the tables of the independent dynamics. */
#include "tests/isoc/dynamics/tables.h"

enum { ROD1, ROD2, ROD3, ROD4, ROD5 };
enum { HINGE5 };

#define AT(body_index) .mechanism.body[body_index]
#define ON(joint_index) .mechanism.joint[joint_index]
#define X_AXIS .axis = {1.0L, 0.0L, 0.0L}
#define Y_AXIS .axis = {0.0L, 1.0L, 0.0L}
#define Z_AXIS .axis = {0.0L, 0.0L, 1.0L}
#define LENGTHWISE (0.02L / 12.0L)
#define CROSSWISE (1.01L / 12.0L)
#define ALONG_X                                                                                                        \
    {                                                                                                                  \
        LENGTHWISE, CROSSWISE, CROSSWISE, 0.0L, 0.0L, 0.0L                                                             \
    }
#define ALONG_Y                                                                                                        \
    {                                                                                                                  \
        CROSSWISE, LENGTHWISE, CROSSWISE, 0.0L, 0.0L, 0.0L                                                             \
    }
#define ALONG_Z                                                                                                        \
    {                                                                                                                  \
        CROSSWISE, CROSSWISE, LENGTHWISE, 0.0L, 0.0L, 0.0L                                                             \
    }

const table the_table = {
    .mechanism.gravity = {0.0L, -9.81L, 0.0L},
    .mechanism.bodies = 5,

    AT(ROD1) = {1.0L, {0.5L, 0.0L, 0.0L}, ALONG_X},
    AT(ROD2) = {1.0L, {0.0L, -0.5L, 0.0L}, ALONG_Y},
    AT(ROD3) = {1.0L, {0.0L, 0.0L, 0.5L}, ALONG_Z},
    AT(ROD4) = {1.0L, {-0.5L, 0.0L, 0.0L}, ALONG_X},
    AT(ROD5) = {1.0L, {0.0L, 0.5L, 0.0L}, ALONG_Y},

    ON(ROD1) = {REVOLUTE, GROUND, Y_AXIS},
    ON(ROD2) = {REVOLUTE, ROD1, {.at = {1.0L, 0.0L, 0.0L}}, Z_AXIS},
    ON(ROD3) = {REVOLUTE, ROD2, {.at = {0.0L, -1.0L, 0.0L}}, X_AXIS},
    ON(ROD4) = {REVOLUTE, ROD3, {.at = {0.0L, 0.0L, 1.0L}}, Y_AXIS},
    ON(ROD5) = {REVOLUTE, ROD4, {.at = {-1.0L, 0.0L, 0.0L}}, Z_AXIS},

    .mechanism.closures = 1,
    .mechanism.closure =
        {
            [HINGE5] = {REVOLUTE, GROUND, ROD5, {.at = {0.0L, 0.0L, 1.0L}}, {.at = {0.0L, 1.0L, 0.0L}}, X_AXIS},
        },

    .overconstrained = true,
    .spread = 1.0,

    .mechanism.outputs = 5,
    .mechanism.output =
        {
            {.kind = POINT, .of = ROD3},
            {.kind = POINT, .of = ROD4},
            {.kind = POINT, .of = ROD5},
            {.kind = VIOLATION},
            {.kind = ENERGY},
        },

    .controls = 3,
    .control =
        {
            {"mass of the first rod", offsetof(mechanism, body[ROD1].mass)},
            {"com of the second rod", offsetof(mechanism, body[ROD2].com[1])},
            {"Iyy of the third rod", offsetof(mechanism, body[ROD3].inertia[1])},
        },
};
