/* core/link/link.c over a port and a wire that are scripted, tick by tick, by random events with printed seeds: what
 * the plant gets, what it sends and what it counts must be what the script says, to the last number.
 *
 * The files under test are compiled into this one with the port's functions renamed, so that the same test runs beside
 * any port. */
#include "tests/core/link/link/wire.h"

#include "core/link/command.c"
#include "core/link/frame.c"
#include "core/link/link.c"
#include "core/runtime/control.c"
#include "core/runtime/loop.c"
#include "core/runtime/snapshot.c"

/* --- The plant: what a step gets is kept; the third input is a function of time without a wire
 * -------------------------- */

static struct {
    real x[STATES], u[WIRES], y[STATES], good[WIRES + STATES];
} held;
static const real start[STATES];
static real seen[TICKS_MOST][WIRES];
static uint32_t steps, fail_at;

static void output(void *const memory)
{
    (void)memory;
    held.y[0] = held.x[0];
    held.y[1] = R(2.0) * held.x[0];
}

static void drive(void *const memory, const uint64_t tick)
{
    (void)memory;
    held.u[2] = (real)tick;
}

static const iso_limits limits[WIRES] = {{R(-50.0), R(50.0)}, {R(-1000.0), R(1000.0)}, {R(-1000.0), R(1000.0)}};

static iso_refused admit(void *const memory)
{
    (void)memory;
    return iso_admit(held.u, held.good, limits, WIRES, NULL);
}

static uint32_t conclude(void *const memory)
{
    return iso_finish(memory, held.x, NULL, STATES, NULL, output, held.y, held.good + WIRES, STATES);
}

static void step(void *const memory)
{
    (void)memory;
    memcpy(seen[steps % TICKS_MOST], held.u, sizeof held.u);
    steps++;
    held.x[0] += R(1.0);
    held.x[1] = steps == fail_at ? iso_real_of(ISO_EXPONENT_BITS) : R(3.0) * held.u[0];
}

static const iso_model model = {.name = "recorder",
                                .period_ns = PERIOD,
                                .states = STATES,
                                .inputs = WIRES,
                                .outputs = STATES,
                                .start = start,
                                .memory_bytes = sizeof held,
                                .output = output,
                                .drive = drive,
                                .admit = admit,
                                .step = step,
                                .finish = conclude};
static const iso_plant plant = {
    .model = &model, .memory = &held, .x = held.x, .u = held.u, .y = held.y, .good = held.good};

static const iso_wire wires[WIRES] = {{0, R(9.0), 4}, {1, R(0.0), 0}, {2, R(-1.0), 2}};
static real values[WIRES];
static uint8_t received[ISO_LINK_BYTES(WIRES, STATES)], sent[sizeof received];
static const iso_interface interface = {.identity = plant_identity,
                                        .wires = wires,
                                        .wire_count = WIRES,
                                        .values = values,
                                        .received = received,
                                        .sent = sent,
                                        .frame_bytes = sizeof received};

static iso_loop loop;
static iso_link link;

static void nothing(void)
{
}

static void open_link(const bool once)
{
    memset(came, 0, sizeof came);
    towards_count = 0;
    steps = fail_at = 0;
    is_jammed = false;
    on_idle = nothing;
    iso_loop_start(&loop, &plant);
    iso_link_open(&link, &interface, &loop, once);
}

/* --- What the script says ---------------------------------------------------------------------------------------- */

typedef struct expectation {
    bool any;           /* inputs have been taken */
    uint64_t newest;    /* the tick that they answer */
    uint64_t taken;     /* when, plus one */
    real values[WIRES]; /* as they are on the wire; */
    real before[WIRES]; /* inputs of the last step */
    uint64_t held, clamped;
    iso_link_statistics counts;
} expectation;

static expectation due;

static real draw_value(void)
{
    const uint32_t kind = draw(20);
    return kind == 0   ? iso_real_of(ISO_EXPONENT_BITS | 1)
           : kind == 1 ? iso_real_of(ISO_EXPONENT_BITS)
           : kind == 2 ? R(1e30)
           : kind == 3 ? R(-70.0)
                       : (real)draw(90) - R(45.0);
}

/* Inputs that are taken, answering this tick. */
static void take_new(const uint64_t answers, const uint64_t tick)
{
    for (int i = 0; i < WIRES; i++) {
        due.values[i] = draw_value();
    }
    put_inputs(answers, due.values);
    due.counts.inputs++;
    due.counts.late += answers < tick;
    due.any = true;
    due.newest = answers;
    due.taken = tick + 1;
}

static void put_damaged(const uint64_t tick)
{
    const size_t at = towards_count;
    put_inputs(tick, due.values);
    towards[at + 3 + draw(4)] ^= 0x10; /* within the number of the tick: a burst, which a CRC always finds */
    due.counts.damaged++;
}

/* One event on the wire before the step from a tick. */
static void happen(const uint64_t tick, const bool is_free)
{
    switch (draw(8)) {
    case 0:
    case 1:
        if (!due.any || due.newest < tick) {
            take_new(tick, tick);
        }
        break;
    case 2:
        if (is_free && tick > 2 && (!due.any || due.newest + 2 < tick)) {
            take_new(tick - 1 - draw(2), tick);
        }
        break;
    case 3:
        if (due.any) {
            put_inputs(due.newest, due.before);
            due.counts.repeated++;
        }
        break;
    case 4:
        if (due.any && due.newest > 0) {
            put_inputs(due.newest - 1 - draw((uint32_t)due.newest), due.before);
            due.counts.stale++;
        }
        break;
    case 5:
        put_inputs(tick + 1 + draw(3), due.before);
        due.counts.stale++;
        break;
    case 6:
        put_damaged(tick);
        break;
    default:
        begin('?');
        iso_frame_put(&out, tick, 8);
        finish();
        due.counts.refused++;
    }
}

/* What a step from this tick must get: the latest values, put right; the safe ones of those that are too old. */
static bool got_what_is_due(const uint64_t tick, const bool is_free)
{
    const bool is_new = due.any && due.taken == tick + 1;
    const uint64_t age = tick + 1 - due.taken;
    bool is_safe = false, same = true;
    for (int i = 0; i < WIRES; i++) {
        const real sent_value = due.values[i], most = limits[i].most;
        const bool finite = iso_not_finite(sent_value) == 0;
        const real within = !finite              ? due.before[i]
                            : sent_value > most  ? most
                            : sent_value < -most ? -most
                                                 : sent_value;
        due.held += is_new && !finite;
        due.clamped += is_new && finite && within != sent_value;
        due.values[i] = is_new ? within : sent_value;
        real want = due.any ? due.values[i] : i == 2 ? (real)tick : R(0.0);
        if (is_free && wires[i].after > 0 && age >= wires[i].after) {
            want = wires[i].safe;
            is_safe = true;
        }
        same = same && iso_bits_of(seen[tick][i]) == iso_bits_of(want);
        due.before[i] = want;
    }
    due.counts.missing += !is_new;
    due.counts.safe += is_safe;
    return same;
}

static uint64_t word(const size_t at)
{
    return iso_frame_number(came[OF_END].payload + 8 * at, 8);
}

/* The words of an end frame. */
#define WORD_OF(word, member) WORD_##word,
#define WORD_OF_LINK(name) WORD_link_##name,
enum { ISO_STREAM_COUNTS(WORD_OF) ISO_STREAM_WORDS(WORD_OF) ISO_LINK_COUNTS(WORD_OF_LINK) WORDS };

/* The end frame has these counts, and as many ticks, none late or lost. */
static void check_end(const char *const name, const uint64_t ticks)
{
    const uint64_t *const counts = (const uint64_t *)&due.counts;
    uint32_t same = 0;
    for (size_t i = WORD_link_inputs; i < WORDS; i++) {
        same += word(i) == counts[i - WORD_link_inputs];
    }
    tap_note("run", seed);
    tap_count(same, WORDS - WORD_link_inputs, name);
    tap_ok(word(WORD_ticks) == ticks && word(WORD_tick) == ticks && word(WORD_guard) == STATES, "and its ticks");
    tap_ok(word(WORD_late) + word(WORD_lost) + word(WORD_overruns) == 0, "none late, none lost");
    tap_ok(word(WORD_inputs_held) == due.held && word(WORD_inputs_clamped) == due.clamped, "and what was no number");
}

static bool sent_outputs_of(const uint64_t tick)
{
    const uint8_t *const last = came[OF_OUTPUTS].payload;
    return iso_frame_number(last, 8) == tick && iso_frame_real(last + 8) == (real)tick &&
           iso_frame_real(last + 8 + sizeof(real)) == R(2.0) * (real)tick;
}

/* --- A free run -------------------------------------------------------------------------------------------------- */

static void test_free(const uint32_t from)
{
    enum { TICKS = 300 };
    uint32_t good_inputs = 0, good_outputs = 0;
    seed = from;
    tap_note("seed", seed);
    due = (expectation){0};
    open_link(false);
    put_start(plant_identity, ISO_LINK_FREE, TICKS);
    iso_link_begin(&link);
    tap_count(came[OF_OUTPUTS].count, 1, "free: the outputs of tick 0");
    for (uint64_t tick = 0; tick < TICKS; tick++) {
        const uint64_t refused = due.counts.refused;
        const uint32_t sent_before = came[OF_OUTPUTS].count;
        /* Quiet times are long enough for every safe value. */
        for (uint32_t events = tick % 40 < 25 ? draw(4) : 0; events > 0; events--) {
            happen(tick, true);
        }
        is_jammed = draw(10) == 0;
        due.counts.unsent += is_jammed ? 1 + due.counts.refused - refused : 0;
        (void)iso_link_tick(&link);
        good_inputs += got_what_is_due(tick, true);
        good_outputs += is_jammed ? came[OF_OUTPUTS].count == sent_before
                                  : came[OF_OUTPUTS].count == sent_before + 1 && sent_outputs_of(tick + 1);
    }
    is_jammed = false;
    tap_count(good_inputs, TICKS, "free: every step has the inputs that are due");
    tap_count(good_outputs, TICKS, "free: every tick sends its outputs");
    tap_ok(!iso_link_tick(&link), "free: then the run is over");
    iso_link_end(&link);
    check_end("free: all counts", TICKS);
    tap_ok(due.counts.late > 3 && due.counts.repeated > 10 && due.counts.stale > 10 && due.counts.safe > 50 &&
               due.held + due.clamped > 10,
           "free: there was something of all");
}

/* --- Lockstep ---------------------------------------------------------------------------------------------------- */

static uint32_t outputs_due; /* frames of outputs: one a tick, and one for each time that they were asked for again */

/* While the plant waits, ticks of the port pass, and something happens on the wire; at last the inputs come. */
static void wait_a_while(void)
{
    const uint64_t tick = loop.tick;
    now += draw(3) == 0 ? draw(3 * PERIOD) : 0;
    if (draw(3) == 0) {
        take_new(tick, tick);
    } else {
        const uint64_t repeated = due.counts.repeated;
        happen(tick, false);
        outputs_due += (uint32_t)(due.counts.repeated - repeated);
    }
}

static void test_lockstep(const uint32_t from)
{
    enum { TICKS = 200 };
    uint32_t good_inputs = 0, good_outputs = 0;
    seed = from;
    tap_note("seed", seed);
    due = (expectation){0};
    open_link(true);
    put_start(plant_identity, ISO_LINK_LOCKSTEP, TICKS);
    iso_link_begin(&link);
    outputs_due = 1;
    on_idle = wait_a_while;
    for (uint64_t tick = 0; tick < TICKS; tick++) {
        (void)iso_link_tick(&link);
        due.taken = tick + 1;
        outputs_due++;
        good_inputs += steps == tick + 1 && got_what_is_due(tick, false);
        good_outputs += came[OF_OUTPUTS].count == outputs_due && sent_outputs_of(tick + 1);
    }
    tap_count(good_inputs, TICKS, "lockstep: every step has the inputs that answer its tick");
    tap_count(good_outputs, TICKS, "lockstep: the outputs are sent, and again where they were lost");
    tap_ok(!iso_link_tick(&link), "lockstep: then the run is over");
    iso_link_end(&link);
    check_end("lockstep: all counts", TICKS);
    tap_ok(loop.rested > 20 && outputs_due > TICKS + 10, "lockstep: ticks passed, and outputs were lost");
}

/* --- What else is said ------------------------------------------------------------------------------------------- */

static bool is_refused(const iso_link_reason reason, const char type)
{
    const arrival *const a = &came[OF_REFUSAL];
    return a->length == 2 && a->payload[0] == reason && a->payload[1] == (uint8_t)type;
}

static void start_after_all(void)
{
    put_start(plant_identity, ISO_LINK_LOCKSTEP, 0);
}

static void test_before(void)
{
    const real none[WIRES] = {R(0.0)};
    open_link(false);
    begin(ISO_LINK_HELLO);
    finish();
    on_idle = start_after_all;
    receive(&link);
    const uint8_t *const said = came[OF_PLANT].payload;
    tap_ok(came[OF_PLANT].length == 22 && said[0] == ISO_LINK_VERSION && said[1] == sizeof(real),
           "hello: version and type of numbers");
    tap_ok(iso_frame_number(said + 2, 2) == WIRES && iso_frame_number(said + 4, 2) == STATES &&
               iso_frame_number(said + 6, 2) == STATES && iso_frame_number(said + 8, 2) == 0,
           "hello: inputs, outputs, states, tunables");
    tap_bits(iso_frame_number(said + 10, 8), plant_identity, "hello: identity");
    tap_count((uint32_t)iso_frame_number(said + 18, 4), PERIOD, "hello: period");

    put_start(plant_identity + 1, ISO_LINK_LOCKSTEP, 0);
    receive(&link);
    tap_ok(is_refused(ISO_LINK_FOREIGN, 's') && !link.is_starting, "refused: a start for another plant");
    put_start(plant_identity, ISO_LINK_MODES, 0);
    receive(&link);
    tap_ok(is_refused(ISO_LINK_NO_MODE, 's') && !link.is_starting, "refused: a start in no mode");
    put_inputs(0, none);
    receive(&link);
    tap_ok(is_refused(ISO_LINK_NOT_STARTED, 'u'), "refused: inputs without a run");
    begin(ISO_LINK_INPUTS);
    iso_frame_put(&out, 0, 8);
    finish();
    receive(&link);
    tap_ok(is_refused(ISO_LINK_UNKNOWN, 'u'), "refused: inputs that are too short");
    begin(ISO_LINK_START);
    finish();
    receive(&link);
    tap_ok(is_refused(ISO_LINK_UNKNOWN, 's'), "refused: a start that is too short");
    tap_count(came[OF_REFUSAL].count, 5, "refused: each once");
    tap_count(came[OF_OUTPUTS].count + steps, 0, "before a start nothing runs");
    iso_link_begin(&link);
    tap_ok(link.running && came[OF_OUTPUTS].count == 1, "after all that, a start is followed");
}

static void answer(void)
{
    const real none[WIRES] = {R(0.0)};
    put_inputs(loop.tick, none);
}

static void test_again(void)
{
    open_link(false);
    put_start(plant_identity, ISO_LINK_LOCKSTEP, 0);
    iso_link_begin(&link);
    put_start(plant_identity, ISO_LINK_LOCKSTEP, 0);
    receive(&link);
    tap_ok(came[OF_OUTPUTS].count == 2 && !link.is_starting, "again: the same start is answered with tick 0");
    on_idle = answer;
    (void)iso_link_tick(&link);
    (void)iso_link_tick(&link);
    const uint64_t hash = link.control.hash;
    put_start(plant_identity, ISO_LINK_LOCKSTEP, 0);
    tap_ok(!iso_link_tick(&link), "again: a start ends the run");
    iso_link_end(&link);
    iso_link_begin(&link);
    tap_ok(loop.tick == 0 && held.x[0] == R(0.0) && sent_outputs_of(0), "again: the plant is at its start");
    (void)iso_link_tick(&link);
    (void)iso_link_tick(&link);
    tap_bits(link.control.hash, hash, "again: the same run");
    tap_ok(loop.statistics.ticks == 2 && loop.statistics.lost + loop.statistics.late == 0, "again: its own account");
    begin(ISO_LINK_END);
    finish();
    tap_ok(!iso_link_tick(&link), "an end from the controller ends it");
    iso_link_end(&link);
    const uint32_t ends = came[OF_END].count;
    answer();
    receive(&link);
    tap_count(came[OF_END].count, ends + 1, "inputs after the end are answered with it");

    open_link(true);
    put_start(plant_identity, ISO_LINK_LOCKSTEP, 0);
    iso_link_begin(&link);
    on_idle = answer;
    (void)iso_link_tick(&link);
    put_start(plant_identity, ISO_LINK_LOCKSTEP, 0);
    tap_ok(iso_link_tick(&link) && is_refused(ISO_LINK_ALREADY_STARTED, 's'), "a program of one run refuses another");
}

static void test_guard(void)
{
    open_link(false);
    made_safe = 0;
    put_start(plant_identity, ISO_LINK_FREE, 0);
    iso_link_begin(&link);
    fail_at = 3;
    tap_ok(iso_link_tick(&link) && iso_link_tick(&link) && !iso_link_tick(&link), "guard: the third tick is bad");
    iso_link_end(&link);
    tap_ok(word(WORD_guard) == 1 && made_safe == 1 && sent_outputs_of(2), "guard: named, outputs held, port safe");
    fail_at = 0;
    put_start(plant_identity, ISO_LINK_FREE, 0);
    iso_link_begin(&link);
    tap_ok(iso_link_tick(&link) && loop.guard == STATES, "guard: another start runs");
}

int main(void)
{
    for (uint32_t i = 1; i <= 3; i++) {
        test_free(977 * i);
        test_lockstep(1013 * i);
    }
    test_before();
    test_again();
    test_guard();
    tap_done();
}
