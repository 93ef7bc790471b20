/* A shaft that swings in its cogging, a chopper that feeds a winding at a constant speed, and wind: against closed
 * forms, the chopper also against its switchings, the wind against its recurrences in long double and the spectra of
 * Dryden. */
#include <float.h>
#include <math.h>

#include PLANT
#include "core/numbers/noise.h"
#include "core/runtime/tick.h"
#include "tests/host/report.h"

#ifdef ISO_REAL_DOUBLE
#define ULP DBL_EPSILON
#else
#define ULP ((double)FLT_EPSILON)
#endif

#define PI 3.14159265358979323846

enum { TICKS = 2000, FALLS_AT = 200, RISES_AT = 100, PERIODS = 10, SAMPLES = 400000 };

static const iso_plant *plant;
static const double h = 1e-3;

static double shown(const int output)
{
    return (double)plant->y[output];
}

/* --- cogging --- */

/* Of a pendulum with the amplitude a the period is 2 pi / w / M(1, cos(a / 2)), M the mean of Gauss. */
static double period_of(const double w, const double amplitude)
{
    double a = 1.0, b = cos(0.5 * amplitude);
    for (int i = 0; i < 8; i++) {
        const double mean = 0.5 * (a + b);
        b = sqrt(a * b);
        a = mean;
    }
    return 2.0 * PI / w / a;
}

/* The phase errs by (w h)^4 / 120, a crossing between two ticks by less than (w h)^2 / 8 of a tick; in float the
 * rounding of an angle adds up over the ticks. */
static void test_cogging(const double first, const double last, const int turns)
{
    const double w = sqrt(0.2 * 12.0 / 1e-3), exact = period_of(w, 12.0 * 2.0 * PI / 180.0);
    const double off = fabs((last - first) / turns / exact - 1.0), allowed = pow(w * h, 4.0) / 60.0 + TICKS * ULP;
    report_ok(turns > 10 && off <= allowed, "it swings with %.6g s: %.2g off, at most %.2g", exact, off, allowed);
}

/* --- the chopper --- */

static const double supply = 24.0, back = 12.0, inductance = 5e-3, drop = 0.7, period = 100e-6;

/* The current after a period that begins with it, on for a part of it; the mean, and that of the transistor. */
static double switched(const double from, const double on, double *const mean, double *const fed)
{
    const double up = (supply - back) / inductance, down = (back + drop) / inductance;
    const double top = from + up * on * period, falls = fmin((1.0 - on) * period, top / down);
    const double end = fmax(top - down * falls, 0.0);
    *fed = 0.5 * (from + top) * on;
    *mean = *fed + 0.5 * (top + end) * falls / period;
    return end;
}

/* The mean currents of a tick, from its switchings. */
static double switched_tick(double *const current, const double on, double *const fed)
{
    double sum = 0.0;
    *fed = 0.0;
    for (int i = 0; i < PERIODS; i++) {
        double mean, carried;
        *current = switched(*current, on, &mean, &carried);
        sum += mean / PERIODS;
        *fed += carried / PERIODS;
    }
    return sum;
}

/* In a tick the current rises or falls by 2.5 A, and its mean is that of the half; beyond that the switchings have
 * their ripple. Where it comes to zero the last 2 A take the time that the step allows: some ticks, which are left out.
 */
static void test_chopper(void)
{
    double current = 0.0, before = 0.0, worst = 0.0, least = 0.0, most = 0.0;
    for (int tick = 0; tick < 400; tick++) {
        const double on = tick < RISES_AT ? 0.3 : tick < FALLS_AT ? 0.9 : 0.0;
        double fed;
        const double mean = switched_tick(&current, on, &fed);
        (void)iso_plant_tick(plant, (uint64_t)tick);
        const double now = shown(PLANT_Y_CURRENT), half = 0.5 * (before + now);
        if (tick == RISES_AT - 2) { /* its row is the last with the duty from before */
            report_ok(fabs(now - mean) <= 1e-4 * mean, "discontinuous it is %.5g A, switched %.5g A", now, mean);
            report_ok(fabs(shown(PLANT_Y_DRAWN) - fed) <= 1e-4 * fed, "and draws %.5g A, switched %.5g A",
                      shown(PLANT_Y_DRAWN), fed);
            report_ok(fabs(shown(PLANT_Y_VOLTAGE) - back) <= 1e-4 * back, "at the voltage of the winding");
        }
        if (tick > RISES_AT && (current > 2.5 || tick > FALLS_AT + 90)) {
            worst = fmax(worst, fabs(half - mean));
        }
        least = fmin(least, now);
        most = fmax(most, now);
        before = now;
    }
    const double ripple = (supply - back) * 0.9 * period / inductance;
    report_ok(worst <= ripple, "its means are those of the switchings: %.2g A off, ripple %.2g A", worst, ripple);
    report_ok(most > 100.0 && least >= -most * ULP, "it does not reverse: %.2g A", least);
}

/* --- wind --- */

/* Of the noise of an effect: FNV-1a of its name, and beyond. */
static uint32_t seed_of(const char *name, const uint32_t seed)
{
    uint32_t hash = 2166136261U;
    for (; *name != '\0'; name++) {
        hash = (hash ^ (uint32_t)(unsigned char)*name) * 16777619U;
    }
    return hash + seed;
}

/* One axis: two lags in series, of which the first alone is that along the wind. */
typedef struct axis {
    long double x, left, now, second;
    uint32_t seed;
} axis;

static axis axis_of(const long double length, const uint32_t seed)
{
    const long double x = (long double)h * 100.0L / length;
    return (axis){x, expl(-x), 0.0L, 0.0L, seed};
}

static void blow(axis *const a, const uint64_t tick)
{
    const long double left = a->left, fresh = sqrtl(1.0L - left * left), e = (long double)iso_noise(tick, a->seed);
    a->second = left * (a->second + a->x * a->now) + (0.5L - left * left * (0.5L + a->x)) / fresh * e;
    a->now = left * a->now + fresh * e;
}

static long double across(const axis *const a)
{
    return sqrtl(1.5L) * a->now + (sqrtl(0.5L) - sqrtl(1.5L)) * a->second;
}

typedef struct wind {
    axis axes[3];
    long double sigma, sigma_up, other;
} wind;

static wind wind_of(void)
{
    const long double height = 12.0L, low = 0.177L + 0.000823L * height / 0.3048L;
    const long double length = height / powl(low, 1.2L), sigma_up = 0.8L;
    wind w = {.sigma = sigma_up / powl(low, 0.4L), .sigma_up = sigma_up};
    w.axes[0] = axis_of(length, seed_of("field", 1));
    w.axes[1] = axis_of(length, seed_of("field", 2));
    w.axes[2] = axis_of(height, seed_of("field", 3));
    return w;
}

static void blow_all(wind *const w, const uint64_t tick)
{
    const long double left = expl(-25.0L * (long double)h);
    for (int i = 0; i < 3; i++) {
        blow(&w->axes[i], tick);
    }
    w->other = left * w->other + sqrtl(1.0L - left * left) * (long double)iso_noise(tick, seed_of("other", 1));
}

/* What rounding has added in a tick is forgotten after L / V, at most 800 ticks. */
static void test_wind(void)
{
    wind w = wind_of();
    double worst = 0.0;
    iso_plant_start(plant);
    for (uint64_t tick = 0; tick < TICKS; tick++) {
        (void)iso_plant_tick(plant, tick);
        blow_all(&w, tick + 1);
        const long double forth = 8.0L + w.sigma * w.axes[0].now, side = w.sigma * across(&w.axes[1]);
        const long double c = sqrtl(0.75L), s = 0.5L;
        worst = fmax(worst, fabs(shown(PLANT_Y_WIND_X) - (double)(c * forth - s * side)));
        worst = fmax(worst, fabs(shown(PLANT_Y_WIND_Y) - (double)(s * forth + c * side)));
        worst = fmax(worst, fabs(shown(PLANT_Y_WIND_Z) - (double)(w.sigma_up * across(&w.axes[2]))));
        worst = fmax(worst, fabs(shown(PLANT_Y_OTHER) - (double)w.other));
    }
    const double allowed = 800.0 * ULP * 12.0;
    report_ok(worst <= allowed, "the wind has its own noise: %.2g m/s off, at most %.2g", worst, allowed);
}

/* exp(-|t|) of the first axis, of the others (1 - |t| / 2) of it; t in L / V. */
static double correlation(const int i, const double t)
{
    return exp(-fabs(t)) * (i == 0 ? 1.0 : 1.0 - 0.5 * fabs(t));
}

/* The mean of the products of a Gaussian process with itself over N samples deviates by sqrt(sum over all lags of r^2 +
 * r r / N), at most sqrt(2 sum r^2 / N): four of these are allowed, and what the steps leave out. */
static void test_spectrum(const int i)
{
    enum { LAGS = 3, LONGEST = 2048 };
    static double past[LONGEST];
    wind w = wind_of();
    const axis *const a = &w.axes[i];
    const int lag = (int)(1.0L / a->x + 0.5L);
    double sums[LAGS] = {0.0}, square = 0.0;
    for (uint64_t tick = 0; tick < SAMPLES; tick++) {
        blow_all(&w, tick);
        const double now = (double)(i == 0 ? a->now : across(a));
        past[tick % LONGEST] = now;
        for (int n = 0; n < LAGS; n++) {
            sums[n] += now * past[(tick + LONGEST - (uint64_t)(n * lag)) % LONGEST] / SAMPLES;
        }
    }
    for (int n = -20 * lag; n <= 20 * lag; n++) {
        const double r = correlation(i, (double)a->x * n);
        square += r * r;
    }
    const double allowed = 4.0 * sqrt(2.0 * square / SAMPLES) + (double)(a->x * a->x);
    double worst = 0.0;
    for (int n = 0; n < LAGS; n++) {
        worst = fmax(worst, fabs(sums[n] - correlation(i, (double)a->x * n * lag)));
    }
    report_ok(worst <= allowed, "axis %d has the correlation of Dryden: %.3f %.3f %.3f, %.3f off, at most %.3f", i + 1,
              sums[0], sums[1], sums[2], worst, allowed);
}

int main(void)
{
    plant = &iso_the_plant;
    iso_plant_start(plant);
    test_chopper();
    test_wind();
    double before = 2.0 * PI / 180.0, first = 0.0, last = 0.0;
    int turns = -1;
    iso_plant_start(plant);
    for (uint64_t tick = 0; tick < TICKS; tick++) {
        (void)iso_plant_tick(plant, tick);
        const double now = shown(PLANT_Y_ANGLE) - PI / 180.0;
        if (before < 0.0 && now >= 0.0) {
            last = ((double)tick + before / (before - now)) * h;
            first = turns < 0 ? last : first;
            turns++;
        }
        before = now;
    }
    test_cogging(first, last, turns);
    for (int i = 0; i < 3; i++) {
        test_spectrum(i);
    }
    return report_done();
}
