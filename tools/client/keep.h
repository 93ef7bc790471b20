#ifndef ISO_CLIENT_KEEP_H
#define ISO_CLIENT_KEEP_H

/* Snapshots that take the controller's own state along: behind the plant's bytes stand those of the controller, their
 * number in 4 bytes, their CRC in 2, and "is". core/link/README.md has the words. */
#ifdef __cplusplus
extern "C" {
#endif

enum { ISO_CLIENT_TAIL = 8 };

/* Takes a snapshot of both into snapshot[room]. Returns its bytes; 0 with a problem. */
static inline size_t iso_client_take_both(iso_client *c, void *snapshot, size_t room)
{
    const size_t of_plant = iso_client_snapshot(c, snapshot, room);
    const size_t own = c->own_bytes + ISO_CLIENT_TAIL;
    if (of_plant == 0 || c->own_bytes == 0) {
        return of_plant;
    }
    if (own > room - of_plant) {
        return (size_t)iso_client_fail(c, "the snapshot", "there is no room for the state of the controller");
    }
    uint8_t *at = (uint8_t *)snapshot + of_plant;
    memcpy(at, c->own, c->own_bytes);
    const uint64_t tail =
        c->own_bytes | (uint64_t)iso_client_crc_of(at, c->own_bytes) << 32 | (uint64_t)'i' << 48 | (uint64_t)'s' << 56;
    for (size_t i = 0; i < ISO_CLIENT_TAIL; i++) {
        at[c->own_bytes + i] = (uint8_t)(tail >> 8 * i & 0xFF);
    }
    return of_plant + own;
}

/* Puts both to a snapshot; neither where one of them refuses it. */
static inline bool iso_client_put_both(iso_client *c, const void *snapshot, size_t bytes)
{
    const size_t own = c->own_bytes + ISO_CLIENT_TAIL;
    if (c->own_bytes == 0) {
        return iso_client_restore(c, snapshot, bytes);
    }
    const uint8_t *state = (const uint8_t *)snapshot + (bytes > own ? bytes - own : 0);
    const uint64_t tail = bytes > own ? iso_client_number(state + c->own_bytes, ISO_CLIENT_TAIL) : 0;
    if (tail >> 48 != ('i' | 's' << 8) || (tail & 0xFFFFFFFF) != c->own_bytes) {
        return iso_client_fail(c, "the snapshot", "it has no state of a controller of so many bytes");
    }
    if ((tail >> 32 & 0xFFFF) != iso_client_crc_of(state, c->own_bytes)) {
        return iso_client_fail(c, "the snapshot", "the state of the controller is damaged");
    }
    if (!iso_client_restore(c, snapshot, bytes - own)) {
        return false;
    }
    memcpy(c->own, state, c->own_bytes);
    return true;
}

#ifdef __cplusplus
}
#endif

#endif
