/* The port and the wire of tests/core/link/link.c: the port's functions are renamed, what the plant sends is kept, and
 * what it gets is written here. */
#ifndef ISO_TESTS_UNIT_LINK_WIRE_H
#define ISO_TESTS_UNIT_LINK_WIRE_H

#include "core/link/link.h"
#include "core/methods/all.h"
#include "core/methods/method.h"
#include "port/channel.h"
#include "port/port.h"
#include "tests/draw.h"
#include "tests/tap.h"

#undef iso_port_read
#undef iso_port_publish
#define iso_port_safe fake_safe
#define iso_port_start fake_start
#define iso_port_wait fake_wait
#define iso_port_clock fake_clock
#define iso_port_read fake_read
#define iso_port_publish fake_publish
#define iso_port_receive fake_receive
#define iso_port_send fake_send
#define iso_port_idle fake_idle

enum { PERIOD = 1600, WIRES = 3, STATES = 2, TICKS_MOST = 300, WIRE_BYTES = 2048 };

/* --- The port ---------------------------------------------------------------------------------------------------- */

static uint64_t now, reported;

static uint32_t fake_start(const uint32_t period_ns)
{
    now = reported = 0;
    return period_ns;
}

static uint64_t fake_wait(void)
{
    const uint64_t due = (reported + 1) * PERIOD;
    now = now < due ? due : now;
    reported = now / PERIOD;
    return reported;
}

static uint64_t fake_clock(void)
{
    return now;
}

static void fake_read(real *const u, const size_t inputs)
{
    (void)u;
    (void)inputs;
}

static void fake_publish(const real *const y, const size_t outputs)
{
    (void)y;
    (void)outputs;
}

static uint32_t made_safe;

static void fake_safe(void)
{
    made_safe++;
}

/* --- The wire ---------------------------------------------------------------------------------------------------- */

/* To the plant. */
static uint8_t towards[WIRE_BYTES];
static size_t towards_count;

/* From the plant, by types: the number of frames, and the last. */
typedef struct arrival {
    uint32_t count;
    size_t length;
    uint8_t payload[ISO_LINK_END_BYTES];
} arrival;
enum { OF_OUTPUTS, OF_END, OF_PLANT, OF_REFUSAL, OTHERS, TYPES };
static arrival came[TYPES];

static arrival *came_of(const uint8_t type)
{
    static const uint8_t types[OTHERS] = {ISO_LINK_OUTPUTS, ISO_LINK_END, ISO_LINK_PLANT, ISO_LINK_REFUSAL};
    unsigned i = 0;
    while (i < OTHERS && types[i] != type) {
        i++;
    }
    return &came[i];
}

static uint8_t came_buffer[ISO_LINK_BYTES(WIRES, STATES)];
static iso_frame_reader came_reader = {.buffer = came_buffer, .room = sizeof came_buffer};
static bool is_jammed; /* the channel has no room */

static size_t fake_receive(const iso_channel channel, void *const bytes, const size_t count)
{
    const size_t taken = channel != ISO_CHANNEL_CONTROLLER ? 0 : towards_count < count ? towards_count : count;
    memcpy(bytes, towards, taken);
    memmove(towards, towards + taken, towards_count - taken);
    towards_count -= taken;
    return taken;
}

static bool fake_send(const iso_channel channel, const void *const bytes, const size_t count)
{
    for (size_t i = 0; i < count && !is_jammed && channel == ISO_CHANNEL_CONTROLLER; i++) {
        size_t length = 0;
        if (iso_frame_take(&came_reader, ((const uint8_t *)bytes)[i], &length) == ISO_FRAME_WHOLE) {
            arrival *const a = came_of(came_buffer[0]);
            a->count++;
            a->length = length;
            memcpy(a->payload, came_buffer + 1, length);
        }
    }
    return !is_jammed;
}

static void (*on_idle)(void);

static void fake_idle(void)
{
    enum { PATIENCE = 10000 };
    static uint32_t idles;
    idles++;
    if (idles == PATIENCE) {
        tap_ok(false, "the plant waits for ever");
        tap_done();
    }
    on_idle();
}

/* A frame to the plant: numbers of 8 bytes, a byte of mode behind the first, then reals. */
static iso_frame_writer out;

static void begin(const char type)
{
    out = iso_frame_begin(towards + towards_count, (uint8_t)type);
}

static void finish(void)
{
    towards_count += iso_frame_end(&out);
}

static const uint64_t plant_identity = UINT64_C(0x0123456789ABCDEF);

static void put_start(const uint64_t of, const iso_link_mode mode, const uint64_t ticks)
{
    begin(ISO_LINK_START);
    iso_frame_put(&out, of, 8);
    iso_frame_put(&out, (uint64_t)mode, 1);
    iso_frame_put(&out, ticks, 8);
    finish();
}

static void put_inputs(const uint64_t tick, const real *const values)
{
    begin(ISO_LINK_INPUTS);
    iso_frame_put(&out, tick, 8);
    iso_frame_put_reals(&out, values, WIRES);
    finish();
}

#endif
