#define _POSIX_C_SOURCE 200809L
#include "tools/sweep/parts.h"

#include <errno.h>
#include <inttypes.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "tools/sweep/run.h"

void part_make(const plan *const p, const uint64_t part)
{
    static new_file f;
    char name[PLAN_NAME_BYTES], maker[160], host[80] = "";
    plan_part_name(part, name);
    if (part >= p->parts) {
        plan_fail("the plan has no such part", name);
    }
    if (plan_has_part(p, part)) {
        return;
    }
    (void)gethostname(host, sizeof host - 1);
    snprintf(maker, sizeof maker, "%s.%ld", host, (long)getpid());
    file_must_begin(&f, "sweep", p->folder, name, maker);
    run_rows(p, plan_first(p, part), plan_first(p, part + 1), f.to);
    file_must_end(&f, "sweep");
}

/* How far a sweep is. */
typedef struct progress {
    const plan *p;
    double begun, last_report; /* s */
    uint64_t at_begin;         /* runs that were there */
} progress;

/* Runs that are there: those of whole parts. */
static uint64_t count_runs(const plan *const p)
{
    uint64_t runs = 0;
    for (uint64_t part = 0; part < p->parts; part++) {
        runs += plan_has_part(p, part) ? plan_first(p, part + 1) - plan_first(p, part) : 0;
    }
    return runs;
}

static progress begin_progress(const plan *const p)
{
    const double now = seconds_now();
    const progress g = {.p = p, .begun = now, .last_report = now, .at_begin = count_runs(p)};
    if (g.at_begin > 0 && g.at_begin < p->runs) {
        fprintf(stderr, "  SWEEP %" PRIu64 " of %" PRIu64 " runs are there already\n", g.at_begin, p->runs);
    }
    return g;
}

/* A line each two seconds; on a terminal always the same line. */
static void tell_progress(progress *const g)
{
    const double at = seconds_now();
    if (at < g->last_report + 2.0) {
        return;
    }
    const uint64_t runs = count_runs(g->p);
    g->last_report = at;
    fprintf(stderr, "  SWEEP %" PRIu64 " of %" PRIu64 " runs", runs, g->p->runs);
    if (runs > g->at_begin) {
        const double left = (at - g->begun) * (double)(g->p->runs - runs) / (double)(runs - g->at_begin);
        fprintf(stderr, ", %.0f s left", left);
    }
    fputs(isatty(STDERR_FILENO) != 0 ? "   \r" : "\n", stderr);
}

static uint64_t absent(const plan *const p)
{
    uint64_t count = 0;
    for (uint64_t part = 0; part < p->parts; part++) {
        count += !plan_has_part(p, part);
    }
    return count;
}

/* Takes one part after the other from a pipe. Where the reader of `done` has ended, so does this with its next part. */
static _Noreturn void work(const plan *const p, const int queue, const int done)
{
    uint32_t part;
    while (read(queue, &part, sizeof part) == (ssize_t)sizeof part) {
        part_make(p, part);
        if (write(done, "", 1) != 1) {
            _exit(EXIT_FAILURE);
        }
    }
    _exit(EXIT_SUCCESS);
}

/* A pipe with the numbers of all parts that are absent; the plan has so few that they fit. */
static int queue_of(const plan *const p)
{
    int ends[2];
    if (pipe(ends) != 0) {
        plan_fail(strerror(errno), "a pipe");
    }
    for (uint64_t part = 0; part < p->parts; part++) {
        const uint32_t number = (uint32_t)part;
        if (!plan_has_part(p, part) && write(ends[1], &number, sizeof number) != (ssize_t)sizeof number) {
            plan_fail(strerror(errno), "a pipe");
        }
    }
    close(ends[1]);
    return ends[0];
}

uint64_t parts_make(const plan *const p, const unsigned processes)
{
    const int queue = queue_of(p);
    progress g = begin_progress(p);
    int done[2];
    if (pipe(done) != 0) {
        plan_fail(strerror(errno), "a pipe");
    }
    for (unsigned i = 0; i < processes; i++) {
        const pid_t child = fork();
        if (child < 0) {
            plan_fail(strerror(errno), "a process");
        }
        if (child == 0) {
            close(done[0]);
            work(p, queue, done[1]);
        }
    }
    close(done[1]);
    close(queue);
    struct pollfd wait_for = {.fd = done[0], .events = POLLIN};
    char bytes[64];
    bool runs = true;
    while (runs) {
        runs = poll(&wait_for, 1, 1000) <= 0 || read(done[0], bytes, sizeof bytes) > 0;
        tell_progress(&g);
    }
    int status;
    while (wait(&status) > 0) {
        if (WIFSIGNALED(status)) {
            fprintf(stderr, "sweep: a process was ended by signal %d\n", WTERMSIG(status));
        }
    }
    return absent(p);
}

uint64_t parts_watch(const plan *const p, const pid_t engine)
{
    static const struct timespec pause = {.tv_nsec = 200000000};
    progress g = begin_progress(p);
    while (kill(engine, 0) == 0 && absent(p) > 0) {
        nanosleep(&pause, NULL);
        tell_progress(&g);
    }
    return absent(p);
}
