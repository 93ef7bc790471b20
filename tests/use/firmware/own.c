/* Firmware of its own around two plants, one of them twice: they share nothing, and a copy of the memory is a snapshot.
 * C11, and C++17 as well. */
#include "cart.h"
#include "swing.h"

#include <stdio.h>

enum { STEPS = 500 };

static int tests, failures;

static void ok(const bool passed, const char *const name)
{
    tests++;
    failures += passed ? 0 : 1;
    printf("%sok %d - %s\n", passed ? "" : "not ", tests, name);
}

static void run(const iso_plant *const plant, const int steps)
{
    for (int i = 0; i < steps; i++) {
        plant->model->step(plant->memory);
    }
    plant->model->output(plant->memory);
}

static bool same(const void *const a, const void *const b, const size_t bytes)
{
    return memcmp(a, b, bytes) == 0;
}

static void test_instances(void)
{
    static cart_memory left, right, alone, snapshot;
    static swing_memory beside, swing_alone;
    const iso_plant one = cart_plant(&left), two = cart_plant(&right), three = cart_plant(&alone);
    const iso_plant other = swing_plant(&beside), other_alone = swing_plant(&swing_alone);
    iso_plant_start(&one);
    iso_plant_start(&two);
    iso_plant_start(&other);
    right.u[CART_U_FORCE] = (real)1;
    right.p[CART_P_RAIL_DAMPING] = (real)3;
    for (int i = 0; i < STEPS; i++) {
        run(&one, 1);
        run(&other, 1);
        run(&two, 1);
    }
    iso_plant_start(&three);
    run(&three, STEPS);
    ok(same(&left, &alone, sizeof alone), "an instance moves as if it were alone");
    iso_plant_start(&other_alone);
    run(&other_alone, STEPS);
    ok(same(&beside, &swing_alone, sizeof swing_alone), "so does another plant");
    ok(!same(left.y, right.y, sizeof left.y), "found: two instances of other inputs and parameters differ");

    snapshot = left;
    run(&one, STEPS);
    ok(!same(&snapshot, &left, sizeof left), "found: the plant moves on");
    alone = left;
    left = snapshot;
    run(&one, STEPS);
    ok(same(&left, &alone, sizeof left), "a copy of the memory is a snapshot");
}

static void test_tables(void)
{
    const iso_quantity *const damping = &cart_parameters[CART_P_RAIL_DAMPING];
    ok(strcmp(cart_states[CART_X_HINGE_SPEED].name, "hinge_speed") == 0 &&
           strcmp(cart_states[CART_X_HINGE_SPEED].unit, "rad/s") == 0 &&
           strcmp(cart_inputs[CART_U_FORCE].unit, "N") == 0 && strcmp(cart_outputs[CART_Y_ENERGY].unit, "J") == 0,
       "the header knows names and units");
    ok(strcmp(damping->unit, "N*s/m") == 0 && damping->least == (real)0.5 && damping->most == (real)4 &&
           damping->start == (real)2,
       "and the limits and the default of a tunable");
    ok(cart_inputs[CART_U_FORCE].most >= ISO_REAL_MAX, "an input has no limits");
}

int main(void)
{
    test_instances();
    test_tables();
    printf("1..%d\n", tests);
    return failures == 0 ? 0 : 1;
}
