#ifndef ISO_INSIDE_H
#define ISO_INSIDE_H

/* A plant in the process of its controller: what the library of a plant shows, which `isochron python` makes, as the
 * object iso_the_inside. The library and the headers for controllers that isoc writes both have this file. */
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The outcome of a step. */
typedef enum iso_inside_outcome {
    ISO_INSIDE_STEPPED,
    ISO_INSIDE_STEPPED_LAST, /* it is the last of the run */
    ISO_INSIDE_OVER,         /* no step: the guard has stopped the plant with it, or the run is over */
    ISO_INSIDE_RESTS,        /* no step: the plant rests */
    ISO_INSIDE_NO_RUN        /* no step: none has been started */
} iso_inside_outcome;

/* A plant is a block of bytes(), which begins where a 64-bit word may. */
typedef struct iso_inside {
    const uint64_t *identity; /* of the plant: a controller is made for one alone */
    size_t (*bytes)(void);
    const void *(*open)(void *plant); /* its outputs; NULL where this processor, or its mode, computes other bits */
    void (*start)(void *plant, uint64_t ticks);
    iso_inside_outcome (*step)(void *plant, const void *inputs); /* all inputs, reals in the order of a frame */
    void (*stop)(void *plant);
    bool (*runs)(const void *plant);
    /* Does the command of a payload, as it stands in a frame: the payload of its answer; NULL: there is no such one. */
    const uint8_t *(*ask)(void *plant, const uint8_t *payload, size_t length, size_t *answered);
} iso_inside;

#endif
