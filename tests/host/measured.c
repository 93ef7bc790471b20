/* Runs a test and measures it: the processor time and the processes that it and all that follow from it take.
 *
 *     measured SECONDS FILE COMMAND...
 *
 * Ends with the status of the command, which is killed after so many seconds with all that it has started. FILE then
 * has a line: the seconds of processor time, and how many processes and threads were started. They are exact, whatever
 * else the machine does: the command has a namespace of processes of its own, whose numbers the kernel gives in turn,
 * with its own /proc, which sanitizers read. Where neither root nor a user may have one, `-` stands for them.
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
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

static volatile sig_atomic_t first; /* the process that has the command's ones under it */

static _Noreturn void fail(const char *const what)
{
    fprintf(stderr, "measured: %s: %s\n", what, strerror(errno));
    exit(EXIT_FAILURE);
}

static bool tell(const char *const path, const char *const text)
{
    FILE *const file = fopen(path, "w");
    return file != NULL && fputs(text, file) >= 0 && fclose(file) == 0;
}

/* Whether the processes started from here on have namespaces of their own, of processes and of mounts. A user has them
 * in a namespace of users with himself alone. */
static bool separate(void)
{
    char users[64], groups[64];
    snprintf(users, sizeof users, "%u %u 1", (unsigned)geteuid(), (unsigned)geteuid());
    snprintf(groups, sizeof groups, "%u %u 1", (unsigned)getegid(), (unsigned)getegid());
    return unshare(CLONE_NEWPID | CLONE_NEWNS) == 0 ||
           (unshare(CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNS) == 0 && tell("/proc/self/setgroups", "deny") &&
            tell("/proc/self/uid_map", users) && tell("/proc/self/gid_map", groups));
}

/* For the first process of the namespace: whether /proc shows its processes. */
static bool mount_own(void)
{
    return mount("none", "/", NULL, MS_REC | MS_PRIVATE, NULL) == 0 && mount("proc", "/proc", "proc", 0, NULL) == 0;
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

enum { NOT_ALLOWED = -2, NOT_COUNTED = -1 }; /* in place of a number of processes */

static void answer(const int to, const long number)
{
    if (write(to, &number, sizeof number) != (ssize_t)sizeof number) {
        fail("write");
    }
}

/* Runs the command, and ends with its status. The first process of a namespace ends by that all that is left of the
 * others, and sends their number, without itself and the one that counts. */
static _Noreturn void run(char **const command, const int to, const bool is_first)
{
    if (is_first && !mount_own()) {
        answer(to, NOT_ALLOWED);
        exit(EXIT_FAILURE);
    }
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const pid_t child = fork();
    if (child == 0) {
        close(to);
        execvp(command[0], command);
        fprintf(stderr, "measured: %s: %s\n", command[0], strerror(errno));
        _exit(127);
    }
    const int status = status_of(child);
    answer(to, is_first ? (long)next_number() - 2 : (long)NOT_COUNTED);
    exit(status);
}

/* The same in namespaces of its own. */
static _Noreturn void run_apart(char **const command, const int to)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (!separate()) {
        answer(to, NOT_ALLOWED);
        exit(EXIT_FAILURE);
    }
    const pid_t child = fork();
    if (child == 0) {
        run(command, to, true);
    }
    exit(status_of(child));
}

/* Runs the command, in namespaces of its own or not. Returns its status, and the number of processes. */
static int measure(char **const command, const bool is_apart, long *const started)
{
    int ends[2];
    if (pipe(ends) != 0) {
        fail("pipe");
    }
    first = (sig_atomic_t)fork();
    if (first == 0) {
        setpgid(0, 0);
        close(ends[0]);
        if (is_apart) {
            run_apart(command, ends[1]);
        }
        run(command, ends[1], false);
    }
    setpgid((pid_t)first, (pid_t)first);
    close(ends[1]);
    const int status = status_of((pid_t)first);
    if (read(ends[0], started, sizeof *started) != (ssize_t)sizeof *started) {
        *started = NOT_COUNTED; /* it was killed */
    }
    close(ends[0]);
    return status;
}

static double seconds(const struct timeval time)
{
    return (double)time.tv_sec + 1e-6 * (double)time.tv_usec;
}

int main(const int argc, char **const argv)
{
    if (argc < 4) {
        fprintf(stderr, "usage: measured SECONDS FILE COMMAND...\n");
        return EXIT_FAILURE;
    }
    static const int all[] = {SIGALRM, SIGINT, SIGTERM, SIGHUP};
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        signal(all[i], end_all);
    }
    alarm((unsigned)strtoul(argv[1], NULL, 10));
    long started = NOT_ALLOWED;
    int status = measure(argv + 3, true, &started);
    if (started == NOT_ALLOWED) {
        status = measure(argv + 3, false, &started);
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
