/* models/tree.scene in the tables of the independent dynamics. */
#include "tests/isoc/dynamics/tables.h"

enum { CARRIAGE, MAST, TELESCOPE, SENSOR, ROTOR, POINTER };
enum { RAIL, HINGE, SLIDE, WELD, AXLE, NEEDLE };

#define AT(body_index) .mechanism.body[body_index]
#define ON(joint_index) .mechanism.joint[joint_index]
#define NONE 0.0L, 0.0L, 0.0L

const table the_table =
    {
        .mechanism.gravity = {0.0L, 0.0L, -9.81L},
        .mechanism.bodies = 6,

        AT(CARRIAGE) = {3.0L, {0.010L, -0.005L, 0.020L}, {0.02L, 0.03L, 0.04L, NONE}},
        AT(MAST) = {1.6L, {0.005L, 0.010L, 0.240L}, {0.031L, 0.033L, 0.004L, 4e-4L, -3e-4L, 8e-4L}},
        AT(TELESCOPE) = {0.7L, {0.12L, 0.0L, 0.01L}, {8e-4L, 4.1e-3L, 4.2e-3L, 1e-4L, 0.0L, -2e-4L}},
        AT(SENSOR) = {0.050L, {NONE}, {2e-5L, 2e-5L, 3e-5L, NONE}},
        AT(ROTOR) = {0.4L, {0.001L, 0.002L, 0.0L}, {4e-4L, 4e-4L, 7e-4L, 2e-5L, 1e-5L, -1e-5L}},
        AT(POINTER) = {0.020L, {0.0L, 0.1L, 0.0L}, {0.0L}},

        ON(RAIL) = {PRISMATIC,
                    GROUND,
                    {{0.0L, 0.0L, 0.5L}, 15.0L, {0.0L, 1.0L, 0.0L}},
                    {.at = {0.0L, 0.0L, -0.030L}},
                    {1.0L, 0.0L, 0.0L},
                    .damping = 6.0L,
                    .stiffness = 80.0L,
                    .input = 1},
        ON(HINGE) = {REVOLUTE,
                     CARRIAGE,
                     {{0.020L, 0.0L, 0.040L}, 20.0L, {1.0L, 0.0L, 0.0L}},
                     {{0.0L, 0.0L, -0.010L}, 10.0L, {0.0L, 0.0L, 1.0L}},
                     {1.0L, 2.0L, -0.5L},
                     .stiffness = 30.0L},
        ON(SLIDE) = {PRISMATIC,
                     MAST,
                     {{0.0L, 0.0L, 0.4L}, 30.0L, {1.0L, 1.0L, 0.0L}},
                     .axis = {2.0L, 0.0L, 1.0L},
                     .damping = 1.5L,
                     .stiffness = 200.0L,
                     .rest = 0.010L},
        ON(WELD) = {FIXED,
                    TELESCOPE,
                    {{0.25L, 0.0L, 0.0L}, 45.0L, {0.0L, 0.0L, 1.0L}},
                    {.at = {0.0L, 0.010L, 0.0L}},
                    .axis = {1.0L, 0.0L, 0.0L}},
        ON(AXLE) = {REVOLUTE,
                    MAST,
                    {{0.0L, -0.080L, 0.200L}, 35.0L, {0.0L, 1.0L, 0.0L}},
                    {{NONE}, 180.0L, {1.0L, 0.0L, 0.0L}},
                    {0.0L, -1.0L, 0.0L},
                    .damping = 2e-4L,
                    .input = 2},
        ON(NEEDLE) = {REVOLUTE, ROTOR, {.at = {0.0L, 0.030L, 0.0L}}, .axis = {1.0L, 0.0L, 0.0L}, .damping = 1e-3L},

        .mechanism.outputs = 10,
        .mechanism.output =
            {
                {.kind = POSITION, .of = RAIL},
                {.kind = POSITION, .of = HINGE},
                {.kind = POSITION, .of = SLIDE},
                {.kind = POSITION, .of = AXLE},
                {.kind = TURNS, .of = AXLE},
                {.kind = SPEED, .of = NEEDLE},
                {.kind = POINT, .of = SENSOR},
                {.kind = POINT_VELOCITY, .of = SENSOR},
                {.kind = ACCELERATION, .of = HINGE},
                {.kind = ENERGY},
            },
        .inputs = 2,

        .controls = 8,
        .control =
            {
                {"Izz of the mast", offsetof(mechanism, body[MAST].inertia[2])},
                {"Iyz of the rotor", offsetof(mechanism, body[ROTOR].inertia[5])},
                {"Ixx of the sensor", offsetof(mechanism, body[SENSOR].inertia[0])},
                {"mass of the pointer", offsetof(mechanism, body[POINTER].mass)},
                {"com of the telescope", offsetof(mechanism, body[TELESCOPE].com[0])},
                {"turn of the hinge on the mast", offsetof(mechanism, joint[HINGE].on_child.degrees)},
                {"axis of the slide", offsetof(mechanism, joint[SLIDE].axis[0])},
                {"spring of the rail", offsetof(mechanism, joint[RAIL].stiffness)},
            },
};
