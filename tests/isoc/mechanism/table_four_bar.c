/* models/four_bar.scene in the tables of the independent dynamics. */
#include "tests/isoc/dynamics/tables.h"

enum { CRANK, COUPLER, ROCKER };
enum { ROCKER_PIN };

#define AT(body_index) .mechanism.body[body_index]
#define ON(joint_index) .mechanism.joint[joint_index]
#define Z_AXIS .axis = {0.0L, 0.0L, 1.0L}

/* A uniform rod from the origin along x. */
#define ROD(mass, length)                                                                                              \
    {                                                                                                                  \
        mass, {(length) / 2.0L, 0.0L, 0.0L},                                                                           \
        {                                                                                                              \
            0.0L, (mass) * (length) * (length) / 12.0L, (mass) * (length) * (length) / 12.0L, 0.0L, 0.0L, 0.0L         \
        }                                                                                                              \
    }

const table the_table = {
    .mechanism.gravity = {0.0L, -9.81L, 0.0L},
    .mechanism.bodies = 3,

    AT(CRANK) = ROD(0.2L, 0.10L),
    AT(COUPLER) = ROD(0.3L, 0.26L),
    AT(ROCKER) = ROD(0.25L, 0.25L),

    ON(CRANK) = {REVOLUTE, GROUND, Z_AXIS, .input = 1},
    ON(COUPLER) = {REVOLUTE, CRANK, {.at = {0.10L, 0.0L, 0.0L}}, Z_AXIS},
    ON(ROCKER) = {REVOLUTE, GROUND, {.at = {0.39L, 0.0L, 0.0L}}, Z_AXIS},

    .mechanism.closures = 1,
    .mechanism.closure =
        {
            [ROCKER_PIN] = {LINE, ROCKER, COUPLER, {.at = {0.25L, 0.0L, 0.0L}}, {.at = {0.26L, 0.0L, 0.0L}}, Z_AXIS},
        },
    .inputs = 1,
    .spread = 3.0,

    .mechanism.outputs = 6,
    .mechanism.output =
        {
            {.kind = POSITION, .of = CRANK},
            {.kind = POSITION, .of = ROCKER},
            {.kind = POINT, .of = COUPLER, .point = {0.13L, 0.10L, 0.0L}},
            {.kind = FORCE, .of = ROCKER_PIN},
            {.kind = VIOLATION},
            {.kind = ENERGY},
        },

    .controls = 4,
    .control =
        {
            {"Izz of the crank", offsetof(mechanism, body[CRANK].inertia[2])},
            {"mass of the coupler", offsetof(mechanism, body[COUPLER].mass)},
            {"com of the rocker", offsetof(mechanism, body[ROCKER].com[0])},
            {"length of the coupler", offsetof(mechanism, closure[ROCKER_PIN].on_child.at[0])},
        },
};
