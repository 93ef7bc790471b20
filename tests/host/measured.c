/* Runs a test and measures it: the processor time and the processes that it and all that follow from it take.
 *
 *     measured SECONDS FILE COMMAND...
 *
 * Ends with the status of the command, which is killed after so many seconds with all that it has started. FILE then has a line:
 * the seconds of processor time, and how many processes and threads were started. They are exact, whatever else the machine
 * does: the command has a namespace of processes of its own, whose numbers the kernel gives in turn. Where neither root nor a
 * user may have one, `-` stands for them.
 */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* unshare */
#endif
#include <errno.h>
#include <sched.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

static volatile sig_atomic_t first; /* the process that has the command's ones under it */

_Noreturn static void fail(const char *const what)
{
    fprintf(stderr, "measured: %s: %s\n", what, strerror(errno));
    exit(EXIT_FAILURE);
}

static bool tell(const char *const path, const char *const text)
{
    FILE *const file = fopen(path, "w");
    return file != NULL && fputs(text, file) >= 0 && fclose(file) == 0;
}

/* Whether the processes started from here on have a namespace of their own. A user has one in a namespace of users with himself
 * alone. */
static bool separate(void)
{
    char users[64], groups[64];
    snprintf(users, sizeof users, "%u %u 1", (unsigned)geteuid(), (unsigned)geteuid());
    snprintf(groups, sizeof groups, "%u %u 1", (unsigned)getegid(), (unsigned)getegid());
    return unshare(CLONE_NEWPID) == 0 ||
           (unshare(CLONE_NEWUSER | CLONE_NEWPID) == 0 && tell("/proc/self/setgroups", "deny") &&
            tell("/proc/self/uid_map", users) && tell("/proc/self/gid_map", groups));
}

static void end_all(const int number)
{
    (void)number;
    kill(-(pid_t)first, SIGKILL);
}

/* Waits for this child, and for whatever else ends before. Returns its status as a shell tells it. */
static int status_of(const pid_t child)
{
    int status = 0;
    for (pid_t ended = 0; ended != child;) {
        ended = wait(&status);
        if (ended < 0 && errno != EINTR) {
            fail("wait");
        }
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/* The number of a process started now, which ends at once. */
static pid_t next_number(void)
{
    const pid_t child = fork();
    if (child == 0) {
        _exit(EXIT_SUCCESS);
    }
    return child;
}

/* The first process of the namespace: ends with the command's status, and by that ends all that is left of its processes.
 * Sends the number of processes, without itself and the one that counts. */
_Noreturn static void run_first(char **const command, const int answer, const bool is_separate)
{
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const pid_t child = fork();
    if (child == 0) {
        close(answer);
        execvp(command[0], command);
        fprintf(stderr, "measured: %s: %s\n", command[0], strerror(errno));
        _exit(127);
    }
    const int status = status_of(child);
    const long started = is_separate ? (long)next_number() - 2 : -1;
    if (write(answer, &started, sizeof started) != (ssize_t)sizeof started) {
        fail("write");
    }
    exit(status);
}

static double seconds(const struct timeval time)
{
    return (double)time.tv_sec + 1e-6 * (double)time.tv_usec;
}

int main(const int argc, char **const argv)
{
    int ends[2];
    if (argc < 4 || pipe(ends) != 0) {
        fprintf(stderr, "usage: measured SECONDS FILE COMMAND...\n");
        return EXIT_FAILURE;
    }
    const bool is_separate = separate();
    first = (sig_atomic_t)fork();
    if (first == 0) {
        close(ends[0]);
        run_first(argv + 3, ends[1], is_separate);
    }
    setpgid((pid_t)first, (pid_t)first);
    close(ends[1]);
    static const int all[] = {SIGALRM, SIGINT, SIGTERM, SIGHUP};
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        signal(all[i], end_all);
    }
    alarm((unsigned)strtoul(argv[1], NULL, 10));
    const int status = status_of((pid_t)first);
    long started = -1;
    if (read(ends[0], &started, sizeof started) != (ssize_t)sizeof started) {
        started = -1;
    }
    struct rusage used;
    getrusage(RUSAGE_CHILDREN, &used);
    FILE *const file = fopen(argv[2], "w");
    if (file == NULL) {
        fail(argv[2]);
    }
    fprintf(file, "%.3f ", seconds(used.ru_utime) + seconds(used.ru_stime));
    fprintf(file, started < 0 ? "-\n" : "%ld\n", started);
    return fclose(file) == 0 ? status : EXIT_FAILURE;
}
