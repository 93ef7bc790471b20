/* The microcontroller as a platform: Timer 1 is the tick and the clock, USART 0 the console, the EEPROM has how long to
 * run.
 *
 * The clock counts cycles. The timer overflows after 2^16 of them, and a tick is a whole number of overflows, so that
 * the same ones fall into each step. One stands for 15.625 us of the plant: a millisecond has 2^22 cycles, in which a
 * step in software ends. On silicon at 20 MHz the time of the plant is stretched by 210.
 *
 * The console writes lines of hexadecimal digits: a simulator shows them, which shows no other bytes (run.sh).
 * Microchip (2020), ATmega164A/PA/324A/PA/644A/PA/1284/P, DS40002070B. */
#include "port/port.h"

#include "port/none/inputs.h"
#include "port/none/outputs.h"

#define BYTE(address) (*(volatile uint8_t *)(uintptr_t)(address))
#define WORD(address) (*(volatile uint16_t *)(uintptr_t)(address))

#define EECR BYTE(0x3F)
#define EEDR BYTE(0x40)
#define EEAR WORD(0x41)
#define SMCR BYTE(0x53)
#define TIFR1 BYTE(0x36)
#define TIMSK1 BYTE(0x6F)
#define TCCR1B BYTE(0x81)
#define TCNT1 WORD(0x84)
#define UCSR0A BYTE(0xC0)
#define UCSR0B BYTE(0xC1)
#define UBRR0 WORD(0xC4)
#define UDR0 BYTE(0xC6)

enum { READ = 1 << 0, OVERFLOW = 1 << 0, CLOCK_ON = 1 << 0, SLEEP_ON = 1 << 0, IS_EMPTY = 1 << 5, SEND_ON = 1 << 3 };
enum { TWICE = 1 << 1 }; /* the rate of the console */

#define OVERFLOW_NS UINT32_C(15625)
#define OVERFLOW_COUNTS UINT32_C(65536)

static struct {
    volatile uint32_t overflows;
    volatile uint32_t ticks; /* due: the low half */
    uint32_t parts;          /* overflows in a tick */
    uint32_t left;           /* of the present tick */
    uint64_t reported;       /* by iso_port_wait: the latest tick */
} board;

/* The vector of the overflow of Timer 1, by the name that the start-up of the C library gives it. */
void __vector_15(void);
__attribute__((signal, used)) void __vector_15(void)
{
    board.overflows++;
    if (--board.left == 0) {
        board.left = board.parts;
        board.ticks++;
    }
}

static void interrupts_off(void)
{
    __asm__ volatile("cli" ::: "memory");
}

static void interrupts_on(void)
{
    __asm__ volatile("sei" ::: "memory");
}

/* The period is rounded to multiples of 15.625 us. */
__attribute__((cold)) uint32_t iso_port_start(const uint32_t period_ns)
{
    const uint32_t parts = (period_ns + OVERFLOW_NS / 2) / OVERFLOW_NS;
    board.parts = parts > 0 ? parts : 1;
    board.left = board.parts;
    TCCR1B = CLOCK_ON;
    TCNT1 = 0;
    TIFR1 = OVERFLOW;
    TIMSK1 = OVERFLOW;
    SMCR = SLEEP_ON;
    interrupts_on();
    return board.parts * OVERFLOW_COUNTS;
}

/* Ticks that are due and that the last call of iso_port_wait did not report. A load takes several instructions:
 * interrupts are held off meanwhile. */
static uint32_t due(void)
{
    return board.ticks - (uint32_t)board.reported;
}

/* The instruction behind `sei` comes before any interrupt, so that a tick cannot slip in between the look and the
 * sleep. */
uint64_t iso_port_wait(void)
{
    interrupts_off();
    uint32_t ticks = due();
    while (ticks == 0) {
        __asm__ volatile("sei\n    sleep\n    cli" ::: "memory");
        ticks = due();
    }
    interrupts_on();
    board.reported += ticks;
    return board.reported;
}

/* An overflow that is pending came before the counter was read, if that is low. */
uint64_t iso_port_clock(void)
{
    interrupts_off();
    const uint16_t low = TCNT1;
    const uint32_t pending = (TIFR1 & OVERFLOW) != 0 && low < OVERFLOW_COUNTS / 2 ? 1 : 0;
    const uint32_t overflows = board.overflows;
    interrupts_on();
    return ((uint64_t)overflows + pending) * OVERFLOW_COUNTS + low;
}

static void put(const uint8_t byte)
{
    while ((UCSR0A & IS_EMPTY) == 0) {
    }
    UDR0 = byte;
}

static void put_digit(const uint8_t digit)
{
    put((uint8_t)(digit + (digit < 10 ? '0' : 'a' - 10)));
}

void iso_port_write(const void *const bytes, const size_t count)
{
    enum { LINE_BYTES = 32 };
    const uint8_t *const from = bytes;
    UCSR0A = TWICE;
    UBRR0 = 0;
    UCSR0B = SEND_ON;
    for (size_t i = 0; i < count; i++) {
        put_digit((uint8_t)(from[i] >> 4));
        put_digit((uint8_t)(from[i] & 0xF));
        if (i % LINE_BYTES == LINE_BYTES - 1 || i == count - 1) {
            put('\n');
        }
    }
}

/* Eight bytes of the EEPROM, the lowest first. */
__attribute__((cold)) uint64_t iso_port_duration(const int argc, char **const argv)
{
    (void)argc;
    (void)argv;
    uint64_t duration = 0;
    for (uint16_t address = sizeof duration; address-- > 0;) {
        EEAR = address;
        EECR = READ;
        duration = duration << 8 | EEDR;
    }
    return duration;
}

/* The last line has the status. A simulator ends where the processor sleeps without interrupts. */
_Noreturn void iso_port_exit(const int status)
{
    put('!');
    put_digit((uint8_t)status);
    put('\n');
    interrupts_off();
    for (;;) {
        __asm__ volatile("sleep");
    }
}
