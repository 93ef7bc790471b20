#include "core/xcp/service.h"

#include "core/link/link.h"
#include "core/runtime/policy_counts.h"
#include "port/channel.h"

static iso_xcp_slave slave;
static iso_xcp_reader reader;
static uint32_t opened; /* how often the other end was, when the reader began */
static uint16_t counter;

/* A response that has not gone; 0 bytes: there is none. It has room for the whole frame of a packet. */
static uint8_t response[ISO_XCP_FRAME_BYTES];
static uint16_t response_bytes;

static uint8_t sample[ISO_XCP_SAMPLE_BYTES];

iso_xcp_statistics iso_xcp_the_statistics;

static iso_control_answer take_snapshot(void)
{
    return iso_control_take(&iso_the_link.control);
}

static iso_control_answer restore(const size_t bytes)
{
    return iso_link_restore(&iso_the_link, bytes);
}

/* How long a stimulus holds: as long as the link holds an input. */
static uint32_t patience_of(const uint16_t input)
{
    const iso_interface *const interface = iso_the_link.interface;
    uint32_t patience = 0;
    for (uint16_t i = 0; i < interface->wire_count; i++) {
        patience = interface->wires[i].input == input ? interface->wires[i].after : patience;
    }
    return patience;
}

static void start(iso_loop *const loop)
{
    const iso_plant *const plant = loop->plant;
    const iso_policy *const policy = plant->model->policy;
    const uint32_t policy_bytes = policy == NULL ? 0 : policy->count * (uint32_t)sizeof(uint64_t);
    const iso_xcp_access access = {
        .readable = {{plant->memory, (uint32_t)plant->model->memory_bytes},
                     {loop, sizeof *loop},
                     {&iso_the_link, sizeof iso_the_link},
                     {&iso_xcp_the_statistics, sizeof iso_xcp_the_statistics},
                     {iso_the_link.control.snapshot, (uint32_t)iso_the_link.control.snapshot_bytes},
                     {policy == NULL ? NULL : policy->counts, policy_bytes}},
        .tunables = plant->p,
        .limits = iso_xcp_the_description.limits,
        .tunable_count = plant->model->parameters,
        .inputs = plant->u,
        .input_count = plant->model->inputs,
        .patience = patience_of,
        .control = &iso_the_link.control,
        .take = take_snapshot,
        .restore = restore,
    };
    iso_xcp_start(&slave, &iso_xcp_the_description, &access);
}

/* Another master is at the other end, or the first: bytes of the last one are dropped. */
static void greet(void)
{
    const uint32_t times = iso_port_opened(ISO_CHANNEL_CALIBRATION);
    if (times != opened) {
        opened = times;
        reader = (iso_xcp_reader){.is_serial = false};
        response_bytes = 0;
        iso_xcp_disconnect(&slave);
    }
    reader.is_serial = times == 0;
}

/* Sends the response that waits, and those that follow it. Returns whether none waits any more. */
static bool respond(uint16_t length)
{
    do {
        if (length > 0) {
            response_bytes = iso_xcp_frame(response, length, counter, reader.is_serial);
            counter++;
        }
        if (response_bytes > 0 && !iso_port_send(ISO_CHANNEL_CALIBRATION, response, response_bytes)) {
            return false;
        }
        response_bytes = 0;
        length = iso_xcp_continue(&slave, response + ISO_XCP_HEADER_BYTES);
    } while (length > 0);
    return true;
}

/* Takes in up to `most` bytes, and returns their number. The first bytes of another master start a new reader. */
static uint16_t take(const uint16_t most)
{
    uint8_t came[ISO_XCP_FRAME_BYTES];
    const size_t count = iso_port_receive(ISO_CHANNEL_CALIBRATION, came, most);
    if (count > 0) {
        greet();
        memcpy(reader.bytes + reader.used, came, count);
        reader.used = (uint8_t)(reader.used + count);
    }
    return (uint16_t)count;
}

/* The next command among the bytes that came, behind packets of stimulation, which are taken. Returns its length, or
 * 0. */
static uint16_t read_command(void)
{
    const uint8_t *const packet = reader.bytes + ISO_XCP_HEADER_BYTES;
    uint16_t length = iso_xcp_read(&reader);
    while (length > 0 && packet[0] <= ISO_XCP_LAST_STIMULUS) {
        if (iso_xcp_stimulates(&slave.stimulation, &slave.daq)) {
            iso_xcp_the_statistics.stimuli += iso_xcp_stimulation_take(&slave.stimulation, &slave.daq, packet, length);
        }
        length = iso_xcp_read(&reader);
    }
    return length;
}

/* The next command, if it is among so many bytes. Returns its length, or 0. */
static uint16_t next_command(void)
{
    uint16_t left = ISO_XCP_TICK_BYTES, came = 1, length = read_command();
    while (length == 0 && left > 0 && came > 0) {
        const uint16_t missing = iso_xcp_missing(&reader);
        came = take(missing < left ? missing : left);
        left = (uint16_t)(left - came);
        length = read_command();
    }
    return length;
}

static void before(iso_loop *const loop)
{
    greet();
    slave.tick = loop->tick;
    const uint16_t length = respond(0) ? next_command() : 0;
    if (length > 0) {
        iso_xcp_the_statistics.commands++;
        (void)respond(
            iso_xcp_answer(&slave, reader.bytes + ISO_XCP_HEADER_BYTES, length, response + ISO_XCP_HEADER_BYTES));
    }
    if (iso_xcp_stimulates(&slave.stimulation, &slave.daq)) {
        iso_xcp_stimulation_set(&slave.stimulation, &slave.access);
    }
}

/* All packets of a list, or none. */
static void send_sample(const uint8_t list, const uint32_t tick)
{
    iso_xcp_list *const i = &slave.daq.lists[list];
    uint16_t used = 0, next = counter;
    for (uint8_t table = 0; table < i->tables.count; table++) {
        const uint16_t length = iso_xcp_daq_packet(&slave.daq, list, table, tick, sample + used + ISO_XCP_HEADER_BYTES);
        used = (uint16_t)(used + iso_xcp_frame(sample + used, length, next, reader.is_serial));
        next++;
    }
    i->overloaded = !iso_port_send(ISO_CHANNEL_CALIBRATION, sample, used);
    iso_xcp_the_statistics.lost += i->overloaded;
    iso_xcp_the_statistics.samples += !i->overloaded;
    counter = i->overloaded ? counter : next;
}

static void after(iso_loop *const loop)
{
    if (iso_xcp_stimulates(&slave.stimulation, &slave.daq)) {
        iso_xcp_the_statistics.missed += iso_xcp_stimulation_pass(&slave.stimulation);
    }
    for (uint8_t list = 0; list < slave.daq.list_count; list++) {
        if (iso_xcp_daq_due(&slave.daq, list)) {
            send_sample(list, (uint32_t)loop->tick);
        }
    }
}

const iso_service iso_xcp_service = {start, before, after};
