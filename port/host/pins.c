/* The pins of a simulated run, which are all that a table can name: what the script plays is measured, and what is
 * shown can be recorded. Numbers are those of a board whose clock counts 8 ns, as the RP2040's does: the bits are the
 * same. */
#include "port/pins/pins.h"

#include "port/host/wires.h"
#include "port/pins/duty.h"
#include "port/pins/edges.h"
#include "port/pins/table.h"

enum { PULSES_CYCLES = 6250 };

static edges courses[WIRES];
static uint32_t levels[WIRES], counts[WIRES]; /* that pins show */

const char *pins_lacks(const pins_row *const row, const bool is_output)
{
    if (row->pin + pins_width(row, is_output) > WIRES) {
        return "a row is on a pin beyond 63";
    }
    return is_output && row->kind == PINS_EDGES ? "edges are counted, and not shown: a quadrature shows a position"
                                                : NULL;
}

const char *pins_clash(const pins_row *const a, const bool a_is_output, const pins_row *const b, const bool b_is_output)
{
    (void)a;
    (void)a_is_output;
    (void)b;
    (void)b_is_output;
    return NULL;
}

const char *pins_open(const pins_row *const row, const size_t number, const bool is_output)
{
    for (unsigned i = 0; is_output && i < pins_width(row, true); i++) {
        levels[row->pin + i] = counts[row->pin + i] = UINT32_MAX;
    }
    if (is_output && row->kind != PINS_QUADRATURE) {
        pins_show(row, number, row->safe);
    }
    return NULL;
}

bool pins_measure(const pins_row *const row, const size_t number, real *const v)
{
    (void)number;
    const wire *const w = wires_at(row->pin);
    const uint32_t divider = duty_divider(wires_period_cycles()), count_ns = WIRES_CYCLE_NS * divider;
    switch (row->kind) {
    case PINS_VOLTAGE:
        *v = (real)w->volts / (real)WIRES_VOLTS_MOST;
        return true;
    case PINS_DUTY:
        return duty_part((uint16_t)(w->high / count_ns - w->before / count_ns), divider,
                         (uint32_t)(wires_since() / WIRES_CYCLE_NS), v);
    case PINS_EDGES:
        *v = (real)w->rises;
        return true;
    case PINS_QUADRATURE:
        *v = (real)w->count;
        return true;
    case PINS_LEVEL:
    default:
        *v = w->is_high ? R(1.0) : R(0.0);
        return true;
    }
}

static void show_level(const unsigned pin, const uint64_t ns, const uint32_t level)
{
    if (levels[pin] != level) {
        levels[pin] = level;
        wires_show(level != 0 ? "high" : "low", pin, ns, NULL);
    }
}

void pins_show(const pins_row *const row, const size_t number, const real v)
{
    (void)number;
    const uint64_t now = wires_now();
    const bool is_voltage = row->kind == PINS_VOLTAGE;
    const uint32_t most = is_voltage ? WIRES_VOLTS_MOST : PULSES_CYCLES, count = (uint32_t)(v * (real)most + R(0.5));
    if (row->kind == PINS_QUADRATURE) {
        edge list[EDGES_MAX];
        const size_t edge_count = edges_to(&courses[row->pin], v, row->turn, edges_slots(wires_period_cycles()), list);
        for (size_t i = 0; i < edge_count; i++) {
            for (unsigned k = 0; k < pins_width(row, true); k++) {
                show_level(row->pin + k, now + WIRES_CYCLE_NS * (uint64_t)list[i].slot, list[i].levels >> k & 1);
            }
        }
    } else if (row->kind == PINS_LEVEL) {
        show_level(row->pin, now, v >= R(0.5));
    } else if (counts[row->pin] != count) {
        counts[row->pin] = count;
        wires_show(is_voltage ? "volts" : "duty", row->pin, now, &count);
    }
}
