/* The program of a run that begins at a snapshot, takes one, or both; else as that of every run
 * (core/application/main.c). The identity of the plant, and the room for a snapshot, are those that it has with a link.
 */
#include "core/application/run.h"
#include "core/link/interface.h"
#include "core/runtime/snapshot.h"
#include "core/snapshots/request.h"
#include "core/wire/protocol.h"

/* Puts the plant to the snapshot of the request, if there is one. Returns the hash of the trajectory so far. */
static uint64_t restore(iso_loop *const loop)
{
#define REFUSAL(constant, number, words) [constant] = (words),
    static const char *const refusals[] = {ISO_SNAPSHOT_REFUSALS(REFUSAL)};
    const iso_request *const request = &iso_the_request;
    uint64_t hash = ISO_HASH_START;
    if (request->from != NULL) {
        uint64_t tick = 0;
        const iso_snapshot_answer answer = iso_snapshot_restore(loop->plant, iso_the_interface.identity, request->from,
                                                                request->from_bytes, &tick, &hash);
        if (answer != ISO_SNAPSHOT_GOOD) {
            iso_stream_give_up(refusals[answer]);
        }
        iso_loop_jump(loop, tick);
    }
    return hash;
}

/* The request must be within the run, which ends after the tick `end`. */
static uint64_t begin(iso_loop *const loop, const uint64_t duration)
{
    const uint64_t period = loop->plant->model->period_ns, hash = restore(loop);
    const uint64_t end = duration == 0 ? UINT64_MAX : duration / period + (duration % period > 0);
    if (loop->tick > end) {
        iso_stream_give_up(
            "the run ends before the tick of the snapshot that it begins at: --seconds is of the whole run");
    }
    if (iso_the_request.at != ISO_REQUEST_NONE && (iso_the_request.at < loop->tick || iso_the_request.at > end)) {
        iso_stream_give_up("the run does not come by the tick of the snapshot that is asked for");
    }
    return hash;
}

/* Takes the snapshot at the requested tick. */
static void take(const iso_loop *const loop, const uint64_t hash)
{
    const iso_interface *const interface = &iso_the_interface;
    if (loop->tick == iso_the_request.at) {
        iso_snapshot_take(interface->snapshot, loop->plant, interface->identity, loop->tick, hash);
        iso_stream_snapshot(interface->snapshot, interface->snapshot_bytes);
    }
}

int main(int argc, char **argv)
{
    static iso_loop loop;
    static const iso_run_snapshots snapshots = {.begin = begin, .row = take};
    iso_run(&loop, iso_port_duration(argc, argv), &snapshots);
}
