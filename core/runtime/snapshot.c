#include "core/runtime/snapshot.h"

#include "core/methods/adams.h"
#include "core/runtime/policy_counts.h"

/* No padding between the members, with any alignment; for a plant's memory its own source checks this. */
_Static_assert(sizeof(iso_snapshot_head) == 56, "the head of a snapshot has no padding");
_Static_assert(sizeof(iso_progress) == 4 * sizeof(real) && sizeof(bool) == 1, "nor has iso_progress");
_Static_assert(sizeof(iso_adams_state) == 5 * sizeof(real) + 24, "nor has iso_adams_state");
_Static_assert(_Alignof(iso_any_progress) == _Alignof(real), "nor the memory of a plant by hand, before these");

/* CRC-32, half a byte at a time: the table has the remainders of all halves. */
static uint32_t check_of(const unsigned char *const bytes, const size_t count)
{
    static const uint32_t remainders[16] = {
        UINT32_C(0x00000000), UINT32_C(0x1DB71064), UINT32_C(0x3B6E20C8), UINT32_C(0x26D930AC),
        UINT32_C(0x76DC4190), UINT32_C(0x6B6B51F4), UINT32_C(0x4DB26158), UINT32_C(0x5005713C),
        UINT32_C(0xEDB88320), UINT32_C(0xF00F9344), UINT32_C(0xD6D6A3E8), UINT32_C(0xCB61B38C),
        UINT32_C(0x9B64C2B0), UINT32_C(0x86D3D2D4), UINT32_C(0xA00AE278), UINT32_C(0xBDBDF21C),
    };
    uint32_t check = UINT32_MAX;
    for (size_t i = 0; i < count; i++) {
        check ^= bytes[i];
        check = check >> 4 ^ remainders[check & 15];
        check = check >> 4 ^ remainders[check & 15];
    }
    return ~check;
}

/* The rung of a plant and the good ticks there; NULL without a ladder. */
static iso_policy_counts *ladder_of(const iso_plant *const plant)
{
    const iso_policy *const policy = plant->model->policy;
    return policy != NULL && policy->rungs > 0 ? policy->counts : NULL;
}

/* The head that a snapshot of this plant has, at the top of its ladder. */
static iso_snapshot_head head_of(const iso_plant *const plant, const uint64_t identity, const uint64_t tick,
                                 const uint64_t hash)
{
    const iso_model *const model = plant->model;
    return (iso_snapshot_head){
        .magic = ISO_SNAPSHOT_MAGIC,
        .version = ISO_SNAPSHOT_VERSION,
        .real_bytes = sizeof(real),
        .identity = identity,
        .tick = tick,
        .hash = hash,
        .memory_bytes = (uint32_t)model->memory_bytes,
        .states = model->states,
        .inputs = model->inputs,
        .memories = model->memories,
        .parameters = model->parameters,
        .outputs = model->outputs,
    };
}

void iso_snapshot_take(unsigned char *const snapshot, const iso_plant *const plant, const uint64_t identity,
                       const uint64_t tick, const uint64_t hash)
{
    iso_snapshot_head head = head_of(plant, identity, tick, hash);
    const iso_policy_counts *const ladder = ladder_of(plant);
    if (ladder != NULL && ladder->rung > 0) {
        head.rung = (uint16_t)ladder->rung;
        head.good = (uint32_t)ladder->good;
    }
    memcpy(snapshot, &head, sizeof head);
    memcpy(snapshot + sizeof head, plant->memory, head.memory_bytes);
    const uint32_t check = check_of(snapshot, sizeof head + head.memory_bytes);
    memcpy(snapshot + sizeof head + head.memory_bytes, &check, sizeof check);
}

/* The place of a part of the plant's memory in that of a snapshot. */
static const unsigned char *place_in(const unsigned char *const memory, const iso_plant *const plant,
                                     const void *const part)
{
    return memory + ((const unsigned char *)part - (const unsigned char *)plant->memory);
}

/* Whether all count reals from there on are finite, and none is beyond its range, if there is one. */
static bool are_within(const unsigned char *const at, const size_t count, const real *const range)
{
    iso_bits bad = 0;
    for (size_t i = 0; i < count; i++) {
        real x = R(0.0);
        memcpy(&x, at + i * sizeof x, sizeof x);
        bad |= iso_beyond(x, range == NULL ? ISO_REAL_MAX : range[i]);
    }
    return bad == 0;
}

/* Whether a bool has a valid value: a byte other than 0 and 1 is no value of C. */
static bool is_truth(const unsigned char *const at)
{
    return *at <= 1;
}

/* Whether the steps of adams can go on: its order and its level choose rows and shifts, and the order grows at a start.
 */
static bool is_adams(const unsigned char *const at)
{
    const unsigned char order = at[offsetof(iso_adams_state, order)], level = at[offsetof(iso_adams_state, level)];
    const unsigned char *const starting = at + offsetof(iso_adams_state, starting);
    return is_truth(starting) && is_truth(at + offsetof(iso_adams_state, overdue)) && order >= 1 &&
           order + *starting <= ISO_ADAMS_ORDERS && level <= ISO_ADAMS_LEVELS;
}

/* Whether a plant of the model can have this memory, and compute on from it. Inputs and tunables are checked at their
 * use, against the last good ones; the history of a method and the memories of effects show in the states, which the
 * guard checks. */
static bool is_a_state(const iso_plant *const plant, const unsigned char *const memory)
{
    const iso_model *const model = plant->model;
    const size_t good = (size_t)model->inputs + model->parameters + model->outputs;
    return are_within(place_in(memory, plant, plant->x), model->states, model->range) &&
           are_within(place_in(memory, plant, plant->y), model->outputs, NULL) &&
           are_within(place_in(memory, plant, plant->good), good, NULL) &&
           (plant->progress == NULL ||
            is_truth(place_in(memory, plant, plant->progress) + offsetof(iso_progress, discontinuity))) &&
           (plant->adams == NULL || is_adams(place_in(memory, plant, plant->adams)));
}

/* Whether the plant has this rung, and a good tick only below the top. */
static bool is_a_rung(const iso_plant *const plant, const iso_snapshot_head *const head)
{
    const uint16_t rungs = ladder_of(plant) == NULL ? 0 : plant->model->policy->rungs;
    return head->rung <= rungs && (head->rung > 0 || head->good == 0);
}

/* The reason why this program cannot read a snapshot (its head is then meaningless), or ISO_SNAPSHOT_GOOD. */
static iso_snapshot_answer read_head(const unsigned char *const snapshot, const size_t bytes,
                                     iso_snapshot_head *const head)
{
    if (bytes < ISO_SNAPSHOT_BYTES(0)) {
        return ISO_SNAPSHOT_WRONG_SIZE;
    }
    memcpy(head, snapshot, sizeof *head);
    if (head->magic != ISO_SNAPSHOT_MAGIC) {
        return ISO_SNAPSHOT_NO_SNAPSHOT;
    }
    if (head->version != ISO_SNAPSHOT_VERSION) {
        return ISO_SNAPSHOT_OTHER_VERSION;
    }
    if (head->memory_bytes != bytes - ISO_SNAPSHOT_BYTES(0)) {
        return ISO_SNAPSHOT_WRONG_SIZE;
    }
    uint32_t check = 0;
    memcpy(&check, snapshot + bytes - sizeof check, sizeof check);
    return check == check_of(snapshot, bytes - sizeof check) ? ISO_SNAPSHOT_GOOD : ISO_SNAPSHOT_DAMAGED;
}

iso_snapshot_answer iso_snapshot_restore(const iso_plant *const plant, const uint64_t identity,
                                         const unsigned char *const snapshot, const size_t bytes, uint64_t *const tick,
                                         uint64_t *const hash)
{
    iso_snapshot_head head;
    const iso_snapshot_answer readable = read_head(snapshot, bytes, &head);
    if (readable != ISO_SNAPSHOT_GOOD) {
        return readable;
    }
    if (head.real_bytes != sizeof(real)) {
        return ISO_SNAPSHOT_OTHER_NUMBERS;
    }
    iso_snapshot_head own = head_of(plant, identity, head.tick, head.hash);
    own.rung = head.rung;
    own.good = head.good;
    if (memcmp(&head, &own, sizeof own) != 0) {
        return ISO_SNAPSHOT_OTHER_PLANT;
    }
    if (!is_a_rung(plant, &head) || !is_a_state(plant, snapshot + sizeof head)) {
        return ISO_SNAPSHOT_NOT_A_STATE;
    }
    memcpy(plant->memory, snapshot + sizeof head, head.memory_bytes);
    iso_policy_counts *const ladder = ladder_of(plant);
    if (ladder != NULL) {
        ladder->rung = head.rung;
        ladder->good = head.good;
    }
    *tick = head.tick;
    *hash = head.hash;
    return ISO_SNAPSHOT_GOOD;
}
