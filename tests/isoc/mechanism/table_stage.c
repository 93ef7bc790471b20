/* tests/isoc/mechanism/stage.scene in the tables of the independent dynamics. */
#include "tests/isoc/dynamics/tables.h"

enum { PLATE, QUILL, HEAD };

#define AT(body_index) .mechanism.body[body_index]
#define ON(joint_index) .mechanism.joint[joint_index]

const table the_table = {
    .mechanism.gravity = {0.0L, 0.0L, -9.81L},
    .mechanism.bodies = 3,

    AT(PLATE) = {2.0L, {0.030L, 0.010L, -0.020L}, {0.02L, 0.03L, 0.025L, 1e-3L, 2e-3L, -1e-3L}},
    AT(QUILL) = {0.7L, {0.005L, -0.005L, 0.060L}, {3e-3L, 4e-3L, 2e-3L, 2e-4L, -1e-4L, 3e-4L}},
    AT(HEAD) = {0.4L, {0.020L, 0.040L, 0.010L}, {8e-4L, 6e-4L, 9e-4L, 5e-5L, -4e-5L, 6e-5L}},

    ON(PLATE) = {PLANAR,
                 GROUND,
                 {{0.2L, 0.0L, 0.4L}, 25.0L, {1.0L, 0.0L, 1.0L}},
                 {{0.010L, 0.020L, 0.0L}, 35.0L, {0.0L, 0.0L, 1.0L}},
                 .axis = {0.0L, 1.0L, 0.0L},
                 .damping = 3.0L,
                 .spin_damping = 0.1L},
    ON(QUILL) = {CYLINDRICAL,
                 PLATE,
                 {{0.050L, -0.030L, 0.020L}, 40.0L, {1.0L, 0.0L, 0.0L}},
                 {{0.0L, 0.0L, -0.040L}, 15.0L, {0.0L, 1.0L, 0.0L}},
                 .axis = {1.0L, 1.0L, 2.0L},
                 .damping = 2.0L,
                 .spin_damping = 0.02L},
    ON(HEAD) = {UNIVERSAL,
                QUILL,
                {.at = {0.0L, 0.0L, 0.120L}},
                {{-0.010L, 0.0L, 0.0L}, 45.0L, {0.0L, 1.0L, 1.0L}},
                .axis = {1.0L, -1.0L, 0.0L},
                .second = {1.0L, 1.0L, 1.0L}},

    .mechanism.outputs = 5,
    .mechanism.output =
        {
            {.kind = POINT, .of = PLATE, .point = {0.1L, 0.1L, 0.0L}},
            {.kind = POINT, .of = HEAD, .point = {0.0L, 0.1L, 0.0L}},
            {.kind = POINT_VELOCITY, .of = HEAD, .point = {0.0L, 0.1L, 0.0L}},
            {.kind = ORIENTATION, .of = HEAD},
            {.kind = ENERGY},
        },

    .controls = 7,
    .control =
        {
            {"Ixy of the plate", offsetof(mechanism, body[PLATE].inertia[3])},
            {"com of the quill", offsetof(mechanism, body[QUILL].com[2])},
            {"turn of the bore", offsetof(mechanism, joint[QUILL].on_parent.degrees)},
            {"turn of the head", offsetof(mechanism, joint[HEAD].on_child.degrees)},
            {"damping of the table", offsetof(mechanism, joint[PLATE].damping)},
            {"damping of its turn", offsetof(mechanism, joint[PLATE].spin_damping)},
            {"damping of the bore", offsetof(mechanism, joint[QUILL].damping)},
        },
};
