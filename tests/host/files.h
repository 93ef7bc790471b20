/* Files that a compiler reads: which they are, by the list that it writes for make, and hashes of what they say. */
#ifndef FILES_H
#define FILES_H

#include <fcntl.h>
#include <inttypes.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "command.h"

enum { BUFFER = 1 << 16 };

/* FNV-1a (Fowler, Noll, Vo), two of 64 bits from different starts. */
typedef struct hash {
    uint64_t a, b;
} hash;

static inline void hash_add(hash *const h, const void *const bytes, const size_t count)
{
    for (const unsigned char *at = bytes, *const end = at + count; at < end; at++) {
        h->a = (h->a ^ *at) * UINT64_C(0x100000001B3);
        h->b = (h->b ^ *at) * UINT64_C(0x10000000233) + 1;
    }
}

static const hash hash_start = {UINT64_C(0xCBF29CE484222325), UINT64_C(0x84222325CBF29CE4)};

/* The files that a source includes. */
typedef struct reading {
    char text[BUFFER]; /* their names, each behind its kind, and ended by a zero */
    size_t length;
    bool whole; /* whether all are there */
} reading;

/* Kinds of files: of the system; beside the source, named from there; others. */
enum { OF_SYSTEM = 's', BESIDE = 'l', OTHER = 'p' };

static inline void reading_add(reading *const files, const char kind, const char *const name, const size_t length)
{
    files->whole = files->whole && files->length + length + 2 <= sizeof files->text;
    if (files->whole) {
        char *const to = files->text + files->length;
        to[0] = kind;
        memcpy(to + 1, name, length);
        to[length + 1] = '\0';
        files->length += length + 2;
    }
}

/* Reads what the compiler wrote for make: a target, the source, and what it includes. `place` is the folder of the
 * source, with its slash. */
static inline bool read_includes(const char *const list, const char *const place, reading *const files)
{
    static char text[BUFFER];
    FILE *const in = fopen(list, "r");
    const size_t length = in == NULL ? 0 : fread(text, 1, sizeof text - 1, in), beside = strlen(place);
    text[length] = '\0';
    files->length = 0;
    files->whole = length > 0 && length < sizeof text - 1 && strpbrk(text, "$#") == NULL;
    int number = 0;
    for (const char *at = text; files->whole && *(at += strspn(at, " \n")) != '\0';) {
        const size_t size = strcspn(at, " \n");
        const char *const name = begins_with(at, "./") ? at + 2 : at;
        const size_t rest = size - (size_t)(name - at);
        at += size;
        if (rest == 1 && name[0] == '\\') {
            continue; /* the next line goes on */
        }
        files->whole = memchr(name, '\\', rest) == NULL; /* before a space */
        if (++number <= 2) {
            continue;
        }
        if (begins_with(name, "/usr/")) {
            reading_add(files, OF_SYSTEM, name, rest);
        } else if (beside > 0 && strncmp(name, place, beside) == 0) {
            reading_add(files, BESIDE, name + beside, rest - beside);
        } else {
            reading_add(files, OTHER, name, rest);
        }
    }
    if (in != NULL) {
        fclose(in);
    }
    return files->whole && number >= 2;
}

static inline bool copy(const char *const from, const char *const to)
{
    static char bytes[BUFFER];
    const int in = open(from, O_RDONLY);
    if (in < 0) {
        return false;
    }
    (void)unlink(to);
    const int out = open(to, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    ssize_t got = out < 0 ? -1 : 1;
    while (got > 0) {
        got = read(in, bytes, sizeof bytes);
        if (got > 0 && write(out, bytes, (size_t)got) != got) {
            got = -1;
        }
    }
    (void)futimens(in, NULL); /* its last use */
    close(in);
    return out >= 0 && close(out) == 0 && got == 0;
}

static inline bool is_before(const struct timespec a, const struct timespec b)
{
    return a.tv_sec < b.tv_sec || (a.tv_sec == b.tv_sec && a.tv_nsec < b.tv_nsec);
}

/* Adds a file: its text, or of one of the system its size and its date. False if there is none, or if its date is not
 * before
 * `*before`, if that is given: then it may be another than the one that was read. */
static inline bool hash_file(const char kind, const char *const name, const struct timespec *const before,
                             hash *const h)
{
    static char bytes[BUFFER];
    struct stat file;
    const int in = open(name, O_RDONLY);
    bool read_all = in >= 0 && fstat(in, &file) == 0 && (before == NULL || is_before(file.st_mtim, *before));
    if (read_all && kind == OF_SYSTEM) {
        hash_add(h, &file.st_size, sizeof file.st_size);
        hash_add(h, &file.st_mtim, sizeof file.st_mtim);
    } else if (read_all) {
        ssize_t got = 0;
        while ((got = read(in, bytes, sizeof bytes)) > 0) {
            hash_add(h, bytes, (size_t)got);
        }
        read_all = got == 0;
    }
    if (in >= 0) {
        close(in);
    }
    return read_all;
}

/* A time, on the clock of the dates of files, that is after the date of the source, if that is of just now. */
static inline struct timespec begin_after(const char *const source)
{
    const struct timespec pause = {.tv_nsec = 500000};
    struct timespec now = {0};
    struct stat file;
    const bool is_there = stat(source, &file) == 0;
    (void)clock_gettime(CLOCK_REALTIME_COARSE, &now);
    for (int i = 0; i < 20 && is_there && !is_before(file.st_mtim, now); i++) {
        (void)nanosleep(&pause, NULL);
        (void)clock_gettime(CLOCK_REALTIME_COARSE, &now);
    }
    return now;
}

enum { DIGITS = 32 }; /* of a hash, as text */

static inline void hash_text(const hash h, char text[DIGITS + 1])
{
    snprintf(text, DIGITS + 1, "%016" PRIx64 "%016" PRIx64, h.a, h.b);
}

#endif
