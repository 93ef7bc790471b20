#include "tools/isoc/emit/write.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tools/isoc/base/embedded.h"

void file_list_add(file_list *files, const char *path, const text *t)
{
    ADD_TO(files->memory, files->files, files->count, files->room,
           ((file_text){arena_format(files->memory, "%s/%s", files->folder, path), *t}));
}

void file_list_fill(file_list *files, const char *path, const char *template, const filling *fillings)
{
    text result = {.memory = files->memory};
    text_fill(&result, embedded_text(client_files, template), fillings);
    file_list_add(files, path, &result);
}

const char *compiler_flags(arena *memory, flag_line which)
{
    const char *line = embedded_text(client_files, "tools/build/numerics");
    for (int i = 0; i < (int)which; i++) {
        line = strchr(line, '\n') + 1;
    }
    return arena_copy(memory, line, strcspn(line, "\n"));
}

bool file_list_has(const file_list *files, const char *path)
{
    const char *whole = arena_format(files->memory, "%s/%s", files->folder, path);
    bool any = false;
    FOR_ALL (const file_text, f, files->files, files->count) {
        any = any || strcmp(f->path, whole) == 0;
    }
    return any;
}

static bool complain(const char *path)
{
    fprintf(stderr, "%s: error: %s\n", path, strerror(errno));
    return false;
}

/* Makes the folders that a file stands in. */
static bool make_folders(arena *memory, const char *path)
{
    char *partial = arena_copy(memory, path, strlen(path));
    for (char *slash = partial + 1; *slash != '\0'; slash++) {
        if (*slash == '/') {
            *slash = '\0';
            if (mkdir(partial, 0777) != 0 && errno != EEXIST) {
                return complain(partial);
            }
            *slash = '/';
        }
    }
    return true;
}

/* The name of a new file until all are written, and of an old one until all are replaced; another isoc has other names.
 */
static const char *name_of_age(arena *memory, const char *path, const char *age)
{
    return arena_format(memory, "%s.%ld.%s", path, (long)getpid(), age);
}

/* Writes a file to the disk beside the one that it will replace, which must be no folder. */
static bool write_beside(arena *memory, const file_text *f)
{
    struct stat there;
    if (!make_folders(memory, f->path)) {
        return false;
    }
    if (stat(f->path, &there) == 0 && S_ISDIR(there.st_mode)) {
        errno = EISDIR;
        return complain(f->path);
    }
    FILE *file = fopen(name_of_age(memory, f->path, "new"), "wb");
    if (file == NULL) {
        return complain(f->path);
    }
    const bool whole = fwrite(f->text.bytes, 1, f->text.length, file) == f->text.length && fflush(file) == 0 &&
                       fsync(fileno(file)) == 0;
    const int why = errno;
    const bool closed = fclose(file) == 0;
    errno = whole ? errno : why;
    return (whole && closed) || complain(f->path);
}

/* Gives a new file its name; the old file keeps another name. */
static bool replace(arena *memory, const char *path)
{
    const char *old = name_of_age(memory, path, "old");
    const bool kept = link(path, old) == 0 || errno == ENOENT || rename(path, old) == 0; /* not all have links */
    return (kept && rename(name_of_age(memory, path, "new"), path) == 0) || complain(path);
}

/* Undoes the replacement of a file, whole or begun. */
static void take_back(arena *memory, const char *path, bool was_replaced)
{
    if (rename(name_of_age(memory, path, "old"), path) != 0 && was_replaced) {
        remove(path);
    }
}

/* Whether a file has this text already. It then keeps its date, by which make sees what has changed. */
static bool is_the_same(arena *memory, const file_text *f)
{
    struct stat there;
    FILE *file = stat(f->path, &there) == 0 && there.st_size == (off_t)f->text.length ? fopen(f->path, "rb") : NULL;
    if (file == NULL) {
        return false;
    }
    char *bytes = arena_take(memory, f->text.length + 1, 1);
    const bool same =
        fread(bytes, 1, f->text.length, file) == f->text.length && memcmp(bytes, f->text.bytes, f->text.length) == 0;
    fclose(file);
    return same;
}

/* Those of the files that are other on the disk. */
static file_list changed_of(const file_list *files)
{
    file_list changed = {.memory = files->memory};
    FOR_ALL (const file_text, f, files->files, files->count) {
        if (!is_the_same(files->memory, f)) {
            ADD_TO(changed.memory, changed.files, changed.count, changed.room, *f);
        }
    }
    return changed;
}

bool write_files(const file_list *all)
{
    const file_list changed = changed_of(all), *files = &changed;
    arena *memory = files->memory;
    size_t written = 0, replaced = 0;
    signal(SIGXFSZ, SIG_IGN); /* a file that grows too large is reported like a full disk */
    while (written < files->count && write_beside(memory, &files->files[written])) {
        written++;
    }
    while (written == files->count && replaced < files->count && replace(memory, files->files[replaced].path)) {
        replaced++;
    }
    const bool good = replaced == files->count;
    for (size_t i = 0; i < files->count; i++) {
        const char *path = files->files[i].path;
        if (!good) {
            take_back(memory, path, i < replaced);
            remove(name_of_age(memory, path, "new"));
        }
        remove(name_of_age(memory, path, "old"));
    }
    return good;
}

bool write_file(arena *memory, const char *path, const text *t)
{
    file_text file = {path, *t};
    return write_files(&(file_list){.memory = memory, .files = &file, .count = 1});
}

bool write_out(const char *bytes, size_t length)
{
    const bool good = fwrite(bytes, 1, length, stdout) == length && fflush(stdout) == 0;
    if (!good) {
        fprintf(stderr, "isoc: error: standard output: %s\n", strerror(errno));
    }
    return good;
}
