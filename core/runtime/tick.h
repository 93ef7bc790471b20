/* A tick of a plant, without a port: iso_plant_tick, and the parts of it between which a loop reads inputs and clock. */
#ifndef ISO_CORE_RUNTIME_TICK_H
#define ISO_CORE_RUNTIME_TICK_H

#include "core/runtime/plant.h"

/* 1. Sets the inputs that are functions of time to those of a tick. */
static inline void iso_plant_drive(const iso_plant *const plant, const uint64_t tick)
{
    if (plant->model->drive != NULL) {
        plant->model->drive(plant->memory, tick);
    }
}

/* 2. Checks inputs and parameters: iso_plant_admit, once the platform has set its own. */

/* 3. Keeps all memory, with the inputs of the tick, for a step that is made again. */
static inline void iso_plant_keep(const iso_plant *const plant)
{
    if (plant->before != NULL) {
        memcpy(plant->before, plant->memory, plant->model->memory_bytes);
    }
}

/* 4. Makes the step; with a new history, which is counted, if an input or a parameter has a discontinuity. */
static inline void iso_plant_step(const iso_plant *const plant, uint64_t *const restarts)
{
    if (plant->model->discontinuity != NULL && plant->model->discontinuity(plant->memory)) {
        plant->model->prime(plant->memory);
        (*restarts)++;
    }
    plant->model->step(plant->memory);
}

/* 5. Makes the step again from where it began, with a new history, if a discontinuity was detected within it. After a
 * restart the same step would come out again. Its error stays known, so that a plant with a discontinuity in every step
 * does not restart in every tick. Returns whether it did. */
static inline bool iso_plant_step_again(const iso_plant *const plant, const bool restarted)
{
    const bool again = plant->before != NULL && plant->progress->discontinuity && !restarted;
    if (again) {
        const iso_progress progress = *plant->progress;
        memcpy(plant->memory, plant->before, plant->model->memory_bytes);
        *plant->progress = progress;
        plant->model->prime(plant->memory);
        plant->model->step(plant->memory);
    }
    return again;
}

/* All ones if state i is not finite or out of its range, else zero; without a branch on it. */
static inline iso_bits iso_plant_is_bad(const iso_plant *const plant, const uint16_t i)
{
    return iso_beyond(plant->x[i], plant->model->range == NULL ? ISO_REAL_MAX : plant->model->range[i]);
}

/* 6. The first state that is not finite or out of its range; model->states if there is none. Without a branch on a
 * state: from the last to the first, each that is bad takes the place of the one behind it. */
static inline uint16_t iso_plant_guard(const iso_plant *const plant)
{
    uint32_t first = plant->model->states;
    for (uint16_t i = plant->model->states; i-- > 0;) {
        first ^= (first ^ i) & (uint32_t)iso_plant_is_bad(plant, i);
    }
    return (uint16_t)first;
}

/* 7. After a tick in which all is well: what the plant remembers, */
static inline void iso_plant_advance(const iso_plant *const plant)
{
    if (plant->model->advance != NULL) {
        plant->model->advance(plant->memory);
    }
}

/* 8. and its outputs; where one is not finite, the last good ones. Returns 1 then, else 0. */
static inline uint32_t iso_plant_output(const iso_plant *const plant)
{
    const iso_model *const model = plant->model;
    model->output(plant->memory);
    return plant->good == NULL ? 0
                               : iso_hold(plant->y, plant->good + model->inputs + model->parameters, model->outputs);
}

/* All of it, from `tick` (0 after iso_plant_start) to the next; inputs that are no functions of time are those in
 * plant->u. What is not finite or beyond its limits is put right, and not counted. Returns the guard: model->states if all is
 * well; else the outputs stay as they were. */
static inline uint16_t iso_plant_tick(const iso_plant *const plant, const uint64_t tick)
{
    iso_plant_drive(plant, tick);
    iso_refusals unused = {0, 0};
    iso_plant_admit(plant, &unused, &unused);
    iso_plant_keep(plant);
    uint64_t restarts = 0;
    iso_plant_step(plant, &restarts);
    (void)iso_plant_step_again(plant, restarts > 0);
    const uint16_t guard = iso_plant_guard(plant);
    if (guard == plant->model->states) {
        iso_plant_advance(plant);
        (void)iso_plant_output(plant);
    }
    return guard;
}

#endif
