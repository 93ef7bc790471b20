/* Reads the lines of the program of `isochron conform` (core/conform), and prints for each duty of a port whether it
 * holds.
 *
 *     duties STACK COMMAND...
 *
 * COMMAND runs the program, with its console at the standard output, and the channel for a controller at descriptor 3.
 * STACK is the stack of a step in bytes as the compiler knows it; 0: it does not. Exit status 1 if a duty failed.
 */
#include <errno.h>
#include <inttypes.h>
#include <poll.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/conform/pattern.h"
#include "tools/link/child.h"

enum { WIRE = 3, PATIENCE_S = 60, LINE_BYTES = 256, END_MS = 5000 };

typedef struct reader {
    child program;
    unsigned long stack; /* bytes, 0: not known */
    int console, wire;
    uint32_t block, block_read; /* bytes of the block on the console: of which so many have come */
    uint32_t sent, returned;    /* bytes through the channel */
    bool echoes;                /* whether the program sends them back, as a first byte announces */
    bool has_wire;              /* false when the program has closed its end, or all is back */
    bool failed, over, is_done; /* is_done: the program has announced its end */
    int status;                 /* that the program has announced; -1: none */
    size_t line_bytes;
    char line[LINE_BYTES];
} reader;

__attribute__((format(printf, 4, 5))) static void verdict(reader *const r, const char *const duty, const bool good,
                                                          const char *const format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    printf("%s %s: ", duty, good ? "ok" : "FAILED");
    vprintf(format, arguments);
    printf("\n");
    va_end(arguments);
    fflush(stdout);
    r->failed = r->failed || !good;
}

/* Ends a run that cannot go on. */
static void give_up(reader *const r)
{
    r->over = true;
    child_stop(&r->program);
}

static void take_line(reader *const r)
{
    unsigned long number = 0;
    int end = 0;
    const char *const line = r->line;
    if (sscanf(line, "stack %lu%n", &number, &end) == 1 && line[end] == '\0') {
        if (r->stack == 0) {
            printf("stack has none: the compiler has no figure; a step took %lu bytes\n", number);
        } else {
            verdict(r, "stack", number > 0 && number <= r->stack, "a step took %lu of %lu bytes", number, r->stack);
        }
    } else if (sscanf(line, "console %" SCNu32 "%n", &r->block, &end) == 1 && line[end] == '\0') {
        r->block_read = 0;
    } else if (sscanf(line, "end %d%n", &r->status, &end) == 1 && line[end] == '\0') {
        r->is_done = true;
    } else {
        puts(line);
        fflush(stdout);
        r->failed = r->failed || strstr(line, " FAILED") != NULL;
    }
}

/* A byte of the block. The first one that differs shows that a byte was lost or changed. */
static void take_block(reader *const r, const uint8_t byte)
{
    if (byte != conform_byte(r->block_read)) {
        verdict(r, "console", false, "byte %" PRIu32 " of %" PRIu32 " is lost or another; what follows is not tried",
                r->block_read, r->block);
        give_up(r);
    } else if (++r->block_read == r->block) {
        verdict(r, "console", true, "%" PRIu32 " bytes", r->block);
        r->block = 0;
    }
}

static void take_console(reader *const r)
{
    uint8_t bytes[4096];
    const ssize_t came = read(r->console, bytes, sizeof bytes);
    if (came <= 0) {
        r->over = true;
    }
    for (ssize_t i = 0; i < came && !r->over; i++) {
        if (r->block > 0) {
            take_block(r, bytes[i]);
        } else if (bytes[i] == '\n' || r->line_bytes == sizeof r->line - 1) {
            r->line[r->line_bytes] = '\0';
            r->line_bytes = 0;
            take_line(r);
        } else {
            r->line[r->line_bytes++] = (char)bytes[i];
        }
    }
}

static void take_wire(reader *const r)
{
    uint8_t bytes[1024];
    const ssize_t came = recv(r->wire, bytes, sizeof bytes, MSG_DONTWAIT);
    ssize_t first = 0;
    r->has_wire = came > 0;
    if (came > 0 && !r->echoes && bytes[0] == CONFORM_OPEN) {
        r->echoes = true;
        first = 1;
    }
    for (ssize_t i = first; i < came; i++) {
        if (bytes[i] != conform_byte(r->returned)) {
            verdict(r, "channel", false, "byte %" PRIu32 " of %d is lost or another", r->returned,
                    (int)CONFORM_CHANNEL_BYTES);
            give_up(r);
            return;
        }
        r->returned++;
    }
    if (r->returned == CONFORM_CHANNEL_BYTES) {
        verdict(r, "channel", true, "%d bytes there and back", (int)CONFORM_CHANNEL_BYTES);
        r->has_wire = false;
    }
}

/* Pieces of 1 to 64 bytes. */
static void send_wire(reader *const r)
{
    enum { MOST = 64 };
    uint8_t bytes[MOST];
    const uint32_t left = CONFORM_CHANNEL_BYTES - r->sent, size = r->sent % MOST + 1, count = size < left ? size : left;
    for (uint32_t i = 0; i < count; i++) {
        bytes[i] = conform_byte(r->sent + i);
    }
    const ssize_t went = send(r->wire, bytes, count, MSG_DONTWAIT);
    r->sent += went > 0 ? (uint32_t)went : 0;
}

static void read_all(reader *const r)
{
    while (!r->over) {
        struct pollfd files[2] = {{.fd = r->console, .events = POLLIN},
                                  {.fd = r->has_wire ? r->wire : -1, .events = POLLIN}};
        files[1].events = (short)(r->echoes && r->sent < CONFORM_CHANNEL_BYTES ? POLLIN | POLLOUT : POLLIN);
        const int ready = poll(files, 2, r->is_done ? END_MS : PATIENCE_S * 1000);
        if (ready == 0 && r->is_done) {
            r->over = true;
        } else if (ready == 0) {
            verdict(r, r->echoes ? "channel" : "end", false, "nothing came for %d s%s", PATIENCE_S,
                    r->echoes ? ", and bytes are missing" : "");
            give_up(r);
        }
        if ((files[1].revents & (POLLIN | POLLHUP)) != 0) {
            take_wire(r);
        }
        if ((files[1].revents & POLLOUT) != 0) {
            send_wire(r);
        }
        if (files[0].revents != 0) {
            take_console(r);
        }
    }
}

int main(int count, char **const arguments)
{
    int wire[2], console[2];
    const int output = dup(STDOUT_FILENO);
    if (count < 3 || socketpair(AF_UNIX, SOCK_STREAM, 0, wire) != 0 || pipe(console) != 0 || output < 0) {
        fprintf(stderr, "usage: duties STACK COMMAND [ARGUMENT...]\n");
        return EXIT_FAILURE;
    }
    signal(SIGPIPE, SIG_IGN);
    dup2(console[1], STDOUT_FILENO);
    reader r = {.console = console[0],
                .wire = wire[0],
                .has_wire = true,
                .stack = strtoul(arguments[1], NULL, 10),
                .status = -1,
                .program = child_start("the program", arguments + 2, "ISOCHRON_CONTROLLER", "fd:3", wire[1], WIRE)};
    dup2(output, STDOUT_FILENO);
    close(console[1]);
    close(wire[1]);
    read_all(&r);
    while (r.echoes && r.has_wire) { /* bytes that the program sent before it ended */
        take_wire(&r);
    }
    if (r.echoes && !r.failed && r.returned < CONFORM_CHANNEL_BYTES) {
        verdict(&r, "channel", false, "%" PRIu32 " of %d bytes came back", r.returned, (int)CONFORM_CHANNEL_BYTES);
    }
    const bool ended = child_ends(&r.program, END_MS);
    if (r.status >= 0) {
        const bool as_said = ended && WIFEXITED(r.program.status) && WEXITSTATUS(r.program.status) == r.status;
        verdict(&r, "exit", as_said, as_said ? "status %d" : "not with status %d, as it said", r.status);
    } else if (!r.failed) {
        verdict(&r, "exit", false, "the program ended before its end");
    }
    child_stop(&r.program);
    return r.failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
