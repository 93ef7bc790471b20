/* The account of the loop against one made by other code: a model of a loop on a port whose ticks come late, get lost,
 * wake up for nothing, whose steps stall for longer than a counter of 32 bits holds, and whose inputs, tunables and
 * outputs are no numbers, infinite or out of their limits.
 *
 *     PROGRAM TICKS SEED FIRST
 *
 * What happens in a tick is a function of its number and the seed. The port and the plant below do it; the model adds
 * up times by itself. FIRST is the tick before the first: beyond 2^32 nothing begins anew.
 */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/runtime/loop.h"
#include "core/runtime/tick.h"
#include "port/port.h"

enum { PERIOD = 268435459, READING = 3, LATE = PERIOD / 16 };

static uint64_t seed, first;

/* What a tick has of a kind, 64 random bits (Steele, Lea and Flood 2014: splitmix64). */
enum kind { DELAY, LOST, WAKE, COST, INPUT, TUNABLE, OUTPUT, KINDS };
static uint64_t chance(const uint64_t tick, const enum kind of)
{
    uint64_t z = seed + UINT64_C(0x9E3779B97F4A7C15) * (tick * KINDS + (uint64_t)of + 1);
    z = (z ^ z >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ z >> 27) * UINT64_C(0x94D049BB133111EB);
    return z ^ z >> 31;
}

/* Nothing most of the time; up to four periods once in `every`; of those one in 64 up to 2^36 counts. */
static uint64_t span(const uint64_t tick, const enum kind of, const uint64_t every)
{
    const uint64_t bits = chance(tick, of);
    if (bits % every != 0) {
        return 0;
    }
    return (bits >> 8 & 63) != 0 ? bits >> 34 : bits >> 28;
}

/* What comes from outside at a tick: mostly between -1 and 1, and once in 16 a number of these. */
static real given(const uint64_t tick, const enum kind of)
{
    static const real bad[] = {(real)NAN, (real)INFINITY, (real)-INFINITY, R(1e30), R(-1e30), R(1.5), R(-0.0), R(-1.0)};
    const uint64_t bits = chance(tick, of);
    return bits % 16 == 0 ? bad[bits >> 8 & 7] : (real)((double)(bits >> 12) / 2251799813685248.0 - 1.0);
}

/* --- The port ---------------------------------------------------------------------------------------------------- */

static uint64_t now, told, steps;
static uint64_t wrong_times; /* ticks that were driven with another number than theirs */

uint32_t iso_port_start(const uint32_t period_ns)
{
    now = 0;
    return period_ns;
}

uint64_t iso_port_wait(void)
{
    static uint64_t woken;
    if (woken != told && chance(told, WAKE) % 16 == 0) {
        woken = told;
        return told;
    }
    uint64_t next = told + 1;
    while (chance(next, LOST) % 32 == 0) {
        next++;
    }
    const uint64_t at = next * PERIOD + span(next, DELAY, 16);
    now = at > now ? at : now;
    told = now / PERIOD;
    return told;
}

uint64_t iso_port_clock(void)
{
    now += READING;
    return now;
}

void iso_port_read(real *const u, const size_t inputs)
{
    if (inputs == 2) {
        u[1] = given(first + steps, INPUT);
    }
}

static real seen[2];

void iso_port_publish(const real *const y, const size_t outputs)
{
    memcpy(seen, y, outputs * sizeof *y);
}

void iso_port_safe(void)
{
}

/* --- The plant --------------------------------------------------------------------------------------------------- */

static struct {
    real x[1], u[2], p[1], y[2], good[5];
} memory;

static const iso_limits limits[] = {{R(-1.0), R(1.0)}, {R(-0.5), R(0.75)}};

static void output(void *const of)
{
    (void)of;
    memory.y[0] = memory.u[1];
    memory.y[1] = given(first + steps, OUTPUT);
}

static void drive(void *const of, const uint64_t tick)
{
    (void)of;
    wrong_times += tick != first + steps;
    memory.u[0] = R(0.25);
}

static iso_refused admit(void *const of)
{
    (void)of;
    return iso_admit(memory.u, memory.good, limits, 2, NULL) |
           (iso_refused)iso_admit(memory.p, memory.good + 2, NULL, 1, NULL) << 32;
}

static uint32_t finish(void *const of)
{
    return iso_finish(of, memory.x, NULL, 1, NULL, output, memory.y, memory.good + 3, 2);
}

static void step(void *const of)
{
    (void)of;
    steps++;
    now += span(first + steps, COST, 8);
}

static const real start[1];
static const iso_model model = {
    .period_ns = PERIOD,
    .states = 1,
    .inputs = 2,
    .outputs = 2,
    .parameters = 1,
    .defaults = start,
    .start = start,
    .memory_bytes = sizeof memory,
    .output = output,
    .drive = drive,
    .admit = admit,
    .step = step,
    .finish = finish,
};
static const iso_plant plant = {.model = &model,
                                .memory = &memory,
                                .x = memory.x,
                                .u = memory.u,
                                .p = memory.p,
                                .y = memory.y,
                                .good = memory.good};

/* --- The model of the account, in seconds' worth of counts since tick FIRST --------------------------------------- */

typedef struct account {
    int64_t late, lost, overruns, margin, shortest, longest, sum;
    int64_t inputs_held, inputs_clamped, tunables_held, outputs_held;
} account;

/* What the plant has after a tick. */
typedef struct values {
    real input, tunable, outputs[2];
} values;

static void check_values(account *const a, values *const v, const uint64_t tick)
{
    const real input = given(tick - 1, INPUT), tunable = given(tick - 1, TUNABLE), output = given(tick, OUTPUT);
    a->inputs_held += !isfinite(input);
    a->inputs_clamped += isfinite(input) && (input < R(-0.5) || input > R(0.75));
    a->tunables_held += !isfinite(tunable);
    a->outputs_held += !isfinite(output);
    v->tunable = isfinite(tunable) ? tunable : v->tunable;
    if (isfinite(input)) {
        v->input = input < R(-0.5) ? R(-0.5) : input > R(0.75) ? R(0.75) : input;
    }
    if (isfinite(output)) {
        v->outputs[0] = v->input;
        v->outputs[1] = output;
    }
}

static account expected(const int64_t ticks)
{
    account a = {.margin = INT64_MAX, .shortest = INT64_MAX};
    int64_t time = 0, reported = 0;
    for (int64_t k = 1; k <= ticks; k++) {
        if (reported < k) {
            int64_t awake = k;
            while (chance(first + (uint64_t)awake, LOST) % 32 == 0) {
                awake++;
            }
            const int64_t at = awake * PERIOD + (int64_t)span(first + (uint64_t)awake, DELAY, 16);
            time = at > time ? at : time;
            reported = time / PERIOD;
        }
        const int64_t cost = (int64_t)span(first + (uint64_t)k, COST, 8);
        const int64_t behind = time + READING - k * PERIOD;
        time += 3 * READING + cost;
        const int64_t left = (k + 1) * PERIOD - time;
        a.late += behind > LATE;
        a.lost += k < reported;
        a.overruns += left < 0;
        a.margin = left < a.margin ? left : a.margin;
        a.shortest = cost < a.shortest ? cost : a.shortest;
        a.longest = cost > a.longest ? cost : a.longest;
        a.sum += cost;
    }
    return a;
}

static int failed;

static void same(const char *const what, const int64_t got, const int64_t want)
{
    printf("# %s %" PRId64 "\n", what, got);
    if (got != want) {
        printf("# expected %" PRId64 "\n", want);
        failed = 1;
    }
}

int main(const int argc, char **const argv)
{
    if (argc != 4) {
        return EXIT_FAILURE;
    }
    const uint64_t ticks = strtoull(argv[1], NULL, 10);
    seed = strtoull(argv[2], NULL, 10);
    first = strtoull(argv[3], NULL, 10);
    static iso_loop loop;
    drive(NULL, first);
    iso_loop_start(&loop, &plant);
    memset(memory.good, 0, sizeof memory.good);
    const uint64_t at_start = loop.statistics.outputs_held;
    wrong_times = 0;
    loop.tick = loop.reported = told = first;
    now = loop.due = first * PERIOD;
    account a = expected((int64_t)ticks);
    values v = {R(0.0), R(0.0), {R(0.0), R(0.0)}};
    uint64_t others = 0;
    for (uint64_t i = 0; i < ticks; i++) {
        memory.p[0] = given(first + i, TUNABLE);
        failed |= !iso_loop_tick(&loop);
        check_values(&a, &v, first + i + 1);
        others += memory.u[1] != v.input || memory.p[0] != v.tunable || memory.u[0] != R(0.25) ||
                  memcmp(memory.y, v.outputs, sizeof v.outputs) != 0 || memcmp(seen, v.outputs, sizeof seen) != 0;
    }
    const iso_statistics *const s = &loop.statistics;
    printf("# seed %" PRIu64 "\n", seed);
    same("ticks", (int64_t)s->ticks, (int64_t)ticks);
    same("late", (int64_t)s->late, a.late);
    same("lost", (int64_t)s->lost, a.lost);
    same("overruns", (int64_t)s->overruns, a.overruns);
    same("margin", s->margin, a.margin);
    same("execution_min", (int64_t)s->execution_min, a.shortest);
    same("execution_max", (int64_t)s->execution_max, a.longest);
    same("execution_sum", (int64_t)s->execution_sum, a.sum);
    same("inputs_held", (int64_t)s->inputs.held, a.inputs_held);
    same("inputs_clamped", (int64_t)s->inputs.clamped, a.inputs_clamped);
    same("tunables_held", (int64_t)s->parameters.held, a.tunables_held);
    same("tunables_clamped", (int64_t)s->parameters.clamped, 0);
    same("outputs_held", (int64_t)(s->outputs_held - at_start), a.outputs_held);
    same("ticks with other values", (int64_t)others, 0);
    same("ticks driven with another number", (int64_t)wrong_times, 0);
    return failed;
}
