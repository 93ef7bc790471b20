/* What measurement and calibration take of a tick on the board: instructions, by its clock, without those of the port's
 * channel, whose place a script has. */
#include "tests/core/xcp/xcp/channel.h"

#include "core/link/link.h"
#include "core/xcp/service.h"
#include "port/port.h"
#include "tests/core/link/controllers/script.h"
#include "tests/tap.h"

enum { VALUES = 8, TICKS = 50, TICK_NS = 1000000 };

typedef struct shown {
    real x[VALUES];
    real p[VALUES];
    real u[VALUES];
} shown;

static shown memory;
iso_link iso_the_link;
const iso_xcp_description iso_xcp_the_description = {"cost", "0", NULL, NULL, {2, 10000}, {6, 1}};
static const iso_model model = {.memory_bytes = sizeof memory, .parameters = VALUES, .inputs = VALUES};
static const iso_plant plant = {.model = &model, .memory = &memory, .p = memory.p, .u = memory.u};
static const iso_interface interface = {.wires = NULL};
static iso_loop loop = {.plant = &plant};

/* Snapshots are the link's: none is asked for here. */
iso_control_answer iso_control_take(iso_control *const control)
{
    (void)control;
    return ISO_CONTROL_NO_RUN;
}

iso_control_answer iso_link_restore(iso_link *const link, const size_t bytes)
{
    (void)link, (void)bytes;
    return ISO_CONTROL_NO_RUN;
}

uint32_t fake_opened(const iso_channel channel)
{
    (void)channel;
    return 0;
}

/* The instructions of what the service does in a tick. */
static uint32_t tick(void)
{
    const uint64_t begin = iso_port_clock(), first = iso_port_clock();
    iso_xcp_service.before(&loop);
    loop.tick++;
    iso_xcp_service.after(&loop);
    return (uint32_t)(iso_port_clock() - first - (first - begin));
}

/* The most of many ticks without a command. */
static uint32_t ticks(void)
{
    uint32_t most = 0;
    for (int i = 0; i < TICKS; i++) {
        const uint32_t one = tick();
        most = one > most ? one : most;
    }
    return most;
}

/* A command: what its tick takes. */
static uint32_t ask(const uint8_t *const command, const uint16_t length)
{
    memcpy(wire.in + ISO_XCP_HEADER_BYTES, command, length);
    wire.count = iso_xcp_frame(wire.in, length, 0, true);
    wire.taken = 0;
    return tick();
}

/* A list of 8 values from there on. */
static void make_list(const real *const at, const uint8_t mode)
{
    static const uint8_t commands[][8] = {{ISO_XCP_FREE_DAQ},
                                          {ISO_XCP_ALLOC_DAQ, 0, 1, 0},
                                          {ISO_XCP_ALLOC_ODT, 0, 0, 0, 1},
                                          {ISO_XCP_ALLOC_ODT_ENTRY, 0, 0, 0, 0, VALUES},
                                          {ISO_XCP_SET_DAQ_PTR, 0, 0, 0, 0, 0}};
    const uint8_t start[][8] = {{ISO_XCP_SET_DAQ_LIST_MODE, mode, 0, 0, 0, 0, 1, 0},
                                {ISO_XCP_START_STOP_DAQ_LIST, 1, 0, 0}};
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
        ask(commands[i], sizeof commands[i]);
    }
    for (size_t i = 0; i < VALUES; i++) {
        uint8_t entry[8] = {ISO_XCP_WRITE_DAQ, 0xFF, sizeof(real), 0};
        iso_xcp_put_long(entry + 4, iso_xcp_address(&at[i]));
        ask(entry, sizeof entry);
    }
    for (size_t i = 0; i < sizeof start / sizeof start[0]; i++) {
        ask(start[i], sizeof start[i]);
    }
}

int main(void)
{
    static const uint8_t connect[] = {ISO_XCP_CONNECT, 0};
    uint8_t upload[8] = {ISO_XCP_SHORT_UPLOAD, sizeof(real)}, download[12] = {ISO_XCP_SHORT_DOWNLOAD, sizeof(real)};
    iso_xcp_put_long(upload + 4, iso_xcp_address(memory.x));
    iso_xcp_put_long(download + 4, iso_xcp_address(memory.p));
    (void)iso_port_start(TICK_NS);
    iso_the_link.interface = &interface;
    iso_xcp_service.start(&loop);
    tap_note("nothing connected", ticks());
    ask(connect, sizeof connect);
    tap_note("connected", ticks());
    tap_note("with SHORT_UPLOAD of a number", ask(upload, sizeof upload));
    tap_note("with SHORT_DOWNLOAD of a number", ask(download, sizeof download));
    make_list(memory.x, ISO_XCP_STAMPED);
    const size_t sent = wire.sent;
    tap_note("with a list of 8 values", ticks());
    tap_count((uint32_t)(wire.sent - sent), TICKS * (4 + 1 + 4 + VALUES * sizeof(real) + 1 + 2),
              "50 samples were sent");
    make_list(memory.u, ISO_XCP_STIM);
    tap_note("with a list that stimulates 8 inputs, without a sample", ticks());
    uint8_t stimulus[1 + VALUES * sizeof(real)] = {0};
    memcpy(stimulus + 1, &(real){R(0.5)}, sizeof(real));
    tap_note("with its sample", ask(stimulus, sizeof stimulus));
    tap_ok(iso_bits_of(memory.u[0]) == iso_bits_of(R(0.5)), "which set the inputs");
    tap_note("with the sample of before", ticks());
    tap_done();
}
