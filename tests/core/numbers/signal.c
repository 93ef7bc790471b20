/* core/numbers/signal.h: phases, ramps and times of the integer tick. */
#include "core/numbers/signal.h"
#include "tests/tap.h"

static const uint64_t quarter = UINT64_C(1) << 62;

static void test_phase(void)
{
    const real half_pi = R(1.57079632679489662);
    tap_same(iso_phase(0, quarter, 0), R(0.0), "phase: 0 at the start");
    tap_same(iso_phase(1, quarter, 0), half_pi, "phase: a quarter of a turn is pi/2");
    tap_same(iso_phase(2, quarter, 0), -(half_pi + half_pi), "phase: half a turn is -pi");
    tap_same(iso_phase(3, quarter, 0), -half_pi, "phase: three quarters are -pi/2");
    tap_same(iso_phase(4, quarter, 0), R(0.0), "phase: a whole turn is 0");
    tap_same(iso_phase(0, 0, quarter), half_pi, "phase: starts where it is told");
    tap_same(iso_phase(1, UINT64_C(0) - quarter, 0), -half_pi, "phase: turns backwards");
    tap_same(iso_phase(4000000001u, quarter, 0), half_pi, "phase: exact after four thousand million ticks");
    tap_same(iso_phase((UINT64_C(1) << 40) + 1, 1 + quarter, UINT64_C(0) - (UINT64_C(1) << 40) - 1), half_pi,
             "phase: and beyond 2^32");
}

/* The phase after many ticks is the phase of the increment added up so many times: no error grows. */
static void test_long(void)
{
    const uint64_t increment = UINT64_C(0x0123456789ABCDEF);
    uint64_t sum = 77;
    uint32_t wrong = 0, outside = 0;
    for (uint32_t tick = 0; tick < 5000; tick++) {
        wrong += iso_bits_of(iso_phase(tick, increment, 77)) != iso_bits_of(iso_phase(0, 0, sum));
        outside += iso_abs(iso_phase(tick, increment, 77)) > R(3.14159274101257324);
        sum += increment;
    }
    tap_count(wrong, 0, "phase: tick times increment, for 5000 ticks");
    tap_count(outside, 0, "phase: stays within pi, for 5000 ticks");
}

static void test_ramp(void)
{
    tap_same(iso_ramp(0, 10, R(0.25), R(4.0)), R(0.0), "ramp: 0 before it begins");
    tap_same(iso_ramp(10, 10, R(0.25), R(4.0)), R(0.0), "ramp: 0 at the tick before its fraction");
    tap_same(iso_ramp(11, 10, R(0.25), R(4.0)), R(0.75), "ramp: the ticks since its beginning");
    tap_same(iso_ramp(14, 10, R(0.25), R(4.0)), R(3.75), "ramp: up to its end");
    tap_same(iso_ramp(15, 10, R(0.25), R(4.0)), R(4.0), "ramp: holds its length");
    tap_same(iso_ramp(UINT32_MAX, 10, R(0.25), R(4.0)), R(4.0), "ramp: for ever");
    tap_same(iso_ramp((UINT64_C(1) << 32) + 12, 10, R(0.25), R(4.0)), R(4.0), "ramp: beyond 2^32 too");
    tap_same(iso_ramp(0, 0, R(0.0), R(0.0)), R(0.0), "ramp: of no length");
}

static void test_since(void)
{
    tap_ok(iso_since(0, 10, R(0.25)) < R(-1.0), "since: long before, less than a tick before");
    tap_same(iso_since(9, 10, R(0.25)), R(-1.25), "since: the tick before");
    tap_same(iso_since(10, 10, R(0.25)), R(-0.25), "since: within the tick in which it begins");
    tap_same(iso_since(11, 10, R(0.25)), R(0.75), "since: the ticks since its beginning");
    tap_same(iso_since(0, 0, R(0.0)), R(0.0), "since: tick 0");
    tap_same(iso_since(UINT32_MAX, UINT32_C(4294967285), R(0.5)), R(9.5), "since: as exact after a long time");
    tap_same(iso_since(UINT64_C(1) << 40, 0, R(0.0)), R(1099511627776.0), "since: goes on beyond 2^32");
    tap_same(iso_since((UINT64_C(1) << 32) + 5, UINT32_MAX, R(0.5)), R(5.5), "since: as exact there");
}

int main(void)
{
    test_phase();
    test_long();
    test_ramp();
    test_since();
    tap_done();
}
