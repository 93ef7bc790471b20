#include "core/xcp/access.h"

const uint8_t *iso_xcp_at(const iso_xcp_access *const access, const uint32_t address, const uint32_t count)
{
    for (size_t i = 0; i < ISO_XCP_SPANS; i++) {
        const iso_xcp_span *const span = &access->readable[i];
        const uint32_t offset = address - iso_xcp_address(span->start);
        if (offset < span->bytes && count <= span->bytes - offset) {
            return (const uint8_t *)span->start + offset;
        }
    }
    return NULL;
}

/* The value of tunable i after a write of these bytes from byte `offset` of all tunables on. */
static real changed(const iso_xcp_access *const access, const uint32_t i, const uint32_t offset,
                    const uint8_t *const bytes, const uint32_t count)
{
    const uint32_t first = i * (uint32_t)sizeof(real);
    uint8_t x[sizeof(real)];
    memcpy(x, &access->tunables[i], sizeof x);
    for (uint32_t k = 0; k < sizeof x; k++) {
        if (first + k >= offset && first + k - offset < count) {
            x[k] = bytes[first + k - offset];
        }
    }
    real result;
    memcpy(&result, x, sizeof result);
    return result;
}

static bool is_allowed(const iso_xcp_access *const access, const uint32_t i, const real x)
{
    const iso_limits *const limits = access->limits == NULL ? NULL : &access->limits[i];
    return iso_beyond(x, ISO_REAL_MAX) == 0 && (limits == NULL || (x >= limits->least && x <= limits->most));
}

iso_xcp_error iso_xcp_write(const iso_xcp_access *const access, const uint32_t address, const uint8_t *const bytes,
                            const uint32_t count)
{
    const uint32_t offset = address - iso_xcp_address(access->tunables);
    const uint32_t room = access->tunable_count * (uint32_t)sizeof(real);
    if (offset >= room || count > room - offset) {
        const iso_control *const control = access->control;
        if (control != NULL && iso_control_write(control, address - iso_xcp_address(control->snapshot), bytes, count) ==
                                   ISO_CONTROL_DONE) {
            return ISO_XCP_NONE;
        }
        return iso_xcp_at(access, address, count) == NULL ? ISO_XCP_ACCESS_DENIED : ISO_XCP_WRITE_PROTECTED;
    }
    for (uint32_t i = offset / sizeof(real); i * sizeof(real) < offset + count; i++) {
        if (!is_allowed(access, i, changed(access, i, offset, bytes, count))) {
            return ISO_XCP_OUT_OF_RANGE;
        }
    }
    memcpy((uint8_t *)access->tunables + offset, bytes, count);
    return ISO_XCP_NONE;
}
