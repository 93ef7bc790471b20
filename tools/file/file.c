#define _POSIX_C_SOURCE 200809L
#include "tools/file/file.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

void quit(const char *const format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    exit(EXIT_FAILURE);
}

void *memory_for(const size_t count, const size_t bytes)
{
    void *const memory = calloc(count > 0 ? count : 1, bytes);
    if (memory == NULL) {
        quit("there is no memory");
    }
    return memory;
}

void *room_behind(void *const items, const size_t count, const size_t bytes)
{
    /* A power of two has as many behind it. Items may have no bytes. */
    void *const more = (count & (count - 1)) != 0 ? items : realloc(items, (2 * count + 1) * (bytes + 1));
    if (more == NULL) {
        quit("there is no memory");
    }
    return more;
}

char *file_rest(FILE *const from, size_t *const bytes)
{
    enum { BLOCK_BYTES = 1 << 16 };
    char *text = NULL;
    size_t blocks = 0;
    *bytes = 0;
    for (size_t got = 1; got > 0; *bytes += got) {
        if (*bytes + 1 >= blocks * BLOCK_BYTES) {
            text = room_behind(text, blocks++, BLOCK_BYTES);
        }
        got = fread(text + *bytes, 1, blocks * BLOCK_BYTES - *bytes - 1, from);
    }
    if (ferror(from) != 0) {
        free(text);
        return NULL;
    }
    text[*bytes] = '\0';
    return text;
}

char *file_content(const char *const path, size_t *const bytes)
{
    FILE *const from = fopen(path, "rb");
    char *const text = from == NULL ? NULL : file_rest(from, bytes);
    const int why = errno;
    if (from != NULL) {
        fclose(from);
    }
    errno = why;
    return text;
}

bool file_begin(new_file *const f, const char *const folder, const char *const name, const char *const suffix)
{
    f->to = NULL;
    const bool has_folder = folder != NULL;
    if (snprintf(f->path, sizeof f->path, "%s%s%s", has_folder ? folder : "", has_folder ? "/" : "", name) >=
            (int)sizeof f->path ||
        snprintf(f->partial, sizeof f->partial, "%s.%s", f->path, suffix) >= (int)sizeof f->partial) {
        errno = ENAMETOOLONG;
        return false;
    }
    f->to = fopen(f->partial, "wb");
    return f->to != NULL;
}

bool file_end(new_file *const f)
{
    const bool is_written = ferror(f->to) == 0, is_closed = fclose(f->to) == 0;
    f->to = NULL;
    if (is_written && is_closed && rename(f->partial, f->path) == 0) {
        return true;
    }
    const int why = errno;
    file_drop(f);
    errno = why;
    return false;
}

void file_drop(new_file *const f)
{
    if (f->to != NULL) {
        fclose(f->to);
    }
    (void)remove(f->partial);
}

void file_must_begin(new_file *const f, const char *const program, const char *const folder, const char *const name,
                     const char *const suffix)
{
    if (!file_begin(f, folder, name, suffix)) {
        quit("%s: %s: %s", program, f->path, strerror(errno));
    }
}

void file_must_end(new_file *const f, const char *const program)
{
    if (!file_end(f)) {
        quit("%s: %s: %s", program, f->path, strerror(errno));
    }
}

double seconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
