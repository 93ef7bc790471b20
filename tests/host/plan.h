/* The programs that a compiler starts, so that they are started without it: for a file cc1 and as, for a link ld.
 *
 * Which they are, and with what arguments, the compiler says itself (-###), once for all files that are compiled with
 * the same flags, or linked with the same. A plan is kept as words that end with a zero, and an empty one behind each
 * program. It names files of the store, `any.c` and others, in whose place those of a command are put.
 */
#ifndef PLAN_H
#define PLAN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { PLAN_ROOM = 1 << 15, PLAN_WORDS = 512 };

typedef struct plan {
    char text[PLAN_ROOM];
    char *words[PLAN_WORDS]; /* of all programs, a null pointer behind each */
    int count, programs;
} plan;

/* Reads a plan that was kept. One without a program says that there is none. */
static inline bool plan_read(plan *const p, const char *const path)
{
    FILE *const in = fopen(path, "r");
    if (in == NULL) {
        return false;
    }
    const size_t length = fread(p->text, 1, sizeof p->text, in);
    fclose(in);
    p->count = p->programs = 0;
    for (char *at = p->text; at < p->text + length && p->count < PLAN_WORDS; at += strlen(at) + 1) {
        p->words[p->count++] = *at == '\0' ? NULL : at;
        p->programs += *at == '\0';
    }
    return p->count < PLAN_WORDS;
}

/* What the compiler says when it is asked so; its length, or 0 if it fails or says too much. */
static inline size_t plan_answer(const char *const compiler, char **const question, char *const text, const size_t room)
{
    int ends[2];
    size_t length = 0;
    if (pipe(ends) != 0) {
        return 0;
    }
    const pid_t child = fork();
    if (child == 0) {
        dup2(ends[1], STDERR_FILENO);
        close(ends[0]);
        execv(compiler, question);
        _exit(EXIT_FAILURE);
    }
    close(ends[1]);
    for (ssize_t got = 1; got > 0 && length<room - 1; length += got> 0 ? (size_t)got : 0) {
        got = read(ends[0], text + length, room - 1 - length);
    }
    close(ends[0]);
    text[length] = '\0';
    int status = 0;
    return waitpid(child, &status, 0) == child && status == 0 && length < room - 1 ? length : 0;
}

/* Takes the next word of a line, which stands in quotes if it has unusual characters. Returns what follows, or a null
 * pointer at the end. */
static inline char *plan_word(char *at, char word[PLAN_ROOM])
{
    at += strspn(at, " ");
    if (*at == '\0') {
        return NULL;
    }
    const bool quoted = *at == '"';
    for (at += quoted; *at != '\0' && *at != (quoted ? '"' : ' '); at++) {
        at += *at == '\\' && at[1] != '\0';
        *word++ = *at;
    }
    *word = '\0';
    return at + (*at == '"');
}

/* The linker that collect2 would call: the first `ld` in the folders of the line COMPILER_PATH=, or that in PATH. */
static inline void plan_linker(const char *const folders, char path[PLAN_ROOM])
{
    for (const char *at = folders; at != NULL && *at != '\0';) {
        const size_t length = strcspn(at, ":\n");
        snprintf(path, PLAN_ROOM, "%.*sld", (int)length, at);
        if (access(path, X_OK) == 0) {
            return;
        }
        at = at[length] == ':' ? at + length + 1 : NULL;
    }
    strcpy(path, "ld");
}

/* Writes the words of a line. What is for link-time optimisation, which no test has, is left out. */
static inline void plan_write_line(char *const line, const char *const folders, FILE *const out)
{
    static char word[PLAN_ROOM];
    bool first = true, skips = false;
    for (char *at = line; (at = plan_word(at, word)) != NULL; first = false) {
        const size_t length = strlen(word);
        if (first && length >= 8 && strcmp(word + length - 8, "collect2") == 0) {
            plan_linker(folders, word);
        }
        const bool is_of_plugin = strcmp(word, "-plugin") == 0;
        if (!skips && !is_of_plugin && strncmp(word, "-plugin-opt", 11) != 0) {
            fwrite(word, 1, strlen(word) + 1, out);
        }
        skips = is_of_plugin;
    }
    putc('\0', out);
}

/* Asks the compiler for a plan of so many programs, and keeps it; an empty one if it has another number. */
static inline void plan_make(const char *const compiler, char **const question, const int programs,
                             const char *const path)
{
    static char text[PLAN_ROOM], lines[PLAN_ROOM], made[PLAN_ROOM];
    int found = 0;
    snprintf(made, sizeof made, "%s.XXXXXX", path); /* processes of two tests may have one number */
    const int file = plan_answer(compiler, question, text, sizeof text) > 0 ? mkstemp(made) : -1;
    FILE *const out = file < 0 ? NULL : fdopen(file, "w");
    if (out == NULL) {
        return;
    }
    memcpy(lines, text, sizeof lines);
    for (const char *at = lines; (at = strstr(at, "\n ")) != NULL; at++) {
        found++;
    }
    const char *folders = strstr(text, "\nCOMPILER_PATH=");
    folders = folders == NULL ? NULL : folders + strlen("\nCOMPILER_PATH=");
    for (char *line = strtok(lines, "\n"); line != NULL && found == programs; line = strtok(NULL, "\n")) {
        if (line[0] == ' ') {
            plan_write_line(line, folders, out);
        }
    }
    if (fclose(out) == 0) {
        (void)rename(made, path);
    }
}

/* The words of a program of the plan, from 0. */
static inline char **plan_program(plan *const p, int number)
{
    char **word = p->words;
    for (; number > 0; word++) {
        number -= *word == NULL;
    }
    return word;
}

/* Puts a file in the place of one that the plan names. */
static inline void plan_put(plan *const p, const char *const name, char *const file)
{
    for (int i = 0; i < p->count; i++) {
        if (p->words[i] != NULL && strcmp(p->words[i], name) == 0) {
            p->words[i] = file;
        }
    }
}

#endif
