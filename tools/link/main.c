/* Connects a plant with a controller, watches their frames, and prints a summary.
 *
 *     link -o DIRECTORY --header FILE [--controller COMMAND] [--mode lockstep|free] [--patience SECONDS]
 *          [--end plant|controller] -- PLANT...
 *
 * PLANT writes the table of its outputs to DIRECTORY, and a summary to the standard output, as build/trace does. It
 * finds its end of the wire at descriptor 3, as ISOCHRON_CONTROLLER in its environment says; the controller connects
 * with the address in ISOCHRON_LINK. Exit status 0 means that both ended well.
 */
#include <errno.h>
#include <inttypes.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tools/link/child.h"
#include "tools/link/link.h"

enum { PLANT_FILE = 3, LOOK_MS = 50, PATIENCE_S = 10, PATIENCE_S_MAX = 3600, FAREWELL_MS = 5000, TEXT_BYTES = 256 };

typedef struct options {
    const char *directory, *header, *controller;
    int mode;
    int patience; /* s */
    bool ends_with_controller;
    char **plant;
} options;

/* The programs that run, and the first failure. */
typedef struct session {
    const options *chosen;
    wire wire;
    child plant, controller;
    char problem[TEXT_BYTES];
} session;

static const char usage[] =
    "usage: link -o DIRECTORY --header FILE [--controller COMMAND] [--mode lockstep|free] [--patience SECONDS]\n"
    "            [--end plant|controller] -- PLANT [ARGUMENT...]\n"
    "\n"
    "Starts PLANT and, with a shell, COMMAND; connects them, and prints how their exchanges went.\n"
    "\n"
    "    -o DIRECTORY           where PLANT writes trace.csv, which gets the inputs besides\n"
    "    --header FILE          the header that isoc wrote for a controller of it\n"
    "    --controller COMMAND   without it: prints the address, and waits for a controller there\n"
    "    --mode MODE            lockstep or free, instead of what the controller asks for\n"
    "    --patience SECONDS     how long COMMAND may send nothing; 10, unless told\n"
    "    --end controller       the run ends when the controller has closed its link, if it has not ended it before\n";

static volatile sig_atomic_t caught;

static void catch_signal(const int number)
{
    caught = number;
}

static int mode_of(const char *const name)
{
    return strcmp(name, "lockstep") == 0 ? ISO_LINK_LOCKSTEP : strcmp(name, "free") == 0 ? ISO_LINK_FREE : WIRE_NONE;
}

/* Takes an option with its value. Returns whether it is one. */
static bool take_option(options *const chosen, const char *const name, const char *const value)
{
    if (strcmp(name, "-o") == 0) {
        chosen->directory = value;
    } else if (strcmp(name, "--header") == 0) {
        chosen->header = value;
    } else if (strcmp(name, "--controller") == 0) {
        chosen->controller = value;
    } else if (strcmp(name, "--mode") == 0) {
        chosen->mode = mode_of(value);
        return chosen->mode != WIRE_NONE;
    } else if (strcmp(name, "--patience") == 0) {
        chosen->patience = atoi(value);
        return chosen->patience > 0 && chosen->patience <= PATIENCE_S_MAX;
    } else if (strcmp(name, "--end") == 0) {
        chosen->ends_with_controller = strcmp(value, "controller") == 0;
        return chosen->ends_with_controller || strcmp(value, "plant") == 0;
    } else {
        return false;
    }
    return true;
}

static options parse(const int argc, char **const argv)
{
    options chosen = {.mode = WIRE_NONE, .patience = PATIENCE_S};
    int i = 1;
    while (i + 1 < argc && strcmp(argv[i], "--") != 0 && take_option(&chosen, argv[i], argv[i + 1])) {
        i += 2;
    }
    if (argc == 2 && strcmp(argv[1], "--help") == 0) {
        fputs(usage, stdout);
        exit(EXIT_SUCCESS);
    }
    if (i + 1 >= argc || strcmp(argv[i], "--") != 0 || chosen.directory == NULL || chosen.header == NULL) {
        fputs(usage, stderr);
        exit(EXIT_FAILURE);
    }
    chosen.plant = argv + i + 1;
    return chosen;
}

/* Keeps the first error. Returns true. */
static bool tell(session *const s, const char *const what)
{
    if (s->problem[0] == '\0') {
        snprintf(s->problem, sizeof s->problem, "%s", what);
    }
    return true;
}

/* Whether no more frames are to be expected. With a controller that is started by hand there is no limit of time. */
static bool is_lost(session *const s)
{
    const uint64_t silence_ms = (wire_clock() - s->wire.heard) / 1000000;
    const uint64_t patience_ms = (uint64_t)s->chosen->patience * 1000;
    char text[TEXT_BYTES];
    if (s->chosen->controller == NULL) {
        return false;
    }
    if (!child_runs(&s->controller) && s->wire.account.exchanges == 0 && !s->wire.account.ended) {
        const char *const fault = child_fault(&s->controller);
        snprintf(text, sizeof text, "%s and has exchanged nothing", fault == NULL ? "the controller ended" : fault);
        return tell(s, text);
    }
    if (silence_ms > patience_ms && s->wire.controller == WIRE_NONE && s->controller.running) {
        snprintf(text, sizeof text, "the controller has not connected for %d s", s->chosen->patience);
        return tell(s, text);
    }
    if (silence_ms > patience_ms || (!s->controller.running && silence_ms > FAREWELL_MS)) {
        snprintf(text, sizeof text, "nothing comes any more: %s at tick %" PRIu64,
                 s->controller.running ? "plant and controller both wait" : "the controller has ended, the plant waits",
                 s->wire.account.newest);
        return tell(s, text);
    }
    return false;
}

/* Whether the controller of a run has gone, and with it the run is to end. */
static bool is_over(session *const s)
{
    return s->chosen->ends_with_controller && s->wire.controller == WIRE_NONE && s->wire.account.arrival > 0 &&
           !child_runs(&s->controller);
}

/* Runs until the plant has ended or no more frames are to be expected. */
static void run(session *const s)
{
    wire_event event = WIRE_PASSED;
    bool is_ending = false;
    while (caught == 0 && event != WIRE_PLANT_GONE && (event != WIRE_SILENT || !is_lost(s))) {
        is_ending = is_ending || (is_over(s) && wire_end(&s->wire));
        event = wire_pass(&s->wire, LOOK_MS);
    }
}

/* Checks how a program ended that had to end by itself. */
static void see_off(session *const s, child *const c, const char *const stays)
{
    if (caught != 0 || s->problem[0] != '\0') {
        return;
    }
    if (!child_ends(c, FAREWELL_MS)) {
        tell(s, stays);
    } else if (child_fault(c) != NULL) {
        tell(s, child_fault(c));
    }
}

static void print_summary(account *const a)
{
#define PRINT_COUNT(name)                                                                                              \
    if (a->end.link.name > 0) {                                                                                        \
        printf("link_" #name " %" PRIu64 "\n", a->end.link.name);                                                      \
    }
    ISO_LINK_COUNTS(PRINT_COUNT)
    const account_trips trips = account_sum(a);
    printf("controller_max %.3g ms\nexchange_max %.3g ms\n", 1e-6 * (double)trips.longest,
           1e-6 * (double)trips.whole_longest);
    printf("exchanges %zu, median %.3g ms, of which the controller %.3g ms, missed %" PRIu64 "\n", trips.count,
           1e-6 * (double)trips.whole_median, 1e-6 * (double)trips.median, a->end.link.missing);
}

/* The inode number of the file, which a new file of its name does not have; 0 if there is none. */
static ino_t number_of(const char *const directory)
{
    char path[4096];
    struct stat found;
    snprintf(path, sizeof path, "%s/trace.csv", directory);
    return stat(path, &found) == 0 ? found.st_ino : 0;
}

/* Runs both, and ends both. */
static void connect_both(session *const s, const char *const address, const char *const path)
{
    const options *const chosen = s->chosen;
    const int end = wire_open(&s->wire, path, chosen->mode);
    s->plant = child_start("the plant", chosen->plant, "ISOCHRON_CONTROLLER", "fd:3", end, PLANT_FILE);
    close(end);
    if (chosen->controller != NULL) {
        char shell[] = "sh", flag[] = "-c";
        char *const command[] = {shell, flag, (char *)(uintptr_t)chosen->controller, NULL};
        s->controller = child_start("the controller", command, "ISOCHRON_LINK", address, WIRE_NONE, WIRE_NONE);
    } else {
        fprintf(stderr, "link: waiting for a controller with ISOCHRON_LINK=%s\n", address);
    }
    run(s);
    if (caught != 0 || s->problem[0] != '\0') {
        child_stop(&s->plant);
        child_stop(&s->controller);
    }
    wire_finish(&s->wire, FAREWELL_MS);
    see_off(s, &s->plant, "the plant has closed its link, and does not end");
    see_off(s, &s->controller, "the controller does not end when the run is over");
    child_stop(&s->controller);
    child_stop(&s->plant);
    if (!s->wire.account.ended) {
        tell(s, "the plant ended and did not say how the run went");
    }
}

int main(const int argc, char **const argv)
{
    static session s;
    const options chosen = parse(argc, argv);
    const struct sigaction on_signal = {.sa_handler = catch_signal};
    sigaction(SIGINT, &on_signal, NULL);
    sigaction(SIGTERM, &on_signal, NULL);
    sigaction(SIGHUP, &on_signal, NULL);
    signal(SIGPIPE, SIG_IGN);

    char folder[] = "/tmp/isochron-XXXXXX";
    char address[sizeof folder + sizeof "unix:/link"];
    if (mkdtemp(folder) == NULL) {
        fprintf(stderr, "link: %s: %s\n", folder, strerror(errno));
        return EXIT_FAILURE;
    }
    snprintf(address, sizeof address, "unix:%s/link", folder);
    const char *const path = address + strlen("unix:");
    const ino_t before = number_of(chosen.directory);
    s.chosen = &chosen;
    connect_both(&s, address, path);
    unlink(path);
    rmdir(folder);

    if (caught == 0 && s.wire.account.ended) {
        if (number_of(chosen.directory) != before) {
            columns_add(chosen.directory, chosen.header, &s.wire.account);
        }
        print_summary(&s.wire.account);
    }
    account_free(&s.wire.account);
    if (caught != 0) {
        return 128 + caught;
    }
    if (s.problem[0] != '\0') {
        fprintf(stderr, "link: %s\n", s.problem);
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
