/* Bytes as what comes in over the link of a plant: as a stream; as frames whose check is right, commands among them;
 * and as changes of a snapshot, whose check is then made right. Whatever is restored, the plant goes on, and its states
 * are finite. */
#include <math.h>
#include <stdlib.h>

#define ISO_METHOD ISO_ADAMS
#define ISO_METHOD_NAME adams
#include "core/runtime/handwritten.h"

#include "core/link/link.h"
#include "port/channel.h"
#include "port/none/inputs.h"
#include "port/none/outputs.h"
#include "port/port.h"

enum { STATES = 2, INPUTS = 1, PARAMETERS = 1, OUTPUTS = 2, PERIOD = 1000000 };

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

/* --- A plant -------------------------------------------------------------------------------------------------------
 */

ISO_PLANT_MEMORY(STATES, INPUTS, PARAMETERS, OUTPUTS);
static const real start[STATES] = {R(1.0)};
static const real defaults[PARAMETERS] = {R(40000.0)};

static void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                       const real *restrict const p)
{
    dx[0] = x[1];
    dx[1] = u[0] - p[0] * x[0] - R(20.0) * x[1];
}

static void output(real *const y, const real *const x, const real *const u, const real *const p)
{
    (void)u;
    (void)p;
    memcpy(y, x, OUTPUTS * sizeof *y);
}

static const iso_equations equations = {.derivative = derivative};
ISO_PLANT(STATES, INPUTS, PARAMETERS, OUTPUTS, .name = "oscillator", .defaults = defaults);

static const iso_wire wires[INPUTS] = {{.input = 0, .safe = R(0.5), .after = 3}};
static real values[INPUTS];
static uint8_t received[ISO_LINK_BYTES(INPUTS, OUTPUTS)], sent[sizeof received];
static unsigned char record[ISO_SNAPSHOT_BYTES(sizeof(plant_memory))];
const iso_interface iso_the_interface = {.identity = 7,
                                         .wires = wires,
                                         .wire_count = INPUTS,
                                         .values = values,
                                         .received = received,
                                         .sent = sent,
                                         .frame_bytes = sizeof received,
                                         .snapshot = record,
                                         .snapshot_bytes = sizeof record};
static iso_loop loop;
static iso_link the_link;

/* --- A port and a wire ---------------------------------------------------------------------------------------------
 */

static uint64_t now, told;
static uint8_t towards[4096];
static size_t towards_count, towards_at;

uint32_t iso_port_start(const uint32_t period_ns)
{
    (void)period_ns;
    now = told = 0;
    return PERIOD;
}

uint64_t iso_port_wait(void)
{
    told++;
    now = told * PERIOD;
    return told;
}

uint64_t iso_port_clock(void)
{
    return now;
}

_Noreturn void iso_port_exit(const int status)
{
    (void)status;
    abort(); /* no input may end the program */
}

void iso_port_write(const void *const bytes, const size_t count)
{
    (void)bytes;
    (void)count;
}

size_t iso_port_receive(const iso_channel channel, void *const bytes, const size_t count)
{
    const size_t left = towards_count - towards_at, taken = left < count ? left : count;
    (void)channel;
    memcpy(bytes, towards + towards_at, taken);
    towards_at += taken;
    return taken;
}

bool iso_port_send(const iso_channel channel, const void *const bytes, const size_t count)
{
    (void)channel;
    (void)bytes;
    (void)count;
    return true;
}

/* Sends these bytes, or what of them there is room for. */
static void put(const uint8_t *const bytes, const size_t count)
{
    if (towards_at == towards_count) {
        towards_at = towards_count = 0;
    }
    const size_t room = sizeof towards - towards_count, fits = count < room ? count : room;
    memcpy(towards + towards_count, bytes, fits);
    towards_count += fits;
}

static void put_frame(const uint8_t *const payload, const size_t count)
{
    static uint8_t buffer[ISO_FRAME_BYTES(256)];
    iso_frame_writer w = iso_frame_begin(buffer, payload[0]);
    for (size_t i = 1; i < count; i++) {
        iso_frame_put(&w, payload[i], 1);
    }
    put(buffer, iso_frame_end(&w));
}

/* A plant that waits gets by turns what ends each kind of wait. */
void iso_port_idle(void)
{
    static const uint8_t run[] = {ISO_LINK_COMMAND, ISO_COMMAND_RUN, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    static const uint8_t leave[] = {ISO_LINK_END};
    static const uint8_t begin[] = {ISO_LINK_START, 7, 0, 0, 0, 0, 0, 0, 0, ISO_LINK_FREE, 0, 0, 0, 0, 0, 0, 0, 0};
    static unsigned looks;
    looks++;
    put_frame(looks % 3 == 0   ? run
              : looks % 3 == 1 ? leave
                               : begin,
              looks % 3 == 0   ? sizeof run
              : looks % 3 == 1 ? sizeof leave
                               : sizeof begin);
}

/* --- What the bytes ask for ----------------------------------------------------------------------------------------
 */

static void go(const unsigned ticks)
{
    for (unsigned i = 0; i < ticks; i++) {
        if (!the_link.running) {
            iso_link_begin(&the_link);
        }
        if (!iso_link_tick(&the_link)) {
            iso_link_end(&the_link);
        }
        for (int s = 0; s < STATES && loop.guard == STATES; s++) {
            if (!isfinite(the_memory.x[s])) {
                abort();
            }
        }
    }
}

/* A snapshot of now with these bytes from some place on, its check made right; the plant is put to it. */
static void restore(const uint8_t *const bytes, const size_t count)
{
    const uint8_t command[] = {
        ISO_LINK_COMMAND, ISO_COMMAND_RESTORE, bytes[0], sizeof record & 0xFF, sizeof record >> 8, 0, 0};
    const size_t room = sizeof record - 4, place = bytes[0] % room;
    if (iso_control_take(&the_link.control) != ISO_CONTROL_DONE) {
        return;
    }
    memcpy(record + place, bytes, count < room - place ? count : room - place);
    uint32_t check = UINT32_MAX;
    for (size_t i = 0; i < room; i++) {
        check ^= record[i];
        for (int bit = 0; bit < 8; bit++) {
            check = check >> 1 ^ ((check & 1) != 0 ? UINT32_C(0xEDB88320) : 0);
        }
    }
    check = ~check;
    memcpy(record + room, &check, sizeof check);
    put_frame(command, sizeof command);
}

int LLVMFuzzerTestOneInput(const uint8_t *const bytes, const size_t count)
{
    towards_at = towards_count = 0;
    iso_loop_start(&loop, &iso_the_plant);
    iso_link_open(&the_link, &iso_the_interface, &loop, false);
    go(2);
    for (size_t at = 0; at + 2 < count;) {
        const size_t left = count - at - 2;
        const size_t length = bytes[at + 1] < left ? bytes[at + 1] : left;
        const uint8_t *const of = bytes + at + 2;
        switch (length == 0 ? 3 : bytes[at] % 4) {
        case 0:
            put(of, length);
            break;
        case 1:
            put_frame(of, length);
            break;
        case 2:
            restore(of, length);
            break;
        default:
            break;
        }
        go(1 + bytes[at] / 64);
        at += 2 + length;
    }
    return 0;
}
