/* core/xcp without a channel: each command by its bytes, as the standard has them; what must be refused; samples;
 * frames on a damaged line. */
#include "tests/core/xcp/xcp/ask.h"
#include "tests/core/xcp/xcp/stimulate.h"
#include "tests/core/xcp/xcp/wire.h"

static void test_connection(void)
{
    start(&open_plant);
    ask("FD", NULL);
    tap_count(got_length, 0, "without CONNECT there is no answer");
    ask("FF 01", NULL);
    tap_count(got_length, 0, "CONNECT in a mode of its own: no answer");
    tap_ok(says("FF 00", NULL, "FF 05 C0 40 00 01 01 01"), "CONNECT");
    tap_ok(says("FD", NULL, "FF 00 00 00 00 00"), "GET_STATUS");
    tap_ok(says("FB", NULL, "FF 00 01 00 FF 00 00 10"), "GET_COMM_MODE_INFO");
    tap_ok(says("FC", NULL, "FE 00"), "SYNCH");
    tap_ok(says("C8", NULL, "FE 20"), "a command that there is not");
    tap_ok(says("F6 00", NULL, "FE 21"), "a command that is too short");
    tap_ok(says("FA 01", NULL, "FF 00 00 00 04 00 00 00") && says("F5 04", NULL, "FF 63 61 72 74"),
           "GET_ID: the name of the A2L");
    tap_ok(says("FA 05", NULL, "FF 00 00 00 05 00 00 00") && says("F5 05", NULL, "FF 65 70 6B 20 31"),
           "GET_ID: the EPK");
    tap_ok(says("FA 04", NULL, "FF 00 00 00 00 00 00 00"), "GET_ID: what there is not");
    tap_ok(says("FE", NULL, "FF") && !slave.connected, "DISCONNECT");
}

static void test_upload(void)
{
    start(&open_plant);
    ask("FF 00", NULL);
    uint8_t command[8] = {ISO_XCP_SHORT_UPLOAD, sizeof(real)};
    iso_xcp_put_long(command + 4, iso_xcp_address(&world.memory.x[1]));
    ask_bytes(command, sizeof command);
    tap_ok(got_length == 1 + sizeof(real) && memcmp(got + 1, &world.memory.x[1], sizeof(real)) == 0, "SHORT_UPLOAD");
    const uint8_t next[2] = {ISO_XCP_UPLOAD, sizeof(real)};
    ask_bytes(next, sizeof next);
    tap_ok(got_length == 1 + sizeof(real) && memcmp(got + 1, &world.memory.x[2], sizeof(real)) == 0,
           "UPLOAD goes on behind it");

    const uint8_t all[2] = {ISO_XCP_UPLOAD, sizeof(shown)};
    uint8_t block[sizeof(shown)];
    unsigned used = 0, packets = 0;
    tap_ok(says("F6 00 00 00 *", &world.memory, "FF"), "SET_MTA");
    ask_bytes(all, sizeof all);
    do {
        memcpy(block + used, got + 1, got_length - 1U);
        used += got_length - 1U;
        packets++;
        got_length = iso_xcp_continue(&slave, got);
    } while (got_length > 0 && used + got_length - 1U <= sizeof block);
    tap_ok(used == sizeof block && memcmp(block, &world.memory, sizeof block) == 0, "UPLOAD of a block");
    tap_count(packets, (sizeof block + ISO_XCP_MAX_CTO - 2) / (ISO_XCP_MAX_CTO - 1), "in as few packets as can be");

    tap_ok(says("F4 01 00 00 *", world.before, "FE 24"), "memory that is not the plant's");
    tap_ok(says("F4 02 00 00 *", (uint8_t *)(&world.memory + 1) - 1, "FE 24"), "the first byte behind it");
    tap_ok(says("F4 01 00 01 *", &world.memory, "FE 22"), "an address extension");
    tap_ok(says("F4 00 00 00 *", &world.memory, "FE 22"), "no byte");
    tap_ok(says("F4 40 00 00 *", &world.memory, "FE 22"), "more than a packet holds");

    for (unsigned i = 0; i < 9; i++) { /* the check value of the catalogue, in memory of the plant */
        ((uint8_t *)world.memory.x)[i] = (uint8_t)('1' + i);
    }
    tap_ok(says("F6 00 00 00 *", &world.memory, "FF") &&
               says("F3 00 00 00 09 00 00 00", NULL, "FF 08 00 00 B1 29 00 00"),
           "BUILD_CHECKSUM: the CRC of 123456789");
    tap_ok(says("F3 00 00 00 01 04 00 00", NULL, "FE 22 00 00 00 04 00 00"),
           "BUILD_CHECKSUM of too much says how much");
}

/* All tunables are what they were at the start. */
static bool are_untouched(void)
{
    bool good = true;
    for (unsigned i = 0; i < TUNABLES; i++) {
        good = good && iso_bits_of(world.memory.p[i]) == iso_bits_of(R(0.5));
    }
    return good;
}

static void test_download(void)
{
    real *const p = world.memory.p;
    start(&open_plant);
    ask("FF 00", NULL);
    write_reals(&p[1], (const real[]){R(-0.75)}, 1);
    tap_ok(is_answer("FF") && iso_bits_of(p[1]) == iso_bits_of(R(-0.75)), "SHORT_DOWNLOAD of a tunable");
    p[1] = R(0.5);

    write_reals(p, (const real[]){R(1.5)}, 1);
    tap_ok(is_answer("FE 22") && are_untouched(), "a number above its limits is refused");
    write_reals(p, (const real[]){R(-1e-3)}, 1);
    tap_ok(is_answer("FE 22") && are_untouched(), "a number below them");
    write_reals(p, (const real[]){R(0.0), R(-1.0)}, 2);
    tap_ok(is_answer("FF") && iso_bits_of(p[1]) == iso_bits_of(R(-1.0)), "the limits themselves are taken");
    p[0] = p[1] = R(0.5);
    write_reals(p, (const real[]){R(0.25), R(2.0)}, 2);
    tap_ok(is_answer("FE 22") && are_untouched(), "with one of several beyond its limits, none is set");
    const real infinity = iso_real_of(ISO_EXPONENT_BITS), nan = iso_real_of(ISO_EXPONENT_BITS | 1);
    write_reals(&p[2], &infinity, 1);
    tap_ok(is_answer("FE 22") && are_untouched(), "an infinity where there are no limits");
    write_reals(&p[2], &nan, 1);
    tap_ok(is_answer("FE 22") && are_untouched(), "what is no number");
    write_reals(world.memory.x, (const real[]){R(0.25)}, 1);
    tap_ok(is_answer("FE 23"), "a state can be read, and not written");
    write_reals(&world.memory.p[TUNABLES - 1], (const real[]){R(0.25), R(0.25)}, 2);
    tap_ok(is_answer("FE 23") && are_untouched(), "a tunable and an output");
    write_reals(world.after, (const real[]){R(0.25)}, 1);
    tap_ok(is_answer("FE 24"), "memory that is not the plant's");
}

/* DOWNLOAD of all tunables and some more, in blocks. */
static void test_blocks(void)
{
    enum { PART = ISO_XCP_MAX_CTO - 2 };
    static real many[40];
    iso_xcp_access access = {
        .readable = {{many, sizeof many}}, .tunables = many, .tunable_count = sizeof many / sizeof many[0]};
    iso_xcp_start(&slave, &open_plant, &access);
    ask("FF 00", NULL);
    uint8_t values[ISO_XCP_BLOCK_BYTES / sizeof(real) * sizeof(real)] = {0};
    for (unsigned i = 0; i < sizeof values / sizeof(real); i++) {
        put_real(values + i * sizeof(real), (real)i + R(0.5));
    }
    /* Case 0: as it should be. 1: with a NaN at its end. 2: one packet is missing. 3: another command within. */
    for (unsigned broken = 0; broken < 4; broken++) {
        unsigned left = sizeof many < sizeof values ? sizeof many : sizeof values;
        const unsigned all = left;
        bool early = false;
        memset(many, 0, sizeof many);
        put_real(values + all - sizeof(real), broken == 1 ? iso_real_of(ISO_EXPONENT_BITS | 1) : R(3.0));
        ask("F6 00 00 00 *", many);
        for (unsigned k = 0; left > 0; k++) {
            const unsigned count = left < PART ? left : PART;
            uint8_t command[ISO_XCP_MAX_CTO] = {k == 0 ? ISO_XCP_DOWNLOAD : ISO_XCP_DOWNLOAD_NEXT, (uint8_t)left};
            memcpy(command + 2, values + all - left, count);
            if (!(broken == 2 && k == 1)) {
                ask_bytes(command, (uint16_t)(2 + count));
            }
            if (broken == 3 && k == 0) {
                ask("FD", NULL);
                got_length = 0;
            }
            left -= count;
            early = early || (left > 0 && broken < 2 && got_length > 0);
        }
        const real zero = R(0.0);
        const bool set = memcmp(many, values, all) == 0, none = iso_bits_of(many[0]) == iso_bits_of(zero);
        if (broken == 0) {
            tap_ok(is_answer("FF") && set && !early, "a block is set, with one answer");
        } else if (broken == 1) {
            tap_ok(is_answer("FE 22") && none && !early, "of a block with one bad number nothing is set");
        } else {
            tap_ok(got[0] == ISO_XCP_ERR && got[1] == ISO_XCP_SEQUENCE && got_length == 3 && none,
                   broken == 2 ? "a block without its middle is refused" : "a block ends with another command");
        }
    }
}

static void test_lock(void)
{
    start(&locked_plant);
    tap_ok(says("FF 00", NULL, "FF 05 C0 40 00 01 01 01") && says("FD", NULL, "FF 00 0D 00 00 00"), "locked");
    write_reals(world.memory.p, (const real[]){R(0.25)}, 1);
    tap_ok(is_answer("FE 25") && are_untouched(), "no download without the key");
    tap_ok(says("D6", NULL, "FE 25"), "no measurement without the key");
    tap_ok(says("F7 04 00 00 00 00", NULL, "FE 29"), "UNLOCK without a seed");
    tap_ok(says("F8 01 01", NULL, "FE 29") && says("F8 00 10", NULL, "FE 22"), "seeds that there are not");
    slave.tick = 12;
    ask("F8 00 01", NULL);
    const bool has_seed = got[0] == ISO_XCP_RES && got_length == 6 && got[1] == 4;
    uint8_t key[6] = {ISO_XCP_UNLOCK, 4};
    for (unsigned i = 0; i < 4; i++) {
        key[2 + i] = got[2 + i] ^ 0x5A;
    }
    ask_bytes(key, sizeof key);
    tap_ok(has_seed && is_answer("FF 0C"), "the key opens its resource, and no other");
    write_reals(world.memory.p, (const real[]){R(0.25)}, 1);
    tap_ok(is_answer("FF") && says("D6", NULL, "FE 25"), "and then a download works");
    ask("F8 00 04", NULL);
    tap_ok(says("F7 04 00 00 00 00", NULL, "FE 25") && !slave.connected, "a wrong key ends the connection");
    ask("FF 00", NULL);
    tap_ok(says("FD", NULL, "FF 00 0D 00 00 00"), "and all is locked again");
    start(&open_plant);
    ask("FF 00", NULL);
    tap_ok(says("F8 00 01", NULL, "FF 00"), "an open slave has an empty seed");
}

/* A list of three reals in two tables, every second tick. */
static bool make_list(void)
{
    uint8_t command[8] = {ISO_XCP_WRITE_DAQ, 0xFF, sizeof(real), 0};
    bool good = says("D6", NULL, "FF") && says("D5 00 02 00", NULL, "FF") && says("D4 00 00 00 01", NULL, "FF") &&
                says("D4 00 01 00 02", NULL, "FF") && says("D3 00 01 00 00 02", NULL, "FF") &&
                says("D3 00 01 00 01 01", NULL, "FF") && says("E2 00 01 00 00 00", NULL, "FF");
    for (unsigned i = 0; i < 3; i++) {
        if (i == 2) {
            good = good && says("E2 00 01 00 01 00", NULL, "FF");
        }
        iso_xcp_put_long(command + 4, iso_xcp_address(&world.memory.x[i]));
        ask_bytes(command, sizeof command);
        good = good && is_answer("FF");
    }
    return good && says("E0 10 01 00 00 00 02 00", NULL, "FF");
}

/* The same by two commands that write two entries, and one. */
static void test_multiple(void)
{
    uint8_t command[18] = {ISO_XCP_WRITE_DAQ_MULTIPLE, 2, 0xFF, sizeof(real), [10] = 0xFF, sizeof(real)};
    start(&open_plant);
    ask("FF 00", NULL);
    iso_xcp_put_long(command + 4, iso_xcp_address(&world.memory.x[0]));
    iso_xcp_put_long(command + 12, iso_xcp_address(&world.memory.x[2]));
    ask_bytes(command, sizeof command);
    tap_ok(is_answer("FE 29"), "WRITE_DAQ_MULTIPLE without a pointer");
    tap_ok(make_list() && says("E2 00 01 00 01 00", NULL, "FF"), "a list is made");
    ask_bytes(command, sizeof command);
    tap_ok(is_answer("FE 29") && slave.daq.entries[1].at == (const uint8_t *)&world.memory.x[1],
           "two entries where there is room for one: none is written");
    tap_ok(says("E2 00 01 00 00 00", NULL, "FF"), "at two");
    command[11] = 0;
    ask_bytes(command, sizeof command);
    command[11] = sizeof(real);
    tap_ok(is_answer("FE 22") && slave.daq.entries_left == 2, "the second of them without bytes: none is written");
    ask_bytes(command, sizeof command - 2);
    tap_ok(is_answer("FE 21") && says("C7 00", NULL, "FE 22"), "too short, and none");
    ask_bytes(command, sizeof command);
    tap_ok(is_answer("FF") && slave.daq.entries[1].at == (const uint8_t *)&world.memory.x[2] &&
               slave.daq.entries_left == 0,
           "two entries at once");
    iso_xcp_put_long(command + 12, iso_xcp_address(world.after));
    tap_ok(says("E2 00 01 00 00 00", NULL, "FF"), "at them again");
    ask_bytes(command, sizeof command);
    tap_ok(is_answer("FE 24") && slave.daq.entries_left == 2, "the second is not the plant's: none is written");
    tap_ok(says("DE 01 01 00", NULL, "FF 01") && says("E2 00 01 00 00 00", NULL, "FF"), "it runs");
    iso_xcp_put_long(command + 12, iso_xcp_address(&world.memory.x[2]));
    ask_bytes(command, sizeof command);
    tap_ok(is_answer("FE 11"), "none while it runs");
    tap_ok(says("C0 00", NULL, "FF 00 01 04 01 00") && says("C0 01", NULL, "FE 20"), "GET_VERSION");
}

static void test_daq(void)
{
    start(&open_plant);
    ask("FF 00", NULL);
    tap_ok(says("D5 00 01 00", NULL, "FE 29"), "lists before FREE_DAQ: out of order");
    tap_ok(says("D6", NULL, "FF") && says("D4 00 00 00 01", NULL, "FE 29"), "tables before lists");
    tap_ok(says("D5 00 05 00", NULL, "FE 30"), "more lists than there is room for");
    tap_ok(says("D5 00 01 00", NULL, "FF") && says("D4 00 01 00 01", NULL, "FE 22"),
           "a table of a list that there is not");
    tap_ok(says("D4 00 00 00 11", NULL, "FE 30"), "more tables than there is room for");
    tap_ok(says("D4 00 00 00 01", NULL, "FF") && says("D3 00 00 00 00 41", NULL, "FE 30"), "likewise entries");
    tap_ok(says("D3 00 00 00 00 01", NULL, "FF") && says("D3 00 00 00 00 01", NULL, "FE 29"), "entries twice");
    tap_ok(says("DE 01 00 00", NULL, "FE 2A"), "a list that is not written does not start");
    tap_ok(says("E1 FF 04 00 *", world.memory.x, "FE 29"), "WRITE_DAQ without a pointer");
    tap_ok(says("E2 00 00 00 00 00", NULL, "FF") && says("E1 FF 04 00 *", world.after, "FE 24"),
           "an entry that is not the plant's");

    tap_ok(make_list(), "a list is made");
    tap_ok(says("DA", NULL, "FF 53 02 00 01 00 00 00"), "GET_DAQ_PROCESSOR_INFO");
    tap_ok(says("D9", NULL, sizeof(real) == 4 ? "FF 01 FF 04 00 24 10 27" : "FF 01 FF 08 00 24 10 27"),
           "GET_DAQ_RESOLUTION_INFO: 10000 times 100 ns");
    tap_ok(says("D7 00 00 00", NULL, "FF 84 04 04 01 06 00") && says("F5 04", NULL, "FF 74 69 63 6B"),
           "GET_DAQ_EVENT_INFO: 1 ms, tick");
    tap_ok(says("D7 00 01 00", NULL, "FE 22"), "there is one event");
    tap_ok(says("DF 00 01 00", NULL, "FF 10 00 00 00 00 02 00"), "GET_DAQ_LIST_MODE");
    tap_ok(says("E0 12 01 00 00 00 01 00", NULL, "FE 27"), "no time stamps of stimulation");
    tap_ok(says("DE 02 01 00", NULL, "FF 01") && !iso_xcp_daq_due(&slave.daq, 1), "a selected list does not run");
    tap_ok(says("DD 01", NULL, "FF") && says("FD", NULL, "FF 40 00 00 00 00"), "all that are selected start");
    tap_ok(says("D4 00 00 00 01", NULL, "FE 11") && says("E0 10 01 00 00 00 01 00", NULL, "FE 11"),
           "while one runs nothing is allocated, and its mode is not set");
    const bool first = iso_xcp_daq_due(&slave.daq, 1), second = iso_xcp_daq_due(&slave.daq, 1);
    tap_ok(!first && second && !iso_xcp_daq_due(&slave.daq, 0), "every second event is a sample");

    uint8_t packet[ISO_XCP_MAX_DTO];
    const uint16_t length = iso_xcp_daq_packet(&slave.daq, 1, 0, 0x01020304, packet);
    tap_ok(length == 5 + 2 * sizeof(real) && packet[0] == 1 && iso_xcp_long(packet + 1) == 0x01020304 &&
               memcmp(packet + 5, world.memory.x, 2 * sizeof(real)) == 0,
           "the first packet: its number, the tick, the data");
    const uint16_t rest = iso_xcp_daq_packet(&slave.daq, 1, 1, 0x01020304, packet);
    tap_ok(rest == 1 + sizeof(real) && packet[0] == 2 && memcmp(packet + 1, &world.memory.x[2], sizeof(real)) == 0,
           "the second packet: its number, the data");
    slave.daq.lists[1].overloaded = true;
    (void)iso_xcp_daq_packet(&slave.daq, 1, 0, 0, packet);
    tap_ok(packet[0] == 0x81, "behind a loss the number says so");
    tap_ok(says("E3 00 01 00", NULL, "FF") && says("FD", NULL, "FF 00 00 00 00 00") &&
               says("DE 01 01 00", NULL, "FE 2A"),
           "CLEAR_DAQ_LIST stops and empties it");
    tap_ok(make_list() && says("DE 01 01 00", NULL, "FF 01") && says("DD 00", NULL, "FF") &&
               says("FD", NULL, "FF 00 00 00 00 00"),
           "START_STOP_SYNCH stops all");
    slave.tick = UINT64_C(0x100000007);
    tap_ok(says("DC", NULL, "FF 00 00 00 07 00 00 00"), "GET_DAQ_CLOCK: the tick");
}

static uint32_t random_state;

static uint32_t random_below(const uint32_t n)
{
    random_state = random_state * UINT32_C(1664525) + UINT32_C(1013904223);
    return (uint32_t)((uint64_t)random_state * n >> 32);
}

/* Packets of random lengths, numbered, on a line that damages every so many bytes. Those that begin farther behind the
 * damage than a frame is long must come; in their order; and no other. The sum of words misses a change once in 65536
 * times. */
static void test_line(const bool is_serial, const uint32_t seed)
{
    enum { PACKETS = 400, ROOM = 64 * ISO_XCP_FRAME_BYTES, BETWEEN = 700 };
    iso_xcp_reader reader = {.is_serial = is_serial};
    unsigned sent = 0, came = 0, due = 0, wrong = 0, missed = 0;
    unsigned clean = ISO_XCP_FRAME_BYTES + 1, next = BETWEEN;
    uint16_t newest = 0;
    random_state = seed;
    while (sent < PACKETS) {
        uint8_t frame[ISO_XCP_FRAME_BYTES] = {0};
        const uint16_t length = (uint16_t)(3 + random_below(ISO_XCP_MAX_CTO - 2));
        sent++;
        for (unsigned i = 2; i < length; i++) {
            frame[ISO_XCP_HEADER_BYTES + i] = (uint8_t)random_below(256);
        }
        iso_xcp_put_word(frame + ISO_XCP_HEADER_BYTES, (uint16_t)sent);
        const uint16_t count = iso_xcp_frame(frame, length, (uint16_t)sent, is_serial);
        const bool is_due = clean > ISO_XCP_FRAME_BYTES;
        bool damaged = false, has_come = false;
        for (unsigned i = 0; i < count; i++) {
            uint8_t byte = frame[i];
            unsigned copies = 1;
            if (is_serial && --next == 0) {
                const uint32_t kind = random_below(3);
                copies = kind == 0 ? 0 : kind == 1 ? 2 : 1;
                byte ^= (uint8_t)(kind == 2 ? 1 + random_below(255) : 0);
                next = BETWEEN + random_below(BETWEEN);
                damaged = true;
                clean = 0;
            }
            for (; copies > 0; copies--) {
                reader.bytes[reader.used++] = byte;
                for (uint16_t n = iso_xcp_read(&reader); n > 0; n = iso_xcp_read(&reader)) {
                    const uint16_t which = iso_xcp_word(reader.bytes + ISO_XCP_HEADER_BYTES);
                    wrong += which <= newest || which > sent;
                    newest = which;
                    has_come = has_come || which == sent;
                    came++;
                }
            }
            clean++;
        }
        due += is_due && !damaged;
        missed += is_due && !damaged && !has_come;
    }
    tap_note("seed", seed);
    tap_note("packets that came", came);
    tap_note("bytes of no frame", reader.skipped);
    tap_count(wrong, 0, is_serial ? "serial: only what was sent comes, in its order" : "socket: likewise");
    tap_count(missed, 0, is_serial ? "serial: what is a frame's length behind the damage comes" : "socket: all comes");
    tap_ok(due > PACKETS / 2 && (is_serial ? reader.skipped > 0 : came == PACKETS), "of many");
}

/* A LEN that claims the largest frame: what follows is found in the bytes that it took. */
static void test_resynchronisation(void)
{
    iso_xcp_reader reader = {.is_serial = true};
    uint8_t frame[ISO_XCP_FRAME_BYTES] = {[ISO_XCP_HEADER_BYTES] = ISO_XCP_SYNCH};
    const uint16_t count = iso_xcp_frame(frame, 1, 0, true);
    static const uint8_t claim[] = {ISO_XCP_MAX_CTO, 0};
    unsigned taken = 0, came = 0;
    tap_count(count, 8, "a frame of one byte");
    memcpy(reader.bytes, claim, sizeof claim);
    reader.used = sizeof claim;
    for (unsigned k = 0; came == 0 && k < 20; k++) {
        for (unsigned i = 0; i < count; i++) {
            reader.bytes[reader.used++] = frame[i];
            taken += came == 0;
            for (uint16_t n = iso_xcp_read(&reader); n > 0; n = iso_xcp_read(&reader)) {
                came += n == 1 && reader.bytes[ISO_XCP_HEADER_BYTES] == ISO_XCP_SYNCH;
            }
        }
    }
    tap_ok(came > 1 && taken <= ISO_XCP_FRAME_BYTES, "a wrong LEN costs no more than a frame");
}

/* --- The service ------------------------------------------------------------------------------------------------- */

iso_link iso_the_link;

/* Snapshots are the link's: none is asked for here. */
iso_control_answer iso_control_take(iso_control *const of)
{
    (void)of;
    return ISO_CONTROL_NO_RUN;
}

iso_control_answer iso_link_restore(iso_link *const link, const size_t bytes)
{
    (void)link, (void)bytes;
    return ISO_CONTROL_NO_RUN;
}
const iso_xcp_description iso_xcp_the_description = {"cart", "epk 1", limits, NULL, {2, 10000}, {6, 1}};

static const iso_model model = {.memory_bytes = sizeof(shown), .parameters = TUNABLES};
static const iso_plant plant = {.model = &model, .memory = &world.memory, .p = world.memory.p};
static iso_loop loop = {.plant = &plant};

/* A tick with all that the service does. */
static void tick(void)
{
    iso_xcp_service.before(&loop);
    loop.tick++;
    iso_xcp_service.after(&loop);
}

static void send_command(const char *const command, const void *const address)
{
    uint8_t *const frame = wire.in + wire.in_count;
    const uint16_t length = bytes_of(command, address, frame + ISO_XCP_HEADER_BYTES);
    wire.in_count += iso_xcp_frame(frame, length, 0, wire.opened == 0);
}

/* Commands, each with a tick. All are answered with what begins with FF. */
static bool all_are_done(const char *const *const commands, const unsigned count)
{
    bool good = true;
    for (unsigned i = 0; i < count; i++) {
        wire.in_count = wire.taken = wire.out_count = 0;
        send_command(commands[i], &world.memory);
        tick();
        good = good && wire.out_count > 0 && wire.out[ISO_XCP_HEADER_BYTES] == ISO_XCP_RES;
    }
    return good;
}

static void test_service(void)
{
    static const char *const list[] = {"FF 00",
                                       "D6",
                                       "D5 00 01 00",
                                       "D4 00 00 00 02",
                                       "D3 00 00 00 00 01",
                                       "D3 00 00 00 01 01",
                                       "E2 00 00 00 00 00",
                                       "E1 FF 04 00 *",
                                       "E2 00 00 00 01 00",
                                       "E1 FF 04 00 *",
                                       "E0 00 00 00 00 00 01 00",
                                       "DE 01 00 00"};
    enum { COMMANDS = sizeof list / sizeof list[0], SAMPLE = 2 * (4 + 1 + 4 + 1 + 2) };
    start(&open_plant);
    wire.room = 1000;
    iso_xcp_service.start(&loop);

    send_command("FF 00", NULL);
    const size_t whole = wire.in_count;
    for (wire.in_count = 1; wire.in_count < whole; wire.in_count++) {
        tick();
    }
    tap_count((uint32_t)wire.out_count, 0, "a frame that is not whole is not answered");
    tick();
    tap_ok(wire.out_count == 14 && wire.out[0] == 8 && wire.out[4] == ISO_XCP_RES, "one that is whole is, in its tick");

    send_command("FD", NULL);
    send_command("FB", NULL);
    wire.room = 0;
    wire.out_count = 0;
    tick();
    tick();
    const size_t waiting = wire.in_count - wire.taken;
    wire.room = 1000;
    tick();
    tap_ok(waiting == 8, "without room an answer waits, and so does the next command");
    tap_ok(wire.out_count == 12 + 14 && wire.out[0] == 6 && wire.out[2] == 1 && wire.out[12] == 8 &&
               wire.out[12 + 2] == 2,
           "then both are answered, in their order");

    tap_ok(all_are_done(list, COMMANDS), "a list is made and started");
    wire.out_count = 0;
    wire.room = 1;
    const uint64_t lost = iso_xcp_the_statistics.lost;
    tick();
    tick();
    tick();
    wire.room = 1000;
    tick();
    tick();
    tap_ok(wire.out_count == 3 * SAMPLE && iso_xcp_the_statistics.lost - lost == 2,
           "what has no room is lost, and counted");
    tap_ok(wire.out[4] == 0 && wire.out[SAMPLE + 4] == ISO_XCP_OVERLOAD && wire.out[2 * SAMPLE + 4] == 0,
           "the next sample says so, and no other");
    const uint16_t first = iso_xcp_word(wire.out + 2), last = iso_xcp_word(wire.out + 2 * SAMPLE + SAMPLE / 2 + 2);
    tap_count((uint16_t)(last - first), 5, "packets are counted as they are sent");

    wire.in_count = sizeof wire.in;
    wire.taken = 0;
    memset(wire.in, 0xFF, sizeof wire.in);
    size_t most = 0;
    for (unsigned i = 0; i < 20; i++) {
        const size_t before = wire.taken;
        tick();
        most = wire.taken - before > most ? wire.taken - before : most;
    }
    tap_ok(most == ISO_XCP_TICK_BYTES && wire.taken == sizeof wire.in, "no tick takes more bytes than it may");

    wire.opened = 1;
    wire.in_count = wire.taken = wire.out_count = 0;
    tick();
    tap_count((uint32_t)wire.out_count, 0, "when another master has come, nothing of the last one is measured");
    wire.in_count = 0;
    send_command("FF 00", NULL);
    wire.in_count -= 3;
    tick();
    wire.opened = 2;
    wire.in_count = wire.taken = 0;
    send_command("FF 00", NULL);
    tick();
    tap_ok(wire.out_count == 12 && wire.out[0] == 8, "half a frame of one that has gone does not disturb the next one");
}

static void test_pause(void)
{
    start(&open_plant);
    ask("FF 00", NULL);
    control = (iso_control){.left = ISO_CONTROL_ENDLESS};
    tap_ok(says("F1 03", NULL, "FF") && control.left == 0, "USER_CMD: it rests");
    iso_control_done(&control, 1);
    tap_ok(iso_control_is_resting(&control), "and rests behind the tick in which it was asked");
    tap_ok(says("F1 02 00 00 03 01 00 00", NULL, "FF") && control.left == 0x103, "it runs for some ticks");
    iso_control_done(&control, 1);
    tap_ok(control.left == 0x102, "of which one is over");
    tap_ok(says("F1 02 00 00 00 00 00 00", NULL, "FF") && control.left == ISO_CONTROL_ENDLESS,
           "0 ticks: without an end");
    iso_control_done(&control, 1);
    tap_ok(control.left == ISO_CONTROL_ENDLESS, "which stays so");
    tap_ok(says("F1 02 00 00 01 00 00", NULL, "FE 21") && says("F1 01", NULL, "FE 21") &&
               says("F1 04", NULL, "FE 21") && says("F1", NULL, "FE 21") && control.left == ISO_CONTROL_ENDLESS,
           "what it does not know, and what is too short, is refused");
    control.snapshot = record;
    control.snapshot_bytes = sizeof record;
    ask("F1 05", NULL);
    tap_ok(got_length == 12 && got[1] == ISO_CONTROL_BAD_STATE && iso_xcp_long(got + 4) == sizeof record &&
               iso_xcp_long(got + 8) == iso_xcp_address(record) && record[0] == 'I',
           "a snapshot: what came of it, and where it is");
    tap_ok(says("ED 08 00 00 * 01 02 03 04 05 06 07 08", record, "FF") && record[7] == 8 &&
               says("ED 08 00 00 * 01 02 03 04 05 06 07 08", record + 1, "FE 24") && record[1] == 2,
           "its record can be written, and nothing behind it");
    ask("F1 08 00 00 39 30 00 00", NULL);
    tap_ok(got_length == 12 && got[1] == ISO_CONTROL_DONE && restored == 12345, "the plant is put to it");
    tap_ok(says("F1 08 00 00 39 30 00", NULL, "FE 21"), "or not, where its size is missing");
    start(&locked_plant);
    ask("FF 00", NULL);
    tap_ok(says("F1 03", NULL, "FE 25") && control.left == ISO_CONTROL_ENDLESS, "likewise all of it without the key");
    start(&open_plant);
    slave.access.control = NULL;
    ask("FF 00", NULL);
    tap_ok(says("F1 03", NULL, "FE 20"), "a plant that cannot be paused does not know it");
}

int main(void)
{
    test_service();
    test_pause();
    test_connection();
    test_upload();
    test_download();
    test_blocks();
    test_lock();
    test_daq();
    test_multiple();
    test_stimulation();
    test_stimulation_refused();
    test_selected();
    test_line(false, 1);
    test_line(true, 2);
    test_line(true, 3);
    test_resynchronisation();
    bool clean = true;
    for (unsigned i = 0; i < sizeof world.before; i++) {
        clean = clean && world.before[i] == 0 && world.after[i] == 0;
    }
    tap_ok(clean, "nothing beside the plant's memory was touched");
    tap_done();
}
