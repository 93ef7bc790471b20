/* core/application/times.h over a scripted clock: the least and the most that a tick took, what is beside the ticks,
 * and which ticks of the port pass meanwhile. */
#define iso_port_clock fake_clock
#include "core/application/times.h"
#include "tests/tap.h"
#undef iso_port_clock

enum { PERIOD = 1600, SOON = PERIOD >> ISO_LATE_SHIFT };

static uint64_t now, passed;
static int readings;

/* It stands still for the two readings of a tick, and then goes on. */
uint64_t fake_clock(void)
{
    now += readings++ >= 2;
    return now;
}

void iso_loop_pass(iso_loop *const loop, const uint64_t ticks)
{
    passed += ticks;
    loop->due += ticks * loop->period;
}

/* A tick that was due at `due` and took `took`; then so much beside it. */
static void run(iso_times *const times, iso_loop *const loop, const uint64_t due, const uint64_t took,
                const uint64_t beside)
{
    loop->due = due;
    now = due + took;
    readings = 0;
    iso_times_done(times, loop);
    now += beside;
    passed = 0;
    readings = 1;
    iso_times_go_on(times, loop);
}

int main(void)
{
    static iso_loop loop;
    iso_times times = {0};
    loop.period = PERIOD;
    run(&times, &loop, PERIOD, 300, 0);
    tap_ok(times.tick_min == 300 && times.tick_max == 300, "the first tick is the least and the most");
    tap_count((uint32_t)passed, 0, "nothing beside it: no tick passes");
    run(&times, &loop, 2 * PERIOD, 200, 40);
    run(&times, &loop, 3 * PERIOD, 250, 2);
    tap_ok(times.tick_min == 200 && times.tick_max == 300, "a shorter tick is the least, one between them neither");
    run(&times, &loop, 4 * PERIOD, 400, 0);
    tap_ok(times.tick_min == 200 && times.tick_max == 400, "a longer one is the most");
    tap_count((uint32_t)times.beside, 42, "what was beside them");

    /* The next tick of the port is due at 6 periods: one that comes more than a sixteenth of a period behind does not
     * pass. */
    run(&times, &loop, 5 * PERIOD, 100, PERIOD - 100 - SOON - 1);
    tap_count((uint32_t)passed, 0, "done before the next tick is near: none passes");
    run(&times, &loop, 6 * PERIOD, 100, PERIOD - 100 - SOON);
    tap_count((uint32_t)passed, 1, "a tick that comes within a sixteenth of a period passes");
    tap_count((uint32_t)now, 7 * PERIOD,
              "when it has come: the port, asked before, would report one fewer than have passed");
    run(&times, &loop, 8 * PERIOD, 100, 3 * PERIOD);
    tap_count((uint32_t)passed, 3, "three periods beside it: three ticks pass");
    tap_count((uint32_t)now, 11 * PERIOD + 101, "all of them have come: one look at the clock");
    run(&times, &loop, 12 * PERIOD, PERIOD + 100, 0);
    tap_count((uint32_t)passed, 0, "a tick that lasts into the next one lets none pass: that one is late");
    tap_ok(times.next == 14 * PERIOD, "the first tick behind it is due");
    tap_done();
}
