#ifndef ISO_CLIENT_COMMANDS_H
#define ISO_CLIENT_COMMANDS_H

/* Commands to a plant, between two ticks, over the link of client.h, which stands before this in all headers that isoc
 * writes. */
#ifdef __cplusplus
extern "C" {
#endif

#define ISO_CLIENT_TAKES(name, number, bytes) +(command == (number) ? (bytes) : 0)

/* Begins a command with the number that it takes; one that takes none has no bytes of it. */
static inline void iso_client_command(iso_client *c, uint8_t command, uint64_t argument)
{
    iso_client_begin(c, ISO_CLIENT_FRAME_COMMAND);
    iso_client_put(c, command, 1);
    iso_client_put(c, ++c->number, 1);
    iso_client_put(c, argument, (size_t)(0 ISO_CLIENT_COMMANDS(ISO_CLIENT_TAKES)));
}

/* Sends the command that has been begun, again and again until its answer comes: that is then from
 * received[ISO_CLIENT_ANSWER_AT] on, of *length bytes; before it stands the result of the command. */
enum { ISO_CLIENT_ANSWER_AT = 1 + ISO_CLIENT_BYTES_OF_ANSWER };

/* Whether the command was done, by the answer that has come. */
static inline bool iso_client_is_done(iso_client *c)
{
    const uint8_t answer = c->received[ISO_CLIENT_ANSWER_AT - 1];
    return answer == 0 || iso_client_fail(c, "refused", iso_client_answer(answer));
}

static inline bool iso_client_ask(iso_client *c, uint8_t command, size_t *length)
{
    if (c->inside != NULL) {
        return iso_client_ask_inside(c, length) && iso_client_is_done(c);
    }
    bool sent = iso_client_finish(c);
    for (int tries = 0; sent && tries < ISO_CLIENT_TRIES;) {
        const int came = iso_client_receive(c, ISO_CLIENT_PATIENCE_MS, length);
        if (came < 0) {
            return false;
        }
        if (came == 0) {
            tries++;
            sent = iso_client_write(c);
        } else if (c->received[0] == ISO_CLIENT_FRAME_ANSWER && *length >= ISO_CLIENT_BYTES_OF_ANSWER &&
                   c->received[1] == command && c->received[2] == c->number) {
            *length -= ISO_CLIENT_BYTES_OF_ANSWER;
            return iso_client_is_done(c);
        } else if (iso_client_take(c, *length, 0) < 0 && !c->over) {
            return false;
        }
    }
    return sent && iso_client_fail(c, "the plant does not answer", NULL);
}

#define ISO_CLIENT_FIELD_BYTES(name, bytes) +(bytes)
#define ISO_CLIENT_TAKE_FIELD(name, bytes)                                                                             \
    c->state.name = (ISO_CLIENT_OF_##bytes)iso_client_number(at, bytes), at += (bytes);
enum { ISO_CLIENT_STATE_BYTES = 0 ISO_CLIENT_STATE_FIELDS(ISO_CLIENT_FIELD_BYTES) };

/* Sends the command that has been begun; its answer says how the plant is. */
static inline bool iso_client_ask_state(iso_client *c, uint8_t command)
{
    size_t length = 0;
    if (!iso_client_ask(c, command, &length) || length != ISO_CLIENT_STATE_BYTES) {
        return false;
    }
    const uint8_t *at = c->received + ISO_CLIENT_ANSWER_AT;
    ISO_CLIENT_STATE_FIELDS(ISO_CLIENT_TAKE_FIELD)
    return true;
}

/* The first command of a link asks how the plant is, and no more: then no number of a controller before is taken for
 * one of this. */
static inline bool iso_client_meet(iso_client *c)
{
    if (c->number != 0) {
        return true;
    }
    iso_client_command(c, ISO_CLIENT_STATE, 0);
    return iso_client_ask_state(c, ISO_CLIENT_STATE);
}

/* A command whose answer says how the plant is. */
static inline bool iso_client_do(iso_client *c, uint8_t command, uint64_t argument)
{
    if (!iso_client_meet(c)) {
        return false;
    }
    iso_client_command(c, command, argument);
    return iso_client_ask_state(c, command);
}

/* Sets a tunable, by its place, to a real, from the next step on; client.state.tick says which. */
static inline bool iso_client_set(iso_client *c, uint16_t tunable, const void *value)
{
    if (!iso_client_meet(c)) {
        return false;
    }
    iso_client_command(c, ISO_CLIENT_SET, tunable);
    iso_client_put_reals(c, value, 1);
    return iso_client_ask_state(c, ISO_CLIENT_SET);
}

/* Reads a tunable as it is now. */
static inline bool iso_client_get(iso_client *c, uint16_t tunable, void *value)
{
    size_t length = 0;
    const uint8_t *answer = c->received + ISO_CLIENT_ANSWER_AT;
    iso_client_command(c, ISO_CLIENT_GET, tunable);
    if (!iso_client_ask(c, ISO_CLIENT_GET, &length) || length != ISO_CLIENT_BYTES_TO_GET + c->real_bytes ||
        iso_client_number(answer, ISO_CLIENT_BYTES_TO_GET) != tunable) {
        return false;
    }
    iso_client_get_reals(c, value, answer + ISO_CLIENT_BYTES_TO_GET, 1);
    return true;
}

/* How the run has gone so far: in `end`, as at its end. */
static inline bool iso_client_counts(iso_client *c)
{
    size_t length = 0;
    iso_client_command(c, ISO_CLIENT_COUNTS, 0);
    if (!iso_client_ask(c, ISO_CLIENT_COUNTS, &length) || length != sizeof c->end) {
        return false;
    }
    iso_client_take_words(c, c->received + ISO_CLIENT_ANSWER_AT);
    return true;
}

/* A command that puts the plant to another tick, with the outputs there. */
static inline bool iso_client_move(iso_client *c, uint8_t command, uint64_t argument)
{
    if (!iso_client_do(c, command, argument)) {
        return false;
    }
    c->over = false;
    return iso_client_await(c, c->state.tick);
}

/* Takes a snapshot of the plant into snapshot[room]. Returns its bytes; 0 with a problem. */
static inline size_t iso_client_snapshot(iso_client *c, void *snapshot, size_t room)
{
    size_t length = 0;
    if (!iso_client_do(c, ISO_CLIENT_TAKE, 0)) {
        return 0;
    }
    const size_t bytes = c->state.snapshot_bytes, head = ISO_CLIENT_BYTES_TO_READ;
    for (size_t at = 0; at < bytes && bytes <= room; at += length - head) {
        iso_client_command(c, ISO_CLIENT_READ, at);
        if (!iso_client_ask(c, ISO_CLIENT_READ, &length)) {
            return 0;
        }
        const uint8_t *piece = c->received + ISO_CLIENT_ANSWER_AT;
        if (length <= head || iso_client_number(piece, head) != at || length - head > bytes - at) {
            return (size_t)iso_client_fail(c, "the snapshot", "a piece is not that which was asked for");
        }
        memcpy((char *)snapshot + at, piece + head, length - head);
    }
    return bytes <= room ? bytes : (size_t)iso_client_fail(c, "the snapshot", "there is no room for it");
}

/* Puts the plant to a snapshot, of this or another plant of its kind; it rests there, and the outputs are those. */
static inline bool iso_client_restore(iso_client *c, const void *snapshot, size_t bytes)
{
    size_t length = 0;
    for (size_t at = 0; at < bytes; at += ISO_CLIENT_PIECE) {
        const size_t piece = bytes - at < ISO_CLIENT_PIECE ? bytes - at : (size_t)ISO_CLIENT_PIECE;
        iso_client_command(c, ISO_CLIENT_WRITE, at);
        for (size_t i = 0; i < piece; i++) {
            iso_client_put_byte(c, ((const uint8_t *)snapshot)[at + i]);
        }
        if (!iso_client_ask(c, ISO_CLIENT_WRITE, &length)) {
            return false;
        }
    }
    return iso_client_move(c, ISO_CLIENT_RESTORE, bytes);
}

#ifdef __cplusplus
}
#endif

#endif
