/* Many calls of isoc in one process, for tests with many small scenes. A request on stdin is a line of arguments that
 * end with a 0 each: the files for stdout and stderr, then the arguments of isoc. Where the name of the second file is
 * empty, messages go where this program's own go. The answer is a line with the status that isoc ends with. A request
 * that is too long has no answer: the program ends.
 *
 * Under memcheck, which takes longer to start than isoc to run, and translates once what all requests have in common,
 * the status is 99 if it found an error or memory that was not given back since the request began. This program itself
 * keeps nothing on the heap.
 */
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdio_ext.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <valgrind/memcheck.h>

int isoc_main(int count, char **arguments);

/* Its own main is a function here. */
#define main isoc_main
#include "tools/isoc/main.c"
#undef main

enum { REQUEST_BYTES = 4096, ARGUMENTS = 24, FOUND = 99 };

static void redirect(const char *const path, const int to)
{
    const int file = open(path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (file < 0 || dup2(file, to) < 0 || close(file) != 0) {
        _exit(127);
    }
}

/* What memcheck must find: memory that is lost, and a branch on what was never set. */
static int planted(const char *const kind)
{
    char *const one = calloc(2, 1);
    char *const half = realloc(one, 4);
    const bool found = strcmp(kind, "branch") == 0 && memchr(half, 1, 4) != NULL;
    if (strcmp(kind, "leak") != 0) {
        free(half);
    }
    return found ? 1 : 0;
}

/* The errors that memcheck has found, of memory that is lost too; without it none. */
static unsigned long errors_found(void)
{
    VALGRIND_DO_ADDED_LEAK_CHECK;
    return VALGRIND_COUNT_ERRORS;
}

static int carry_out(const int count, char **const arguments, const int own_messages)
{
    const unsigned long before = errors_found();
    redirect(arguments[0], STDOUT_FILENO);
    if (arguments[1][0] == '\0') {
        dup2(own_messages, STDERR_FILENO);
    } else {
        redirect(arguments[1], STDERR_FILENO);
    }
    const int status =
        strcmp(arguments[2], "planted") == 0 ? planted(arguments[3]) : isoc_main(count - 1, arguments + 1);
    __fpurge(stdout); /* of a device that is full */
    clearerr(stdout);
    return errors_found() == before ? status : FOUND;
}

/* Reads up to the end of a line; its length without it, or -1 at the end of all and of a line that is too long. */
static int read_line(char *const line)
{
    int length = 0;
    while (length < REQUEST_BYTES && read(STDIN_FILENO, line + length, 1) == 1) {
        if (line[length] == '\n') {
            return length;
        }
        length++;
    }
    return -1;
}

int main(void)
{
    static char line[REQUEST_BYTES], buffer[BUFSIZ];
    const int answers = dup(STDOUT_FILENO), own_messages = dup(STDERR_FILENO);
    setvbuf(stdout, buffer, _IOFBF, sizeof buffer);
    for (int length = read_line(line); length > 0; length = read_line(line)) {
        char *arguments[ARGUMENTS + 1] = {NULL};
        int count = 0;
        char *at = line;
        for (; at < line + length && count < ARGUMENTS; at += strlen(at) + 1) {
            arguments[count++] = at;
        }
        if (at < line + length || dprintf(answers, "%d\n", carry_out(count, arguments, own_messages)) < 0) {
            return EXIT_FAILURE;
        }
    }
    return EXIT_SUCCESS;
}
