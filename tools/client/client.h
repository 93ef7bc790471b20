#ifndef ISO_CLIENT_H
#define ISO_CLIENT_H

/* The controller's end of a link to a plant: the same in all headers that isoc writes, behind inside.h. C11 and POSIX,
 * over any stream of bytes; core/link/README.md has the frames. All functions are static: nothing is to be linked.
 *
 * Frames that are lost on the wire are sent again: a question after patience_ms, ISO_CLIENT_TRIES times. */
#include <errno.h>
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <termios.h>
#include <unistd.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { ISO_CLIENT_PATIENCE_MS = 500, ISO_CLIENT_TRIES = 20 };

/* Types of frames, and the bytes of the fields that stand once in each; modes of a run, commands, and the states of a
 * plant in its answer to a command. */
#define ISO_CLIENT_FRAME(name, letter, bytes) ISO_CLIENT_FRAME_##name = (letter), ISO_CLIENT_BYTES_OF_##name = (bytes),
#define ISO_CLIENT_COMMAND(name, number, bytes) ISO_CLIENT_##name = (number), ISO_CLIENT_BYTES_TO_##name = (bytes),
#define ISO_CLIENT_CONSTANT(name, number, words) ISO_CLIENT_##name = (number),
enum { ISO_CLIENT_FRAMES(ISO_CLIENT_FRAME) };
enum { ISO_CLIENT_MODES(ISO_CLIENT_CONSTANT) };
enum { ISO_CLIENT_COMMANDS(ISO_CLIENT_COMMAND) };
enum { ISO_CLIENT_STATES(ISO_CLIENT_CONSTANT) };

/* How a run went. */
#define ISO_CLIENT_MEMBER(name) uint64_t name;
typedef struct iso_client_end {
    ISO_CLIENT_WORDS(ISO_CLIENT_MEMBER)
} iso_client_end;

/* Types for numbers of so many bytes in a frame. */
#define ISO_CLIENT_OF_1 int
#define ISO_CLIENT_OF_4 size_t
#define ISO_CLIENT_OF_8 uint64_t
#define ISO_CLIENT_FIELD(name, bytes) ISO_CLIENT_OF_##bytes name;

/* How a plant is, by its answer to a command; `left` are the ticks until it rests, UINT64_MAX: without an end. */
typedef struct iso_client_state {
    ISO_CLIENT_STATE_FIELDS(ISO_CLIENT_FIELD)
} iso_client_state;

/* Bytes of a buffer for frames of up to so many bytes of payload. */
#define ISO_CLIENT_ROOM(payload) ((payload) + (payload) / 254 + 8)

/* An input or an output; -HUGE_VAL and HUGE_VAL in `least` and `most`: no limit. */
typedef struct iso_client_quantity {
    const char *name, *unit;
    double least, most;
} iso_client_quantity;

/* Bytes that have come at once, and the next of them that is looked at. */
typedef struct iso_client_chunk {
    uint8_t bytes[2048]; /* a datagram has a whole frame */
    size_t count, at;
} iso_client_chunk;

/* A link, with inputs, outputs and room for a frame in and out that belong to its plant. */
typedef struct iso_client {
    int file;        /* descriptor; its owner closes it */
    uint64_t tick;   /* of the outputs */
    int patience_ms; /* how long an answer is waited for, before it is asked for again: 500 where nobody sets it */
    bool over;       /* the run has ended, and `end` says how it went */
    iso_client_end end;
    char problem[120]; /* why the last call failed; empty where the run is over */

    uint64_t identity; /* of the plant that the controller was built for */
    int mode;
    uint64_t ticks; /* of the run; 0: until it is ended */
    size_t real_bytes, inputs, outputs;
    void *u, *y; /* arrays of reals */
    uint8_t *received, *sent;
    size_t room, used, sent_used;
    uint16_t crc;
    size_t code;    /* where that of the present block of COBS stands */
    uint8_t number; /* of the last command */
    iso_client_state state;
    iso_client_chunk chunk;

    const iso_inside *inside; /* of a plant in this process (process.h), its block and its outputs; else NULL */
    void *plant;
    const void *outputs_inside;
    void *own; /* the state of the controller that snapshots take along (keep.h): so many bytes; 0: none */
    size_t own_bytes;
} iso_client;

static inline bool iso_client_fail(iso_client *c, const char *what, const char *why)
{
    (void)snprintf(c->problem, sizeof c->problem, "%s%s%s", what, why == NULL ? "" : ": ", why == NULL ? "" : why);
    return false;
}

/* --- Where the plant is ------------------------------------------------------------------------------------------ */

static inline int iso_client_unix(const char *path)
{
    struct sockaddr_un at;
    memset(&at, 0, sizeof at);
    at.sun_family = AF_UNIX;
    if (strlen(path) >= sizeof at.sun_path) {
        errno = ENAMETOOLONG;
        return -1;
    }
    memcpy(at.sun_path, path, strlen(path));
    const int file = socket(AF_UNIX, SOCK_STREAM, 0);
    if (file >= 0 && connect(file, (const struct sockaddr *)&at, sizeof at) != 0) {
        (void)close(file);
        return -1;
    }
    return file;
}

/* HOST:PORT, of TCP, or of UDP: a frame is a datagram there. */
static inline int iso_client_internet(const char *where, int type)
{
    char host[200];
    const char *colon = strrchr(where, ':');
    struct addrinfo wanted, *found = NULL;
    memset(&wanted, 0, sizeof wanted);
    wanted.ai_socktype = type;
    if (colon == NULL || (size_t)(colon - where) >= sizeof host) {
        errno = EINVAL;
        return -1;
    }
    memcpy(host, where, (size_t)(colon - where));
    host[colon - where] = '\0';
    if (getaddrinfo(host, colon + 1, &wanted, &found) != 0) {
        errno = EHOSTUNREACH;
        return -1;
    }
    int file = -1;
    for (const struct addrinfo *a = found; a != NULL && file < 0; a = a->ai_next) {
        const int one = 1;
        file = socket(a->ai_family, a->ai_socktype, a->ai_protocol);
        if (file >= 0 && connect(file, a->ai_addr, a->ai_addrlen) != 0) {
            (void)close(file);
            file = -1;
        } else if (file >= 0 && type == SOCK_STREAM) { /* each frame leaves at once */
            (void)setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
        }
    }
    freeaddrinfo(found);
    return file;
}

/* A serial line or a terminal: bytes as they are, at the speed that stty has set. */
static inline int iso_client_device(const char *path)
{
    const int file = open(path, O_RDWR | O_NOCTTY);
    struct termios mode;
    if (file >= 0 && tcgetattr(file, &mode) == 0) {
        mode.c_iflag &= ~(tcflag_t)(IGNBRK | BRKINT | PARMRK | ISTRIP | INLCR | IGNCR | ICRNL | IXON | IXOFF);
        mode.c_oflag &= ~(tcflag_t)OPOST;
        mode.c_lflag &= ~(tcflag_t)(ECHO | ECHONL | ICANON | ISIG | IEXTEN);
        mode.c_cflag = (mode.c_cflag & ~(tcflag_t)(CSIZE | PARENB)) | CS8 | CLOCAL | CREAD;
        (void)tcsetattr(file, TCSANOW, &mode);
    }
    return file;
}

/* unix:PATH, tcp:HOST:PORT, udp:HOST:PORT, fd:NUMBER or the path of a device; NULL: the address in the variable
 * ISOCHRON_LINK. Returns a descriptor, or -1. */
static inline int iso_client_connect(const char *address)
{
    address = address == NULL ? getenv("ISOCHRON_LINK") : address;
    if (address == NULL) {
        errno = EDESTADDRREQ;
        return -1;
    }
    return strncmp(address, "unix:", 5) == 0  ? iso_client_unix(address + 5)
           : strncmp(address, "tcp:", 4) == 0 ? iso_client_internet(address + 4, SOCK_STREAM)
           : strncmp(address, "udp:", 4) == 0 ? iso_client_internet(address + 4, SOCK_DGRAM)
           : strncmp(address, "fd:", 3) == 0  ? atoi(address + 3)
                                              : iso_client_device(address);
}

/* --- Frames ------------------------------------------------------------------------------------------------------ */

static inline uint16_t iso_client_crc(uint16_t crc, uint8_t byte)
{
    uint32_t x = (uint32_t)(crc >> 8) ^ byte;
    x ^= x >> 4;
    return (uint16_t)(((uint32_t)crc << 8) ^ (x << 12) ^ (x << 5) ^ x);
}

static inline uint16_t iso_client_crc_of(const uint8_t *bytes, size_t count)
{
    uint16_t crc = 0xFFFF;
    for (size_t i = 0; i < count; i++) {
        crc = iso_client_crc(crc, bytes[i]);
    }
    return crc;
}

/* Within a process a payload stays as it is. */
static inline void iso_client_put_byte(iso_client *c, uint8_t byte)
{
    if (c->inside != NULL) {
        c->sent[c->sent_used++] = byte;
        return;
    }
    c->crc = iso_client_crc(c->crc, byte);
    if (byte != 0) {
        c->sent[c->sent_used++] = byte;
    }
    if (byte == 0 || c->sent_used - c->code == 255) {
        c->sent[c->code] = (uint8_t)(c->sent_used - c->code);
        c->code = c->sent_used++;
    }
}

static inline void iso_client_put(iso_client *c, uint64_t number, size_t bytes)
{
    for (size_t i = 0; i < bytes; i++) {
        iso_client_put_byte(c, (uint8_t)(number >> 8 * i & 0xFF));
    }
}

static inline uint64_t iso_client_number(const uint8_t *from, size_t bytes)
{
    uint64_t number = 0;
    for (size_t i = bytes; i-- > 0;) {
        number = number << 8 | from[i];
    }
    return number;
}

/* Reals of either width. */
static inline void iso_client_put_reals(iso_client *c, const void *reals, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        uint32_t narrow = 0;
        uint64_t wide = 0;
        memcpy(c->real_bytes == 8 ? (void *)&wide : &narrow, (const char *)reals + i * c->real_bytes, c->real_bytes);
        iso_client_put(c, c->real_bytes == 8 ? wide : narrow, c->real_bytes);
    }
}

static inline void iso_client_get_reals(iso_client *c, void *reals, const uint8_t *from, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const uint64_t wide = iso_client_number(from + i * c->real_bytes, c->real_bytes);
        const uint32_t narrow = (uint32_t)wide;
        memcpy((char *)reals + i * c->real_bytes, c->real_bytes == 8 ? (const void *)&wide : &narrow, c->real_bytes);
    }
}

static inline void iso_client_begin(iso_client *c, uint8_t type)
{
    c->sent[0] = 0;
    c->code = 1;
    c->sent_used = 2;
    c->crc = 0xFFFF;
    iso_client_put_byte(c, type);
}

/* Bytes to a socket, or to a file that is none. No signal where the plant has closed the link. */
static inline ssize_t iso_client_send(const iso_client *c, const uint8_t *from, size_t count)
{
    const ssize_t sent = send(c->file, from, count, MSG_NOSIGNAL);
    return sent < 0 && errno == ENOTSOCK ? write(c->file, from, count) : sent;
}

/* Sends the frame that has been begun; or the last one again. A plant that has closed the link may have sent an end
 * frame before: its bytes are still to be read. */
static inline bool iso_client_write(iso_client *c)
{
    if (c->inside != NULL) { /* nothing is lost there */
        return true;
    }
    for (size_t done = 0; done < c->sent_used;) {
        const ssize_t count = iso_client_send(c, c->sent + done, c->sent_used - done);
        if (count < 0 && (errno == EPIPE || errno == ECONNRESET)) {
            return true;
        }
        if (count < 0 && errno != EINTR) {
            return iso_client_fail(c, "the link", strerror(errno));
        }
        done += count < 0 ? 0 : (size_t)count;
    }
    return true;
}

static inline bool iso_client_finish(iso_client *c)
{
    iso_client_put(c, c->crc, 2);
    c->sent[c->code] = (uint8_t)(c->sent_used - c->code);
    c->sent[c->sent_used++] = 0;
    return iso_client_write(c);
}

/* Takes the bytes between two zeros back from COBS. Returns the bytes of payload, or -1 if it is no frame. */
static inline long iso_client_decode(iso_client *c, size_t count)
{
    uint8_t *b = c->received;
    size_t from = 0, to = 0;
    while (from < count) {
        const size_t block = b[from++];
        if (block - 1 > count - from) {
            return -1;
        }
        for (size_t i = 1; i < block; i++) {
            b[to++] = b[from++];
        }
        if (block < 255 && from < count) {
            b[to++] = 0;
        }
    }
    return to >= 3 && iso_client_number(b + to - 2, 2) == iso_client_crc_of(b, to - 2) ? (long)to - 3 : -1;
}

/* The next byte: 1; none in so many milliseconds: 0; the link is broken: -1. */
static inline int iso_client_byte(iso_client *c, int patience_ms, uint8_t *byte)
{
    if (c->chunk.at == c->chunk.count) {
        struct pollfd p = {c->file, POLLIN, 0};
        if (poll(&p, 1, patience_ms) <= 0) {
            return 0;
        }
        const ssize_t count = read(c->file, c->chunk.bytes, sizeof c->chunk.bytes);
        if (count <= 0) {
            (void)iso_client_fail(c, "the link", count == 0 ? "closed by the plant" : strerror(errno));
            return -1;
        }
        c->chunk.count = (size_t)count;
        c->chunk.at = 0;
    }
    *byte = c->chunk.bytes[c->chunk.at++];
    return 1;
}

/* Waits for a whole frame: its type is then received[0], behind it are *length bytes. Returns 1; 0 after so many
 * milliseconds without a byte; -1 if the link is broken. A damaged frame is dropped. */
static inline int iso_client_receive(iso_client *c, int patience_ms, size_t *length)
{
    for (;;) {
        uint8_t byte;
        const int came = iso_client_byte(c, patience_ms, &byte);
        if (came <= 0) {
            return came;
        }
        if (byte != 0) {
            c->used += c->used <= c->room;
            c->received[c->used <= c->room ? c->used - 1 : 0] = byte;
            continue;
        }
        const size_t used = c->used;
        c->used = 0;
        const long count = used == 0 || used > c->room ? -1 : iso_client_decode(c, used);
        if (count >= 0) {
            *length = (size_t)count;
            return 1;
        }
    }
}

/* --- A run ------------------------------------------------------------------------------------------------------- */

#define ISO_CLIENT_IF(number, words) code == (number) ? (words):

/* Why a frame was refused, and why a command was not done. */
static inline const char *iso_client_reason(unsigned code)
{
    return ISO_CLIENT_REASONS(ISO_CLIENT_IF) "for a reason that is not known";
}

static inline const char *iso_client_answer(unsigned code)
{
    return ISO_CLIENT_ANSWERS(ISO_CLIENT_IF) "not known";
}

/* How a run went, or has gone so far. */
static inline void iso_client_take_words(iso_client *c, const uint8_t *at)
{
#define ISO_CLIENT_TAKE_WORD(name) c->end.name = iso_client_number(at, 8), at += 8;
    ISO_CLIENT_WORDS(ISO_CLIENT_TAKE_WORD)
}

/* Takes a frame. Returns 1 if outputs came of a tick from `from` on, or, where those of the next tick are due, of an
 * earlier one to which somebody else has put the plant; and if they need an answer. 0 if something else came, -1 if
 * the run is over or the plant has refused it. */
static inline int iso_client_take(iso_client *c, size_t length, uint64_t from)
{
    const uint8_t type = c->received[0];
    if (type == ISO_CLIENT_FRAME_OUTPUTS && length == ISO_CLIENT_BYTES_OF_OUTPUTS + c->outputs * c->real_bytes) {
        const uint64_t tick = iso_client_number(c->received + 1, ISO_CLIENT_BYTES_OF_OUTPUTS);
        const bool is_taken = tick >= from || (from == c->tick + 1 && tick < c->tick);
        if (is_taken) {
            c->tick = tick;
            iso_client_get_reals(c, c->y, c->received + 1 + ISO_CLIENT_BYTES_OF_OUTPUTS, c->outputs);
        }
        return is_taken && (c->ticks == 0 || tick < c->ticks);
    }
    if (type == ISO_CLIENT_FRAME_END && length == sizeof c->end) {
        iso_client_take_words(c, c->received + 1);
        c->over = true;
        c->problem[0] = '\0';
        return -1;
    }
    if (type == ISO_CLIENT_FRAME_REFUSAL && length == ISO_CLIENT_BYTES_OF_REFUSAL) {
        (void)iso_client_fail(c, "refused", iso_client_reason(c->received[1]));
        return -1;
    }
    return 0;
}

static inline bool iso_client_look(iso_client *c, uint64_t tick);
static inline bool iso_client_ask_inside(iso_client *c, size_t *length);

/* Waits for outputs of a tick from `from` on; meanwhile sends the last frame again and again. */
static inline bool iso_client_await(iso_client *c, uint64_t from)
{
    if (c->inside != NULL) {
        return iso_client_look(c, from);
    }
    for (int tries = 0; tries < ISO_CLIENT_TRIES;) {
        size_t length = 0;
        const int came = iso_client_receive(c, c->patience_ms, &length);
        const int taken = came > 0 ? iso_client_take(c, length, from) : came;
        if (taken != 0) {
            return taken > 0;
        }
        if (came == 0) {
            tries++;
            if (!iso_client_write(c)) {
                return false;
            }
        }
    }
    return iso_client_fail(c, "the plant does not answer", NULL);
}

/* Drops the received bytes. */
static inline void iso_client_drop(iso_client *c)
{
    uint8_t byte;
    while (iso_client_byte(c, 0, &byte) > 0) {
    }
    c->used = 0;
}

/* Starts a run of so many ticks, 0: until it is ended. The outputs are then those of tick 0. The end of a run that
 * goes on comes before. */
static inline bool iso_client_start(iso_client *c, int mode, uint64_t ticks)
{
    c->over = false;
    c->mode = mode;
    c->ticks = ticks;
    iso_client_drop(c);
    iso_client_begin(c, ISO_CLIENT_FRAME_START);
#define ISO_CLIENT_PUT_FIELD(name, bytes) iso_client_put(c, (uint64_t)c->name, bytes);
    ISO_CLIENT_START_FIELDS(ISO_CLIENT_PUT_FIELD)
    if (!iso_client_finish(c)) {
        return false;
    }
    const bool started = iso_client_await(c, 0);
    const bool ended_another = !started && c->over;
    c->over = false;
    return started || (ended_another && iso_client_await(c, 0));
}

/* Sends the inputs, which answer the outputs, and waits for the next outputs; in a free run for the latest. Returns
 * false if the run is over, with the last outputs, or with a problem. */
static inline bool iso_client_exchange(iso_client *c)
{
    size_t length = 0;
    iso_client_begin(c, ISO_CLIENT_FRAME_INPUTS);
    iso_client_put(c, c->tick, ISO_CLIENT_BYTES_OF_INPUTS);
    iso_client_put_reals(c, c->u, c->inputs);
    if (!iso_client_finish(c) || !iso_client_await(c, c->tick + 1)) {
        return false;
    }
    while (c->mode == ISO_CLIENT_FREE && iso_client_receive(c, 0, &length) > 0) {
        if (iso_client_take(c, length, c->tick + 1) < 0) {
            return false;
        }
    }
    return true;
}

/* Ends the run; then `end` says how it went. */
static inline bool iso_client_stop(iso_client *c)
{
    iso_client_begin(c, ISO_CLIENT_FRAME_END);
    return c->over || (iso_client_finish(c) && !iso_client_await(c, UINT64_MAX) && c->over);
}

#ifdef __cplusplus
}
#endif

#endif
