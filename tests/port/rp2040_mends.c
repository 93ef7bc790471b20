/* What the chip does, and the emulator's package does not: sleep and interrupts, the period of SysTick, alarms. Prints
 * a number for each. Armv6-M Architecture Reference Manual, DDI 0419E: B1.5.19 wait for interrupt, B3.3 SysTick. RP2040
 * Datasheet: 4.6 timer. */
#include "port/mps2/interrupts.h"
#include "port/pins/pins.h"
#include "port/port.h"
#include "port/rp2040/registers.h"
#include "port/rp2040/start.h"

#define TIMER ((registers)0x40054000U)
enum { TIMER_ALARM = 0x10 / 4, TIMER_NOW = 0x28 / 4, TIMER_PENDING = 0x34 / 4, TIMER_ENABLED = 0x38 / 4 };
enum { TICKS = 300, TICK_CYCLES = 1250, ALARMS = 50 };

static volatile uint32_t handled, early, target, ticks, first, last;

/* No pin is used. */
const char *pins_start(void)
{
    return NULL;
}

void tick_interrupt(void)
{
    const uint32_t now = TIMER[TIMER_NOW];
    first = ticks == 0 ? now : first;
    last = now;
    ticks++;
}

static void alarm_interrupt(void)
{
    early += TIMER[TIMER_NOW] < target;
    handled++;
    TIMER[TIMER_PENDING] = 1;
}

static void say(const char *const name, uint32_t number)
{
    char digits[12] = "";
    unsigned at = sizeof digits - 1;
    for (digits[--at] = '\n'; number > 0 || digits[at] == '\n'; number /= 10) {
        digits[--at] = (char)('0' + number % 10);
    }
    size_t length = 0;
    while (name[length] != 0) {
        length++;
    }
    iso_port_write(name, length);
    iso_port_write(&digits[at], sizeof digits - 1 - at);
}

static void alarm_in(const uint32_t us)
{
    target = TIMER[TIMER_NOW] + us;
    TIMER[TIMER_ALARM] = target;
}

int main(int argc, char **argv)
{
    (void)iso_port_duration(argc, argv);
    the_handlers[EXCEPTIONS] = alarm_interrupt;
    TIMER[TIMER_ENABLED] = 1;
    interrupts_let(0);

    /* Held off, an interrupt ends a sleep, and is taken when it may. */
    interrupts_off();
    alarm_in(20);
    __asm__ volatile("wfi" ::: "memory");
    say("held_off ", handled == 0);
    interrupts_on();

    /* One that is pending already ends it at once. */
    interrupts_off();
    handled = 0;
    alarm_in(20);
    while ((TIMER[TIMER_PENDING] & 1) == 0) {
    }
    __asm__ volatile("wfi" ::: "memory");
    say("still_held ", handled == 0);
    interrupts_on();

    for (unsigned i = 0; i < ALARMS; i++) {
        handled = 0;
        alarm_in(5);
        while (handled == 0) {
        }
        for (volatile unsigned wait = 0; wait < i; wait++) {
        }
    }
    say("alarms_early ", early);

    SYSTICK[SYSTICK_RVR] = TICK_CYCLES - 1;
    SYSTICK[SYSTICK_CVR] = 0;
    SYSTICK[SYSTICK_CSR] = SYSTICK_RUN;
    while (ticks <= TICKS) {
        __asm__ volatile("wfi" ::: "memory");
    }
    say("systick_us ", last - first);
    iso_port_write("end\n", 4);
    iso_port_exit(0);
}
