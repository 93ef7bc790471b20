/* A generated plant, ticked without a loop, with inputs and tunables that no plant can compute with. */
#include <math.h>
#include <stdio.h>

#include "limited.h"
#include "open.h"

#include "core/runtime/tick.h"

static int failed;

static void expect(const int passed, const char *const name)
{
    if (!passed) {
        printf("not so: %s\n", name);
        failed = 1;
    }
}

int main(void)
{
    enum { TICKS = 2000 };
    static limited_memory inside;
    static open_memory outside;
    const iso_plant limited = limited_plant(&inside), open = open_plant(&outside);
    iso_plant_start(&limited);
    iso_plant_start(&open);
    for (uint64_t tick = 0; tick < TICKS; tick++) {
        limited.u[LIMITED_U_FORCE] = open.u[OPEN_U_FORCE] = (real)(tick % 10) - R(5.0);
        limited.p[LIMITED_P_DRAG] = open.p[OPEN_P_DRAG] = tick % 2 == 0 ? R(0.1) : R(2.0);
        (void)iso_plant_tick(&limited, tick);
        (void)iso_plant_tick(&open, tick);
    }
    expect(memcmp(inside.x, outside.x, sizeof inside.x) == 0 && inside.x[0] != R(0.0),
           "the same bits within the limits");

    const real bad[] = {(real)NAN, (real)INFINITY, (real)-INFINITY, ISO_REAL_MAX, -ISO_REAL_MAX, R(1e30)};
    const uint64_t kinds = sizeof bad / sizeof bad[0];
    uint64_t good = 0;
    iso_tick_counts counts = {.restarts = 0};
    for (uint64_t tick = 0; tick < TICKS; tick++) {
        inside.u[LIMITED_U_FORCE] = bad[tick % kinds];
        inside.p[LIMITED_P_DRAG] = bad[tick / kinds % kinds];
        good += iso_plant_tick_counted(&limited, tick, &counts) == limited.model->states;
        expect(inside.u[LIMITED_U_FORCE] >= R(-5.0) && inside.u[LIMITED_U_FORCE] <= R(4.0),
               "the force within its limits");
        expect(inside.p[LIMITED_P_DRAG] >= R(0.1) && inside.p[LIMITED_P_DRAG] <= R(2.0), "the drag within its limits");
    }
    const iso_refusals inputs = counts.inputs, parameters = counts.parameters;
    expect(good == TICKS && inputs.held + inputs.clamped == TICKS && parameters.held + parameters.clamped == TICKS,
           "every tick good, every number counted");

    /* A mass that would make the matrix of masses singular, or negative. */
    const real masses[] = {R(0.0), R(-0.0), R(-1.0), R(1e-30), R(1e30), (real)NAN};
    const uint64_t counted = counts.parameters.held + counts.parameters.clamped;
    inside.p[LIMITED_P_DRAG] = R(0.5);
    bool is_finite = true;
    for (uint64_t tick = 0; tick < TICKS; tick++) {
        inside.p[LIMITED_P_WEIGHT] = masses[tick % (sizeof masses / sizeof masses[0])];
        inside.u[LIMITED_U_FORCE] = R(1.0);
        is_finite = is_finite && iso_plant_tick_counted(&limited, tick, &counts) == limited.model->states &&
                    inside.p[LIMITED_P_WEIGHT] >= R(0.1) && inside.p[LIMITED_P_WEIGHT] <= R(4.0);
    }
    expect(is_finite, "a mass of zero is that of its limit");
    expect(counts.parameters.held + counts.parameters.clamped == counted + TICKS, "and counted");
    const real weight = outside.p[OPEN_P_WEIGHT];
    iso_tick_counts of_open = {.restarts = 0};
    outside.p[OPEN_P_WEIGHT] = R(0.0);
    expect(iso_plant_tick_counted(&open, TICKS, &of_open) == open.model->states && outside.p[OPEN_P_WEIGHT] == weight &&
               of_open.parameters.held == 1,
           "without limits it is refused");

    /* A quotient by zero is infinite: then the last good outputs stand. */
    const real place = inside.y[LIMITED_Y_PLACE], ratio = inside.y[LIMITED_Y_RATIO];
    inside.p[LIMITED_P_SCALE] = R(0.0);
    expect(iso_plant_tick_counted(&limited, 0, &counts) == limited.model->states, "a bad output is no bad state");
    expect(counts.outputs_held == 1, "it is counted");
    expect(inside.y[LIMITED_Y_PLACE] == place && inside.y[LIMITED_Y_RATIO] == ratio, "the last good outputs stand");
    inside.p[LIMITED_P_SCALE] = R(2.0);
    (void)iso_plant_tick(&limited, 0);
    expect(inside.y[LIMITED_Y_RATIO] == inside.x[0] / R(2.0), "and new ones when all is well again");
    printf("inputs held %d clamped %d, tunables held %d clamped %d\n", (int)inputs.held, (int)inputs.clamped,
           (int)parameters.held, (int)parameters.clamped);
    return failed;
}
