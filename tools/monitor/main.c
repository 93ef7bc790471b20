/* Shows a plant that runs, by its A2L and XCP: a table with units and small curves, and the statistics; sets
 * tunables and faults, records outputs and inputs, and replays a record.
 *
 *     monitor A2L ADDRESS [OPTION...]
 *     monitor A2L --replay FILE [--once]
 */
#include <poll.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include "tools/file/file.h"
#include "tools/monitor/monitor.h"

enum { COMMANDS_MAX = 64, LINE_BYTES = 256, WAIT_MS = 10, PATIENCE_S_MAX = 1000000 };

typedef struct options {
    const char *a2l, *address, *record, *replay;
    const char *commands[COMMANDS_MAX];
    size_t command_count;
    double seconds, ticks; /* that it looks on for, both; 0: not asked for */
    double patience;       /* s */
    bool once, is_serial;
} options;

typedef struct session {
    const options *chosen;
    a2l description;
    display display;
    display_row **order; /* the rows by their addresses */
    master master;
    record record;
    char line[LINE_BYTES]; /* a command that is being typed behind ':' */
    bool is_typing, is_terminal, leaves;
    double tick; /* of the plant, when its values were read last */
    char message[sizeof(((master *)0)->problem)];
} session;

static const char usage[] =
    "usage: monitor A2L ADDRESS [OPTION...]\n"
    "       monitor A2L --replay FILE [--once]\n"
    "\n"
    "Shows a plant that `isochron link --xcp open` or `isochron a2l` built, over XCP: a table of what its A2L names.\n"
    "ADDRESS is that of ISOCHRON_CALIBRATION: tcp:HOST:PORT, udp:HOST:PORT or unix:PATH.\n"
    "\n"
    "    --once             prints one table and ends, as it does where the output is no terminal\n"
    "    --do COMMAND       does a command first: set NAME = VALUE, pause, run, step N, record FILE, stop,\n"
    "                       snapshot FILE, restore FILE\n"
    "    --record FILE      writes outputs and inputs of every tick to FILE, in the form of trace.csv\n"
    "    --seconds N        looks on for so many seconds, then ends\n"
    "    --ticks N          looks on until the plant has done so many ticks since it connected, then ends\n"
    "    --patience N       seconds that it waits for an answer of the plant; 5, unless told\n"
    "    --replay FILE      shows what was recorded\n"
    "    --serial           ADDRESS is a serial line, such as that of QEMU\n"
    "\n"
    "Keys: space pauses and runs, s does a step, q ends, : takes a command.\n";

/* Puts the result of a command into s->message. Returns whether it was done. */
__attribute__((format(printf, 3, 4))) static bool tell(session *const s, const bool good, const char *const format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(s->message, sizeof s->message, format, arguments);
    va_end(arguments);
    return good;
}

/* The same for a request to the plant: the message is `done`, or the problem of the master. */
static bool told(session *const s, const bool good, const char *const done)
{
    return tell(s, good, "%s", good ? done : s->master.problem);
}

/* --- Options ----------------------------------------------------------------------------------------------------- */

static bool take_number(double *const to, const char *const text)
{
    char *end = NULL;
    *to = strtod(text, &end);
    return end != text && *end == '\0' && *to > 0 && *to < 1e9;
}

/* Takes an option with its value. */
static bool take_valued(options *const chosen, const char *const name, const char *const value)
{
    if (strcmp(name, "--record") == 0) {
        chosen->record = value;
    } else if (strcmp(name, "--replay") == 0) {
        chosen->replay = value;
    } else if (strcmp(name, "--seconds") == 0) {
        return take_number(&chosen->seconds, value);
    } else if (strcmp(name, "--ticks") == 0) {
        return take_number(&chosen->ticks, value);
    } else if (strcmp(name, "--patience") == 0) {
        return take_number(&chosen->patience, value) && chosen->patience <= (double)PATIENCE_S_MAX;
    } else if (strcmp(name, "--do") == 0 && chosen->command_count < COMMANDS_MAX) {
        chosen->commands[chosen->command_count++] = value;
    } else {
        return false;
    }
    return true;
}

static bool take_options(options *const chosen, const int argc, char **const argv)
{
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--once") == 0) {
            chosen->once = true;
        } else if (strcmp(argv[i], "--serial") == 0) {
            chosen->is_serial = true;
        } else if (argv[i][0] == '-') {
            if (i + 1 == argc || !take_valued(chosen, argv[i], argv[i + 1])) {
                return false;
            }
            i++;
        } else if (chosen->a2l == NULL) {
            chosen->a2l = argv[i];
        } else if (chosen->address == NULL) {
            chosen->address = argv[i];
        } else {
            return false;
        }
    }
    const bool has_live = chosen->record != NULL || chosen->command_count > 0 || chosen->seconds > 0 ||
                          chosen->ticks > 0 || chosen->patience > 0 || chosen->is_serial;
    return chosen->a2l != NULL &&
           (chosen->replay == NULL ? chosen->address != NULL : chosen->address == NULL && !has_live);
}

/* --- Values ------------------------------------------------------------------------------------------------------ */

/* The quantities of one piece of memory: the plant's, or the statistics of the loop, the link or the slave. */
static int place_of(const char *const name)
{
    return strncmp(name, "statistics.", 11) != 0 ? 0
           : strncmp(name + 11, "link_", 5) == 0 ? 1
           : strncmp(name + 11, "xcp_", 4) == 0  ? 2
                                                 : 3;
}

static int by_address(const void *const a, const void *const b)
{
    const uint32_t x = (*(display_row *const *)a)->quantity->address, y = (*(display_row *const *)b)->quantity->address;
    return x < y ? -1 : x > y;
}

static void sort(session *const s)
{
    s->order = memory_for(s->display.count, sizeof(display_row *));
    for (size_t i = 0; i < s->display.count; i++) {
        s->order[i] = &s->display.rows[i];
    }
    qsort(s->order, s->display.count, sizeof(display_row *), by_address);
}

/* How many rows from one on have neighbouring places, which one block brings; *bytes: its length. */
static size_t block(const session *const s, const size_t from, uint8_t *const bytes)
{
    const a2l_quantity *const first = s->order[from]->quantity;
    size_t count = 0, used = 0;
    for (; from + count < s->display.count; count++) {
        const a2l_quantity *const q = s->order[from + count]->quantity;
        const bool is_next = q->address == first->address + used && place_of(q->name) == place_of(first->name);
        if (!is_next || used + a2l_bytes(q->type) > MASTER_BLOCK) {
            break;
        }
        used += a2l_bytes(q->type);
    }
    *bytes = (uint8_t)used;
    return count;
}

/* Reads all values; those of a block are of one tick. */
static bool read_values(session *const s)
{
    uint8_t bytes[MASTER_BLOCK], used = 0;
    for (size_t i = 0, count; i < s->display.count; i += count) {
        const uint32_t address = s->order[i]->quantity->address;
        count = block(s, i, &used);
        if (!master_read(&s->master, address, bytes, used)) {
            return false;
        }
        for (size_t k = i; k < i + count; k++) {
            display_row *const row = s->order[k];
            display_set(row, a2l_value(row->quantity->type, bytes + (row->quantity->address - address)));
            if (strcmp(row->quantity->name, "statistics.tick") == 0) {
                s->tick = row->value;
                s->display.time = row->value * s->description.step;
            } else if (strcmp(row->quantity->name, "statistics.ticks_left") == 0) {
                s->display.rests = row->value <= 0;
            }
        }
    }
    display_step(&s->display);
    return true;
}

/* --- Commands ---------------------------------------------------------------------------------------------------- */

static bool set(session *const s, const char *const rest)
{
    char name[A2L_TEXT_BYTES] = "";
    double value = 0;
    int used = 0;
    if (sscanf(rest, " %127[^ =] = %lf %n", name, &value, &used) != 2 || rest[used] != '\0') {
        return tell(s, false, "expected set NAME = VALUE, such as set p.damping = 0.2");
    }
    char full[A2L_TEXT_BYTES + 2];
    snprintf(full, sizeof full, "p.%s", name);
    const a2l_quantity *q = a2l_find(&s->description, full);
    q = q != NULL ? q : a2l_find(&s->description, name);
    if (q == NULL || !q->is_tunable) {
        return tell(s, false, q == NULL ? "there is no %.60s" : "%.60s is no tunable and no fault", name);
    }
    if (!(value >= q->least && value <= q->most)) {
        return tell(s, false, "%.60s must be from %g to %g %s", q->name, q->least, q->most, q->unit);
    }
    return master_set(&s->master, q, value) ? tell(s, true, "%.60s is %g %.30s", q->name, value, q->unit)
                                            : told(s, false, "");
}

static bool begin_record(session *const s, const char *const path)
{
    return s->record.file != NULL ? tell(s, false, "a record is being written; stop ends it")
                                  : told(s, record_begin(&s->record, &s->description, &s->master, path), "records");
}

static bool end_record(session *const s)
{
    if (s->record.file == NULL) {
        return tell(s, false, "no record is being written");
    }
    if (!record_end(&s->record, &s->master)) {
        return told(s, false, "");
    }
    return tell(s, true, "recorded %llu ticks%s", (unsigned long long)s->record.rows,
                s->record.lost > 0 ? "; some are missing: the channel had no room" : "");
}

static bool step(session *const s, const char *const rest)
{
    char *end = NULL;
    const unsigned long ticks = *rest == '\0' ? 1 : strtoul(rest, &end, 10);
    if ((end != NULL && *end != '\0') || ticks == 0 || ticks > INT32_MAX) {
        return tell(s, false, "expected step or step N, such as step 10");
    }
    return told(s, master_run(&s->master, (uint32_t)ticks), "steps");
}

/* Carries out a command; s->message has its result. */
static bool obey(session *const s, const char *const command)
{
    const char *const text = command + strspn(command, " ");
    if (strncmp(text, "set ", 4) == 0) {
        return set(s, text + 4);
    }
    if (strncmp(text, "record ", 7) == 0) {
        return begin_record(s, text + 7 + strspn(text + 7, " "));
    }
    if (strncmp(text, "snapshot ", 9) == 0) {
        return told(s, snapshot_save(&s->master, text + 9 + strspn(text + 9, " ")), "the snapshot is written");
    }
    if (strncmp(text, "restore ", 8) == 0) {
        return told(s, snapshot_load(&s->master, text + 8 + strspn(text + 8, " ")), "it rests at the snapshot");
    }
    if (strncmp(text, "step", 4) == 0 && (text[4] == ' ' || text[4] == '\0')) {
        return step(s, text + 4);
    }
    if (strcmp(text, "run") == 0) {
        return told(s, master_run(&s->master, 0), "runs");
    }
    if (strcmp(text, "pause") == 0) {
        return told(s, master_pause(&s->master), "pauses");
    }
    if (strcmp(text, "stop") == 0) {
        return end_record(s);
    }
    return tell(s, false,
                "'%.60s' is no command; there are: set NAME = VALUE, pause, run, step N, record FILE, stop, "
                "snapshot FILE, restore FILE",
                text);
}

/* --- The terminal ------------------------------------------------------------------------------------------------ */

static struct termios kept;

static void restore_terminal(void)
{
    (void)tcsetattr(STDIN_FILENO, TCSANOW, &kept);
    fputs("\033[?25h", stdout);
    fflush(stdout);
}

/* Keys come at once and are not shown. */
static void prepare_terminal(const session *const s)
{
    if (!s->is_terminal) {
        return;
    }
    if (tcgetattr(STDIN_FILENO, &kept) == 0) {
        struct termios raw = kept;
        raw.c_lflag &= ~(tcflag_t)(ICANON | ECHO);
        (void)tcsetattr(STDIN_FILENO, TCSANOW, &raw);
        atexit(restore_terminal);
    }
    fputs("\033[?25l\033[2J", stdout);
}

static void draw(const session *const s)
{
    char *text = NULL;
    size_t bytes = 0;
    FILE *const page = open_memstream(&text, &bytes);
    if (page == NULL) {
        abort();
    }
    display_write(page, &s->display);
    fprintf(page, "%s%s\n", s->is_typing ? ":" : "", s->is_typing ? s->line : s->message);
    fclose(page);
    fputs("\033[H", stdout);
    for (const char *at = text; *at != '\0'; at++) { /* the rest of each line of the screen is cleared */
        fputs(*at == '\n' ? "\033[K" : "", stdout);
        fputc(*at, stdout);
    }
    fputs("\033[J", stdout);
    fflush(stdout);
    free(text);
}

static void type(session *const s, const char key)
{
    const size_t n = strlen(s->line);
    if (key == '\n' || key == '\r') {
        s->is_typing = false;
        (void)obey(s, s->line);
    } else if (key == '\033') {
        s->is_typing = false;
    } else if (key == '\b' || key == 127) {
        s->line[n > 0 ? n - 1 : 0] = '\0';
    } else if (n + 1 < sizeof s->line) {
        s->line[n] = key;
        s->line[n + 1] = '\0';
    }
}

static void take_keys(session *const s)
{
    struct pollfd p = {.fd = STDIN_FILENO, .events = POLLIN};
    char key = 0;
    while (poll(&p, 1, 0) > 0 && read(STDIN_FILENO, &key, 1) == 1) {
        if (s->is_typing) {
            type(s, key);
        } else if (key == ':' && s->chosen->replay == NULL) {
            s->is_typing = true;
            s->line[0] = '\0';
        } else if (key == ' ' && s->chosen->replay == NULL) {
            (void)obey(s, s->display.rests ? "run" : "pause");
        } else if (key == 's' && s->chosen->replay == NULL) {
            (void)obey(s, "step");
        } else if (key == 'q') {
            s->leaves = true;
            return;
        }
    }
}

/* --- The run ----------------------------------------------------------------------------------------------------- */

/* Until q; or for so many seconds, with all values of that time, and so many ticks from the one on that was the
 * first. The table is printed only at the end where there is no terminal. */
static bool watch(session *const s, const double first)
{
    const bool has_end = s->chosen->seconds > 0 || s->chosen->ticks > 0;
    const double begin = seconds_now(), end = begin + s->chosen->seconds;
    double due = begin;
    while (!s->leaves && !(has_end && due >= end && seconds_now() >= end && s->tick - first >= s->chosen->ticks)) {
        if (!master_wait(&s->master, WAIT_MS)) {
            return false;
        }
        if (seconds_now() >= due) {
            due += DISPLAY_PERIOD;
            if (!read_values(s)) {
                return false;
            }
            if (s->is_terminal) {
                draw(s);
            }
        }
        if (s->is_terminal) {
            take_keys(s);
        }
    }
    return true;
}

static void live(session *const s)
{
    const options *const chosen = s->chosen;
    s->master.patience_ms = chosen->patience > 0 ? (int)(1000 * chosen->patience) : MASTER_PATIENCE_MS;
    if (!master_connect(&s->master, chosen->address, chosen->is_serial, s->description.epk) ||
        (chosen->ticks > 0 && !read_values(s))) {
        quit("monitor: %s", s->master.problem);
    }
    const double first = s->tick;
    for (size_t i = 0; i < chosen->command_count; i++) {
        if (!obey(s, chosen->commands[i])) {
            quit("monitor: %s", s->message);
        }
    }
    if (chosen->record != NULL && !begin_record(s, chosen->record)) {
        quit("monitor: %s", s->message);
    }
    prepare_terminal(s);
    bool good = s->is_terminal || chosen->seconds > 0 || chosen->ticks > 0 ? watch(s, first) : true;
    good = good && read_values(s);
    if (s->record.file != NULL) {
        good = end_record(s) && good;
    }
    if (!good) {
        quit("monitor: %s", s->master.problem);
    }
    (void)master_disconnect(&s->master);
}

static bool show_replay(void *const context)
{
    session *const s = context;
    if (s->is_terminal) {
        const struct timespec period = {.tv_nsec = (long)(DISPLAY_PERIOD * 1e9)};
        take_keys(s);
        draw(s);
        nanosleep(&period, NULL);
    }
    return !s->leaves;
}

int main(const int argc, char **const argv)
{
    static options chosen;
    static session s = {.chosen = &chosen};
    if (!take_options(&chosen, argc, argv)) {
        fputs(usage, stderr);
        return 2;
    }
    s.is_terminal = !chosen.once && isatty(STDOUT_FILENO) && isatty(STDIN_FILENO);
    s.description = a2l_read(chosen.a2l);
    display_make(&s.display, &s.description);
    sort(&s);
    if (chosen.replay != NULL) {
        prepare_terminal(&s);
        record_replay(chosen.replay, &s.description, &s.display, show_replay, &s);
    } else {
        live(&s);
    }
    if (!s.is_terminal) {
        display_write(stdout, &s.display);
    }
    free(s.display.rows);
    free(s.order);
    free(s.description.quantities);
    return 0;
}
