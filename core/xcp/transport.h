/* Packets on a stream of bytes: LEN and CTR, two bytes each, then the packet. On a socket that is XCP on Ethernet
 * (TCP). On a serial line (XCP on SxI, HEADER_LEN_CTR_WORD, CHECKSUM_WORD) a zero fills an odd packet, and the sum of
 * all words, modulo 2^16, follows. ASAM MCD-1 XCP, parts 3: Transport Layer Specifications for Ethernet and for SxI.
 *
 * A frame with a LEN that no command has, or with a wrong sum, is rejected: the search for the next one begins at its
 * second byte. So a damaged frame costs itself, and those that follow in the bytes that its LEN claimed: at most
 * ISO_XCP_FRAME_BYTES. A master that gets no answer sends SYNCH; its bytes complete the claimed length. Nothing here
 * needs a clock. */
#ifndef ISO_CORE_XCP_TRANSPORT_H
#define ISO_CORE_XCP_TRANSPORT_H

#include <stdbool.h>

#include "core/xcp/packet.h"

/* Bytes of a frame whose packet has this length; and of those under the checksum, for which the packet is made even. */
static inline uint16_t iso_xcp_summed_bytes(const uint16_t length)
{
    return (uint16_t)(ISO_XCP_HEADER_BYTES + length + (length & 1));
}

static inline uint16_t iso_xcp_frame_bytes(const uint16_t length, const bool is_serial)
{
    return is_serial ? (uint16_t)(iso_xcp_summed_bytes(length) + 2) : (uint16_t)(ISO_XCP_HEADER_BYTES + length);
}

/* Frames that come in. All zeros at the start, but for is_serial. */
typedef struct iso_xcp_reader {
    uint8_t bytes[ISO_XCP_FRAME_BYTES];
    uint8_t used, taken; /* of them the frame that was returned last */
    bool is_serial;
    uint32_t skipped; /* bytes that belong to no frame */
} iso_xcp_reader;

/* The length of the next packet, which begins at bytes + ISO_XCP_HEADER_BYTES until the next call; 0 if it has not
 * come. */
uint16_t iso_xcp_read(iso_xcp_reader *r);

/* After that: how many bytes are missing at least; they go to bytes + used, and are added to `used`. */
uint16_t iso_xcp_missing(const iso_xcp_reader *r);

/* Makes a frame of a packet that stands behind room for a header, and before room for a tail. Returns the bytes of the
 * frame. */
uint16_t iso_xcp_frame(uint8_t *frame, uint16_t length, uint16_t counter, bool is_serial);

#endif
