/* Choppers and batteries of supply.py. A chopper's current is in the end that of its switchings, to the part of L / R
 * that a period is, at every step; its shaft does not turn more slowly. A battery has the voltage of its equation; it
 * gives no more than its charge, and takes no more than its capacity. */
#include <float.h>
#include <math.h>

#include PLANT
#include "core/runtime/tick.h"
#include "tests/host/report.h"

#ifdef ISO_REAL_DOUBLE
#define ULP DBL_EPSILON
#else
#define ULP ((double)FLT_EPSILON)
#endif

typedef struct chopper {
    int current;
    double mean, period, rise; /* A; of L / R; and the current that a step at the supply's voltage adds, in A */
} chopper;

typedef struct battery {
    int charge, voltage, heat;
    double start, current;
    int cells;
    double resistance;
} battery;

#include "table.h"

enum { CHOPPERS = sizeof choppers / sizeof choppers[0], BATTERIES = sizeof batteries / sizeof batteries[0] };

static const double capacity = 10.0, seconds = 1.0;

/* Of a cell at rest: Chen, Rincon-Mora (2006), eq. 2. */
static double cell(const double s)
{
    return -1.031 * exp(-35.0 * s) + 3.685 + 0.2156 * s - 0.1178 * s * s + 0.3201 * s * s * s;
}

int main(void)
{
    const iso_plant *const plant = &iso_the_plant;
    double off[BATTERIES] = {0.0}, least[BATTERIES], most[BATTERIES], given[BATTERIES] = {0.0}, heat[BATTERIES];
    const int ticks = (int)(seconds / STEP + 0.5);
    for (int i = 0; i < BATTERIES; i++) {
        least[i] = most[i] = batteries[i].start;
        heat[i] = 0.0;
    }
    iso_plant_start(plant);
    for (int tick = 0; tick < ticks; tick++) {
        (void)iso_plant_tick(plant, (uint64_t)tick);
        for (int i = 0; i < BATTERIES; i++) {
            const battery *b = &batteries[i];
            const double charge = (double)plant->y[b->charge], voltage = (double)plant->y[b->voltage];
            const double rest = cell(charge) * fmin(charge / 0.005, 1.0);
            off[i] = fmax(off[i], fabs(voltage - (b->cells * rest - b->resistance * b->current)));
            least[i] = fmin(least[i], charge);
            most[i] = fmax(most[i], charge);
            given[i] += STEP * (voltage + b->resistance * b->current) * b->current;
            heat[i] += STEP * ((double)plant->y[b->heat] - b->resistance * b->current * b->current);
        }
    }
    for (int i = 0; i < CHOPPERS; i++) {
        const double now = (double)plant->y[choppers[i].current], mean = choppers[i].mean;
        /* The voltage is rounded; so is the current that it leads to in a step. */
        const double allowed = choppers[i].period * mean + 8.0 * ULP * choppers[i].rise;
        report_ok(fabs(now - mean) <= allowed, "chopper %d: %.5g A, switched %.5g A: %.2g A off, at most %.2g", i, now,
                  mean, fabs(now - mean), allowed);
    }
    for (int i = 0; i < BATTERIES; i++) {
        const battery *b = &batteries[i];
        const double change = fabs(b->current) * STEP / capacity;
        const double allowed = 64.0 * ULP * (b->cells * 4.2 + b->resistance * fabs(b->current));
        report_ok(off[i] <= allowed, "battery %d: its voltage is that of the equation, %.2g V off, at most %.2g", i,
                  off[i], allowed);
        /* In an empty one what it still gives is that of the charge that it has below 0.005, at most the voltage there.
         */
        double held = 0.0;
        for (int n = 0; n < 10000; n++) {
            const double s = (n + 0.5) / 10000.0;
            held += s < b->start ? b->cells * capacity * cell(s) * fmin(s / 0.005, 1.0) / 10000.0 : 0.0;
        }
        const double edge = b->cells * capacity * 8.0 * change * 4.2 + b->cells * capacity * 1e-3;
        report_ok(least[i] >= 0.0 && most[i] <= 1.0 && given[i] <= held + edge &&
                      heat[i] >= -ticks * ULP * b->current * b->current,
                  "battery %d: its charge stays within 0 and 1: %.3g to %.4g; it gives %.4g J of %.4g J", i, least[i],
                  most[i], given[i], held);
    }
    return report_done();
}
