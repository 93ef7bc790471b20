/* core/runtime/policy.h: the edges of what is counted and decided: bins, the grace, what is made good, the ladder. */
#include "core/runtime/policy.h"
#include "tests/tap.h"

/* A period of 3217 counts has bins of 100. */
enum { PERIOD = 3217, WIDTH = PERIOD / ISO_HISTOGRAM_BINS, LAST = ISO_HISTOGRAM_BINS - 1 };

/* The bin that a tick of so many counts is in; ISO_HISTOGRAM_BINS if it is not in one. */
static uint32_t bin_of(const uint64_t counts)
{
    iso_loop loop = {.period = PERIOD};
    iso_policy_histogram histogram = {.width = 0};
    const iso_news news = {.counts = counts};
    iso_policy_bin(&loop, &histogram, &news);
    uint32_t found = ISO_HISTOGRAM_BINS, sum = 0;
    for (uint32_t i = 0; i < ISO_HISTOGRAM_BINS; i++) {
        sum += (uint32_t)histogram.bins[i];
        found = histogram.bins[i] == 1 ? i : found;
    }
    return sum == 1 && histogram.width == WIDTH && loop.execution_min == UINT32_MAX ? found : ISO_HISTOGRAM_BINS;
}

static void test_histogram(void)
{
    uint32_t below = 0, at = 0;
    for (uint32_t i = 1; i < ISO_HISTOGRAM_BINS; i++) {
        below += bin_of((uint64_t)i * WIDTH - 1) == i - 1;
        at += bin_of((uint64_t)i * WIDTH) == i;
    }
    tap_ok(bin_of(0) == 0, "histogram: nothing is in the first bin");
    tap_count(below, LAST, "histogram: a count below an edge is in the bin before");
    tap_count(at, LAST, "histogram: a count at an edge is in the bin behind");
    tap_ok(bin_of((uint64_t)ISO_HISTOGRAM_BINS * WIDTH) == LAST && bin_of(PERIOD) == LAST &&
               bin_of(UINT64_C(1) << 32) == LAST && bin_of(UINT64_MAX) == LAST,
           "histogram: the last bin is open");
}

static void test_grace(void)
{
    const iso_news news = {.late = true, .overran = true};
    for (uint32_t tick = 9; tick <= 11; tick++) {
        iso_loop loop = {.tick = tick, .statistics = {.late = 5, .overruns = 7}};
        iso_policy_counts counts = {.grace_late = 1, .grace_overruns = 2};
        const uint32_t apart = tick <= 10;
        iso_policy_grace(&loop, &counts, &news, 10);
        tap_ok(counts.grace_late == 1 + apart && counts.grace_overruns == 2 + apart &&
                   loop.statistics.late == 5 - apart && loop.statistics.overruns == 7 - apart,
               "grace: of 10 ticks, the 9th and the 10th are counted apart, the 11th is not");
    }
}

static void test_catch_up(void)
{
    iso_loop loop = {.tick = 100, .reported = 103, .rested = 50, .due = 7000, .period = 10};
    iso_policy_counts counts = {.skipped = 0};
    iso_policy_catch_up(&loop, &counts, 3);
    tap_ok(counts.skipped == 0 && loop.reported == 103 && loop.rested == 50 && loop.due == 7000,
           "catch_up: as many as are made good, are");
    loop.reported = 105;
    iso_policy_catch_up(&loop, &counts, 3);
    tap_ok(counts.skipped == 2 && loop.reported == 103 && loop.rested == 52 && loop.due == 7020,
           "catch_up: two more pass");
    tap_ok(counts.skipped_first == 151 && counts.skipped_last == 152, "catch_up: by the numbers of the port");
    loop.reported = 104;
    iso_policy_catch_up(&loop, &counts, 3);
    tap_ok(counts.skipped == 3 && counts.skipped_first == 151 && counts.skipped_last == 153,
           "catch_up: the first stays, the last moves");
}

static void test_stop(void)
{
    const iso_news good = {.late = true}, bad = {.overran = true};
    iso_loop loop = {.tick = 20};
    iso_policy_counts counts = {.stopped = 0};
    tap_ok(iso_policy_stop(&loop, &counts, &bad, 20) && counts.stopped == 0, "stop: not within the grace");
    loop.tick = 21;
    tap_ok(iso_policy_stop(&loop, &counts, &good, 20) && counts.stopped == 0, "stop: not by a late tick");
    tap_ok(!iso_policy_stop(&loop, &counts, &bad, 20) && counts.stopped == 21, "stop: by an overrun behind the grace");
}

/* A ladder of two rungs, three good ticks up. */
static uint64_t rung_after(iso_loop *const loop, iso_policy_counts *const counts, const bool overran)
{
    const iso_news news = {.overran = overran};
    loop->tick++;
    iso_policy_degrade(loop, counts, &news, 1, 2, 3);
    return counts->rung;
}

static void test_degrade(void)
{
    static const struct {
        bool overran;
        uint8_t rung;
    } ticks[] = {
        {true, 0},  {false, 0}, {true, 1},  {false, 1}, {false, 1}, {true, 2},  {true, 2},  {false, 2}, {false, 2},
        {false, 1}, {false, 1}, {false, 1}, {false, 0}, {false, 0}, {false, 0}, {false, 0}, {true, 1},
    };
    iso_loop loop = {.tick = 0};
    iso_policy_counts counts = {.rung = 0};
    uint32_t right = 0, marked = 0;
    for (size_t i = 0; i < sizeof ticks / sizeof ticks[0]; i++) {
        loop.execution_min = 0;
        right += rung_after(&loop, &counts, ticks[i].overran) == ticks[i].rung;
        marked += (loop.execution_min == UINT32_MAX) == (ticks[i].rung > 0);
    }
    tap_count(right, sizeof ticks / sizeof ticks[0], "degrade: the rung after each tick");
    tap_count(marked, sizeof ticks / sizeof ticks[0], "degrade: the tick behind one on a rung is one with news");
    tap_ok(counts.lowest == 2 && counts.degraded == 10, "degrade: the lowest rung, and the ticks below the top");
}

/* A run that begins has no counts of the one before, nor bins. */
static void test_reset(void)
{
    iso_policy_histogram histogram = {.counts = {.skipped = 3, .latency = 9, .rung = 2, .lowest = 2}, .width = 7};
    histogram.bins[LAST] = 5;
    const iso_policy policy = {
        .counts = &histogram.counts, .count = sizeof histogram / sizeof(uint64_t), .delays = true};
    iso_policy_reset(&policy);
    iso_policy_histogram begun = {.counts = {.latency = 1}};
    tap_ok(memcmp(&histogram, &begun, sizeof begun) == 0,
           "reset: nothing is counted, and the latency is that of the policy");
}

int main(void)
{
    test_reset();
    test_histogram();
    test_grace();
    test_catch_up();
    test_stop();
    test_degrade();
    tap_done();
}
