/* Outputs that are not of each tick, in a plant of tests/isoc/plant/outputs/rates.scene: before and after a snapshot,
 * across 2^32 ticks, and where an output is not finite. */
#include <string.h>

#include "core/runtime/snapshot.h"
#include "core/runtime/tick.h"
#include "rates.h"
#include "tests/host/report.h"

enum { IDENTITY = 7 };

static rates_memory memory, other_memory;
static unsigned char record[ISO_SNAPSHOT_BYTES(sizeof memory)];

static bool same(const real *const a, const real *const b, const size_t n)
{
    return memcmp(a, b, n * sizeof *a) == 0;
}

/* A plant that goes on from a snapshot between the ticks of its slow outputs has the same outputs as the first. */
static bool goes_on(const iso_plant *const plant, const uint64_t from)
{
    const iso_plant other = rates_plant(&other_memory);
    uint64_t tick = 0, hash = 0;
    iso_snapshot_take(record, plant, IDENTITY, from, 0);
    iso_plant_start(&other);
    bool is = iso_snapshot_restore(&other, IDENTITY, record, sizeof record, &tick, &hash) == ISO_SNAPSHOT_GOOD;
    for (uint64_t i = from; i < from + 30; i++) {
        is = is && same(plant->y, other.y, RATES_OUTPUTS);
        is = is && iso_plant_tick(plant, i) == RATES_STATES && iso_plant_tick(&other, tick++) == RATES_STATES;
    }
    return is;
}

/* Whether a slow output changes at the end of the ticks whose number is a multiple of 3, and at no others; the plant is
 * told other numbers, which are so far ahead. */
static bool keeps_rate(const iso_plant *const plant, const uint64_t from, const uint64_t to, const uint64_t ahead)
{
    bool is = true;
    for (uint64_t i = from; i < to; i++) {
        const real before = plant->y[RATES_Y_MEAN_3];
        is = is && iso_plant_tick(plant, i + ahead) == RATES_STATES;
        is = is && ((i + 1) % 3 == 0) == same(&plant->y[RATES_Y_MEAN_3], &plant->y[RATES_Y_MEAN], 1);
        is = is && ((i + 1) % 3 == 0) != same(&plant->y[RATES_Y_MEAN_3], &before, 1);
    }
    return is;
}

/* An output that is not finite is so at its own ticks: then the last good ones of all stand, and that is counted. */
static bool is_held(const iso_plant *const plant)
{
    iso_tick_counts counts = {.restarts = 0};
    bool is = true;
    iso_plant_start(plant);
    plant->model->output(plant->memory);
    const real first = plant->y[RATES_Y_LONE_5];
    plant->p[RATES_P_DIVISOR] = R(0.0);
    for (uint64_t i = 0; i < 20; i++) {
        const real theta = plant->y[RATES_Y_THETA];
        (void)iso_plant_tick_counted(plant, i, &counts);
        is = is && counts.outputs_held == (i + 1) / 5;
        is = is && same(&plant->y[RATES_Y_LONE_5], &first, 1);
        is = is && ((i + 1) % 5 == 0) == same(&plant->y[RATES_Y_THETA], &theta, 1);
    }
    return is;
}

int main(void)
{
    const iso_plant plant = rates_plant(&memory);
    iso_plant_start(&plant);
    plant.model->output(plant.memory);
    report_ok(same(&plant.y[RATES_Y_MEAN], &plant.y[RATES_Y_MEAN_3], 1), "at the start all are computed");
    report_ok(keeps_rate(&plant, 0, 50, 0), "in the ticks of its rate, and in no other");
    report_ok(!keeps_rate(&plant, 50, 60, 1), "found: ticks that are one off");
    report_ok(goes_on(&plant, 62), "a plant from a snapshot has the same outputs");
    const uint64_t wrap = UINT64_C(1) << 32;
    (void)iso_plant_tick(&plant, wrap - 6);
    report_ok(keeps_rate(&plant, wrap - 5, wrap + 20, 0), "also from tick 2^32 on");
    report_ok(is_held(&plant), "an output that is not finite is held, and counted when it is computed");
    return report_done();
}
