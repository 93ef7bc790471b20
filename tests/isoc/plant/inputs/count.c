/* What each tick takes outside of the step, on the board, where the clock counts instructions: functions of time, and
 * what is kept of signals. And a hash of all outputs, on the board and on the host. */
#include <string.h>

#include PLANT
#include "core/runtime/tick.h"
#include "port/port.h"
#include "tests/tap.h"

enum { TICKS = 3000 };

typedef struct bounds {
    uint64_t least, most;
} bounds;

static void widen(bounds *const r, const uint64_t from)
{
    const uint64_t took = iso_port_clock() - from;
    r->least = took < r->least ? took : r->least;
    r->most = took > r->most ? took : r->most;
}

/* FNV-1a (Fowler, Noll and Vo 1991). */
static uint64_t hash_of(uint64_t hash, const real *const y, const size_t count)
{
    for (size_t i = 0; i < count; i++) {
        hash = (hash ^ iso_bits_of(y[i])) * UINT64_C(0x100000001B3);
    }
    return hash;
}

/* Which of the samples of waveforms.scene are due in a row: those of each 7 ms, and of each 20 ms. */
enum { ALL_DUE = 3 };
static unsigned samples_due(const uint64_t row)
{
    return (row % 7 == 0) + 2U * (row % 20 == 0);
}

int main(void)
{
    const iso_plant *const plant = &iso_the_plant;
    bounds nothing = {UINT64_MAX, 0}, drive = {UINT64_MAX, 0};
    bounds advance[] = {{UINT64_MAX, 0}, {UINT64_MAX, 0}, {UINT64_MAX, 0}, {UINT64_MAX, 0}};
    uint64_t hash = UINT64_C(0xCBF29CE484222325);
    iso_port_start(UINT32_C(10000000)); /* longer than all that a tick takes */
    iso_plant_start(plant);
    for (uint64_t tick = 0; tick < TICKS; tick++) {
        (void)iso_port_wait(); /* the timer interrupts here and not below */
        uint64_t from = iso_port_clock();
        widen(&nothing, from);
        from = iso_port_clock();
        iso_plant_drive(plant, tick);
        widen(&drive, from);
        (void)iso_plant_step(plant);
        from = iso_port_clock();
        if (plant->model->advance != NULL) {
            plant->model->advance(plant->memory);
        }
        widen(&advance[samples_due(tick + 1)], from);
        plant->model->output(plant->memory);
        hash = hash_of(hash, plant->y, plant->model->outputs);
    }
    tap_note_bits("hash", hash);
    tap_note("drive", (uint32_t)(drive.most - nothing.most));
    tap_note("advance", (uint32_t)(advance[ALL_DUE].most - nothing.most));
    tap_count((uint32_t)drive.most, (uint32_t)drive.least,
              "the functions of time take as many instructions in every tick");
    for (unsigned due = 0; due <= ALL_DUE; due++) {
        tap_count((uint32_t)advance[due].most, (uint32_t)advance[due].least,
                  "and so does what is kept of signals, with the same samples due");
    }
    tap_done();
}
