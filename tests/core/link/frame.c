/* core/link: CRC-16, COBS and frames, against vectors of their authors, and against random damage of a wire. */
#include "core/link/crc16.h"
#include "tests/draw.h"
#include "tests/tap.h"

#undef iso_frame_put_reals
#undef iso_frame_real
#include "core/link/frame.c"
#include "core/link/link.h"

/* --- CRC --------------------------------------------------------------------------------------------------------- */

/* Bit by bit, as the polynomial says. */
static uint16_t crc_by_bits(const uint8_t *const bytes, const size_t count)
{
    uint32_t crc = 0xFFFF;
    for (size_t i = 0; i < count; i++) {
        for (int bit = 7; bit >= 0; bit--) {
            const uint32_t top = (crc >> 15 ^ (uint32_t)bytes[i] >> bit) & 1;
            crc = (crc << 1 ^ top * 0x1021) & 0xFFFF;
        }
    }
    return (uint16_t)crc;
}

static void test_crc(void)
{
    uint8_t bytes[64] = {0};
    tap_count(iso_crc16(ISO_CRC16_START, (const uint8_t *)"123456789", 9), 0x29B1,
              "crc: the check value of the catalogue");
    tap_count(iso_crc16(ISO_CRC16_START, bytes, 0), 0xFFFF, "crc: of nothing");
    uint32_t same = 0;
    for (int i = 0; i < 200; i++) {
        const size_t count = draw(sizeof bytes);
        for (size_t k = 0; k < count; k++) {
            bytes[k] = (uint8_t)draw(256);
        }
        same += iso_crc16(ISO_CRC16_START, bytes, count) == crc_by_bits(bytes, count);
    }
    tap_count(same, 200, "crc: 200 random texts as bit by bit");
}

/* --- COBS -------------------------------------------------------------------------------------------------------- */

static size_t encode(uint8_t *const to, const uint8_t *const from, const size_t count)
{
    memcpy(to + 1, from, count);
    return iso_cobs_encode(to, count);
}

static bool is_encoded(const uint8_t *const from, const size_t count, const uint8_t *const wanted, const size_t length)
{
    uint8_t coded[16];
    return encode(coded, from, count) == length && memcmp(coded, wanted, length) == 0 &&
           iso_cobs_decode(coded, length) == count && memcmp(coded, from, count) == 0;
}

/* As many bytes, all zeros, none, or some, come back; no zero is on the wire, and there is room. */
static bool comes_back(const size_t count, const uint32_t zeros)
{
    static uint8_t bytes[600], coded[ISO_COBS_ROOM(sizeof bytes)];
    for (size_t i = 0; i < count; i++) {
        bytes[i] = draw(100) < zeros ? 0 : (uint8_t)(1 + draw(255));
    }
    const size_t length = encode(coded, bytes, count);
    bool good = length <= ISO_COBS_ROOM(count);
    for (size_t i = 0; i < length; i++) {
        good = good && coded[i] != 0;
    }
    return good && iso_cobs_decode(coded, length) == count && memcmp(coded, bytes, count) == 0;
}

static void test_cobs(void)
{
    tap_ok(is_encoded((const uint8_t *)"", 0, (const uint8_t *)"\1", 1), "cobs: nothing");
    tap_ok(is_encoded((const uint8_t *)"\0", 1, (const uint8_t *)"\1\1", 2), "cobs: a zero");
    tap_ok(is_encoded((const uint8_t *)"\0\0", 2, (const uint8_t *)"\1\1\1", 3), "cobs: two zeros");
    tap_ok(is_encoded((const uint8_t *)"\x11\x22\0\x33", 4, (const uint8_t *)"\3\x11\x22\2\x33", 5),
           "cobs: two blocks");
    tap_ok(is_encoded((const uint8_t *)"\x11\0\0\0", 4, (const uint8_t *)"\2\x11\1\1\1", 5), "cobs: zeros at the end");
    uint32_t good = 0, tried = 0;
    for (size_t count = 0; count <= 600; count += count < 250 || count > 512 ? 25 : 1) {
        for (uint32_t zeros = 0; zeros <= 100; zeros += 50) {
            tried++;
            good += comes_back(count, zeros);
        }
    }
    tap_count(good, tried, "cobs: texts of all lengths about 254 and 508 come back, within their room");
    tap_count((uint32_t)iso_cobs_decode((uint8_t[]){5, 1, 2}, 3), 0, "cobs: a block that ends behind the frame");
    tap_count((uint32_t)iso_cobs_decode((uint8_t[]){1, 0, 2}, 3), 0, "cobs: a code of zero");
}

/* --- Frames ------------------------------------------------------------------------------------------------------ */

enum { PAYLOAD_MOST = 300, FRAME_BYTES = ISO_FRAME_BYTES(PAYLOAD_MOST) };

static uint8_t received[FRAME_BYTES];

/* A frame whose payload follows from its number: its length, and every byte. */
static size_t length_of(const uint32_t number)
{
    return 4 + number * 7 % 40;
}

static size_t make_frame(uint8_t *const to, const uint32_t number)
{
    iso_frame_writer w = iso_frame_begin(to, 'y');
    iso_frame_put(&w, number, 4);
    for (size_t i = 4; i < length_of(number); i++) {
        iso_frame_put(&w, (uint8_t)(number * i >> 2), 1);
    }
    return iso_frame_end(&w);
}

/* Whether what has come in is such a frame, to the last byte; and its number. */
static bool is_good(const size_t length, uint32_t *const number)
{
    *number = (uint32_t)iso_frame_number(received + 1, 4);
    bool good = received[0] == 'y' && length >= 4 && length == length_of(*number);
    for (size_t i = 4; good && i < length; i++) {
        good = received[1 + i] == (uint8_t)(*number * i >> 2);
    }
    return good;
}

/* What came over a wire: of the frames that were sent whole, how many; how many pieces were no frames; and what nobody
 * sent. A frame whose zeros alone were hit may come through. */
enum { FRAMES = 600, DAMAGES = 6 };
typedef struct account {
    uint32_t sent_whole, whole, dropped, wrong, twice;
} account;

/* Damages n > 2 bytes: bits turned, a byte another one, left out, put in, bytes in noise, or the end cut off. The zero
 * before them and the one behind them may be hit too. Returns how many there are then. */
static size_t damage(uint8_t *const bytes, const size_t n)
{
    const size_t at = draw((uint32_t)n);
    switch (draw(DAMAGES)) {
    case 0:
        bytes[at] ^= (uint8_t)(1 << draw(8));
        return n;
    case 1:
        bytes[at] ^= (uint8_t)(1 + draw(255));
        return n;
    case 2:
        memmove(bytes + at, bytes + at + 1, n - at - 1);
        return n - 1;
    case 3:
        memmove(bytes + at + 1, bytes + at, n - at);
        bytes[at] = (uint8_t)draw(256);
        return n + 1;
    case 4:
        for (size_t i = at; i < n && i < at + 4; i++) {
            bytes[i] = (uint8_t)draw(256);
        }
        return n;
    default:
        return at;
    }
}

/* One frame of three is damaged, if any; all have lost so many bytes in front. */
static account over_the_wire(const bool is_damaged, const size_t skipped)
{
    static uint8_t seen[FRAMES], wire[FRAME_BYTES + 1], before[FRAME_BYTES];
    memset(seen, 0, sizeof seen);
    iso_frame_reader r = {.buffer = received, .room = sizeof received};
    account a = {0};
    for (uint32_t number = 0; number < FRAMES; number++) {
        const size_t n = make_frame(wire, number);
        memcpy(before, wire, n);
        const size_t left = is_damaged && number % 3 == 1 ? damage(wire, n) : n;
        const bool whole = left == n && memcmp(before, wire, n) == 0;
        a.sent_whole += whole;
        seen[number] |= whole ? 0 : 2;
        for (size_t i = skipped; i < left; i++) {
            size_t length = 0;
            uint32_t got = 0;
            const iso_frame_state state = iso_frame_take(&r, wire[i], &length);
            a.dropped += state == ISO_FRAME_DAMAGED;
            if (state == ISO_FRAME_WHOLE && is_good(length, &got) && got < FRAMES) {
                a.twice += seen[got] & 1;
                a.whole += seen[got] == 0;
                seen[got] |= 1;
            } else {
                a.wrong += state == ISO_FRAME_WHOLE;
            }
        }
    }
    return a;
}

/* The state of a reader after n bytes. */
static iso_frame_state take_all(iso_frame_reader *const r, const uint8_t *const bytes, const size_t n,
                                size_t *const length)
{
    iso_frame_state state = ISO_FRAME_OPEN;
    for (size_t i = 0; i < n; i++) {
        state = iso_frame_take(r, bytes[i], length);
    }
    return state;
}

static void test_wire(void)
{
    const account quiet = over_the_wire(false, 0);
    tap_count(quiet.whole, FRAMES, "wire: all frames come through");
    tap_count(quiet.dropped + quiet.wrong + quiet.twice, 0, "wire: and nothing else");
    for (uint32_t i = 1; i <= 3; i++) {
        seed = 1000 * i + 7;
        tap_note("seed", seed);
        const account noisy = over_the_wire(true, 0);
        tap_count(noisy.whole, noisy.sent_whole, "damage: every frame that was not hit comes through");
        tap_count(noisy.wrong + noisy.twice, 0, "damage: none that was hit, and none twice");
        tap_ok(noisy.dropped > FRAMES / 6, "damage: it was there");
    }
    const account bare = over_the_wire(true, 1);
    tap_ok(bare.whole < bare.sent_whole,
           "found: without the zero before them frames are lost beside others that were hit");
}

static void test_sizes(void)
{
    static uint8_t wire[FRAME_BYTES];
    size_t length = 0;
    iso_frame_reader r = {.buffer = received, .room = sizeof received};
    iso_frame_writer w = iso_frame_begin(wire, 'y');
    for (size_t i = 0; i < PAYLOAD_MOST; i++) {
        iso_frame_put(&w, 1, 1);
    }
    size_t n = iso_frame_end(&w);
    tap_count((uint32_t)n, FRAME_BYTES, "sizes: the largest frame");
    tap_ok(take_all(&r, wire, n, &length) == ISO_FRAME_WHOLE && length == PAYLOAD_MOST, "sizes: comes through");
    r.room = n - 3; /* without its zeros, one byte less than it needs */
    tap_ok(take_all(&r, wire, n, &length) == ISO_FRAME_DAMAGED, "sizes: a larger one is dropped");
    n = make_frame(wire, 11);
    tap_ok(take_all(&r, wire, n, &length) == ISO_FRAME_WHOLE && length == length_of(11),
           "sizes: the next comes through");
}

static void test_reals(void)
{
    static uint8_t wire[FRAME_BYTES];
    const real x[2] = {R(1.5), R(-0.0)};
    size_t length = 0;
    iso_frame_reader r = {.buffer = received, .room = sizeof received};
    iso_frame_writer w = iso_frame_begin(wire, 'u');
    iso_frame_put_reals(&w, x, 2);
    const size_t n = iso_frame_end(&w);
    tap_ok(take_all(&r, wire, n, &length) == ISO_FRAME_WHOLE && length == sizeof x, "reals: as wide as they are");
    tap_same(iso_frame_real(received + 1), x[0], "reals: a number");
    tap_same(iso_frame_real(received + 1 + sizeof(real)), x[1], "reals: with the sign of its zero");
}

/* --- The numbers of the wire: those of core/link/README.md, which programs of others have too ------------------------
 */

static void test_numbers(void)
{
    static const uint8_t types[] = {ISO_LINK_HELLO,  ISO_LINK_START,   ISO_LINK_INPUTS,
                                    ISO_LINK_END,    ISO_LINK_COMMAND, ISO_LINK_OUTPUTS,
                                    ISO_LINK_ANSWER, ISO_LINK_PLANT,   ISO_LINK_REFUSAL};
    static const char letters[] = "hsuecyCHn";
    static const uint8_t commands[] = {ISO_COMMAND_STATE, ISO_COMMAND_RUN,  ISO_COMMAND_REST,  ISO_COMMAND_RESET,
                                       ISO_COMMAND_TAKE,  ISO_COMMAND_READ, ISO_COMMAND_WRITE, ISO_COMMAND_RESTORE};
    static const uint8_t reasons[] = {ISO_LINK_UNKNOWN, ISO_LINK_FOREIGN, ISO_LINK_NO_MODE, ISO_LINK_NOT_STARTED,
                                      ISO_LINK_ALREADY_STARTED};
    bool good = true;
    for (size_t i = 0; i < sizeof types; i++) {
        good = good && types[i] == (uint8_t)letters[i];
    }
    tap_ok(good, "types of frames");
    good = true;
    for (size_t i = 0; i < sizeof commands; i++) {
        good = good && commands[i] == i + 1;
    }
    tap_ok(good, "commands");
    good = true;
    for (size_t i = 0; i < sizeof reasons; i++) {
        good = good && reasons[i] == i + 1;
    }
    tap_ok(good, "reasons of a refusal");
    tap_ok(ISO_LINK_VERSION == 1 && ISO_LINK_FREE == 0 && ISO_LINK_LOCKSTEP == 1, "version and modes");
    tap_count(ISO_COMMAND_PIECE, 128, "bytes of a piece of a snapshot");
}

int main(void)
{
    seed = 12345;
    test_numbers();
    test_crc();
    test_cobs();
    test_wire();
    test_sizes();
    test_reals();
    tap_done();
}
