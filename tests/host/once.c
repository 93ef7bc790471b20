/* Compiles every source once, whichever test asks for it: a compiler in front of the compiler.
 *
 *     COMPILER ARGUMENT...
 *
 * A folder of links to this program, one named like each compiler, stands first in the PATH of the tests; the compilers
 * themselves are the links beside it in real/, the objects in store/. An object is kept under a hash of all that it
 * follows from: the compiler's file, its flags, the name and the text of the source, and all files that it includes. A
 * source in a command that links as well is compiled for itself. What the hash does not cover goes to the compiler as
 * it is: debug information, which names folders; output that is no object; several files or languages.
 *
 * Which files a source includes the compiler says when it compiles it. For a command and the text of its source a list
 * says, for every time that it was compiled, which files were read, with a hash of each, and which object came of it.
 * If all of them are as they were, it is the same object, in whichever folder the source stands; unless the object
 * names the folder. A file of the same name that would be found before one of them is seen beside the source only.
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
    command c = {.kept = argc < ARGUMENTS - 16};
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
           strcmp(word, "-nostartfiles") == 0 || word[0] != '-';
}

/* The flags of a compilation: those of the command without what is the linker's, and what asks for a list for make;
 * folders of headers last, wherever they stood. They are added to the hash. */
static int flags_of(const command *const c, char **const flags, hash *const h)
{
    int count = 0;
    for (int folders = 0; folders < 2; folders++) {
        for (int i = 0, words = 1; i < c->word_count; i += words) {
            const char *const word = c->words[i];
            const bool passes = i == 0 || !(is_for_linker(word) || begins_with(word, "-M"));
            words = takes_value(word) && i + 1 < c->word_count ? 2 : 1;
            for (int j = i; j < i + words && passes && begins_with(word, "-I") == (folders == 1); j++) {
                flags[count++] = c->words[j];
                hash_add(h, c->words[j], strlen(c->words[j]) + 1);
            }
        }
    }
    return count;
}

/* The files that a source includes. */
typedef struct reading {
    char text[BUFFER]; /* their names, each behind its kind, and ended by a zero */
    size_t length;
    bool whole; /* whether all are there */
} reading;

/* Kinds of files: of the system; beside the source, named from there; others. */
enum { OF_SYSTEM = 's', BESIDE = 'l', OTHER = 'p' };

static void reading_add(reading *const files, const char kind, const char *const name, const size_t length)
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
static bool read_includes(const char *const list, const char *const place, reading *const files)
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

/* The file in which make looks for what the object depends on, or no name if the command asks for none. */
static void name_dependencies(const command *const c, const char *const object, char name[PATH_MAX])
{
    name[0] = '\0';
    for (int i = 1; i < c->word_count; i++) {
        if (strcmp(c->words[i], "-MMD") == 0) {
            snprintf(name, PATH_MAX - 2, "%s", object);
            char *const dot = strrchr(name, '.');
            snprintf(dot == NULL ? name + strlen(name) : dot, 3, ".d");
        }
    }
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

static bool is_before(const struct timespec a, const struct timespec b)
{
    return a.tv_sec < b.tv_sec || (a.tv_sec == b.tv_sec && a.tv_nsec < b.tv_nsec);
}

/* Adds a file: its text, or of one of the system its size and its date. False if there is none, or if its date is not
 * before
 * `*before`, if that is given: then it may be another than the one that was read. */
static bool hash_file(const char kind, const char *const name, const struct timespec *const before, hash *const h)
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
static struct timespec begin_after(const char *const source)
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

static const hash hash_start = {UINT64_C(0xCBF29CE484222325), UINT64_C(0x84222325CBF29CE4)};

enum { DIGITS = 32 }; /* of a hash, as text */

static void hash_text(const hash h, char text[DIGITS + 1])
{
    snprintf(text, DIGITS + 1, "%016" PRIx64 "%016" PRIx64, h.a, h.b);
}

/* What is compiled: the source, its folder with a slash, and the flags, the first of which is the compiler. */
typedef struct task {
    char *source, *flags[ARGUMENTS];
    char place[PATH_MAX];
    int count;
    hash text, key;              /* of the source; of all but what the source includes */
    char list[2][PATH_MAX + 64]; /* of objects that do not name the folder, and of those that do */
    char dependencies[PATH_MAX]; /* for make, or no name */
} task;

/* The path of a file of the store. */
static void name_kept(char path[PATH_MAX + 64], const char *const digits, const char *const end)
{
    snprintf(path, PATH_MAX + 64, "%s/store/%s%s", folder, digits, end);
}

/* The path of a file that is read, as it is named for this source. */
static const char *path_of(const task *const t, const char kind, const char *const name)
{
    static char path[2 * PATH_MAX];
    if (kind != BESIDE) {
        return name;
    }
    snprintf(path, sizeof path, "%s%s", t->place, name);
    return path;
}

/* Whether beside the source stands a file that it would include in place of this one, which a folder of -I has. */
static bool is_hidden(const task *const t, const char *const name)
{
    struct stat file;
    for (int i = 1; i < t->count && t->place[0] != '\0'; i++) {
        if (begins_with(t->flags[i], "-I")) {
            const char *const from = t->flags[i][2] == '\0' && i + 1 < t->count ? t->flags[i + 1] : t->flags[i] + 2;
            const size_t length = strlen(from);
            const bool is_in = strncmp(name, from, length) == 0 && name[length] == '/';
            if ((is_in || strcmp(from, ".") == 0) &&
                stat(path_of(t, BESIDE, is_in ? name + length + 1 : name), &file) == 0) {
                return true;
            }
        }
    }
    return false;
}

/* Writes what came of this time: a line "= OBJECT", a line "KIND HASH NAME" for each file, and a line ".". The object
 * gets its name, a hash of all that it follows from. False if a file may have changed since `begun`. */
static bool list_append(const task *const t, const bool named, const reading *const files, const char *const object,
                        const struct timespec begun)
{
    static char text[2 * BUFFER];
    char digits[DIGITS + 1], kept[PATH_MAX + 64], made[PATH_MAX + 96];
    hash of_object = t->key;
    size_t length = DIGITS + 3;
    hash_add(&of_object, t->place, named ? strlen(t->place) : 0);
    for (const char *at = files->text; at < files->text + files->length; at += strlen(at) + 1) {
        hash h = hash_start;
        if (length + strlen(at) + DIGITS + 8 > sizeof text ||
            !hash_file(at[0], path_of(t, at[0], at + 1), &begun, &h)) {
            return false;
        }
        hash_text(h, digits);
        hash_add(&of_object, digits, DIGITS);
        hash_add(&of_object, at, strlen(at) + 1);
        length += (size_t)snprintf(text + length, sizeof text - length, "%c %s %s\n", at[0], digits, at + 1);
    }
    length += (size_t)snprintf(text + length, sizeof text - length, ".\n");
    hash_text(of_object, digits);
    memcpy(text, "= ", 2);
    memcpy(text + 2, digits, DIGITS);
    text[DIGITS + 2] = '\n';
    name_kept(kept, digits, ".o");
    snprintf(made, sizeof made, "%s.%ld", kept, (long)getpid());
    const int out =
        copy(object, made) && rename(made, kept) == 0 ? open(t->list[named], O_WRONLY | O_CREAT | O_APPEND, 0666) : -1;
    const bool written = out >= 0 && write(out, text, length) == (ssize_t)length;
    return out >= 0 && close(out) == 0 && written;
}

/* Whether the list has a time at which all files were what they are: the object that came of it, and the files. */
static bool list_find(const task *const t, const char *const list, char object[DIGITS + 1], reading *const files)
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
            files->whole = same = true;
        } else if (line[0] == '.') {
            found = same;
        } else if (same && length > DIGITS + 4) {
            hash h = hash_start;
            const char *const name = line + DIGITS + 3;
            same = hash_file(line[0], path_of(t, line[0], name), NULL, &h) && !(line[0] == OTHER && is_hidden(t, name));
            hash_text(h, digits);
            same = same && memcmp(line + 2, digits, DIGITS) == 0;
            reading_add(files, line[0], name, strlen(name));
            same = same && files->whole;
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
static bool write_dependencies(const task *const t, const char *const object, const reading *const files)
{
    FILE *const out = fopen(t->dependencies, "w");
    if (out == NULL) {
        return false;
    }
    fprintf(out, "%s: %s", object, t->source);
    for (int round = 0; round < 2; round++) {
        for (const char *at = files->text; at < files->text + files->length; at += strlen(at) + 1) {
            if (at[0] != OF_SYSTEM) {
                fprintf(out, round == 0 ? " %s" : "%s:\n", path_of(t, at[0], at + 1));
            }
        }
        fprintf(out, "\n");
    }
    return fclose(out) == 0;
}

/* Takes the object from the store, if that has it. */
static bool take(const task *const t, const char *const object)
{
    static reading files;
    char digits[DIGITS + 1], kept[PATH_MAX + 64];
    for (int i = 0; i < 2; i++) {
        if (list_find(t, t->list[i], digits, &files)) {
            name_kept(kept, digits, ".o");
            if (copy(kept, object) && (t->dependencies[0] == '\0' || write_dependencies(t, object, &files))) {
                return true;
            }
        }
    }
    return false;
}

/* Whether the object names the folder, as one with __FILE__ does. */
static bool names_place(const char *const object, const char *const place)
{
    bool found = false;
    struct stat file;
    const size_t length = strlen(place);
    const int in = open(object, O_RDONLY);
    char *const bytes = in >= 0 && fstat(in, &file) == 0 ? malloc((size_t)file.st_size + 1) : NULL;
    if (bytes == NULL || read(in, bytes, (size_t)file.st_size) != file.st_size) {
        fail(object);
    }
    const char *const end = bytes + file.st_size;
    for (const char *at = bytes; length > 0 && !found && (at = memchr(at, place[0], (size_t)(end - at))) != NULL;
         at++) {
        found = (size_t)(end - at) >= length && memcmp(at, place, length) == 0;
    }
    free(bytes);
    close(in);
    return found;
}

/* Has the compiler make the object and say what the source includes, and keeps it. Where that cannot be read, the
 * compiler writes the list for make itself. Returns its status. */
static int make(task *const t, const char *const object)
{
    static reading files;
    char includes[PATH_MAX + 96];
    const struct timespec begun = begin_after(t->source);
    char **const further = t->flags + t->count;
    hash text = hash_start;
    snprintf(includes, sizeof includes, "%s/store/%ld.d", folder, (long)getpid());
    const char *const told[] = {"-c", t->source, "-o", object, "-MD", "-MF", includes, "-MT", "object", NULL};
    memcpy(further, told, sizeof told);
    int status = run(t->flags);
    const bool known = status == EXIT_SUCCESS && read_includes(includes, t->place, &files);
    (void)unlink(includes);
    if (status == EXIT_SUCCESS && t->dependencies[0] != '\0' && !(known && write_dependencies(t, object, &files))) {
        const char *const plain[] = {"-MMD", "-MP", NULL};
        memcpy(further + 4, plain, sizeof plain);
        status = run(t->flags);
    }
    t->flags[t->count] = NULL;
    if (known && hash_file(OTHER, t->source, NULL, &text) && memcmp(&text, &t->text, sizeof text) == 0) {
        (void)list_append(t, names_place(object, t->place), &files, object, begun);
    }
    return status;
}

/* Compiles one source of the command to the object, or takes it from the store. Makes of one object at once wait for
 * the first. Returns the compiler's status. */
static int compile(const command *const c, char *const source, const char *const object)
{
    static task t;
    char digits[DIGITS + 1], lock[PATH_MAX + 96];
    struct stat file;
    hash key = hash_start;
    if (stat(compiler, &file) != 0) {
        fail(compiler);
    }
    const char *const slash = strrchr(source, '/');
    snprintf(t.place, sizeof t.place, "%.*s", slash == NULL ? 0 : (int)(slash + 1 - source), source);
    t.source = source;
    hash_add(&key, compiler, strlen(compiler));
    hash_add(&key, &file.st_size, sizeof file.st_size);
    hash_add(&key, &file.st_mtime, sizeof file.st_mtime);
    t.count = flags_of(c, t.flags, &key);
    hash_add(&key, source + strlen(t.place), strlen(source + strlen(t.place)) + 1); /* which the object names */
    t.text = hash_start;
    (void)hash_file(OTHER, source, NULL, &t.text);
    hash_add(&key, &t.text, sizeof t.text);
    t.key = key;
    hash_text(key, digits);
    name_kept(t.list[0], digits, ".list");
    hash_add(&key, t.place, strlen(t.place) + 1);
    hash_text(key, digits);
    name_kept(t.list[1], digits, ".list");
    name_dependencies(c, object, t.dependencies);
    if (take(&t, object)) {
        return EXIT_SUCCESS;
    }

    /* One byte of the lock for each key. */
    snprintf(lock, sizeof lock, "%s/store/lock", folder);
    const int locked = open(lock, O_WRONLY | O_CREAT, 0666);
    struct flock byte = {.l_type = F_WRLCK, .l_whence = SEEK_SET, .l_start = (off_t)(t.key.a >> 2), .l_len = 1};
    if (locked < 0 || fcntl(locked, F_SETLKW, &byte) != 0) {
        fail(lock);
    }
    const int status = take(&t, object) ? EXIT_SUCCESS : make(&t, object);
    close(locked);
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
