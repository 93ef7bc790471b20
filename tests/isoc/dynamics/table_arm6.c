/* models/arm6.scene in the tables of the independent dynamics. */
#include "tests/isoc/dynamics/tables.h"

enum { TRUNK, UPPER_ARM, FOREARM, WRIST, HAND, FLANGE };
enum { WAIST, SHOULDER, ELBOW, ROLL, PITCH, SPIN };

#define AT(body_index) .mechanism.body[body_index]
#define ON(joint_index) .mechanism.joint[joint_index]
#define X_AXIS .axis = {1.0L, 0.0L, 0.0L}
#define Z_AXIS .axis = {0.0L, 0.0L, 1.0L}
#define TEN_DEGREES (3.14159265358979323846264338327950288L / 18.0L)

const table the_table = {
    .mechanism.gravity = {0.0L, 0.0L, -9.81L},
    .mechanism.bodies = 6,

    AT(TRUNK) = {12.9L, {-0.008L, 0.026L, 0.110L}, {0.412L, 0.395L, 0.118L, 4.1e-3L, -7.3e-3L, 1.9e-2L}},
    AT(UPPER_ARM) = {17.4L, {0.068L, 0.006L, -0.016L}, {0.130L, 0.524L, 0.539L, -2.4e-3L, 1.1e-2L, 3.7e-3L}},
    AT(FOREARM) = {4.8L, {0.0L, -0.070L, 0.014L}, {0.066L, 0.0125L, 0.076L, 1.2e-3L, -6.0e-4L, 2.1e-3L}},
    AT(WRIST) = {0.82L, {0.0L, 0.0015L, -0.019L}, {1.8e-3L, 1.8e-3L, 1.3e-3L, 2e-5L, -3e-5L, 4e-5L}},
    AT(HAND) = {0.34L, {0.0004L, -0.002L, 0.003L}, {3.0e-4L, 4.0e-4L, 3.0e-4L, 1e-5L, 2e-5L, -1e-5L}},
    AT(FLANGE) = {0.09L, {0.001L, -0.0005L, 0.032L}, {1.5e-4L, 1.5e-4L, 4.0e-5L, 1e-6L, -2e-6L, 3e-6L}},

    ON(WAIST) = {REVOLUTE, GROUND, {.at = {0.0L, 0.0L, 0.67L}}, Z_AXIS, .damping = 3.0L, .input = 1},
    ON(SHOULDER) = {REVOLUTE, TRUNK, {{0.0L, 0.15L, 0.0L}, -90.0L, X_AXIS}, Z_AXIS, .damping = 4.0L, .input = 2},
    ON(ELBOW) = {REVOLUTE, UPPER_ARM, {.at = {0.4318L, 0.0L, -0.0203L}}, Z_AXIS, .damping = 2.0L, .input = 3},
    ON(ROLL) = {REVOLUTE, FOREARM, {{0.0203L, -0.4331L, 0.0L}, 90.0L, X_AXIS}, Z_AXIS, .damping = 0.2L, .input = 4},
    ON(PITCH) = {REVOLUTE,
                 WRIST,
                 {{0.0L, 0.0L, 0.0L}, -90.0L, X_AXIS},
                 Z_AXIS,
                 .damping = 0.1L,
                 .stiffness = 0.5L,
                 .rest = TEN_DEGREES,
                 .input = 5},
    ON(SPIN) = {REVOLUTE, HAND, {{0.0L, 0.0L, 0.0L}, 90.0L, X_AXIS}, Z_AXIS, .damping = 0.005L, .input = 6},

    .mechanism.outputs = 8,
    .mechanism.output =
        {
            {.kind = POSITION, .of = WAIST},
            {.kind = POSITION, .of = SHOULDER},
            {.kind = POSITION, .of = ELBOW},
            {.kind = TURNS, .of = SPIN},
            {.kind = POINT, .of = FLANGE, .point = {0.0L, 0.0L, 0.056L}},
            {.kind = POINT_VELOCITY, .of = FLANGE, .point = {0.0L, 0.0L, 0.056L}},
            {.kind = ACCELERATION, .of = SHOULDER},
            {.kind = ENERGY},
        },
    .inputs = 6,

    .controls = 6,
    .control =
        {
            {"Ixx of the forearm", offsetof(mechanism, body[FOREARM].inertia[0])},
            {"Iyz of the wrist", offsetof(mechanism, body[WRIST].inertia[5])},
            {"mass of the hand", offsetof(mechanism, body[HAND].mass)},
            {"com of the flange", offsetof(mechanism, body[FLANGE].com[2])},
            {"place of the elbow", offsetof(mechanism, joint[ELBOW].on_parent.at[0])},
            {"damping of the pitch", offsetof(mechanism, joint[PITCH].damping)},
        },
};
