/* The account of the loop against one made by other code: a model of a loop on a port whose ticks come late, get lost, wake
 * up for nothing, and whose steps stall for longer than a counter of 32 bits holds.
 *
 *     PROGRAM TICKS SEED FIRST
 *
 * What happens in a tick is a function of its number and the seed. The port and the plant below do it; the model adds up
 * times by itself. FIRST is the tick before the first: beyond 2^32 nothing begins anew.
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/runtime/loop.h"
#include "port/port.h"

enum { PERIOD = 268435459, READING = 3, LATE = PERIOD / 16 };

static uint64_t seed, first;

/* What a tick has of a kind, 64 random bits (Steele, Lea and Flood 2014: splitmix64). */
enum kind { DELAY, LOST, WAKE, COST, KINDS };
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
    (void)u;
    (void)inputs;
}

void iso_port_publish(const real *const y, const size_t outputs)
{
    (void)y;
    (void)outputs;
}

/* --- The plant --------------------------------------------------------------------------------------------------- */

static struct {
    real x[1], u[1], y[1];
} memory;

static void output(void *const of)
{
    (void)of;
    memory.y[0] = memory.x[0];
}

static void drive(void *const of, const uint64_t tick)
{
    (void)of;
    wrong_times += tick != first + steps;
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
    .inputs = 1,
    .outputs = 1,
    .start = start,
    .memory_bytes = sizeof memory,
    .output = output,
    .drive = drive,
    .step = step,
};
static const iso_plant plant = {.model = &model, .memory = &memory, .x = memory.x, .u = memory.u, .y = memory.y};

/* --- The model of the account, in seconds' worth of counts since tick FIRST --------------------------------------- */

typedef struct account {
    int64_t late, lost, overruns, margin, shortest, longest, sum;
} account;

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
        time += 4 * READING + cost;
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
    wrong_times = 0;
    loop.tick = loop.reported = told = first;
    now = loop.due = first * PERIOD;
    for (uint64_t i = 0; i < ticks; i++) {
        failed |= !iso_loop_tick(&loop);
    }
    const account a = expected((int64_t)ticks);
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
    same("ticks driven with another number", (int64_t)wrong_times, 0);
    return failed;
}
