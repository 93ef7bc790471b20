/* core/runtime/snapshot.h: a record goes on bit for bit in another memory, has the same bytes on every target, and is
 * refused with a reason, with nothing changed, when it is another plant's, damaged, or no snapshot. */
#define ISO_METHOD ISO_ADAMS
#define ISO_METHOD_NAME adams
#define ISO_TOLERANCE 1e-6
#include "core/runtime/snapshot.h"
#include "core/runtime/handwritten.h"
#include "core/runtime/tick.h"
#include "tests/tap.h"

/* The program that is tested: the file itself, so that no other one must be linked. */
#include "core/runtime/snapshot.c"

enum { STATES = 2, INPUTS = 1, PARAMETERS = 1, OUTPUTS = 1 };

ISO_PLANT_MEMORY(STATES, INPUTS, PARAMETERS, OUTPUTS);

static const real start[STATES] = {R(1.0)};
static const real defaults[PARAMETERS] = {R(40000.0)};

/* An oscillator of 200 rad/s: adams divides its ticks of 1 ms. */
static void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                       const real *restrict const p)
{
    dx[0] = x[1];
    dx[1] = u[0] - p[0] * x[0];
}

static void output(real *const y, const real *const x, const real *const u, const real *const p)
{
    (void)u;
    (void)p;
    y[0] = x[0];
}

static const iso_equations equations = {.derivative = derivative};

ISO_PLANT(STATES, INPUTS, PARAMETERS, OUTPUTS, .name = "oscillator", .defaults = defaults);

/* The same plant in another memory. */
static plant_memory other_memory;
static const iso_plant other = {.model = &model,
                                .memory = &other_memory,
                                .x = other_memory.x,
                                .u = other_memory.u,
                                .p = other_memory.p,
                                .y = other_memory.y,
                                .progress = &other_memory.progress.progress,
                                .adams = &other_memory.progress.adams,
                                .good = other_memory.good};

enum { BYTES = ISO_SNAPSHOT_BYTES(sizeof(plant_memory)), TICKS = 20 };

static const uint64_t identity = UINT64_C(0x0123456789ABCDEF), hash = UINT64_C(0xFEDCBA9876543210);
static unsigned char record[BYTES];

static bool go(const iso_plant *const plant, const uint64_t from, const uint64_t to)
{
    bool good = true;
    for (uint64_t tick = from; tick < to; tick++) {
        plant->u[0] = (real)(tick % 7);
        good = good && iso_plant_tick(plant, tick) == STATES;
    }
    return good;
}

static void test_goes_on(void)
{
    static unsigned char again[BYTES];
    uint64_t tick = 0, so_far = 0;
    iso_plant_start(&iso_the_plant);
    tap_ok(go(&iso_the_plant, 0, TICKS) && the_memory.progress.adams.level > 0, "goes on: a plant with sub-steps");
    iso_snapshot_take(record, &iso_the_plant, identity, TICKS, hash);
    iso_plant_start(&other);
    (void)go(&other, 0, 3);
    other.p[0] = R(7.0);
    tap_ok(iso_snapshot_restore(&other, identity, record, BYTES, &tick, &so_far) == ISO_SNAPSHOT_GOOD,
           "goes on: its record is taken by another");
    tap_ok(tick == TICKS && so_far == hash, "goes on: with its tick and its hash");
    iso_snapshot_take(again, &other, identity, tick, so_far);
    tap_ok(memcmp(record, again, BYTES) == 0, "goes on: that one has the same record");
    tap_ok(go(&iso_the_plant, TICKS, 3 * TICKS) && go(&other, TICKS, 3 * TICKS) &&
               memcmp(&the_memory, &other_memory, sizeof the_memory) == 0,
           "goes on: to the same memory");
}

/* Of the start, since in double this board's subtraction is not that of IEEE 754 (README.md, Limits). */
static void test_bytes(void)
{
    uint32_t check = 0;
    iso_plant_start(&iso_the_plant);
    iso_snapshot_take(record, &iso_the_plant, identity, 0, hash);
    memcpy(&check, record + BYTES - sizeof check, sizeof check);
    tap_ok(check_of((const unsigned char *)"123456789", 9) == UINT32_C(0xCBF43926), "bytes: the check is CRC-32");
    tap_bits(check, sizeof(real) == sizeof(float) ? UINT32_C(0xA2BE50C9) : UINT32_C(0xC1FA1ECB),
             "bytes: the same on every target");
}

/* The answer to a record, whose check is made right first if it is to be; -1 if the plant changed though it is refused.
 */
static int answer(const unsigned char *const changed, const size_t bytes, const bool mended, const uint64_t asked)
{
    static unsigned char offered[BYTES + 1];
    static plant_memory before;
    uint64_t tick = 5, so_far = 6;
    memcpy(offered, changed, bytes);
    if (mended) {
        const uint32_t check = check_of(offered, bytes - sizeof check);
        memcpy(offered + bytes - sizeof check, &check, sizeof check);
    }
    before = other_memory;
    const iso_snapshot_answer given = iso_snapshot_restore(&other, asked, offered, bytes, &tick, &so_far);
    const bool same = memcmp(&before, &other_memory, sizeof before) == 0 && tick == 5 && so_far == 6;
    return given == ISO_SNAPSHOT_GOOD || same ? (int)given : -1;
}

/* The record with another byte at this place. */
static int with(const size_t at, const unsigned char byte)
{
    static unsigned char changed[BYTES];
    memcpy(changed, record, BYTES);
    changed[at] = byte;
    return answer(changed, BYTES, true, identity);
}

static void test_damaged(void)
{
    static unsigned char longer[BYTES + 1];
    static unsigned char changed[BYTES];
    iso_plant_start(&other);
    size_t taken = 0, cut = 0;
    memcpy(changed, record, BYTES);
    for (size_t bit = 0; bit < 8 * (size_t)BYTES; bit++) {
        changed[bit / 8] ^= (unsigned char)(1U << bit % 8);
        taken += answer(changed, BYTES, false, identity) <= ISO_SNAPSHOT_GOOD;
        changed[bit / 8] ^= (unsigned char)(1U << bit % 8);
    }
    tap_ok(taken == 0, "damaged: every wrong bit is found, and changes nothing");
    for (size_t bytes = 0; bytes < BYTES; bytes++) {
        cut += answer(record, bytes, bytes >= sizeof(uint32_t), identity) == ISO_SNAPSHOT_WRONG_SIZE;
    }
    tap_ok(cut == BYTES, "damaged: a record that is cut off, at any byte, its check made right");
    memcpy(longer, record, BYTES);
    tap_ok(answer(longer, BYTES + 1, true, identity) == ISO_SNAPSHOT_WRONG_SIZE, "damaged: a byte more");
    tap_ok(with(BYTES - 1, 0) == ISO_SNAPSHOT_GOOD && answer(record, BYTES, false, identity) == ISO_SNAPSHOT_GOOD,
           "damaged: what is made right is taken");
}

static void test_foreign(void)
{
    iso_plant_start(&other);
    tap_ok(with(0, 'J') == ISO_SNAPSHOT_NO_SNAPSHOT, "foreign: another magic");
    tap_ok(with(offsetof(iso_snapshot_head, version), 1) == ISO_SNAPSHOT_OTHER_VERSION, "foreign: another version");
    tap_ok(with(offsetof(iso_snapshot_head, real_bytes), 2) == ISO_SNAPSHOT_OTHER_NUMBERS, "foreign: other numbers");
    tap_ok(answer(record, BYTES, false, identity + 1) == ISO_SNAPSHOT_OTHER_PLANT, "foreign: another plant");
    tap_ok(with(offsetof(iso_snapshot_head, outputs), 2) == ISO_SNAPSHOT_OTHER_PLANT, "foreign: other sizes");
    tap_ok(with(offsetof(iso_snapshot_head, unused), 1) == ISO_SNAPSHOT_OTHER_PLANT, "foreign: what must be zero");
    tap_ok(with(offsetof(iso_snapshot_head, rung), 1) == ISO_SNAPSHOT_NOT_A_STATE &&
               with(offsetof(iso_snapshot_head, good), 1) == ISO_SNAPSHOT_NOT_A_STATE,
           "foreign: a rung of a plant without a ladder");
}

/* The record with a number that is none in the place of one of these. */
static int with_infinity(const real *const at)
{
    const size_t place = sizeof(iso_snapshot_head) + (size_t)((const char *)at - (const char *)&other_memory);
    static unsigned char changed[BYTES];
    const iso_bits infinity = ISO_EXPONENT_BITS;
    memcpy(changed, record, BYTES);
    memcpy(changed + place, &infinity, sizeof infinity);
    return answer(changed, BYTES, true, identity);
}

static void test_no_state(void)
{
    static const size_t adams = sizeof(iso_snapshot_head) + offsetof(plant_memory, progress);
    static unsigned char changed[BYTES];
    iso_plant_start(&other);
    tap_ok(with_infinity(&other_memory.x[1]) == ISO_SNAPSHOT_NOT_A_STATE, "no state: an infinite one");
    tap_ok(with_infinity(&other_memory.y[0]) == ISO_SNAPSHOT_NOT_A_STATE, "no state: an output");
    tap_ok(with_infinity(&other_memory.good[1]) == ISO_SNAPSHOT_NOT_A_STATE, "no state: a last good value");
    tap_ok(with(adams + offsetof(iso_adams_state, order), 0) == ISO_SNAPSHOT_NOT_A_STATE &&
               with(adams + offsetof(iso_adams_state, order), 5) == ISO_SNAPSHOT_NOT_A_STATE,
           "no state: an order that adams has not");
    memcpy(changed, record, BYTES);
    changed[adams + offsetof(iso_adams_state, order)] = ISO_ADAMS_ORDERS;
    changed[adams + offsetof(iso_adams_state, starting)] = true;
    tap_ok(answer(changed, BYTES, true, identity) == ISO_SNAPSHOT_NOT_A_STATE, "no state: or that would grow");
    tap_ok(with(adams + offsetof(iso_adams_state, level), 31) == ISO_SNAPSHOT_NOT_A_STATE, "no state: a level");
    tap_ok(with(adams + offsetof(iso_adams_state, starting), 2) == ISO_SNAPSHOT_NOT_A_STATE &&
               with(adams + offsetof(iso_adams_state, overdue), 255) == ISO_SNAPSHOT_NOT_A_STATE &&
               with(adams + offsetof(iso_progress, discontinuity), 2) == ISO_SNAPSHOT_NOT_A_STATE,
           "no state: a truth that is neither true nor false");
    /* An input that is none is no harm: the plant holds its last good one. */
    tap_ok(with_infinity(&other_memory.u[0]) == ISO_SNAPSHOT_GOOD && iso_plant_tick(&other, TICKS) == STATES,
           "an input is checked when it is used");
}

int main(void)
{
    test_bytes();
    test_goes_on();
    test_damaged();
    test_foreign();
    test_no_state();
    tap_done();
}
