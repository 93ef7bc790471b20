/* Compiles every source once, whichever test asks for it: a compiler in front of the compiler.
 *
 *     COMPILER ARGUMENT...
 *
 * A folder of links to this program, one named like each compiler, stands first in the PATH of the tests; the compilers
 * themselves are the links beside it in real/, the objects in store/. An object is kept under a hash of all that it follows
 * from: the compiler's file, its flags, the name of the source and the preprocessed source. A source in a command that
 * links as well is compiled for itself. What the hash does not cover goes to the compiler as it is: debug information, which
 * names folders; output that is no object; several files or languages.
 *
 * The preprocessor is asked only where no list answers: for a command and the text of its source a list says, for every time
 * that it was preprocessed, which files were read, with a hash of each, and which object came of it. If all of them are as
 * they were, it is the same object. A file of the same name that would be found before one of them is not seen.
 */
#ifndef _XOPEN_SOURCE
#define _XOPEN_SOURCE 700 /* realpath */
#endif
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <limits.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { ARGUMENTS = 512, BUFFER = 1 << 16 };

static char folder[PATH_MAX];   /* of this program */
static char compiler[PATH_MAX]; /* the real one */

_Noreturn static void fail(const char *const what)
{
    fprintf(stderr, "once: %s: %s\n", what, strerror(errno));
    exit(EXIT_FAILURE);
}

/* FNV-1a (Fowler, Noll, Vo), two of 64 bits from different starts. */
typedef struct hash {
    uint64_t a, b;
} hash;

static void hash_add(hash *const h, const void *const bytes, const size_t count)
{
    for (const unsigned char *at = bytes, *const end = at + count; at < end; at++) {
        h->a = (h->a ^ *at) * UINT64_C(0x100000001B3);
        h->b = (h->b ^ *at) * UINT64_C(0x10000000233) + 1;
    }
}

/* Runs the compiler. Returns its exit status. */
static int run(char **const arguments)
{
    const pid_t child = fork();
    if (child == 0) {
        execv(compiler, arguments);
        fail(compiler);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : EXIT_FAILURE;
}

static bool ends_with(const char *const text, const char *const end)
{
    const size_t length = strlen(text), tail = strlen(end);
    return length > tail && strcmp(text + length - tail, end) == 0;
}

static bool begins_with(const char *const text, const char *const start)
{
    return strncmp(text, start, strlen(start)) == 0;
}

/* A command taken apart; `words` has it without sources, -c and -o. */
typedef struct command {
    char *words[ARGUMENTS];
    char *sources[ARGUMENTS];
    const char *output;
    int word_count, source_count;
    bool compiles, kept; /* -c; whether the store may keep what it makes */
} command;

static bool takes_value(const char *const word)
{
    static const char *const with[] = {"-I",  "-D",  "-U", "-include", "-isystem", "-iquote",
                                       "-MF", "-MT", "-T", "-L",       "-l",       "-Xlinker"};
    for (size_t i = 0; i < sizeof with / sizeof with[0]; i++) {
        if (strcmp(word, with[i]) == 0) {
            return true;
        }
    }
    return false;
}

/* What changes an object without a trace in the preprocessed source, or makes other files than the object. */
static bool beyond_hash(const char *const word)
{
    return begins_with(word, "-g") || strcmp(word, "-S") == 0 || strcmp(word, "-E") == 0 || strcmp(word, "-x") == 0 ||
           strcmp(word, "-") == 0 || begins_with(word, "-save") || begins_with(word, "-fcallgraph") ||
           begins_with(word, "-fprofile") || begins_with(word, "-fsyntax") || begins_with(word, "-print") ||
           begins_with(word, "-fsanitize") || begins_with(word, "-M") || begins_with(word, "@") ||
           ends_with(word, ".s") || ends_with(word, ".S") || begins_with(word, "--coverage") ||
           begins_with(word, "-flto");
}

static command take_apart(const int argc, char **const argv)
{
    command c = {.kept = argc < ARGUMENTS - 8};
    c.words[c.word_count++] = argv[0];
    for (int i = 1; i < argc && c.kept; i++) {
        const bool depends = strcmp(argv[i], "-MMD") == 0 || strcmp(argv[i], "-MP") == 0;
        if (strcmp(argv[i], "-c") == 0) {
            c.compiles = true;
        } else if (strcmp(argv[i], "-o") == 0 && i + 1 < argc) {
            c.output = argv[++i];
        } else if (argv[i][0] != '-' && ends_with(argv[i], ".c")) {
            c.sources[c.source_count++] = argv[i];
        } else {
            c.kept = depends || !beyond_hash(argv[i]);
            c.words[c.word_count++] = argv[i];
            if (takes_value(argv[i]) && i + 1 < argc) {
                c.words[c.word_count++] = argv[++i];
            }
        }
    }
    c.kept = c.kept && c.output != NULL && c.source_count > 0 && (!c.compiles || c.source_count == 1) &&
             !begins_with(c.output, "/dev/");
    return c;
}

static bool is_for_linker(const char *const word)
{
    return begins_with(word, "-l") || begins_with(word, "-Wl,") || begins_with(word, "-L") || begins_with(word, "-T") ||
           begins_with(word, "--specs") || strcmp(word, "-nostartfiles") == 0 || word[0] != '-';
}

/* The flags of a compilation: those of the command without what is the linker's. They are added to a hash of all, and to
 * another but for those that the preprocessed source shows. */
static int flags_of(const command *const c, char **const flags, hash *const all, hash *const h)
{
    int count = 0;
    for (int i = 0; i < c->word_count; i++) {
        const bool value = takes_value(c->words[i]) && i + 1 < c->word_count;
        if (i == 0 || !is_for_linker(c->words[i])) {
            flags[count++] = c->words[i];
            hash_add(all, c->words[i], strlen(c->words[i]) + 1);
            if (value) {
                flags[count++] = c->words[i + 1];
                hash_add(all, c->words[i + 1], strlen(c->words[i + 1]) + 1);
            }
            if (i > 0 && !value && !begins_with(c->words[i], "-I") && !begins_with(c->words[i], "-D") &&
                !begins_with(c->words[i], "-M")) {
                hash_add(h, c->words[i], strlen(c->words[i]) + 1);
            }
        }
        i += value;
    }
    return count;
}

/* The files that a preprocessor read. */
typedef struct reading {
    char text[BUFFER]; /* their names, each behind 's' for a header of the system or 'p', and ended by a zero */
    size_t length;
    bool whole; /* whether all are there */
} reading;

/* Adds the file of a line marker: # LINE "NAME" FLAG..., of which 3 says that it is the system's. */
static void read_marker(reading *const files, const char *const line)
{
    const char *const quote = strchr(line, '"');
    const char *const end = quote == NULL ? NULL : strchr(quote + 1, '"');
    if (end == NULL || quote[1] == '<' || end[-1] == '/') {
        return; /* no file */
    }
    const char *const name = begins_with(quote + 1, "./") ? quote + 3 : quote + 1;
    const size_t length = (size_t)(end - name);
    for (const char *at = files->text; at < files->text + files->length; at += strlen(at) + 1) {
        if (strlen(at + 1) == length && memcmp(at + 1, name, length) == 0) {
            return;
        }
    }
    files->whole = files->whole && files->length + length + 2 <= sizeof files->text &&
                   strcspn(name, " \\$#:\"") == length; /* which make would read otherwise */
    if (files->whole) {
        char *const to = files->text + files->length;
        to[0] = strstr(end, " 3") == NULL ? 'p' : 's';
        memcpy(to + 1, name, length);
        to[length + 1] = '\0';
        files->length += length + 2;
    }
}

/* The file in which make looks for what the object depends on, or no name if the flags ask for none. */
static void name_dependencies(char **const flags, const int count, const char *const object, char name[PATH_MAX])
{
    name[0] = '\0';
    for (int i = 1; i < count; i++) {
        if (strcmp(flags[i], "-MMD") == 0) {
            snprintf(name, PATH_MAX - 2, "%s", object);
            char *const dot = strrchr(name, '.');
            snprintf(dot == NULL ? name + strlen(name) : dot, 3, ".d");
        }
    }
}

/* Adds the preprocessed source to the hash, without markers and empty lines, and tells what was read. With -MMD that also
 * writes the list of what the object depends on. */
static bool hash_source(char **const flags, int count, char *const source, const char *const object, hash *const h,
                        reading *const files)
{
    char dependencies[PATH_MAX];
    name_dependencies(flags, count, object, dependencies);
    if (dependencies[0] != '\0') {
        flags[count++] = (char *)"-MF";
        flags[count++] = dependencies;
        flags[count++] = (char *)"-MT";
        flags[count++] = (char *)object;
    }
    flags[count++] = (char *)"-E";
    flags[count++] = source;
    flags[count] = NULL;

    int ends[2];
    if (pipe(ends) != 0) {
        fail("pipe");
    }
    const pid_t child = fork();
    if (child == 0) {
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(ends[1], STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
        close(ends[0]);
        close(ends[1]);
        execv(compiler, flags);
        _exit(EXIT_FAILURE);
    }
    close(ends[1]);
    FILE *const out = fdopen(ends[0], "r");
    if (out == NULL) {
        fail("pipe");
    }
    char *line = NULL;
    size_t room = 0;
    files->length = 0;
    files->whole = true;
    for (ssize_t length = 0; (length = getline(&line, &room, out)) > 0;) {
        if (line[0] == '#' && line[1] == ' ') {
            read_marker(files, line);
        } else if (length > 1) {
            hash_add(h, line, (size_t)length);
        }
    }
    free(line);
    fclose(out);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

static bool copy(const char *const from, const char *const to)
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

#define TICK INT64_C(10000000)

static int64_t nanoseconds(const struct timespec t)
{
    return (int64_t)t.tv_sec * 1000000000 + t.tv_nsec;
}

/* Adds a file: its text, or of one of the system its size and its date. False if there is none, or if its date is not before
 * `begun`: then it may be another than the one that was read. Dates of files lag by a tick of the system. */
static bool hash_file(const char kind, const char *const name, const struct timespec begun, hash *const h)
{
    static char bytes[BUFFER];
    struct stat file;
    const int in = open(name, O_RDONLY);
    bool read_all = in >= 0 && fstat(in, &file) == 0 && nanoseconds(file.st_mtim) + TICK < nanoseconds(begun);
    if (read_all && kind == 's') {
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

static const hash hash_start = {UINT64_C(0xCBF29CE484222325), UINT64_C(0x84222325CBF29CE4)};

enum { DIGITS = 32 }; /* of a hash, as text */

static void hash_text(const hash h, char text[DIGITS + 1])
{
    snprintf(text, DIGITS + 1, "%016" PRIx64 "%016" PRIx64, h.a, h.b);
}

/* A list has for each time a line "= OBJECT", a line "KIND HASH NAME" for each file, and a line ".". */
static void list_append(const char *const list, const char *const object, const reading *const files,
                        const struct timespec begun)
{
    static char text[2 * BUFFER];
    char digits[DIGITS + 1];
    size_t length = (size_t)snprintf(text, sizeof text, "= %s\n", object);
    for (const char *at = files->text; at < files->text + files->length; at += strlen(at) + 1) {
        hash h = hash_start;
        if (length + strlen(at) + DIGITS + 8 > sizeof text || !hash_file(at[0], at + 1, begun, &h)) {
            return;
        }
        hash_text(h, digits);
        length += (size_t)snprintf(text + length, sizeof text - length, "%c %s %s\n", at[0], digits, at + 1);
    }
    length += (size_t)snprintf(text + length, sizeof text - length, ".\n");
    const int out = open(list, O_WRONLY | O_CREAT | O_APPEND, 0666);
    if (out >= 0) {
        (void)!write(out, text, length);
        close(out);
    }
}

/* Whether the list has a time at which all files were what they are: the object that came of it, and the files. */
static bool list_find(const char *const list, char object[DIGITS + 1], reading *const files,
                      const struct timespec begun)
{
    FILE *const in = fopen(list, "r");
    char *line = NULL, digits[DIGITS + 1];
    size_t room = 0;
    bool same = false, found = false;
    for (ssize_t length = 0; in != NULL && !found && (length = getline(&line, &room, in)) > 0;) {
        line[length - 1] = '\0';
        if (line[0] == '=' && length == DIGITS + 3) {
            strcpy(object, line + 2);
            files->length = 0;
            same = true;
        } else if (line[0] == '.') {
            found = same;
        } else if (same && length > DIGITS + 4) {
            hash h = hash_start;
            const char *const name = line + DIGITS + 3;
            const size_t size = strlen(name) + 2;
            same = files->length + size <= sizeof files->text && hash_file(line[0], name, begun, &h);
            hash_text(h, digits);
            same = same && memcmp(line + 2, digits, DIGITS) == 0;
            if (same) {
                files->text[files->length] = line[0];
                memcpy(files->text + files->length + 1, name, size - 1);
                files->length += size;
            }
        }
    }
    free(line);
    if (in != NULL) {
        (void)futimens(fileno(in), NULL); /* its last use */
        fclose(in);
    }
    return found;
}

/* Writes for make what the object depends on. A file that is gone is then no error. */
static bool write_dependencies(const char *const name, const char *const object, const reading *const files)
{
    FILE *const out = fopen(name, "w");
    if (out == NULL) {
        return false;
    }
    fprintf(out, "%s:", object);
    for (int round = 0; round < 2; round++) {
        for (const char *at = files->text; at < files->text + files->length; at += strlen(at) + 1) {
            if (at[0] == 'p' && (round == 0 || at > files->text)) {
                fprintf(out, round == 0 ? " %s" : "%s:\n", at + 1);
            }
        }
        fprintf(out, "\n");
    }
    return fclose(out) == 0;
}

/* Compiles one source of the command to the object, or takes it from the store. Makes of one object at once wait for the
 * first. Returns the compiler's status. */
static int compile(const command *const c, char *const source, const char *const object)
{
    static reading files;
    char *flags[ARGUMENTS];
    char dependencies[PATH_MAX], digits[DIGITS + 1];
    char kept[PATH_MAX + 64], made[PATH_MAX + 96], lock[PATH_MAX + 96], list[PATH_MAX + 64];
    struct stat file;
    struct timespec begun;
    hash h = hash_start;
    if (stat(compiler, &file) != 0 || clock_gettime(CLOCK_REALTIME, &begun) != 0) {
        fail(compiler);
    }
    hash_add(&h, compiler, strlen(compiler));
    hash_add(&h, &file.st_size, sizeof file.st_size);
    hash_add(&h, &file.st_mtime, sizeof file.st_mtime);
    hash all = h;
    int count = flags_of(c, flags, &all, &h);
    hash_add(&all, source, strlen(source) + 1);
    const bool listed = hash_file('p', source, begun, &all);
    hash_text(all, digits);
    snprintf(list, sizeof list, "%s/store/%s.list", folder, digits);
    name_dependencies(flags, count, object, dependencies);
    if (listed && list_find(list, digits, &files, begun)) {
        snprintf(kept, sizeof kept, "%s/store/%s.o", folder, digits);
        if (copy(kept, object) && (dependencies[0] == '\0' || write_dependencies(dependencies, object, &files))) {
            return EXIT_SUCCESS;
        }
    }

    const char *const slash = strrchr(source, '/');
    const char *const base = slash == NULL ? source : slash + 1; /* which the object names */
    hash_add(&h, base, strlen(base) + 1);
    const bool known = hash_source(flags, count, source, object, &h, &files);
    hash_text(h, digits);
    snprintf(kept, sizeof kept, "%s/store/%s.o", folder, digits);
    snprintf(made, sizeof made, "%s.%ld", kept, (long)getpid());
    snprintf(lock, sizeof lock, "%s/store/lock", folder);

    /* One byte of the lock for each hash. */
    const int locked = known ? open(lock, O_WRONLY | O_CREAT, 0666) : -1;
    struct flock byte = {.l_type = F_WRLCK, .l_whence = SEEK_SET, .l_start = (off_t)(h.a >> 2), .l_len = 1};
    if (locked >= 0) {
        (void)fcntl(locked, F_SETLKW, &byte);
    }
    int status = EXIT_SUCCESS;
    bool stored = known && copy(kept, object);
    if (!stored) {
        flags[count++] = (char *)"-c";
        flags[count++] = source;
        flags[count++] = (char *)"-o";
        flags[count++] = (char *)object;
        flags[count] = NULL;
        status = run(flags);
        stored = status == EXIT_SUCCESS && known && copy(object, made) && rename(made, kept) == 0;
    }
    if (stored && listed && files.whole) {
        list_append(list, digits, &files, begun);
    }
    if (locked >= 0) {
        close(locked);
    }
    return status;
}

/* Links what the sources of the command give. */
static int compile_and_link(const command *const c)
{
    static char objects[ARGUMENTS][PATH_MAX];
    char *words[2 * ARGUMENTS];
    int count = 0, status = EXIT_SUCCESS;
    for (int i = 0; i < c->source_count && status == EXIT_SUCCESS; i++) {
        snprintf(objects[i], sizeof objects[i], "%s.%ld.%d.o", c->output, (long)getpid(), i);
        status = compile(c, c->sources[i], objects[i]);
    }
    words[count++] = c->words[0];
    for (int i = 0; i < c->source_count; i++) {
        words[count++] = objects[i];
    }
    for (int i = 1; i < c->word_count; i++) {
        words[count++] = c->words[i];
    }
    words[count++] = (char *)"-o";
    words[count++] = (char *)c->output;
    words[count] = NULL;
    status = status == EXIT_SUCCESS ? run(words) : status;
    for (int i = 0; i < c->source_count; i++) {
        (void)unlink(objects[i]);
    }
    return status;
}

int main(int argc, char **argv)
{
    const char *const slash = strrchr(argv[0], '/');
    const char *const name = slash == NULL ? argv[0] : slash + 1;
    const ssize_t length = readlink("/proc/self/exe", folder, sizeof folder - 1);
    char *const end = length > 0 ? strrchr(folder, '/') : NULL;
    char link[PATH_MAX + 16];
    if (end == NULL) {
        fail("/proc/self/exe");
    }
    *end = '\0';
    snprintf(link, sizeof link, "%s/real/%s", folder, name);
    if (argc < 1 || realpath(link, compiler) == NULL) {
        fail(link);
    }
    argv[0] = compiler; /* by which it finds its own parts */
    const command c = take_apart(argc, argv);
    if (!c.kept) {
        execv(compiler, argv);
        fail(compiler);
    }
    return c.compiles ? compile(&c, c.sources[0], c.output) : compile_and_link(&c);
}
