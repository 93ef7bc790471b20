/* The account of a plant with a link against one made by other code: ticks that are late, lost or slow, stalls beyond
 * 2^31 counts; frames that are damaged, cut off, missing, repeated, late or from nowhere; inputs, tunables and outputs
 * that are no numbers, infinite or 1e30; commands that are none, twice the same, or rests; snapshots that are taken and
 * restored, damaged or cut off.
 *
 *     PROGRAM TICKS SEED
 *
 * What happens in a tick is a function of how many were made before, and of the seed. The port, the wire and the plant
 * below do it; the model adds up by itself, in numbers of port ticks. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/link/link.h"
#include "core/runtime/tick.h"
#include "port/channel.h"
#include "port/none/inputs.h"
#include "port/port.h"

enum { PERIOD = 268435459, LATE = PERIOD / 16 };

static uint64_t seed;

/* What a tick has of a kind, 64 random bits (Steele, Lea and Flood 2014: splitmix64). */
enum kind { DELAY, LOST, COST, STREAM, BURST, COMMAND, IDLE, INPUT, TUNABLE, OUTPUT, KINDS };
static uint64_t chance(const uint64_t tick, const enum kind of)
{
    uint64_t z = seed + UINT64_C(0x9E3779B97F4A7C15) * (tick * KINDS + (uint64_t)of + 1);
    z = (z ^ z >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ z >> 27) * UINT64_C(0x94D049BB133111EB);
    return z ^ z >> 31;
}

/* The bits of a tick that has a fault of that kind, one in `every`; else 0. */
static uint64_t fault(const uint64_t tick, const enum kind of, const uint64_t every)
{
    const uint64_t bits = chance(tick, of);
    return bits % every == 0 ? bits >> 12 | 1 : 0;
}

/* Nothing most of the time, else up to four periods, of which one in 64 is up to 2^36 counts. */
static uint64_t span(const uint64_t tick, const enum kind of)
{
    const uint64_t bits = fault(tick, of, 500);
    return bits == 0 ? 0 : (bits & 63) != 1 ? bits >> 22 : bits >> 16;
}

static bool is_lost(const uint64_t tick)
{
    return fault(tick, LOST, 500) != 0;
}

/* What comes from outside at a tick: mostly between -1 and 1. */
static real given(const uint64_t tick, const enum kind of)
{
    static const real bad[] = {(real)NAN, (real)INFINITY, (real)-INFINITY, R(1e30), R(-1e30), R(1.5), R(-0.0), R(-1.0)};
    const uint64_t bits = chance(tick, of);
    return bits % 300 == 0 ? bad[bits >> 12 & 7] : (real)((double)(bits >> 12) / 2251799813685248.0 - 1.0);
}

/* What the wire does to the inputs of a tick, and what is asked for. */
enum stream { WELL, NO_FRAME, WRONG_BYTE, CUT_OFF, GARBAGE, TWICE, OLD, FUTURE, BEHIND, STREAMS };
static enum stream stream_of(const uint64_t tick)
{
    const uint64_t bits = fault(tick, STREAM, 200);
    return bits == 0 ? WELL : (enum stream)(1 + (bits >> 4) % (STREAMS - 1));
}

enum command { NOTHING, NO_COMMAND, NO_LENGTH, NO_PIECE, TAKE, SPOIL, RESTORE, SHORT, PAUSE, ONE, AGAIN, COMMANDS };
static enum command command_of(const uint64_t tick)
{
    const uint64_t bits = fault(tick, COMMAND, 300);
    return bits == 0 ? NOTHING : (enum command)(1 + (bits >> 4) % (COMMANDS - 1));
}

/* --- The port ---------------------------------------------------------------------------------------------------- */

static uint64_t now, told, steps;

_Noreturn void iso_port_exit(const int status)
{
    exit(status);
}

uint32_t iso_port_start(const uint32_t period_ns)
{
    return period_ns;
}

uint64_t iso_port_wait(void)
{
    uint64_t next = told + 1;
    while (is_lost(next)) {
        next++;
    }
    const uint64_t at = next * PERIOD + span(next, DELAY);
    now = at > now ? at : now;
    told = now / PERIOD;
    return told;
}

uint64_t iso_port_clock(void)
{
    return now;
}

static real seen[2];

void iso_port_publish(const real *const y, const size_t outputs)
{
    memcpy(seen, y, outputs * sizeof *y);
}

void iso_port_safe(void)
{
    puts("# the guard");
    exit(EXIT_FAILURE);
}

void iso_port_write(const void *const bytes, const size_t count)
{
    (void)bytes;
    (void)count;
}

/* --- The plant --------------------------------------------------------------------------------------------------- */

static struct {
    real x[2], u[1], p[1], y[2], good[4];
} memory;

static const iso_limits limits[] = {{R(-0.5), R(0.75)}};

static void output(void *const of)
{
    (void)of;
    memory.y[0] = memory.x[0];
    memory.y[1] = given(steps, OUTPUT);
}

static iso_refused admit(void *const of)
{
    (void)of;
    return iso_admit(memory.u, memory.good, limits, 1, NULL) |
           (iso_refused)iso_admit(memory.p, memory.good + 1, NULL, 1, NULL) << 32;
}

static uint32_t finish(void *const of)
{
    return iso_finish(of, memory.x, NULL, 2, NULL, output, memory.y, memory.good + 2, 2);
}

static void step(void *const of)
{
    (void)of;
    memory.x[0] = R(0.5) * memory.x[0] + memory.u[0];
    memory.x[1] = R(0.25) * memory.x[1] - memory.x[0];
    now += span(steps, COST);
    steps++;
}

static const real start[2];
static const iso_model model = {
    .period_ns = PERIOD,
    .states = 2,
    .inputs = 1,
    .outputs = 2,
    .parameters = 1,
    .defaults = start,
    .start = start,
    .memory_bytes = sizeof memory,
    .output = output,
    .admit = admit,
    .step = step,
    .finish = finish,
};
static const iso_plant plant = {.model = &model,
                                .memory = &memory,
                                .x = memory.x,
                                .u = memory.u,
                                .p = memory.p,
                                .y = memory.y,
                                .good = memory.good};

static void begin_service(iso_loop *const loop)
{
    (void)loop;
}

/* Sets the tunable before each tick. */
static void set_tunable(iso_loop *const loop)
{
    (void)loop;
    memory.p[0] = given(steps, TUNABLE);
}

static const iso_service service = {begin_service, set_tunable, begin_service};
static const iso_service *const services[] = {&service};
enum { SAFE_AFTER = 5 };
#define SAFE R(0.125)
static const iso_wire wires[] = {{.input = 0, .safe = SAFE, .after = SAFE_AFTER}};
static real values[1];
static uint8_t received[ISO_LINK_BYTES(1, 2)], sent[sizeof received];
static unsigned char record[ISO_SNAPSHOT_BYTES(sizeof memory)];
static const iso_interface interface = {.identity = 77,
                                        .wires = wires,
                                        .services = services,
                                        .wire_count = 1,
                                        .service_count = 1,
                                        .values = values,
                                        .received = received,
                                        .sent = sent,
                                        .frame_bytes = sizeof received,
                                        .snapshot = record,
                                        .snapshot_bytes = sizeof record};
static iso_loop loop;
static iso_link the_link;

/* --- The wire: frames by a writer of its own -----------------------------------------------------------------------
 */

static uint8_t towards[2048], frame[256];
static size_t towards_count, towards_at, frame_count;
static uint8_t number;

static void put(const uint64_t value, const int bytes)
{
    for (int i = 0; i < bytes; i++) {
        frame[frame_count++] = (uint8_t)(value >> 8 * i);
    }
}

static uint16_t crc_of(const uint8_t *const bytes, const size_t count)
{
    uint32_t crc = 0xFFFF;
    for (size_t i = 0; i < count; i++) {
        crc ^= (uint32_t)bytes[i] << 8;
        for (int bit = 0; bit < 8; bit++) {
            crc = (crc & 0x8000) != 0 ? crc << 1 ^ 0x11021 : crc << 1;
        }
    }
    return (uint16_t)crc;
}

/* Sends the frame, whose bytes have no run of 254 without a zero, without the last `less` of its bytes. */
static void send(const size_t less)
{
    frame[frame_count] = 0;
    towards[towards_count++] = 0;
    for (size_t at = 0; at <= frame_count - less; at++) {
        const size_t begin = at;
        while (at < frame_count - less && frame[at] != 0) {
            at++;
        }
        towards[towards_count++] = (uint8_t)(at - begin + 1);
        memcpy(towards + towards_count, frame + begin, at - begin);
        towards_count += at - begin;
    }
    towards[towards_count++] = 0;
    frame_count = 0;
}

static void send_whole(void)
{
    put(crc_of(frame, frame_count), 2);
    send(0);
}

static void put_command(const int command)
{
    put('c', 1);
    put((uint64_t)command, 1);
    put(++number, 1);
}

static void send_command(const int command, const uint64_t argument, const int bytes)
{
    put_command(command);
    put(argument, bytes);
    send_whole();
}

enum { DO_RUN = 2, DO_REST, DO_TAKE = 5, DO_READ, DO_WRITE, DO_RESTORE };

static void send_what_is_asked(const enum command asked)
{
    switch (asked) {
    case NO_COMMAND:
        send_command(99, 0, 0);
        break;
    case NO_LENGTH:
        send_command(DO_RUN, 0, 7);
        break;
    case NO_PIECE:
        send_command(DO_READ, sizeof record, 4);
        break;
    case TAKE:
        send_command(DO_TAKE, 0, 0);
        break;
    case SPOIL: /* a piece of one byte, the exponent of the first state: it becomes 1e16 */
        put_command(DO_WRITE);
        put(sizeof(iso_snapshot_head) + 3, 4);
        put(0x5A, 1);
        send_whole();
        break;
    case RESTORE:
        send_command(DO_RESTORE, sizeof record, 4);
        send_command(DO_RUN, 0, 8);
        break;
    case SHORT:
        send_command(DO_RESTORE, sizeof record - 1, 4);
        break;
    case PAUSE:
        send_command(DO_REST, 0, 0);
        break;
    case ONE:
        send_command(DO_RUN, 1, 8);
        break;
    case AGAIN:
        send_command(DO_RUN, 1, 8);
        number--;
        send_command(DO_RUN, 1, 8);
        break;
    default:
        break;
    }
}

static void put_inputs(const uint64_t answers, const real value)
{
    put('u', 1);
    put(answers, 8);
    put(iso_bits_of(value), sizeof(real));
}

static void send_inputs(const enum stream how, const uint64_t tick, const real value)
{
    if (how == NO_FRAME) {
        return;
    }
    put_inputs(how == OLD ? tick - 3 : how == FUTURE ? tick + 1 : how == BEHIND ? tick - 1 : tick, value);
    if (how == WRONG_BYTE || how == CUT_OFF || how == GARBAGE) {
        put(crc_of(frame, frame_count), 2);
        frame[3] ^= how == WRONG_BYTE ? 0x10 : 0;
        frame_count = how == GARBAGE ? 2 : frame_count;
        send(how == CUT_OFF ? 1 : 0);
        return;
    }
    send_whole();
    if (how == TWICE) {
        put_inputs(tick, value);
        send_whole();
    }
}

/* Once for a tick: what is asked, then its inputs. Whether a record is restored the sender knows from the plant's
 * answers: it looks. A tick with a restore has no inputs. */
static void come_in(void)
{
    static uint64_t burst;
    const enum command asked = command_of(steps);
    burst = fault(steps, BURST, 3000) != 0 ? 1 + 2 * SAFE_AFTER : burst - (burst > 0);
    towards_count = towards_at = 0;
    send_what_is_asked(asked);
    if (burst == 0 && asked != RESTORE) {
        send_inputs(stream_of(steps), loop.tick, given(steps, INPUT));
    }
}

static uint64_t came_in = UINT64_MAX;

size_t iso_port_receive(const iso_channel channel, void *const bytes, const size_t count)
{
    if (came_in != steps && the_link.running) {
        came_in = steps;
        come_in();
    }
    const size_t left = towards_count - towards_at, taken = left < count ? left : count;
    memcpy(bytes, towards + towards_at, taken);
    towards_at += channel == ISO_CHANNEL_CONTROLLER ? taken : 0;
    return channel == ISO_CHANNEL_CONTROLLER ? taken : 0;
}

static uint64_t frames_sent;

bool iso_port_send(const iso_channel channel, const void *const bytes, const size_t count)
{
    frames_sent += channel == ISO_CHANNEL_CONTROLLER && count > 0 && ((const uint8_t *)bytes)[0] == 0;
    return true;
}

/* A plant that rests is looked at up to three times, half-periods apart; then it is told to run. */
void iso_port_idle(void)
{
    static uint64_t looks;
    const uint64_t bits = chance(steps, IDLE);
    now += bits % 5 * (PERIOD / 2);
    looks++;
    if (looks > (bits >> 8) % 3) {
        looks = towards_count = towards_at = 0;
        send_command(DO_RUN, 0, 8);
    }
}

#include "tests/core/runtime/account/faults_model.h"

/* --- The comparison ------------------------------------------------------------------------------------------------
 */

static int failed;

static void same(const char *const what, const uint64_t got, const int64_t want)
{
    printf("# %s %" PRId64 "\n", what, (int64_t)got);
    if (got != (uint64_t)want) {
        printf("# expected %" PRId64 "\n", want);
        failed = 1;
    }
}

int main(const int argc, char **const argv)
{
    if (argc != 3) {
        return EXIT_FAILURE;
    }
    const uint64_t ticks = strtoull(argv[1], NULL, 10);
    seed = strtoull(argv[2], NULL, 10);
    iso_loop_start(&loop, &plant);
    iso_link_open(&the_link, &interface, &loop, false);
    put('s', 1);
    put(interface.identity, 8);
    put(ISO_LINK_FREE, 1);
    put(0, 8);
    send_whole();
    iso_link_begin(&the_link);
    m.ticks = m.reported = (int64_t)told; /* a start rests for a tick */
    m.time = (int64_t)now;
    m.is.hash = UINT64_C(0xCBF29CE484222325);
    m.is.outputs[1] = memory.y[1];
    const uint64_t at_start = loop.statistics.outputs_held;
    uint64_t others = 0;
    for (uint64_t k = 0; k < ticks; k++) {
        model_tick(k);
        failed |= !iso_link_tick(&the_link);
        others += loop.tick != m.is.tick || memory.u[0] != m.is.input || memory.p[0] != m.is.tunable ||
                  memcmp(memory.x, m.is.x, sizeof memory.x) != 0 || memcmp(seen, m.is.outputs, sizeof seen) != 0;
    }
    const iso_statistics *const s = &loop.statistics;
    const iso_link_statistics *const l = &the_link.statistics;
    printf("# seed %" PRIu64 " faults %" PRId64 " moves %" PRId64 " rests %" PRId64 "\n", seed, m.faults, m.moves,
           m.rests);
    same("ticks", s->ticks, (int64_t)ticks);
    same("late", s->late, m.late);
    same("lost", s->lost, m.lost);
    same("overruns", s->overruns, m.overruns);
    same("margin", (uint64_t)s->margin, m.margin);
    same("execution_min", s->execution_min, m.shortest);
    same("execution_max", s->execution_max, m.longest);
    same("execution_sum", s->execution_sum, m.sum);
    same("inputs_held", s->inputs.held, m.inputs_held);
    same("inputs_clamped", s->inputs.clamped, m.inputs_clamped);
    same("tunables_held", s->parameters.held, m.tunables_held);
    same("tunables_clamped", s->parameters.clamped, 0);
    same("outputs_held", s->outputs_held - at_start, m.outputs_held);
    same("link_inputs", l->inputs, m.inputs);
    same("link_late", l->late, m.inputs_late);
    same("link_repeated", l->repeated, m.repeated);
    same("link_stale", l->stale, m.stale);
    same("link_missing", l->missing, m.missing);
    same("link_safe", l->safe, m.safe);
    same("link_damaged", l->damaged, m.damaged);
    same("link_refused", l->refused, m.refused);
    same("link_unsent", l->unsent, 0);
    same("commands", the_link.commands.done, m.done);
    same("commands_refused", the_link.commands.refused, m.not_done);
    same("tick", loop.tick, (int64_t)m.is.tick);
    same("hash", the_link.control.hash, (int64_t)m.is.hash);
    same("ticks with other values", others, 0);
    return failed;
}
