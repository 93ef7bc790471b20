#include "tools/monitor/monitor.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/runtime/control.h"
#include "core/wire/protocol.h"
#include "tools/file/file.h"

enum { RECORD_MOST = 1 << 24 };

static bool fail(master *const m, const char *const what, const char *const why)
{
    return master_fail(m, "%.120s: %.120s", what, why);
}

static const char *reason(const uint8_t answer)
{
    switch (answer) {
#define REASON(constant, number, words)                                                                                \
    case number:                                                                                                       \
        return words;
        ISO_SNAPSHOT_REFUSALS(REASON)
        ISO_CONTROL_REFUSALS(REASON)
    default:
        return "the plant refuses";
    }
}

/* CRC-32, bit by bit: the check of a snapshot. */
static uint32_t check_of(const uint8_t *const bytes, const size_t count)
{
    uint32_t check = UINT32_MAX;
    for (size_t i = 0; i < count; i++) {
        check ^= bytes[i];
        for (int bit = 0; bit < 8; bit++) {
            check = check >> 1 ^ ((check & 1) != 0 ? UINT32_C(0xEDB88320) : 0);
        }
    }
    return ~check;
}

static bool write_file(master *const m, const char *const path, const uint8_t *const content, const size_t bytes)
{
    static new_file f;
    bool good = file_begin(&f, NULL, path, "partial");
    if (good) {
        (void)fwrite(content, 1, bytes, f.to);
        good = file_end(&f);
    }
    return good || fail(m, path, strerror(errno));
}

/* Whether the snapshot is whole: it was not changed while it was read. */
static bool is_whole(const uint8_t *const content, const size_t bytes)
{
    uint32_t check = 0;
    if (bytes < ISO_SNAPSHOT_BYTES(0) || memcmp(content, "ISOS", 4) != 0) {
        return false;
    }
    memcpy(&check, content + bytes - sizeof check, sizeof check);
    return check == check_of(content, bytes - sizeof check);
}

bool snapshot_save(master *const m, const char *const path)
{
    uint32_t at = 0, bytes = 0;
    uint8_t answer = 0;
    if (!master_take(m, &answer, &at, &bytes)) {
        return false;
    }
    if (answer != ISO_CONTROL_DONE || bytes > RECORD_MOST) {
        return fail(m, path, reason(answer));
    }
    uint8_t *const content = memory_for(bytes, 1);
    bool good = master_read(m, at, content, bytes);
    if (good && !is_whole(content, bytes)) {
        good = fail(m, path, "the snapshot changed while it was read; another program has its hands on it");
    }
    good = good && write_file(m, path, content, bytes);
    free(content);
    return good;
}

/* The first answer has the place of the snapshot. */
bool snapshot_load(master *const m, const char *const path)
{
    uint32_t at = 0, snapshot_bytes = 0;
    uint8_t answer = 0;
    size_t bytes = 0;
    uint8_t *const content = (uint8_t *)file_content(path, &bytes);
    if (content == NULL) {
        return fail(m, path, strerror(errno));
    }
    bool good = master_pause(m) && master_take(m, &answer, &at, &snapshot_bytes);
    if (good && bytes != snapshot_bytes) {
        good = fail(
            m, path,
            reason(bytes < 4 || memcmp(content, "ISOS", 4) != 0 ? ISO_SNAPSHOT_NO_SNAPSHOT : ISO_SNAPSHOT_WRONG_SIZE));
    }
    good = good && master_write(m, at, content, snapshot_bytes) && master_restore(m, snapshot_bytes, &answer);
    if (good && answer != ISO_CONTROL_DONE) {
        good = fail(m, path, reason(answer));
    }
    free(content);
    return good;
}
