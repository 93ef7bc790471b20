/* core/runtime/loop.h over a port whose every tick is scripted: the statistics must be exact to the count. */
#include "tests/core/runtime/loop/counter.h"

/* Runs so many ticks of the script; returns how many of them were good. */
static uint32_t run(const script *const what, const uint32_t ticks, const uint32_t failing_step)
{
    events = what;
    steps = published = primed = made_safe = 0;
    fail_at = failing_step;
    x[0] = x[1] = u[0] = p[0] = y[0] = R(-7.0);
    iso_loop_start(&loop, &plant);
    uint32_t good = 0;
    while (good < ticks && iso_loop_tick(&loop)) {
        good++;
    }
    return good;
}

/* Readings of the clock in a tick: at its beginning, before the step, after it, and at the end. At the end of a tick
 * that started on time and took nothing, so much of the period is left. */
enum { IDLE_MARGIN = PERIOD - 3 * READING };

static void test_start(void)
{
    const script quiet = {0};
    tap_count(run(&quiet, 0, 0), 0, "start: no tick yet");
    tap_same(x[0], R(0.0), "start: the state is the plant's start");
    tap_same(x[1], R(5.0), "start: of every state");
    tap_same(p[0], R(8.0), "start: the parameters are the defaults");
    tap_same(u[0], R(0.0), "start: the inputs are those of tick 0");
    tap_count(primed, 1, "start: the history is primed once");
    tap_same(state_when_primed, R(5.0), "start: after the state was set");
    tap_count((uint32_t)loop.statistics.ticks, 0, "start: nothing is accounted");
    tap_count(published, 1, "start: the outputs are published");
    tap_same(seen, R(0.0), "start: which are those of the start");
    tap_count((uint32_t)loop.overhead, READING, "start: the cost of reading the clock is measured");
}

static void test_quiet(void)
{
    const script quiet = {.cost = {0, 50, 70, 60}};
    tap_count(run(&quiet, 3, 0), 3, "quiet: three ticks");
    tap_count((uint32_t)loop.statistics.ticks, 3, "quiet: ticks");
    tap_count((uint32_t)loop.statistics.late, 0, "quiet: none late");
    tap_count((uint32_t)loop.statistics.lost, 0, "quiet: none lost");
    tap_count((uint32_t)loop.statistics.overruns, 0, "quiet: no overrun");
    tap_count((uint32_t)loop.statistics.execution_min, 50, "quiet: least execution time, without the clock's own");
    tap_count((uint32_t)loop.statistics.execution_max, 70, "quiet: greatest execution time");
    tap_count((uint32_t)loop.statistics.execution_sum, 180, "quiet: sum of the execution times");
    tap_count((uint32_t)loop.statistics.margin, IDLE_MARGIN - 70, "quiet: least margin");
    tap_count(waits, 3, "quiet: one wait a tick");
    tap_count(published, 1 + 3, "quiet: outputs are published at the start and once a tick");
    tap_same(seen, R(30.0), "quiet: the outputs are those of the state after the step");
    tap_same(latched, R(2.0), "quiet: the inputs are driven with the time before the step");
    tap_same(input_of_step, R(102.0), "quiet: what the platform measures overwrites them");
}

/* Late is more than a sixteenth of the period from due to the beginning of the step, the first reading of the clock,
 * which takes READING. How long the inputs take counts. */
static void test_late(void)
{
    enum { LIMIT = PERIOD / 16 };
    const script late = {.delay = {0, 0, LIMIT - READING, LIMIT - READING + 1, 700}};
    tap_count(run(&late, 6, 0), 6, "late: six ticks");
    tap_count((uint32_t)loop.statistics.late, 2, "late: two are late, the one at the limit is not");
    tap_count((uint32_t)loop.statistics.lost, 0, "late: none lost");
    tap_count((uint32_t)loop.statistics.overruns, 0, "late: no overrun");
    tap_count((uint32_t)loop.statistics.margin, IDLE_MARGIN - 700, "late: the margin shrinks by the delay");
    tap_count((uint32_t)loop.statistics.execution_max, 0, "late: a delay is not execution time");

    const script inputs = {.inputs = PERIOD / 2};
    tap_count(run(&inputs, 6, 0), 6, "slow inputs: six ticks");
    tap_count((uint32_t)loop.statistics.late, 6, "slow inputs: each step begins late");
    tap_count((uint32_t)loop.statistics.margin, IDLE_MARGIN - PERIOD / 2, "slow inputs: the margin shrinks by them");
}

/* Tick 3 is never reported: tick 4 tells, when 3 is a whole period old; both are done then, one after the other. */
static void test_lost(void)
{
    const script lost = {.lost = {[3] = true}};
    tap_count(run(&lost, 6, 0), 6, "lost: six ticks");
    tap_count((uint32_t)loop.statistics.lost, 1, "lost: one");
    tap_count((uint32_t)loop.statistics.late, 1, "lost: the one that was made up for is late");
    tap_count((uint32_t)loop.statistics.overruns, 1, "lost: and ends after the next was due");
    tap_count(waits, 5, "lost: no wait for a tick that is already due");
    tap_same(x[0], R(6.0), "lost: no step is missing");
    tap_ok(loop.statistics.margin == IDLE_MARGIN - PERIOD, "lost: the margin is negative");

    const script three = {.lost = {[2] = true, [3] = true, [4] = true}};
    tap_count(run(&three, 6, 0), 6, "lost in a row: six ticks");
    tap_count((uint32_t)loop.statistics.lost, 3, "lost in a row: three");
    tap_count((uint32_t)loop.statistics.overruns, 3, "lost in a row: each an overrun");
    tap_ok(loop.statistics.margin == IDLE_MARGIN - 3 * PERIOD, "lost in a row: the margin is that of the first");
}

/* Tick 2 takes two and a half periods: 3 and 4 come due meanwhile and start late; from 5 on all is well. */
static void test_slow(void)
{
    const script slow = {.cost = {[2] = 5 * PERIOD / 2}};
    tap_count(run(&slow, 7, 0), 7, "slow: seven ticks");
    tap_count((uint32_t)loop.statistics.overruns, 2, "slow: the slow tick and the next end after their time");
    tap_count((uint32_t)loop.statistics.late, 2, "slow: two start late");
    tap_count((uint32_t)loop.statistics.lost, 1, "slow: the first of them is told of only with the second");
    tap_count((uint32_t)loop.statistics.execution_max, 5 * PERIOD / 2, "slow: the execution time is the step's");
    tap_count((uint32_t)loop.statistics.execution_min, 0, "slow: the others take nothing");
    tap_same(x[0], R(7.0), "slow: no step is missing");
    tap_ok(loop.statistics.margin == IDLE_MARGIN - 5 * PERIOD / 2, "slow: the margin is negative");
}

static void test_exactly_full(void)
{
    const script full = {.cost = {[1] = IDLE_MARGIN, [3] = IDLE_MARGIN + 1}};
    tap_count(run(&full, 1, 0), 1, "full: one tick that takes its whole period");
    tap_count((uint32_t)loop.statistics.overruns, 0, "full: is no overrun");
    tap_count((uint32_t)loop.statistics.margin, 0, "full: margin 0");
    tap_count(run(&full, 3, 0), 3, "full: and one that takes a count more");
    tap_count((uint32_t)loop.statistics.overruns, 1, "full: is an overrun");
    tap_ok(loop.statistics.margin == -1, "full: margin -1");
}

/* After tick 2 the plant rests for so many calls, then goes on to tick 5. */
static void rest(const script *const what, const uint32_t calls)
{
    (void)run(what, 2, 0);
    for (uint32_t i = 0; i < calls; i++) {
        iso_loop_rest(&loop);
    }
    for (int i = 0; i < 3; i++) {
        (void)iso_loop_tick(&loop);
    }
}

static void test_rest(void)
{
    const script quiet = {0};
    rest(&quiet, 4);
    tap_count((uint32_t)loop.tick, 5, "rest: the plant has its ticks");
    tap_count((uint32_t)(loop.reported + loop.rested), 9, "rest: the port has four more");
    tap_count((uint32_t)loop.rested, 4, "rest: which passed");
    tap_count((uint32_t)loop.statistics.ticks, 5, "rest: they are not accounted");
    tap_same(x[0], R(5.0), "rest: nor is a step made");
    tap_same(latched, R(4.0), "rest: and the plant's time stands still");
    tap_count(published, 1 + 5, "rest: and nothing is published");
    tap_ok(loop.statistics.late == 0 && loop.statistics.lost == 0 && loop.statistics.overruns == 0,
           "rest: none is late, lost or overrun");
    tap_count((uint32_t)loop.statistics.margin, IDLE_MARGIN, "rest: the margin is that of its ticks");

    const script lost = {.lost = {[4] = true, [5] = true}, .delay = {[3] = 700, [6] = 900, [9] = 300}};
    rest(&lost, 2);
    tap_count((uint32_t)loop.rested, 4, "rest: what the port loses meanwhile passes");
    tap_ok(loop.statistics.lost == 0 && loop.statistics.late == 1, "rest: only what is late afterwards is late");
    tap_count((uint32_t)loop.statistics.margin, IDLE_MARGIN - 300, "rest: and counts in the margin");

    /* Tick 2 takes two and a half periods: 3 and 4 would be caught up. */
    const script slow = {.cost = {[2] = 5 * PERIOD / 2}};
    rest(&slow, 1);
    tap_count((uint32_t)loop.rested, 2, "rest: ticks that were to be caught up pass");
    tap_ok(loop.statistics.late == 0 && loop.statistics.lost == 0 && loop.statistics.overruns == 1,
           "rest: and are not late; the slow tick remains an overrun");
    tap_count(waits, 2 + 1 + 3, "rest: it waits once");
}

/* From tick 4 to tick 7, then back to tick 1: the plant's time is another, the port's goes on. */
static void test_jump_to(void)
{
    const script quiet = {0};
    (void)run(&quiet, 4, 0);
    y[0] = R(99.0);
    iso_loop_jump(&loop, 7);
    tap_same(seen, R(99.0), "jump to: the outputs are published as they are");
    tap_ok(loop.tick == 7 && published == 1 + 4 + 1, "jump to: the tick is that");
    (void)iso_loop_tick(&loop);
    tap_ok(latched == R(7.0) && loop.tick == 8 && waits == 5, "jump to: the next tick of the port is the one after it");
    iso_loop_jump(&loop, 1);
    (void)iso_loop_tick(&loop);
    tap_ok(latched == R(1.0) && loop.tick == 2 && waits == 6, "jump to: back as well");
    iso_loop_rest(&loop);
    (void)iso_loop_tick(&loop);
    tap_ok(latched == R(2.0) && loop.tick == 3 && waits == 8, "jump to: and rests there");
    tap_ok(loop.statistics.ticks == 7 && loop.statistics.late == 0 && loop.statistics.lost == 0,
           "jump to: the account goes on");
    tap_count((uint32_t)loop.statistics.margin, IDLE_MARGIN, "jump to: and no tick is late");

    /* With ticks to be caught up: tick 2 takes two and a half periods, 3 and 4 are due. */
    const script slow = {.cost = {[2] = 5 * PERIOD / 2}};
    (void)run(&slow, 3, 0);
    iso_loop_jump(&loop, 100);
    (void)iso_loop_tick(&loop);
    tap_ok(latched == R(100.0) && waits == 3 && loop.statistics.late == 2, "jump to: a tick that is due is caught up");
}

static void test_guard(void)
{
    const script quiet = {0};
    tap_count(run(&quiet, 9, 4), 3, "guard: three good ticks before the state is infinite");
    tap_count((uint32_t)loop.guard, 1, "guard: names the state");
    tap_count((uint32_t)loop.tick, 4, "guard: names the tick");
    tap_count((uint32_t)loop.statistics.ticks, 3, "guard: the bad tick is not accounted");
    tap_count(published, 1 + 3, "guard: nor published");
    tap_same(y[0], R(30.0), "guard: the last good outputs stand");
    tap_count(made_safe, 1, "guard: the port is put into its safe state, once");
    tap_same(seen_before_safe, R(30.0), "guard: after the last good outputs");
    tap_count(run(&quiet, 9, 0), 9, "guard: a new start is good again");
    tap_count(made_safe, 0, "guard: no safe state while all is well");
    tap_count((uint32_t)loop.guard, model.states, "guard: no state is named while all are finite");
}

/* The second state leaves its range downwards by an ulp; it may stay at its end. The first has none. */
static void test_range(void)
{
    const script quiet = {0};
    range[1] = R(8.0);
    leave_at = 4;
    tap_count(run(&quiet, 9, 0), 3, "range: three good ticks before the state is too large");
    tap_count((uint32_t)loop.guard, 1, "range: names the state");
    tap_count((uint32_t)loop.tick, 4, "range: names the tick");
    tap_count(published, 1 + 3, "range: the bad tick is not published");
    tap_same(y[0], R(30.0), "range: the last good outputs stand");
    leave_at = 0;
    range[1] = R(5.0);
    tap_count(run(&quiet, 9, 0), 9, "range: a state at the end of its range is good");
    range[1] = ISO_REAL_MAX;
}

/* How far off its closures the plant is: at the limit after two ticks and six, above it after three and five. */
static real violation(const void *const memory)
{
    static const real off[] = {R(0.0), R(0.25), R(0.5), R(0.75), R(0.125), R(2.0), R(0.5)};
    (void)memory;
    return off[(int)x[0]];
}

static void test_violation(void)
{
    static const script quiet;
    iso_model closing = model;
    closing.violation = violation;
    closing.violation_limit = R(0.5);
    closing.tell = iso_plant_tell;
    iso_plant closed = plant;
    closed.model = &closing;
    events = &quiet;
    steps = fail_at = 0;
    iso_loop_start(&loop, &closed);
    for (int i = 0; i < 6; i++) {
        (void)iso_loop_tick(&loop);
    }
    tap_count((uint32_t)loop.statistics.violated, 2, "violation: ticks above the limit are counted");
    tap_same(loop.statistics.violation, R(2.0), "violation: the largest is kept");
    tap_ok(run(&quiet, 6, 0) == 6 && loop.statistics.violated == 0, "violation: a plant without closures has none");
}

static bool account(iso_loop *const of, const iso_news *const news)
{
    (void)of;
    (void)news;
    return true;
}

/* Outputs that are published when the next tick begins: whatever the step takes, at the same time of the period. */
static void test_delayed(void)
{
    static const script costs = {.cost = {0, 50, 700, 90}};
    static const iso_policy policy = {.account = account, .delays = true};
    iso_model delaying = model;
    delaying.policy = &policy;
    iso_plant delayed = plant;
    delayed.model = &delaying;
    events = &costs;
    steps = fail_at = published = 0;
    iso_loop_start(&loop, &delayed);
    bool on_time = published == 1;
    for (uint32_t i = 0; i < 4; i++) {
        const real last = y[0];
        on_time = on_time && iso_loop_tick(&loop) && published == 2 + i && seen == last && published_late == 0;
    }
    tap_ok(on_time && y[0] == R(40.0), "delayed: the outputs of a tick are published when the next one begins");
    tap_ok(run(&costs, 4, 0) == 4 && seen == R(40.0) && published_late > 0,
           "delayed: without that, when they are made");
}

int main(void)
{
    test_start();
    test_quiet();
    test_late();
    test_lost();
    test_slow();
    test_exactly_full();
    test_rest();
    test_jump_to();
    test_guard();
    test_range();
    test_violation();
    test_delayed();
    tap_done();
}
