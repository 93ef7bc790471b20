/* The answers to the commands: a function for each, called by iso_xcp_answer when the command is long enough and its
 * resource is not locked. The response begins with ISO_XCP_RES already; each returns its length. */
#ifndef ISO_CORE_XCP_COMMANDS_H
#define ISO_CORE_XCP_COMMANDS_H

#include "core/xcp/slave.h"

typedef struct iso_xcp_exchange {
    const uint8_t *command; /* [length] */
    uint16_t length;
    uint8_t *response; /* [ISO_XCP_MAX_CTO] */
} iso_xcp_exchange;

/* A positive response without data, or that of an error. */
static inline uint16_t iso_xcp_reply(uint8_t *const response, const iso_xcp_error error)
{
    if (error == ISO_XCP_NONE) {
        return 1;
    }
    response[0] = ISO_XCP_ERR;
    response[1] = (uint8_t)error;
    return 2;
}

/* Of an address and its extension before it: there is only extension 0. */
static inline bool iso_xcp_has_address(const uint8_t *const extension)
{
    return *extension == 0;
}

extern const char iso_xcp_event_name[4];

typedef uint16_t iso_xcp_answering(iso_xcp_slave *s, const iso_xcp_exchange *x);

/* transfer.c */
iso_xcp_answering iso_xcp_answer_mta, iso_xcp_answer_upload, iso_xcp_answer_short_upload, iso_xcp_answer_checksum,
    iso_xcp_answer_download, iso_xcp_answer_download_next, iso_xcp_answer_short_download;

/* measure.c */
iso_xcp_answering iso_xcp_answer_processor_info, iso_xcp_answer_resolution_info, iso_xcp_answer_event_info,
    iso_xcp_answer_clock, iso_xcp_answer_free, iso_xcp_answer_alloc_lists, iso_xcp_answer_alloc_tables,
    iso_xcp_answer_alloc_entries, iso_xcp_answer_clear, iso_xcp_answer_pointer, iso_xcp_answer_write_daq,
    iso_xcp_answer_write_daq_multiple, iso_xcp_answer_set_mode, iso_xcp_answer_get_mode, iso_xcp_answer_start_stop,
    iso_xcp_answer_start_stop_synch;

#endif
