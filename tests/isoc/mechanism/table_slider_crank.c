/* models/slider_crank.scene in the tables of the independent dynamics. */
#include "tests/isoc/dynamics/tables.h"

enum { CRANK, ROD, SLIDER };
enum { PISTON_PIN };

#define AT(body_index) .mechanism.body[body_index]
#define ON(joint_index) .mechanism.joint[joint_index]
#define X_AXIS .axis = {1.0L, 0.0L, 0.0L}
#define Z_AXIS .axis = {0.0L, 0.0L, 1.0L}

const table the_table = {
    .mechanism.gravity = {0.0L, -9.81L, 0.0L},
    .mechanism.bodies = 3,

    AT(CRANK) = {0.038L, {0.0765L, 0.0L, 0.0L}, {0.0L, 7.4e-5L, 7.4e-5L}},
    AT(ROD) = {0.038L, {0.153L, 0.0L, 0.0L}, {0.0L, 5.9e-4L, 5.9e-4L}},
    AT(SLIDER) = {0.076L, {0.0L, 0.0L, 0.0L}, {0.0L}},

    ON(CRANK) = {REVOLUTE, GROUND, Z_AXIS},
    ON(ROD) = {REVOLUTE, CRANK, {.at = {0.153L, 0.0L, 0.0L}}, Z_AXIS},
    ON(SLIDER) = {PRISMATIC, GROUND, X_AXIS},

    .mechanism.closures = 1,
    .mechanism.closure =
        {
            [PISTON_PIN] = {LINE, SLIDER, ROD, .on_child = {.at = {0.306L, 0.0L, 0.0L}}, Z_AXIS},
        },

    .spread = 3.0,

    .mechanism.outputs = 7,
    .mechanism.output =
        {
            {.kind = POSITION, .of = CRANK},
            {.kind = SPEED, .of = CRANK},
            {.kind = POSITION, .of = SLIDER},
            {.kind = SPEED, .of = SLIDER},
            {.kind = FORCE, .of = PISTON_PIN},
            {.kind = VIOLATION},
            {.kind = ENERGY},
        },

    .controls = 4,
    .control =
        {
            {"Izz of the rod", offsetof(mechanism, body[ROD].inertia[2])},
            {"mass of the slider", offsetof(mechanism, body[SLIDER].mass)},
            {"place of the crank pin", offsetof(mechanism, joint[ROD].on_parent.at[0])},
            {"length of the rod", offsetof(mechanism, closure[PISTON_PIN].on_child.at[0])},
        },
};
