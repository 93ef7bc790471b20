/* Plants of every method, with effects, noise, faults and trees of all kinds of joints: at some tick a record is taken,
 * and the plant goes on; another of its kind, which was somewhere else, takes the record and goes on. Both end in the
 * same memory with the same hash. Ticks are random, by the seed that is printed. */
#include <stdlib.h>

#include "core/runtime/hash.h"
#include "core/runtime/snapshot.h"
#include "core/runtime/tick.h"
#include "tests/core/runtime/snapshots/family.h"
#include "tests/host/report.h"

enum { RECORD_MOST = 1 << 16, TRIES = 3 };

static uint64_t chance;

/* Steele, Lea and Flood 2014: splitmix64. */
static uint64_t below(const uint64_t limit)
{
    chance += UINT64_C(0x9E3779B97F4A7C15);
    uint64_t z = (chance ^ chance >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ z >> 27) * UINT64_C(0x94D049BB133111EB);
    return (z ^ z >> 31) % limit;
}

/* The plant from one tick to another; what is set from outside is a function of the tick. Returns the tick that it
 * reaches: where a method is not stable, the guard stops it. */
static uint64_t go(const iso_plant *const plant, const uint64_t from, const uint64_t to, uint64_t *const hash)
{
    for (uint64_t tick = from; tick < to; tick++) {
        if (plant->model->drive == NULL && plant->model->inputs > 0) {
            plant->u[0] = (real)(tick % 5) * R(0.125);
        }
        if (iso_plant_tick(plant, tick) < plant->model->states) {
            return tick;
        }
        *hash = iso_hash_reals(*hash, plant->x, plant->model->states);
    }
    return to;
}

/* Whether it goes on from a record at tick k to the end as it went on itself. */
static bool goes_on(const iso_plant *const one, const iso_plant *const other, const uint64_t k, const uint64_t to)
{
    static unsigned char record[RECORD_MOST], again[RECORD_MOST];
    const size_t bytes = ISO_SNAPSHOT_BYTES(one->model->memory_bytes);
    uint64_t hash = ISO_HASH_START, elsewhere = ISO_HASH_START, tick = 0, taken = 0;
    iso_plant_start(one);
    iso_plant_start(other);
    (void)go(one, 0, k, &hash);
    if (other->model->parameters > 0) { /* what follows from tunables alone is kept too */
        other->p[0] += R(0.25);
    }
    (void)go(other, 0, below(to), &elsewhere);
    iso_snapshot_take(record, one, 1, k, hash);
    const uint64_t end = go(one, k, to, &hash);
    if (bytes > sizeof record || iso_snapshot_restore(other, 1, record, bytes, &tick, &taken) != ISO_SNAPSHOT_GOOD) {
        return false;
    }
    iso_snapshot_take(again, other, 1, tick, taken);
    return memcmp(record, again, bytes) == 0 && go(other, tick, to, &taken) == end && taken == hash &&
           memcmp(one->memory, other->memory, one->model->memory_bytes) == 0;
}

int main(const int argc, char **const argv)
{
    chance = argc > 1 ? strtoull(argv[1], NULL, 10) : 1;
    report_note("seed %llu", (unsigned long long)chance);
    for (const family_member *const *m = family; *m != NULL; m++) {
        const iso_plant one = (*m)->plant_of(0), other = (*m)->plant_of(1);
        uint64_t unused = ISO_HASH_START;
        iso_plant_start(&one);
        const uint64_t end = go(&one, 0, (*m)->ticks, &unused);
        bool good = end > 0;
        for (int i = 0; i < TRIES && good; i++) {
            const uint64_t k = below(end);
            good = goes_on(&one, &other, k, end + 1);
            if (!good) {
                report_note("from tick %llu", (unsigned long long)k);
            }
        }
        report_ok(good, "%s goes on bit for bit, %zu bytes", (*m)->name, ISO_SNAPSHOT_BYTES(one.model->memory_bytes));
    }
    return report_done();
}
