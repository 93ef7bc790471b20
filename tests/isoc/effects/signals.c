/* The effects of signals and circuits, tick by tick against the same equations in long double: rk4 for what has a
 * state, recurrences for what has a memory, formulas for the rest. What differs is rounding alone. Besides, what an
 * integration by the same method could not tell: steady states, the curve of a cell, the moments of the gusts. */
#include <float.h>
#include <math.h>
#include <string.h>

#include PLANT
#include "core/numbers/noise.h"
#include "core/runtime/tick.h"
#include "tests/host/report.h"

#ifdef ISO_REAL_DOUBLE
#define ULP ((long double)DBL_EPSILON)
#else
#define ULP ((long double)FLT_EPSILON)
#endif
/* Of what isoc chose the program has nine digits. */
#define DIGITS 1e-8L

enum { TICKS = 2000, FAULT_AT = 1000, GUSTS = 40000 };
enum { FILTER, SLOW, CHARGE, CURRENT, OVER, STATES };

static const long double h = 1e-3L, lag = (long double)SLOW_LAG, gain = (long double)FUSE_GAIN;

static long double clamp(const long double x, const long double least, const long double most)
{
    return fminl(fmaxl(x, least), most);
}

static long double warmth(const long double over)
{
    return 1.0L + 0.00393L * (313.15L + over - 293.15L);
}

static void slope(const long double y[STATES], const long double u, const long double amps, long double d[STATES])
{
    const long double i = y[CURRENT], drop = 2.0L * warmth(y[OVER]) * i;
    const long double supply = 24.0L - gain * (i - clamp(i, -3.0L, 3.0L));
    d[FILTER] = (u - y[FILTER]) / 20e-3L;
    d[SLOW] = clamp((u - y[SLOW]) / lag, -20.0L, 50.0L);
    d[CHARGE] = -amps / 1.0L;
    d[CURRENT] = (supply - drop) / 20e-3L;
    d[OVER] = (drop * i - y[OVER] / 5.0L) / 0.1L;
}

/* A step of rk4 (Kutta 1901). */
static void make_step(long double y[STATES], const long double u, const long double amps)
{
    static const long double at[] = {0.0L, 0.5L, 0.5L, 1.0L}, weight[] = {1.0L, 2.0L, 2.0L, 1.0L};
    long double k[STATES] = {0}, sum[STATES] = {0};
    for (int stage = 0; stage < 4; stage++) {
        long double now[STATES];
        for (int i = 0; i < STATES; i++) {
            now[i] = y[i] + h * at[stage] * k[i];
        }
        slope(now, u, amps, k);
        for (int i = 0; i < STATES; i++) {
            sum[i] += weight[stage] / 6.0L * k[i];
        }
    }
    for (int i = 0; i < STATES; i++) {
        y[i] += h * sum[i];
    }
}

/* The voltage of a cell at rest, Chen and Rincon-Mora (2006), eq. 2. */
static long double cell(const long double s)
{
    return -1.031L * expl(-35.0L * s) + 3.685L + 0.2156L * s - 0.1178L * s * s + 0.3201L * s * s * s;
}

/* The largest deviation from what is expected, over what rounding allows. */
static long double worst[PLANT_OUTPUTS];
static const iso_plant *plant;

static void expect(const int output, const long double expected, const long double allowed)
{
    const long double off = fabsl((long double)plant->y[output] - expected) / allowed;
    worst[output] = off > worst[output] || isnan(off) ? off : worst[output];
}

/* A code is the nearest one, to the rounding of what it is of. */
static void expect_code(const int output, const long double of, const long double levels)
{
    expect(output, clamp(of, 0.0L, levels - 1.0L), 0.5L + 8.0L * ULP * levels);
    const long double code = (long double)plant->y[output];
    worst[output] = code != floorl(code) ? HUGE_VALL : worst[output];
}

static void expect_states(const long double y[STATES], const long double amps)
{
    /* A rounding of each step lasts as long as the time constant, of the charge for ever. */
    expect(PLANT_Y_FILTER, y[FILTER], 4.0L * 20.0L * ULP * 3.0L);
    expect(PLANT_Y_SLOW, y[SLOW], TICKS * ULP * 3.0L + DIGITS);
    expect(PLANT_Y_CHARGE, y[CHARGE], TICKS * ULP);
    expect(PLANT_Y_LIMITED_CURRENT, y[CURRENT], 4.0L * 10.0L * ULP * 24.0L + DIGITS);
    expect(PLANT_Y_TEMPERATURE, 313.15L + y[OVER], 500.0L * ULP * (313.15L + y[OVER]));
    const long double i = (long double)plant->y[PLANT_Y_LIMITED_CURRENT],
                      t = (long double)plant->y[PLANT_Y_TEMPERATURE];
    expect(PLANT_Y_HEAT, 2.0L * (1.0L + 0.00393L * (t - 293.15L)) * i * i, 16.0L * ULP * 30.0L);
    /* Of the charge of a tick before, which differs by CHANGE. */
    expect(PLANT_Y_REST, 3.0L * cell((long double)plant->y[PLANT_Y_CHARGE]) - 0.1L * amps, 3.0L * 0.02L);
}

static void expect_formulas(const long double u, const long double amps)
{
    const long double one = 8.0L * ULP * 3.0L;
    expect(PLANT_Y_LIMITED, clamp(u, -1.0L, 2.0L), one);
    expect(PLANT_Y_BAND, u - clamp(u, -0.5L, 0.5L), one);
    expect_code(PLANT_Y_CODE, (u + 3e-3L + 2.0L) / (4.5L / 1024.0L), 1024.0L);
    expect(PLANT_Y_CONVERTED, -2.0L + 4.5L / 1024.0L * (long double)plant->y[PLANT_Y_CODE], one);
    expect_code(PLANT_Y_SENSED_CODE, (0.11L * amps + 2e-3L + 0.25L) / (0.5L / 256.0L), 256.0L);
    expect(PLANT_Y_SENSED, (0.5L / 256.0L * (long double)plant->y[PLANT_Y_SENSED_CODE] - 0.25L) / 0.1L, one);
    const long double duty = clamp(u / 2.0L, -1.0L, 1.0L);
    expect(PLANT_Y_BRIDGE, duty * 24.0L - 1.4L * amps / sqrtl(amps * amps + 1e-4L) - 0.2L * amps, 8.0L * one);
    expect(PLANT_Y_DRAWN, duty * amps, one);
}

/* Before the fault the signal itself, from it on what the fault makes of it. */
static void expect_faults(const long double u, const long double noise, const uint32_t tick,
                          const long double *const past)
{
    const bool on = tick >= FAULT_AT;
    const long double one = 8.0L * ULP * 7.0L;
    expect(PLANT_Y_STUCK, on ? past[FAULT_AT - 1] : u, one);
    expect(PLANT_Y_DROPPED, on ? 7.0L : u, one);
    expect(PLANT_Y_SHIFTED, on ? u + 0.3L : u, one);
    expect(PLANT_Y_SCALED, on ? u * 1.5L : u, one);
    expect(PLANT_Y_NOISY, on ? u + 0.1L * noise : u, one);
    expect(PLANT_Y_DELAYED, on ? past[tick - 4] : u, one);
    expect(PLANT_Y_WEAK, on ? u / 4.0L : u, one);
    expect(PLANT_Y_DEAD, on ? 0.0L : u, one);
}

static void run(void)
{
    static long double past[TICKS];
    long double y[STATES] = {[CHARGE] = 1.0L}, walked = 0.0L, gust = 0.0L;
    const long double left = expl(-250.0L / 10.0L * h);
    iso_plant_start(plant);
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        if (tick == FAULT_AT) {
            for (int i = PLANT_P_ONE_ACTIVE; i <= PLANT_P_EIGHT_ACTIVE; i++) {
                plant->p[i] = R(1.0);
            }
        }
        /* A wave and steps, beyond all limits. */
        plant->u[PLANT_U_VOLTS] = (real)(2.0 * sin(0.011 * tick) + (tick / 333 % 2 == 0 ? 1.0 : -1.0));
        plant->u[PLANT_U_AMPS] = (real)(0.35 + 2.6 * sin(0.04 * tick));
        const long double u = (long double)plant->u[PLANT_U_VOLTS], amps = (long double)plant->u[PLANT_U_AMPS];
        const long double noise_1 = (long double)iso_noise(tick + 1, 1), noise_2 = (long double)iso_noise(tick + 1, 2);
        (void)iso_plant_tick(plant, tick);
        past[tick] = u;
        make_step(y, u, amps);
        gust = left * gust + 2.0L * sqrtl(1.0L - left * left) * noise_1;
        expect_states(y, amps);
        expect_formulas(u, amps);
        expect_faults(u, noise_2, tick, past);
        expect(PLANT_Y_PROBE, 1.02L * u + 0.1L + walked + 0.2L * noise_1, (TICKS + 8.0L) * ULP * 4.0L);
        walked += 0.5L * sqrtl(h) * noise_2;
        expect(PLANT_Y_WIND, 3.0L + gust, 2.0L * 40.0L * ULP * 10.0L);
    }
    for (int i = 0; i < PLANT_OUTPUTS; i++) {
        report_ok(worst[i] <= 1.0L, "%s is as expected: %.2Lg of what is allowed", plant_outputs[i].name, worst[i]);
    }
    const long double t = (long double)plant->y[PLANT_Y_TEMPERATURE], hot = 2.0L * (1.0L + 0.00393L * (t - 293.15L));
    const long double steady = (24.0L + gain * 3.0L) / (hot + gain), i = (long double)plant->y[PLANT_Y_LIMITED_CURRENT];
    report_ok(fabsl(i - steady) <= 1e-4L * steady, "the limit holds the current at %.5Lg A: %.5Lg", i, steady);
}

/* Mean, variance and correlation of the gusts over many time constants of 40 ticks: of a Gaussian process with the
 * correlation a^n, the means of N samples deviate by sigma sqrt((1 + a) / (1 - a) / N), its second moments by sigma^2
 * sqrt(2 (1 + a^2) / (1 - a^2) / N). Four of these are allowed. */
static void run_gusts(void)
{
    const double a = exp(-1.0 / 40.0), sigma = 2.0;
    double mean = 0.0, square = 0.0, later = 0.0;
    static double past[40];
    iso_plant_start(plant);
    for (uint32_t tick = 0; tick < GUSTS; tick++) {
        (void)iso_plant_tick(plant, tick);
        const double gust = (double)plant->y[PLANT_Y_WIND] - 3.0;
        mean += gust / GUSTS;
        square += gust * gust / GUSTS;
        later += gust * past[tick % 40] / GUSTS;
        past[tick % 40] = gust;
    }
    const double few = 4.0 * sigma * sqrt((1.0 + a) / (1.0 - a) / GUSTS);
    const double more = 4.0 * sigma * sigma * sqrt(2.0 * (1.0 + a * a) / (1.0 - a * a) / GUSTS);
    report_ok(fabs(mean) <= few, "the mean of the gusts: %.2g of at most %.2g m/s", mean, few);
    report_ok(fabs(square - sigma * sigma) <= more, "their variance: %.3g, not %.3g, by at most %.2g", square,
              sigma * sigma, more);
    report_ok(fabs(later - sigma * sigma * exp(-1.0)) <= more, "after L / V a part of 1/e is left: %.3g of %.3g", later,
              square);
}

int main(void)
{
    plant = &iso_the_plant;
    run();
    run_gusts();
    return report_done();
}
