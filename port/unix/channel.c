/* The channels of the host: a variable of the environment gives the address of each.
 *
 *     ISOCHRON_CONTROLLER    ISOCHRON_CALIBRATION
 *
 *     unix:PATH              a socket of the file system, which waits for a peer there
 *     tcp:PORT               waits at 127.0.0.1; port 0 is one that is free
 *     tcp:ADDRESS:PORT       waits at this address of IPv4
 *     udp:PORT, udp:ADDRESS:PORT  the same with datagrams (port/unix/datagrams.h)
 *     pty                    a terminal of its own
 *     fd:N                   a stream of bytes that is open from the start
 *
 * Where it waits stands on the standard error, with the name of the terminal and the number of the port. One peer is
 * served at a time; when it has gone, the next one is. A peer of calibration that has neither sent nor received a
 * byte for IDLE_SECONDS is closed when another waits. A channel without an address receives nothing and sends
 * nothing.
 */
#define _GNU_SOURCE /* ppoll */

#include <arpa/inet.h>
#include <errno.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include "port/channel.h"
#include "port/unix/channel.h"
#include "port/unix/datagrams.h"

/* Bytes that a peer has not yet taken, beyond those that the system keeps. */
enum { WAITING_BYTES = 65536, NONE = -1, IDLE_SECONDS = 5 };

static const int64_t second_ns = 1000000000;

typedef struct line {
    const char *variable;
    const char *address;
    int listener; /* where peers come to, NONE for a stream that is open from the start */
    int peer;
    uint32_t opened;   /* peers that have come there */
    int64_t active_ns; /* when the last byte came from the peer or went to it, or the peer came */
    bool is_datagram;
    size_t waiting_bytes;
    uint8_t waiting[WAITING_BYTES];
} line;

_Static_assert(sizeof((line *)0)->waiting >= ISO_CHANNEL_BYTES, "a frame can wait");

static line lines[ISO_CHANNELS] = {
    [ISO_CHANNEL_CONTROLLER] = {.variable = "ISOCHRON_CONTROLLER", .listener = NONE, .peer = NONE},
    [ISO_CHANNEL_CALIBRATION] = {.variable = "ISOCHRON_CALIBRATION", .listener = NONE, .peer = NONE},
};

/* Of the lines that have some. */
static datagrams packets[ISO_CHANNELS] = {[ISO_CHANNEL_CONTROLLER] = {.are_frames = true}};

static _Noreturn void fail(const line *const l, const char *const why)
{
    fprintf(stderr, "%s=%s: %s\n", l->variable, l->address, why);
    exit(EXIT_FAILURE);
}

/* The result of a call; ends the program if it is negative, which means that the call failed. */
static int must(const line *const l, const int returned)
{
    if (returned < 0) {
        fail(l, strerror(errno));
    }
    return returned;
}

static void say(const line *const l, const char *const where)
{
    fprintf(stderr, "%s: waiting at %s\n", l->variable, where);
}

static void without_waiting(const line *const l, const int file)
{
    must(l, fcntl(file, F_SETFL, must(l, fcntl(file, F_GETFL)) | O_NONBLOCK));
}

/* The text as a whole number from 0 to `most`; -1 if it is none. */
static int number(const char *const text, const long most)
{
    char *end = NULL;
    errno = 0;
    const long value = strtol(text, &end, 10);
    return text[0] >= '0' && text[0] <= '9' && *end == '\0' && errno == 0 && value <= most ? (int)value : -1;
}

static void remove_paths(void)
{
    for (size_t i = 0; i < ISO_CHANNELS; i++) {
        if (lines[i].listener != NONE && strncmp(lines[i].address, "unix:", 5) == 0) {
            unlink(lines[i].address + 5);
        }
    }
}

/* A socket left behind by a program, on which nothing answers, is removed. */
static void open_unix(line *const l, const char *const path)
{
    struct sockaddr_un at = {.sun_family = AF_UNIX};
    if (path[0] == '\0' || strlen(path) >= sizeof at.sun_path) {
        fail(l, "expected the path of a socket, of at most 107 bytes");
    }
    memcpy(at.sun_path, path, strlen(path));
    const struct sockaddr *const where = (const struct sockaddr *)&at;
    const int socket_file = must(l, socket(AF_UNIX, SOCK_STREAM, 0));
    struct stat found;
    if (stat(path, &found) == 0 && S_ISSOCK(found.st_mode) && connect(socket_file, where, sizeof at) != 0 &&
        errno == ECONNREFUSED) {
        unlink(path);
    }
    must(l, bind(socket_file, where, sizeof at));
    l->listener = socket_file;
    atexit(remove_paths);
    must(l, listen(socket_file, 1));
    say(l, l->address);
}

/* A socket that waits at an address, PORT or ADDRESS:PORT; messages name the kind. */
static void open_internet(line *const l, const char *const where, const int type, const char *const kind)
{
    const char *const colon = strrchr(where, ':');
    const int port = number(colon == NULL ? where : colon + 1, UINT16_MAX);
    char host[INET_ADDRSTRLEN] = "127.0.0.1", text[96];
    struct sockaddr_in at = {.sin_family = AF_INET};
    if (colon != NULL && colon - where < (int)sizeof host) {
        snprintf(host, sizeof host, "%.*s", (int)(colon - where), where);
    }
    if (port < 0 || inet_pton(AF_INET, host, &at.sin_addr) != 1) {
        snprintf(text, sizeof text, "expected %s:PORT or %s:ADDRESS:PORT, such as %s:127.0.0.1:5555", kind, kind, kind);
        fail(l, text);
    }
    at.sin_port = htons((uint16_t)port);
    l->listener = must(l, socket(AF_INET, type, 0));
    if (type == SOCK_STREAM) {
        must(l, setsockopt(l->listener, SOL_SOCKET, SO_REUSEADDR, &(int){1}, sizeof(int)));
    }
    must(l, bind(l->listener, (struct sockaddr *)&at, sizeof at));
    if (type == SOCK_STREAM) {
        must(l, listen(l->listener, 1));
    }
    socklen_t bytes = sizeof at;
    must(l, getsockname(l->listener, (struct sockaddr *)&at, &bytes));
    snprintf(text, sizeof text, "%s:%s:%u", kind, host, (unsigned)ntohs(at.sin_port));
    say(l, text);
}

static void open_udp(line *const l, const char *const where)
{
    l->is_datagram = true;
    open_internet(l, where, SOCK_DGRAM, "udp");
}

/* The other end of the terminal stays open here as well: so it keeps its settings, and no peer that closes it ends it.
 * Raw: every byte goes through as it is. */
static void open_terminal(line *const l)
{
    l->peer = must(l, posix_openpt(O_RDWR | O_NOCTTY));
    must(l, grantpt(l->peer));
    must(l, unlockpt(l->peer));
    const char *const name = ptsname(l->peer);
    const int other = must(l, open(name, O_RDWR | O_NOCTTY));
    struct termios how;
    must(l, tcgetattr(other, &how));
    cfmakeraw(&how);
    must(l, tcsetattr(other, TCSANOW, &how));
    say(l, name);
}

static void open_line(line *const l)
{
    l->address = getenv(l->variable);
    if (l->address == NULL || l->address[0] == '\0') {
        l->address = NULL;
        return;
    }
    if (strncmp(l->address, "unix:", 5) == 0) {
        open_unix(l, l->address + 5);
    } else if (strncmp(l->address, "tcp:", 4) == 0) {
        open_internet(l, l->address + 4, SOCK_STREAM, "tcp");
    } else if (strncmp(l->address, "udp:", 4) == 0) {
        open_udp(l, l->address + 4);
    } else if (strcmp(l->address, "pty") == 0) {
        open_terminal(l);
    } else if (strncmp(l->address, "fd:", 3) == 0 && number(l->address + 3, INT16_MAX) >= 0) {
        l->peer = number(l->address + 3, INT16_MAX);
    } else {
        fail(l, "expected unix:PATH, tcp:PORT, tcp:ADDRESS:PORT, udp:PORT, udp:ADDRESS:PORT, pty or fd:NUMBER");
    }
    without_waiting(l, l->peer == NONE ? l->listener : l->peer);
}

/* All lines, which the first call of the program opens. A peer that goes while bytes are sent to it is no signal. */
static line *line_of(const iso_channel channel)
{
    static bool open;
    if (!open) {
        open = true;
        signal(SIGPIPE, SIG_IGN);
        for (size_t i = 0; i < ISO_CHANNELS; i++) {
            open_line(&lines[i]);
        }
    }
    return &lines[channel];
}

static void part(line *const from)
{
    close(from->peer);
    from->peer = NONE;
    from->waiting_bytes = 0;
}

static int64_t now_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * second_ns + now.tv_nsec;
}

/* How long the peer may still be idle; at most zero: the next one takes its place. */
static int64_t idle_left(const line *const l)
{
    return l->active_ns + IDLE_SECONDS * second_ns - now_ns();
}

/* Whether another peer may take the place of one that is idle. A controller may be idle for any time. */
static bool may_replace(const line *const l)
{
    return l == &lines[ISO_CHANNEL_CALIBRATION] && l->peer != NONE && l->listener != NONE;
}

static bool is_waited_for(const line *const l)
{
    struct pollfd file = {.fd = l->listener, .events = POLLIN};
    return poll(&file, 1, 0) > 0;
}

/* Takes the next peer if there is none, or if this one is idle. Returns whether there is one. */
static bool meet(line *const at)
{
    if (may_replace(at) && idle_left(at) <= 0 && is_waited_for(at)) {
        fprintf(stderr, "%s: a client that was idle for %d s is closed: another waits\n", at->variable, IDLE_SECONDS);
        part(at);
    }
    if (at->peer == NONE && at->listener != NONE) {
        at->peer = accept(at->listener, NULL, NULL);
        if (at->peer != NONE) {
            at->opened++;
            at->active_ns = now_ns();
            without_waiting(at, at->peer);
            (void)setsockopt(at->peer, IPPROTO_TCP, TCP_NODELAY, &(int){1}, sizeof(int)); /* of TCP alone */
        }
    }
    return at->peer != NONE;
}

static bool is_passing(const int why)
{
    return why == EAGAIN || why == EWOULDBLOCK || why == EINTR;
}

size_t iso_port_receive(const iso_channel channel, void *const bytes, const size_t count)
{
    line *const from = line_of(channel);
    if (from->is_datagram) {
        return datagrams_receive(&packets[channel], from->listener, bytes, count, &from->opened);
    }
    if (count == 0 || !meet(from)) {
        return 0;
    }
    const ssize_t came = read(from->peer, bytes, count);
    if (came == 0 || (came < 0 && !is_passing(errno))) {
        part(from);
    }
    from->active_ns = came > 0 ? now_ns() : from->active_ns;
    return came > 0 ? (size_t)came : 0;
}

uint32_t iso_port_opened(const iso_channel channel)
{
    return line_of(channel)->opened;
}

/* Hands the system as many of the waiting bytes as it takes. */
static void flush(line *const to)
{
    while (to->peer != NONE && to->waiting_bytes > 0) {
        const ssize_t went = write(to->peer, to->waiting, to->waiting_bytes);
        if (went < 0 && is_passing(errno)) {
            return;
        }
        if (went < 0) {
            part(to);
            return;
        }
        to->active_ns = now_ns();
        to->waiting_bytes -= (size_t)went;
        memmove(to->waiting, to->waiting + went, to->waiting_bytes);
    }
}

bool iso_port_send(const iso_channel channel, const void *const bytes, const size_t count)
{
    line *const to = line_of(channel);
    if (to->is_datagram) {
        return datagrams_send(&packets[channel], to->listener, bytes, count);
    }
    if (!meet(to)) {
        return false;
    }
    flush(to);
    if (to->peer == NONE || count > WAITING_BYTES - to->waiting_bytes) {
        return false;
    }
    memcpy(to->waiting + to->waiting_bytes, bytes, count);
    to->waiting_bytes += count;
    flush(to);
    return to->peer != NONE;
}

/* The shorter of two times, of which a negative one has no end. */
static int64_t shorter(const int64_t a, const int64_t b)
{
    return a < 0 || (b >= 0 && b < a) ? b : a;
}

void iso_port_idle(void)
{
    struct pollfd files[2 * ISO_CHANNELS];
    nfds_t count = 0;
    int64_t left = host_until_tick();
    for (size_t i = 0; i < ISO_CHANNELS; i++) {
        line *const l = line_of((iso_channel)i);
        flush(l);
        left = datagrams_wait(&packets[i]) ? 0 : left;
        const int file = l->peer == NONE ? l->listener : l->peer;
        const short events = (short)(POLLIN | (l->waiting_bytes > 0 ? POLLOUT : 0));
        files[count] = (struct pollfd){.fd = file, .events = events};
        count += file != NONE;
        if (may_replace(l) && is_waited_for(l)) {
            const int64_t rest = idle_left(l);
            left = shorter(left, rest > 0 ? rest : 0);
        } else if (may_replace(l)) {
            files[count++] = (struct pollfd){.fd = l->listener, .events = POLLIN};
        }
    }
    if (count == 0 && left < 0) {
        const line *const controller = line_of(ISO_CHANNEL_CONTROLLER);
        fprintf(stderr, "%s: %s\n", controller->variable,
                controller->address == NULL ? "no controller can come: it is not set to an address"
                                            : "the controller has gone, and no other can come");
        exit(EXIT_FAILURE);
    }
    const struct timespec wait = {.tv_sec = left / second_ns, .tv_nsec = left % second_ns};
    (void)ppoll(files, count, left < 0 ? NULL : &wait, NULL);
}

void iso_port_drain(void)
{
    for (size_t i = 0; i < ISO_CHANNELS; i++) {
        line *const l = line_of((iso_channel)i);
        flush(l);
        while (l->peer != NONE && l->waiting_bytes > 0) {
            struct pollfd file = {.fd = l->peer, .events = POLLOUT};
            (void)poll(&file, 1, -1);
            flush(l);
        }
    }
}
