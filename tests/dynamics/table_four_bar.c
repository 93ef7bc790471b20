/* tests/order/four_bar.scene in the tables of the independent dynamics. */
#include "tests/dynamics/tables.h"

enum { CRANK, COUPLER, ROCKER };

#define AT(body_index) .mechanism.body[body_index]
#define ON(joint_index) .mechanism.joint[joint_index]
#define THIN                                                                                                           \
    {                                                                                                                  \
        0.0L, 1e-3L, 1e-3L, 0.0L, 0.0L, 0.0L                                                                           \
    }
#define Z_AXIS .axis = {0.0L, 0.0L, 1.0L}

const table the_table = {
    .mechanism.gravity = {0.0L, -0.25L, 0.0L},
    .mechanism.bodies = 3,

    AT(CRANK) = {1.0L, {0.050L, 0.0L, 0.0L}, THIN},
    AT(COUPLER) = {1.0L, {0.130L, 0.0L, 0.0L}, THIN},
    AT(ROCKER) = {1.0L, {0.125L, 0.0L, 0.0L}, THIN},

    ON(CRANK) = {REVOLUTE, GROUND, Z_AXIS},
    ON(COUPLER) = {REVOLUTE, CRANK, {.at = {0.100L, 0.0L, 0.0L}}, Z_AXIS},
    ON(ROCKER) = {REVOLUTE, GROUND, {.at = {0.390L, 0.0L, 0.0L}}, Z_AXIS},

    .mechanism.closures = 1,
    .mechanism.closure =
        {
            {LINE, ROCKER, COUPLER, {.at = {0.250L, 0.0L, 0.0L}}, {.at = {0.260L, 0.0L, 0.0L}}, Z_AXIS},
        },

    .mechanism.outputs = 1,
    .mechanism.output = {{.kind = POSITION, .of = ROCKER}},
};
