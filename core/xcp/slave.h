/* The slave: a packet of the master comes in, a packet goes out. A pure function of its state, of the memory that it
 * shows, and of the packet; it knows no channel and no clock.
 *
 * Before CONNECT all other commands are ignored, and packets that are no commands always (stimulation.h). The data of
 * DOWNLOAD, its block or SHORT_DOWNLOAD take effect as a whole when the last packet is answered, or not at all. */
#ifndef ISO_CORE_XCP_SLAVE_H
#define ISO_CORE_XCP_SLAVE_H

#include "core/xcp/stimulation.h"

enum { ISO_XCP_SEED_BYTES = 8, ISO_XCP_BLOCK_BYTES = 255, ISO_XCP_CHECKSUM_BYTES = 1024 };

/* Seed and key: a master must show the key before it may write (ISO_XCP_CAL_PAG), measure (ISO_XCP_DAQ) or stimulate
 * (ISO_XCP_STIMULATE, behind that for ISO_XCP_DAQ where both are locked). */
typedef struct iso_xcp_lock {
    uint8_t resources; /* that are locked behind CONNECT */

    /* Writes a seed for a resource; `different` is another number at each call. Returns the seed's length, 1 to
     * ISO_XCP_SEED_BYTES. */
    uint8_t (*seed)(uint8_t resource, uint64_t different, uint8_t seed[ISO_XCP_SEED_BYTES]);

    /* Whether a key fits the seed that was handed out for this resource. */
    bool (*fits)(uint8_t resource, const uint8_t *seed, uint8_t seed_length, const uint8_t *key, uint8_t key_length);
} iso_xcp_lock;

/* A duration of `count` times 10^unit ns. */
typedef struct iso_xcp_duration {
    uint8_t unit;
    uint16_t count;
} iso_xcp_duration;

/* The description of a plant for a master; isoc writes it. */
typedef struct iso_xcp_description {
    const char *name;         /* of the A2L file, without its ending */
    const char *epk;          /* of the A2L that belongs to it, which has the same text */
    const iso_limits *limits; /* of each tunable; NULL where none has any */
    const iso_xcp_lock *lock; /* NULL: open to all */
    iso_xcp_duration stamp;   /* a step, the unit of time stamps; rounded, where it has more than 65535 of all units */
    iso_xcp_duration cycle;   /* likewise with a count of at most 255 */
} iso_xcp_description;

typedef struct iso_xcp_slave {
    const iso_xcp_description *description;
    iso_xcp_access access;
    uint64_t tick; /* of the plant; the caller sets it */
    bool connected;
    uint8_t locked;        /* resources */
    uint8_t seed_resource; /* the resource whose seed was handed out last; 0: none is valid */
    uint8_t seed_length;
    uint8_t upload_left;    /* bytes of a block that are still to be sent */
    uint8_t download_bytes; /* of a block */
    uint8_t download_left;  /* of them, still to come */
    uint32_t mta;           /* the memory transfer address */
    uint8_t seed[ISO_XCP_SEED_BYTES];
    uint8_t download[ISO_XCP_BLOCK_BYTES];
    iso_xcp_daq daq;
    iso_xcp_stimulation stimulation;
} iso_xcp_slave;

/* Starts a slave without a master. Three spans of the access must be free: they get texts that a master can request. */
void iso_xcp_start(iso_xcp_slave *s, const iso_xcp_description *i, const iso_xcp_access *access);

/* Back to the state of the start: no master is connected, no list runs. */
void iso_xcp_disconnect(iso_xcp_slave *s);

/* Answers a command of `length` bytes, any bytes. Returns the length of the response, up to ISO_XCP_MAX_CTO; 0: there
 * is none. */
uint16_t iso_xcp_answer(iso_xcp_slave *s, const uint8_t *command, uint16_t length, uint8_t *response);

/* The next packet of a response of several; 0 if there is none. */
uint16_t iso_xcp_continue(iso_xcp_slave *s, uint8_t *response);

#endif
