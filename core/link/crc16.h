/* CRC-16/IBM-3740: polynomial x^16 + x^12 + x^5 + 1, from 0xFFFF, the most significant bit first, nothing turned round.
 * Of "123456789" it is 0x29B1. It finds every burst of up to 16 bits and every odd number of wrong bits; other damage
 * gets through once in 65536 times. Source: G. Cook, Catalogue of parametrised CRC algorithms; ITU-T V.41 has the
 * polynomial.
 */
#ifndef ISO_CORE_LINK_CRC16_H
#define ISO_CORE_LINK_CRC16_H

#include <stddef.h>
#include <stdint.h>

#define ISO_CRC16_START UINT16_C(0xFFFF)

/* The CRC continued over bytes: a division by the polynomial, eight bits at once. Bits above the 16 have no meaning,
 * and are removed at the end. */
static inline uint16_t iso_crc16(const uint16_t start, const uint8_t *const bytes, const size_t count)
{
    uint32_t crc = start;
    for (size_t i = 0; i < count; i++) {
        uint32_t x = (crc >> 8 & 0xFF) ^ bytes[i];
        x ^= x >> 4;
        crc = crc << 8 ^ x << 12 ^ x << 5 ^ x;
    }
    return (uint16_t)(crc & 0xFFFF);
}

#endif
