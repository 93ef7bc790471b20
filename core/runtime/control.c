#include "core/runtime/control.h"

void iso_control_reset(iso_control *const control)
{
    iso_loop_restart(control->loop);
    iso_control_rest(control);
}

iso_control_answer iso_control_take(iso_control *const control)
{
    const iso_loop *const loop = control->loop;
    if (loop->guard != loop->plant->model->states) {
        return ISO_CONTROL_BAD_STATE;
    }
    if (control->snapshot_bytes < ISO_SNAPSHOT_BYTES(loop->plant->model->memory_bytes)) {
        return ISO_CONTROL_BEYOND;
    }
    iso_snapshot_take(control->snapshot, loop->plant, control->identity, loop->tick, control->hash);
    return ISO_CONTROL_DONE;
}

iso_control_answer iso_control_restore(iso_control *const control, const size_t bytes)
{
    uint64_t tick = 0;
    const iso_snapshot_answer answer = bytes > control->snapshot_bytes
                                           ? ISO_SNAPSHOT_WRONG_SIZE
                                           : iso_snapshot_restore(control->loop->plant, control->identity,
                                                                  control->snapshot, bytes, &tick, &control->hash);
    if (answer == ISO_SNAPSHOT_GOOD) {
        iso_loop_jump(control->loop, tick);
        iso_control_rest(control);
    }
    return (iso_control_answer)answer;
}
