/* A slave with a small plant, commands of hexadecimal digits, and its answers. */
#ifndef ISO_TESTS_UNIT_XCP_ASK_H
#define ISO_TESTS_UNIT_XCP_ASK_H

#include "tests/core/xcp/xcp/channel.h"

#include "core/link/link.h"
#include "core/xcp/service.h"
#include "tests/tap.h"

enum { STATES = 3, TUNABLES = 5, OUTPUTS = 2, BEYOND = 4 };

/* What the slave shows, and what it must not touch. */
typedef struct shown {
    real x[STATES];
    real p[TUNABLES];
    real y[OUTPUTS];
} shown;

static struct {
    uint8_t before[64];
    shown memory;
    uint8_t after[64];
} world;

static const iso_limits limits[TUNABLES] = {
    {R(0.0), R(1.0)}, {R(-1.0), R(1.0)}, {-ISO_REAL_MAX, ISO_REAL_MAX}, {R(0.0), ISO_REAL_MAX}, {R(0.0), R(9.0)}};
static const iso_xcp_description open_plant = {"cart", "epk 1", limits, NULL, {2, 10000}, {6, 1}};
static const iso_xcp_description locked_plant = {"cart", "epk 1", limits, &iso_xcp_example_lock, {2, 10000}, {6, 1}};
static iso_xcp_slave slave;
static iso_control control;
static unsigned char record[8];
static size_t restored;

static iso_control_answer take(void)
{
    record[0] = 'I';
    return ISO_CONTROL_BAD_STATE;
}

static iso_control_answer restore(const size_t bytes)
{
    restored = bytes;
    return ISO_CONTROL_DONE;
}
static uint8_t got[ISO_XCP_MAX_CTO];
static uint16_t got_length;

static void start(const iso_xcp_description *const of)
{
    for (unsigned i = 0; i < STATES; i++) {
        world.memory.x[i] = (real)(i + 1) * R(0.25);
    }
    for (unsigned i = 0; i < TUNABLES; i++) {
        world.memory.p[i] = R(0.5);
    }
    world.memory.y[0] = R(7.0);
    world.memory.y[1] = R(8.0);
    const iso_xcp_access access = {.readable = {{&world.memory, sizeof world.memory}},
                                   .tunables = world.memory.p,
                                   .limits = limits,
                                   .tunable_count = TUNABLES,
                                   .control = &control,
                                   .take = take,
                                   .restore = restore};
    iso_xcp_start(&slave, of, &access);
}

static int digit(const char c)
{
    return c >= '0' && c <= '9' ? c - '0' : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/* Bytes of a text in hexadecimal; * is an address. */
static uint16_t bytes_of(const char *text, const void *const address, uint8_t *const to)
{
    uint16_t count = 0;
    while (*text != '\0') {
        if (*text == '*') {
            iso_xcp_put_long(to + count, iso_xcp_address(address));
            count += 4;
            text++;
        } else if (digit(text[0]) >= 0) {
            to[count++] = (uint8_t)(digit(text[0]) * 16 + digit(text[1]));
            text += 2;
        } else {
            text++;
        }
    }
    return count;
}

static void ask_bytes(const uint8_t *const command, const uint16_t length)
{
    for (unsigned i = 0; i < sizeof got; i++) {
        got[i] = 0;
    }
    got_length = iso_xcp_answer(&slave, command, length, got);
}

static void ask(const char *const command, const void *const address)
{
    uint8_t bytes[ISO_XCP_MAX_CTO];
    ask_bytes(bytes, bytes_of(command, address, bytes));
}

static bool is_answer(const char *const want)
{
    uint8_t bytes[ISO_XCP_MAX_CTO];
    const uint16_t length = bytes_of(want, NULL, bytes);
    return got_length == length && memcmp(got, bytes, length) == 0;
}

/* A command, and all bytes of what must come back. */
static bool says(const char *const command, const void *const address, const char *const want)
{
    ask(command, address);
    const bool good = is_answer(want);
    if (!good) {
        tap_note("length of the answer", got_length);
        tap_note_bits("its first bytes", (uint64_t)iso_xcp_long(got) << 32 | iso_xcp_long(got + 4));
    }
    return good;
}

static void put_real(uint8_t *const to, const real x)
{
    memcpy(to, &x, sizeof x);
}

/* SHORT_DOWNLOAD of some reals. */
static void write_reals(const void *const to, const real *const x, const unsigned n)
{
    uint8_t command[ISO_XCP_MAX_CTO] = {ISO_XCP_SHORT_DOWNLOAD, (uint8_t)(n * sizeof(real))};
    iso_xcp_put_long(command + 4, iso_xcp_address(to));
    for (unsigned i = 0; i < n; i++) {
        put_real(command + 8 + i * sizeof(real), x[i]);
    }
    ask_bytes(command, (uint16_t)(8 + n * sizeof(real)));
}

#endif
