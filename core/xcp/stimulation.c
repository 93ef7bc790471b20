#include "core/xcp/stimulation.h"

enum { NUMBER_BYTES = 1, OUT_OF_ORDER = UINT8_MAX };

/* The place of an entry's input in u; UINT16_MAX if it is none. */
ISO_RARE static uint16_t place_of(const iso_xcp_access *const access, const iso_xcp_entry *const entry)
{
    const uintptr_t offset = (uintptr_t)entry->at - (uintptr_t)access->inputs;
    const bool is_whole = entry->bytes == sizeof(real) && offset % sizeof(real) == 0;
    return is_whole && offset / sizeof(real) < access->input_count ? (uint16_t)(offset / sizeof(real)) : UINT16_MAX;
}

ISO_RARE iso_xcp_error iso_xcp_stimulation_check(const iso_xcp_daq *const daq, const iso_xcp_access *const access,
                                                 const uint8_t list)
{
    const iso_xcp_list *const l = &daq->lists[list];
    unsigned inputs = 0, bytes = 0;
    bool good = true;
    for (uint8_t other = 0; other < daq->list_count; other++) {
        const uint8_t mode = daq->lists[other].mode;
        good = good && (other == list || !(mode & ISO_XCP_STIM) || !(mode & (ISO_XCP_SELECTED | ISO_XCP_RUNNING)));
    }
    for (uint8_t table = 0; table < l->tables.count; table++) {
        const iso_xcp_part *const entries = &daq->tables[l->tables.first + table];
        const unsigned packet = NUMBER_BYTES + entries->count * (unsigned)sizeof(real);
        for (uint8_t i = 0; i < entries->count; i++) {
            good = good && place_of(access, &daq->entries[entries->first + i]) != UINT16_MAX;
        }
        good = good && packet <= ISO_XCP_MAX_CTO;
        inputs += entries->count;
        bytes += ISO_XCP_HEADER_BYTES + packet + ISO_XCP_TAIL_BYTES;
    }
    good = good && inputs <= ISO_XCP_STIMULI && bytes <= ISO_XCP_STIMULUS_BYTES;
    return good ? ISO_XCP_NONE : ISO_XCP_DAQ_CONFIG;
}

ISO_RARE void iso_xcp_stimulation_start(iso_xcp_stimulation *const s, const iso_xcp_daq *const daq,
                                        const iso_xcp_access *const access, const uint8_t list)
{
    const iso_xcp_part tables = daq->lists[list].tables;
    *s = (iso_xcp_stimulation){.list = list};
    for (uint8_t table = 0; table < tables.count; table++) {
        const iso_xcp_part *const entries = &daq->tables[tables.first + table];
        for (uint8_t i = 0; i < entries->count; i++) {
            const uint16_t place = place_of(access, &daq->entries[entries->first + i]);
            s->places[s->count] = place;
            s->patience[s->count] = access->patience == NULL ? 0 : access->patience(place);
            s->count++;
        }
    }
}

ISO_RARE bool iso_xcp_stimulation_take(iso_xcp_stimulation *const s, const iso_xcp_daq *const daq,
                                       const uint8_t *const packet, const uint16_t length)
{
    const iso_xcp_part tables = daq->lists[s->list].tables;
    const uint8_t table = (uint8_t)(packet[0] - tables.first);
    if (table >= tables.count) {
        return false;
    }
    if (table == 0) {
        s->tables = s->taken = 0;
    }
    const uint8_t count = daq->tables[packet[0]].count;
    const size_t bytes = count * sizeof(real);
    if (table != s->tables || length != NUMBER_BYTES + bytes) {
        s->tables = OUT_OF_ORDER;
        return false;
    }
    memcpy(&s->coming[s->taken], packet + NUMBER_BYTES, bytes);
    s->taken = (uint8_t)(s->taken + count);
    s->tables++;
    if (s->tables < tables.count) {
        return false;
    }
    memcpy(s->held, s->coming, s->count * sizeof(real));
    s->tables = OUT_OF_ORDER;
    s->is_held = s->is_fresh = true;
    return true;
}

/* The age of the newest sample in the next step. */
static uint32_t next_age(const iso_xcp_stimulation *const s)
{
    return s->is_fresh ? 0 : s->age + (s->age < UINT32_MAX);
}

ISO_RARE void iso_xcp_stimulation_set(const iso_xcp_stimulation *const s, const iso_xcp_access *const access)
{
    const uint32_t age = next_age(s);
    for (uint8_t i = 0; s->is_held && i < s->count; i++) {
        if (s->patience[i] == 0 || age < s->patience[i]) {
            access->inputs[s->places[i]] = s->held[i];
        }
    }
}

ISO_RARE bool iso_xcp_stimulation_pass(iso_xcp_stimulation *const s)
{
    const bool missed = !s->is_fresh;
    s->age = next_age(s);
    s->is_fresh = false;
    return missed;
}
