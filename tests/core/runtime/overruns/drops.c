/* The trajectory and the outputs of a ladder that drops effects, from plants of the scene with less and less of them,
 * one handing what it keeps to the other: the rung of each tick is a line of RUNGS, the outputs after it a line of the
 * trace, which begins with a header and the start. What is dropped keeps its state and its memory here; the past of its
 * formulas goes on.
 *
 *     PROGRAM RUNGS TRACE
 *
 * Prints the hash of the states, and in how many lines an output has other bits.
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "by_all.h"
#include "by_least.h"
#include "by_less.h"

#include "core/runtime/hash.h"
#include "core/runtime/tick.h"

enum { PLANTS = 3, REST = 3 };

static by_all_memory all;
static by_less_memory less;
static by_least_memory least;

/* To the plants of lower rungs, and back from the one that made the tick. */
static void hand_down(void)
{
    less.x[BY_LESS_X_PIVOT] = least.x[BY_LEAST_X_PIVOT] = all.x[BY_ALL_X_PIVOT];
    less.x[BY_LESS_X_PIVOT_SPEED] = least.x[BY_LEAST_X_PIVOT_SPEED] = all.x[BY_ALL_X_PIVOT_SPEED];
    less.u[BY_LESS_U_WIND_PUSH] = all.u[BY_ALL_U_WIND_PUSH];
    less.u[BY_LESS_U_AIR_SWING] = least.u[BY_LEAST_U_AIR_SWING] = all.u[BY_ALL_U_AIR_SWING];
}

static void hand_up(const int rung)
{
    if (rung == 1) {
        all.x[BY_ALL_X_PIVOT] = less.x[BY_LESS_X_PIVOT];
        all.x[BY_ALL_X_PIVOT_SPEED] = less.x[BY_LESS_X_PIVOT_SPEED];
        all.u[BY_ALL_U_WIND_PUSH] = less.u[BY_LESS_U_WIND_PUSH];
        all.u[BY_ALL_U_AIR_SWING] = less.u[BY_LESS_U_AIR_SWING];
    } else if (rung > 1) {
        all.x[BY_ALL_X_PIVOT] = least.x[BY_LEAST_X_PIVOT];
        all.x[BY_ALL_X_PIVOT_SPEED] = least.x[BY_LEAST_X_PIVOT_SPEED];
        all.u[BY_ALL_U_AIR_SWING] = least.u[BY_LEAST_U_AIR_SWING];
    }
    if (rung > 0) {
        all.u[BY_ALL_U_KEPT_PREVIOUS_1] = all.past_3[0];
        all.past_3[0] = all.x[BY_ALL_X_HINGE_BEND];
    }
}

/* The outputs of a rung: what is dropped shows zero. */
static void outputs_of(const int rung, real y[BY_ALL_OUTPUTS])
{
    if (rung == 0) {
        memcpy(y, all.y, sizeof all.y);
        return;
    }
    const bool is_first = rung == 1;
    y[BY_ALL_Y_THETA] = is_first ? less.y[BY_LESS_Y_THETA] : least.y[BY_LEAST_Y_THETA];
    y[BY_ALL_Y_ACCELERATION] = is_first ? less.y[BY_LESS_Y_ACCELERATION] : least.y[BY_LEAST_Y_ACCELERATION];
    y[BY_ALL_Y_ENERGY] = is_first ? less.y[BY_LESS_Y_ENERGY] : least.y[BY_LEAST_Y_ENERGY];
    y[BY_ALL_Y_EFFORT] = y[BY_ALL_Y_LATE] = R(0.0);
}

/* Whether a line of the trace has these outputs behind the time. */
static bool agrees(const char *line, const real y[BY_ALL_OUTPUTS])
{
    bool is = true;
    for (int i = 0; i < BY_ALL_OUTPUTS; i++) {
        line = strchr(line, ',');
        const real shown = line == NULL ? R(1e30) : strtof(line + 1, NULL);
        line = line == NULL ? "" : line + 1;
        is = is && shown >= y[i] && shown <= y[i];
    }
    return is;
}

int main(const int argc, char **const argv)
{
    FILE *const rungs = argc > 2 ? fopen(argv[1], "r") : NULL, *const trace = argc > 2 ? fopen(argv[2], "r") : NULL;
    const iso_plant plants[PLANTS] = {by_all_plant(&all), by_less_plant(&less), by_least_plant(&least)};
    uint64_t hash = ISO_HASH_START;
    int rung = 0, wrong = 0;
    char line[400];
    if (rungs == NULL || trace == NULL || fgets(line, sizeof line, trace) == NULL ||
        fgets(line, sizeof line, trace) == NULL) {
        return EXIT_FAILURE;
    }
    for (int i = 0; i < PLANTS; i++) {
        iso_plant_start(&plants[i]);
    }
    for (uint64_t tick = 0; fscanf(rungs, "%d", &rung) == 1 && fgets(line, sizeof line, trace) != NULL; tick++) {
        const iso_plant *const on = &plants[rung < PLANTS ? rung : PLANTS - 1];
        real y[BY_ALL_OUTPUTS];
        hand_down();
        (void)iso_plant_output(on); /* the sines of the states that it was handed */
        iso_plant_drive(on, tick);
        (void)iso_plant_admit(on);
        if (rung != REST) {
            (void)iso_plant_step(on);
        }
        (void)on->model->finish(on->memory);
        hand_up(rung);
        outputs_of(rung, y);
        wrong += !agrees(line, y);
        hash = iso_hash_reals(hash, all.x, BY_ALL_STATES);
    }
    printf("%016" PRIx64 " %d\n", hash, wrong);
    return EXIT_SUCCESS;
}
