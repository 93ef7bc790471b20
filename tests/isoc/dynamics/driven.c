/* driven.scene against what its functions of time and the laws of motion say, at every step of a second: positions,
 * speeds, and the efforts that it takes. Linked with its plant, in the plant's real.
 *
 *     driven PLACE EFFORT   TAP: no position or speed is off by more than PLACE, and no effort by more than EFFORT
 *     driven NAME           the error of one output alone
 *     driven pulled         that of the spindle a while after it was turned by PULLED against its gear
 *
 * The effort of the crank is its power over its speed: what moves takes m (a - g) . v and I alpha omega, its damper d
 * v^2.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/runtime/plant.h"
#include "tests/host/report.h"
#include "tests/isoc/dynamics/jet.h"

#define PI 3.14159265358979323846264338327950288L
#define GRAVITY 10.0L
#define PULLED R(0.01) /* rad */

/* In the order of the scene's outputs; behind them its turns, which are counted with the angle, and its violation. */
enum {
    SLIDER,
    LIFT,
    SPEED,
    TABLE,
    ANGLE,
    SWING,
    MATE,
    TORQUE,
    PULL,
    DRIVE,
    TOOTH,
    TWIST,
    OUTPUTS,
    PLACES = TORQUE,
    TURNS = OUTPUTS
};

static const char *const names[OUTPUTS] = {
    "slider", "lift", "speed", "table", "angle", "swing", "mate", "torque", "pull", "drive", "tooth", "twist",
};

/* value, rate and second derivative as a jet */
static jet moving(const wide value, const wide rate, const wide second)
{
    return (jet){{value, rate, second / 2.0L}};
}

/* The 3-4-5 polynomial of cams from 0 to 1 between two times. */
static jet rise(const wide t, const wide from, const wide to)
{
    const wide length = to - from;
    const wide c = fminl(fmaxl((t - from) / length, 0.0L), 1.0L);
    return moving(c * c * c * (10.0L - 15.0L * c + 6.0L * c * c), 30.0L * c * c * (1.0L - c) * (1.0L - c) / length,
                  60.0L * c * (1.0L - c) * (1.0L - 2.0L * c) / (length * length));
}

/* What it takes to move a mass: m (a - g) . v. */
static wide mass_power(const wide mass, const jet x, const jet y)
{
    return mass * (2.0L * x.c[2] * x.c[1] + (2.0L * y.c[2] + GRAVITY) * y.c[1]);
}

static void crank(const wide t, wide y[OUTPUTS])
{
    const wide r = 0.3L, l = 0.5L, speed = 10.0L * PI;
    const jet theta = moving(PI / 2.0L + speed * t, speed, 0.0L);
    const jet across = jet_scale(r, jet_sin(theta));
    /* l sin phi = -r sin theta, and what follows of it by differentiation. */
    const wide phi = -asinl(across.c[0] / l), cosine = l * cosl(phi);
    const wide rate = -across.c[1] / cosine;
    const jet rod = moving(phi, rate, (l * sinl(phi) * rate * rate - 2.0L * across.c[2]) / cosine);
    const jet zero = jet_constant(0.0L);
    const jet slider = jet_add(jet_scale(r, jet_cos(theta)), jet_scale(l, jet_cos(rod)));
    const wide power =
        mass_power(1.0L, jet_scale(0.1L, jet_cos(theta)), jet_scale(0.1L, jet_sin(theta))) +
        mass_power(2.0L, slider, zero) +
        mass_power(0.5L, jet_sub(slider, jet_scale(0.2L, jet_cos(rod))), jet_scale(-0.2L, jet_sin(rod))) +
        0.003L * 2.0L * rod.c[2] * rod.c[1] + 3.0L * slider.c[1] * slider.c[1];
    y[SLIDER] = slider.c[0];
    y[TORQUE] = power / speed;
}

static void lift(const wide t, wide y[OUTPUTS])
{
    const jet up = jet_scale(0.2L, rise(t, 0.125L, 0.25L)), down = jet_scale(-0.3L, rise(t, 0.25L, 0.5L));
    const jet height = jet_add(up, down);
    y[LIFT] = height.c[0];
    y[PULL] = 2.0L * (2.0L * height.c[2] + GRAVITY);
}

/* The axle turns by the integral of its speed; a tooth of the spindle, which is -2 times as fast, pushes it back. */
static void axle(const wide t, wide y[OUTPUTS])
{
    const wide top = 20.0L * PI, up = 0.5L, c = fminl(t / up, 1.0L);
    const jet speed = jet_scale(top, rise(t, 0.0L, up));
    const wide angle = top * (up * c * c * c * c * (2.5L - 3.0L * c + c * c) + fmaxl(t - up, 0.0L));
    y[SPEED] = speed.c[0];
    y[ANGLE] = angle;
    y[MATE] = -2.0L * angle;
    y[TOOTH] = -2.0L * (0.005L * speed.c[1] + 0.002L * speed.c[0]);
    y[DRIVE] = 0.02L * speed.c[1] + 0.01L * speed.c[0] - 2.0L * y[TOOTH];
}

static void table(const wide t, wide y[OUTPUTS])
{
    const wide w = 4.0L * PI;
    y[TABLE] = 1.5L * t * t + 0.2L * cosl(w * t + PI / 6.0L);
    y[TWIST] = 0.02L * (3.0L - 0.2L * w * w * cosl(w * t + PI / 6.0L));
}

/* The input that the step began with, on 2 kg m^2. */
static void disc(const wide t, wide y[OUTPUTS])
{
    const jet push = jet_scale(-3.0L, rise(t, 0.1234L, 0.4321L));
    y[SWING] = (1.0L + push.c[0] + 3.0L * t) / 2.0L;
}

/* How far output i is off; the mate up to whole turns. */
static wide error_of(const int i, const wide wanted)
{
    const wide turned = i == ANGLE ? 2.0L * PI * (wide)iso_the_plant.y[TURNS] : 0.0L;
    const wide off = (wide)iso_the_plant.y[i] + turned - wanted;
    return fabsl(i == MATE ? remainderl(off, 2.0L * PI) : off);
}

/* A tick, and what is wanted of it. */
static void tick_of(const uint32_t tick, const uint32_t ticks, wide y[OUTPUTS])
{
    const wide t = (wide)(tick + 1) / (wide)ticks;
    iso_the_plant.model->step(iso_the_plant.memory);
    iso_the_plant.model->output(iso_the_plant.memory);
    crank(t, y);
    lift(t, y);
    axle(t, y);
    table(t, y);
    disc((wide)tick / (wide)ticks, y);
}

/* The largest errors in a second, of what is larger than 1 relative to that; where time runs so many ticks ahead. */
static void run(wide worst[OUTPUTS], const uint32_t ahead)
{
    const uint32_t ticks = UINT32_C(1000000000) / iso_the_plant.model->period_ns;
    memset(worst, 0, OUTPUTS * sizeof *worst);
    iso_plant_start(&iso_the_plant);
    for (uint32_t tick = 0; tick < ticks; tick++) {
        wide y[OUTPUTS];
        iso_the_plant.model->drive(iso_the_plant.memory, tick + ahead);
        tick_of(tick, ticks, y);
        for (int i = 0; i < OUTPUTS; i++) {
            const wide off = error_of(i, y[i]) / fmaxl(1.0L, fabsl(y[i]));
            worst[i] = off <= worst[i] ? worst[i] : off; /* what is not a number stays */
        }
    }
}

/* The second after that of `run`: the stabilisation, with 50/s, takes what is pulled back by a factor of 1e20. */
static wide pulled(void)
{
    const uint32_t ticks = UINT32_C(1000000000) / iso_the_plant.model->period_ns;
    wide y[OUTPUTS] = {0.0L};
    for (int i = 0; i < iso_the_plant.model->states; i++) {
        iso_the_plant.x[i] += iso_the_plant.x[i] == iso_the_plant.y[MATE] ? PULLED : R(0.0);
    }
    for (uint32_t tick = ticks; tick < 2 * ticks; tick++) {
        iso_the_plant.model->drive(iso_the_plant.memory, tick);
        tick_of(tick, ticks, y);
    }
    return error_of(MATE, y[MATE]);
}

int main(int count, char **arguments)
{
    static wide worst[OUTPUTS], off[OUTPUTS];
    run(worst, 0);
    if (count == 2 && strcmp(arguments[1], "pulled") == 0) {
        printf("%.3Le\n", pulled());
        return EXIT_SUCCESS;
    }
    if (count < 3) {
        for (int i = 0; i < OUTPUTS && count == 2; i++) {
            if (strcmp(arguments[1], names[i]) == 0) {
                printf("%.3Le\n", worst[i]);
            }
        }
        return EXIT_SUCCESS;
    }
    run(off, 1);
    for (int i = 0; i < OUTPUTS; i++) {
        const wide most = strtold(arguments[i < PLACES ? 1 : 2], NULL);
        report_ok(worst[i] <= most, "%s: error %.2Le, at most %.0Le", names[i], worst[i], most);
        report_ok(off[i] > most, "control: time that runs a tick ahead, %s: error %.2Le", names[i], off[i]);
    }
    /* By then the crank has turned a whole number of times; the states that are time are the tick's, and no sum of
     * steps. */
    run(off, (uint32_t)(86400.0e9 / (double)iso_the_plant.model->period_ns));
    report_ok(off[SLIDER] <= strtold(arguments[1], NULL), "a day later: the slider is off by %.2Le", off[SLIDER]);
    return report_done();
}
