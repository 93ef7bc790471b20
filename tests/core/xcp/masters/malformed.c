/* Packets that nobody should send, between the ticks of a plant: its trajectory is that without them, as far as nobody
 * may write, and where all may, what holds of every packet (world.h) holds. */
#include <stdio.h>
#include <stdlib.h>

#include "core/runtime/hash.h"
#include "core/runtime/tick.h"
#include "plant.h"
#include "tests/core/xcp/masters/world.h"
#include "tests/host/report.h"

enum { PACKETS_A_TICK = 100, NO_BIT = 0xFF };

static plant_memory memory;
static uint64_t chance;
static unsigned long accepted, refused, unanswered, measured, stimulated;

/* xorshift64: Marsaglia (2003). */
static uint32_t draw(const uint32_t below)
{
    chance ^= chance << 13;
    chance ^= chance >> 7;
    chance ^= chance << 17;
    return (uint32_t)((chance >> 32) * below >> 32);
}

/* Nobody has a key of it: writing is locked, measuring is not. */
static uint8_t seed(const uint8_t resource, const uint64_t different, uint8_t to[ISO_XCP_SEED_BYTES])
{
    iso_xcp_put_long(to, (uint32_t)different);
    return resource == ISO_XCP_DAQ ? 1 : 4;
}

static bool fits(const uint8_t resource, const uint8_t *const of, const uint8_t of_length, const uint8_t *const key,
                 const uint8_t length)
{
    (void)resource, (void)of, (void)of_length, (void)key, (void)length;
    return false;
}

static const iso_xcp_lock lock = {ISO_XCP_CAL_PAG | ISO_XCP_STIMULATE, seed, fits};

/* The next of the commands that make two lists and start them, one of which stimulates, and of its packets; one in 16
 * has a wrong byte. */
static uint16_t list_packet(uint8_t *const to)
{
    static const uint8_t commands[][8] = {
        {ISO_XCP_CONNECT, 0},
        {ISO_XCP_FREE_DAQ},
        {ISO_XCP_ALLOC_DAQ, 0, 2, 0},
        {ISO_XCP_ALLOC_ODT, 0, 0, 0, 1},
        {ISO_XCP_ALLOC_ODT, 0, 1, 0, 3},
        {ISO_XCP_ALLOC_ODT_ENTRY, 0, 0, 0, 0, 1},
        {ISO_XCP_ALLOC_ODT_ENTRY, 0, 1, 0, 2, 4},
        {ISO_XCP_ALLOC_ODT_ENTRY, 0, 1, 0, 1, 1},
        {ISO_XCP_ALLOC_ODT_ENTRY, 0, 1, 0, 0, 1},
        {ISO_XCP_SET_DAQ_PTR, 0, 0, 0, 0, 0},
        {ISO_XCP_WRITE_DAQ, NO_BIT, sizeof(real), 0},
        {ISO_XCP_SET_DAQ_LIST_MODE, ISO_XCP_STIM, 0, 0, 0, 0, 1, 0},
        {ISO_XCP_START_STOP_DAQ_LIST, 1, 0, 0},
        {0, 0},
        {ISO_XCP_SET_DAQ_PTR, 0, 1, 0, 0, 0},
        {ISO_XCP_WRITE_DAQ, NO_BIT, 100, 0},
        {ISO_XCP_SET_DAQ_PTR, 0, 1, 0, 1, 0},
        {ISO_XCP_WRITE_DAQ, NO_BIT, 8, 0},
        {ISO_XCP_SET_DAQ_PTR, 0, 1, 0, 2, 0},
        {ISO_XCP_WRITE_DAQ, NO_BIT, 4, 0},
        {ISO_XCP_SET_DAQ_LIST_MODE, ISO_XCP_STAMPED, 1, 0, 0, 0, 1, 0},
        {ISO_XCP_START_STOP_DAQ_LIST, 1, 1, 0},
        {0, 0},
    };
    static unsigned next;
    memcpy(to, commands[next], sizeof commands[next]);
    if (to[0] == ISO_XCP_WRITE_DAQ) {
        iso_xcp_put_long(to + 4, iso_xcp_address(to[2] == sizeof(real) ? (void *)memory.u : (void *)&memory));
    }
    const bool is_stimulus = to[0] == 0;
    if (is_stimulus) {
        const real x = (real)draw(1000) * R(0.01) - R(5.0);
        memcpy(to + 1, &x, sizeof x);
    }
    if (draw(16) == 0) {
        to[draw(8)] = (uint8_t)draw(256);
    }
    next = (next + 1) % (sizeof commands / sizeof commands[0]);
    return is_stimulus ? 1 + sizeof(real) : sizeof commands[0];
}

/* A command of any code, most of them known ones; its length and its bytes are small numbers, addresses of the plant,
 * or anything. */
static uint16_t packet(uint8_t *const to, const bool of_list)
{
    if (of_list) {
        return list_packet(to);
    }
    static const uint8_t known[] = {0xFF, 0xFD, 0xFC, 0xFB, 0xFA, 0xF8, 0xF7, 0xF6, 0xF5, 0xF4,
                                    0xF3, 0xF0, 0xEF, 0xED, 0xE3, 0xE2, 0xE1, 0xE0, 0xDF, 0xDE,
                                    0xDD, 0xDC, 0xDA, 0xD9, 0xD7, 0xD6, 0xD5, 0xD4, 0xD3};
    const uint16_t length = (uint16_t)(draw(4) == 0 ? draw(ISO_XCP_MAX_CTO + 1) : draw(13));
    for (uint16_t i = 0; i < ISO_XCP_MAX_CTO; i++) {
        to[i] = (uint8_t)(draw(3) == 0 ? draw(256) : draw(3));
    }
    to[0] = draw(20) == 0 ? (uint8_t)draw(256) : known[draw(sizeof known)];
    to[1] = draw(2) == 0 ? to[1] : to[0] == ISO_XCP_WRITE_DAQ ? NO_BIT : (uint8_t)(draw(5) * sizeof(real));
    if (draw(2) == 0) {
        to[3] = 0;
        iso_xcp_put_long(to + 4, draw(2) == 0 ? iso_xcp_address(&memory) + draw(sizeof memory + 8)
                                              : iso_xcp_address(&memory.p[draw(PLANT_PARAMETERS)]));
        for (uint16_t i = 8; i + sizeof(real) <= ISO_XCP_MAX_CTO; i = (uint16_t)(i + sizeof(real))) {
            const real x = (real)draw(1000) * R(0.001);
            memcpy(to + i, &x, sizeof x);
        }
    }
    return length;
}

/* The hash of a run of so many ticks, with packets between them; *whole: what must hold did. */
static uint64_t run(const uint32_t ticks, const uint32_t packets, const iso_xcp_lock *const by, bool *const whole)
{
    static world w;
    const iso_plant plant = plant_plant(&memory);
    iso_limits limits[PLANT_PARAMETERS];
    for (size_t i = 0; i < PLANT_PARAMETERS; i++) {
        limits[i] = (iso_limits){plant_parameters[i].least, plant_parameters[i].most};
    }
    const iso_xcp_description of = {"cart", "0", limits, by, {2, 10000}, {6, 1}};
    uint64_t hash = ISO_HASH_START;
    iso_plant_start(&plant);
    world_start(&w, &of, &memory, sizeof memory, (world_part){plant.p, PLANT_PARAMETERS},
                (world_part){plant.u, PLANT_INPUTS});
    *whole = true;
    for (uint32_t tick = 0; tick < ticks; tick++) {
        for (uint32_t k = 0; k < packets && *whole; k++) {
            uint8_t bytes[ISO_XCP_MAX_CTO];
            const uint16_t length = packet(bytes, k < packets / 2);
            w.slave.tick = tick;
            *whole = world_take(&w, bytes, length);
            accepted += w.length > 0 && w.response[0] == ISO_XCP_RES;
            refused += w.length > 0 && w.response[0] == ISO_XCP_ERR;
            unanswered += w.length == 0;
        }
        plant.u[PLANT_U_FORCE] = R(1.0);
        const bool is_whole = world_stimulate(&w);
        *whole = *whole && is_whole && iso_plant_tick(&plant, tick) == PLANT_STATES && world_sample(&w);
        measured += iso_xcp_daq_runs(&w.slave.daq);
        hash = iso_hash_reals(hash, plant.x, PLANT_STATES);
    }
    stimulated += w.whole;
    w.whole = 0;
    return hash;
}

int main(const int argc, char **const argv)
{
    const uint32_t packets = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1000000;
    const uint32_t ticks = packets / 2 / PACKETS_A_TICK;
    bool whole;
    chance = 20261122;
    report_note("seed %lu", (unsigned long)chance);
    const uint64_t plain = run(ticks, 0, NULL, &whole);
    const uint64_t disturbed = run(ticks, PACKETS_A_TICK, &lock, &whole);
    report_ok(whole && plain == disturbed, "%u packets where nobody may write: the same hash", (unsigned)packets / 2);
    const uint64_t written = run(ticks, PACKETS_A_TICK, NULL, &whole);
    report_ok(whole && written != plain,
              "%u where all may: tunables change, all within their limits, and nothing else does",
              (unsigned)packets / 2);
    report_note("%lu were accepted, %lu refused, %lu not answered, %lu samples taken; in %lu ticks a list ran",
                accepted, refused, unanswered, stimulated, measured);
    report_ok(accepted > packets / 10 && refused > packets / 10 && measured > 0 && stimulated > 0, "of each many");
    return report_done();
}
