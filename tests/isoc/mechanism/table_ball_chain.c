/* tests/isoc/mechanism/ball_chain.scene in the tables of the independent dynamics. */
#include "tests/isoc/dynamics/tables.h"

enum { FIRST, SECOND, THIRD };

#define AT(body_index) .mechanism.body[body_index]
#define ON(joint_index) .mechanism.joint[joint_index]

const table the_table = {
    .mechanism.gravity = {1.0L, -2.0L, -9.0L},
    .mechanism.bodies = 3,

    AT(FIRST) = {1.2L, {0.020L, -0.030L, 0.150L}, {0.02L, 0.03L, 0.015L, 1e-3L, -2e-3L, 3e-3L}},
    AT(SECOND) = {0.8L, {-0.010L, 0.090L, 0.020L}, {8e-3L, 5e-3L, 9e-3L, -5e-4L, 4e-4L, 3e-4L}},
    AT(THIRD) = {0.5L, {0.060L, 0.010L, -0.040L}, {2e-3L, 3e-3L, 2.5e-3L, 1e-4L, 2e-4L, -3e-4L}},

    ON(FIRST) = {SPHERICAL,
                 GROUND,
                 {{0.1L, 0.2L, 0.5L}, 30.0L, {0.0L, 1.0L, 0.0L}},
                 {{0.0L, 0.0L, -0.050L}, 40.0L, {1.0L, 2.0L, 3.0L}},
                 .spin_damping = 0.05L},
    ON(SECOND) = {.kind = SPHERICAL,
                  .parent = FIRST,
                  .on_parent = {.at = {0.0L, 0.050L, 0.300L}},
                  .on_child = {.degrees = -70.0L, .axis = {0.0L, 0.0L, 1.0L}}},
    ON(THIRD) = {SPHERICAL,
                 SECOND,
                 {{0.010L, 0.200L, 0.0L}, 25.0L, {0.0L, 1.0L, -1.0L}},
                 {.at = {-0.030L, 0.0L, 0.020L}},
                 .spin_damping = 0.01L},

    .mechanism.outputs = 6,
    .mechanism.output =
        {
            {.kind = POINT, .of = SECOND},
            {.kind = POINT, .of = THIRD, .point = {0.1L, 0.0L, -0.1L}},
            {.kind = POINT_VELOCITY, .of = THIRD, .point = {0.1L, 0.0L, -0.1L}},
            {.kind = ORIENTATION, .of = THIRD},
            {.kind = BODY_SPIN, .of = THIRD},
            {.kind = ENERGY},
        },

    .controls = 5,
    .control =
        {
            {"Ixz of the second", offsetof(mechanism, body[SECOND].inertia[4])},
            {"com of the third", offsetof(mechanism, body[THIRD].com[1])},
            {"turn of the first on its ball", offsetof(mechanism, joint[FIRST].on_child.degrees)},
            {"turn of the ball on the second", offsetof(mechanism, joint[THIRD].on_parent.degrees)},
            {"damping of the shoulder", offsetof(mechanism, joint[FIRST].spin_damping)},
        },
};
