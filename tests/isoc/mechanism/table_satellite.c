/* tests/isoc/mechanism/satellite.scene in the tables of the independent dynamics. */
#include "tests/isoc/dynamics/tables.h"

enum { BUS, PANEL, WHEEL };
enum { ENGINE, SCREW };

#define AT(body_index) .mechanism.body[body_index]
#define ON(joint_index) .mechanism.joint[joint_index]

const table the_table = {
    .mechanism.gravity = {0.0L, 0.0L, -1.6L},
    .mechanism.bodies = 3,

    AT(BUS) = {4.0L, {0.050L, -0.020L, 0.080L}, {0.12L, 0.10L, 0.08L, 4e-3L, -6e-3L, 5e-3L}},
    AT(PANEL) = {0.9L, {0.0L, 0.250L, 0.010L}, {0.03L, 4e-3L, 0.032L, 2e-4L, 1e-4L, -3e-4L}},
    AT(WHEEL) = {0.3L, {0.001L, 0.0L, 0.002L}, {4e-4L, 4e-4L, 7e-4L, 1e-5L, 2e-5L, -1e-5L}},

    ON(BUS) = {FREE,
               GROUND,
               {{0.0L, 0.0L, 1.0L}, 20.0L, {1.0L, 0.0L, 0.0L}},
               {{0.030L, 0.0L, 0.0L}, 90.0L, {1.0L, 0.0L, 1.0L}},
               .damping = 0.4L,
               .spin_damping = 0.02L},
    ON(PANEL) = {UNIVERSAL,
                 BUS,
                 {{0.0L, 0.150L, 0.0L}, 15.0L, {0.0L, 0.0L, 1.0L}},
                 {{0.0L, -0.020L, 0.0L}, 10.0L, {1.0L, 0.0L, 0.0L}},
                 .axis = {1.0L, 0.0L, 0.0L},
                 .second = {0.0L, 0.0L, -1.0L},
                 .spin_damping = 0.03L},
    ON(WHEEL) = {REVOLUTE,
                 BUS,
                 {{-0.040L, 0.0L, 0.060L}, 60.0L, {0.0L, 1.0L, 1.0L}},
                 .axis = {0.0L, 0.0L, 1.0L},
                 .damping = 1e-3L},

    .mechanism.applied_forces = 2,
    .mechanism.applied_force =
        {
            [ENGINE] = {BUS, {0.0L, -0.100L, 0.020L}, {0.0L, 1.0L, 0.2L}, 0.0L, 1},
            [SCREW] = {PANEL, {0.010L, 0.300L, 0.0L}, {-1.0L, 0.0L, 0.0L}, 0.030L, 2},
        },
    .inputs = 2,

    .mechanism.outputs = 6,
    .mechanism.output =
        {
            {.kind = POINT, .of = BUS},
            {.kind = POINT_VELOCITY, .of = BUS, .point = {0.1L, 0.0L, 0.0L}},
            {.kind = ORIENTATION, .of = BUS},
            {.kind = BODY_SPIN, .of = PANEL},
            {.kind = ACCELERATION, .of = WHEEL},
            {.kind = ENERGY},
        },

    .controls = 7,
    .control =
        {
            {"Iyz of the bus", offsetof(mechanism, body[BUS].inertia[5])},
            {"com of the bus", offsetof(mechanism, body[BUS].com[0])},
            {"mass of the panel", offsetof(mechanism, body[PANEL].mass)},
            {"turn of the bus", offsetof(mechanism, joint[BUS].on_child.degrees)},
            {"damping of the hinge", offsetof(mechanism, joint[PANEL].spin_damping)},
            {"place of the engine", offsetof(mechanism, applied_force[ENGINE].at[1])},
            {"lever of the screw", offsetof(mechanism, applied_force[SCREW].lever)},
        },
};
