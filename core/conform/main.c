/* The program of `isochron conform`: tries the duties of a port (port/port.h, port/channel.h) on the target itself, and
 * writes a line for each. tools/conform reads them, and adds the duties that only show from outside. */
#include "core/conform/pattern.h"
#include "core/conform/report.h"
#include "core/numbers/self_check.h"
#include "core/runtime/plant.h"

extern const iso_plant iso_the_plant;

enum { PERIOD_NS = 10000000, LATE_SHIFT = 4, STILL = 1000 };

/* The findings on the ticks. */
typedef struct watch {
    uint64_t tick, clock; /* the last ones */
    uint64_t skipped;     /* ticks that no wait reported alone */
    uint64_t late, worst; /* ticks whose wait returned late; the latest, counts */
    uint64_t early;       /* readings of the clock before the tick that was due, or before the reading before, */
    uint64_t early_above; /* and of them those behind 2^32 counts */
} watch;

static void look(watch *const w, const uint32_t period)
{
    const uint64_t tick = iso_port_wait(), clock = iso_port_clock(), again = iso_port_clock();
    const uint64_t due = tick * period;
    const bool is_above = due > UINT32_MAX;
    const bool is_early = clock < due || clock < w->clock || again < clock;
    w->skipped += tick - w->tick - 1;
    w->early += is_early && !is_above;
    w->early_above += is_early && is_above;
    if (!is_early) {
        const uint64_t after = clock - due;
        w->worst = after > w->worst ? after : w->worst;
        w->late += after > period >> LATE_SHIFT;
    }
    w->tick = tick;
    w->clock = again;
}

/* Computes until so many periods have passed since a tick: then the wait reports the latest due tick at once, and the
 * bits of the numbers computed meanwhile are right. Where time is virtual, no tick comes while a program computes. */
static bool catch_up(watch *const w, const uint32_t period)
{
    enum { PERIODS = 2 };
    const uint64_t until = (w->tick + PERIODS) * period + period / 2;
    uint64_t clock = iso_port_clock(), last = 0;
    bool good = true;
    for (unsigned still = 0; clock < until && still < STILL; clock = iso_port_clock()) {
        still = clock == last ? still + 1 : 0;
        last = clock;
        good = good && iso_self_check();
    }
    if (clock < until) {
        conform_text("catching_up has none: time is virtual\n");
        return good;
    }
    const uint64_t tick = iso_port_wait();
    const bool is_at_once = tick == w->tick + PERIODS && iso_port_clock() < (tick + 1) * period;
    (void)conform_line("catching_up", is_at_once, tick - w->tick, " ticks reported at once after 2.5 periods");
    conform_text(good ? "interrupts ok: they keep the registers\n"
                      : "interrupts FAILED: they change bits of results\n");
    return good && is_at_once;
}

/* Ticks of 10 ms until the clock is beyond 2^32 counts. */
static bool try_time(void)
{
    const uint32_t period = iso_port_start(PERIOD_NS);
    watch w = {.clock = iso_port_clock()};
    bool good =
        conform_line("start", period > 0 && w.clock <= period >> LATE_SHIFT, w.clock, " counts behind the start");
    while (period > 0 && w.tick * period <= UINT32_MAX + 4 * (uint64_t)period) {
        look(&w, period);
    }
    good &= conform_line("clock", w.early == 0, w.early, " readings went back, or were before the tick that was due");
    good &= conform_line("wrap", w.early_above == 0, w.early_above, " of them behind 2^32 counts");
    good &= conform_line("tick", w.skipped == 0, w.skipped, " skipped");
    conform_begin("jitter", w.late == 0);
    conform_number(w.late);
    conform_text(" of ");
    conform_number(w.tick);
    conform_text(" ticks late, the latest by ");
    conform_number(w.worst);
    conform_text(" of ");
    conform_number(period);
    conform_text(" counts\n");
    good &= w.late == 0;
    if (period == 0 || w.early + w.early_above > 0) {
        conform_text("catching_up FAILED: no clock tells when it is done\n");
        return false;
    }
    return catch_up(&w, period) && good;
}

/* The platform writes its measured values into the inputs, and nowhere else. */
static bool try_inputs(void)
{
    enum { INPUTS = 3, GUARDS = 2 };
    real u[INPUTS + GUARDS];
    unsigned kept = 0, unread = 0;
    for (unsigned i = 0; i < INPUTS + GUARDS; i++) {
        u[i] = R(12345.0);
    }
    iso_port_read(u, INPUTS);
    for (unsigned i = 0; i < INPUTS + GUARDS; i++) {
        kept += i >= INPUTS && iso_bits_of(u[i]) == iso_bits_of(R(12345.0));
        unread += i < INPUTS && iso_bits_of(u[i]) == iso_bits_of(R(12345.0));
    }
    if (unread == INPUTS && kept == GUARDS) {
        conform_text("inputs has none\n");
        return true;
    }
    return conform_line("inputs", kept == GUARDS, INPUTS - unread, " measured; what stands behind them is kept or not");
}

/* Paint below the stack, and how much of it a call has overwritten. The painter and the looker have the same frame,
 * which stands where that of the call stood. */
enum { PAINT_BYTES = 2048, PAINT = 0xA5 };

__attribute__((noinline)) static void paint(uintptr_t *const bottom)
{
    volatile uint8_t area[PAINT_BYTES];
    for (unsigned i = 0; i < PAINT_BYTES; i++) {
        area[i] = PAINT;
    }
    *bottom = (uintptr_t)area;
}

__attribute__((noinline)) static uint32_t painted(const volatile uint8_t *const bottom)
{
    uint32_t left = 0;
    while (left < PAINT_BYTES && bottom[left] == PAINT) {
        left++;
    }
    return left;
}

/* A function that needs no stack; the compiler does not see which one is called. */
static void nothing(void *const memory)
{
    (void)memory;
}

static uint32_t deep(void (*const volatile step)(void *memory), void *const memory)
{
    uintptr_t bottom;
    paint(&bottom);
    step(memory);
    return painted((const volatile uint8_t *)bottom);
}

/* The reader compares it with the compiler's figure. */
static void measure_stack(void)
{
    const iso_plant *const plant = &iso_the_plant;
    iso_plant_start(plant);
    const uint32_t without = deep(nothing, plant->memory), with = deep(plant->model->step, plant->memory);
    conform_text("stack ");
    conform_number(without - with);
    conform_text("\n");
}

/* A block of bytes, in writes of 1 to 255 of them. */
static void write_block(void)
{
    uint8_t bytes[255];
    conform_text("console ");
    conform_number(CONFORM_CONSOLE_BYTES);
    conform_text("\n");
    uint32_t size = 1;
    for (uint32_t done = 0; done < CONFORM_CONSOLE_BYTES; size = size % sizeof bytes + 1) {
        const uint32_t left = CONFORM_CONSOLE_BYTES - done, count = size < left ? size : left;
        for (uint32_t i = 0; i < count; i++) {
            bytes[i] = conform_byte(done + i);
        }
        iso_port_write(bytes, count);
        done += count;
    }
}

int main(int argc, char **argv)
{
    const uint64_t duration = iso_port_duration(argc, argv);
    bool good = iso_self_check();
    conform_text(good ? "arithmetic ok: the bits of the self-check\n"
                      : "arithmetic FAILED: other bits than the self-check's\n");
    good &= conform_line("duration", duration == CONFORM_DURATION, duration, " ns");
    good &= try_inputs();
    measure_stack();
    good &= try_time();
    write_block();
    good &= conform_channel();
    conform_text(good ? "end 0\n" : "end 1\n");
    iso_port_exit(good ? 0 : 1);
}
