/* The program of a plant with a link: rests until a controller starts a run, makes it, and rests again. Where the port
 * says how long to run, it makes one run, of at most that time, writes it to the console, and ends. */
#include "core/link/link.h"
#include "core/numbers/self_check.h"
#include "port/channel.h"
#include "port/port.h"

static iso_loop loop;
iso_link iso_the_link;

/* Makes a run of at most `most` nanoseconds of the plant's time, 0: without an end. */
static void run(const uint64_t most)
{
    const iso_model *const model = loop.plant->model;
    uint64_t time = 0;
    iso_link_begin(&iso_the_link);
    if (most > 0) {
        iso_stream_row(loop.plant->y, model->outputs);
    }
    while ((most == 0 || time < most) && iso_link_tick(&iso_the_link)) {
        time += model->period_ns;
        if (most > 0) {
            iso_stream_row(loop.plant->y, model->outputs);
        }
    }
    iso_link_end(&iso_the_link);
}

int main(int argc, char **argv)
{
    const iso_plant *const plant = &iso_the_plant;
    const uint64_t duration = iso_port_duration(argc, argv);
    if (!iso_self_check()) {
        iso_stream_bail_out("the processor or a flag of the compiler changes the bits of results; compile with "
                            "-std=c11 -ffp-contract=off, round to nearest, and do not flush denormals to zero");
        iso_port_exit(1);
    }
    if (duration > 0) {
        iso_stream_header(plant, duration);
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
