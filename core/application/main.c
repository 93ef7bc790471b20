/* The program of every target: runs the plant for as long as the port says, and writes the run to the console. */
#include "core/application/hash.h"
#include "core/application/stream.h"
#include "core/application/times.h"
#include "core/numbers/self_check.h"
#include "core/runtime/loop.h"
#include "port/port.h"

static iso_loop loop;

int main(int argc, char **argv)
{
    const iso_plant *const plant = &iso_the_plant;
    const uint64_t duration = iso_port_duration(argc, argv);
    uint64_t hash = ISO_HASH_START;
    uint64_t time = 0;
    iso_times times = {0};
    bool good = true;

    if (!iso_self_check()) {
        iso_stream_bail_out("the processor or a flag of the compiler changes the bits of results; compile with "
                            "-std=c11 -ffp-contract=off, round to nearest, and do not flush denormals to zero");
        iso_port_exit(1);
    }
    iso_stream_header(plant, duration);
    iso_loop_start(&loop, plant);
    iso_stream_row(plant->y, plant->model->outputs);
    while (good && (time < duration || duration == 0)) {
        good = iso_loop_tick(&loop);
        if (loop.guard == plant->model->states) { /* a run that a policy stops ends with a good tick */
            iso_times_done(&times, &loop);
            time += plant->model->period_ns;
            hash = iso_hash_reals(hash, plant->x, plant->model->states);
            iso_stream_row(plant->y, plant->model->outputs);
            iso_times_go_on(&times, &loop);
        }
    }
    iso_stream_times(&times);
    iso_stream_end(&loop, hash);
    iso_port_exit(good ? 0 : 1);
}
