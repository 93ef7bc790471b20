/* The inputs of a loop: values that change at every tick, as a controller gives them. Recorded, or a wave for each
 * input that a seed chooses, about its value at the start, from 1/400 to 1/100 of a period in a tick. It is as large as
 * the scene's own function of time gets, or 1 in SI units, and begins gently, like t^4: as if the input had been
 * constant before. */
#ifndef ISO_REPORT_SIGNALS_H
#define ISO_REPORT_SIGNALS_H

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "core/numbers/sincos.h"
#include "core/runtime/plant.h"
#include "tools/file/file.h"

enum { SIGNALS_SEED = 1, SIGNALS_MOST = 256 };

typedef struct wave {
    double centre, amplitude;
    double frequency; /* rad/s */
    double phase;
} wave;

typedef struct signals {
    wave waves[SIGNALS_MOST];
    size_t inputs;
    double tick;     /* of the scene, s */
    double *samples; /* recorded, [rows inputs]; NULL if there are none */
    size_t rows;
} signals;

/* Steele, Lea, Flood (2014), Fast splittable pseudorandom number generators: a number in [0, 1). */
static inline double signals_random(uint64_t *const state)
{
    uint64_t z = *state += UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/* The values with which the functions of time of a plant, which it starts, are largest in so long; 0 without one. */
static inline void signals_largest(const iso_plant *const plant, const double time, real *const largest)
{
    const uint32_t ticks = (uint32_t)(time / (double)plant->model->step_size + 0.5);
    iso_plant_start(plant);
    for (uint32_t k = 0; plant->model->drive != NULL && k < ticks; k++) {
        plant->model->drive(plant->memory, k);
        for (size_t i = 0; i < plant->model->inputs && i < SIGNALS_MOST; i++) {
            largest[i] = iso_abs(plant->u[i]) > iso_abs(largest[i]) ? plant->u[i] : largest[i];
        }
    }
}

/* Waves for the inputs of a plant, whose functions of time are looked at for so long; starts the plant. */
static inline void signals_waves(signals *const s, const iso_plant *const plant, const double time)
{
    const double pi = 3.14159265358979323846;
    uint64_t state = SIGNALS_SEED;
    real largest[SIGNALS_MOST] = {R(0.0)};
    signals_largest(plant, time, largest);
    iso_plant_start(plant);
    for (size_t i = 0; i < s->inputs; i++) {
        s->waves[i].centre = (double)plant->u[i];
        s->waves[i].amplitude = iso_abs(largest[i]) > R(0.0) ? (double)iso_abs(largest[i]) : 1;
        s->waves[i].frequency = 2 * pi * (1 + 3 * signals_random(&state)) / (400 * s->tick);
        s->waves[i].phase = 2 * pi * signals_random(&state);
    }
}

/* Starts a plant whose inputs keep their values at its start for so long. If the environment has STEADY, which it has
 * for all plants of a measurement alike, each keeps the value with which its function of time is largest until then;
 * without a function, or where that is 0, 1 in SI units. */
static inline void signals_start(const iso_plant *const plant, const double time)
{
    const char *const steady = getenv("STEADY");
    real largest[SIGNALS_MOST] = {R(0.0)};
    iso_plant_start(plant);
    if (steady == NULL || *steady == '\0') {
        return;
    }
    signals_largest(plant, time, largest);
    for (size_t i = 0; i < plant->model->inputs && i < SIGNALS_MOST; i++) {
        plant->u[i] = iso_abs(largest[i]) > R(0.0) ? largest[i] : R(1.0);
    }
    if (plant->model->prime != NULL) {
        plant->model->prime(plant->memory);
    }
}

/* A line for each tick, with a number for each input, and blanks or commas between them. */
static inline void signals_recorded(signals *const s, const char *const path)
{
    size_t bytes = 0, count = 0;
    char *const text = file_content(path, &bytes);
    if (text == NULL) {
        quit("%s: %s", path, strerror(errno));
    }
    s->samples = memory_for(bytes / 2 + 1, sizeof *s->samples); /* each number but the first has two characters */
    char *at = text;
    for (char *end = NULL;; at = end + strspn(end, ", \t")) {
        const double value = strtod(at, &end);
        if (end == at) {
            break;
        }
        s->samples[count++] = value;
    }
    s->rows = count / s->inputs;
    if (at[strspn(at, " \t\r\n")] != '\0' || s->rows == 0 || count % s->inputs != 0) {
        quit("%s: %zu numbers are no lines of %zu inputs", path, count, s->inputs);
    }
    free(text);
}

static inline double signals_at(const signals *const s, const size_t i, const double t)
{
    if (s->samples != NULL) {
        return s->samples[(size_t)(t / s->tick + 0.5) % s->rows * s->inputs + i];
    }
    const wave *const w = &s->waves[i];
    const double part = t / (t + 50 * s->tick);
    const iso_sine_cosine turn = iso_sincos((real)(w->frequency * t + w->phase));
    return w->centre + w->amplitude * part * part * part * part * (double)turn.sin;
}

#endif
