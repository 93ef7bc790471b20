/* What the link takes of a tick on the board: instructions, by its clock, in lockstep; without those of the port's
 * channel, whose place a script has. A tick of the loop without a link is subtracted. All ticks are due before, so that
 * none waits; the least of many is one that no interrupt of the timer falls into. */
#define iso_port_receive fake_receive
#define iso_port_send fake_send
#define iso_port_idle fake_idle

#include "core/link/link.c"

#include "tests/core/link/controllers/script.h"
#include "tests/tap.h"

enum { TICKS = 40, FRAME_MOST = 64 };

static iso_loop loop;
static iso_link link;
void fake_idle(void)
{
}

static void put_start(void)
{
    iso_frame_writer w = iso_frame_begin(wire.in, ISO_LINK_START);
    iso_frame_put(&w, iso_the_interface.identity, 8);
    iso_frame_put(&w, ISO_LINK_LOCKSTEP, 1);
    iso_frame_put(&w, 0, 8);
    wire.count = iso_frame_end(&w);
    wire.taken = wire.sent = 0;
}

static void put_inputs(void)
{
    static const real u[FRAME_MOST] = {R(0.37)};
    iso_frame_writer w = iso_frame_begin(wire.in, ISO_LINK_INPUTS);
    iso_frame_put(&w, loop.tick, 8);
    iso_frame_put_reals(&w, u, iso_the_interface.wire_count);
    wire.count = iso_frame_end(&w);
    wire.taken = wire.sent = 0;
}

/* Until so many ticks are due. */
static void let_pass(const uint32_t ticks)
{
    const uint64_t begin = iso_port_clock();
    while (iso_port_clock() - begin < (uint64_t)ticks * loop.period) {
    }
}

/* The least of some ticks, with the link or without. */
static uint32_t least(const bool has_link)
{
    const uint64_t first = iso_port_clock(), overhead = iso_port_clock() - first;
    uint64_t most = UINT32_MAX;
    let_pass(2 * TICKS);
    for (int i = 0; i < TICKS; i++) {
        if (has_link) {
            put_inputs();
        }
        const uint64_t begin = iso_port_clock();
        const bool good = has_link ? iso_link_tick(&link) : iso_loop_tick(&loop);
        const uint64_t counts = iso_port_clock() - begin - overhead;
        most = good && counts < most ? counts : most;
    }
    return (uint32_t)most;
}

int main(void)
{
    iso_loop_start(&loop, &iso_the_plant);
    const uint32_t alone = least(false);
    iso_link_open(&link, &iso_the_interface, &loop, false);
    put_start();
    iso_link_begin(&link);
    const uint32_t with = least(true);
    tap_ok(loop.tick == TICKS && link.statistics.inputs == TICKS, "each tick has taken inputs");
    tap_note("bytes of a frame of inputs", (uint32_t)wire.count);
    tap_note("bytes of a frame of outputs", (uint32_t)wire.sent);
    tap_note("a tick of the loop", alone);
    tap_note("the link beside it", with - alone);
    tap_done();
}
