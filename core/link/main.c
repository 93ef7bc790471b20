/* The program of a plant with a link: rests until a controller starts a run, makes it, and rests again. Where the port
 * says how long to run, it makes one run, of at most that time, writes it to the console, and ends. From 2^63 - 1 ns on
 * that run has no end of its own. */
#include "core/application/run.h"
#include "core/link/link.h"

static iso_loop loop;
iso_link iso_the_link;

/* Makes a run of at most `most` nanoseconds of the plant's time, 0: without an end. */
static void run(const uint64_t most)
{
    const iso_model *const model = loop.plant->model;
    bool good = true;
    iso_link_begin(&iso_the_link);
    for (uint64_t time = 0; good; time += model->period_ns) {
        if (most > 0) {
            iso_stream_row(loop.plant->y, model->outputs);
        }
        good = (most == 0 || time < most) && iso_link_tick(&iso_the_link);
    }
    iso_link_end(&iso_the_link);
}

int main(int argc, char **argv)
{
    const iso_plant *const plant = &iso_the_plant;
    const uint64_t duration = iso_port_duration(argc, argv);
    iso_run_check();
    if (duration > 0) {
        iso_stream_header(plant, duration < INT64_MAX ? duration : 0);
    }
    iso_loop_start(&loop, plant);
    iso_link_open(&iso_the_link, &iso_the_interface, &loop, duration > 0);
    do {
        run(duration);
    } while (duration == 0);
    iso_stream_end(&loop, iso_the_link.control.hash);
    iso_port_drain();
    iso_port_exit(iso_the_link.stopped ? 1 : 0);
}
