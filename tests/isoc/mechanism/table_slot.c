/* tests/isoc/mechanism/slot.scene in the tables of the independent dynamics. */
#include "tests/isoc/dynamics/tables.h"

enum { HUB, NEAR, FAR };
enum { SLOT };

#define AT(body_index) .mechanism.body[body_index]
#define ON(joint_index) .mechanism.joint[joint_index]
#define Y_AXIS .axis = {0.0L, 1.0L, 0.0L}

const table the_table = {
    .mechanism.gravity = {0.0L, 0.0L, -9.81L},
    .mechanism.bodies = 3,

    AT(HUB) = {2.0L, {0.010L, -0.020L, 0.030L}, {0.12L, 0.10L, 0.08L, 4e-3L, -6e-3L, 5e-3L}},
    AT(NEAR) = {0.6L, {0.120L, 0.010L, 0.0L}, {2e-3L, 6e-3L, 5e-3L, 1e-4L, 2e-4L, -1e-4L}},
    AT(FAR) = {0.5L, {0.150L, 0.0L, -0.010L}, {2e-3L, 5e-3L, 4e-3L, 1e-4L, -1e-4L, 2e-4L}},

    ON(HUB) = {.kind = FREE, .parent = GROUND},
    ON(NEAR) = {REVOLUTE, HUB, {{0.0L, 0.1L, 0.0L}, 20.0L, {0.0L, 1.0L, 0.0L}}, Y_AXIS},
    ON(FAR) = {UNIVERSAL, NEAR, {.at = {0.25L, 0.0L, 0.0L}}, Y_AXIS, .second = {0.0L, 0.0L, 1.0L}},

    .mechanism.closures = 1,
    .mechanism.closure =
        {
            [SLOT] = {LINE,
                      HUB,
                      FAR,
                      {{0.2L, 0.1L, 0.05L}, 40.0L, {1.0L, 2.0L, 0.0L}},
                      {.at = {0.3L, 0.0L, 0.0L}},
                      .axis = {0.0L, 0.0L, 1.0L}},
        },

    .spread = 1.0,

    .mechanism.outputs = 5,
    .mechanism.output =
        {
            {.kind = POSITION, .of = NEAR},
            {.kind = POINT, .of = FAR, .point = {0.3L, 0.0L, 0.0L}},
            {.kind = FORCE, .of = SLOT},
            {.kind = VIOLATION},
            {.kind = ENERGY},
        },

    .controls = 3,
    .control =
        {
            {"turn of the slot", offsetof(mechanism, closure[SLOT].on_parent.degrees)},
            {"place of the fork", offsetof(mechanism, closure[SLOT].on_child.at[0])},
            {"mass of the hub", offsetof(mechanism, body[HUB].mass)},
        },
};
