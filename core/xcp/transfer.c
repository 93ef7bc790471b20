/* Memory, read and written by the master. */
#include "core/link/crc16.h"
#include "core/xcp/commands.h"

enum { CRC_16_CITT = 8 };

uint16_t iso_xcp_answer_mta(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    if (!iso_xcp_has_address(x->command + 3)) {
        return iso_xcp_reply(x->response, ISO_XCP_OUT_OF_RANGE);
    }
    s->mta = iso_xcp_long(x->command + 4);
    return 1;
}

uint16_t iso_xcp_continue(iso_xcp_slave *const s, uint8_t *const response)
{
    if (s->upload_left == 0) {
        return 0;
    }
    const uint8_t most = ISO_XCP_MAX_CTO - 1, count = s->upload_left < most ? s->upload_left : most;
    const uint8_t *const from = iso_xcp_at(&s->access, s->mta, count);
    if (from == NULL) {
        return 0;
    }
    response[0] = ISO_XCP_RES;
    memcpy(response + 1, from, count);
    s->mta += count;
    s->upload_left = (uint8_t)(s->upload_left - count);
    return (uint16_t)(1 + count);
}

/* The first of the packets that have the bytes from the MTA on. */
static uint16_t upload(iso_xcp_slave *const s, const uint8_t count, uint8_t *const response)
{
    if (count == 0) {
        return iso_xcp_reply(response, ISO_XCP_OUT_OF_RANGE);
    }
    if (iso_xcp_at(&s->access, s->mta, count) == NULL) {
        return iso_xcp_reply(response, ISO_XCP_ACCESS_DENIED);
    }
    s->upload_left = count;
    return iso_xcp_continue(s, response);
}

uint16_t iso_xcp_answer_upload(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    return upload(s, x->command[1], x->response);
}

uint16_t iso_xcp_answer_short_upload(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    if (!iso_xcp_has_address(x->command + 3) || x->command[1] > ISO_XCP_MAX_CTO - 1) {
        return iso_xcp_reply(x->response, ISO_XCP_OUT_OF_RANGE);
    }
    s->mta = iso_xcp_long(x->command + 4);
    return upload(s, x->command[1], x->response);
}

uint16_t iso_xcp_answer_checksum(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    const uint32_t count = iso_xcp_long(x->command + 4);
    if (count == 0 || count > ISO_XCP_CHECKSUM_BYTES) {
        (void)iso_xcp_reply(x->response, ISO_XCP_OUT_OF_RANGE);
        iso_xcp_put_word(x->response + 2, 0);
        iso_xcp_put_long(x->response + 4, ISO_XCP_CHECKSUM_BYTES);
        return 8;
    }
    const uint8_t *const from = iso_xcp_at(&s->access, s->mta, count);
    if (from == NULL) {
        return iso_xcp_reply(x->response, ISO_XCP_ACCESS_DENIED);
    }
    s->mta += count;
    x->response[1] = CRC_16_CITT;
    iso_xcp_put_word(x->response + 2, 0);
    iso_xcp_put_long(x->response + 4, iso_crc16(ISO_CRC16_START, from, count));
    return 8;
}

/* The next packet of a block: its bytes stand behind those that came before; the last one writes all. */
static uint16_t download(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    const uint8_t most = ISO_XCP_MAX_CTO - 2, count = s->download_left < most ? s->download_left : most;
    if (x->length < 2 + count) {
        s->download_left = 0;
        return iso_xcp_reply(x->response, ISO_XCP_CMD_SYNTAX);
    }
    memcpy(s->download + s->download_bytes - s->download_left, x->command + 2, count);
    s->download_left = (uint8_t)(s->download_left - count);
    if (s->download_left > 0) {
        return 0;
    }
    const iso_xcp_error error = iso_xcp_write(&s->access, s->mta, s->download, s->download_bytes);
    s->mta += error == ISO_XCP_NONE ? s->download_bytes : 0;
    return iso_xcp_reply(x->response, error);
}

uint16_t iso_xcp_answer_download(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    if (x->command[1] == 0) {
        return iso_xcp_reply(x->response, ISO_XCP_OUT_OF_RANGE);
    }
    s->download_bytes = s->download_left = x->command[1];
    return download(s, x);
}

uint16_t iso_xcp_answer_download_next(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    if (s->download_left == 0 || x->command[1] != s->download_left) {
        x->response[2] = s->download_left; /* the number that was expected */
        s->download_left = 0;
        return (uint16_t)(iso_xcp_reply(x->response, ISO_XCP_SEQUENCE) + 1);
    }
    return download(s, x);
}

uint16_t iso_xcp_answer_short_download(iso_xcp_slave *const s, const iso_xcp_exchange *const x)
{
    const uint8_t count = x->command[1];
    if (!iso_xcp_has_address(x->command + 3) || count == 0 || count > ISO_XCP_MAX_CTO - 8) {
        return iso_xcp_reply(x->response, ISO_XCP_OUT_OF_RANGE);
    }
    if (x->length < 8 + count) {
        return iso_xcp_reply(x->response, ISO_XCP_CMD_SYNTAX);
    }
    s->mta = iso_xcp_long(x->command + 4);
    const iso_xcp_error error = iso_xcp_write(&s->access, s->mta, x->command + 8, count);
    s->mta += error == ISO_XCP_NONE ? count : 0;
    return iso_xcp_reply(x->response, error);
}
