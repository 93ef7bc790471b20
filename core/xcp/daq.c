#include "core/xcp/daq.h"

enum { NUMBER_BYTES = 1, STAMP_BYTES = 4 };

/* Advances the stage of the allocation, if the order of the commands is right and no list runs. */
ISO_RARE static iso_xcp_error advance(iso_xcp_daq *const daq, const iso_xcp_stage from, const iso_xcp_stage to)
{
    if (iso_xcp_daq_runs(daq)) {
        return ISO_XCP_DAQ_ACTIVE;
    }
    if (daq->stage != from && daq->stage != to) {
        return ISO_XCP_SEQUENCE;
    }
    daq->stage = to;
    return ISO_XCP_NONE;
}

/* Takes the next `count` elements of an array, of which `used` are taken already. */
ISO_RARE static iso_xcp_error take(iso_xcp_part *const part, uint8_t *const used, const unsigned room,
                                   const unsigned count)
{
    if (part->count > 0) {
        return ISO_XCP_SEQUENCE;
    }
    if (count > room - *used) {
        return ISO_XCP_MEMORY_OVERFLOW;
    }
    *part = (iso_xcp_part){*used, (uint8_t)count};
    *used = (uint8_t)(*used + count);
    return ISO_XCP_NONE;
}

ISO_RARE iso_xcp_error iso_xcp_daq_alloc_lists(iso_xcp_daq *const daq, const uint16_t count)
{
    if (daq->stage != ISO_XCP_FREED) {
        return iso_xcp_daq_runs(daq) ? ISO_XCP_DAQ_ACTIVE : ISO_XCP_SEQUENCE;
    }
    if (count > ISO_XCP_LISTS) {
        return ISO_XCP_MEMORY_OVERFLOW;
    }
    daq->list_count = (uint8_t)count;
    daq->stage = ISO_XCP_LISTED;
    return ISO_XCP_NONE;
}

ISO_RARE iso_xcp_error iso_xcp_daq_alloc_tables(iso_xcp_daq *const daq, const uint16_t list, const uint8_t count)
{
    const iso_xcp_error error = advance(daq, ISO_XCP_LISTED, ISO_XCP_TABLED);
    if (error != ISO_XCP_NONE) {
        return error;
    }
    return list < daq->list_count ? take(&daq->lists[list].tables, &daq->table_count, ISO_XCP_TABLES, count)
                                  : ISO_XCP_OUT_OF_RANGE;
}

/* A table of a list; NULL if there is none. */
ISO_RARE static iso_xcp_part *table_of(iso_xcp_daq *const daq, const uint16_t list, const uint8_t table)
{
    if (list >= daq->list_count || table >= daq->lists[list].tables.count) {
        return NULL;
    }
    return &daq->tables[daq->lists[list].tables.first + table];
}

ISO_RARE iso_xcp_error iso_xcp_daq_alloc_entries(iso_xcp_daq *const daq, const uint16_t list, const uint8_t table,
                                                 const uint8_t count)
{
    const iso_xcp_error error = advance(daq, ISO_XCP_TABLED, ISO_XCP_MADE);
    if (error != ISO_XCP_NONE) {
        return error;
    }
    iso_xcp_part *const entries = table_of(daq, list, table);
    return entries == NULL ? ISO_XCP_OUT_OF_RANGE : take(entries, &daq->entry_count, ISO_XCP_ENTRIES, count);
}

ISO_RARE iso_xcp_error iso_xcp_daq_point(iso_xcp_daq *const daq, const uint16_t list, const uint8_t table,
                                         const uint8_t entry)
{
    const iso_xcp_part *const entries = table_of(daq, list, table);
    daq->entries_left = 0;
    if (entries == NULL || entry >= entries->count) {
        return ISO_XCP_OUT_OF_RANGE;
    }
    daq->list = (uint8_t)list;
    daq->entry = (uint8_t)(entries->first + entry);
    daq->entries_left = (uint8_t)(entries->count - entry);
    return ISO_XCP_NONE;
}

ISO_RARE iso_xcp_error iso_xcp_daq_takes(const iso_xcp_daq *const daq, const uint8_t count)
{
    if (daq->entries_left < count) {
        return ISO_XCP_SEQUENCE;
    }
    return daq->lists[daq->list].mode & ISO_XCP_RUNNING ? ISO_XCP_DAQ_ACTIVE : ISO_XCP_NONE;
}

ISO_RARE iso_xcp_error iso_xcp_daq_write(iso_xcp_daq *const daq, const uint8_t *const at, const uint8_t bytes)
{
    const iso_xcp_error error = iso_xcp_daq_takes(daq, 1);
    if (error == ISO_XCP_NONE) {
        daq->entries[daq->entry++] = (iso_xcp_entry){at, bytes};
        daq->entries_left--;
    }
    return error;
}

ISO_RARE iso_xcp_error iso_xcp_daq_clear(iso_xcp_daq *const daq, const uint16_t list)
{
    if (list >= daq->list_count) {
        return ISO_XCP_OUT_OF_RANGE;
    }
    iso_xcp_daq_stop(daq, list);
    for (uint8_t table = 0; table < daq->lists[list].tables.count; table++) {
        const iso_xcp_part *const entries = table_of(daq, list, table);
        for (uint8_t i = 0; i < entries->count; i++) {
            daq->entries[entries->first + i] = (iso_xcp_entry){NULL, 0};
        }
    }
    return ISO_XCP_NONE;
}

ISO_RARE iso_xcp_error iso_xcp_daq_mode(iso_xcp_daq *const daq, const uint16_t list, const uint8_t mode,
                                        const uint8_t prescaler)
{
    if (list >= daq->list_count || prescaler == 0) {
        return ISO_XCP_OUT_OF_RANGE;
    }
    iso_xcp_list *const i = &daq->lists[list];
    if (i->mode & ISO_XCP_RUNNING) {
        return ISO_XCP_DAQ_ACTIVE;
    }
    if (mode != 0 && mode != ISO_XCP_STAMPED && mode != ISO_XCP_STIM) {
        return ISO_XCP_MODE_NOT_VALID;
    }
    if (mode == ISO_XCP_STIM && prescaler != 1) {
        return ISO_XCP_OUT_OF_RANGE;
    }
    i->mode = (uint8_t)((i->mode & ISO_XCP_SELECTED) | mode);
    i->prescaler = prescaler;
    return ISO_XCP_NONE;
}

/* The length of a table's packet, as far as its entries are written. */
static unsigned packet_bytes(const iso_xcp_daq *const daq, const iso_xcp_list *const list, const uint8_t table)
{
    const iso_xcp_part *const entries = &daq->tables[list->tables.first + table];
    unsigned bytes = table == 0 && (list->mode & ISO_XCP_STAMPED) ? NUMBER_BYTES + STAMP_BYTES : NUMBER_BYTES;
    for (uint8_t i = 0; i < entries->count; i++) {
        bytes += daq->entries[entries->first + i].bytes;
    }
    return bytes;
}

ISO_RARE iso_xcp_error iso_xcp_daq_check(const iso_xcp_daq *const daq, const uint16_t list)
{
    if (list >= daq->list_count) {
        return ISO_XCP_OUT_OF_RANGE;
    }
    const iso_xcp_list *const i = &daq->lists[list];
    bool good = i->tables.count > 0 && i->prescaler > 0;
    unsigned sample = 0;
    for (uint8_t table = 0; table < i->tables.count; table++) {
        const iso_xcp_part *const entries = &daq->tables[i->tables.first + table];
        const unsigned bytes = packet_bytes(daq, i, table);
        good = good && entries->count > 0 && daq->entries[entries->first].bytes > 0 && bytes <= ISO_XCP_MAX_DTO;
        sample += ISO_XCP_HEADER_BYTES + bytes + ISO_XCP_TAIL_BYTES;
    }
    good = good && sample <= ISO_XCP_SAMPLE_BYTES;
    return good ? ISO_XCP_NONE : ISO_XCP_DAQ_CONFIG;
}

ISO_RARE void iso_xcp_daq_start(iso_xcp_daq *const daq, const uint16_t list)
{
    iso_xcp_list *const i = &daq->lists[list];
    i->mode = (uint8_t)((i->mode & ~ISO_XCP_SELECTED) | ISO_XCP_RUNNING);
    i->passed = 0;
    i->overloaded = false;
}

ISO_RARE void iso_xcp_daq_stop(iso_xcp_daq *const daq, const uint16_t list)
{
    daq->lists[list].mode &= (uint8_t) ~(ISO_XCP_SELECTED | ISO_XCP_RUNNING);
}

bool iso_xcp_daq_runs(const iso_xcp_daq *const daq)
{
    bool any = false;
    for (uint8_t list = 0; list < daq->list_count; list++) {
        any = any || (daq->lists[list].mode & ISO_XCP_RUNNING);
    }
    return any;
}

bool iso_xcp_daq_due(iso_xcp_daq *const daq, const uint8_t list)
{
    iso_xcp_list *const i = &daq->lists[list];
    if ((i->mode & (ISO_XCP_RUNNING | ISO_XCP_STIM)) != ISO_XCP_RUNNING) {
        return false;
    }
    i->passed++;
    if (i->passed < i->prescaler) {
        return false;
    }
    i->passed = 0;
    return true;
}

uint16_t iso_xcp_daq_packet(const iso_xcp_daq *const daq, const uint8_t list, const uint8_t table, const uint32_t tick,
                            uint8_t *const to)
{
    const iso_xcp_list *const l = &daq->lists[list];
    const uint8_t number = (uint8_t)(l->tables.first + table);
    const iso_xcp_part *const entries = &daq->tables[number];
    uint16_t used = NUMBER_BYTES;
    to[0] = number;
    if (table == 0) {
        to[0] |= l->overloaded ? ISO_XCP_OVERLOAD : 0;
        if (l->mode & ISO_XCP_STAMPED) {
            iso_xcp_put_long(to + used, tick);
            used += STAMP_BYTES;
        }
    }
    for (uint8_t i = 0; i < entries->count; i++) {
        const iso_xcp_entry *const entry = &daq->entries[entries->first + i];
        memcpy(to + used, entry->at, entry->bytes);
        used = (uint16_t)(used + entry->bytes);
    }
    return used;
}
