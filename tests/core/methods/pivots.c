/* The watch over the pivots of closed loops, one of each closure, and the energy that it holds: each change by more
 * than ISO_PIVOT_CHANGE is seen in either direction, none that is less, and none in the first step. */
#include "core/methods/hold_energy.h"
#include "tests/tap.h"

enum { COUNT = 3 };

static const uint16_t closures[COUNT] = {0, 1, 3};

/* What is told of a step between these pivots, and the closure. */
static bool told(const real last[COUNT], const real now[COUNT], iso_nearness *const nearness)
{
    real kept[COUNT];
    memcpy(kept, last, sizeof kept);
    const iso_bits near = iso_watch_pivots(kept, now, closures, COUNT, nearness);
    tap_ok(memcmp(kept, now, sizeof kept) == 0 && nearness->known == UINT32_MAX, "the pivots are kept");
    tap_ok(near == 0 || near == (iso_bits) ~(iso_bits)0, "a mask");
    return near != 0;
}

static void test_watch(void)
{
    static const real before[COUNT] = {R(1.0), R(1e-3), R(20.0)};
    static const struct {
        real now[COUNT];
        uint32_t closure;
        const char *name;
    } cases[] = {
        {{R(1.0), R(1e-3), R(20.0)}, 0, "no change"},
        {{R(1.24), R(0.81e-3), R(24.9)}, 0, "changes by less than the factor"},
        {{R(1.26), R(1e-3), R(20.0)}, 1, "the first rises"},
        {{R(1.0), R(0.79e-3), R(20.0)}, 2, "the second falls"},
        {{R(1.0), R(1e-3), R(15.9)}, 4, "the third falls"},
        {{R(1.0), R(-1e-3), R(20.0)}, 2, "the second is negative"},
        {{R(2.0), R(1e-3), R(40.0)}, 4, "two closures: the last is told"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        iso_nearness nearness = {0, UINT32_MAX};
        tap_ok(told(before, cases[i].now, &nearness) == (cases[i].closure > 0) && nearness.closure == cases[i].closure,
               cases[i].name);
    }
    iso_nearness first = {0, 0};
    static const real none[COUNT] = {R(0.0), R(0.0), R(0.0)};
    tap_ok(!told(none, before, &first) && first.closure == 0, "the first step has nothing to compare with");
    iso_nearness stays = {3, UINT32_MAX};
    tap_ok(!told(before, before, &stays) && stays.closure == 3, "what was told stays until it is read");
}

/* A kinetic energy of `kinetic` above `rest` J: the one speed has its root. */
static void test_hold(void)
{
    const iso_bits near = (iso_bits) ~(iso_bits)0;
    iso_held_energy held = {R(0.0), 0};
    real speed = R(3.0);
    iso_hold_energy(&held, 0, R(10.0), R(1.0), &speed, 1);
    tap_same(speed, R(3.0), "a step that is not near keeps its speeds");
    tap_same(held.energy, R(10.0), "and its energy is kept");
    speed = R(6.0);
    iso_hold_energy(&held, near, R(38.0), R(2.0), &speed, 1);
    tap_ok(iso_abs(speed * speed - R(8.0)) <= R(32.0) * ISO_REAL_EPSILON, "near: the energy is that of before");
    speed = R(4.0);
    iso_hold_energy(&held, 0, R(20.0), R(4.0), &speed, 1);
    tap_ok(iso_abs(speed * speed - R(6.0)) <= R(32.0) * ISO_REAL_EPSILON, "so it is in the step after one");
    speed = R(4.0);
    iso_hold_energy(&held, 0, R(20.0), R(4.0), &speed, 1);
    tap_same(speed, R(4.0), "and not in the next");
    speed = R(1.0);
    iso_hold_energy(&held, near, R(31.0), R(30.0), &speed, 1);
    tap_same(speed, R(0.0), "where the rest is more than all: no speed");
    speed = R(0.0);
    iso_hold_energy(&held, near, R(5.0), R(5.0), &speed, 1);
    tap_same(speed, R(0.0), "at rest: no speed");
}

int main(void)
{
    test_watch();
    test_hold();
    tap_done();
}
