/* Makes the runs of a sweep; compiled with its plants.
 *
 *     sweep FOLDER make PROCESSES      makes all parts of FOLDER/plan that are absent, and shows the progress
 *     sweep FOLDER part NUMBER...      makes these parts
 *     sweep FOLDER share NUMBER OF     makes the parts of a share of so many: each OFth part, where it is absent
 *     sweep FOLDER watch PROCESS       shows the progress, as long as that process runs
 *     sweep FOLDER absent              prints the numbers of the parts that are absent
 *     sweep FOLDER table TO AGAIN      writes the table into the folder TO; AGAIN begins a command for one run
 *
 * The exit status is 1 where parts are absent in the end.
 */
#define _POSIX_C_SOURCE 200809L
#include <inttypes.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "tools/sweep/parts.h"
#include "tools/sweep/run.h"
#include "tools/sweep/steps.h"
#include "tools/sweep/table.h"

static uint64_t whole(const char *const text)
{
    char *end = NULL;
    const uint64_t number = strtoull(text, &end, 10);
    if (text[0] < '0' || text[0] > '9' || *end != '\0') {
        plan_fail("it is no number", text);
    }
    return number;
}

static int told(const uint64_t absent)
{
    if (absent > 0) {
        fprintf(stderr, "sweep: %" PRIu64 " parts are absent; the same command goes on\n", absent);
    }
    return absent == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

/* Plants side by side are compiled for the processor of one machine. */
static void end_on_another_processor(const int number)
{
    static const char text[] = "sweep: this processor lacks instructions of that for which the program was compiled; "
                               "with --lanes 1 it is for all\n";
    const ssize_t written = write(STDERR_FILENO, text, sizeof text - 1);
    (void)number;
    (void)written;
    _exit(EXIT_FAILURE);
}

int main(const int count, char **const arguments)
{
    const char *const verb = count > 2 ? arguments[2] : "";
    if (count < 3) {
        plan_fail("it needs a folder, and what to do", "sweep");
    }
    plan p = plan_read(arguments[1]);
    (void)signal(SIGILL, end_on_another_processor);
    plan_widen(&p, steps_width);
    run_check(&p);
    if (strcmp(verb, "make") == 0 && count == 4) {
        return told(parts_make(&p, (unsigned)whole(arguments[3])));
    }
    if (strcmp(verb, "watch") == 0 && count == 4) {
        return told(parts_watch(&p, (pid_t)whole(arguments[3])));
    }
    if (strcmp(verb, "table") == 0 && count == 5) {
        table_make(&p, arguments[3], arguments[4]);
        return EXIT_SUCCESS;
    }
    if (strcmp(verb, "part") == 0) {
        for (int i = 3; i < count; i++) {
            part_make(&p, whole(arguments[i]));
        }
        return EXIT_SUCCESS;
    }
    if (strcmp(verb, "share") == 0 && count == 5) {
        const uint64_t stride = whole(arguments[4]);
        for (uint64_t part = whole(arguments[3]); part < p.parts && stride > 0; part += stride) {
            part_make(&p, part);
        }
        return EXIT_SUCCESS;
    }
    if (strcmp(verb, "absent") != 0 || count != 3) {
        plan_fail("it is not known, or has other arguments", verb);
    }
    for (uint64_t part = 0; part < p.parts; part++) {
        if (!plan_has_part(&p, part)) {
            printf("%" PRIu64 "\n", part);
        }
    }
    return EXIT_SUCCESS;
}
