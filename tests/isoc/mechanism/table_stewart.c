/* models/stewart.scene in the tables of the independent dynamics. */
#include "tests/isoc/dynamics/tables.h"

enum { PLATFORM };

/* Leg n, from 1 to 6: its barrel hangs on the ground, its rod on the barrel, its ball closes the loop. */
#define BARREL(n) (2 * (n)-1)
#define ROD(n) (2 * (n))

/* From x, y (m) on the ground to u, v on the platform, `length` long at the start. */
#define LEG(n, x, y, u, v, length_of_spring)                                                                           \
    .mechanism.body[BARREL(n)] = {1.0L, {0.0L, 0.0L, 0.150L}, {8e-3L, 8e-3L, 4e-4L, 0.0L, 0.0L, 0.0L}},                \
    .mechanism.body[ROD(n)] = {0.5L, {0.0L, 0.0L, -0.150L}, {4e-3L, 4e-3L, 1e-4L, 0.0L, 0.0L, 0.0L}},                  \
    .mechanism.joint[BARREL(n)] = {UNIVERSAL,                                                                          \
                                   GROUND,                                                                             \
                                   {.at = {x, y, 0.0L}},                                                               \
                                   .axis = {1.0L, 0.0L, 0.0L},                                                         \
                                   .second = {0.0L, 1.0L, 0.0L}},                                                      \
    .mechanism.joint[ROD(n)] = {PRISMATIC,         BARREL(n),          .axis = {0.0L, 0.0L, 1.0L},                     \
                                .damping = 200.0L, .stiffness = 20e3L, .rest = length_of_spring,                       \
                                .input = n},                                                                           \
    .mechanism.closure[(n)-1] = {                                                                                      \
        .kind = SPHERICAL, .parent = PLATFORM, .child = ROD(n), .on_parent = {.at = {u, v, 0.0L}}}

const table the_table = {
    .mechanism.gravity = {0.0L, 0.0L, -9.81L},
    .mechanism.bodies = 13,
    .mechanism.closures = 6,

    .mechanism.body[PLATFORM] = {10.0L, {0.0L, 0.0L, 0.020L}, {0.25L, 0.25L, 0.45L, 0.0L, 0.0L, 0.0L}},
    .mechanism.joint[PLATFORM] = {.kind = FREE, .parent = GROUND},
    LEG(1, 0.489L, 0.104L, 0.201L, 0.223L, 0.67609540746850218491L),
    LEG(2, -0.155L, 0.476L, 0.093L, 0.285L, 0.67674589027196906946L),
    LEG(3, -0.335L, 0.372L, -0.293L, 0.062L, 0.6766564859661067344L),
    LEG(4, -0.335L, -0.372L, -0.293L, -0.062L, 0.6766564859661067344L),
    LEG(5, -0.155L, -0.476L, 0.093L, -0.285L, 0.67674589027196906946L),
    LEG(6, 0.489L, -0.104L, 0.201L, -0.223L, 0.67609540746850218491L),
    .inputs = 6,
    .spread = 0.5,

    .mechanism.outputs = 5,
    .mechanism.output =
        {
            {.kind = POINT, .of = PLATFORM},
            {.kind = ORIENTATION, .of = PLATFORM},
            {.kind = POSITION, .of = ROD(1)},
            {.kind = FORCE, .of = 0},
            {.kind = VIOLATION},
        },

    .controls = 4,
    .control =
        {
            {"com of the platform", offsetof(mechanism, body[PLATFORM].com[2])},
            {"Ixx of a barrel", offsetof(mechanism, body[BARREL(3)].inertia[0])},
            {"spring of a leg", offsetof(mechanism, joint[ROD(2)].stiffness)},
            {"place of a foot", offsetof(mechanism, joint[BARREL(5)].on_parent.at[0])},
        },
};
