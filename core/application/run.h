/* A run of the plant, as long as the port demands, written to the console. Two programs make it: that of every run
 * (core/application/main.c), and that of a run with snapshots (core/snapshots/main.c). That of a plant with a link
 * (core/link/main.c) makes its check only. */
#ifndef ISO_CORE_APPLICATION_RUN_H
#define ISO_CORE_APPLICATION_RUN_H

#include "core/application/stream.h"
#include "core/application/times.h"
#include "core/numbers/self_check.h"
#include "core/runtime/hash.h"
#include "core/runtime/loop.h"
#include "port/port.h"

/* The additions of a run with snapshots. */
typedef struct iso_run_snapshots {
    uint64_t (*begin)(iso_loop *loop,
                      uint64_t duration); /* puts the loop to the first tick; returns the hash until there */
    void (*row)(const iso_loop *loop, uint64_t hash); /* after the row of each tick that is done, and of the first */
} iso_run_snapshots;

/* Gives up where this program computes with other bits. */
static inline void iso_run_check(void)
{
    if (!iso_self_check()) {
        iso_stream_give_up("the processor or a flag of the compiler changes the bits of results; compile with "
                           "-std=c11 -ffp-contract=off, round to nearest, and do not flush denormals to zero");
    }
}

static inline void iso_run_row(const iso_loop *const loop, const uint64_t hash,
                               const iso_run_snapshots *const snapshots)
{
    iso_stream_row(loop->plant->y, loop->plant->model->outputs);
    if (snapshots != NULL) {
        snapshots->row(loop, hash);
    }
}

/* Ends the program, with status 1 where the guard stopped the run. A duration of zero has no end. */
static _Noreturn inline void iso_run(iso_loop *const loop, const uint64_t duration,
                                     const iso_run_snapshots *const snapshots)
{
    const iso_plant *const plant = &iso_the_plant;
    iso_times times = {0};
    bool good = true;

    iso_run_check();
    iso_stream_header(plant, duration);
    iso_loop_start(loop, plant);
    uint64_t hash = ISO_HASH_START;
    if (snapshots != NULL) {
        hash = snapshots->begin(loop, duration);
        iso_stream_from(loop->tick);
    }
    uint64_t time = loop->tick * plant->model->period_ns;
    iso_run_row(loop, hash, snapshots);
    while (good && (time < duration || duration == 0)) {
        good = iso_loop_tick(loop);
        if (loop->guard == plant->model->states) { /* a run that a policy stops ends with a good tick */
            iso_times_done(&times, loop);
            time += plant->model->period_ns;
            hash = iso_hash_reals(hash, plant->x, plant->model->states);
            iso_run_row(loop, hash, snapshots);
            iso_times_go_on(&times, loop);
        }
    }
    iso_stream_times(&times);
    iso_stream_end(loop, hash);
    iso_port_exit(good ? 0 : 1);
}

#endif
