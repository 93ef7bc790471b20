/* STIM: inputs of the plant that the master sets. The entries of such a list are inputs, and its packets come from the
 * master: for each table, in their order, its number and the values. When the packet of the last table has come, the
 * sample is whole; the newest one that is whole holds in the next step, and in those behind it until the next sample,
 * or until it is as old as an input allows. With a packet of another length, or out of order, the sample is lost.
 *
 * One list stimulates at a time. */
#ifndef ISO_CORE_XCP_STIMULATION_H
#define ISO_CORE_XCP_STIMULATION_H

#include "core/xcp/daq.h"

/* Inputs of a list, and bytes of the frames of its sample. */
enum { ISO_XCP_STIMULI = 16, ISO_XCP_STIMULUS_BYTES = 2 * ISO_XCP_FRAME_BYTES };

/* The largest number of a table that a packet of the master can have; above it are commands. */
enum { ISO_XCP_LAST_STIMULUS = 0xBF };

typedef struct iso_xcp_stimulation {
    real coming[ISO_XCP_STIMULI];       /* [taken] of the next sample */
    real held[ISO_XCP_STIMULI];         /* [count] the newest whole sample, if there is one */
    uint16_t places[ISO_XCP_STIMULI];   /* [count] of the inputs in u */
    uint32_t patience[ISO_XCP_STIMULI]; /* [count] the age at which a sample no longer counts for an input; 0: never */
    uint32_t age;                       /* of the newest sample: steps since the one that took it */
    uint8_t list, count, taken;
    uint8_t tables; /* of the next sample, that have come */
    bool is_held;   /* there is a whole sample */
    bool is_fresh;  /* no step has taken it yet */
} iso_xcp_stimulation;

/* Whether its list runs. The functions below with a packet or a step are for one that does. */
static inline bool iso_xcp_stimulates(const iso_xcp_stimulation *const s, const iso_xcp_daq *const daq)
{
    const uint8_t both = ISO_XCP_STIM | ISO_XCP_RUNNING;
    return s->list < daq->list_count && (daq->lists[s->list].mode & both) == both;
}

/* Whether a list can stimulate: its entries are whole inputs, its packets those of a master, and no other list
 * does. */
iso_xcp_error iso_xcp_stimulation_check(const iso_xcp_daq *daq, const iso_xcp_access *access, uint8_t list);
void iso_xcp_stimulation_start(iso_xcp_stimulation *s, const iso_xcp_daq *daq, const iso_xcp_access *access,
                               uint8_t list);

/* A packet of the master that is no command, of any bytes and length. Returns whether a sample is whole with it. */
bool iso_xcp_stimulation_take(iso_xcp_stimulation *s, const iso_xcp_daq *daq, const uint8_t *packet, uint16_t length);

/* Before a step, as often as one likes: sets the inputs. */
void iso_xcp_stimulation_set(const iso_xcp_stimulation *s, const iso_xcp_access *access);

/* After a step. Returns whether it had no sample that was new. */
bool iso_xcp_stimulation_pass(iso_xcp_stimulation *s);

#endif
