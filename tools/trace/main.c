/* Runs a plant, writes its outputs down as a table, and sums the run up.
 *
 *     trace -o DIRECTORY [--clock UNIT] -- COMMAND [ARGUMENT...]
 *
 * COMMAND writes its run to its standard output (core/application/stream.h). The table goes to DIRECTORY/trace.csv,
 * which is there only when it is whole, and a snapshot that the run takes to DIRECTORY/snapshot.bin. Exit status 0
 * means that the run reached its end with a finite state.
 */
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tools/file/file.h"
#include "tools/trace/decimal.h"
#include "tools/trace/stream.h"

typedef struct options {
    const char *directory;
    const char *clock; /* the unit of the port's clock */
    char **command;
} options;

static const char usage[] =
    "usage: trace -o DIRECTORY [--clock UNIT] -- COMMAND [ARGUMENT...]\n"
    "\n"
    "Runs COMMAND, writes its outputs to DIRECTORY/trace.csv, their units to units.csv there, the number of\n"
    "ticks and the last state to last.txt, and prints a summary.\n"
    "\n"
    "    -o DIRECTORY    an existing directory\n"
    "    --clock UNIT    what the platform's clock counts: ns (unless told), cycles,\n"
    "                    instructions (these are summed up as instructions_per_step)\n";

static options parse(const int argc, char **const argv)
{
    options chosen = {.clock = "ns"};
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--help") == 0) {
            fputs(usage, stdout);
            exit(EXIT_SUCCESS);
        } else if (strcmp(argv[i], "-o") == 0 && i + 1 < argc) {
            chosen.directory = argv[++i];
        } else if (strcmp(argv[i], "--clock") == 0 && i + 1 < argc) {
            chosen.clock = argv[++i];
        } else if (strcmp(argv[i], "--") == 0 && i + 1 < argc) {
            chosen.command = argv + i + 1;
            break;
        } else {
            break;
        }
    }
    if (chosen.directory == NULL || chosen.command == NULL) {
        fputs(usage, stderr);
        exit(EXIT_FAILURE);
    }
    return chosen;
}

/* Starts the command; its standard output is *output. */
static pid_t start(char **const command, FILE **const output)
{
    int ends[2];
    if (pipe(ends) != 0) {
        quit("trace: pipe: %s", strerror(errno));
    }
    const pid_t child = fork();
    if (child < 0) {
        quit("trace: fork: %s", strerror(errno));
    }
    if (child == 0) {
        dup2(ends[1], STDOUT_FILENO);
        close(ends[0]);
        close(ends[1]);
        execvp(command[0], command);
        fprintf(stderr, "trace: %s: %s\n", command[0], strerror(errno));
        _exit(EXIT_FAILURE);
    }
    close(ends[1]);
    *output = fdopen(ends[0], "rb");
    if (*output == NULL) {
        quit("trace: pipe: %s", strerror(errno));
    }
    return child;
}

/* A line on the terminal with the progress of the run, from half a second on and ten times a second. */
static void show_progress(const stream_header *const header, const uint64_t from, const uint64_t ticks, const bool last)
{
    enum { LOOK_EVERY = 256 };
    static double next;
    static bool shown;
    if (isatty(STDERR_FILENO) == 0) {
        return;
    }
    if (last) {
        fputs(shown ? "\r\033[K" : "", stderr);
        return;
    }
    if (ticks % LOOK_EVERY != 1) {
        return;
    }
    const double now = seconds_now();
    next = ticks == 1 ? now + 0.5 : next;
    if (now >= next) {
        next = now + 0.1;
        shown = true;
        const double t = (double)(from + ticks) * header->step_size;
        const double end = 1e-9 * (double)header->duration_ns;
        if (header->duration_ns > 0) {
            fprintf(stderr, "\r%s: %.1f s of %.1f s, %.0f %%\033[K", header->scene, t, end, 100 * t / end);
        } else {
            fprintf(stderr, "\r%s: %.1f s\033[K", header->scene, t);
        }
    }
}

/* One row: the time as tick times step, and the outputs. */
static void write_row(FILE *const table, const stream *const run, const uint64_t tick)
{
    char text[DECIMAL_BYTES];
    fputs(decimal_of((double)tick * run->header.step_size, sizeof(double), text), table);
    for (size_t i = 0; i < run->header.outputs; i++) {
        fprintf(table, ",%s", stream_value(run, i, text));
    }
    fputc('\n', table);
}

/* Copies the rows of the run, from its first tick on, to the table. False: run->error says why it stopped. */
static bool write_table(FILE *const table, stream *const run)
{
    if (!stream_read_header(run)) {
        return false;
    }
    fprintf(table, run->header.outputs > 0 ? "t,%s\n" : "t\n", run->header.names);
    uint64_t rows = 0;
    stream_part part = stream_read(run);
    for (; part == STREAM_ROW; part = stream_read(run)) {
        write_row(table, run, run->from + rows);
        rows++;
        if (ferror(table) != 0) {
            snprintf(run->error, sizeof run->error, "the table cannot be written: %s", strerror(errno));
            return false;
        }
        show_progress(&run->header, run->from, rows, false);
    }
    show_progress(&run->header, run->from, rows, true);
    if (part == STREAM_END && rows != run->end.ticks + 1) {
        snprintf(run->error, sizeof run->error, "%" PRIu64 " ticks were done, but %" PRIu64 " rows arrived",
                 run->end.ticks, rows);
        return false;
    }
    return part == STREAM_END;
}

/* The execution times of steps, those with a restart of the method apart, since the others are all alike; of whole
 * ticks; and of the trace of a tick. In virtual time nothing takes time, and nothing is printed. */
static void print_execution(const stream *const run, const char *const unit)
{
    const stream_end *const end = &run->end;
    const uint64_t steady = end->ticks - end->restarts;
    if (steady > 0 && end->execution_max > 0) {
        printf("execution %" PRIu64 " %.1f %" PRIu64 " %s\n", end->execution_min,
               (double)end->execution_sum / (double)steady, end->execution_max, unit);
    }
    if (end->restarts > 0 && end->restart_max > 0) {
        printf("restart_execution %" PRIu64 " %s\n", end->restart_max, unit);
    }
    if (end->ticks > 0 && (end->execution_max > 0 || end->margin != run->header.period_ns)) {
        printf("margin %" PRId64 " %s\n", (int64_t)end->margin, unit);
    }
    if (run->tick_max > 0) {
        printf("tick %" PRIu64 " %" PRIu64 " %s\n", run->tick_min, run->tick_max, unit);
        printf("tracing %.1f %s\n", (double)run->beside / (double)end->ticks, unit);
    }
}

/* The counts of the scene's policies: core/runtime/policy.h. */
static void print_policy(const stream *const run, const char *const unit)
{
    const iso_policy_counts *const counts = &run->policy.counted.counts;
    if (run->policy_words > 0) {
        printf("grace_late %" PRIu64 "\ngrace_overruns %" PRIu64 "\n", counts->grace_late, counts->grace_overruns);
        printf("latency %" PRIu64 " ticks\n", counts->latency);
    }
    if (counts->skipped > 0) {
        printf("skipped %" PRIu64 " from %" PRIu64 " to %" PRIu64 "\n", counts->skipped, counts->skipped_first,
               counts->skipped_last);
    }
    if (counts->degraded > 0) {
        printf("degraded %" PRIu64 " to rung %" PRIu64 "\n", counts->degraded, counts->lowest);
    }
    if (run->policy_words < STREAM_POLICY_WORDS) {
        return;
    }
    const iso_policy_histogram *const histogram = &run->policy.counted;
    for (uint64_t i = 0; i < ISO_HISTOGRAM_BINS; i++) {
        if (histogram->bins[i] > 0 && i + 1 < ISO_HISTOGRAM_BINS) {
            printf("histogram %" PRIu64 " to %" PRIu64 " %s: %" PRIu64 "\n", i * histogram->width,
                   (i + 1) * histogram->width, unit, histogram->bins[i]);
        } else if (histogram->bins[i] > 0) {
            printf("histogram from %" PRIu64 " %s: %" PRIu64 "\n", i * histogram->width, unit, histogram->bins[i]);
        }
    }
}

/* A count, where there is one. */
static void print_count(const char *const key, const uint64_t count)
{
    if (count > 0) {
        printf("%s %" PRIu64 "\n", key, count);
    }
}

static void write_state(FILE *const file, const stream *const run)
{
    char text[DECIMAL_BYTES];
    fputs("state", file);
    for (size_t i = 0; i < run->header.states; i++) {
        fprintf(file, " %s", stream_value(run, i, text));
    }
    fputc('\n', file);
}

/* The end of the run: the ticks from the start, and the last state. */
static void write_last(const char *const directory, const stream *const run)
{
    static new_file f;
    file_must_begin(&f, "trace", directory, "last.txt", "partial");
    fprintf(f.to, "ticks %" PRIu64 "\n", run->from + run->end.ticks);
    write_state(f.to, run);
    file_must_end(&f, "trace");
}

static void print_summary(const stream *const run, const char *const unit, const char *const path)
{
    const stream_header *const header = &run->header;
    const stream_end *const end = &run->end;
    char text[DECIMAL_BYTES];

    printf("scene %s\nmethod %s\nstep %s\nreal %s\n", header->scene, header->method, header->step, header->real);
    print_count("from", run->from);
    printf("ticks %" PRIu64 "\nlate %" PRIu64 "\nlost %" PRIu64 "\noverruns %" PRIu64 "\n", end->ticks, end->late,
           end->lost, end->overruns);
    print_execution(run, unit);
    write_state(stdout, run);
    printf("hash %016" PRIx64 "\n", end->hash);
    print_count("restarts", end->restarts + end->adams_restarts);
    if (end->substeps > 0) {
        printf("substeps %" PRIu64 "\nrejected %" PRIu64 "\nbudget_bound %" PRIu64 "\nevaluations %" PRIu64 "\n",
               end->substeps, end->rejected, end->budget_bound, end->evaluations);
    }
    if (strcmp(stream_value(run, header->states, text), "0") != 0) {
        printf("local_error %s\n", text);
    }
    if (strcmp(stream_value(run, header->states + 1, text), "0") != 0) {
        printf("violation %s\nviolated %" PRIu64 "\n", text, end->violated);
    }
    if (end->near_singular > 0) {
        char closure[STREAM_TEXT_BYTES];
        printf("near_singular %" PRIu64 " from %.9g s in %s\n", end->near_singular,
               (double)end->near_singular_first * header->step_size,
               stream_name(header->closure_names, end->near_singular_closure, closure));
    }
    print_count("events", end->events);
    print_count("late_events", end->late_events);
    print_count("inputs_held", end->inputs_held);
    print_count("inputs_clamped", end->inputs_clamped);
    print_count("tunables_held", end->tunables_held);
    print_count("tunables_clamped", end->tunables_clamped);
    print_count("outputs_held", end->outputs_held);
    if (end->ticks > end->restarts && strcmp(unit, "instructions") == 0) {
        const uint64_t more = end->execution_max - end->execution_min;
        printf("instructions_per_step %" PRIu64, end->execution_min);
        if (more > 0) {
            printf(" %" PRIu64, end->execution_max);
        }
        /* The next tick was due before the step ended; the steps of adams differ by themselves. */
        if (more > 0 && end->overruns + end->late + end->lost > 0 && strcmp(header->method, "adams") != 0) {
            printf(", up to %" PRIu64 " of them of the interrupts of ticks that came during a step", more);
        }
        printf("\n");
    }
    print_policy(run, unit);
    printf("trace %s\n", path);
}

/* Waits for the command; how it ended, in words, or NULL if well. */
static const char *verdict(const pid_t child)
{
    static char text[64];
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) {
            return strerror(errno);
        }
    }
    const bool by_signal = WIFSIGNALED(status);
    snprintf(text, sizeof text, "it ended %s %d", by_signal ? "by signal" : "with status",
             by_signal ? WTERMSIG(status) : WEXITSTATUS(status));
    return status == 0 ? NULL : text;
}

/* Runs the command and writes the table. False, with a message and no table, unless the run is whole; a run that the
 * guard stopped is whole. */
static bool write_down(const options *const chosen, stream *const run, FILE *const table)
{
    const pid_t child = start(chosen->command, &run->file);
    const bool whole = write_table(table, run);
    const bool given_up = !whole && feof(run->file) == 0;
    if (given_up) {
        kill(child, SIGTERM);
    }
    fclose(run->file);
    const char *const ended = verdict(child);
    if (whole && (ended == NULL || run->end.guard != run->header.states || run->policy.counted.counts.stopped > 0)) {
        return true;
    }
    const bool shows_end = ended != NULL && !given_up;
    fprintf(stderr, "trace: %s: %s%s%s\n", chosen->command[0], whole ? "" : run->error, !whole && shows_end ? "; " : "",
            shows_end ? ended : "");
    return false;
}

/* Writes a snapshot that was taken to a file. Returns its path; NULL: there is none. */
static const char *write_snapshot(const char *const directory, const stream *const run)
{
    if (run->snapshot == NULL) {
        return NULL;
    }
    static new_file f;
    file_must_begin(&f, "trace", directory, "snapshot.bin", "partial");
    (void)fwrite(run->snapshot, 1, run->snapshot_bytes, f.to);
    file_must_end(&f, "trace");
    return f.path;
}

/* The columns of the table and their units, in the same order. */
static void write_units(FILE *const file, const stream_header *const header)
{
    const char *const comma = header->outputs > 0 ? "," : "";
    fprintf(file, "t%s%s\ns%s", comma, header->names, comma);
    for (const char *c = header->names; header->units[0] == '\0' && *c != '\0'; c++) {
        fputs(*c == ',' ? "," : "", file);
    }
    fprintf(file, "%s\n", header->units);
}

int main(int argc, char **argv)
{
    static stream run;
    static new_file table, units;
    static char name[STREAM_TEXT_BYTES];
    const options chosen = parse(argc, argv);
    file_must_begin(&table, "trace", chosen.directory, "trace.csv", "partial");
    file_must_begin(&units, "trace", chosen.directory, "units.csv", "partial");
    if (!write_down(&chosen, &run, table.to)) {
        file_drop(&table);
        file_drop(&units);
        return EXIT_FAILURE;
    }
    write_units(units.to, &run.header);
    if (!file_end(&units) || !file_end(&table)) {
        const int why = errno;
        file_drop(&table);
        quit("trace: %s: %s", table.path, strerror(why));
    }
    write_last(chosen.directory, &run);
    const char *const snapshot = write_snapshot(chosen.directory, &run);
    print_summary(&run, chosen.clock, table.path);
    if (snapshot != NULL) {
        printf("snapshot %s\n", snapshot);
    }
    if (fflush(stdout) != 0) {
        quit("trace: standard output: %s", strerror(errno));
    }
    if (run.end.guard < run.header.states) {
        fprintf(stderr, "trace: guard state %" PRIu64 "%s%s at tick %" PRIu64 ": it is %s\n", run.end.guard,
                run.header.state_names[0] == '\0' ? "" : " ", stream_name(run.header.state_names, run.end.guard, name),
                run.end.tick, isfinite(stream_number(&run, run.end.guard)) ? "out of range" : "not finite");
        return EXIT_FAILURE;
    }
    if (run.end.guard > run.header.states) {
        fprintf(stderr, "trace: guard at tick %" PRIu64 ": near a singular position of closure %s\n", run.end.tick,
                stream_name(run.header.closure_names, run.end.near_singular_closure, name));
        return EXIT_FAILURE;
    }
    if (run.policy.counted.counts.stopped > 0) {
        fprintf(stderr, "trace: stopped by the overrun of tick %" PRIu64 "\n", run.policy.counted.counts.stopped);
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
