#include "core/application/stream.h"

#include "core/methods/adams.h"
#include "core/numbers/unroll.h"
#include "core/runtime/policy.h"

#include "port/port.h"

/* Bytes on their way to the console. Records are written whole as long as they are shorter than the buffer. */
enum { BUFFER_BYTES = 1024 };
static uint8_t trace_buffer[BUFFER_BYTES];
static size_t used;

static void flush(void)
{
    iso_port_write(trace_buffer, used);
    used = 0;
}

ISO_APART static void put_byte(const uint8_t byte)
{
    if (used == BUFFER_BYTES) {
        flush();
    }
    trace_buffer[used++] = byte;
}

ISO_APART static void put_number(uint64_t number, const size_t bytes)
{
    for (size_t i = 0; i < bytes; i++) {
        put_byte((uint8_t)(number & 0xFF));
        number >>= 8;
    }
}

static void put_reals(const real *const x, const size_t n)
{
    for (size_t i = 0; i < n; i++) {
        put_number(iso_bits_of(x[i]), sizeof *x);
    }
}

ISO_RARE static void put_text(const char *text)
{
    while (text != NULL && *text != '\0') {
        put_byte((uint8_t)*text++);
    }
}

ISO_APART ISO_RARE static void put_line(const char *const key, const char *const value)
{
    put_text(key);
    put_byte(' ');
    put_text(value);
    put_byte('\n');
}

ISO_APART ISO_RARE static void put_hexadecimal(const char *const key, const uint64_t value)
{
    enum { DIGITS = 16 };
    char text[DIGITS + 1];
    for (unsigned i = 0; i < DIGITS; i++) {
        text[i] = "0123456789abcdef"[value >> 4 * (DIGITS - 1 - i) & 0xF];
    }
    text[DIGITS] = '\0';
    put_line(key, text);
}

ISO_RARE _Noreturn void iso_stream_give_up(const char *const why)
{
    put_line("Bail out!", why);
    flush();
    iso_port_exit(1);
}

ISO_RARE void iso_stream_header(const iso_plant *const plant, const uint64_t duration)
{
    const iso_model *const model = plant->model;
#define STREAM_TEXT(key, value) put_line(#key, value);
#define STREAM_NUMBER(key, value) put_hexadecimal(#key, value);
    put_text(ISO_STREAM_VERSION "\n");
    ISO_STREAM_TEXTS(STREAM_TEXT)
    ISO_STREAM_NUMBERS(STREAM_NUMBER)
    put_byte('\n');
    flush();
}

void iso_stream_row(const real *const y, const size_t outputs)
{
    if (used + 1 + outputs * sizeof *y > BUFFER_BYTES) {
        flush();
    }
    put_byte(ISO_STREAM_ROW);
    put_reals(y, outputs);
}

ISO_RARE void iso_stream_from(const uint64_t tick)
{
    put_byte(ISO_STREAM_FROM);
    put_number(tick, sizeof tick);
}

ISO_RARE void iso_stream_snapshot(const unsigned char *const snapshot, const size_t bytes)
{
    put_byte(ISO_STREAM_SNAPSHOT);
    put_number(bytes, sizeof(uint64_t));
    for (size_t i = 0; i < bytes; i++) {
        put_byte(snapshot[i]);
    }
}

/* The places of the whole numbers in the statistics: 8 bytes each from the beginning, nothing between. */
#define STREAM_PLACE(name, member) STREAM_AT_##name,
enum { ISO_STREAM_COUNTS(STREAM_PLACE) STREAM_COUNTS };
#define STREAM_PLACED(name, member)                                                                                    \
    _Static_assert(offsetof(iso_statistics, member) == STREAM_AT_##name * sizeof(uint64_t), #name);
ISO_STREAM_COUNTS(STREAM_PLACED)

/* count numbers of 64 bits, which stand one after another. */
ISO_RARE static void put_words(const void *const from, const size_t count)
{
    for (size_t i = 0; i < count; i++) {
        uint64_t word;
        memcpy(&word, (const uint8_t *)from + i * sizeof word, sizeof word);
        put_number(word, sizeof word);
    }
}

ISO_RARE void iso_stream_times(const iso_times *const times)
{
    const uint64_t words[] = {times->tick_min, times->tick_max, times->beside};
    put_byte(ISO_STREAM_TIMES);
    put_words(words, sizeof words / sizeof words[0]);
}

ISO_RARE void iso_stream_end(const iso_loop *const loop, const uint64_t hash)
{
    static const iso_adams_state none;
    const iso_statistics *const statistics = &loop->statistics;
    const iso_policy *const policy = loop->plant->model->policy;
    const iso_adams_state *const adams = loop->plant->adams == NULL ? &none : loop->plant->adams;

#define STREAM_VALUE(name, value) value,
    const uint64_t words[] = {ISO_STREAM_WORDS(STREAM_VALUE)};

    put_byte(ISO_STREAM_END);
    put_words(statistics, STREAM_COUNTS);
    put_words(words, sizeof words / sizeof words[0]);
    put_reals(loop->plant->x, loop->plant->model->states);
    put_reals(&statistics->local_error, 1);
    put_reals(&statistics->violation, 1);
    if (policy != NULL) {
        put_words(policy->counts, policy->count);
    }
    flush();
}
