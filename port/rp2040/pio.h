/* The programmable pins: state machines, and what writes to them. RP2040 Datasheet: 2.5 DMA, 3 PIO. */
#ifndef ISO_PORT_RP2040_PIO_H
#define ISO_PORT_RP2040_PIO_H

#include "port/rp2040/registers.h"

#define PIO0 ((registers)0x50200000U) /* reads quadratures */
#define PIO1 ((registers)0x50300000U) /* plays edges */
enum { PIO_CONTROL = 0, PIO_FULL = 4 / 4, PIO_TX = 0x10 / 4, PIO_RX = 0x20 / 4, PIO_PROGRAM = 0x48 / 4 };
enum { PIO_RX_EMPTY = 1 << 8, PIO_MACHINES = 4 };
/* The registers of a state machine, one behind the other. */
enum { PIO_MACHINE = 0xC8 / 4, PIO_STRIDE = 6, PIO_DIVIDER = 0, PIO_WRAP, PIO_SHIFT, PIO_PLACE, PIO_DO, PIO_PINS };
enum { PIO_DIVIDER_AT = 16, WRAP_BOTTOM_AT = 7, WRAP_TOP_AT = 12, SHIFT_AUTOPULL = 1 << 17, SHIFT_OUT_RIGHT = 1 << 19 };
enum { PINS_OUT_AT = 0, PINS_SET_AT = 5, PINS_IN_AT = 15, PINS_OUT_COUNT_AT = 20, PINS_SET_COUNT_AT = 26 };

/* Counts a quadrature. X has the count, Y the levels before; both levels before and now are the place of a jump.
 *
 *      0   a jump for each of 16 pairs: to sample, up or down; where both pins changed, to sample
 *     16   up: x = ~x; x--; x = ~x
 *     19   sample: isr = x; push; in y, 2; in pins, 2; y = isr; pc = isr
 *     25   down: x--; wraps to sample
 *
 * With a divider of 8 a round takes 11 * 64 ns at most: two edges must be as far apart. */
enum { DECODER_SAMPLE = 19, DECODER_UP = 16, DECODER_DOWN = 25, DECODER_DIVIDER = 8 };
static const uint16_t decoder_program[] = {
    DECODER_SAMPLE, DECODER_UP,     DECODER_DOWN,   DECODER_SAMPLE, /* from 00 to 00, A, B, both */
    DECODER_DOWN,   DECODER_SAMPLE, DECODER_SAMPLE, DECODER_UP,     /* from A */
    DECODER_UP,     DECODER_SAMPLE, DECODER_SAMPLE, DECODER_DOWN,   /* from B */
    DECODER_SAMPLE, DECODER_DOWN,   DECODER_UP,     DECODER_SAMPLE, /* from both */
    0xA029,         0x0052,         0xA029,         0xA0C1,         0x8000, 0x4042, 0x4002, 0xA046, 0xA0A6, 0x0053};
enum { DO_Y_IS_PINS = 0xA040, DO_X_IS_0 = 0xE020, DO_OUTPUTS = 0xE080 };

/* Plays edges: each word has a delay in its lower 29 bits, and the levels after it in the upper 3.
 *
 *      0   out x, 29
 *      1   jmp x-- 1
 *      2   out pins, 3; wraps */
static const uint16_t player_program[] = {0x603D, 0x0041, 0x6003};
enum { PLAYER_LEVELS_AT = 29 };

/* Channels of the DMA, one for each player. */
#define DMA ((registers)0x50000000U)
enum { DMA_STRIDE = 0x40 / 4, DMA_READ = 0, DMA_WRITE, DMA_COUNT, DMA_CONTROL };
enum {
    DMA_ON = 1 << 0,
    DMA_WORDS = 2 << 2,
    DMA_READS_ON = 1 << 4,
    DMA_CHAIN_AT = 11,
    DMA_PACE_AT = 15,
    DMA_QUIET = 1 << 21
};
enum { DMA_BUSY = 1 << 24, DMA_PACE_PIO1_TX = 8 };

static inline void pio_load(const registers pio, const uint32_t unit, const uint16_t *const program, const size_t count)
{
    units_start(unit);
    for (size_t i = 0; i < count; i++) {
        pio[PIO_PROGRAM + i] = program[i];
    }
}

static inline registers pio_machine(const registers pio, const unsigned machine)
{
    return &pio[PIO_MACHINE + PIO_STRIDE * machine];
}

#endif
