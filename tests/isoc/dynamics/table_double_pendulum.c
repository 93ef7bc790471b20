/* models/double_pendulum.scene in the tables of the independent dynamics. */
#include "tests/isoc/dynamics/tables.h"

enum { UPPER, LOWER };
enum { SHOULDER, ELBOW };

const table the_table = {
    .mechanism.gravity = {0.0L, -9.81L, 0.0L},
    .mechanism.bodies = 2,
    .mechanism.body[UPPER] = {1.0L, {0.0L, -1.0L, 0.0L}, {0.0L}},
    .mechanism.body[LOWER] = {1.0L, {0.0L, -1.0L, 0.0L}, {0.0L}},
    .mechanism.joint[SHOULDER] = {.kind = REVOLUTE, .parent = GROUND, .axis = {0.0L, 0.0L, 1.0L}},
    .mechanism.joint[ELBOW] = {REVOLUTE, UPPER, {.at = {0.0L, -1.0L, 0.0L}}, .axis = {0.0L, 0.0L, 1.0L}},

    .mechanism.outputs = 6,
    .mechanism.output =
        {
            {.kind = POSITION, .of = SHOULDER},
            {.kind = POSITION, .of = ELBOW},
            {.kind = SPEED, .of = SHOULDER},
            {.kind = SPEED, .of = ELBOW},
            {.kind = POINT, .of = LOWER, .point = {0.0L, -1.0L, 0.0L}},
            {.kind = ENERGY},
        },

    .controls = 2,
    .control =
        {
            {"mass of the lower bob", offsetof(mechanism, body[LOWER].mass)},
            {"place of the elbow", offsetof(mechanism, joint[ELBOW].on_parent.at[1])},
        },
};
