/* Compiles every source once, whichever test asks for it: a compiler in front of the compiler.
 *
 *     COMPILER ARGUMENT...
 *
 * A folder of links to this program, one named like each compiler, stands first in the PATH of the tests; the compilers
 * themselves are the links beside it in real/, the objects in store/. An object is kept under a hash of all that it follows
 * from: the compiler's file, its flags, the name of the source and the preprocessed source. A source in a command that
 * links as well is compiled for itself. What the hash does not cover goes to the compiler as it is: debug information, which names folders; output
 * that is no object; several files or languages.
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
    static const char *const with[] = {"-I",  "-D", "-U", "-include", "-isystem", "-MF",
                                       "-MT", "-T", "-L", "-l",       "-Xlinker"};
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

/* The flags of a compilation: those of the command without what is the linker's. They are added to the hash, but for those
 * that the preprocessed source shows. */
static int flags_of(const command *const c, char **const flags, hash *const h)
{
    int count = 0;
    for (int i = 0; i < c->word_count; i++) {
        const bool value = takes_value(c->words[i]) && i + 1 < c->word_count;
        if (i == 0 || !is_for_linker(c->words[i])) {
            flags[count++] = c->words[i];
            if (value) {
                flags[count++] = c->words[i + 1];
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

/* Adds the preprocessed source to the hash. With -MMD that also writes the list of what the object depends on. */
static bool hash_source(char **const flags, int count, char *const source, const char *const object, hash *const h)
{
    static char bytes[BUFFER];
    char list[PATH_MAX];
    for (int i = 1; i < count; i++) {
        if (strcmp(flags[i], "-MMD") == 0) {
            snprintf(list, sizeof list, "%s", object);
            char *const dot = strrchr(list, '.');
            snprintf(dot == NULL ? list + strlen(list) : dot, 3, ".d");
            flags[count++] = (char *)"-MF";
            flags[count++] = list;
            flags[count++] = (char *)"-MT";
            flags[count++] = (char *)object;
            break;
        }
    }
    flags[count++] = (char *)"-E";
    flags[count++] = (char *)"-P";
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
    for (ssize_t got = 1; got > 0;) {
        got = read(ends[0], bytes, sizeof bytes);
        hash_add(h, bytes, got > 0 ? (size_t)got : 0);
    }
    close(ends[0]);
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

/* Compiles one source of the command to the object, or takes it from the store. Makes of one object at once wait for the
 * first. Returns the compiler's status. */
static int compile(const command *const c, char *const source, const char *const object)
{
    char *flags[ARGUMENTS];
    char kept[PATH_MAX + 64], made[PATH_MAX + 96], lock[PATH_MAX + 96];
    struct stat file;
    hash h = {UINT64_C(0xCBF29CE484222325), UINT64_C(0x84222325CBF29CE4)};
    if (stat(compiler, &file) != 0) {
        fail(compiler);
    }
    hash_add(&h, compiler, strlen(compiler));
    hash_add(&h, &file.st_size, sizeof file.st_size);
    hash_add(&h, &file.st_mtime, sizeof file.st_mtime);
    int count = flags_of(c, flags, &h);
    const char *const slash = strrchr(source, '/');
    const char *const base = slash == NULL ? source : slash + 1; /* which the object names */
    hash_add(&h, base, strlen(base) + 1);
    const bool known = hash_source(flags, count, source, object, &h);
    snprintf(kept, sizeof kept, "%s/store/%016" PRIx64 "%016" PRIx64 ".o", folder, h.a, h.b);
    snprintf(made, sizeof made, "%s.%ld", kept, (long)getpid());
    snprintf(lock, sizeof lock, "%s/store/lock", folder);

    /* One byte of the lock for each hash. */
    const int locked = known ? open(lock, O_WRONLY | O_CREAT, 0666) : -1;
    struct flock byte = {.l_type = F_WRLCK, .l_whence = SEEK_SET, .l_start = (off_t)(h.a >> 2), .l_len = 1};
    if (locked >= 0) {
        (void)fcntl(locked, F_SETLKW, &byte);
    }
    int status = EXIT_SUCCESS;
    if (!known || !copy(kept, object)) {
        flags[count++] = (char *)"-c";
        flags[count++] = source;
        flags[count++] = (char *)"-o";
        flags[count++] = (char *)object;
        flags[count] = NULL;
        status = run(flags);
        if (status == EXIT_SUCCESS && known && copy(object, made)) {
            (void)rename(made, kept);
        }
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
