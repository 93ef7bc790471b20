/* The channels of the host: what goes into one comes out again, at every kind of address, whoever comes and goes.
 *
 *     channels FOLDER    FOLDER is for sockets
 *
 * Whoever waits does so for an event, or as long as a test may take (tests/harness/tap.py).
 *
 * A plant, here one that sends back what it receives, is a child of this program, which is the peer.
 */
#define _GNU_SOURCE

#include <arpa/inet.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include "port/channel.h"
#include "tests/host/report.h"

enum { PORTION = 700, RECORD = 1000, TEXT = 512, PATIENCE_MS = 1800000, MOST_RECORDS = 20000 };

/* --- Plants ------------------------------------------------------------------------------------------------------ */

typedef void plant(void);

/* Sends back what it receives on each channel; on the second with all bits turned. */
static void echo(void)
{
    uint8_t bytes[PORTION];
    for (;;) {
        iso_port_idle();
        for (int channel = 0; channel < ISO_CHANNELS; channel++) {
            const size_t count = iso_port_receive((iso_channel)channel, bytes, sizeof bytes);
            for (size_t i = 0; i < count; i++) {
                bytes[i] = (uint8_t)(channel == ISO_CHANNEL_CALIBRATION ? ~bytes[i] : bytes[i]);
            }
            if (count > 0) { /* a peer that has gone meanwhile gets no answer, and the next one not that of another */
                (void)iso_port_send((iso_channel)channel, bytes, count);
            }
        }
    }
}

/* Sends where nobody is, and ends with how many calls said that they did. */
static void send_alone(void)
{
    _exit(iso_port_send(ISO_CHANNEL_CONTROLLER, "1", 1) + iso_port_send(ISO_CHANNEL_CALIBRATION, "2", 1));
}

/* When a byte has come: numbered records until there is no room, which it says, more than the system ever has room for;
 * and the number of them at the end. */
static void flood(void)
{
    uint8_t record[RECORD] = {0};
    while (iso_port_receive(ISO_CHANNEL_CONTROLLER, record, 1) == 0) {
        iso_port_idle();
    }
    uint32_t number = 0;
    do {
        memcpy(record, &number, sizeof number);
        number++;
    } while (iso_port_send(ISO_CHANNEL_CONTROLLER, record, sizeof record) && number < MOST_RECORDS);
    (void)!write(STDERR_FILENO, "full\n", strlen("full\n"));
    memset(record, 0xFF, sizeof record);
    memcpy(record + 1, &number, sizeof number);
    while (!iso_port_send(ISO_CHANNEL_CONTROLLER, record, sizeof record)) {
        iso_port_idle();
    }
    for (;;) {
        iso_port_idle();
    }
}

typedef struct child {
    pid_t id;
    int errors; /* what it writes to its standard error */
} child;

static child start(plant *const run, const char *const controller, const char *const calibration, const int keep)
{
    int ends[2];
    child made = {.id = pipe(ends) == 0 ? fork() : -1};
    if (made.id == 0) {
        setenv("ISOCHRON_CONTROLLER", controller, 1);
        setenv("ISOCHRON_CALIBRATION", calibration, 1);
        dup2(ends[1], STDERR_FILENO);
        for (int file = STDERR_FILENO + 1; file < 64; file++) {
            if (file != keep) {
                close(file);
            }
        }
        run();
    }
    close(ends[1]);
    made.errors = ends[0];
    return made;
}

/* The next line that it writes, without its end; empty if there is none. */
static const char *says(const child *const who)
{
    static char text[TEXT];
    size_t length = 0;
    struct pollfd file = {.fd = who->errors, .events = POLLIN};
    while (length + 1 < sizeof text && poll(&file, 1, PATIENCE_MS) > 0 && read(who->errors, text + length, 1) == 1 &&
           text[length] != '\n') {
        length++;
    }
    text[length] = '\0';
    return text;
}

/* The place where it waits, by what it says. */
static const char *place(const child *const who)
{
    const char *const said = strstr(says(who), "waiting at ");
    return said == NULL ? "" : said + strlen("waiting at ");
}

static int end(const child *const who)
{
    int status = 0;
    kill(who->id, SIGKILL);
    waitpid(who->id, &status, 0);
    close(who->errors);
    return status;
}

/* Its status when it ends by itself. */
static int ended(const child *const who)
{
    int status = -1;
    for (int i = 0; i < PATIENCE_MS && waitpid(who->id, &status, WNOHANG) == 0; i++) {
        usleep(1000);
    }
    close(who->errors);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/* --- Peers ------------------------------------------------------------------------------------------------------- */

static int reach(const char *const where)
{
    if (where[0] == '/') {
        return open(where, O_RDWR | O_NOCTTY);
    }
    struct sockaddr_un path = {.sun_family = AF_UNIX};
    struct sockaddr_in host = {.sin_family = AF_INET};
    unsigned port = 0;
    char name[TEXT];
    if (sscanf(where, "tcp:%511[0-9.]:%u", name, &port) == 2 && inet_pton(AF_INET, name, &host.sin_addr) == 1) {
        host.sin_port = htons((uint16_t)port);
        const int file = socket(AF_INET, SOCK_STREAM, 0);
        return connect(file, (const struct sockaddr *)&host, sizeof host) == 0 ? file : -1;
    }
    snprintf(path.sun_path, sizeof path.sun_path, "%s", where + strlen("unix:"));
    const int file = socket(AF_UNIX, SOCK_STREAM, 0);
    return connect(file, (const struct sockaddr *)&path, sizeof path) == 0 ? file : -1;
}

/* Reads so many bytes; whether they came, each within so many milliseconds. */
static bool take_within(const int file, uint8_t *const bytes, const size_t count, const int patience)
{
    size_t came = 0;
    struct pollfd wait = {.fd = file, .events = POLLIN};
    while (came < count && poll(&wait, 1, patience) > 0) {
        const ssize_t more = read(file, bytes + came, count - came);
        if (more <= 0) {
            break;
        }
        came += (size_t)more;
    }
    return came == count;
}

static bool take(const int file, uint8_t *const bytes, const size_t count)
{
    return take_within(file, bytes, count, PATIENCE_MS);
}

static uint32_t seed = 20261122;

static uint32_t draw(void)
{
    seed = seed * 1664525 + 1013904223;
    return seed >> 8;
}

/* Sends portions of random bytes, and whether each comes back, with bits turned or not. */
static bool talk(const int file, const uint8_t turned)
{
    enum { PORTIONS = 40 };
    bool same = file >= 0;
    for (int i = 0; same && i < PORTIONS; i++) {
        uint8_t out[PORTION];
        uint8_t in[PORTION];
        const size_t count = 1 + draw() % PORTION;
        for (size_t at = 0; at < count; at++) {
            out[at] = (uint8_t)draw();
        }
        same = write(file, out, count) == (ssize_t)count && take(file, in, count);
        for (size_t at = 0; same && at < count; at++) {
            same = in[at] == (out[at] ^ turned);
        }
    }
    return same;
}

/* --- Tests ------------------------------------------------------------------------------------------------------- */

/* Three peers, one after another; the second leaves with bytes on their way. */
static void try_kind(const char *const address)
{
    const child plant_child = start(echo, address, "", -1);
    char where[TEXT];
    snprintf(where, sizeof where, "%s", place(&plant_child));
    bool same = true;
    for (int i = 0; same && i < 3; i++) {
        const int peer = reach(where);
        same = talk(peer, 0);
        if (i == 1 && strcmp(address, "pty") != 0) {
            uint8_t lost[PORTION] = {0};
            same = same && write(peer, lost, sizeof lost) == sizeof lost;
        }
        close(peer);
    }
    report_ok(same, "%s, at %s: three peers, one after another, get back what they send", address, where);
    report_ok(WIFSIGNALED(end(&plant_child)), "the plant is alive when they have gone");
}

static void try_stream(void)
{
    int ends[2];
    (void)!socketpair(AF_UNIX, SOCK_STREAM, 0, ends);
    char address[TEXT];
    snprintf(address, sizeof address, "fd:%d", ends[1]);
    const child one = start(echo, address, "", ends[1]);
    close(ends[1]);
    report_ok(talk(ends[0], 0), "fd: a stream that is open gets back what it sends");
    close(ends[0]);
    report_ok(strstr(says(&one), "the controller has gone, and no other can come") != NULL &&
                  ended(&one) == EXIT_FAILURE,
              "at its end the plant ends, and says why");
}

static void try_both(const char *const first, const char *const second)
{
    const child one = start(echo, first, second, -1);
    char where[TEXT];
    snprintf(where, sizeof where, "%s", place(&one));
    const int controller = reach(where);
    const int calibration = reach(place(&one));
    report_ok(talk(controller, 0) && talk(calibration, 0xFF) && talk(controller, 0), "two channels at once do not mix");
    close(controller);
    close(calibration);
    end(&one);
}

/* A peer that takes nothing until there is no room: all that was sent is whole. It has been sent before this reads, so
 * that a byte that does not come within a minute was cut off. */
static void try_flood(const char *const address)
{
    enum { MINUTE_MS = 60000 };
    const child one = start(flood, address, "", -1);
    char where[TEXT];
    snprintf(where, sizeof where, "%s", place(&one));
    const int peer = reach(where);
    uint8_t record[RECORD] = {0};
    bool whole = write(peer, record, 1) == 1 && strcmp(says(&one), "full") == 0;
    uint32_t number = 0;
    uint32_t records = 0;
    for (whole = whole && take_within(peer, record, sizeof record, MINUTE_MS); whole && record[RECORD - 1] == 0;
         records++) {
        memcpy(&number, record, sizeof number);
        whole = number == records && take_within(peer, record, sizeof record, MINUTE_MS);
    }
    memcpy(&number, record + 1, sizeof number);
    report_ok(whole && records + 1 == number && records > 64 && records < MOST_RECORDS,
              "%u records were sent before there was no room, and none in part", (unsigned)records);
    close(peer);
    end(&one);
    const child alone = start(send_alone, "tcp:0", "", -1);
    report_ok(ended(&alone) == 0, "nothing is sent without a peer");
}

static void refuses(const char *const address, const char *const why)
{
    const child one = start(echo, address, "", -1);
    char said[TEXT];
    snprintf(said, sizeof said, "%s", says(&one));
    const int status = ended(&one);
    report_ok(strstr(said, why) != NULL && status == EXIT_FAILURE, "'%s': %s", address, said);
}

/* The socket of a plant that was killed is taken, that of a living one is not. */
static void try_stale(const char *const address)
{
    const child killed = start(echo, address, "", -1);
    (void)place(&killed);
    end(&killed);
    const child next = start(echo, address, "", -1);
    const int peer = reach(place(&next));
    report_ok(talk(peer, 0), "a socket that a plant has left behind is taken");
    refuses(address, "Address already in use");
    close(peer);
    end(&next);
}

int main(const int argc, char **const argv)
{
    const char *const folder = argc > 1 ? argv[1] : ".";
    char path[TEXT];
    char other[TEXT];
    snprintf(path, sizeof path, "unix:%s/a", folder);
    snprintf(other, sizeof other, "unix:%s/b", folder);
    signal(SIGPIPE, SIG_IGN);
    setvbuf(stdout, NULL, _IOLBF, 0);
    report_note("seed %u", (unsigned)seed);
    try_kind(path);
    try_kind("tcp:0");
    try_kind("tcp:127.0.0.1:0");
    try_kind("pty");
    try_stream();
    try_both("tcp:0", other);
    try_flood(path);
    try_stale(path);
    refuses("", "it is not set to an address");
    refuses("serial", "expected unix:PATH, tcp:PORT");
    refuses("unix:", "expected the path");
    refuses("tcp:65536", "expected tcp:PORT");
    refuses("tcp:localhost:1", "expected tcp:PORT");
    refuses("tcp:127.0.0.1000000:0", "expected tcp:PORT");
    refuses("fd:x", "or fd:NUMBER");
    refuses("fd:63", "Bad file descriptor");
    refuses("unix:/absent/socket", "No such file");
    return report_done();
}
