#include "tools/monitor/monitor.h"

#include <errno.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "core/xcp/transport.h"

bool master_fail(master *const m, const char *const format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(m->problem, sizeof m->problem, format, arguments);
    va_end(arguments);
    return false;
}

/* --- The socket -------------------------------------------------------------------------------------------------- */

/* Connects a socket; or closes it, and returns -1 with errno. */
static int connected(const int file, const struct sockaddr *const to, const socklen_t length)
{
    if (file < 0 || connect(file, to, length) == 0) {
        return file;
    }
    const int why = errno;
    close(file);
    errno = why;
    return -1;
}

static int open_unix(const char *const path)
{
    struct sockaddr_un at = {.sun_family = AF_UNIX};
    if (strlen(path) >= sizeof at.sun_path) {
        errno = ENAMETOOLONG;
        return -1;
    }
    memcpy(at.sun_path, path, strlen(path) + 1);
    return connected(socket(AF_UNIX, SOCK_STREAM, 0), (const struct sockaddr *)&at, sizeof at);
}

static int open_internet(const char *const host, const char *const port, const int type)
{
    const struct addrinfo hints = {.ai_socktype = type, .ai_family = AF_UNSPEC};
    struct addrinfo *found = NULL;
    const int one = 1;
    int file = -1;
    errno = EADDRNOTAVAIL;
    if (getaddrinfo(host, port, &hints, &found) != 0) {
        return -1;
    }
    for (const struct addrinfo *at = found; at != NULL && file < 0; at = at->ai_next) {
        file = connected(socket(at->ai_family, at->ai_socktype, at->ai_protocol), at->ai_addr, at->ai_addrlen);
    }
    freeaddrinfo(found);
    if (file >= 0 && type == SOCK_STREAM) {
        (void)setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
    }
    return file;
}

static bool open_line(master *const m, const char *const address)
{
    char host[sizeof m->problem / 2];
    const bool is_udp = strncmp(address, "udp:", 4) == 0;
    const char *const colon = is_udp || strncmp(address, "tcp:", 4) == 0 ? strrchr(address + 4, ':') : NULL;
    if (strncmp(address, "unix:", 5) == 0) {
        m->file = open_unix(address + 5);
    } else if (colon != NULL && (size_t)(colon - address - 4) < sizeof host) {
        snprintf(host, sizeof host, "%.*s", (int)(colon - address - 4), address + 4);
        m->file = open_internet(host, colon + 1, is_udp ? SOCK_DGRAM : SOCK_STREAM);
    } else {
        return master_fail(m, "'%.100s' is no address; it could be tcp:127.0.0.1:5555 or unix:/tmp/plant", address);
    }
    return m->file >= 0 || master_fail(m, "%.100s: %s; is the plant running?", address, strerror(errno));
}

/* --- Packets ----------------------------------------------------------------------------------------------------- */

static void drop(master *const m, const size_t count)
{
    m->used -= count;
    memmove(m->data, m->data + count, m->used);
}

/* Takes the next packet of the received bytes; 0: it is not whole. Bytes that cannot begin one are passed over. */
static size_t cut(master *const m, uint8_t packet[ISO_XCP_MAX_DTO])
{
    while (m->used >= ISO_XCP_HEADER_BYTES) {
        const uint16_t length = iso_xcp_word(m->data), bytes = iso_xcp_frame_bytes(length, m->is_serial);
        if (length == 0 || length > ISO_XCP_MAX_DTO) {
            drop(m, 1);
        } else if (m->used < bytes) {
            return 0;
        } else {
            memcpy(packet, m->data + ISO_XCP_HEADER_BYTES, length);
            drop(m, bytes);
            return length;
        }
    }
    return 0;
}

/* Waits for bytes. Returns whether there are more; a line that has ended is an error. */
static bool receive(master *const m, const int milliseconds)
{
    struct pollfd p = {.fd = m->file, .events = POLLIN};
    m->problem[0] = '\0';
    if (poll(&p, 1, milliseconds) <= 0) {
        return false;
    }
    const ssize_t count = read(m->file, m->data + m->used, sizeof m->data - m->used);
    if (count <= 0) {
        return master_fail(m, "the plant has ended the connection");
    }
    m->used += (size_t)count;
    return true;
}

/* The next response; samples before it are handed on. 0: there is none in this time. */
static size_t get(master *const m, uint8_t packet[ISO_XCP_MAX_DTO], const int milliseconds)
{
    do {
        for (size_t length = cut(m, packet); length > 0; length = cut(m, packet)) {
            if (packet[0] >= ISO_XCP_ERR) {
                return length;
            }
            if (m->sample != NULL) {
                m->sample(m->context, packet, length);
            }
        }
    } while (receive(m, milliseconds));
    return 0;
}

static bool put(master *const m, const uint8_t *const packet, const uint16_t length)
{
    uint8_t frame[ISO_XCP_FRAME_BYTES];
    memcpy(frame + ISO_XCP_HEADER_BYTES, packet, length);
    const uint16_t bytes = iso_xcp_frame(frame, length, m->counter++, m->is_serial);
    for (uint16_t sent = 0; sent < bytes;) {
        const ssize_t count = send(m->file, frame + sent, (size_t)(bytes - sent), MSG_NOSIGNAL);
        if (count <= 0) {
            return master_fail(m, "the plant has ended the connection");
        }
        sent = (uint16_t)(sent + count);
    }
    return true;
}

static const char *reason(const uint8_t error)
{
    switch (error) {
    case ISO_XCP_OUT_OF_RANGE:
        return "the plant refuses: out of range";
    case ISO_XCP_WRITE_PROTECTED:
        return "the plant refuses: this cannot be written";
    case ISO_XCP_ACCESS_DENIED:
        return "the plant refuses: no access to this address; is the A2L that of the program?";
    case ISO_XCP_ACCESS_LOCKED:
        return "the plant refuses: it is locked (--xcp open has no lock)";
    case ISO_XCP_CMD_UNKNOWN:
        return "the plant refuses: it does not know this command";
    default:
        return "the plant refuses";
    }
}

/* Receives a response; its length goes to *length. Returns false if it is an error, or absent. */
static bool answered(master *const m, uint8_t packet[ISO_XCP_MAX_DTO], size_t *const length)
{
    *length = get(m, packet, m->patience_ms);
    if (*length == 0) {
        return m->problem[0] != '\0' ? false : master_fail(m, "the plant does not answer");
    }
    return packet[0] == ISO_XCP_RES || master_fail(m, "%s", reason(packet[1]));
}

static bool ask(master *const m, const uint8_t *const command, const size_t count, uint8_t packet[ISO_XCP_MAX_DTO])
{
    size_t length = 0;
    return put(m, command, (uint16_t)count) && answered(m, packet, &length);
}

/* A command whose answer has no data. */
static bool order(master *const m, const uint8_t *const command, const size_t count)
{
    uint8_t packet[ISO_XCP_MAX_DTO];
    return ask(m, command, count, packet);
}

/* --- Commands ---------------------------------------------------------------------------------------------------- */

/* The bytes from the address on that was set last, in blocks. */
static bool upload(master *const m, uint8_t *const to, const uint8_t count)
{
    const uint8_t command[] = {ISO_XCP_UPLOAD, count};
    uint8_t packet[ISO_XCP_MAX_DTO];
    if (!put(m, command, sizeof command)) {
        return false;
    }
    for (size_t got = 0, length = 0; got < count; got += length - 1) {
        if (!answered(m, packet, &length) || length - 1 > count - got) {
            return false;
        }
        memcpy(to + got, packet + 1, length - 1);
    }
    return true;
}

bool master_read(master *const m, const uint32_t address, uint8_t *const to, const uint32_t count)
{
    uint8_t command[8] = {ISO_XCP_SET_MTA};
    bool good = true;
    for (uint32_t from = 0; from < count && good; from += MASTER_BLOCK) {
        const uint32_t left = count - from;
        iso_xcp_put_long(command + 4, address + from);
        good = order(m, command, sizeof command) &&
               upload(m, to + from, (uint8_t)(left < MASTER_BLOCK ? left : MASTER_BLOCK));
    }
    return good;
}

static bool has_epk(master *const m, const char *const epk)
{
    const uint8_t command[] = {ISO_XCP_GET_ID, 5};
    uint8_t packet[ISO_XCP_MAX_DTO];
    char text[UINT8_MAX + 1] = "";
    if (!ask(m, command, sizeof command, packet)) {
        return false;
    }
    const uint32_t length = iso_xcp_long(packet + 4);
    if (length > UINT8_MAX || (length > 0 && !upload(m, (uint8_t *)text, (uint8_t)length))) {
        return m->problem[0] != '\0' ? false : master_fail(m, "the plant has no EPK");
    }
    return strcmp(text, epk) == 0 ||
           master_fail(m, "the plant is %.60s, and the A2L is of %.60s: another program", text, epk);
}

bool master_connect(master *const m, const char *const address, const bool is_serial, const char *const epk)
{
    const uint8_t command[] = {ISO_XCP_CONNECT, 0};
    *m = (master){.patience_ms = m->patience_ms, .is_serial = is_serial};
    return open_line(m, address) && order(m, command, sizeof command) && has_epk(m, epk);
}

bool master_disconnect(master *const m)
{
    const uint8_t command[] = {ISO_XCP_DISCONNECT};
    const bool good = order(m, command, sizeof command);
    close(m->file);
    return good;
}

bool master_set(master *const m, const a2l_quantity *const q, const double value)
{
    const float narrow = (float)value;
    const void *const bytes = q->type == A2L_FLOAT ? (const void *)&narrow : &value;
    return master_write(m, q->address, bytes, (uint32_t)a2l_bytes(q->type));
}

bool master_run(master *const m, const uint32_t ticks)
{
    uint8_t command[8] = {ISO_XCP_USER_CMD, ISO_XCP_USER_RUN};
    iso_xcp_put_long(command + 4, ticks);
    return order(m, command, sizeof command);
}

bool master_pause(master *const m)
{
    const uint8_t command[] = {ISO_XCP_USER_CMD, ISO_XCP_USER_REST};
    return order(m, command, sizeof command);
}

bool master_write(master *const m, const uint32_t address, const uint8_t *const bytes, const uint32_t count)
{
    enum { HEAD = 8, MOST = ISO_XCP_MAX_CTO - HEAD };
    bool good = true;
    for (uint32_t from = 0; from < count && good; from += MOST) {
        const uint8_t piece = (uint8_t)(count - from < MOST ? count - from : MOST);
        uint8_t command[ISO_XCP_MAX_CTO] = {ISO_XCP_SHORT_DOWNLOAD, piece};
        iso_xcp_put_long(command + 4, address + from);
        memcpy(command + HEAD, bytes + from, piece);
        good = order(m, command, (size_t)HEAD + piece);
    }
    return good;
}

bool master_take(master *const m, uint8_t *const answer, uint32_t *const at, uint32_t *const bytes)
{
    const uint8_t command[] = {ISO_XCP_USER_CMD, ISO_XCP_USER_TAKE};
    uint8_t packet[ISO_XCP_MAX_DTO] = {0};
    if (!ask(m, command, sizeof command, packet)) {
        return false;
    }
    *answer = packet[1];
    *bytes = iso_xcp_long(packet + 4);
    *at = iso_xcp_long(packet + 8);
    return true;
}

bool master_restore(master *const m, const uint32_t bytes, uint8_t *const answer)
{
    uint8_t command[8] = {ISO_XCP_USER_CMD, ISO_XCP_USER_RESTORE}, packet[ISO_XCP_MAX_DTO] = {0};
    iso_xcp_put_long(command + 4, bytes);
    if (!ask(m, command, sizeof command, packet)) {
        return false;
    }
    *answer = packet[1];
    return true;
}

/* --- Measurement ------------------------------------------------------------------------------------------------- */

/* Each entry goes to the first table that has room: behind its number, and the tick in table 0. Returns the tables. */
static uint8_t plan(const a2l_quantity *const *const quantities, const size_t count, uint8_t tables[],
                    uint8_t entries[])
{
    enum { STAMPED = 5 };
    size_t used = STAMPED;
    uint8_t number = 0;
    entries[0] = 0;
    for (size_t i = 0; i < count; i++) {
        if (used + a2l_bytes(quantities[i]->type) > ISO_XCP_MAX_DTO) {
            used = 1;
            entries[++number] = 0;
        }
        used += a2l_bytes(quantities[i]->type);
        entries[number]++;
        tables[i] = number;
    }
    return (uint8_t)(number + 1);
}

static bool make_list(master *const m, const uint8_t table_count, const uint8_t entries[])
{
    const uint8_t commands[][5] = {
        {ISO_XCP_FREE_DAQ}, {ISO_XCP_ALLOC_DAQ, 0, 1, 0}, {ISO_XCP_ALLOC_ODT, 0, 0, 0, table_count}};
    bool good = true;
    for (size_t i = 0; i < sizeof commands / sizeof commands[0] && good; i++) {
        good = order(m, commands[i], sizeof commands[i]);
    }
    for (uint8_t number = 0; number < table_count && good; number++) {
        const uint8_t command[] = {ISO_XCP_ALLOC_ODT_ENTRY, 0, 0, 0, number, entries[number]};
        good = order(m, command, sizeof command);
    }
    return good;
}

bool master_measure(master *const m, const a2l_quantity *const *const quantities, const size_t count, uint8_t tables[])
{
    static const uint8_t start[][8] = {{ISO_XCP_SET_DAQ_LIST_MODE, 0x10, 0, 0, 0, 0, 1, 0},
                                       {ISO_XCP_START_STOP_DAQ_LIST, 2, 0, 0},
                                       {ISO_XCP_START_STOP_SYNCH, 1}};
    uint8_t entries[MASTER_LIST_VALUES] = {0};
    if (count == 0 || count > MASTER_LIST_VALUES) {
        return master_fail(m, "a list has 1 to 64 values");
    }
    bool good = make_list(m, plan(quantities, count, tables, entries), entries);
    for (size_t i = 0; i < count && good; i++) {
        const bool is_first = i == 0 || tables[i] != tables[i - 1];
        const uint8_t pointer[] = {ISO_XCP_SET_DAQ_PTR, 0, 0, 0, tables[i], 0};
        uint8_t entry[8] = {ISO_XCP_WRITE_DAQ, 0xFF, (uint8_t)a2l_bytes(quantities[i]->type)};
        iso_xcp_put_long(entry + 4, quantities[i]->address);
        good = (!is_first || order(m, pointer, sizeof pointer)) && order(m, entry, sizeof entry);
    }
    for (size_t i = 0; i < sizeof start / sizeof start[0] && good; i++) {
        good = order(m, start[i], sizeof start[i]);
    }
    return good;
}

bool master_stop(master *const m)
{
    const uint8_t command[] = {ISO_XCP_START_STOP_SYNCH, 0};
    return order(m, command, sizeof command);
}

bool master_wait(master *const m, const int milliseconds)
{
    uint8_t packet[ISO_XCP_MAX_DTO];
    (void)receive(m, milliseconds);
    (void)get(m, packet, 0);
    return m->problem[0] == '\0';
}
