/* The program of a run that begins at a snapshot, takes one, or both; else as that of every run (core/application/main.c). The
 * identity of the plant, and the room for a record, are those that it has with a link. */
#include "core/application/hash.h"
#include "core/application/stream.h"
#include "core/application/times.h"
#include "core/link/interface.h"
#include "core/numbers/self_check.h"
#include "core/record/request.h"
#include "core/runtime/snapshot.h"
#include "port/port.h"

static iso_loop loop;

_Noreturn static void give_up(const char *const why)
{
    iso_stream_bail_out(why);
    iso_port_exit(1);
}

/* Puts the plant to the snapshot of the request, if there is one. Returns the hash of the trajectory so far. */
static uint64_t restore(void)
{
    static const char *const refusals[] = {
        [ISO_SNAPSHOT_NO_SNAPSHOT] = "the file is no snapshot",
        [ISO_SNAPSHOT_OTHER_VERSION] = "the snapshot is of another version of the record",
        [ISO_SNAPSHOT_WRONG_SIZE] = "the snapshot is not whole, or something follows it",
        [ISO_SNAPSHOT_DAMAGED] = "the snapshot is damaged: its check is another",
        [ISO_SNAPSHOT_OTHER_NUMBERS] =
            "the snapshot has the other type of numbers, float for double or double for float",
        [ISO_SNAPSHOT_OTHER_PLANT] = "the snapshot is of another plant, method or step",
        [ISO_SNAPSHOT_NOT_A_STATE] = "the snapshot has a number that is not finite or out of range",
    };
    const iso_request *const request = &iso_the_request;
    uint64_t hash = ISO_HASH_START;
    if (request->from != NULL) {
        uint64_t tick = 0;
        const iso_snapshot_answer answer = iso_snapshot_restore(loop.plant, iso_the_interface.identity, request->from,
                                                                request->from_bytes, &tick, &hash);
        if (answer != ISO_SNAPSHOT_GOOD) {
            give_up(refusals[answer]);
        }
        iso_loop_jump(&loop, tick);
    }
    return hash;
}

/* Where the plant is after `end` ticks of all: those that are asked for must be within. */
static void check_request(const uint64_t end)
{
    if (loop.tick > end) {
        give_up("the run ends before the tick of the snapshot that it begins at: SECONDS is of the whole run");
    }
    if (iso_the_request.at != ISO_REQUEST_NONE && (iso_the_request.at < loop.tick || iso_the_request.at > end)) {
        give_up("the run does not come by the tick of the snapshot that is asked for");
    }
}

/* The outputs of the tick that is done; and if it is the one, the snapshot. */
static void write_tick(const uint64_t hash)
{
    const iso_interface *const interface = &iso_the_interface;
    iso_stream_row(loop.plant->y, loop.plant->model->outputs);
    if (loop.tick == iso_the_request.at) {
        iso_snapshot_take(interface->record, loop.plant, interface->identity, loop.tick, hash);
        iso_stream_snapshot(interface->record, interface->record_bytes);
    }
}

int main(int argc, char **argv)
{
    const iso_plant *const plant = &iso_the_plant;
    const uint64_t duration = iso_port_duration(argc, argv), period = plant->model->period_ns;
    const uint64_t end = duration == 0 ? UINT64_MAX : duration / period + (duration % period > 0);
    bool good = true;
    iso_times times = {0};

    if (!iso_self_check()) {
        give_up("the processor or a flag of the compiler changes the bits of results; compile with "
                "-std=c11 -ffp-contract=off, round to nearest, and do not flush denormals to zero");
    }
    iso_loop_start(&loop, plant);
    uint64_t hash = restore();
    check_request(end);
    iso_stream_header(plant, duration);
    iso_stream_from(loop.tick);
    write_tick(hash);
    while (good && loop.tick < end) {
        good = iso_loop_tick(&loop);
        if (loop.guard == plant->model->states) { /* a run that a policy stops ends with a good tick */
            iso_times_done(&times, &loop);
            hash = iso_hash_reals(hash, plant->x, plant->model->states);
            write_tick(hash);
            iso_times_go_on(&times, &loop);
        }
    }
    iso_stream_times(&times);
    iso_stream_end(&loop, hash);
    iso_port_exit(good ? 0 : 1);
}
