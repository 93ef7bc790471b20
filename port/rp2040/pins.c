/* The pins of the RP2040: the converter, PWM slices as counters and as pulses, levels, and quadratures by the PIO. What
 * is counted is latched by the interrupt of the tick. RP2040 Datasheet: 2.3.1.7 SIO, 4.5 PWM, 4.9 ADC. */
#include "port/rp2040/pins.h"

#include "port/pins/duty.h"
#include "port/pins/edges.h"
#include "port/pins/table.h"
#include "port/port.h"
#include "port/rp2040/pio.h"

#define SIO ((registers)0xD0000000U)
enum { SIO_IN = 0x04 / 4, SIO_OUT_SET = 0x14 / 4, SIO_OUT_CLEAR = 0x18 / 4, SIO_OUTPUT_SET = 0x24 / 4 };

#define ADC ((registers)0x4004C000U)
enum {
    ADC_CONTROL = 0,
    ADC_RESULT = 4 / 4,
    ADC_ON = 1 << 0,
    ADC_START = 1 << 2,
    ADC_READY = 1 << 8,
    ADC_CHANNEL_AT = 12
};
enum { ADC_FIRST_PIN = 26, ADC_MOST = 4095 };

/* A slice has a counter and two pins, A and B; B can gate it, or make it count. */
#define PWM ((registers)0x40050000U)
enum { PWM_STRIDE = 0x14 / 4, PWM_CONTROL = 0, PWM_DIVIDER, PWM_COUNT, PWM_LEVEL, PWM_TOP };
enum { PWM_ON = 1 << 0, PWM_GATED = 1 << 4, PWM_BY_EDGES = 2 << 4, PWM_DIVIDER_AT = 4, PWM_DIVIDER_MOST = 255 };
enum { PULSES_HZ = 20000, PULSES_CYCLES = SYSTEM_MHZ * 1000000 / PULSES_HZ };
enum { BOARD_PINS = 30, SLICES = 8 };

static struct {
    bool is_on;
    uint32_t levels;                         /* of all pins, at the last tick */
    uint32_t cycles;                         /* of the tick before until then */
    uint32_t at;                             /* when that tick was due, in cycles modulo 2^32 */
    uint32_t captures;                       /* the slices that count, a bit for each */
    uint32_t divider;                        /* of those that are gated */
    uint16_t now[SLICES], before[SLICES];    /* their counters at the last two ticks */
    uint32_t edges[SLICES];                  /* rising edges, of those that count them */
    uint32_t slots, margin;                  /* of a play, and before the first of them, cycles */
    uint32_t behind;                         /* its begin behind the tick, cycles */
    unsigned decoders, players;              /* state machines that are used */
    unsigned machine[BOARD_PINS];            /* of the row that begins at a pin */
    edges courses[PIO_MACHINES];             /* of the players */
    uint32_t words[PIO_MACHINES][EDGES_MAX]; /* that the DMA gives to each */
} pins;

static unsigned slice_of(const pins_row *const row)
{
    return row->pin / 2 % SLICES;
}

static registers pwm_of(const pins_row *const row)
{
    return &PWM[PWM_STRIDE * slice_of(row)];
}

static bool is_capture(const pins_row *const row, const bool is_output)
{
    return !is_output && (row->kind == PINS_DUTY || row->kind == PINS_EDGES);
}

const char *pins_lacks(const pins_row *const row, const bool is_output)
{
    const unsigned last = row->pin + pins_width(row, is_output) - 1;
    if (last >= BOARD_PINS || row->pin < 2 || (row->pin < 6 && last > 3)) {
        return "a row is on a pin that is not free: GPIO2, 3 and 6 to 29 are";
    }
    if (row->kind == PINS_VOLTAGE && (is_output || row->pin < ADC_FIRST_PIN)) {
        return "a voltage is measured on GPIO26 to GPIO29, and shown on no pin: pulses and a filter show one";
    }
    if (row->kind == PINS_EDGES && is_output) {
        return "edges are counted, and not shown: a quadrature shows a position";
    }
    if (is_capture(row, is_output) && row->pin % 2 == 0) {
        return "a duty or edges are measured on a pin with an odd number";
    }
    return NULL;
}

static bool is_on_slice(const pins_row *const row, const bool is_output)
{
    return row->kind == PINS_DUTY || is_capture(row, is_output);
}

const char *pins_clash(const pins_row *const a, const bool a_is_output, const pins_row *const b, const bool b_is_output)
{
    if (!is_on_slice(a, a_is_output) || !is_on_slice(b, b_is_output) || slice_of(a) != slice_of(b)) {
        return NULL;
    }
    return is_capture(a, a_is_output) || is_capture(b, b_is_output) || a->pin % 2 == b->pin % 2
               ? "two rows are on one PWM slice: a pin with its neighbour, or with the one 16 on; of pulses out, only "
                 "the "
                 "neighbour can be"
               : NULL;
}

static void open_capture(const pins_row *const row)
{
    const registers slice = pwm_of(row);
    pins.captures |= UINT32_C(1) << slice_of(row);
    slice[PWM_TOP] = UINT16_MAX;
    slice[PWM_DIVIDER] = 1 << PWM_DIVIDER_AT;
    slice[PWM_CONTROL] = PWM_ON | (row->kind == PINS_DUTY ? PWM_GATED : PWM_BY_EDGES);
    slice[PWM_COUNT] = 0;
    pin_use(row->pin, PAD_INPUT | PAD_PULL_DOWN | PAD_SCHMITT, FUNCTION_PWM);
}

static void open_pulses(const pins_row *const row)
{
    const registers slice = pwm_of(row);
    slice[PWM_TOP] = PULSES_CYCLES - 1;
    slice[PWM_DIVIDER] = 1 << PWM_DIVIDER_AT;
    slice[PWM_CONTROL] = PWM_ON;
    pin_use(row->pin, PAD_4_MA, FUNCTION_PWM);
}

/* The count begins at 0, with the levels that are there. */
static void open_decoder(const pins_row *const row)
{
    const unsigned machine = pins.decoders++;
    const registers m = pio_machine(PIO0, machine);
    if (machine == 0) {
        pio_load(PIO0, UNIT_PIO0, decoder_program, sizeof decoder_program / sizeof decoder_program[0]);
    }
    for (unsigned i = 0; i < 2; i++) {
        pin_use(row->pin + i, PAD_INPUT | PAD_PULL_DOWN | PAD_SCHMITT, FUNCTION_PIO0);
    }
    pins.machine[row->pin] = machine;
    m[PIO_DIVIDER] = DECODER_DIVIDER << PIO_DIVIDER_AT;
    m[PIO_WRAP] = DECODER_DOWN << WRAP_TOP_AT | DECODER_SAMPLE << WRAP_BOTTOM_AT;
    m[PIO_SHIFT] = SHIFT_OUT_RIGHT;
    m[PIO_PINS] = row->pin << PINS_IN_AT;
    m[PIO_DO] = DO_Y_IS_PINS;
    m[PIO_DO] = DO_X_IS_0;
    m[PIO_DO] = DECODER_SAMPLE;
    PIO0[SETS + PIO_CONTROL] = UINT32_C(1) << machine;
}

static void open_player(const pins_row *const row)
{
    const unsigned machine = pins.players++, width = pins_width(row, true);
    const registers m = pio_machine(PIO1, machine);
    if (machine == 0) {
        units_start(UNIT_DMA);
        pio_load(PIO1, UNIT_PIO1, player_program, sizeof player_program / sizeof player_program[0]);
    }
    pins.machine[row->pin] = machine;
    m[PIO_DIVIDER] = 1 << PIO_DIVIDER_AT;
    m[PIO_WRAP] = (sizeof player_program / sizeof player_program[0] - 1) << WRAP_TOP_AT;
    m[PIO_SHIFT] = SHIFT_AUTOPULL | SHIFT_OUT_RIGHT;
    m[PIO_PINS] =
        row->pin << PINS_OUT_AT | row->pin << PINS_SET_AT | width << PINS_OUT_COUNT_AT | width << PINS_SET_COUNT_AT;
    m[PIO_DO] = DO_OUTPUTS | ((UINT32_C(1) << width) - 1);
    m[PIO_DO] = 0;
    for (unsigned i = 0; i < width; i++) {
        pin_use(row->pin + i, PAD_4_MA, FUNCTION_PIO1);
    }
    PIO1[SETS + PIO_CONTROL] = UINT32_C(1) << machine;
}

const char *pins_open(const pins_row *const row, const size_t number, const bool is_output)
{
    if (!pins.is_on) {
        pins.is_on = true;
        units_start(UNIT_ADC | UNIT_PWM);
        ADC[ADC_CONTROL] = ADC_ON;
    }
    if (row->kind == PINS_QUADRATURE) {
        if ((is_output ? pins.players : pins.decoders) == PIO_MACHINES) {
            return "more than four quadratures in, or four out";
        }
        (is_output ? open_player : open_decoder)(row);
    } else if (is_capture(row, is_output)) {
        open_capture(row);
    } else if (row->kind == PINS_VOLTAGE) {
        pin_use(row->pin, PAD_NO_OUTPUT, FUNCTION_NONE);
    } else if (!is_output) {
        pin_use(row->pin, PAD_INPUT | PAD_PULL_DOWN | PAD_SCHMITT, FUNCTION_SIO);
    } else {
        pins_show(row, number, row->safe);
        if (row->kind == PINS_DUTY) {
            open_pulses(row);
        } else {
            SIO[SIO_OUTPUT_SET] = UINT32_C(1) << row->pin;
            pin_use(row->pin, PAD_4_MA, FUNCTION_SIO);
        }
    }
    return NULL;
}

const char *pins_begin(const uint32_t period_cycles)
{
    pins.divider = duty_divider(period_cycles);
    pins.slots = edges_slots(period_cycles);
    pins.margin = period_cycles / 16;
    for (unsigned i = 0; i < SLICES; i++) {
        const registers slice = &PWM[PWM_STRIDE * i];
        if ((pins.captures >> i & 1) != 0 && (slice[PWM_CONTROL] & PWM_GATED) != 0) {
            if (pins.divider > PWM_DIVIDER_MOST) {
                return "the step is too long for a duty: 66 ms at most";
            }
            slice[PWM_DIVIDER] = pins.divider << PWM_DIVIDER_AT;
            slice[PWM_COUNT] = 0;
        }
    }
    return NULL;
}

static bool has_count(const unsigned machine)
{
    return (PIO0[PIO_FULL] & (uint32_t)PIO_RX_EMPTY << machine) == 0;
}

/* The counts that wait in a FIFO are old ones: without them the first of the next four that it takes is new. */
void pins_latch(const uint32_t tick_cycles)
{
    pins.levels = SIO[SIO_IN];
    for (uint32_t left = pins.captures, i = 0; left != 0; left >>= 1, i++) {
        if ((left & 1) != 0) {
            pins.before[i] = pins.now[i];
            pins.now[i] = (uint16_t)PWM[PWM_STRIDE * i + PWM_COUNT];
            pins.edges[i] += (uint16_t)(pins.now[i] - pins.before[i]);
        }
    }
    for (unsigned machine = 0; machine < pins.decoders; machine++) {
        while (has_count(machine)) {
            (void)PIO0[PIO_RX + machine];
        }
    }
    pins.cycles = tick_cycles - pins.at;
    pins.at = tick_cycles;
}

/* A conversion takes 2 us. */
static bool measure_voltage(const pins_row *const row, real *const v)
{
    ADC[ADC_CONTROL] = ADC_ON | ADC_START | (row->pin - ADC_FIRST_PIN) << ADC_CHANNEL_AT;
    for (unsigned looks = 0; looks < 1000; looks++) {
        if ((ADC[ADC_CONTROL] & ADC_READY) != 0) {
            *v = (real)ADC[ADC_RESULT] / (real)ADC_MOST;
            return true;
        }
    }
    return false;
}

/* The first count that came since the latch. */
static bool measure_count(const pins_row *const row, real *const v)
{
    const unsigned machine = pins.machine[row->pin];
    for (unsigned looks = 0; looks < 100; looks++) {
        if (has_count(machine)) {
            *v = (real)(int32_t)PIO0[PIO_RX + machine];
            return true;
        }
    }
    return false;
}

bool pins_measure(const pins_row *const row, const size_t number, real *const v)
{
    (void)number;
    const unsigned slice = slice_of(row);
    switch (row->kind) {
    case PINS_VOLTAGE:
        return measure_voltage(row, v);
    case PINS_DUTY:
        return duty_part((uint16_t)(pins.now[slice] - pins.before[slice]), pins.divider, pins.cycles, v);
    case PINS_EDGES:
        *v = (real)pins.edges[slice];
        return true;
    case PINS_QUADRATURE:
        return measure_count(row, v);
    case PINS_LEVEL:
    default:
        *v = (real)(pins.levels >> row->pin & 1);
        return true;
    }
}

/* Edges come at a fixed time behind the tick: that at which the first tick had its outputs, and a sixteenth of a period
 * more. What is left of that time now, cycles. */
static uint32_t until_play(void)
{
    if (pins.cycles == 0) { /* before the first tick, and the clock */
        return 0;
    }
    const uint32_t late = (uint32_t)iso_port_clock() - pins.at;
    if (pins.behind == 0) {
        pins.behind = late + pins.margin;
    }
    return late < pins.behind ? pins.behind - late : 0;
}

/* Edges that the last tick could not end yet stay: those of this one come with the next. */
static void play(const pins_row *const row, const real v)
{
    const unsigned machine = pins.machine[row->pin];
    const registers channel = &DMA[DMA_STRIDE * machine];
    if ((channel[DMA_CONTROL] & DMA_BUSY) != 0) {
        return;
    }
    edge list[EDGES_MAX];
    const size_t count = edges_to(&pins.courses[machine], v, row->turn, pins.slots, list);
    for (size_t i = 0; i < count; i++) {
        const uint32_t before = i > 0 ? list[i - 1].slot : 0;
        pins.words[machine][i] = (list[i].slot - before - EDGES_APART) | list[i].levels << PLAYER_LEVELS_AT;
    }
    pins.words[machine][0] += until_play();
    if (count > 0) {
        __asm__ volatile("" ::: "memory"); /* the words are there before the channel reads them */
        channel[DMA_READ] = (uint32_t)(uintptr_t)pins.words[machine];
        channel[DMA_WRITE] = (uint32_t)(uintptr_t)&PIO1[PIO_TX + machine];
        channel[DMA_COUNT] = count;
        channel[DMA_CONTROL] = DMA_ON | DMA_WORDS | DMA_READS_ON | DMA_QUIET | machine << DMA_CHAIN_AT |
                               (DMA_PACE_PIO1_TX + machine) << DMA_PACE_AT;
    }
}

void pins_show(const pins_row *const row, const size_t number, const real v)
{
    (void)number;
    if (row->kind == PINS_QUADRATURE) {
        play(row, v);
    } else if (row->kind == PINS_DUTY) {
        const registers level = &pwm_of(row)[PWM_LEVEL];
        const uint32_t count = (uint32_t)(v * (real)PULSES_CYCLES + R(0.5)), shift = row->pin % 2 * 16;
        *level = (*level & ~(UINT32_C(0xFFFF) << shift)) | count << shift;
    } else {
        SIO[v < R(0.5) ? SIO_OUT_CLEAR : SIO_OUT_SET] = UINT32_C(1) << row->pin;
    }
}
