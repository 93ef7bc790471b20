/* Commands to a plant that runs freely, and that the guard stops: a rotor, and a torque without limits. */
#include "rotor_link.h"

#include "tests/host/report.h"

static rotor_link plant;
static uint8_t record[4096], other[4096];

static bool is(const int state)
{
    return rotor_state(&plant) && plant.client.state.state == state;
}

static bool refused(const bool done, const char *const why)
{
    return !done && strstr(plant.client.problem, why) != NULL;
}

/* Waits until so many ticks are done, and it rests. */
static bool comes_to(const uint64_t tick)
{
    for (int tries = 0; tries < 100000 && is(ISO_CLIENT_RUNS); tries++) {
    }
    return plant.client.state.state == ISO_CLIENT_RESTS && plant.client.state.tick == tick;
}

static bool stops(const rotor_real torque)
{
    plant.u[ROTOR_U_TORQUE] = torque;
    bool good = true;
    for (int i = 0; i < 10000 && good; i++) {
        good = rotor_exchange(&plant);
    }
    return !good && plant.client.over;
}

int main(void)
{
    if (!rotor_open(&plant, NULL)) {
        return EXIT_FAILURE;
    }
    report_ok(rotor_reset(&plant) && plant.client.tick == 0 && is(ISO_CLIENT_RESTS), "a reset before any start rests");
    report_ok(rotor_run(&plant, 500) && comes_to(500), "500 ticks by themselves");
    report_ok(is(ISO_CLIENT_RESTS) && is(ISO_CLIENT_RESTS) && plant.client.state.tick == 500, "no tick while it rests");
    const size_t bytes = rotor_snapshot(&plant, record, sizeof record);
    const uint64_t hash = plant.client.state.hash;
    report_ok(bytes > 0 && rotor_run(&plant, 300) && comes_to(800), "300 more");
    const uint64_t end = plant.client.state.hash;
    report_ok(rotor_restore(&plant, record, bytes) && plant.client.state.hash == hash && rotor_run(&plant, 300) &&
                  comes_to(800) && plant.client.state.hash == end,
              "and again from the snapshot");
    report_ok(rotor_run(&plant, 0) && is(ISO_CLIENT_RUNS) && rotor_pause(&plant) && is(ISO_CLIENT_RESTS) &&
                  plant.client.state.tick >= 800,
              "a pause");

    report_ok(rotor_start(&plant, ISO_CLIENT_FREE, 0) && stops(1e37F) && plant.client.end.guard < 2 &&
                  is(ISO_CLIENT_STOPPED),
              "the guard stops it");
    report_ok(refused(rotor_run(&plant, 1), "no run") && refused(rotor_pause(&plant), "no run") &&
                  refused(rotor_snapshot(&plant, other, sizeof other) > 0, "guard"),
              "then it neither runs nor rests, and has no snapshot");
    memcpy(other, record, bytes);
    other[bytes / 2] ^= 1;
    report_ok(refused(rotor_restore(&plant, other, bytes), "damaged") && is(ISO_CLIENT_STOPPED),
              "a damaged snapshot leaves it stopped");
    report_ok(rotor_restore(&plant, record, bytes) && plant.client.tick == 500 && is(ISO_CLIENT_RESTS) &&
                  plant.client.state.hash == hash && rotor_run(&plant, 300) && comes_to(800) &&
                  plant.client.state.hash == end,
              "a good one ends that without a reset: the run goes on from there, to the same hash");
    report_ok(rotor_run(&plant, 0) && stops(1e37F) && is(ISO_CLIENT_STOPPED), "until the guard stops it again");
    report_ok(rotor_reset(&plant) && is(ISO_CLIENT_RESTS) && plant.client.state.tick == 0, "it waits for a reset");
    report_ok(rotor_restore(&plant, record, bytes) && rotor_run(&plant, 300) && comes_to(800) &&
                  plant.client.state.hash == end,
              "and goes on from a snapshot");

    plant.u[ROTOR_U_TORQUE] = (rotor_real)NAN;
    report_ok(rotor_run(&plant, 0) && rotor_exchange(&plant) && plant.client.tick > 800, "an input that is no number");
    plant.u[ROTOR_U_TORQUE] = (rotor_real)INFINITY;
    bool good = true;
    for (int i = 0; i < 4; i++) { /* in a free run the ticks of the first outputs may be older than the inputs */
        good = good && rotor_exchange(&plant) && isfinite(plant.y[ROTOR_Y_SPEED]);
    }
    report_ok(good, "and one that is infinite");
    report_ok(rotor_stop(&plant) && plant.client.end.inputs_held >= 2 && plant.client.end.guard >= 2,
              "are held and counted");
    rotor_close(&plant);
    return report_done();
}
