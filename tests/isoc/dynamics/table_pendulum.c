/* models/pendulum.scene in the tables of the independent dynamics. */
#include "tests/isoc/dynamics/tables.h"

const table the_table = {
    .mechanism.gravity = {0.0L, -9.81L, 0.0L},
    .mechanism.bodies = 1,
    .mechanism.body[0] = {1.0L, {0.0L, -1.0L, 0.0L}, {0.0L}},
    .mechanism.joint[0] = {.kind = REVOLUTE, .parent = GROUND, .axis = {0.0L, 0.0L, 1.0L}},

    .mechanism.outputs = 4,
    .mechanism.output =
        {
            {.kind = POSITION, .of = 0},
            {.kind = SPEED, .of = 0},
            {.kind = POINT, .of = 0, .point = {0.0L, -1.0L, 0.0L}},
            {.kind = ENERGY},
        },

    .controls = 1,
    .control = {{"gravity", offsetof(mechanism, gravity[1])}},
};
