#include "tools/monitor/monitor.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/file/file.h"

/* The words of the file, one after another: texts in quotes are words of their own, comments are none. */
typedef struct words {
    const char *at;
    int line;
    char word[A2L_TEXT_BYTES]; /* without its quotes; a longer one is cut */
} words;

static void skip_space(words *const w)
{
    for (;;) {
        const char *const end = strncmp(w->at, "/*", 2) == 0 ? strstr(w->at + 2, "*/") : NULL;
        const char *const to = end != NULL ? end + 2 : w->at + (isspace((unsigned char)*w->at) ? 1 : 0);
        if (to == w->at) {
            return;
        }
        for (; w->at < to; w->at++) {
            w->line += *w->at == '\n';
        }
    }
}

/* Returns false at the end. */
static bool next(words *const w)
{
    skip_space(w);
    const bool is_text = *w->at == '"';
    w->at += is_text;
    size_t n = 0;
    for (; *w->at != '\0' && (is_text ? *w->at != '"' : !isspace((unsigned char)*w->at)); w->at++) {
        w->line += *w->at == '\n';
        if (n + 1 < sizeof w->word) {
            w->word[n++] = *w->at;
        }
    }
    w->word[n] = '\0';
    w->at += is_text && *w->at == '"';
    return n > 0 || is_text;
}

static bool skip(words *const w, const int count)
{
    bool good = true;
    for (int i = 0; i < count && good; i++) {
        good = next(w);
    }
    return good;
}

static bool text(words *const w, char to[A2L_TEXT_BYTES])
{
    const bool good = next(w);
    memcpy(to, w->word, A2L_TEXT_BYTES);
    return good;
}

static bool number(words *const w, double *const to)
{
    char *end = NULL;
    if (!next(w)) {
        return false;
    }
    *to = strtod(w->word, &end);
    return end != w->word && *end == '\0';
}

static bool address(words *const w, uint32_t *const to)
{
    char *end = NULL;
    if (!next(w)) {
        return false;
    }
    const unsigned long long value = strtoull(w->word, &end, 0);
    *to = (uint32_t)value;
    return end != w->word && *end == '\0' && value <= UINT32_MAX;
}

/* The index of the next word in a list of words; -1: it is none of them. */
static int one_of(words *const w, const char *const *const names, const size_t count)
{
    int found = next(w) ? (int)count - 1 : -1;
    while (found >= 0 && strcmp(w->word, names[found]) != 0) {
        found--;
    }
    return found;
}

static bool type(words *const w, a2l_type *const to)
{
    static const char *const names[] = {"FLOAT32_IEEE", "FLOAT64_IEEE", "A_UINT64", "A_INT64"};
    const int found = one_of(w, names, sizeof names / sizeof names[0]);
    *to = found < 0 ? A2L_FLOAT : (a2l_type)found;
    return found >= 0;
}

/* The unit is that of a COMPU_METHOD, whose name stands in its place until all are known. */
static bool measurement(words *const w, a2l_quantity *const q)
{
    return text(w, q->name) && skip(w, 1) && type(w, &q->type) && text(w, q->unit) && skip(w, 2) &&
           number(w, &q->least) && number(w, &q->most) && next(w) && strcmp(w->word, "ECU_ADDRESS") == 0 &&
           address(w, &q->address);
}

static bool characteristic(words *const w, a2l_quantity *const q, const a2l_type real)
{
    q->is_tunable = true;
    q->type = real;
    return text(w, q->name) && skip(w, 1) && next(w) && strcmp(w->word, "VALUE") == 0 && address(w, &q->address) &&
           skip(w, 2) && text(w, q->unit) && number(w, &q->least) && number(w, &q->most);
}

static bool unit(words *const w, const a2l *const a)
{
    char name[A2L_TEXT_BYTES];
    if (!text(w, name) || !skip(w, 4)) {
        return false;
    }
    for (size_t i = 0; i < a->count; i++) {
        if (strcmp(a->quantities[i].unit, name) == 0) {
            memcpy(a->quantities[i].unit, w->word, A2L_TEXT_BYTES);
        }
    }
    return true;
}

/* A step is so many units of a power of ten. */
static bool stamp(words *const w, double *const step)
{
    static const char *const names[] = {"UNIT_1NS",   "UNIT_10NS", "UNIT_100NS", "UNIT_1US",   "UNIT_10US",
                                        "UNIT_100US", "UNIT_1MS",  "UNIT_10MS",  "UNIT_100MS", "UNIT_1S"};
    double count = 0;
    const int power = number(w, &count) && skip(w, 1) ? one_of(w, names, sizeof names / sizeof names[0]) : -1;
    *step = count / pow(10, 9 - power);
    return power >= 0;
}

static a2l_quantity *added(a2l *const to)
{
    to->quantities = room_behind(to->quantities, to->count, sizeof *to->quantities);
    to->quantities[to->count] = (a2l_quantity){.is_tunable = false};
    return &to->quantities[to->count++];
}

/* Takes the keyword and its arguments. Keywords that the monitor does not need are passed over. */
static bool take(a2l *const to, words *const w, a2l_type *const real)
{
    if (strcmp(w->word, "EPK") == 0) {
        return text(w, to->epk);
    }
    if (strcmp(w->word, "FNC_VALUES") == 0) {
        return skip(w, 1) && type(w, real);
    }
    if (strcmp(w->word, "/begin") != 0) {
        return true;
    }
    if (!next(w)) {
        return false;
    }
    if (strcmp(w->word, "A2ML") == 0) {
        while (next(w) && strcmp(w->word, "/end") != 0) {
        }
        return strcmp(w->word, "/end") == 0;
    }
    return strcmp(w->word, "MEASUREMENT") == 0           ? measurement(w, added(to))
           : strcmp(w->word, "CHARACTERISTIC") == 0      ? characteristic(w, added(to), *real)
           : strcmp(w->word, "COMPU_METHOD") == 0        ? unit(w, to)
           : strcmp(w->word, "TIMESTAMP_SUPPORTED") == 0 ? stamp(w, &to->step)
                                                         : true;
}

a2l a2l_read(const char *const path)
{
    a2l found = {.count = 0};
    size_t bytes = 0;
    char *const all = file_content(path, &bytes);
    if (all == NULL) {
        quit("monitor: %s: %s", path, strerror(errno));
    }
    words w = {.at = all, .line = 1};
    a2l_type real = A2L_FLOAT;
    bool good = next(&w) && strcmp(w.word, "ASAP2_VERSION") == 0;
    while (good && next(&w)) {
        good = take(&found, &w, &real);
    }
    if (!good) {
        quit("monitor: %s:%d: '%.40s' is not what stands there in an A2L of isoc; `isochron a2l` makes one", path,
             w.line, w.word);
    }
    if (found.count == 0) {
        quit("monitor: %s:%d: the file ends without a MEASUREMENT; `isochron a2l` makes an A2L", path, w.line);
    }
    for (size_t i = 0; i < found.count; i++) {
        a2l_quantity *const q = &found.quantities[i];
        q->unit[0] = strcmp(q->unit, "NO_COMPU_METHOD") == 0 ? '\0' : q->unit[0];
    }
    free(all);
    return found;
}

size_t a2l_bytes(const a2l_type type)
{
    return type == A2L_FLOAT ? 4 : 8;
}

double a2l_value(const a2l_type type, const uint8_t *const from)
{
    union {
        float narrow;
        double wide;
        uint64_t count;
        int64_t whole;
    } bytes;
    memcpy(&bytes, from, a2l_bytes(type));
    return type == A2L_FLOAT      ? (double)bytes.narrow
           : type == A2L_DOUBLE   ? bytes.wide
           : type == A2L_UNSIGNED ? (double)bytes.count
                                  : (double)bytes.whole;
}

const a2l_quantity *a2l_find(const a2l *const in, const char *const name)
{
    for (size_t i = 0; i < in->count; i++) {
        const char *const dot = strchr(in->quantities[i].name, '.');
        if (strcmp(in->quantities[i].name, name) == 0 || (dot != NULL && strcmp(dot + 1, name) == 0)) {
            return &in->quantities[i];
        }
    }
    return NULL;
}
