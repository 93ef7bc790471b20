/* XCP's packets: codes and sizes. ASAM MCD-1 XCP, Universal Measurement and Calibration Protocol, version 1.x, part 2:
 * Protocol Layer Specification. Numbers are little-endian, as the memory is that a master reads. */
#ifndef ISO_CORE_XCP_PACKET_H
#define ISO_CORE_XCP_PACKET_H

#include <stddef.h>
#include <stdint.h>

#include "core/wire/protocol.h"

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "a big-endian memory would have to be told to the master");

/* The largest packets: of commands and responses (MAX_CTO), and of measured data (MAX_DTO). */
enum { ISO_XCP_MAX_CTO = 64, ISO_XCP_MAX_DTO = 256 };

/* Around each, the most that a frame has (transport.h); the largest frame that comes in; and the frames of one sample
 * of a list. */
enum {
    ISO_XCP_HEADER_BYTES = 4,
    ISO_XCP_TAIL_BYTES = 3,
    ISO_XCP_FRAME_BYTES = ISO_XCP_HEADER_BYTES + ISO_XCP_MAX_CTO + ISO_XCP_TAIL_BYTES,
    ISO_XCP_SAMPLE_BYTES = 512
};

/* The first byte of a packet of the slave; below: data, numbered by their table. */
enum { ISO_XCP_RES = 0xFF, ISO_XCP_ERR = 0xFE };

typedef enum iso_xcp_code {
    ISO_XCP_CONNECT = 0xFF,
    ISO_XCP_DISCONNECT = 0xFE,
    ISO_XCP_GET_STATUS = 0xFD,
    ISO_XCP_SYNCH = 0xFC,
    ISO_XCP_GET_COMM_MODE_INFO = 0xFB,
    ISO_XCP_GET_ID = 0xFA,
    ISO_XCP_GET_SEED = 0xF8,
    ISO_XCP_UNLOCK = 0xF7,
    ISO_XCP_SET_MTA = 0xF6,
    ISO_XCP_UPLOAD = 0xF5,
    ISO_XCP_SHORT_UPLOAD = 0xF4,
    ISO_XCP_BUILD_CHECKSUM = 0xF3,
    ISO_XCP_USER_CMD = 0xF1, /* its meaning is the slave's: iso_xcp_user */
    ISO_XCP_DOWNLOAD = 0xF0,
    ISO_XCP_DOWNLOAD_NEXT = 0xEF,
    ISO_XCP_SHORT_DOWNLOAD = 0xED,
    ISO_XCP_CLEAR_DAQ_LIST = 0xE3,
    ISO_XCP_SET_DAQ_PTR = 0xE2,
    ISO_XCP_WRITE_DAQ = 0xE1,
    ISO_XCP_SET_DAQ_LIST_MODE = 0xE0,
    ISO_XCP_GET_DAQ_LIST_MODE = 0xDF,
    ISO_XCP_START_STOP_DAQ_LIST = 0xDE,
    ISO_XCP_START_STOP_SYNCH = 0xDD,
    ISO_XCP_GET_DAQ_CLOCK = 0xDC,
    ISO_XCP_GET_DAQ_PROCESSOR_INFO = 0xDA,
    ISO_XCP_GET_DAQ_RESOLUTION_INFO = 0xD9,
    ISO_XCP_GET_DAQ_EVENT_INFO = 0xD7,
    ISO_XCP_FREE_DAQ = 0xD6,
    ISO_XCP_ALLOC_DAQ = 0xD5,
    ISO_XCP_ALLOC_ODT = 0xD4,
    ISO_XCP_ALLOC_ODT_ENTRY = 0xD3,
    ISO_XCP_WRITE_DAQ_MULTIPLE = 0xC7,
    ISO_XCP_LEVEL_1 = 0xC0, /* its second byte is the command: GET_VERSION, 0 */
} iso_xcp_code;

typedef enum iso_xcp_error {
    ISO_XCP_CMD_SYNCH = 0x00,
    ISO_XCP_DAQ_ACTIVE = 0x11,
    ISO_XCP_CMD_UNKNOWN = 0x20,
    ISO_XCP_CMD_SYNTAX = 0x21,
    ISO_XCP_OUT_OF_RANGE = 0x22,
    ISO_XCP_WRITE_PROTECTED = 0x23,
    ISO_XCP_ACCESS_DENIED = 0x24,
    ISO_XCP_ACCESS_LOCKED = 0x25,
    ISO_XCP_MODE_NOT_VALID = 0x27,
    ISO_XCP_SEQUENCE = 0x29,
    ISO_XCP_DAQ_CONFIG = 0x2A,
    ISO_XCP_MEMORY_OVERFLOW = 0x30,
    ISO_XCP_NONE = 0x100, /* no error; not of the standard */
} iso_xcp_error;

/* The requests of USER_CMD: its second byte, a command of a link. RUN, REST, TAKE and RESTORE are known. RUN and
 * RESTORE have 32 bits behind two bytes that are reserved: how many ticks, 0: without an end; and the bytes of the
 * snapshot. TAKE and RESTORE are answered with the result (iso_control_answer), two zeros, and the size
 * and the address of the snapshot, 32 bits each. */
#define ISO_XCP_USER_CONSTANT(name, number) ISO_XCP_USER_##name = (number),
typedef enum iso_xcp_user { ISO_COMMAND_LIST(ISO_XCP_USER_CONSTANT) } iso_xcp_user;

/* Resources, which can be locked. */
enum { ISO_XCP_CAL_PAG = 0x01, ISO_XCP_DAQ = 0x04, ISO_XCP_STIMULATE = 0x08 };

/* Words of a packet. */
static inline uint16_t iso_xcp_word(const uint8_t *const from)
{
    return (uint16_t)(from[0] | from[1] << 8);
}

static inline uint32_t iso_xcp_long(const uint8_t *const from)
{
    return iso_xcp_word(from) | (uint32_t)iso_xcp_word(from + 2) << 16;
}

static inline void iso_xcp_put_word(uint8_t *const to, const uint16_t word)
{
    to[0] = (uint8_t)word;
    to[1] = (uint8_t)(word >> 8);
}

static inline void iso_xcp_put_long(uint8_t *const to, const uint32_t word)
{
    iso_xcp_put_word(to, (uint16_t)word);
    iso_xcp_put_word(to + 2, (uint16_t)(word >> 16));
}

#endif
