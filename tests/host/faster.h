/* A family of starts of one plant. */
#ifndef ISO_TESTS_HOST_FASTER_H
#define ISO_TESTS_HOST_FASTER_H

#include "core/runtime/plant.h"

/* Starts a plant with the speeds of its scene times `faster`. Without memories they are the second half of the states;
 * with a ball joint, whose position has a number more, the smaller half. */
static inline void start_faster(const iso_plant *const plant, const real faster)
{
    const uint16_t states = plant->model->states;
    iso_plant_start(plant);
    for (int s = states - states / 2; s < states; s++) {
        plant->x[s] *= faster;
    }
}

#endif
