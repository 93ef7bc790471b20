/* A command of a compiler, taken apart. */
#ifndef COMMAND_H
#define COMMAND_H

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

enum { ARGUMENTS = 512 };

static inline bool ends_with(const char *const text, const char *const end)
{
    const size_t length = strlen(text), tail = strlen(end);
    return length > tail && strcmp(text + length - tail, end) == 0;
}

static inline bool begins_with(const char *const text, const char *const start)
{
    return strncmp(text, start, strlen(start)) == 0;
}

/* A command taken apart; `words` has it without sources, -c and -o. Without a source it only links. */
typedef struct command {
    char *words[ARGUMENTS];
    char *sources[ARGUMENTS];
    const char *output; /* NULL where each source has an object of its name, here */
    int word_count, source_count;
    bool compiles, kept; /* -c; whether the store may keep the objects that it makes */
} command;

static inline bool takes_value(const char *const word)
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
static inline bool beyond_hash(const char *const word)
{
    return begins_with(word, "-g") || strcmp(word, "-S") == 0 || strcmp(word, "-E") == 0 || strcmp(word, "-x") == 0 ||
           strcmp(word, "-") == 0 || begins_with(word, "-save") || begins_with(word, "-fcallgraph") ||
           begins_with(word, "-fprofile") || begins_with(word, "-fsyntax") || begins_with(word, "-print") ||
           begins_with(word, "-fsanitize") || begins_with(word, "-M") || begins_with(word, "@") ||
           ends_with(word, ".s") || ends_with(word, ".S") || begins_with(word, "--coverage") ||
           begins_with(word, "-flto");
}

static inline command take_apart(const int argc, char **const argv)
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
    c.kept = c.kept && (c.output != NULL ? (!c.compiles || c.source_count == 1) && !begins_with(c.output, "/dev/")
                                         : c.compiles && c.source_count > 0);
    return c;
}

static inline bool is_for_linker(const char *const word)
{
    return begins_with(word, "-l") || begins_with(word, "-Wl,") || begins_with(word, "-L") || begins_with(word, "-T") ||
           strcmp(word, "-nostartfiles") == 0 || strcmp(word, "-shared") == 0 || strcmp(word, "-r") == 0 ||
           word[0] != '-';
}

/* Folders of headers and macros, whose order among themselves is all that matters of their places. */
static inline bool is_for_preprocessor(const char *const word)
{
    return begins_with(word, "-I") || begins_with(word, "-D") || begins_with(word, "-U");
}

#endif
