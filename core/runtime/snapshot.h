/* A snapshot: all of a plant at a tick in one flat array of bytes, from which it goes on bit for bit, on any target.
 *
 *     head      iso_snapshot_head, 56 bytes
 *     memory    the plant's, head.memory_bytes: states, history of the method, inputs, memories of effects, tunables
 *               and faults, outputs, last good values; noise and functions of time follow from the tick
 *     check     4 bytes: CRC-32 of all before it, polynomial 0x04C11DB7 reflected, start and last exclusive-or all ones
 *               (that of Ethernet, IEEE 802.3, and of zlib)
 *
 * The numbers are those of the processor, little-endian on every target that there is; the magic of a processor with
 * another order is another number. No member has padding, so a plant has the same snapshot on every target. The
 * account of times is no part of it, but for the rung of a ladder (core/runtime/policy.h), on which the next steps
 * depend.
 */
#ifndef ISO_CORE_RUNTIME_SNAPSHOT_H
#define ISO_CORE_RUNTIME_SNAPSHOT_H

#include "core/runtime/plant.h"

#ifdef __cplusplus
extern "C" {
#endif

#define iso_snapshot_take ISO_REAL_NAME(iso_snapshot_take)
#define iso_snapshot_restore ISO_REAL_NAME(iso_snapshot_restore)

#define ISO_SNAPSHOT_MAGIC UINT32_C(0x534F5349) /* the bytes "ISOS" */

enum { ISO_SNAPSHOT_VERSION = 2 };

typedef struct iso_snapshot_head {
    uint32_t magic;
    uint16_t version;
    uint16_t real_bytes; /* the type of numbers: 4 float, 8 double */
    uint64_t identity;   /* of the plant with its method, step and type of numbers */
    uint64_t tick;       /* steps done */
    uint64_t hash;       /* of the trajectory so far */
    uint32_t memory_bytes;
    uint16_t states;
    uint16_t inputs;
    uint16_t memories;
    uint16_t parameters;
    uint16_t outputs;
    uint16_t rung;   /* of `overrun degrade`; 0: the method of the scene */
    uint32_t good;   /* on a rung below it, ticks without an overrun; else 0 */
    uint32_t unused; /* 0 */
} iso_snapshot_head;

/* The size of a snapshot of a plant with so much memory. */
#define ISO_SNAPSHOT_BYTES(memory_bytes) (sizeof(iso_snapshot_head) + (memory_bytes) + sizeof(uint32_t))

/* Why a snapshot is refused. The order is that of the tests: the first that fails is the answer. */
typedef enum iso_snapshot_answer {
    ISO_SNAPSHOT_GOOD,
    ISO_SNAPSHOT_NO_SNAPSHOT,   /* it does not begin as one, or in another order of bytes */
    ISO_SNAPSHOT_OTHER_VERSION, /* of the snapshot */
    ISO_SNAPSHOT_WRONG_SIZE,    /* cut off, or something follows */
    ISO_SNAPSHOT_DAMAGED,       /* by its check */
    ISO_SNAPSHOT_OTHER_NUMBERS, /* float for double, or double for float */
    ISO_SNAPSHOT_OTHER_PLANT,   /* another scene, method or step */
    ISO_SNAPSHOT_NOT_A_STATE    /* a number that no snapshot has: not finite, or out of range */
} iso_snapshot_answer;

/* Takes the snapshot[ISO_SNAPSHOT_BYTES(plant->model->memory_bytes)] of a plant between two ticks: `tick` steps are
 * done, and the hash of the trajectory is `hash`. */
void iso_snapshot_take(unsigned char *snapshot, const iso_plant *plant, uint64_t identity, uint64_t tick,
                       uint64_t hash);

/* Restores the plant from snapshot[bytes], and sets *tick and *hash; or changes nothing, and returns the reason. */
iso_snapshot_answer iso_snapshot_restore(const iso_plant *plant, uint64_t identity, const unsigned char *snapshot,
                                         size_t bytes, uint64_t *tick, uint64_t *hash);

#ifdef __cplusplus
}
#endif

#endif
