/* Stimulation, command by command and packet by packet: the inputs are the states of the small plant. */
#ifndef ISO_TESTS_UNIT_XCP_STIMULATE_H
#define ISO_TESTS_UNIT_XCP_STIMULATE_H

#include "tests/core/xcp/xcp/ask.h"

static uint32_t patience_of(const uint16_t input)
{
    return input == 1 ? 3 : 0;
}

static void start_with_inputs(const iso_xcp_description *const of)
{
    start(of);
    slave.access.inputs = world.memory.x;
    slave.access.input_count = STATES;
    slave.access.patience = patience_of;
}

/* WRITE_DAQ of a whole real. */
static bool write_entry(const void *const at)
{
    return says(sizeof(real) == 4 ? "E1 FF 04 00 *" : "E1 FF 08 00 *", at, "FF");
}

/* List 0 of one table, and list 1 of two tables, of two inputs and of one: the latter stimulates. */
static bool make_stimulation(void)
{
    bool good = says("D6", NULL, "FF") && says("D5 00 02 00", NULL, "FF") && says("D4 00 00 00 01", NULL, "FF") &&
                says("D4 00 01 00 02", NULL, "FF") && says("D3 00 00 00 00 01", NULL, "FF") &&
                says("D3 00 01 00 00 02", NULL, "FF") && says("D3 00 01 00 01 01", NULL, "FF");
    good = good && says("E2 00 00 00 00 00", NULL, "FF") && write_entry(&world.memory.x[0]);
    good = good && says("E2 00 01 00 00 00", NULL, "FF") && write_entry(&world.memory.x[2]);
    good = good && write_entry(&world.memory.x[1]);
    good = good && says("E2 00 01 00 01 00", NULL, "FF") && write_entry(&world.memory.x[0]);
    return good && says("E0 02 01 00 00 00 01 00", NULL, "FF");
}

/* The packet of table 1 or 2, of so many bytes. Returns whether a sample is whole with it. */
static bool stimulate(const uint8_t table, const real first, const real second, const uint16_t length)
{
    uint8_t packet[1 + 2 * sizeof(real) + 4] = {table};
    put_real(packet + 1, first);
    put_real(packet + 1 + sizeof(real), second);
    return iso_xcp_stimulates(&slave.stimulation, &slave.daq) &&
           iso_xcp_stimulation_take(&slave.stimulation, &slave.daq, packet, length);
}

enum { LONG = 1 + 2 * sizeof(real), SHORT = 1 + sizeof(real) };

static bool sample(const real a, const real b, const real c)
{
    return !stimulate(1, c, b, LONG) && stimulate(2, a, R(0.0), SHORT);
}

/* A step whose own inputs are 9: whether it has these, and whether its sample is new. */
static bool step_has(const real a, const real b, const real c, const bool is_new)
{
    const real want[STATES] = {a, b, c};
    bool good = true;
    for (unsigned i = 0; i < STATES; i++) {
        world.memory.x[i] = R(9.0);
    }
    iso_xcp_stimulation_set(&slave.stimulation, &slave.access);
    iso_xcp_stimulation_set(&slave.stimulation, &slave.access);
    for (unsigned i = 0; i < STATES; i++) {
        good = good && iso_bits_of(world.memory.x[i]) == iso_bits_of(want[i]);
    }
    return iso_xcp_stimulation_pass(&slave.stimulation) != is_new && good;
}

static void test_stimulation(void)
{
    start_with_inputs(&open_plant);
    tap_ok(says("FF 00", NULL, "FF 0D C0 40 00 01 01 01"), "CONNECT of a plant with inputs: STIM");
    tap_ok(says("D9", NULL, sizeof(real) == 4 ? "FF 01 FF 04 04 24 10 27" : "FF 01 FF 08 08 24 10 27"),
           "GET_DAQ_RESOLUTION_INFO: whole inputs");
    tap_ok(says("D7 00 00 00", NULL, "FF 8C 04 04 01 06 00"), "GET_DAQ_EVENT_INFO: both directions");
    tap_ok(make_stimulation(), "a list that stimulates is made");
    tap_ok(says("E0 12 01 00 00 00 01 00", NULL, "FE 27") && says("E0 02 01 00 00 00 02 00", NULL, "FE 22"),
           "none with time stamps, nor every second tick");
    tap_ok(says("DF 00 01 00", NULL, "FF 02 00 00 00 00 01 00"), "GET_DAQ_LIST_MODE");
    ask("00", NULL);
    tap_ok(got_length == 0 && !sample(R(1.0), R(2.0), R(3.0)), "what is no command has no answer, and no effect yet");
    tap_ok(says("DE 01 01 00", NULL, "FF 01") && says("FD", NULL, "FF 40 00 00 00 00") &&
               says("DF 00 01 00", NULL, "FF 42 00 00 00 00 01 00") && !iso_xcp_daq_due(&slave.daq, 1),
           "it runs, and is not sampled");
    tap_ok(step_has(R(9.0), R(9.0), R(9.0), false), "before the first sample inputs are their own");
    tap_ok(sample(R(1.0), R(2.0), R(3.0)) && step_has(R(1.0), R(2.0), R(3.0), true), "a sample of two packets");
    tap_ok(!stimulate(1, R(7.0), R(7.0), LONG) && step_has(R(1.0), R(2.0), R(3.0), false), "half a sample waits");
    tap_ok(stimulate(2, R(4.0), R(0.0), SHORT) && sample(R(4.5), R(5.0), R(6.0)) &&
               step_has(R(4.5), R(5.0), R(6.0), true),
           "of two samples the newer one holds");
    tap_ok(!stimulate(2, R(7.0), R(0.0), SHORT) && !stimulate(1, R(7.0), R(7.0), LONG) &&
               !stimulate(1, R(7.0), R(7.0), LONG - 1) && !stimulate(2, R(7.0), R(0.0), SHORT) &&
               !stimulate(1, R(7.0), R(7.0), LONG + 1) && !stimulate(2, R(7.0), R(0.0), SHORT) &&
               !stimulate(0, R(7.0), R(7.0), LONG) && !stimulate(3, R(7.0), R(7.0), LONG) &&
               step_has(R(4.5), R(5.0), R(6.0), false),
           "out of order, of another length, of no table: none is whole, and the last one holds");
    tap_ok(step_has(R(4.5), R(5.0), R(6.0), false) && step_has(R(4.5), R(9.0), R(6.0), false) &&
               step_has(R(4.5), R(9.0), R(6.0), false),
           "as old as an input allows: that is its own again, the others hold");
    tap_ok(sample(R(1.0), R(2.0), R(3.0)) && step_has(R(1.0), R(2.0), R(3.0), true), "until the next one");
    tap_ok(says("DE 00 01 00", NULL, "FF 01") && !iso_xcp_stimulates(&slave.stimulation, &slave.daq) &&
               !sample(R(1.0), R(2.0), R(3.0)),
           "a list that is stopped takes nothing");
    tap_ok(says("DE 01 01 00", NULL, "FF 01") && step_has(R(9.0), R(9.0), R(9.0), false), "and begins anew");
}

static void test_stimulation_refused(void)
{
    start_with_inputs(&open_plant);
    ask("FF 00", NULL);
    tap_ok(make_stimulation() && says("E0 02 00 00 00 00 01 00", NULL, "FF") && says("DE 02 01 00", NULL, "FF 01") &&
               says("DE 01 00 00", NULL, "FE 2A") && says("DE 00 01 00", NULL, "FF 01") &&
               says("DE 01 00 00", NULL, "FF 00"),
           "one list stimulates at a time");
    tap_ok(make_stimulation() && says("E2 00 01 00 01 00", NULL, "FF") && write_entry(world.memory.p) &&
               says("DE 01 01 00", NULL, "FE 2A"),
           "a tunable is no input");
    tap_ok(make_stimulation() && says("E2 00 01 00 01 00", NULL, "FF") &&
               write_entry((const uint8_t *)world.memory.x + 1) && says("DE 01 01 00", NULL, "FE 2A"),
           "nor is what begins within one");
    tap_ok(make_stimulation() && says("E2 00 01 00 01 00", NULL, "FF") && says("E1 FF 02 00 *", world.memory.x, "FF") &&
               says("DE 01 01 00", NULL, "FE 2A"),
           "nor a part of one");
    tap_ok(says("D6", NULL, "FF") && says("D5 00 01 00", NULL, "FF") && says("D4 00 00 00 01", NULL, "FF") &&
               says("D3 00 00 00 00 11", NULL, "FF") && says("E2 00 00 00 00 00", NULL, "FF"),
           "a table of 17");
    for (unsigned i = 0; i < 17; i++) {
        (void)write_entry(world.memory.x);
    }
    tap_ok(says("E0 02 00 00 00 00 01 00", NULL, "FF") && says("DE 01 00 00", NULL, "FE 2A"), "is too long");
    tap_ok(says("E0 00 00 00 00 00 01 00", NULL, "FF") && says("DE 01 00 00", NULL, "FF 00"), "but can be measured");

    start_with_inputs(&locked_plant);
    tap_ok(says("FF 00", NULL, "FF 0D C0 40 00 01 01 01") && says("FD", NULL, "FF 00 0D 00 00 00"), "it can be locked");
    slave.locked = ISO_XCP_STIMULATE;
    tap_ok(says("D6", NULL, "FF") && says("D5 00 01 00", NULL, "FF") &&
               says("E0 02 00 00 00 00 01 00", NULL, "FE 25") && says("E0 00 00 00 00 00 01 00", NULL, "FF"),
           "then lists measure, and none stimulates");
    ask("F8 00 08", NULL);
    tap_ok(got[0] == ISO_XCP_RES && got[1] == 4, "it has a seed");
}

/* What was written since a list was selected is checked when it starts. */
static void test_selected(void)
{
    start_with_inputs(&open_plant);
    ask("FF 00", NULL);
    tap_ok(says("D6", NULL, "FF") && says("D5 00 01 00", NULL, "FF") && says("D4 00 00 00 01", NULL, "FF") &&
               says("D3 00 00 00 00 0A", NULL, "FF") && says("E2 00 00 00 00 00", NULL, "FF") &&
               write_entry(world.memory.x) && says("E0 10 00 00 00 00 01 00", NULL, "FF") &&
               says("DE 02 00 00", NULL, "FF 00"),
           "a list of one value is selected");
    for (unsigned i = 1; i < 10; i++) {
        tap_ok(says(sizeof(real) == 4 ? "E1 FF 28 00 *" : "E1 FF 50 00 *", &world.memory, "FF"), "a long one is added");
    }
    tap_ok(says("DD 01", NULL, "FE 2A") && !iso_xcp_daq_runs(&slave.daq), "then it is too long, and does not start");
}

#endif
