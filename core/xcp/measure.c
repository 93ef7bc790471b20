/* DAQ by the commands of the master. */
#include "core/xcp/commands.h"

/* Lists are made by the master, prescaler, time stamps, loss shown in the number of a packet. */
enum { DAQ_PROPERTIES = 0x53, DAQ_KEY = 0, STAMP_BYTES = 4, NO_BIT = 0xFF };

/* The event: of DAQ, of STIM where there are inputs, consistent over all of its lists. */
enum { EVENTS = 1, EVENT_PROPERTIES = 0x84, EVENT_OF_STIM = 0x08 };

const char iso_xcp_event_name[4] = "tick";

ISO_RARE uint16_t iso_xcp_answer_processor_info(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    x->response[1] = DAQ_PROPERTIES;
    iso_xcp_put_word(x->response + 2, s->daq.list_count);
    iso_xcp_put_word(x->response + 4, EVENTS);
    x->response[6] = 0; /* lists that the master did not make */
    x->response[7] = DAQ_KEY;
    return 8;
}

ISO_RARE uint16_t iso_xcp_answer_resolution_info(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    x->response[1] = 1; /* entries are whole bytes */
    x->response[2] = UINT8_MAX;
    x->response[3] = sizeof(real); /* those of STIM are whole inputs */
    x->response[4] = s->access.input_count > 0 ? sizeof(real) : 0;
    x->response[5] = (uint8_t)(s->description->stamp.unit << 4 | STAMP_BYTES);
    iso_xcp_put_word(x->response + 6, s->description->stamp.count);
    return 8;
}

/* The name of the event is read with UPLOAD. */
ISO_RARE uint16_t iso_xcp_answer_event_info(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    if (iso_xcp_word(x->command + 2) >= EVENTS) {
        return iso_xcp_reply(x->response, ISO_XCP_OUT_OF_RANGE);
    }
    s->mta = iso_xcp_address(iso_xcp_event_name);
    x->response[1] = EVENT_PROPERTIES | (s->access.input_count > 0 ? EVENT_OF_STIM : 0);
    x->response[2] = ISO_XCP_LISTS;
    x->response[3] = sizeof iso_xcp_event_name;
    x->response[4] = (uint8_t)s->description->cycle.count;
    x->response[5] = s->description->cycle.unit;
    x->response[6] = 0; /* priority */
    return 7;
}

uint16_t iso_xcp_answer_clock(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    memset(x->response + 1, 0, 3);
    iso_xcp_put_long(x->response + 4, (uint32_t)s->tick);
    return 8;
}

uint16_t iso_xcp_answer_free(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    (void)x;
    s->daq = (iso_xcp_daq){.stage = ISO_XCP_FREED};
    return 1;
}

ISO_RARE uint16_t iso_xcp_answer_alloc_lists(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    return iso_xcp_reply(x->response, iso_xcp_daq_alloc_lists(&s->daq, iso_xcp_word(x->command + 2)));
}

ISO_RARE uint16_t iso_xcp_answer_alloc_tables(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    return iso_xcp_reply(x->response, iso_xcp_daq_alloc_tables(&s->daq, iso_xcp_word(x->command + 2), x->command[4]));
}

ISO_RARE uint16_t iso_xcp_answer_alloc_entries(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    return iso_xcp_reply(
        x->response, iso_xcp_daq_alloc_entries(&s->daq, iso_xcp_word(x->command + 2), x->command[4], x->command[5]));
}

ISO_RARE uint16_t iso_xcp_answer_clear(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    return iso_xcp_reply(x->response, iso_xcp_daq_clear(&s->daq, iso_xcp_word(x->command + 2)));
}

ISO_RARE uint16_t iso_xcp_answer_pointer(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    return iso_xcp_reply(x->response,
                         iso_xcp_daq_point(&s->daq, iso_xcp_word(x->command + 2), x->command[4], x->command[5]));
}

/* The memory of an entry, whose parts stand in another order in each of the next two commands. */
ISO_RARE static iso_xcp_error entry_at(const iso_xcp_slave *const s, const uint8_t *const bit_and_bytes,
                                       const uint8_t *const extension, const uint8_t *const address,
                                       const uint8_t **const at)
{
    if (bit_and_bytes[0] != NO_BIT || bit_and_bytes[1] == 0 || !iso_xcp_has_address(extension)) {
        return ISO_XCP_OUT_OF_RANGE;
    }
    *at = iso_xcp_at(&s->access, iso_xcp_long(address), bit_and_bytes[1]);
    return *at == NULL ? ISO_XCP_ACCESS_DENIED : ISO_XCP_NONE;
}

ISO_RARE uint16_t iso_xcp_answer_write_daq(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    const uint8_t *at = NULL;
    const iso_xcp_error error = entry_at(s, x->command + 1, x->command + 3, x->command + 4, &at);
    return iso_xcp_reply(x->response, error == ISO_XCP_NONE ? iso_xcp_daq_write(&s->daq, at, x->command[2]) : error);
}

/* Entries of 8 bytes each: bit offset, size, address, extension, and one byte to align the next. All are written, or
 * none. */
ISO_RARE uint16_t iso_xcp_answer_write_daq_multiple(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    enum { AT = 2, ENTRY_BYTES = 8 };
    const uint8_t count = x->command[1];
    const uint8_t *at = NULL;
    if (count == 0) {
        return iso_xcp_reply(x->response, ISO_XCP_OUT_OF_RANGE);
    }
    if (x->length < AT + ENTRY_BYTES * count - 1) {
        return iso_xcp_reply(x->response, ISO_XCP_CMD_SYNTAX);
    }
    iso_xcp_error error = iso_xcp_daq_takes(&s->daq, count);
    const uint8_t *const end = x->command + AT + ENTRY_BYTES * count;
    for (const uint8_t *entry = x->command + AT; entry < end && error == ISO_XCP_NONE; entry += ENTRY_BYTES) {
        error = entry_at(s, entry, entry + 6, entry + 2, &at);
    }
    for (const uint8_t *entry = x->command + AT; entry < end && error == ISO_XCP_NONE; entry += ENTRY_BYTES) {
        (void)entry_at(s, entry, entry + 6, entry + 2, &at);
        error = iso_xcp_daq_write(&s->daq, at, entry[1]);
    }
    return iso_xcp_reply(x->response, error);
}

/* There is one event, and one priority. */
ISO_RARE uint16_t iso_xcp_answer_set_mode(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    if (iso_xcp_word(x->command + 4) >= EVENTS || x->command[7] != 0) {
        return iso_xcp_reply(x->response, ISO_XCP_OUT_OF_RANGE);
    }
    if (x->command[1] & ISO_XCP_STIM && s->locked & ISO_XCP_STIMULATE) {
        return iso_xcp_reply(x->response, ISO_XCP_ACCESS_LOCKED);
    }
    return iso_xcp_reply(x->response,
                         iso_xcp_daq_mode(&s->daq, iso_xcp_word(x->command + 2), x->command[1], x->command[6]));
}

ISO_RARE uint16_t iso_xcp_answer_get_mode(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    const uint16_t list = iso_xcp_word(x->command + 2);
    if (list >= s->daq.list_count) {
        return iso_xcp_reply(x->response, ISO_XCP_OUT_OF_RANGE);
    }
    x->response[1] = s->daq.lists[list].mode;
    memset(x->response + 2, 0, 4);
    x->response[6] = s->daq.lists[list].prescaler;
    x->response[7] = 0;
    return 8;
}

enum { STOP, START, SELECT };

ISO_RARE static iso_xcp_error check(const iso_xcp_slave *const s, const uint16_t list)
{
    const iso_xcp_error error = iso_xcp_daq_check(&s->daq, list);
    return error == ISO_XCP_NONE && s->daq.lists[list].mode & ISO_XCP_STIM
               ? iso_xcp_stimulation_check(&s->daq, &s->access, (uint8_t)list)
               : error;
}

ISO_RARE static void start_list(iso_xcp_slave *const s, const uint8_t list)
{
    iso_xcp_daq_start(&s->daq, list);
    if (s->daq.lists[list].mode & ISO_XCP_STIM) {
        iso_xcp_stimulation_start(&s->stimulation, &s->daq, &s->access, list);
    }
}

ISO_RARE uint16_t iso_xcp_answer_start_stop(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    const uint16_t list = iso_xcp_word(x->command + 2);
    const uint8_t mode = x->command[1];
    if (mode > SELECT) {
        return iso_xcp_reply(x->response, ISO_XCP_MODE_NOT_VALID);
    }
    const iso_xcp_error error = check(s, list);
    if (error == ISO_XCP_OUT_OF_RANGE || (error != ISO_XCP_NONE && mode != STOP)) {
        return iso_xcp_reply(x->response, error);
    }
    if (mode == STOP) {
        iso_xcp_daq_stop(&s->daq, list);
    } else if (mode == START) {
        start_list(s, (uint8_t)list);
    } else {
        s->daq.lists[list].mode |= ISO_XCP_SELECTED;
    }
    x->response[1] = s->daq.lists[list].tables.first;
    return 2;
}

/* All selected lists at once, or all. Lists are checked again, since they may have changed: all start, or none. */
ISO_RARE uint16_t iso_xcp_answer_start_stop_synch(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    enum { STOP_ALL, START_SELECTED, STOP_SELECTED };
    if (x->command[1] > STOP_SELECTED) {
        return iso_xcp_reply(x->response, ISO_XCP_MODE_NOT_VALID);
    }
    iso_xcp_error error = ISO_XCP_NONE;
    for (uint8_t list = 0; list < s->daq.list_count && x->command[1] == START_SELECTED && error == ISO_XCP_NONE;
         list++) {
        error = s->daq.lists[list].mode & ISO_XCP_SELECTED ? check(s, list) : ISO_XCP_NONE;
    }
    if (error != ISO_XCP_NONE) {
        return iso_xcp_reply(x->response, error);
    }
    for (uint8_t list = 0; list < s->daq.list_count; list++) {
        const bool selected = s->daq.lists[list].mode & ISO_XCP_SELECTED;
        if (x->command[1] == START_SELECTED && selected) {
            start_list(s, list);
        } else if (x->command[1] == STOP_ALL || selected) {
            iso_xcp_daq_stop(&s->daq, list);
        }
    }
    return 1;
}
