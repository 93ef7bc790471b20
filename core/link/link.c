#include "core/link/link.h"

#include "core/runtime/hash.h"
#include "port/channel.h"
#include "port/port.h"

/* Bytes that are taken from the channel at once; and how often in a row, so that endless bytes do not keep the plant
 * from its tick. */
enum { CHUNK_BYTES = 64, CHUNKS = 64 };

/* Bytes of payload of frames whose size does not depend on the plant. */
enum {
    HELLO_BYTES = 0 ISO_LINK_HELLO_FIELDS(ISO_FIELD_BYTES),
    START_BYTES = 0 ISO_LINK_START_FIELDS(ISO_FIELD_BYTES),
    ASK_END_BYTES = 0,
    TICK_BYTES = 0 ISO_LINK_INPUTS_FIELDS(ISO_FIELD_BYTES),
};
_Static_assert(ISO_LINK_TICK_BYTES(1) == TICK_BYTES + sizeof(real), "inputs and outputs stand behind a tick");

/* The fields of a frame as numbers of 64 bits, and how they are written. */
#define FIELD(name, ...) uint64_t name;
#define PUT_FIELD(name, type, count) iso_frame_put(&w, fields.name, ISO_BYTES_OF_##type);

/* --- Frames to the controller ------------------------------------------------------------------------------------ */

static void put_frame(iso_link *const link, iso_frame_writer *const w)
{
    const size_t bytes = iso_frame_end(w);
    link->statistics.unsent += !iso_port_send(ISO_CHANNEL_CONTROLLER, link->interface->sent, bytes);
}

static void send_plant(iso_link *const link)
{
    const iso_interface *const interface = link->interface;
    const iso_model *const model = link->loop->plant->model;
    const struct {
        ISO_LINK_PLANT_FIELDS(FIELD)
    } fields = {
        .version = ISO_LINK_VERSION,
        .real_bytes = sizeof(real),
        .wires = interface->wire_count,
        .outputs = model->outputs,
        .states = model->states,
        .tunables = model->parameters,
        .identity = interface->identity,
        .period_ns = model->period_ns,
    };
    iso_frame_writer w = iso_frame_begin(interface->sent, ISO_LINK_PLANT);
    ISO_LINK_PLANT_FIELDS(PUT_FIELD)
    put_frame(link, &w);
}

static void send_outputs(iso_link *const link)
{
    const iso_plant *const plant = link->loop->plant;
    iso_frame_writer w = iso_frame_begin(link->interface->sent, ISO_LINK_OUTPUTS);
    iso_frame_put(&w, link->loop->tick, TICK_BYTES);
    iso_frame_put_reals(&w, plant->y, plant->model->outputs);
    put_frame(link, &w);
}

static void send_end(iso_link *const link)
{
    iso_frame_writer w = iso_frame_begin(link->interface->sent, ISO_LINK_END);
    iso_command_put_counts(&link->control, &link->statistics, &w);
    put_frame(link, &w);
}

static void refuse(iso_link *const link, const iso_link_reason reason)
{
    const uint8_t type = link->reader.buffer[0];
    link->statistics.refused++;
    const struct {
        ISO_LINK_REFUSAL_FIELDS(FIELD)
    } fields = {.reason = reason, .type = type};
    iso_frame_writer w = iso_frame_begin(link->interface->sent, ISO_LINK_REFUSAL);
    ISO_LINK_REFUSAL_FIELDS(PUT_FIELD)
    put_frame(link, &w);
}

/* --- Frames from it ---------------------------------------------------------------------------------------------- */

#define TAKE_FIELD(name, type, count)                                                                                  \
    start.name = iso_frame_number(at, ISO_BYTES_OF_##type);                                                            \
    at += ISO_BYTES_OF_##type;

/* A start that comes again before the first step, because its answer was lost, is answered again. */
static void take_start(iso_link *const link, const uint8_t *const payload)
{
    struct {
        ISO_LINK_START_FIELDS(FIELD)
    } start;
    const uint8_t *at = payload;
    ISO_LINK_START_FIELDS(TAKE_FIELD)
    if (start.identity != link->interface->identity) {
        refuse(link, ISO_LINK_FOREIGN);
    } else if (start.mode >= ISO_LINK_MODES) {
        refuse(link, ISO_LINK_NO_MODE);
    } else if (link->running && link->loop->tick == 0 && start.mode == link->mode && start.ticks == link->ticks) {
        send_outputs(link);
    } else if (link->running && link->once) {
        refuse(link, ISO_LINK_ALREADY_STARTED);
    } else {
        link->mode = (iso_link_mode)start.mode;
        link->ticks = start.ticks;
        link->is_starting = true;
    }
}

static void take_values(iso_link *const link, const uint64_t answers, const uint8_t *const payload)
{
    link->statistics.inputs++;
    link->statistics.late += answers < link->loop->tick;
    link->answered = answers + 1;
    link->fresh = true;
    for (uint16_t i = 0; i < link->interface->wire_count; i++) {
        link->interface->values[i] = iso_frame_real(payload + i * sizeof(real));
    }
}

/* Only values that are newer than all before are taken. In lockstep, repeated inputs mean that the outputs which answer
 * them were lost; after the end they mean that the end frame was lost. */
static void take_inputs(iso_link *const link, const uint8_t *const payload)
{
    const uint64_t answers = iso_frame_number(payload, TICK_BYTES);
    const uint64_t tick = link->loop->tick;
    if (!link->running && link->ended) {
        send_end(link);
    } else if (!link->running) {
        refuse(link, ISO_LINK_NOT_STARTED);
    } else if (answers > tick || answers + 1 < link->answered) {
        link->statistics.stale++;
    } else if (answers + 1 == link->answered) {
        link->statistics.repeated++;
        if (link->mode == ISO_LINK_LOCKSTEP && link->answered == tick) {
            send_outputs(link);
        }
    } else {
        take_values(link, answers, payload + TICK_BYTES);
    }
}

/* Keeps the values as the plant admitted them, so that one that is not finite, or beyond its limits, counts once. */
static void keep_admitted(const iso_link *const link)
{
    for (uint16_t i = 0; i < link->interface->wire_count; i++) {
        link->interface->values[i] = link->loop->plant->u[link->interface->wires[i].input];
    }
}

/* At another tick: inputs that come now answer the outputs there; until then the plant's own hold. */
static void take_up(iso_link *const link)
{
    link->answered = link->loop->tick;
    link->age = 0;
    link->fresh = false;
    keep_admitted(link);
}

/* A run from tick 0, where the plant is. */
static void set_out(iso_link *const link)
{
    link->statistics = (iso_link_statistics){0};
    link->control.hash = ISO_HASH_START;
    link->is_starting = link->leaving = link->stopped = false;
    link->running = true;
    take_up(link);
}

/* The run from another tick, where the plant was put; also one that the guard had stopped. */
static void go_on(iso_link *const link)
{
    link->leaving = link->leaving && link->running;
    link->stopped = false;
    link->running = true;
    take_up(link);
}

static void take_command(iso_link *const link, const uint8_t *const payload, const size_t length)
{
    const iso_command_outcome outcome = iso_command_do(&link->commands, &link->control, link->running, payload, length);
    if (outcome == ISO_COMMAND_UNKNOWN) {
        refuse(link, ISO_LINK_UNKNOWN);
        return;
    }
    if (outcome == ISO_COMMAND_ANEW) {
        set_out(link);
    } else if (outcome == ISO_COMMAND_WENT_ON) {
        go_on(link);
    } else if (outcome == ISO_COMMAND_MOVED) {
        take_up(link);
    }
    iso_frame_writer w = iso_frame_begin(link->interface->sent, ISO_LINK_ANSWER);
    iso_command_put_answer(&link->commands, &link->control, &link->statistics, link->running, payload, &w);
    put_frame(link, &w);
    if (outcome != ISO_COMMAND_DONE) {
        send_outputs(link);
    }
}

static void take_frame(iso_link *const link, const size_t length)
{
    const uint8_t type = link->reader.buffer[0];
    const uint8_t *const payload = link->reader.buffer + 1;
    if (type == ISO_LINK_HELLO && length == HELLO_BYTES) {
        send_plant(link);
    } else if (type == ISO_LINK_START && length == START_BYTES) {
        take_start(link, payload);
    } else if (type == ISO_LINK_INPUTS && length == ISO_LINK_TICK_BYTES(link->interface->wire_count)) {
        take_inputs(link, payload);
    } else if (type == ISO_LINK_END && length == ASK_END_BYTES) {
        link->leaving = link->running;
    } else if (type == ISO_LINK_COMMAND) {
        take_command(link, payload, length);
    } else {
        refuse(link, ISO_LINK_UNKNOWN);
    }
}

/* Takes the received bytes. */
static void receive(iso_link *const link)
{
    uint8_t bytes[CHUNK_BYTES];
    size_t count = sizeof bytes;
    for (int chunk = 0; chunk < CHUNKS && count == sizeof bytes; chunk++) {
        count = iso_port_receive(ISO_CHANNEL_CONTROLLER, bytes, sizeof bytes);
        for (size_t i = iso_frame_take_run(&link->reader, bytes, count); i < count;
             i += 1 + iso_frame_take_run(&link->reader, bytes + i + 1, count - i - 1)) {
            size_t length = 0;
            const iso_frame_state state = iso_frame_take(&link->reader, bytes[i], &length);
            link->statistics.damaged += state == ISO_FRAME_DAMAGED;
            if (state == ISO_FRAME_WHOLE) {
                take_frame(link, length);
            }
        }
    }
}

/* --- A run ------------------------------------------------------------------------------------------------------- */

static void serve_before(const iso_link *const link)
{
    for (uint16_t i = 0; i < link->interface->service_count; i++) {
        link->interface->services[i]->before(link->loop);
    }
}

static void serve_after(const iso_link *const link)
{
    for (uint16_t i = 0; i < link->interface->service_count; i++) {
        link->interface->services[i]->after(link->loop);
    }
}

void iso_link_open(iso_link *const link, const iso_interface *const interface, iso_loop *const loop, const bool once)
{
    *link = (iso_link){
        .interface = interface,
        .loop = loop,
        .reader = {.buffer = interface->received, .room = interface->frame_bytes},
        .once = once,
        .control = {.loop = loop,
                    .snapshot = interface->snapshot,
                    .snapshot_bytes = interface->snapshot_bytes,
                    .identity = interface->identity,
                    .hash = ISO_HASH_START},
    };
    for (uint16_t i = 0; i < interface->service_count; i++) {
        interface->services[i]->start(loop);
    }
}

void iso_link_begin(iso_link *const link)
{
    receive(link);
    while (!link->is_starting && !link->running) {
        serve_before(link);
        iso_port_idle();
        receive(link);
    }
    if (link->is_starting) {
        iso_loop_restart(link->loop);
        iso_control_run(&link->control, 0);
        set_out(link);
        send_outputs(link);
    }
}

static bool is_over(const iso_link *const link)
{
    return link->is_starting || link->leaving || link->stopped || (link->ticks > 0 && link->loop->tick >= link->ticks);
}

/* Whether the plant waits: it rests, or in lockstep the inputs of the next step have not come. */
static bool is_waiting(const iso_link *const link)
{
    return !is_over(link) && (iso_control_is_resting(&link->control) ||
                              (link->mode == ISO_LINK_LOCKSTEP && link->answered <= link->loop->tick));
}

/* If the port's next tick is due when the wait is over, the wait has taken it, and it passes. */
static void wait_to_go(iso_link *const link)
{
    iso_loop *const loop = link->loop;
    const bool waited = is_waiting(link);
    while (is_waiting(link)) {
        serve_before(link);
        iso_port_idle();
        receive(link);
    }
    if (waited && iso_port_clock() - loop->due >= loop->period) {
        iso_loop_rest(loop);
    }
}

/* Puts the latest values into the inputs; of those that are too old, the safe ones. */
static void set_inputs(iso_link *const link)
{
    const iso_interface *const interface = link->interface;
    bool is_safe = false;
    link->age = link->fresh ? 0 : link->age + 1;
    link->statistics.missing += !link->fresh;
    for (uint16_t i = 0; i < interface->wire_count; i++) {
        const iso_wire *const wire = &interface->wires[i];
        if (wire->after > 0 && link->age >= wire->after) {
            link->loop->plant->u[wire->input] = wire->safe;
            is_safe = true;
        } else if (link->answered > 0) {
            link->loop->plant->u[wire->input] = interface->values[i];
        }
    }
    link->statistics.safe += is_safe;
    link->fresh = false;
}

bool iso_link_tick(iso_link *const link)
{
    iso_loop *const loop = link->loop;
    const iso_plant *const plant = loop->plant;
    receive(link);
    do { /* a tick that has begun begins again if a command makes the plant wait */
        wait_to_go(link);
        if (is_over(link)) {
            return false;
        }
        iso_loop_begin(loop);
        receive(link);
        if (is_over(link)) {
            return false;
        }
    } while (is_waiting(link));
    iso_port_read(plant->u, plant->model->inputs);
    set_inputs(link);
    serve_before(link);
    link->stopped = !iso_loop_end(loop);
    keep_admitted(link);
    if (loop->guard != plant->model->states) {
        return false;
    }
    iso_control_done(&link->control, iso_hash_reals(link->control.hash, plant->x, plant->model->states));
    send_outputs(link);
    serve_after(link);
    return true;
}

iso_control_answer iso_link_restore(iso_link *const link, const size_t bytes)
{
    if (link->running && !iso_control_is_resting(&link->control)) {
        return ISO_CONTROL_RUNS; /* perhaps within a tick */
    }
    const iso_control_answer answer = iso_command_restore(&link->control, link->running, bytes);
    if (answer == ISO_CONTROL_DONE) {
        go_on(link);
        send_outputs(link);
    }
    return answer;
}

void iso_link_end(iso_link *const link)
{
    link->running = false;
    link->ended = true;
    send_end(link);
}
