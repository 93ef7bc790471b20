/* Datagrams of UDP behind a channel. Those of calibration have packets of XCP: each has a LEN and a CTR of two bytes
 * before it (ASAM MCD-1 XCP, part 3: Ethernet). One that is sent has one packet; one that comes in may have several.
 * Those of a controller have a frame of the link each. A datagram is dropped if it has a part of one, or is not of the
 * peer. The peer is the sender of the last CONNECT; of the first frame, then of the last start or hello: the end of a
 * connection is not known here. */
#ifndef ISO_PORT_HOST_DATAGRAMS_H
#define ISO_PORT_HOST_DATAGRAMS_H

#include <netinet/in.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { DATAGRAM_BYTES = 2048 };

typedef struct datagrams {
    struct sockaddr_in peer; /* port 0: there is none */
    uint8_t bytes[DATAGRAM_BYTES];
    size_t count, taken; /* of the last one that came in */
    bool are_frames;     /* of the link */
} datagrams;

/* Takes up to `most` bytes from a socket that does not wait. Returns how many; *peers grows when another peer comes. */
size_t datagrams_receive(datagrams *d, int socket, void *to, size_t most, uint32_t *peers);

/* Sends each packet, or the frame, by itself. Returns whether the first has gone; one that the system has no room for
 * later is lost, as any may. */
bool datagrams_send(const datagrams *d, int socket, const void *from, size_t count);

/* Whether bytes wait that have come in. */
static inline bool datagrams_wait(const datagrams *d)
{
    return d->taken < d->count;
}

#endif
