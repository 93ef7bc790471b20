#include "tools/link/child.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "tools/file/file.h"

enum { STEP_MS = 5, GRACE_MS = 500 };

child child_start(const char *const name, char *const *const command, const char *const variable,
                  const char *const value, const int file, const int number)
{
    fflush(stdout);
    const child result = {.name = name, .id = fork(), .running = true};
    if (result.id < 0) {
        quit("link: %s: %s", name, strerror(errno));
    }
    if (result.id == 0) {
        setpgid(0, 0);
        signal(SIGPIPE, SIG_DFL);
        setenv(variable, value, 1);
        const int nothing = open("/dev/null", O_RDONLY);
        dup2(nothing, STDIN_FILENO);
        if (file >= 0 && file != number) {
            dup2(file, number);
            close(file);
        }
        execvp(command[0], command);
        fprintf(stderr, "link: %s: %s: %s\n", name, command[0], strerror(errno));
        _exit(EXIT_FAILURE);
    }
    setpgid(result.id, result.id);
    return result;
}

bool child_runs(child *const c)
{
    c->running = c->running && waitpid(c->id, &c->status, WNOHANG) != c->id;
    return c->running;
}

bool child_ends(child *const c, const int milliseconds)
{
    for (int waited = 0; child_runs(c) && waited < milliseconds; waited += STEP_MS) {
        nanosleep(&(struct timespec){.tv_nsec = STEP_MS * 1000000L}, NULL);
    }
    return !c->running;
}

void child_stop(child *const c)
{
    if (c->id == 0) {
        return;
    }
    kill(-c->id, SIGTERM);
    (void)child_ends(c, GRACE_MS);
    kill(-c->id, SIGKILL);
    (void)child_ends(c, GRACE_MS);
}

const char *child_fault(const child *const c)
{
    static char text[128];
    if (WIFSIGNALED(c->status)) {
        snprintf(text, sizeof text, "%s ended by signal %d", c->name, WTERMSIG(c->status));
        return text;
    }
    if (WEXITSTATUS(c->status) != 0) {
        snprintf(text, sizeof text, "%s ended with status %d", c->name, WEXITSTATUS(c->status));
        return text;
    }
    return NULL;
}
