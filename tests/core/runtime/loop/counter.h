/* The loop over a port whose every tick is scripted, and a plant that counts. The file under test is compiled into this
 * one with the port's functions renamed, so that the same test runs beside any port. */
#ifndef ISO_TESTS_UNIT_LOOP_COUNTER_H
#define ISO_TESTS_UNIT_LOOP_COUNTER_H

#include "core/methods/all.h"
#include "core/methods/method.h"
#include "core/runtime/loop.h"
#include "port/port.h"
#include "tests/tap.h"

#undef iso_port_read
#undef iso_port_publish
#define iso_port_safe fake_safe
#define iso_port_start fake_start
#define iso_port_wait fake_wait
#define iso_port_clock fake_clock
#define iso_port_read fake_read
#define iso_port_publish fake_publish

enum { PERIOD = 1600, READING = 3, TICKS_MAX = 16 };

/* The script: when tick k (from 1) is reported, after it was due, and how long its step takes. */
typedef struct script {
    uint32_t delay[TICKS_MAX];
    uint32_t cost[TICKS_MAX];
    uint32_t inputs; /* how long the inputs of a tick take */
    bool lost[TICKS_MAX];
    uint32_t clock_at_start;
} script;

static const script *events;
static uint32_t now;      /* counts since the start */
static uint32_t reported; /* the latest tick that the loop was told of */
static uint32_t waits;

static uint32_t fake_start(const uint32_t period_ns)
{
    now = events->clock_at_start;
    reported = 0;
    waits = 0;
    return period_ns;
}

/* The latest tick that is due and not lost; if the loop knows it, idles until the next one is reported. */
static uint64_t fake_wait(void)
{
    uint32_t next = reported + 1;
    while (events->lost[next]) {
        next++;
    }
    const uint32_t at = events->clock_at_start + next * PERIOD + events->delay[next];
    if ((int32_t)(at - now) > 0) {
        now = at;
    }
    const uint32_t due = (now - events->clock_at_start) / PERIOD;
    reported = due > next ? due : next;
    waits++;
    return reported;
}

/* Every reading takes READING counts, which the loop must not take for the plant's. */
static uint64_t fake_clock(void)
{
    now += READING;
    return now - events->clock_at_start;
}

static real latched;
static uint32_t published;
static real seen;

static void fake_read(real *const u, const size_t inputs)
{
    now += events->inputs;
    if (inputs == 1) {
        latched = u[0];
        u[0] += R(100.0);
    }
}

static uint32_t published_late; /* when the last was, after its tick was due */

static void fake_publish(const real *const y, const size_t outputs)
{
    if (outputs > 0) {
        published++;
        published_late = (now - events->clock_at_start) % PERIOD;
        seen = outputs == 1 ? y[0] : R(-1.0);
    }
}

static uint32_t made_safe; /* calls, and the last outputs that were published before */
static real seen_before_safe;

static void fake_safe(void)
{
    made_safe++;
    seen_before_safe = seen;
}

#include "core/runtime/loop.c"

/* A plant that counts: x is the number of steps, u the tick that drives it, and a step costs what the script says. */
static real x[2], u[1], p[1], y[1], kept[3];
static const real start[2] = {R(0.0), R(5.0)};
static const real defaults[1] = {R(8.0)};
static uint32_t primed, steps, fail_at, leave_at;
static real range[2] = {ISO_REAL_MAX, ISO_REAL_MAX};
static real input_of_step, state_when_primed;

static void output(void *const memory)
{
    (void)memory;
    y[0] = R(10.0) * x[0];
}

static void drive(void *const memory, const uint64_t tick)
{
    (void)memory;
    u[0] = (real)tick;
}

static void prime(void *const memory)
{
    (void)memory;
    primed++;
    state_when_primed = x[1];
}

static void step(void *const memory)
{
    (void)memory;
    steps++;
    now += events->cost[steps];
    input_of_step = u[0];
    x[0] += R(1.0);
    if (steps == fail_at) {
        x[1] = iso_real_of(ISO_EXPONENT_BITS);
    }
    if (steps == leave_at) {
        x[1] = -(range[1] + range[1] * ISO_REAL_EPSILON);
    }
}

static uint32_t finish(void *const memory)
{
    return iso_finish(memory, x, range, 2, NULL, output, y, kept + 2, 1);
}

static const iso_model model = {
    .name = "counter",
    .period_ns = PERIOD,
    .states = 2,
    .inputs = 1,
    .outputs = 1,
    .parameters = 1,
    .start = start,
    .defaults = defaults,
    .range = range,
    .output = output,
    .drive = drive,
    .prime = prime,
    .step = step,
    .finish = finish,
};

static const iso_plant plant = {.model = &model, .x = x, .u = u, .p = p, .y = y, .good = kept};

static iso_loop loop;

#endif
