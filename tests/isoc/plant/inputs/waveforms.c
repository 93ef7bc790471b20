/* Test signals tick by tick against the same in other words: edges in whole ticks, a shift register, phases in long
 * double, lines between the points that the file has. */
#include <float.h>
#include <math.h>
#include <string.h>

#include PLANT
#include "core/runtime/tick.h"
#include "tests/host/report.h"

#ifdef ISO_REAL_DOUBLE
#define ULP ((long double)DBL_EPSILON)
#else
#define ULP ((long double)FLT_EPSILON)
#endif

enum { TICKS = 5000 };

/* The largest deviation from what is expected, over what rounding allows. */
static long double worst[PLANT_OUTPUTS];
static const iso_plant *plant;

static void expect(const int output, const long double expected, const long double allowed)
{
    const long double off = fabsl((long double)plant->y[output] - expected);
    const long double part = allowed > 0.0L ? off / allowed : off > 0.0L ? INFINITY : 0.0L;
    worst[output] = part > worst[output] || isnan(part) ? part : worst[output];
}

/* Fibonacci's form, one bit after the other. */
typedef struct shift_register {
    unsigned order, other, state;
} shift_register;

static unsigned shift(shift_register *const r)
{
    const unsigned out = r->state >> (r->order - 1) & 1, back = out ^ (r->state >> (r->other - 1) & 1);
    r->state = (r->state << 1 | back) & ((1U << r->order) - 1);
    return out;
}

static long double half_of(const long double turns)
{
    return turns - floorl(turns) < 0.5L ? 1.0L : -1.0L;
}

/* A phase has a rounding of the growth in a tick, and the angle and its sine one each. */
static void expect_chirp(const int output, const long double from, const long double to, const uint64_t ticks,
                         const uint64_t tick)
{
    const long double h = 1e-3L, n = tick < ticks ? tick : ticks;
    const long double turns = n * h * from + 0.5L * n * n / ticks * h * (to - from) + (tick - n) * h * to;
    const long double pi = 3.14159265358979323846264338L;
    const long double allowed = 4.0L * ULP + 2.0L * pi * tick * 4.0L * (long double)DBL_EPSILON * 0.5L;
    expect(output, sinl(2.0L * pi * (turns - floorl(turns))), allowed);
}

static const long double times[] = {0.01L, 0.0105L, 0.0107L, 0.05L, 0.25L, 1.5L};
static const long double columns[2][6] = {{1.5L, 2.5L, 0.5L, -4.0L, 6.0L, 7.25L},
                                          {-30.0L, 4.0L, 8.0L, 0.125L, 1.0L, -2.0L}};

static void expect_line(const int output, const long double *const of, const long double factor, const uint64_t tick)
{
    const long double t = 1e-3L * tick;
    int i = 0;
    while (i < 5 && times[i + 1] <= t + 1e-9L) {
        i++;
    }
    const long double part = fmaxl(0.0L, i < 5 ? (t - times[i]) / (times[i + 1] - times[i]) : 0.0L);
    const long double next = of[i < 5 ? i + 1 : i], is = of[i] + part * (next - of[i]);
    const bool is_point = fabsl(t - times[i]) < 1e-9L || t < times[0] || i == 5;
    expect(output, factor * is, is_point ? 0.0L : 4.0L * ULP * factor * (fabsl(of[i]) + fabsl(next)));
}

static void expect_edges(const uint64_t tick)
{
    expect(PLANT_Y_ON, tick >= 300 ? 1.0L : 0.0L, 0.0L);
    expect(PLANT_Y_LATE, tick >= 301 ? 1.0L : 0.0L, 0.0L);
    expect(PLANT_Y_WHOLE, tick % 50 < 25 ? 1.0L : -1.0L, 0.0L);
    expect(PLANT_Y_SHIFTED, (4 * tick + 25) % 100 < 50 ? 1.0L : -1.0L, 0.0L);
    expect(PLANT_Y_ODD, half_of(0.007L * tick + 1e-12L), 0.0L);
}

static int ups[2], same[2];

static void expect_bits(const uint64_t tick)
{
    static shift_register eleven, seven;
    static unsigned held, first[2][TICKS];
    if (tick == 0) {
        eleven = (shift_register){11, 9, 7};
        seven = (shift_register){7, 6, 5};
        memset(ups, 0, sizeof ups);
        memset(same, 0, sizeof same);
    }
    const unsigned bit = shift(&eleven);
    held = tick % 3 == 0 ? shift(&seven) : held;
    expect(PLANT_Y_BITS, bit == 1 ? 1.0L : -1.0L, 0.0L);
    expect(PLANT_Y_HELD, held == 1 ? 1.0L : -1.0L, 0.0L);
    const uint32_t period[] = {2047, 127 * 3};
    const real now[] = {plant->y[PLANT_Y_BITS], plant->y[PLANT_Y_HELD]};
    for (int k = 0; k < 2; k++) {
        first[k][tick] = now[k] > R(0.0);
        ups[k] += tick < period[k] && now[k] > R(0.0);
        same[k] += tick >= period[k] && first[k][tick] == first[k][tick - period[k]];
    }
}

/* What stood in a row some rows before; before the first one what that has, or a start. */
static void expect_past(const uint64_t row)
{
    static real ramp[TICKS], wave[TICKS], turn[TICKS];
    ramp[row] = plant->y[PLANT_Y_RAMP];
    wave[row] = plant->y[PLANT_Y_WAVE];
    turn[row] = plant->y[PLANT_Y_TURN];
    const uint64_t of_7 = row / 7 * 7, of_20 = row / 20 * 20;
    expect(PLANT_Y_PAST, (long double)ramp[row >= 1 ? row - 1 : 0], 0.0L);
    expect(PLANT_Y_DELAYED, (long double)(row >= 5 ? ramp[row - 5] : R(7.0)), 0.0L);
    expect(PLANT_Y_TWICE, (long double)ramp[row >= 3 ? row - 3 : 0], 0.0L);
    expect(PLANT_Y_TAKEN, (long double)(of_7 > 0 ? ramp[of_7] : R(-1.0)), 0.0L);
    expect(PLANT_Y_STEPS, 1.0L + (long double)row, 0.0L);
    expect(PLANT_Y_HELD_WAVE, (long double)wave[of_7], 0.0L);
    expect(PLANT_Y_LONG_AGO, (long double)wave[row >= 300 ? row - 300 : 0], 0.0L);
    expect(PLANT_Y_TURNED, (long double)(row >= 1 ? turn[row - 1] : R(1.0)), 0.0L);
    expect(PLANT_Y_TURNED_BEFORE, (long double)turn[row >= 20 ? row - 20 : 0], 0.0L);
    expect(PLANT_Y_TURN_TAKEN, (long double)turn[of_20], 0.0L);
    expect(PLANT_Y_MOVED, (long double)(turn[row] - turn[row >= 1 ? row - 1 : 0]), 0.0L);
    expect(PLANT_Y_RAMP, (long double)row, 2.0L * ULP * row);
    expect(PLANT_Y_WAVE, sinl(6.28318530717958647693L * 0.003L * row), 4.0L * ULP + row * (long double)DBL_EPSILON);
    expect(PLANT_Y_TURN, 1.0L + 0.002L * row, row * ULP * 11.0L);
}

static void expect_row(const uint64_t tick)
{
    expect_edges(tick);
    expect_bits(tick);
    expect_past(tick);
    expect_chirp(PLANT_Y_RISE, 1.0L, 50.0L, 2000, tick);
    expect_chirp(PLANT_Y_FALL, 400.0L, 3.0L, 3000, tick);
    expect_line(PLANT_Y_LEFT, columns[0], 1.0L, tick);
    expect_line(PLANT_Y_RIGHT, columns[1], 0.5L, tick);
}

/* A tick of 64 bits is taken modulo periods of up to 24 bits. */
static bool counts_beyond(void)
{
    uint64_t tick = 1;
    bool good = true;
    for (int i = 0; i < 10000; i++) {
        tick = tick * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407); /* Knuth's MMIX */
        const uint32_t period = ((uint32_t)(tick >> 40) >> (i % 24)) | 1, few = 0x10000;
        good = good && iso_tick_modulo(tick, period) == tick % period && iso_tick_modulo(tick, few) == tick % few &&
               iso_tick_modulo(tick, few + 1) == tick % (few + 1);
    }
    return good;
}

int main(void)
{
    static unsigned char memory_of_first[sizeof(plant_memory)];
    plant = &iso_the_plant;
    for (int run = 0; run < 2; run++) {
        iso_plant_start(plant);
        (void)iso_plant_output(plant);
        expect_row(0);
        for (uint64_t tick = 0; tick < TICKS - 1; tick++) {
            (void)iso_plant_tick(plant, tick);
            expect_row(tick + 1);
        }
        if (run == 0) {
            memcpy(memory_of_first, plant->memory, sizeof memory_of_first);
        }
    }
    for (int i = 0; i < PLANT_OUTPUTS; i++) {
        report_ok(worst[i] <= 1.0L, "%s is as expected: %.2Lg of what is allowed", plant_outputs[i].name, worst[i]);
    }
    report_ok(ups[0] == 1024 && same[0] == TICKS - 2047, "2^11 - 1 bits, 1024 of them ones, and then the same again");
    report_ok(ups[1] == 3 * 64 && same[1] == TICKS - 3 * 127, "2^7 - 1 bits of 3 ticks, 64 of them ones, likewise");
    report_ok(memcmp(memory_of_first, plant->memory, sizeof memory_of_first) == 0,
              "a restart gives the same run again");
    report_ok(counts_beyond(), "periods of ticks beyond 2^32");
    return report_done();
}
