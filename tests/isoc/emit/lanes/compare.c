/* Each lane against the same plant alone. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/isoc/emit/lanes/lanes.h"

static outcome alone[MOST_LANES], lanes[MOST_LANES];

static void show(const char *const what, const unsigned number, const outcome *const o)
{
    printf(
        "# %s %u: hash %016llx last %016llx stopped %llu restarts %llu held %llu %llu %llu clamped %llu %llu near %llu "
        "violated %llu error %g %g\n",
        what, number, (unsigned long long)o->hash, (unsigned long long)o->last, (unsigned long long)o->stopped_at,
        (unsigned long long)o->restarts, (unsigned long long)o->outputs_held, (unsigned long long)o->held[0],
        (unsigned long long)o->held[1], (unsigned long long)o->clamped[0], (unsigned long long)o->clamped[1],
        (unsigned long long)o->near_singular, (unsigned long long)o->violated, o->local_error, o->violation);
}

int main(const int count, char **const arguments)
{
    const unsigned n = (unsigned)strtoul(arguments[1], NULL, 10);
    const uint64_t ticks = strtoull(arguments[2], NULL, 10);
    bool good = count == 3;
    run_alone(ticks, n, alone);
    run_lanes(ticks, n, lanes);
    uint64_t restarts = 0, stopped = 0, held = 0, near = 0;
    for (unsigned i = 0; i < n; i++) {
        restarts += alone[i].restarts;
        stopped += alone[i].stopped_at > 0;
        held += alone[i].held[0] + alone[i].held[1];
        near += alone[i].near_singular;
        if (memcmp(&alone[i], &lanes[i], sizeof alone[i]) != 0) {
            good = false;
            show("alone", i, &alone[i]);
            show("lane", i, &lanes[i]);
        }
    }
    printf("%s: restarts %llu stopped %llu held %llu near %llu, hash %016llx\n", good ? "same" : "OTHER",
           (unsigned long long)restarts, (unsigned long long)stopped, (unsigned long long)held,
           (unsigned long long)near, (unsigned long long)alone[1].hash);
    return !good;
}
