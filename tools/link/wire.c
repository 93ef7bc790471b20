#include "tools/link/link.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "tools/file/file.h"

uint64_t wire_clock(void)
{
    return (uint64_t)(1e9 * seconds_now());
}

/* Makes a descriptor non-blocking, and closed in programs that are started. */
static int own(const int file)
{
    if (file < 0 || fcntl(file, F_SETFL, O_NONBLOCK) != 0 || fcntl(file, F_SETFD, FD_CLOEXEC) != 0) {
        quit("link: a socket: %s", strerror(errno));
    }
    return file;
}

int wire_open(wire *const w, const char *const path, const int mode)
{
    struct sockaddr_un at = {.sun_family = AF_UNIX};
    int ends[2];
    if (strlen(path) >= sizeof at.sun_path) {
        errno = ENAMETOOLONG;
        quit("link: %s: %s", path, strerror(errno));
    }
    memcpy(at.sun_path, path, strlen(path));
    w->listener = own(socket(AF_UNIX, SOCK_STREAM, 0));
    if (bind(w->listener, (const struct sockaddr *)&at, sizeof at) != 0 || listen(w->listener, 1) != 0) {
        quit("link: %s: %s", path, strerror(errno));
    }
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) {
        quit("link: a socket: %s", strerror(errno));
    }
    w->plant = own(ends[0]);
    w->controller = WIRE_NONE;
    w->mode = mode;
    w->heard = wire_clock();
    direction_start(&w->outwards);
    direction_start(&w->inwards);
    return ends[1];
}

/* Bytes of the plant are passed on as they are. */
static bool look_outwards(void *const context, uint8_t *const frame, const size_t length)
{
    wire *const w = context;
    account_plant(&w->account, frame[0], frame + 1, length, wire_clock());
    return false;
}

/* A start has the identity of the plant, the mode and the number of ticks. */
static bool look_inwards(void *const context, uint8_t *const frame, const size_t length)
{
#define FIELD_AT(name, type, count) AT_##name, LAST_OF_##name = AT_##name + ISO_BYTES_OF_##type - 1,
    enum { TYPE_AT, ISO_LINK_START_FIELDS(FIELD_AT) END_AT };
    wire *const w = context;
    account_controller(&w->account, frame[0], frame + 1, length, wire_clock());
    if (frame[TYPE_AT] != ISO_LINK_START || length != END_AT - 1 || w->mode == WIRE_NONE) {
        return false;
    }
    frame[AT_mode] = (uint8_t)w->mode;
    return true;
}

static void part(wire *const w)
{
    close(w->controller);
    w->controller = WIRE_NONE;
    direction_start(&w->inwards);
    w->outwards.queued = 0;
}

static void meet(wire *const w)
{
    const int came = accept(w->listener, NULL, NULL);
    w->controller = came < 0 ? WIRE_NONE : own(came);
    w->heard = wire_clock();
}

static bool is_readable(const struct pollfd *const file)
{
    return (file->revents & (POLLIN | POLLHUP | POLLERR)) != 0;
}

static wire_event pass(wire *const w, const struct pollfd *const plant, const struct pollfd *const other)
{
    w->heard = wire_clock();
    if (is_readable(plant) && direction_has_room(&w->outwards) &&
        !direction_read(&w->outwards, w->plant, look_outwards, w)) {
        return WIRE_PLANT_GONE;
    }
    if (w->controller == WIRE_NONE) {
        w->outwards.queued = 0; /* without a controller bytes are lost, as on any wire */
        if (is_readable(other)) {
            meet(w);
        }
        return WIRE_PASSED;
    }
    if ((is_readable(other) && direction_has_room(&w->inwards) &&
         !direction_read(&w->inwards, w->controller, look_inwards, w)) ||
        !direction_write(&w->outwards, w->controller)) {
        part(w);
        return WIRE_PASSED;
    }
    if (!direction_write(&w->inwards, w->plant)) {
        w->inwards.queued = 0;
    }
    return WIRE_PASSED;
}

/* The events of poll at one end: bytes for the direction from it, and that those of the direction to it can go. If
 * for neither, not even for its close. */
static struct pollfd waits(const int file, const direction *const from, const direction *const to)
{
    const int events = (direction_has_room(from) ? POLLIN : 0) | (to->queued > 0 ? POLLOUT : 0);
    return (struct pollfd){.fd = events == 0 ? WIRE_NONE : file, .events = (short)events};
}

wire_event wire_pass(wire *const w, const int milliseconds)
{
    struct pollfd files[] = {
        waits(w->plant, &w->outwards, &w->inwards),
        w->controller == WIRE_NONE ? (struct pollfd){.fd = w->listener, .events = POLLIN}
                                   : waits(w->controller, &w->inwards, &w->outwards),
    };
    return poll(files, 2, milliseconds) <= 0 ? WIRE_SILENT : pass(w, &files[0], &files[1]);
}

bool wire_end(wire *const w)
{
    uint8_t bytes[ISO_FRAME_BYTES(0)];
    iso_frame_writer end = iso_frame_begin(bytes, ISO_LINK_END);
    return write(w->plant, bytes, iso_frame_end(&end)) > 0;
}

void wire_finish(wire *const w, const int milliseconds)
{
    close(w->plant);
    const uint64_t until = wire_clock() + (uint64_t)milliseconds * 1000000;
    while (w->controller != WIRE_NONE && w->outwards.queued > 0 && wire_clock() < until) {
        struct pollfd file = {.fd = w->controller, .events = POLLOUT};
        (void)poll(&file, 1, milliseconds);
        if (!direction_write(&w->outwards, w->controller)) {
            part(w);
        }
    }
    if (w->controller != WIRE_NONE) {
        (void)shutdown(w->controller, SHUT_WR);
    }
}
