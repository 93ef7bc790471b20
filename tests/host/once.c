/* Compiles every source once, whichever test asks for it: a compiler in front of the compiler.
 *
 *     COMPILER ARGUMENT...
 *
 * A folder of links to this program, one named like each compiler, stands first in the PATH of the tests; the compilers
 * themselves are the links beside it in real/, the objects in store/. An object is kept under a hash of all that it
 * follows from: the compiler's file, its flags, the name and the text of the source, and all files that it includes. A
 * source in a command that links as well is compiled for itself. What the hash does not cover goes to the compiler as
 * it is: debug information, which names folders; output that is no object; several languages.
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

#include "command.h"
#include "files.h"
#include "plan.h"

static char folder[PATH_MAX];   /* of this program */
static char compiler[PATH_MAX]; /* the real one */

static _Noreturn void fail(const char *const what)
{
    fprintf(stderr, "once: %s: %s\n", what, strerror(errno));
    exit(EXIT_FAILURE);
}

/* Runs a program. Returns its exit status. */
static int run(const char *const program, char **const arguments)
{
    const pid_t child = fork();
    if (child == 0) {
        execvp(program, arguments);
        fail(program);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : EXIT_FAILURE;
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

/* What is compiled: the source, its folder with a slash, and the flags, the first of which is the compiler. */
typedef struct task {
    char *source, *flags[ARGUMENTS];
    char place[PATH_MAX];
    int count;
    hash text, key;              /* of the source; of all but what the source includes */
    char digits[DIGITS + 1];     /* of `key`: a file that is named so is of whoever has its lock */
    char list[2][PATH_MAX + 64]; /* of objects that do not name the folder, and of those that do */
    char plan[PATH_MAX + 64];    /* of what the compiler starts with these flags */
    char dependencies[PATH_MAX]; /* for make, or no name */
} task;

/* The path of a file of the store. */
static void name_kept(char path[PATH_MAX + 64], const char *const digits, const char *const end)
{
    snprintf(path, PATH_MAX + 64, "%s/store/%s%s", folder, digits, end);
}

/* The plan for these words of a command, the first of which is the compiler: by all but folders of headers and macros.
 */
static void name_plan(char **const words, char path[PATH_MAX + 64])
{
    char digits[DIGITS + 1];
    struct stat file;
    hash key = hash_start;
    if (stat(compiler, &file) != 0) {
        fail(compiler);
    }
    hash_add(&key, &file.st_size, sizeof file.st_size);
    hash_add(&key, &file.st_mtime, sizeof file.st_mtime);
    for (int i = 0, pair = 1; words[i] != NULL; i += pair) {
        pair = takes_value(words[i]) && words[i + 1] != NULL ? 2 : 1;
        for (int j = i; j < i + pair && (i == 0 || !is_for_preprocessor(words[i])); j++) {
            hash_add(&key, words[j], strlen(words[j]) + 1);
        }
    }
    hash_text(key, digits);
    name_kept(path, digits, ".plan");
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

/* Takes the object from the store, if that has it; without an object to write, `kept` is the one in the store. */
static bool take(const task *const t, const char *const object, char kept[PATH_MAX + 64])
{
    static reading files;
    char digits[DIGITS + 1];
    for (int i = 0; i < 2; i++) {
        if (list_find(t, t->list[i], digits, &files)) {
            name_kept(kept, digits, ".o");
            if (object == NULL
                    ? utimensat(AT_FDCWD, kept, NULL, 0) == 0
                    : copy(kept, object) && (t->dependencies[0] == '\0' || write_dependencies(t, object, &files))) {
                return true;
            }
        }
    }
    return false;
}

/* Runs what the compiler would start for the flags and what `told` says; the compiler itself where that is not known.
 * Returns its status. */
static int run_planned(task *const t, const char *const *const told, const char *const object, char *const includes)
{
    static plan p;
    static char any[3][PATH_MAX + 64], assembly[PATH_MAX + 64];
    char *words[2 * ARGUMENTS], *inserted[ARGUMENTS];
    int count = 0, insert = 0;
    for (int i = 0, pair = 1; i < t->count; i += pair) {
        pair = takes_value(t->flags[i]) && i + 1 < t->count ? 2 : 1;
        for (int j = i; j < i + pair; j++) {
            if (i > 0 && is_for_preprocessor(t->flags[i])) {
                inserted[insert++] = t->flags[j];
            } else {
                words[count++] = t->flags[j];
            }
        }
    }
    static const char *const ends[] = {".c", ".o", ".d"};
    for (int i = 0; i < 3; i++) {
        name_kept(any[i], "any", ends[i]);
    }
    if (!plan_read(&p, t->plan)) {
        char *const question[] = {"-c", any[0], "-o", any[1], "-MD", "-MF", any[2], "-MT", "object", "-###", NULL};
        close(open(any[0], O_WRONLY | O_CREAT, 0666));
        memcpy(words + count, question, sizeof question);
        plan_make(compiler, words, 2, t->plan);
    }
    if (!plan_read(&p, t->plan) || p.programs != 2 || !ends_with(p.words[0], "/cc1") ||
        strcmp(p.words[1], "-quiet") != 0) {
        memcpy(t->flags + t->count, told, 9 * sizeof told[0]);
        const int status = run(compiler, t->flags);
        t->flags[t->count] = NULL;
        return status;
    }
    char **const assembler = plan_program(&p, 1);
    name_kept(assembly, t->digits, ".s");
    plan_put(&p, assembler[-2], assembly); /* the last word of cc1 */
    plan_put(&p, any[0], t->source);
    plan_put(&p, "any.c", t->source + strlen(t->place));
    plan_put(&p, any[1], (char *)(uintptr_t)object);
    plan_put(&p, any[2], includes);
    memcpy(words, p.words, 2 * sizeof words[0]);
    memcpy(words + 2, inserted, (size_t)insert * sizeof words[0]);
    memcpy(words + 2 + insert, p.words + 2, (size_t)(assembler - p.words - 2) * sizeof words[0]);
    int status = run(words[0], words);
    status = status == EXIT_SUCCESS ? run(assembler[0], assembler) : status;
    (void)unlink(assembly);
    if (status != EXIT_SUCCESS) {
        (void)unlink(object);
    }
    return status;
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
    char includes[PATH_MAX + 64];
    const struct timespec begun = begin_after(t->source);
    char **const further = t->flags + t->count;
    hash text = hash_start;
    name_kept(includes, t->digits, ".d");
    const char *const told[] = {"-c", t->source, "-o", object, "-MD", "-MF", includes, "-MT", "object", NULL};
    int status = run_planned(t, told, object, includes);
    const bool known = status == EXIT_SUCCESS && read_includes(includes, t->place, &files);
    (void)unlink(includes);
    if (status == EXIT_SUCCESS && t->dependencies[0] != '\0' && !(known && write_dependencies(t, object, &files))) {
        const char *const plain[] = {"-MMD", "-MP", NULL};
        memcpy(further, told, 4 * sizeof told[0]);
        memcpy(further + 4, plain, sizeof plain);
        status = run(compiler, t->flags);
        t->flags[t->count] = NULL;
    }
    if (known && hash_file(OTHER, t->source, NULL, &text) && memcmp(&text, &t->text, sizeof text) == 0) {
        (void)list_append(t, names_place(object, t->place), &files, object, begun);
    }
    return status;
}

/* Compiles one source of the command to the object, or takes it from the store. Makes of one object at once wait for
 * the first. For a link, `kept` is the object in the store, or empty where that has none and it is where it was to be.
 * Returns the compiler's status. */
static int compile(const command *const c, char *const source, const char *const object, char kept[PATH_MAX + 64])
{
    static task t;
    const char *const asked = c->compiles ? object : NULL;
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
    name_plan(t.flags, t.plan);
    hash_add(&key, source + strlen(t.place), strlen(source + strlen(t.place)) + 1); /* which the object names */
    t.text = hash_start;
    (void)hash_file(OTHER, source, NULL, &t.text);
    hash_add(&key, &t.text, sizeof t.text);
    t.key = key;
    hash_text(key, t.digits);
    name_kept(t.list[0], t.digits, ".list");
    hash_add(&key, t.place, strlen(t.place) + 1);
    hash_text(key, digits);
    name_kept(t.list[1], digits, ".list");
    name_dependencies(c, object, t.dependencies);
    if (take(&t, asked, kept)) {
        return EXIT_SUCCESS;
    }

    /* One byte of the lock for each key. */
    snprintf(lock, sizeof lock, "%s/store/lock", folder);
    const int locked = open(lock, O_WRONLY | O_CREAT, 0666);
    struct flock byte = {.l_type = F_WRLCK, .l_whence = SEEK_SET, .l_start = (off_t)(t.key.a >> 2), .l_len = 1};
    if (locked < 0 || fcntl(locked, F_SETLKW, &byte) != 0) {
        fail(lock);
    }
    int status = EXIT_SUCCESS;
    if (!take(&t, asked, kept)) {
        status = make(&t, object);
        kept[0] = '\0';
        if (!c->compiles && status == EXIT_SUCCESS && take(&t, asked, kept)) {
            (void)unlink(object);
        }
    }
    close(locked);
    return status;
}

/* Compiles the sources of a command that links nothing. Returns the compiler's status, of the first that has errors. */
static int compile_all(const command *const c)
{
    static char object[PATH_MAX], kept[PATH_MAX + 64];
    int status = EXIT_SUCCESS;
    for (int i = 0; i < c->source_count; i++) {
        const char *const slash = strrchr(c->sources[i], '/');
        snprintf(object, sizeof object, "%s", slash == NULL ? c->sources[i] : slash + 1);
        object[strlen(object) - 1] = 'o';
        const int of_source = compile(c, c->sources[i], c->output == NULL ? object : c->output, kept);
        status = status == EXIT_SUCCESS ? of_source : status;
    }
    return status;
}

/* What links these words to the output without the compiler, if that says so. A library follows all objects. */
static bool link_planned(char **const words, char *const output, char **linker)
{
    static plan p;
    static char path[PATH_MAX + 64], any[2][PATH_MAX + 64];
    char *question[2 * ARGUMENTS], *objects[2 * ARGUMENTS];
    int count = 0, objects_count = 0;
    bool has_library = false;
    name_kept(any[0], "any", ".o");
    name_kept(any[1], "any", "");
    for (int i = 0, pair = 1; words[i] != NULL; i += pair) {
        char *const word = words[i];
        pair = takes_value(word) && words[i + 1] != NULL ? 2 : 1;
        if (word[0] != '-' && ends_with(word, ".o")) {
            if (objects_count == 0) {
                question[count++] = any[0];
            }
            objects[objects_count++] = word;
            if (has_library) {
                return false;
            }
        } else if (!is_for_preprocessor(word) && (word[1] != 'W' || begins_with(word, "-Wl,"))) {
            has_library = has_library || begins_with(word, "-l") || begins_with(word, "-Wl,--start") ||
                          begins_with(word, "-Wl,--whole") || (i > 0 && word[0] != '-');
            memcpy(question + count, words + i, (size_t)pair * sizeof words[0]);
            count += pair;
        }
    }
    question[count] = NULL;
    if (objects_count == 0) {
        return false;
    }
    name_plan(question, path);
    if (!plan_read(&p, path)) {
        char *const rest[] = {"-o", any[1], "-###", NULL};
        memcpy(question + count, rest, sizeof rest);
        close(open(any[0], O_WRONLY | O_CREAT, 0666));
        plan_make(compiler, question, 1, path);
    }
    if (!plan_read(&p, path) || p.programs != 1 || (strcmp(p.words[0], "ld") != 0 && !ends_with(p.words[0], "/ld"))) {
        return false;
    }
    plan_put(&p, any[1], output);
    for (char **word = p.words; *word != NULL; word++) {
        if (strcmp(*word, any[0]) == 0) {
            memcpy(linker, objects, (size_t)objects_count * sizeof objects[0]);
            linker += objects_count;
        } else {
            *linker++ = *word;
        }
    }
    *linker = NULL;
    return true;
}

/* Links what the sources of the command give, and what else it names. */
static int compile_and_link(const command *const c)
{
    static char objects[ARGUMENTS][PATH_MAX + 64], kept[PATH_MAX + 64];
    char *words[2 * ARGUMENTS], *linker[4 * ARGUMENTS], *output = (char *)(uintptr_t)c->output;
    int count = 0, status = EXIT_SUCCESS, made = 0;
    words[count++] = c->words[0];
    for (int i = 0; i < c->source_count && status == EXIT_SUCCESS; i++) {
        snprintf(objects[i], sizeof objects[i], "%s.%ld.%d.o", c->output, (long)getpid(), i);
        status = compile(c, c->sources[i], objects[i], kept);
        made += kept[0] == '\0';
        if (kept[0] != '\0') {
            strcpy(objects[i], kept);
        }
        words[count++] = objects[i];
    }
    for (int i = 1; i < c->word_count; i++) {
        words[count++] = c->words[i];
    }
    words[count] = NULL;
    if (status != EXIT_SUCCESS || !link_planned(words, output, linker)) {
        words[count++] = (char *)(uintptr_t) "-o";
        words[count++] = output;
        words[count] = NULL;
        memcpy(linker, words, sizeof words);
        linker[0] = compiler;
    }
    if (status == EXIT_SUCCESS && made == 0) {
        execvp(linker[0], linker);
        fail(linker[0]);
    }
    status = status == EXIT_SUCCESS ? run(linker[0], linker) : status;
    for (int i = 0; i < c->source_count && made > 0; i++) {
        if (begins_with(objects[i], c->output)) {
            (void)unlink(objects[i]);
        }
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
    return c.compiles ? compile_all(&c) : compile_and_link(&c);
}
