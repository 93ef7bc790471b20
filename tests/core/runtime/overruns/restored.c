/* A plant with a ladder, put to its start and to a snapshot: on the simulated port, whose script has the overruns.
 *
 *     PROGRAM NANOSECONDS SCRIPT
 *
 * At tick 60 it stands on a lower rung; what was taken there goes on with the rung and its good ticks, to the same
 * hash. */
#include "core/runtime/control.h"
#include "core/runtime/hash.h"
#include "core/runtime/policy.h"
#include "port/port.h"
#include "tests/host/report.h"

enum { ROOM = 1024, TAKEN_AT = 60, TICKS = 200 };

static iso_loop loop;
static unsigned char record[ROOM], again[ROOM];
static iso_control control = {.loop = &loop, .snapshot = record, .identity = 1, .hash = ISO_HASH_START};
static uint64_t rungs_of[TICKS];

/* To that tick. Whether each step is on the rung that it was on before, if it is to be. */
static bool go(const uint64_t to, const bool again_the_same)
{
    const iso_policy_counts *const counts = iso_the_plant.model->policy->counts;
    bool same = true;
    while (loop.tick < to) {
        same = same && (!again_the_same || rungs_of[loop.tick] == counts->rung);
        rungs_of[loop.tick] = counts->rung;
        if (!iso_loop_tick(&loop)) {
            return false;
        }
        iso_control_done(&control, iso_hash_reals(control.hash, iso_the_plant.x, iso_the_plant.model->states));
    }
    return same;
}

static bool is_clear(const iso_policy *const policy)
{
    const iso_policy_histogram *const histogram = (const iso_policy_histogram *)(const void *)policy->counts;
    iso_policy_counts none = {.latency = 1};
    uint64_t ticks = 0;
    for (int i = 0; i < ISO_HISTOGRAM_BINS; i++) {
        ticks += histogram->bins[i];
    }
    return memcmp(&none, policy->counts, sizeof none) == 0 && ticks == 0;
}

int main(int argc, char **argv)
{
    const iso_policy *const policy = iso_the_plant.model->policy;
    (void)iso_port_duration(argc, argv);
    control.snapshot_bytes = ISO_SNAPSHOT_BYTES(iso_the_plant.model->memory_bytes);
    iso_loop_start(&loop, &iso_the_plant);
    report_ok(go(TAKEN_AT, false) && policy->counts->rung == 2 && policy->counts->good > 0,
              "at tick %d it is on rung 2", TAKEN_AT);
    report_ok(iso_control_take(&control) == ISO_CONTROL_DONE, "a snapshot");
    memcpy(again, record, sizeof record);
    report_ok(go(TICKS, false) && policy->counts->rung == 0 && rungs_of[TAKEN_AT + 40] == 1, "it climbs up again");
    const uint64_t end = control.hash;

    report_ok(!is_clear(policy), "it has counts");
    control.hash = ISO_HASH_START;
    iso_control_reset(&control);
    report_ok(is_clear(policy), "a reset clears all but the latency");
    report_ok(iso_control_restore(&control, control.snapshot_bytes) == ISO_CONTROL_DONE && policy->counts->rung == 2,
              "restored at its start, it is on rung 2");
    report_ok(iso_control_take(&control) == ISO_CONTROL_DONE && memcmp(record, again, sizeof record) == 0,
              "with the same record");
    report_ok(go(TICKS, true) && control.hash == end, "it climbs at the same ticks, to the same hash");

    /* Rungs that it has not. */
    policy->counts->rung = 9;
    (void)iso_control_take(&control);
    policy->counts->rung = 1;
    report_ok(iso_control_restore(&control, control.snapshot_bytes) == (iso_control_answer)ISO_SNAPSHOT_NOT_A_STATE &&
                  policy->counts->rung == 1 && loop.tick == TICKS,
              "a record with a rung that it has not is refused, and changes nothing");
    return report_done();
}
