#include "tests/tap.h"

#include <string.h>

#include "port/port.h"

static uint32_t tests;
static uint32_t failures;

static void put(const char *const text)
{
    iso_port_write(text, strlen(text));
}

static void put_decimal(uint32_t value)
{
    char digits[10];
    size_t first = sizeof digits;
    do {
        digits[--first] = (char)('0' + value % 10);
        value /= 10;
    } while (value != 0);
    iso_port_write(digits + first, sizeof digits - first);
}

static void put_hex(const uint64_t value)
{
    char digits[18] = "0x";
    for (unsigned i = 0; i < 16; i++) {
        digits[2 + i] = "0123456789abcdef"[(value >> (60 - 4 * i)) & 15];
    }
    iso_port_write(digits, sizeof digits);
}

void tap_ok(const bool passed, const char *const name)
{
    tests++;
    failures += passed ? 0 : 1;
    put(passed ? "ok " : "not ok ");
    put_decimal(tests);
    put(" - ");
    put(name);
    put("\n");
}

void tap_count(const uint32_t got, const uint32_t want, const char *const name)
{
    tap_ok(got == want, name);
    if (got != want) {
        tap_note("got", got);
        tap_note("want", want);
    }
}

void tap_bits(const uint64_t got, const uint64_t want, const char *const name)
{
    tap_ok(got == want, name);
    if (got != want) {
        tap_note_bits("got", got);
        tap_note_bits("want", want);
    }
}

void tap_note(const char *const name, const uint32_t value)
{
    put("# ");
    put(name);
    put(" ");
    put_decimal(value);
    put("\n");
}

void tap_note_bits(const char *const name, const uint64_t value)
{
    put("# ");
    put(name);
    put(" ");
    put_hex(value);
    put("\n");
}

_Noreturn void tap_done(void)
{
    put("1..");
    put_decimal(tests);
    put("\n");
    iso_port_exit(failures == 0 && tests > 0 ? 0 : 1);
}
