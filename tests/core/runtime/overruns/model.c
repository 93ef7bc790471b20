/* What the loop counts under a policy on the simulated port, by other code: a list of times and a few rules. For
 * each seed from 1 on it writes a script of the port's ticks, FOLDER/SEED.script, and what the summary of the run must
 * have, FOLDER/SEED.expected.
 *
 *     PROGRAM SEEDS FOLDER count|catch_up|stop|degrade NUMBER GRACE
 *
 * A ladder has three rungs, and NUMBER good ticks lead up; the rung of each tick goes to FOLDER/SEED.rungs.
 */
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TICKS = 1000, ROOM = 4 * TICKS, PERIOD = 1000000, BINS = 32, EVENTS = 60 };

static int64_t late_by[ROOM], slow_by[ROOM];
static bool is_lost[ROOM];
static uint64_t state;

/* Marsaglia (2003), Xorshift RNGs. */
static uint32_t random_below(const uint32_t most)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (uint32_t)(state >> 32) % most;
}

static FILE *file_of(const char *const folder, const int seed, const char *const kind)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%d.%s", folder, seed, kind);
    FILE *const file = fopen(path, "w");
    if (file == NULL) {
        exit(EXIT_FAILURE);
    }
    return file;
}

static void write_script(FILE *const file)
{
    memset(late_by, 0, sizeof late_by);
    memset(slow_by, 0, sizeof slow_by);
    memset(is_lost, 0, sizeof is_lost);
    for (int i = 0; i < EVENTS; i++) {
        const uint32_t tick = 1 + random_below(TICKS), kind = random_below(3);
        const uint32_t us = random_below(4) == 0 ? 1 + random_below(9000) : 1 + random_below(1200);
        if (kind == 0 && late_by[tick] == 0) {
            late_by[tick] = (int64_t)us * 1000;
            fprintf(file, "late %" PRIu32 " %" PRIu32 "us\n", tick, us);
        } else if (kind == 1 && slow_by[tick] == 0) {
            slow_by[tick] = (int64_t)us * 1000;
            fprintf(file, "slow %" PRIu32 " %" PRIu32 "us\n", tick, us);
        } else if (kind == 2 && !is_lost[tick]) {
            is_lost[tick] = true;
            fprintf(file, "lose %" PRIu32 "\n", tick);
        }
    }
}

static void account(const char *const policy, const int64_t most, const int64_t grace, FILE *const expected,
                    FILE *const ladder)
{
    const bool skips = strcmp(policy, "catch_up") == 0, stops = strcmp(policy, "stop") == 0;
    int64_t now = 0, told = 0, absent = 0, first = 0, last = 0, stopped = 0, ticks = 0;
    int64_t rung = 0, good = 0, degraded = 0, lowest = 0;
    int64_t counted[2][2] = {{0, 0}, {0, 0}}, lost = 0, least = INT64_MAX, bins[BINS] = {0};
    while (ticks < TICKS && stopped == 0) {
        const int64_t k = ticks + 1, due = (k + absent) * PERIOD;
        if (told < k + absent) {
            int64_t next = told + 1;
            while (is_lost[next]) {
                next++;
            }
            const int64_t awake = next * PERIOD + late_by[next];
            now = awake > now ? awake : now;
            told = now / PERIOD;
        }
        const bool is_late = now > due + PERIOD / 16;
        now += slow_by[k];
        const int64_t left = due + PERIOD - now, bin = slow_by[k] / (PERIOD / BINS);
        ticks = k;
        counted[k <= grace][0] += is_late;
        counted[k <= grace][1] += left < 0;
        lost += told > k + absent;
        least = left < least ? left : least;
        bins[bin < BINS ? bin : BINS - 1]++;
        if (skips && told - k - absent > most) {
            first = first == 0 ? k + absent + 1 : first;
            absent = told - k - most;
            last = k + absent;
        }
        if (ladder != NULL) {
            fprintf(ladder, "%" PRId64 "\n", rung);
            degraded += rung != 0;
            good = left < 0 && k > grace ? 0 : good + 1;
            if (good == 0 && rung < 3) {
                rung++;
            } else if (rung > 0 && good == most) {
                rung--;
                good = 0;
            }
            lowest = rung > lowest ? rung : lowest;
        }
        stopped = stops && left < 0 && k > grace ? k : 0;
    }
    fprintf(expected,
            "ticks %" PRId64 "\nlate %" PRId64 "\nlost %" PRId64 "\noverruns %" PRId64 "\nmargin %" PRId64 " ns\n",
            ticks, counted[0][0], lost, counted[0][1], least);
    fprintf(expected, "grace_late %" PRId64 "\ngrace_overruns %" PRId64 "\n", counted[1][0], counted[1][1]);
    if (absent > 0) {
        fprintf(expected, "skipped %" PRId64 " from %" PRId64 " to %" PRId64 "\n", absent, first, last);
    }
    if (degraded > 0) {
        fprintf(expected, "degraded %" PRId64 " to rung %" PRId64 "\n", degraded, lowest);
    }
    for (int64_t i = 0; i < BINS; i++) {
        if (bins[i] > 0 && i + 1 < BINS) {
            fprintf(expected, "histogram %" PRId64 " to %" PRId64 " ns: %" PRId64 "\n", i * (PERIOD / BINS),
                    (i + 1) * (PERIOD / BINS), bins[i]);
        } else if (bins[i] > 0) {
            fprintf(expected, "histogram from %" PRId64 " ns: %" PRId64 "\n", i * (PERIOD / BINS), bins[i]);
        }
    }
}

int main(const int argc, char **const argv)
{
    if (argc < 6) {
        return EXIT_FAILURE;
    }
    for (int seed = 1; seed <= atoi(argv[1]); seed++) {
        state = (uint64_t)seed * UINT64_C(0x9E3779B97F4A7C15) + 1;
        FILE *const script = file_of(argv[2], seed, "script"), *const expected = file_of(argv[2], seed, "expected");
        FILE *const ladder = strcmp(argv[3], "degrade") == 0 ? file_of(argv[2], seed, "rungs") : NULL;
        write_script(script);
        account(argv[3], atoi(argv[4]), atoi(argv[5]), expected, ladder);
        fclose(script);
        fclose(expected);
        if (ladder != NULL) {
            fclose(ladder);
        }
    }
    return EXIT_SUCCESS;
}
