/* Three plants of one scene: `held`, `smooth`, and `jump`, smooth with a jump of 1. What a plant knows of its inputs is
 * in its memory; the first sample has no past, a jump forgets it. Bits, so that no tolerance hides a sample. */
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "core/runtime/tick.h"
#include "tests/host/report.h"

#include "held.h"
#include "jump.h"
#include "smooth.h"

enum { TICKS = 40, INPUTS = SMOOTH_INPUTS };

typedef void signal_of(real *u, int tick);

static void constant(real *const u, const int tick)
{
    (void)tick;
    u[0] = R(5.0);
    u[1] = R(-2.0);
}

static void leap(real *const u, const int tick)
{
    constant(u, tick);
    u[0] *= tick < TICKS / 2 ? R(1.0) : R(-1.0);
    u[1] *= tick < TICKS / 2 ? R(1.0) : R(-1.0);
}

static void wave(real *const u, const int tick)
{
    u[0] = (real)sin(0.05 * tick);
    u[1] = (real)cos(0.03 * tick);
}

static void run(const iso_plant *const plant, signal_of *const signal, const int from, const int to)
{
    for (int tick = from; tick < to; tick++) {
        signal(plant->u, tick);
        (void)iso_plant_tick(plant, (uint32_t)tick);
    }
}

static void whole(const iso_plant *const plant, signal_of *const signal)
{
    iso_plant_start(plant);
    run(plant, signal, 0, TICKS);
}

static bool same(const iso_plant *const a, const iso_plant *const b)
{
    return memcmp(a->x, b->x, a->model->states * sizeof *a->x) == 0;
}

int main(void)
{
    static held_memory held_one;
    static smooth_memory one, two, kept;
    static jump_memory jump_one;
    const iso_plant held = held_plant(&held_one), smooth = smooth_plant(&one), other = smooth_plant(&two);
    const iso_plant jump = jump_plant(&jump_one);

    whole(&held, constant);
    whole(&smooth, constant);
    report_ok(same(&held, &smooth), "a constant from the first tick on: a first sample has no past");
    whole(&held, leap);
    whole(&smooth, leap);
    whole(&jump, leap);
    report_ok(same(&held, &jump), "a constant after a jump: it forgets the samples");
    report_ok(!same(&held, &smooth), "control: without a jump in the scene it does not");
    whole(&held, wave);
    whole(&smooth, wave);
    report_ok(!same(&held, &smooth), "control: a wave is extrapolated");
    whole(&jump, wave);
    report_ok(same(&jump, &smooth), "changes below the jump are no jump");

    /* Another instance runs in between, with other samples; a snapshot is a copy. */
    iso_plant_start(&other);
    iso_plant_start(&smooth);
    for (int tick = 0; tick < TICKS / 2; tick++) {
        run(&smooth, wave, tick, tick + 1);
        run(&other, leap, tick, tick + 1);
    }
    kept = one;
    run(&smooth, leap, 0, 3);
    one = kept;
    run(&smooth, wave, TICKS / 2, TICKS);
    report_ok(same(&jump, &smooth), "two instances, and a snapshot: the samples are in the memory");
    report_ok(memcmp(&one, &two, sizeof one) != 0, "control: the instances differ");
    return report_done();
}
