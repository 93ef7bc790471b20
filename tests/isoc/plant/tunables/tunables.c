/* Tunables that change between two ticks. `tuned` is a plant with tunables, `other` the same with other defaults, and
 * `fixed` has these as constants. Values that follow from tunables alone stand in the memory of a plant: they must be
 * those of the tunables in every tick, in every copy of the memory. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/runtime/tick.h"
#include "fixed.h"
#include "other.h"
#include "tests/host/report.h"
#include "tuned.h"

enum { TICKS = 200, BYTES = TUNED_STATES * sizeof(real) };

static tuned_memory of_tuned, of_second;
static other_memory of_other;
static fixed_memory of_fixed;

static uint64_t restarts_of_tick(const iso_plant *const plant, const uint64_t tick)
{
    iso_tick_counts counts = {.restarts = 0};
    (void)iso_plant_tick_counted(plant, tick, &counts);
    return counts.restarts;
}

/* Ticks from one to before another; returns the restarts. */
static uint64_t run(const iso_plant *const plant, const uint64_t from, const uint64_t to)
{
    uint64_t restarts = 0;
    for (uint64_t tick = from; tick < to; tick++) {
        restarts += restarts_of_tick(plant, tick);
    }
    return restarts;
}

/* The tunables of `other`, in that many of the places. */
static void change(const iso_plant *const plant, const int count)
{
    for (int i = 0; i < count; i++) {
        plant->p[i] = other_parameters[i].start;
    }
}

static void prime_at(const iso_plant *const plant, const uint64_t tick)
{
    iso_plant_drive(plant, tick);
    if (plant->model->prime != NULL) {
        plant->model->prime(plant->memory);
    }
}

/* A plant at a tick with the state of another, and its method begun there. */
static void begin_at(const iso_plant *const plant, const iso_plant *const from, const uint64_t tick)
{
    iso_plant_start(plant);
    memcpy(plant->x, from->x, BYTES);
    prime_at(plant, tick);
}

/* After a change a plant goes on as one that was compiled with these values: the same bits. */
static void as_compiled(void)
{
    const iso_plant tuned = tuned_plant(&of_tuned), other = other_plant(&of_other);
    bool same = true;
    iso_plant_start(&tuned);
    uint64_t restarts = run(&tuned, 0, TICKS);
    report_ok(restarts == 0, "no restart while no tunable changes");
    begin_at(&other, &tuned, TICKS);
    change(&tuned, TUNED_PARAMETERS);
    for (uint64_t tick = TICKS; tick < 2 * TICKS; tick++) {
        restarts += restarts_of_tick(&tuned, tick);
        (void)restarts_of_tick(&other, tick);
        same = same && memcmp(tuned.x, other.x, BYTES) == 0;
    }
    report_ok(same, "changed between two ticks: the bits of a plant that was compiled with these values");
    report_ok(restarts == 1, "one restart for the change of all");
}

/* And as one that has them as constants, but for rounding: the derivative along the way. An acceleration is a sum of
 * some 30 products of up to three times its size, each with a rounding in either plant. */
static void as_constants(void)
{
    const iso_plant tuned = tuned_plant(&of_tuned), fixed = fixed_plant(&of_fixed);
    double off = 0.0, largest = 0.0;
    iso_plant_start(&tuned);
    iso_plant_start(&fixed);
    change(&tuned, TUNED_PARAMETERS);
    for (uint64_t tick = 0; tick < TICKS; tick++) {
        real a[TUNED_STATES], b[TUNED_STATES];
        (void)restarts_of_tick(&tuned, tick);
        tuned_derivative(a, tuned.x, tuned.u, tuned.p);
        fixed_derivative(b, tuned.x, tuned.u, fixed.p);
        for (int i = 0; i < TUNED_STATES; i++) {
            off = fmax(off, fabs((double)(a[i] - b[i])));
            largest = fmax(largest, fabs((double)b[i]));
        }
    }
    report_ok(off > 0.0 && off <= 100.0 * (double)ISO_REAL_EPSILON * largest, "%.2g of %.2g off constants: rounding",
              off, largest);
}

/* Two plants with tunables of their own, a tick of one after a tick of the other. */
static void instances(void)
{
    const iso_plant one = tuned_plant(&of_tuned), two = tuned_plant(&of_second);
    real alone_one[TUNED_STATES], alone_two[TUNED_STATES];
    iso_plant_start(&one);
    (void)run(&one, 0, TICKS);
    memcpy(alone_one, one.x, BYTES);
    iso_plant_start(&two);
    change(&two, 2);
    (void)run(&two, 0, TICKS);
    memcpy(alone_two, two.x, BYTES);

    iso_plant_start(&one);
    iso_plant_start(&two);
    change(&two, 2);
    for (uint64_t tick = 0; tick < TICKS; tick++) {
        (void)restarts_of_tick(&one, tick);
        (void)restarts_of_tick(&two, tick);
    }
    report_ok(memcmp(one.x, alone_one, BYTES) == 0 && memcmp(two.x, alone_two, BYTES) == 0 &&
                  memcmp(alone_one, alone_two, BYTES) != 0,
              "two plants, each with its own tunables");
}

/* A copy of the memory is all: what was tried after it leaves no trace. */
static void snapshot(void)
{
    const iso_plant plant = tuned_plant(&of_tuned);
    real straight[TUNED_STATES];
    iso_plant_start(&plant);
    change(&plant, 3);
    (void)run(&plant, 0, TICKS);
    of_second = of_tuned;
    (void)run(&plant, TICKS, 2 * TICKS);
    memcpy(straight, plant.x, BYTES);

    of_tuned = of_second;
    change(&plant, TUNED_PARAMETERS);
    (void)run(&plant, TICKS, TICKS + 10);
    const bool other_way = memcmp(plant.x, of_second.x, BYTES) != 0;
    of_tuned = of_second;
    (void)run(&plant, TICKS, 2 * TICKS);
    report_ok(other_way && memcmp(plant.x, straight, BYTES) == 0, "a copy of the memory is a snapshot");
}

/* What is not finite stays at its last good value, and is no change; a limit that is passed is one. */
static void refused(void)
{
    const iso_plant plant = tuned_plant(&of_tuned);
    iso_plant_start(&plant);
    (void)run(&plant, 0, 1);
    plant.p[0] = (real)NAN;
    const uint64_t of_nan = run(&plant, 1, 3);
    plant.p[0] = R(100.0);
    const uint64_t of_limit = run(&plant, 3, 5);
    plant.p[0] = R(200.0);
    const uint64_t of_same = run(&plant, 5, 7);
    report_ok(of_nan == 0 && of_limit == 1 && of_same == 0 && plant.p[0] == tuned_parameters[0].most,
              "NaN is no change, a value that is set to a limit is one");
}

int main(void)
{
    as_compiled();
    as_constants();
    instances();
    snapshot();
    refused();
    return report_done();
}
