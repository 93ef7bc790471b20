/* Commands over a link: a controller that pauses its plant, runs it tick by tick, takes snapshots and puts it to them.
 *
 *     commands tick RECORD TICKS    balances the pole; at TICKS it writes a snapshot; prints the hash 1000 ticks later
 *     commands from RECORD TICKS    puts the plant to that snapshot, and prints the hash 1000 ticks later
 *     commands all RECORD           tries all commands, and what is refused; RECORD is a snapshot of this plant
 */
#include "cart_pole_link.h"

#include "tests/core/link/controllers/law.h"
#include "tests/core/link/controllers/record.h"
#include "tests/host/report.h"

static cart_pole_link plant;
static uint8_t changed[ROOM];

/* Exchanges until that tick. */
static bool balance(const uint64_t tick)
{
    bool good = true;
    while (good && plant.client.tick < tick) {
        plant.u[CART_POLE_U_FORCE] = LAW(plant.y);
        good = cart_pole_exchange(&plant);
    }
    return good;
}

static int finish(const bool good)
{
    if (good && cart_pole_state(&plant)) {
        printf("tick %llu hash %016llx\n", (unsigned long long)plant.client.state.tick,
               (unsigned long long)plant.client.state.hash);
        return EXIT_SUCCESS;
    }
    fprintf(stderr, "%s\n", plant.client.problem);
    return EXIT_FAILURE;
}

static bool is_at(const int state, const uint64_t tick, const uint64_t left)
{
    const iso_client_state *const s = &plant.client.state;
    return cart_pole_state(&plant) && s->state == state && s->tick == tick && s->left == left;
}

static bool refused(const bool done, const char *const why)
{
    return !done && strstr(plant.client.problem, why) != NULL;
}

static void try_running(void)
{
    report_ok(cart_pole_state(&plant) && plant.client.state.state == ISO_CLIENT_NO_RUN, "no run at first");
    report_ok(refused(cart_pole_run(&plant, 1), "no run") && refused(cart_pole_pause(&plant), "no run"),
              "nothing runs or rests then");
    report_ok(cart_pole_start(&plant, ISO_CLIENT_LOCKSTEP, 0) && is_at(ISO_CLIENT_RUNS, 0, UINT64_MAX),
              "a start runs without an end");
    report_ok(balance(10) && cart_pole_run(&plant, 3) && balance(13) && is_at(ISO_CLIENT_RESTS, 13, 0),
              "three ticks, then it rests");
    report_ok(cart_pole_pause(&plant) && is_at(ISO_CLIENT_RESTS, 13, 0), "it may be told to");
    report_ok(cart_pole_run(&plant, 1) && balance(14) && is_at(ISO_CLIENT_RESTS, 14, 0), "one tick");
    report_ok(cart_pole_run(&plant, 2) && iso_client_write(&plant.client) && balance(16) &&
                  is_at(ISO_CLIENT_RESTS, 16, 0),
              "two ticks, asked for twice with the same number, are two");
    report_ok(cart_pole_run(&plant, 0) && balance(20) && is_at(ISO_CLIENT_RUNS, 20, UINT64_MAX), "on without an end");
}

static void try_snapshots(const size_t bytes)
{
    const size_t taken = cart_pole_snapshot(&plant, changed, sizeof changed);
    const uint64_t hash = plant.client.state.hash;
    report_ok(taken == bytes && taken == plant.client.state.snapshot_bytes, "a snapshot at tick 20, %zu bytes", taken);
    report_ok(balance(40) && cart_pole_state(&plant), "on to tick 40");
    const uint64_t end = plant.client.state.hash;
    report_ok(cart_pole_restore(&plant, changed, taken) && is_at(ISO_CLIENT_RESTS, 20, 0) &&
                  plant.client.state.hash == hash && plant.client.tick == 20,
              "back to tick 20, where it rests");
    report_ok(cart_pole_run(&plant, 20) && balance(40) && is_at(ISO_CLIENT_RESTS, 40, 0) &&
                  plant.client.state.hash == end,
              "and to tick 40 with the same hash");
    uint8_t other[ROOM];
    memcpy(other, changed, taken);
    other[taken / 2] ^= 1;
    report_ok(refused(cart_pole_restore(&plant, other, taken), "damaged"), "a damaged one is refused");
    report_ok(refused(cart_pole_restore(&plant, changed, taken - 1), "not whole"), "one that is cut off");
    report_ok(refused(cart_pole_restore(&plant,
                                        (const uint8_t *)"no snapshot, but a text that is longer than its head, by "
                                                         "far",
                                        60),
                      "no snapshot"),
              "one that is none");
    memset(other, 0, sizeof other);
    report_ok(refused(cart_pole_restore(&plant, other, taken + 1), "beyond"), "one that is too long");
    report_ok(is_at(ISO_CLIENT_RESTS, 40, 0) && plant.client.state.hash == end, "and nothing has changed");
    report_ok(cart_pole_restore(&plant, record, bytes) && is_at(ISO_CLIENT_RESTS, plant.client.tick, 0) &&
                  plant.client.tick > 40,
              "one of another program is taken");
}

static void try_reset(void)
{
    report_ok(cart_pole_reset(&plant) && is_at(ISO_CLIENT_RESTS, 0, 0) && plant.client.tick == 0,
              "a reset: it rests at tick 0");
    report_ok(cart_pole_run(&plant, 0) && balance(10) && cart_pole_stop(&plant) && plant.client.end.ticks == 10,
              "a run from there");
    report_ok(is_at(ISO_CLIENT_NO_RUN, 10, UINT64_MAX), "which is over when it is ended");
    report_ok(cart_pole_snapshot(&plant, changed, sizeof changed) > 0, "a snapshot of its end");
    report_ok(refused(cart_pole_restore(&plant, changed, plant.client.state.snapshot_bytes), "no run"),
              "to which nothing is put where there is no run");
    report_ok(cart_pole_reset(&plant) && cart_pole_run(&plant, 5) && balance(5) && is_at(ISO_CLIENT_RESTS, 5, 0),
              "a reset begins the next");
}

int main(const int count, char **const arguments)
{
    const size_t bytes = count > 2 ? read_record(arguments[2]) : 0;
    const uint64_t tick = count > 3 ? strtoull(arguments[3], NULL, 10) : 0;
    if (count < 3 || !cart_pole_open(&plant, NULL)) {
        return finish(false);
    }
    if (strcmp(arguments[1], "all") == 0) {
        try_running();
        try_snapshots(bytes);
        try_reset();
        return report_done();
    }
    bool good = cart_pole_start(&plant, ISO_CLIENT_LOCKSTEP, 0);
    if (strcmp(arguments[1], "tick") == 0) {
        good = good && balance(tick) && write_record(arguments[2], cart_pole_snapshot(&plant, record, sizeof record));
    } else {
        good =
            good && cart_pole_restore(&plant, record, bytes) && plant.client.tick == tick && cart_pole_run(&plant, 0);
    }
    return finish(good && balance(tick + 1000));
}
