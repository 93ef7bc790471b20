/* models/cart_pole.scene, its tunables at their defaults, in the tables of the independent dynamics. */
#include "tests/isoc/dynamics/tables.h"

enum { CART, ROD };
enum { RAIL, HINGE };

#define ROD_MASS 0.2L
#define HALF_LENGTH 0.25L
#define ROD_INERTIA (ROD_MASS * HALF_LENGTH * HALF_LENGTH / 3.0L)

const table the_table = {
    .mechanism.gravity = {0.0L, 0.0L, -9.81L},
    .mechanism.bodies = 2,
    .mechanism.body[CART] = {1.0L, {0.0L}, {0.0L}},
    .mechanism.body[ROD] = {ROD_MASS, {0.0L, 0.0L, HALF_LENGTH}, {ROD_INERTIA, ROD_INERTIA}},
    .mechanism.joint[RAIL] = {PRISMATIC, GROUND, .axis = {1.0L, 0.0L, 0.0L}, .damping = 0.1L, .input = 1},
    .mechanism.joint[HINGE] = {REVOLUTE, CART, .axis = {0.0L, 1.0L, 0.0L}, .damping = 0.002L},

    .mechanism.outputs = 6,
    .mechanism.output =
        {
            {.kind = POSITION, .of = RAIL},
            {.kind = SPEED, .of = RAIL},
            {.kind = POSITION, .of = HINGE},
            {.kind = SPEED, .of = HINGE},
            {.kind = ACCELERATION, .of = HINGE},
            {.kind = ENERGY},
        },
    .inputs = 1,

    .controls = 3,
    .control =
        {
            {"Iyy of the rod", offsetof(mechanism, body[ROD].inertia[1])},
            {"mass of the cart", offsetof(mechanism, body[CART].mass)},
            {"damping of the hinge", offsetof(mechanism, joint[HINGE].damping)},
        },
};
