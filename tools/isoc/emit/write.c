#include "tools/isoc/emit/write.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

bool write_folder(arena *memory, const char *path)
{
    char *partial = arena_copy(memory, path, strlen(path));
    for (char *slash = partial + 1; *slash != '\0'; slash++) {
        if (*slash == '/') {
            *slash = '\0';
            mkdir(partial, 0777);
            *slash = '/';
        }
    }
    if (mkdir(path, 0777) != 0 && errno != EEXIST) {
        fprintf(stderr, "%s: error: %s\n", path, strerror(errno));
        return false;
    }
    return true;
}

bool write_file(arena *memory, const char *folder, const char *base, const text *t)
{
    const char *path = arena_format(memory, "%s/%s", folder, base);
    const char *beside = arena_format(memory, "%s.new", path);
    FILE *file = fopen(beside, "wb");
    bool good = file != NULL && fwrite(t->bytes, 1, t->length, file) == t->length;
    good = file != NULL && fclose(file) == 0 && good;
    good = good && rename(beside, path) == 0;
    if (!good) {
        fprintf(stderr, "%s: error: %s\n", path, strerror(errno));
        remove(beside);
    }
    return good;
}

bool write_out(const char *bytes, size_t length)
{
    const bool good = fwrite(bytes, 1, length, stdout) == length && fflush(stdout) == 0;
    if (!good) {
        fprintf(stderr, "isoc: error: standard output: %s\n", strerror(errno));
    }
    return good;
}
