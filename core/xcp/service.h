/* Measurement and calibration between two ticks: the slave on the channel ISO_CHANNEL_CALIBRATION. Before a tick it
 * takes in ISO_XCP_TICK_BYTES bytes at most, answers one command among them at most, and sets the inputs that the
 * master stimulates; after it the lists are sampled that are due. A response that it cannot send is kept; a sample that
 * it cannot send is lost, and the next one shows it. */
#ifndef ISO_CORE_XCP_SERVICE_H
#define ISO_CORE_XCP_SERVICE_H

#include "core/link/interface.h"
#include "core/xcp/slave.h"
#include "core/xcp/transport.h"

#define iso_xcp_service ISO_REAL_NAME(iso_xcp_service)
#define iso_xcp_the_description ISO_REAL_NAME(iso_xcp_the_description)
#define iso_xcp_the_statistics ISO_REAL_NAME(iso_xcp_the_statistics)

/* Bytes that are taken in before a tick. */
enum { ISO_XCP_TICK_BYTES = ISO_XCP_STIMULUS_BYTES + ISO_XCP_FRAME_BYTES };

/* Counts of packets. A master can measure them. */
typedef struct iso_xcp_statistics {
    uint64_t commands; /* that were answered */
    uint64_t samples;  /* of lists, that were sent */
    uint64_t lost;     /* of lists, for which the channel had no room */
    uint64_t stimuli;  /* samples of stimulation that came whole */
    uint64_t missed;   /* steps, while a list stimulates, that had none that was new */
} iso_xcp_statistics;

/* Of the plant of the program; isoc writes it, with the interface. */
extern const iso_xcp_description iso_xcp_the_description;
extern const char iso_xcp_the_epk[17];

extern const iso_service iso_xcp_service;
extern iso_xcp_statistics iso_xcp_the_statistics;

/* An example of seed and key: the key is the seed, each byte exclusive-or 0x5A. It protects against accidents only. */
extern const iso_xcp_lock iso_xcp_example_lock;

#endif
