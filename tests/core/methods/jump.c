/* Steps that find a discontinuity in the loop, and the same plant without it. */
#include "tests/core/runtime/loop/counter.h"

/* A step that finds a jump is made again from where it began; all other memory is as it was, the error is not. */
static struct {
    real x[2], u[1], p[1], y[1], good[3];
    iso_progress progress;
} watched_memory, watched_before;

static void watched_step(void *const memory)
{
    (void)memory;
    steps++;
    watched_memory.x[0] += primed > 1 ? R(1.0) : R(100.0);
    watched_memory.x[1] = R(3.0);
    watched_memory.progress.usual += R(1.0);
    watched_memory.progress.discontinuity = steps == 1 || steps == 4 || steps == 5;
    now += events->cost[steps];
}

static void watched_prime(void *const memory)
{
    enum { PRIMING = 40 };
    (void)memory;
    primed++;
    now += PRIMING;
    state_when_primed = watched_memory.x[0] + watched_memory.x[1];
}

static bool watched_discontinuity(void *const memory)
{
    (void)memory;
    return steps < 2;
}

static void watched_drive(void *const memory, const uint64_t tick)
{
    (void)memory;
    watched_memory.u[0] = (real)tick;
}

static void watched_output(void *const memory)
{
    (void)memory;
    watched_memory.y[0] = watched_memory.x[0] + watched_memory.u[0];
}

static uint32_t watched_finish(void *const memory)
{
    return iso_finish(memory, watched_memory.x, range, 2, NULL, watched_output, watched_memory.y,
                      watched_memory.good + 2, 1);
}

static const iso_model watched_model = {
    .period_ns = PERIOD,
    .states = 2,
    .start = start,
    .range = range,
    .memory_bytes = sizeof watched_memory,
    .output = watched_output,
    .drive = watched_drive,
    .prime = watched_prime,
    .step = watched_step,
    .attempt = iso_plant_attempt,
    .finish = watched_finish,
};

static iso_plant watched_plant(const iso_model *const of)
{
    return (iso_plant){
        .model = of,
        .memory = &watched_memory,
        .x = watched_memory.x,
        .u = watched_memory.u,
        .p = watched_memory.p,
        .y = watched_memory.y,
        .progress = &watched_memory.progress,
        .before = &watched_before,
        .good = watched_memory.good,
    };
}

static void test_jump(void)
{
    static const script costs = {.cost = {0, 10, 10, 20, 30, 50, 10}};
    iso_model watching = watched_model;
    const iso_plant watched = watched_plant(&watching);
    events = &costs;
    steps = primed = 0;
    iso_loop_start(&loop, &watched);
    tap_ok(iso_loop_tick(&loop) && steps == 2 && primed == 2, "jump: the step is made again, with a new history");
    tap_same(state_when_primed, R(5.0), "jump: which is that of the state before the step");
    tap_same(watched_memory.x[0], R(1.0), "jump: the step begins there too");
    tap_same(watched_memory.progress.usual, R(2.0), "jump: but the error stays known");
    tap_count((uint32_t)loop.statistics.restarts, 1, "jump: and is accounted");
    tap_ok(iso_loop_tick(&loop) && steps == 3 && loop.statistics.restarts == 1,
           "jump: a step without one is made once");
    tap_ok(iso_loop_tick(&loop) && steps == 5 && loop.statistics.restarts == 2, "jump: a step is made again only once");
    tap_ok(iso_loop_tick(&loop) && loop.statistics.execution_min == 10 && loop.statistics.execution_max == 20 &&
               loop.statistics.execution_sum == 30,
           "jump: the steps without are timed by themselves");
    tap_count((uint32_t)loop.statistics.restart_max, 30 + 40 + 50, "jump: the dearest with one is all that it took");
    tap_count((uint32_t)loop.statistics.ticks, 4, "jump: all are ticks");

    watching.discontinuity = watched_discontinuity;
    steps = primed = 0;
    iso_loop_start(&loop, &watched);
    tap_ok(iso_loop_tick(&loop) && steps == 1 && primed == 2, "jump: after a new history a step is not made again");
    tap_count((uint32_t)loop.statistics.restarts, 1, "jump: which is one restart");
    watched_memory.x[0] = iso_real_of(ISO_EXPONENT_BITS);
    tap_ok(!iso_loop_tick(&loop) && primed == 3 && loop.statistics.restarts == 1,
           "jump: a restart of a bad tick is not");
}

/* The loop without its port: a plant that is driven by iso_plant_tick ends in the same memory. */
static void test_plant_tick(void)
{
    enum { TICKS = 7 };
    static const script quiet;
    iso_model watching = watched_model;
    watching.discontinuity = watched_discontinuity;
    const iso_plant watched = watched_plant(&watching);
    events = &quiet;
    steps = primed = 0;
    iso_loop_start(&loop, &watched);
    for (uint32_t i = 0; i < TICKS; i++) {
        (void)iso_loop_tick(&loop);
    }
    static unsigned char by_loop[sizeof watched_memory];
    memcpy(by_loop, &watched_memory, sizeof watched_memory);
    const uint32_t made = steps, primes = primed;
    steps = primed = 0;
    iso_plant_start(&watched);
    bool good = true;
    for (uint32_t i = 0; i < TICKS; i++) {
        good = good && iso_plant_tick(&watched, i) == watched_model.states;
    }
    tap_ok(good && memcmp(by_loop, &watched_memory, sizeof watched_memory) == 0 && watched_memory.y[0] != R(0.0),
           "plant_tick: the same memory as by the loop");
    tap_ok(steps == made && primed == primes && made > TICKS, "plant_tick: as many steps and restarts");
    watched_memory.x[0] = iso_real_of(ISO_EXPONENT_BITS);
    const real last = watched_memory.y[0];
    tap_ok(iso_plant_tick(&watched, TICKS) == 0 && watched_memory.y[0] == last,
           "plant_tick: the guard names the state");
}

int main(void)
{
    test_jump();
    test_plant_tick();
    tap_done();
}
