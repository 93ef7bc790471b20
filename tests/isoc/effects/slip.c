/* Stick and slip of a block that a spring draws over a rough rail: the period is that of an integration of the same
 * equations in steps of a quarter of the tick, and longer than that of the closed form for a friction that falls at
 * once. */
#include <math.h>

#include PLANT
#include "core/runtime/tick.h"
#include "tests/host/report.h"

enum { TICKS = 50000, PARTS = 4, PERIODS = 5 };

static const long double h = 1e-4L, mass = 2.0L, stiffness = 200.0L, sliding = 3.0L, at_rest = 4.0L, drawn = 0.05L,
                         fall = 0.014L, creep = (long double)CREEP;

/* The times at which the speed rises through that of the spring's end: each a slip that begins. */
typedef struct slips {
    long double times[64], before;
    int count;
} slips;

static void look(slips *const s, const long double t, const long double v)
{
    if (s->before < drawn && v >= drawn && s->count < 64) {
        s->times[s->count++] = t - h * (v - drawn) / (v - s->before);
    }
    s->before = v;
}

/* The mean of the last periods, when the first, from rest, has been forgotten. */
static long double period_of(const slips *const s)
{
    return s->count > PERIODS ? (s->times[s->count - 1] - s->times[s->count - 1 - PERIODS]) / PERIODS : 0.0L;
}

static long double friction(const long double v)
{
    const long double beyond = fmaxl(v * v - creep * creep, 0.0L);
    const long double level = sliding + (at_rest - sliding) / (1.0L + beyond / (fall * fall));
    const long double near = fminl(fmaxl(v / creep, -1.0L), 1.0L);
    return level * near * (3.0L - near * near) / 2.0L;
}

static void move(long double *const x, long double *const v, const long double end, const long double by)
{
    long double dx[4], dv[4], xs = *x, vs = *v;
    static const long double parts[4] = {0.5L, 0.5L, 1.0L, 0.0L};
    for (int i = 0; i < 4; i++) {
        dx[i] = vs;
        dv[i] = (stiffness * (end - xs) - friction(vs)) / mass;
        xs = *x + parts[i] * by * dx[i];
        vs = *v + parts[i] * by * dv[i];
    }
    *x += by / 6.0L * (dx[0] + 2.0L * dx[1] + 2.0L * dx[2] + dx[3]);
    *v += by / 6.0L * (dv[0] + 2.0L * dv[1] + 2.0L * dv[2] + dv[3]);
}

int main(void)
{
    const iso_plant *const plant = &iso_the_plant;
    slips seen = {.before = 0.0L}, expected = {.before = 0.0L};
    long double x = 0.0L, v = 0.0L;
    iso_plant_start(plant);
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        (void)iso_plant_tick(plant, tick);
        look(&seen, h * (tick + 1), (long double)plant->y[PLANT_Y_SPEED]);
        for (int i = 0; i < PARTS; i++) {
            move(&x, &v, drawn * h * tick, h / PARTS);
        }
        look(&expected, h * (tick + 1), v);
    }
    const long double is = period_of(&seen), exact = period_of(&expected);
    /* The spring's force has the rounding of its places, up to 0.25 m, of the 1 N that the period is of; and rk4
     * follows a creep at half of what it holds to some parts in a million. */
    const long double off = fabsl(is / exact - 1.0L), rounding = 200.0L * 0.25L * (long double)ISO_REAL_EPSILON;
    report_ok(off <= 10.0L * rounding + 1e-5L, "it sticks and slips every %.6Lg s: %.2Lg off", exact, off);
    /* While it slips it swings about the place where the spring holds the sliding friction, from a stretch beyond that
     * by `far` to one short of it by as much, at which it has the speed of the spring's end again. A friction that
     * falls over some speed takes more time to let go. */
    const long double far = (at_rest - sliding) / stiffness, w = sqrtl(stiffness / mass);
    const long double closed = 2.0L * far / drawn + 2.0L / w * (acosl(-1.0L) - atanl(far * w / drawn));
    report_ok(is > closed && is < 1.1L * closed, "at least the %.4Lg s of the closed form", closed);
    return report_done();
}
