/* isoc as often as it is asked for, in one process, so that memcheck, which takes longer to start than isoc to run,
 * starts once, and translates once what all runs have in common with the first ones, of the scenes that this program's
 * own arguments name behind their folder. A request on stdin is a line of arguments that end with a 0 each: the files
 * for stdout and stderr, then those of isoc. The answer is a line with the status as waitpid has it. Every run is a
 * process of its own, which memcheck judges at its end; this program itself keeps nothing on the heap, so that what is
 * left there is isoc's.
 */
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* That of tools/isoc/main.c. */
int isoc_main(int count, char **arguments);

enum { REQUEST_BYTES = 4096, ARGUMENTS = 16 };

/* Reads up to the end of a line; its length without it, or -1 at the end of all. */
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
    char *const text = calloc(2, 1);
    char *const half = realloc(text, 4);
    const bool found = strcmp(kind, "branch") == 0 && memchr(half, 1, 4) != NULL;
    if (strcmp(kind, "leak") != 0) {
        free(half);
    }
    return found ? 1 : 0;
}

static int run(const int count, char **const arguments)
{
    redirect(arguments[0], STDOUT_FILENO);
    redirect(arguments[1], STDERR_FILENO);
    return strcmp(arguments[2], "planted") == 0 ? planted(arguments[3]) : isoc_main(count - 2, arguments + 2);
}

int main(const int own_count, char **const own_arguments)
{
    static char line[REQUEST_BYTES], own_option[] = "-o";
    const int answers = dup(STDOUT_FILENO);
    redirect("/dev/null", STDOUT_FILENO);
    redirect("/dev/null", STDERR_FILENO);
    for (int i = 2; i < own_count; i++) {
        char *first[] = {own_arguments[0], own_arguments[i], own_option, own_arguments[1], NULL};
        (void)isoc_main(4, first);
    }
    for (int length = read_line(line); length > 0; length = read_line(line)) {
        char *arguments[ARGUMENTS + 1] = {NULL};
        int count = 0;
        for (char *a = line; a < line + length && count < ARGUMENTS; a += strlen(a) + 1) {
            arguments[count++] = a;
        }
        const pid_t child = fork();
        if (child == 0) {
            exit(run(count, arguments));
        }
        int status = 0;
        char answer[16];
        if (child < 0 || waitpid(child, &status, 0) != child) {
            return EXIT_FAILURE;
        }
        const int bytes = snprintf(answer, sizeof answer, "%d\n", status);
        if (write(answers, answer, (size_t)bytes) != bytes) {
            return EXIT_FAILURE;
        }
    }
    return EXIT_SUCCESS;
}
