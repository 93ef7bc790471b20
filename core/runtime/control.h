/* Commands to a plant from outside, between two ticks: to run for a number of ticks, to rest, to restore a snapshot.
 * The state of all this is in iso_control, and can be read at any time.
 *
 * A plant that rests keeps its outputs; ticks of the port pass meanwhile, and none is lost or late (iso_loop_rest). So
 * does a plant that the guard has stopped, until it is put to its start or to a snapshot. */
#ifndef ISO_CORE_RUNTIME_CONTROL_H
#define ISO_CORE_RUNTIME_CONTROL_H

#include "core/runtime/loop.h"
#include "core/runtime/snapshot.h"

#define iso_control_reset ISO_REAL_NAME(iso_control_reset)
#define iso_control_take ISO_REAL_NAME(iso_control_take)
#define iso_control_restore ISO_REAL_NAME(iso_control_restore)

#define ISO_CONTROL_ENDLESS UINT64_MAX

/* The answer to a command. The first values are those of iso_snapshot_answer. */
typedef enum iso_control_answer {
    ISO_CONTROL_DONE = ISO_SNAPSHOT_GOOD,
    ISO_CONTROL_NO_RUN = 16, /* not started, over, or stopped by the guard: then a restore goes on */
    ISO_CONTROL_BAD_STATE,   /* no snapshot of a plant that the guard has stopped */
    ISO_CONTROL_BEYOND,      /* a piece that is not in the snapshot; or there is no room for a snapshot */
    ISO_CONTROL_RUNS,        /* the plant does not rest, so that it is put to no other tick */
    ISO_CONTROL_NO_TUNABLE
} iso_control_answer;

typedef struct iso_control {
    iso_loop *loop;
    unsigned char *snapshot; /* [snapshot_bytes]: a snapshot that was taken, or that is being written in pieces */
    size_t snapshot_bytes;   /* ISO_SNAPSHOT_BYTES(memory_bytes) */
    uint64_t identity;       /* of the plant with its method, step and type of numbers */
    uint64_t hash;           /* of the trajectory so far */
    uint64_t left;           /* ticks to do until it rests, or ISO_CONTROL_ENDLESS; 0: it rests */
} iso_control;

/* The address of a tunable of the plant; NULL if there is none of this number. Between two ticks it may be set: the
 * next tick checks it as the platform's own (core/runtime/admit.h). A reset puts it to its default, a restore to that
 * of the snapshot. */
static inline real *iso_control_tunable(const iso_control *const control, const size_t tunable)
{
    const iso_plant *const plant = control->loop->plant;
    return tunable < plant->model->parameters ? &plant->p[tunable] : NULL;
}

/* Runs for so many ticks; 0: until the next command. */
static inline void iso_control_run(iso_control *const control, const uint64_t ticks)
{
    control->left = ticks == 0 ? ISO_CONTROL_ENDLESS : ticks;
}

static inline void iso_control_rest(iso_control *const control)
{
    control->left = 0;
}

static inline bool iso_control_is_resting(const iso_control *const control)
{
    return control->left == 0;
}

/* After a tick, with the hash of the trajectory. A plant that got the command to rest within the tick rests after it.
 */
static inline void iso_control_done(iso_control *const control, const uint64_t hash)
{
    control->left -= control->left != ISO_CONTROL_ENDLESS && !iso_control_is_resting(control);
    control->hash = hash;
}

/* Puts the plant to its start, where it rests, and begins the account anew. The hash is the caller's to begin. */
void iso_control_reset(iso_control *control);

/* Takes a snapshot of the plant. */
iso_control_answer iso_control_take(iso_control *control);

/* Puts the plant to the snapshot, of `bytes` bytes by the caller: publishes its outputs, and the plant rests. If
 * the snapshot is refused, nothing changes. */
iso_control_answer iso_control_restore(iso_control *control, size_t bytes);

/* Writes count bytes into the snapshot from `offset` on; all of them, or none if one would be beyond its end. */
static inline iso_control_answer iso_control_write(const iso_control *const control, const size_t offset,
                                                   const uint8_t *const bytes, const size_t count)
{
    if (offset > control->snapshot_bytes || count > control->snapshot_bytes - offset) {
        return ISO_CONTROL_BEYOND;
    }
    memcpy(control->snapshot + offset, bytes, count);
    return ISO_CONTROL_DONE;
}

#endif
