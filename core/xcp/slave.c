#include "core/xcp/commands.h"

enum { PROTOCOL_VERSION = 1, PROTOCOL_MINOR = 4, TRANSPORT_VERSION = 1, TRANSPORT_MINOR = 0, DRIVER_VERSION = 0x10 };

/* CONNECT: slave blocks, and GET_COMM_MODE_INFO; byte order and address granularity are 0. */
enum { COMM_MODE_BASIC = 0xC0, COMM_MODE_OPTIONAL_MASTER_BLOCK = 0x01 };

static uint16_t length_of(const char *const text)
{
    uint16_t n = 0;
    while (text[n] != '\0') {
        n++;
    }
    return n;
}

ISO_RARE void iso_xcp_disconnect(iso_xcp_slave *const s)
{
    s->connected = false;
    s->locked = s->description->lock == NULL ? 0 : s->description->lock->resources;
    s->seed_resource = 0;
    s->upload_left = 0;
    s->download_left = 0;
    s->mta = 0;
    s->daq = (iso_xcp_daq){.stage = ISO_XCP_UNMADE};
}

ISO_RARE void iso_xcp_start(iso_xcp_slave *const s, const iso_xcp_description *const d,
                            const iso_xcp_access *const access)
{
    const iso_xcp_span texts[] = {
        {d->name, length_of(d->name)}, {d->epk, length_of(d->epk)}, {iso_xcp_event_name, sizeof iso_xcp_event_name}};
    *s = (iso_xcp_slave){.description = d, .access = *access};
    uint8_t next = 0;
    for (size_t i = 0; i < ISO_XCP_SPANS && next < sizeof texts / sizeof texts[0]; i++) {
        if (s->access.readable[i].bytes == 0) {
            s->access.readable[i] = texts[next++];
        }
    }
    iso_xcp_disconnect(s);
}

ISO_RARE static uint16_t answer_connect(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    if (x->command[1] != 0) {
        return 0; /* a mode of its own, which this slave does not have */
    }
    iso_xcp_disconnect(s);
    s->connected = true;
    x->response[1] = ISO_XCP_CAL_PAG | ISO_XCP_DAQ | (s->access.input_count > 0 ? ISO_XCP_STIMULATE : 0);
    x->response[2] = COMM_MODE_BASIC;
    x->response[3] = ISO_XCP_MAX_CTO;
    iso_xcp_put_word(x->response + 4, ISO_XCP_MAX_DTO);
    x->response[6] = PROTOCOL_VERSION;
    x->response[7] = TRANSPORT_VERSION;
    return 8;
}

ISO_RARE static uint16_t answer_disconnect(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    (void)x;
    iso_xcp_disconnect(s);
    return 1;
}

ISO_RARE static uint16_t answer_status(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    x->response[1] = iso_xcp_daq_runs(&s->daq) ? ISO_XCP_RUNNING : 0;
    x->response[2] = s->locked;
    x->response[3] = 0;
    iso_xcp_put_word(x->response + 4, 0); /* no configuration is stored */
    return 6;
}

static uint16_t answer_synch(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    (void)s;
    return iso_xcp_reply(x->response, ISO_XCP_CMD_SYNCH);
}

ISO_RARE static uint16_t answer_comm_mode(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    (void)s;
    memset(x->response + 1, 0, 7);
    x->response[2] = COMM_MODE_OPTIONAL_MASTER_BLOCK;
    x->response[4] = UINT8_MAX; /* MAX_BS: a block has no more than ISO_XCP_BLOCK_BYTES anyway */
    x->response[7] = DRIVER_VERSION;
    return 8;
}

/* The commands of the second level: there is one. */
ISO_RARE static uint16_t answer_level_1(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    enum { GET_VERSION = 0 };
    (void)s;
    if (x->command[1] != GET_VERSION) {
        return iso_xcp_reply(x->response, ISO_XCP_CMD_UNKNOWN);
    }
    x->response[1] = 0;
    x->response[2] = PROTOCOL_VERSION;
    x->response[3] = PROTOCOL_MINOR;
    x->response[4] = TRANSPORT_VERSION;
    x->response[5] = TRANSPORT_MINOR;
    return 6;
}

/* The text is read with UPLOAD. */
ISO_RARE static uint16_t answer_id(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    enum { ID_ASCII = 0, ID_A2L = 1, ID_EPK = 5 };
    const char *const text = x->command[1] == ID_ASCII || x->command[1] == ID_A2L ? s->description->name
                             : x->command[1] == ID_EPK                            ? s->description->epk
                                                                                  : NULL;
    memset(x->response + 1, 0, 7);
    if (text != NULL) {
        s->mta = iso_xcp_address(text);
        iso_xcp_put_long(x->response + 4, length_of(text));
    }
    return 8;
}

ISO_RARE static uint16_t answer_seed(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    const uint8_t resource = x->command[2];
    if (x->command[1] == 1) {
        return iso_xcp_reply(x->response,
                             ISO_XCP_SEQUENCE); /* the rest of a seed: there is none, they fit into one packet */
    }
    if (x->command[1] != 0 ||
        (resource != ISO_XCP_CAL_PAG && resource != ISO_XCP_DAQ && resource != ISO_XCP_STIMULATE)) {
        return iso_xcp_reply(x->response, ISO_XCP_OUT_OF_RANGE);
    }
    x->response[1] = 0;
    if (s->locked & resource) {
        s->seed_resource = resource;
        s->seed_length = s->description->lock->seed(resource, s->tick, s->seed);
        x->response[1] = s->seed_length;
        memcpy(x->response + 2, s->seed, s->seed_length);
    }
    return (uint16_t)(2 + x->response[1]);
}

/* A wrong key ends the connection. */
ISO_RARE static uint16_t answer_unlock(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    const uint8_t key_length = x->command[1];
    if (s->seed_resource == 0) {
        return iso_xcp_reply(x->response, ISO_XCP_SEQUENCE);
    }
    if (key_length > x->length - 2) {
        return iso_xcp_reply(x->response, ISO_XCP_CMD_SYNTAX);
    }
    const uint8_t resource = s->seed_resource;
    s->seed_resource = 0;
    if (!s->description->lock->fits(resource, s->seed, s->seed_length, x->command + 2, key_length)) {
        iso_xcp_disconnect(s);
        return iso_xcp_reply(x->response, ISO_XCP_ACCESS_LOCKED);
    }
    s->locked &= (uint8_t)~resource;
    x->response[1] = s->locked;
    return 2;
}

/* The answer to a command of snapshots, and the place of the snapshot. */
ISO_RARE static uint16_t answer_record(const iso_control *const control, const iso_control_answer came,
                                       uint8_t *const response)
{
    response[1] = (uint8_t)came;
    iso_xcp_put_word(response + 2, 0);
    iso_xcp_put_long(response + 4, (uint32_t)control->snapshot_bytes);
    iso_xcp_put_long(response + 8, iso_xcp_address(control->snapshot));
    return 12;
}

ISO_RARE static uint16_t answer_user(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    iso_control *const control = s->access.control;
    const uint8_t request = x->command[1];
    if (control == NULL) {
        return iso_xcp_reply(x->response, ISO_XCP_CMD_UNKNOWN);
    }
    if (request == ISO_XCP_USER_RUN && x->length >= 8) {
        iso_control_run(control, iso_xcp_long(x->command + 4));
    } else if (request == ISO_XCP_USER_REST) {
        iso_control_rest(control);
    } else if (request == ISO_XCP_USER_TAKE) {
        return answer_record(control, s->access.take(), x->response);
    } else if (request == ISO_XCP_USER_RESTORE && x->length >= 8) {
        return answer_record(control, s->access.restore(iso_xcp_long(x->command + 4)), x->response);
    } else {
        return iso_xcp_reply(x->response, ISO_XCP_CMD_SYNTAX);
    }
    return 1;
}

/* A command with the conditions that are checked before it: its least length, and the resource that must not be locked.
 */
typedef struct row {
    uint8_t code, length, resource;
    iso_xcp_answering *answer;
} row;

static const row rows[] = {
    {ISO_XCP_CONNECT, 2, 0, answer_connect},
    {ISO_XCP_DISCONNECT, 1, 0, answer_disconnect},
    {ISO_XCP_GET_STATUS, 1, 0, answer_status},
    {ISO_XCP_SYNCH, 1, 0, answer_synch},
    {ISO_XCP_GET_COMM_MODE_INFO, 1, 0, answer_comm_mode},
    {ISO_XCP_LEVEL_1, 2, 0, answer_level_1},
    {ISO_XCP_GET_ID, 2, 0, answer_id},
    {ISO_XCP_GET_SEED, 3, 0, answer_seed},
    {ISO_XCP_UNLOCK, 2, 0, answer_unlock},
    {ISO_XCP_SET_MTA, 8, 0, iso_xcp_answer_mta},
    {ISO_XCP_UPLOAD, 2, 0, iso_xcp_answer_upload},
    {ISO_XCP_SHORT_UPLOAD, 8, 0, iso_xcp_answer_short_upload},
    {ISO_XCP_BUILD_CHECKSUM, 8, 0, iso_xcp_answer_checksum},
    {ISO_XCP_USER_CMD, 2, ISO_XCP_CAL_PAG, answer_user},
    {ISO_XCP_DOWNLOAD, 2, ISO_XCP_CAL_PAG, iso_xcp_answer_download},
    {ISO_XCP_DOWNLOAD_NEXT, 2, ISO_XCP_CAL_PAG, iso_xcp_answer_download_next},
    {ISO_XCP_SHORT_DOWNLOAD, 8, ISO_XCP_CAL_PAG, iso_xcp_answer_short_download},
    {ISO_XCP_CLEAR_DAQ_LIST, 4, ISO_XCP_DAQ, iso_xcp_answer_clear},
    {ISO_XCP_SET_DAQ_PTR, 6, ISO_XCP_DAQ, iso_xcp_answer_pointer},
    {ISO_XCP_WRITE_DAQ, 8, ISO_XCP_DAQ, iso_xcp_answer_write_daq},
    {ISO_XCP_WRITE_DAQ_MULTIPLE, 2, ISO_XCP_DAQ, iso_xcp_answer_write_daq_multiple},
    {ISO_XCP_SET_DAQ_LIST_MODE, 8, ISO_XCP_DAQ, iso_xcp_answer_set_mode},
    {ISO_XCP_GET_DAQ_LIST_MODE, 4, ISO_XCP_DAQ, iso_xcp_answer_get_mode},
    {ISO_XCP_START_STOP_DAQ_LIST, 4, ISO_XCP_DAQ, iso_xcp_answer_start_stop},
    {ISO_XCP_START_STOP_SYNCH, 2, ISO_XCP_DAQ, iso_xcp_answer_start_stop_synch},
    {ISO_XCP_GET_DAQ_CLOCK, 1, ISO_XCP_DAQ, iso_xcp_answer_clock},
    {ISO_XCP_GET_DAQ_PROCESSOR_INFO, 1, ISO_XCP_DAQ, iso_xcp_answer_processor_info},
    {ISO_XCP_GET_DAQ_RESOLUTION_INFO, 1, ISO_XCP_DAQ, iso_xcp_answer_resolution_info},
    {ISO_XCP_GET_DAQ_EVENT_INFO, 4, ISO_XCP_DAQ, iso_xcp_answer_event_info},
    {ISO_XCP_FREE_DAQ, 1, ISO_XCP_DAQ, iso_xcp_answer_free},
    {ISO_XCP_ALLOC_DAQ, 4, ISO_XCP_DAQ, iso_xcp_answer_alloc_lists},
    {ISO_XCP_ALLOC_ODT, 5, ISO_XCP_DAQ, iso_xcp_answer_alloc_tables},
    {ISO_XCP_ALLOC_ODT_ENTRY, 6, ISO_XCP_DAQ, iso_xcp_answer_alloc_entries},
};

static const row *row_of(const uint8_t code)
{
    const row *found = NULL;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        found = rows[i].code == code ? &rows[i] : found;
    }
    return found;
}

uint16_t iso_xcp_answer(iso_xcp_slave *const s, const uint8_t *const command, const uint16_t length,
                        uint8_t *const response)
{
    if (length == 0 || command[0] <= ISO_XCP_LAST_STIMULUS || (!s->connected && command[0] != ISO_XCP_CONNECT)) {
        return 0;
    }
    s->upload_left = 0;
    s->download_left = command[0] == ISO_XCP_DOWNLOAD_NEXT ? s->download_left : 0; /* any other ends a block */
    response[0] = ISO_XCP_RES;
    const row *const known = row_of(command[0]);
    if (known == NULL) {
        return iso_xcp_reply(response, ISO_XCP_CMD_UNKNOWN);
    }
    if (length < known->length) {
        return s->connected ? iso_xcp_reply(response, ISO_XCP_CMD_SYNTAX) : 0;
    }
    if (s->locked & known->resource) {
        return iso_xcp_reply(response, ISO_XCP_ACCESS_LOCKED);
    }
    return known->answer(s, &(iso_xcp_exchange){command, length, response});
}
