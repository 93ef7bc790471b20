/* Linux in real time: a clock of nanoseconds, and ticks by sleeping until an absolute time.
 *
 *     PROGRAM [NANOSECONDS]
 *
 * Where it is allowed, the program has a real-time priority and keeps its memory from being paged out; a missing
 * permission is named on the standard error. Ticks that the system was too late for are in the account, as on a board.
 */
#define _GNU_SOURCE

#include <errno.h>
#include <sched.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <time.h>

#include "port/none/inputs.h"
#include "port/none/outputs.h"
#include "port/port.h"
#include "port/unix/channel.h"
#include "port/unix/console.h"

/* In the middle of the real-time priorities: above all programs that have none, and below the threads that serve
 * devices. */
enum { PRIORITY = 49 };

static uint64_t start; /* on the clock of the system, ns */
static uint64_t period;
static uint64_t reported; /* the last tick that a wait returned */

static uint64_t now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (uint64_t)time.tv_sec * 1000000000 + (uint64_t)time.tv_nsec;
}

static void warn(const char *const what, const char *const so)
{
    fprintf(stderr, "posix: no %s (%s): %s\n", what, strerror(errno), so);
}

/* Takes a real-time priority, locks the memory, and reduces the slack of timers, by default 50 us, to 1 ns. */
static void become_punctual(void)
{
    if (sched_setscheduler(0, SCHED_FIFO, &(struct sched_param){.sched_priority = PRIORITY}) != 0) {
        warn("SCHED_FIFO", "other programs can make ticks late");
    }
    if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) {
        warn("mlockall", "memory that is paged out can make ticks late");
    }
    (void)prctl(PR_SET_TIMERSLACK, 1);
}

uint32_t iso_port_start(const uint32_t period_ns)
{
    become_punctual();
    period = period_ns;
    reported = 0;
    start = now();
    return period_ns;
}

uint64_t iso_port_clock(void)
{
    return now() - start;
}

uint64_t iso_port_wait(void)
{
    const uint64_t due = start + (reported + 1) * period;
    const struct timespec time = {.tv_sec = (time_t)(due / 1000000000), .tv_nsec = (long)(due % 1000000000)};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, NULL) == EINTR) {
    }
    reported = iso_port_clock() / period;
    return reported;
}

int64_t host_until_tick(void)
{
    const uint64_t due = (reported + 1) * period;
    const uint64_t time = iso_port_clock();
    return time < due ? (int64_t)(due - time) : 0;
}

uint64_t iso_port_duration(const int argc, char **const argv)
{
    return console_duration(argc, argv);
}
