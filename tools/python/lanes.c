/* Plants side by side in a program of another language: the plant of isoc --lanes, with -DISO_LANES=16 or another
 * number, in blocks of bytes of its own. `isochron python --lanes` compiles it, tools/python/lanes.py calls it. The
 * folder of plant.c is one for includes in quotes. */
#include "plant.c"

#include "core/numbers/self_check.h"
#include "core/runtime/hash.h"
#include "tools/python/lanes.h"

/* Of a plant without inputs, or without tunables, plant.h has no table. */
#ifdef ISO_SIDE_NO_INPUTS
enum { PLANT_INPUTS = 0 };
#define plant_inputs NULL
#endif
#ifdef ISO_SIDE_NO_PARAMETERS
enum { PLANT_PARAMETERS = 0 };
#define plant_parameters NULL
#endif

struct iso_side {
    plant_memory memory, parked, spare, other, start; /* the last: as it is at tick 0 */
    iso_lanes lanes;
    uint64_t hashes[ISO_LANES]; /* FNV-1a over the bytes of the states of a lane after each of its ticks */
};

static const struct {
    const iso_quantity *all;
    uint16_t count;
} tables[] = {
    [ISO_SIDE_STATES] = {plant_states, PLANT_STATES},
    [ISO_SIDE_INPUTS] = {plant_inputs, PLANT_INPUTS},
    [ISO_SIDE_TUNABLES] = {plant_parameters, PLANT_PARAMETERS},
    [ISO_SIDE_OUTPUTS] = {plant_outputs, PLANT_OUTPUTS},
};

const size_t iso_side_sizes[ISO_SIDE_SIZES] = {sizeof(iso_side), _Alignof(iso_side), ISO_LANES, sizeof(iso_scalar)};

const char *iso_side_name(const iso_side_kind kind, const uint16_t i)
{
    return i < tables[kind].count ? tables[kind].all[i].name : NULL;
}

void *iso_side_numbers(iso_side *const side, const iso_side_kind kind)
{
    const iso_plant *const plant = &side->lanes.plant;
    real *const at[] = {plant->x, plant->u, plant->p, plant->y};
    return at[kind];
}

bool iso_side_start(iso_side *const side)
{
    side->lanes = (iso_lanes){.plant = plant_plant(&side->memory), .parked = &side->parked};
    side->lanes.plant.spare = &side->spare;
    if (side->lanes.plant.before != NULL) {
        side->lanes.plant.before = &side->other;
    }
    const bool good = iso_self_check() && iso_lanes_start(&side->lanes);
    side->start = side->memory;
    for (unsigned lane = 0; lane < ISO_LANES; lane++) {
        side->hashes[lane] = ISO_HASH_START;
    }
    return good;
}

/* An input is driven if the functions of time overwrite a number in it. */
bool iso_side_is_driven(iso_side *const side, const uint16_t input)
{
    const iso_model *const model = side->lanes.plant.model;
    const size_t place = (size_t)((const char *)&side->lanes.plant.u[input] - (const char *)&side->memory);
    iso_bits row = ISO_NOTHING - 1; /* a NaN */
    memcpy(&side->spare, &side->memory, sizeof side->spare);
    memcpy((char *)&side->spare + place, &row, sizeof row);
    if (model->drive != NULL) {
        model->drive(&side->spare, side->lanes.tick + 1);
    }
    memcpy(&row, (const char *)&side->spare + place, sizeof row);
    return row[0] + 1 != 0;
}

/* A row has a word of each lane: those of the lanes of a mask are set to the start. */
void iso_side_restart(iso_side *const side, const uint8_t *const chosen)
{
    iso_bits mask = ISO_NOTHING;
    for (unsigned lane = 0; lane < ISO_LANES; lane++) {
        if (chosen[lane] != 0) {
            mask[lane] = (iso_word)0 - 1;
            side->hashes[lane] = ISO_HASH_START;
            side->lanes.stopped_at[lane] = 0;
        }
    }
    iso_lanes_take(&side->memory, &side->start, side->lanes.plant.lane_bytes, mask);
    side->lanes.statistics.stopped &= ~mask;
}

uint64_t iso_side_hash(const iso_side *const side, const unsigned lane)
{
    return side->hashes[lane];
}

uint64_t iso_side_stopped_at(const iso_side *const side, const unsigned lane)
{
    return side->lanes.stopped_at[lane];
}

static void take_row(const iso_side *const side, iso_scalar *const rows, const uint64_t room, const uint64_t row)
{
    const iso_plant *const plant = &side->lanes.plant;
    for (size_t i = 0; i < PLANT_OUTPUTS; i++) {
        memcpy(rows + (i * room + row) * ISO_LANES, &plant->y[i], sizeof plant->y[i]);
    }
}

static void give(const iso_side *const side, const iso_side_column *const columns, const uint64_t row)
{
    for (size_t i = 0; i < tables[ISO_SIDE_INPUTS].count; i++) {
        const iso_side_column *const c = &columns[i];
        for (unsigned lane = 0; lane < ISO_LANES && c->values != NULL; lane++) {
            side->lanes.plant.u[i][lane] = c->values[row * c->of_step + lane * c->of_lane];
        }
    }
}

uint64_t iso_side_run(iso_side *const side, const uint64_t ticks, const iso_side_column *const columns,
                      iso_scalar *const rows)
{
    uint64_t done = 0;
    bool runs = true;
    if (rows != NULL) {
        take_row(side, rows, ticks + 1, 0);
    }
    while (done < ticks && runs) {
        give(side, columns, done);
        runs = iso_lanes_tick(&side->lanes);
        done++;
        for (unsigned lane = 0; lane < ISO_LANES; lane++) {
            if (side->lanes.statistics.stopped[lane] == 0) {
                side->hashes[lane] = iso_hash_lane(side->hashes[lane], side->lanes.plant.x, PLANT_STATES, lane);
            }
        }
        if (rows != NULL) {
            take_row(side, rows, ticks + 1, done);
        }
    }
    return done;
}
