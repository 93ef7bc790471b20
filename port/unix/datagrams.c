#include "port/unix/datagrams.h"

#include <string.h>
#include <sys/socket.h>

enum { HEADER_BYTES = 4, CONNECT = 0xFF };

/* A frame of the link begins with a zero and a code of COBS; behind that stands its type (core/wire/protocol.h), and
 * two bytes of a CRC and a zero end it. */
enum { TYPE_AT = 2, LEAST_FRAME = 6, START = 's', HELLO = 'h' };

/* The bytes of the packet there with its header; 0 if it is not whole. */
static size_t packet_bytes(const uint8_t *const at, const size_t left)
{
    const size_t whole = left < HEADER_BYTES ? 0 : HEADER_BYTES + (size_t)(at[0] | at[1] << 8);
    return whole > HEADER_BYTES && whole <= left ? whole : 0;
}

/* Whether there are packets, and nothing but packets. */
static bool are_packets(const uint8_t *const bytes, const size_t count)
{
    size_t at = 0, length = 0;
    do {
        length = packet_bytes(bytes + at, count - at);
        at += length;
    } while (length > 0 && at < count);
    return length > 0;
}

static bool is_frame(const uint8_t *const bytes, const size_t count)
{
    return count >= LEAST_FRAME && bytes[0] == 0 && bytes[count - 1] == 0;
}

/* Whether a datagram makes its sender the peer. */
static bool is_opening(const datagrams *const d)
{
    const uint8_t type = d->bytes[TYPE_AT];
    return d->are_frames ? d->peer.sin_port == 0 || type == START || type == HELLO : d->bytes[HEADER_BYTES] == CONNECT;
}

/* Whether the datagram is from the peer, or from a sender that becomes it. */
static bool is_of_peer(datagrams *const d, const struct sockaddr_in *const sender, uint32_t *const peers)
{
    const bool is_same = sender->sin_port == d->peer.sin_port && sender->sin_addr.s_addr == d->peer.sin_addr.s_addr;
    const bool is_new = !is_same && is_opening(d);
    if (is_new) {
        d->peer = *sender;
        (*peers)++;
    }
    return is_same || is_new;
}

size_t datagrams_receive(datagrams *const d, const int socket, void *const to, const size_t most, uint32_t *const peers)
{
    if (!datagrams_wait(d)) {
        struct sockaddr_in sender = {.sin_port = 0};
        socklen_t bytes = sizeof sender;
        const ssize_t came = recvfrom(socket, d->bytes, sizeof d->bytes, MSG_TRUNC, (struct sockaddr *)&sender, &bytes);
        d->count = d->taken = 0;
        if (came <= 0 || (size_t)came > sizeof d->bytes ||
            !(d->are_frames ? is_frame : are_packets)(d->bytes, (size_t)came) || !is_of_peer(d, &sender, peers)) {
            return 0;
        }
        d->count = (size_t)came;
    }
    const size_t left = d->count - d->taken, count = left < most ? left : most;
    memcpy(to, d->bytes + d->taken, count);
    d->taken += count;
    return count;
}

bool datagrams_send(const datagrams *const d, const int socket, const void *const from, const size_t count)
{
    const uint8_t *const bytes = from;
    bool good = d->peer.sin_port != 0;
    for (size_t at = 0, length = 0; at < count && good; at += length) {
        length = d->are_frames ? count : packet_bytes(bytes + at, count - at);
        good = length > 0 && sendto(socket, bytes + at, length, 0, (const struct sockaddr *)&d->peer, sizeof d->peer) ==
                                 (ssize_t)length;
        if (!good && at > 0) {
            return true;
        }
    }
    return good;
}
