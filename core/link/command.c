#include "core/link/command.h"

#include "core/methods/adams.h"

#define IS_NUMBERED(constant, number, words) _Static_assert((int)(constant) == (number), words);
ISO_SNAPSHOT_REFUSALS(IS_NUMBERED)
ISO_CONTROL_REFUSALS(IS_NUMBERED)

/* The bytes before those of a command: its type and its number. */
enum {
    HEAD_BYTES = 0 ISO_LINK_COMMAND_FIELDS(ISO_FIELD_BYTES),
    TICKS_BYTES = 0 ISO_COMMAND_RUN_TAKES(ISO_FIELD_BYTES),
    OFFSET_BYTES = 0 ISO_COMMAND_PIECE_FIELDS(ISO_FIELD_BYTES),
    TUNABLE_BYTES = 0 ISO_COMMAND_VALUE_FIELDS(ISO_FIELD_BYTES),
};

/* Whether the bytes behind the head are as many as the command has. */
static bool has_length(const iso_command_type type, const size_t length)
{
#define LENGTH(name, number) [number] = 0 ISO_COMMAND_##name##_TAKES(ISO_FIELD_BYTES),
    static const uint8_t lengths[ISO_COMMANDS] = {ISO_COMMAND_LIST(LENGTH)};
    return type == ISO_COMMAND_WRITE ? length > OFFSET_BYTES && length <= OFFSET_BYTES + ISO_COMMAND_PIECE
           : type == ISO_COMMAND_SET ? length == TUNABLE_BYTES + sizeof(real)
                                     : length == lengths[type];
}

/* Commands whose repetition has another effect. */
static bool is_done_once(const iso_command_type type)
{
    return type == ISO_COMMAND_RUN || type == ISO_COMMAND_RESET || type == ISO_COMMAND_RESTORE;
}

static size_t offset_of(const uint8_t *const payload)
{
    return (size_t)iso_frame_number(payload + HEAD_BYTES, OFFSET_BYTES);
}

/* How many bytes a piece has from there on; 0: none. */
static size_t piece_bytes(const iso_control *const control, const size_t offset)
{
    const size_t left = offset < control->snapshot_bytes ? control->snapshot_bytes - offset : 0;
    return left < ISO_COMMAND_PIECE ? left : ISO_COMMAND_PIECE;
}

static real *tunable_of(const iso_control *const control, const uint8_t *const payload)
{
    return iso_control_tunable(control, (size_t)iso_frame_number(payload + HEAD_BYTES, TUNABLE_BYTES));
}

static iso_control_answer set_tunable(const iso_control *const control, const uint8_t *const payload)
{
    real *const tunable = tunable_of(control, payload);
    if (tunable == NULL) {
        return ISO_CONTROL_NO_TUNABLE;
    }
    *tunable = iso_frame_real(payload + HEAD_BYTES + TUNABLE_BYTES);
    return ISO_CONTROL_DONE;
}

/* Commands that need a run that goes on. */
static bool is_of_a_run(const iso_command_type type)
{
    return type == ISO_COMMAND_RUN || type == ISO_COMMAND_REST || type == ISO_COMMAND_SET;
}

static bool is_stopped(const iso_control *const control)
{
    return control->loop->guard != control->loop->plant->model->states;
}

/* A restore ends the stop by the guard: it replaces the bad state. */
iso_control_answer iso_command_restore(iso_control *const control, const bool is_running, const size_t bytes)
{
    return is_running || is_stopped(control) ? iso_control_restore(control, bytes) : ISO_CONTROL_NO_RUN;
}

static iso_control_answer answer_to(iso_control *const control, const bool is_running, const uint8_t *const payload,
                                    const size_t length)
{
    if (!is_running && is_of_a_run((iso_command_type)payload[0])) {
        return ISO_CONTROL_NO_RUN;
    }
    switch (payload[0]) {
    case ISO_COMMAND_RUN:
        iso_control_run(control, iso_frame_number(payload + HEAD_BYTES, TICKS_BYTES));
        return ISO_CONTROL_DONE;
    case ISO_COMMAND_REST:
        iso_control_rest(control);
        return ISO_CONTROL_DONE;
    case ISO_COMMAND_SET:
        return set_tunable(control, payload);
    case ISO_COMMAND_GET:
        return tunable_of(control, payload) != NULL ? ISO_CONTROL_DONE : ISO_CONTROL_NO_TUNABLE;
    case ISO_COMMAND_RESET:
        iso_control_reset(control);
        return ISO_CONTROL_DONE;
    case ISO_COMMAND_TAKE:
        return iso_control_take(control);
    case ISO_COMMAND_READ:
        return piece_bytes(control, offset_of(payload)) > 0 ? ISO_CONTROL_DONE : ISO_CONTROL_BEYOND;
    case ISO_COMMAND_WRITE:
        return iso_control_write(control, offset_of(payload), payload + HEAD_BYTES + OFFSET_BYTES,
                                 length - HEAD_BYTES - OFFSET_BYTES);
    case ISO_COMMAND_RESTORE:
        return iso_command_restore(control, is_running, offset_of(payload));
    default: /* STATE, COUNTS: the answer alone */
        return ISO_CONTROL_DONE;
    }
}

iso_command_outcome iso_command_do(iso_commands *const commands, iso_control *const control, const bool is_running,
                                   const uint8_t *const payload, const size_t length)
{
    if (length < HEAD_BYTES || payload[0] == 0 || payload[0] >= ISO_COMMANDS ||
        !has_length((iso_command_type)payload[0], length - HEAD_BYTES)) {
        return ISO_COMMAND_UNKNOWN;
    }
    const iso_command_type type = (iso_command_type)payload[0];
    const bool again = commands->type == type && commands->number == payload[1] && is_done_once(type);
    if (!again) {
        commands->type = payload[0];
        commands->number = payload[1];
        commands->answer = (uint8_t)answer_to(control, is_running, payload, length);
        commands->done += commands->answer == ISO_CONTROL_DONE;
        commands->refused += commands->answer != ISO_CONTROL_DONE;
    }
    if (commands->answer != ISO_CONTROL_DONE) {
        return ISO_COMMAND_DONE;
    }
    return type == ISO_COMMAND_RESET && !again                        ? ISO_COMMAND_ANEW
           : type == ISO_COMMAND_RESTORE && !again                    ? ISO_COMMAND_WENT_ON
           : type == ISO_COMMAND_RESET || type == ISO_COMMAND_RESTORE ? ISO_COMMAND_MOVED
                                                                      : ISO_COMMAND_DONE;
}

static void put_piece(const iso_control *const control, const size_t offset, iso_frame_writer *const w)
{
    const size_t bytes = piece_bytes(control, offset);
    iso_frame_put(w, offset, OFFSET_BYTES);
    for (size_t i = 0; i < bytes; i++) {
        iso_frame_put(w, control->snapshot[offset + i], 1);
    }
}

static iso_command_state state_of(const iso_control *const control, const bool is_running)
{
    return is_stopped(control)               ? ISO_COMMAND_STOPPED
           : !is_running                     ? ISO_COMMAND_NO_RUN
           : iso_control_is_resting(control) ? ISO_COMMAND_RESTS
                                             : ISO_COMMAND_RUNS;
}

#define FIELD(name, ...) uint64_t name;
#define PUT_STATE(name, type, count) iso_frame_put(w, fields.name, ISO_BYTES_OF_##type);
static void put_state(const iso_control *const control, const bool is_running, iso_frame_writer *const w)
{
    const struct {
        ISO_COMMAND_STATE_FIELDS(FIELD)
    } fields = {
        .state = state_of(control, is_running),
        .tick = control->loop->tick,
        .left = control->left,
        .hash = control->hash,
        .snapshot_bytes = control->snapshot_bytes,
    };
    ISO_COMMAND_STATE_FIELDS(PUT_STATE)
}

void iso_command_put_counts(const iso_control *const control, const iso_link_statistics *const wire,
                            iso_frame_writer *const w)
{
    static const iso_adams_state none;
    const iso_loop *const loop = control->loop;
    const iso_statistics *const statistics = &loop->statistics;
    const iso_adams_state *const adams = loop->plant->adams == NULL ? &none : loop->plant->adams;
    const uint64_t hash = control->hash;
#define LOOP_COUNT(name, member) (uint64_t) statistics->member,
#define LOOP_WORD(name, value) value,
#define LINK_COUNT(name) wire->name,
    const uint64_t words[] = {ISO_STREAM_COUNTS(LOOP_COUNT) ISO_STREAM_WORDS(LOOP_WORD) ISO_LINK_COUNTS(LINK_COUNT)};
    _Static_assert(sizeof words == ISO_LINK_END_WORDS * sizeof(uint64_t),
                   "the end frame has these words and no others");
    for (size_t i = 0; i < ISO_LINK_END_WORDS; i++) {
        iso_frame_put(w, words[i], sizeof words[i]);
    }
}

void iso_command_put_answer(const iso_commands *const commands, const iso_control *const control,
                            const iso_link_statistics *const wire, const bool is_running, const uint8_t *const payload,
                            iso_frame_writer *const w)
{
    const bool is_done = commands->answer == ISO_CONTROL_DONE;
    iso_frame_put(w, payload[0], 1);
    iso_frame_put(w, payload[1], 1);
    iso_frame_put(w, commands->answer, 1);
    if (payload[0] == ISO_COMMAND_READ) {
        put_piece(control, offset_of(payload), w);
    } else if (payload[0] == ISO_COMMAND_GET && is_done) {
        iso_frame_put(w, iso_frame_number(payload + HEAD_BYTES, TUNABLE_BYTES), TUNABLE_BYTES);
        iso_frame_put_reals(w, tunable_of(control, payload), 1);
    } else if (payload[0] == ISO_COMMAND_COUNTS) {
        iso_command_put_counts(control, wire, w);
    } else {
        put_state(control, is_running, w);
    }
}
