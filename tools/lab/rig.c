/* A plant in a process of Python (tools/lab/rig.py): rows of all that it keeps. A row is a copy of the plant's memory.
 * Compiled as a library with the plant, plant.c. */
#include "plant.c"

#include "core/runtime/tick.h"

static const iso_plant *const plant = &iso_the_plant;

/* Sizes, and where in a row its arrays begin, in bytes; `progress` is 0 where there is none. */
struct {
    uint32_t states, inputs, outputs, parameters, memories, bytes, x, u, p, y, real_bytes, period_ns, progress;
    double step; /* s */
    const char *output_names, *output_units;
    void *memory;
    iso_tick_counts counts; /* since the start */
    uint32_t guard;         /* what it said last (core/runtime/tick.h) */
} rig;

static uint32_t place_of(const void *const part)
{
    return part == NULL ? 0 : (uint32_t)((const char *)part - (const char *)plant->memory);
}

void rig_open(void);
void rig_open(void)
{
    const iso_model *const model = plant->model;
    rig.states = model->states;
    rig.inputs = model->inputs;
    rig.outputs = model->outputs;
    rig.parameters = model->parameters;
    rig.memories = model->memories;
    rig.bytes = (uint32_t)model->memory_bytes;
    rig.x = place_of(plant->x);
    rig.u = place_of(plant->u);
    rig.p = place_of(plant->p);
    rig.y = place_of(plant->y);
    rig.real_bytes = (uint32_t)sizeof(real);
    rig.period_ns = model->period_ns;
    rig.step = (double)model->step_size;
    rig.output_names = model->output_names;
    rig.output_units = model->output_units;
    rig.memory = plant->memory;
    rig.progress = place_of(plant->progress);
}

/* Puts the plant to its start, with tunables p[parameters] where p is not NULL. */
void rig_start(const real *p);
void rig_start(const real *const p)
{
    (void)iso_plant_start(plant);
    memset(&rig.counts, 0, sizeof rig.counts);
    if (p != NULL) {
        memcpy(plant->p, p, plant->model->parameters * sizeof *p);
        (void)iso_plant_admit(plant);
    }
}

/* Begins the method anew where the plant stands, before the tick of this number. */
void rig_begin(uint64_t tick);
void rig_begin(const uint64_t tick)
{
    iso_plant_drive(plant, tick);
    if (plant->model->prime != NULL) {
        plant->model->prime(plant->memory);
    }
}

/* The outputs, as the start and a changed state have them. */
void rig_output(void);
void rig_output(void)
{
    (void)iso_plant_output(plant);
}

/* What iso_plant_tick_counted does when the inputs are known. */
static uint16_t end_tick(void)
{
    const iso_refused refused = iso_plant_admit(plant);
    iso_count_refused(&rig.counts.inputs, (uint32_t)refused);
    iso_count_refused(&rig.counts.parameters, (uint32_t)(refused >> 32));
    rig.counts.restarts += iso_plant_step(plant);
    const uint32_t finished = plant->model->finish(plant->memory);
    rig.counts.outputs_held += finished == ISO_HELD;
    if (plant->nearness != NULL) {
        rig.counts.near_singular += plant->nearness->closure != 0;
        plant->nearness->closure = 0;
    }
    rig.guard = iso_plant_guard(plant, finished);
    return (uint16_t)rig.guard;
}

/* Makes so many ticks, with numbers from `first` on, and inputs inputs[ticks][inputs] where these are not NULL, in the
 * place of functions of time too: all of them, or where which[inputs] is not NULL those that it names. Takes a row at
 * every tick that is a multiple of `every`, counted from the first one, when its inputs are known, and that behind the
 * last tick. Returns how many ticks were made before the guard ended it. */
uint64_t rig_go(uint64_t first, uint64_t ticks, uint64_t every, const real *inputs, const bool *which, char *rows);
uint64_t rig_go(const uint64_t first, const uint64_t ticks, const uint64_t every, const real *const inputs,
                const bool *const which, char *const rows)
{
    const iso_model *const model = plant->model;
    for (uint64_t tick = 0;; tick++) {
        iso_plant_drive(plant, first + tick);
        for (uint32_t i = 0; inputs != NULL && tick < ticks && i < model->inputs; i++) {
            plant->u[i] = which == NULL || which[i] ? inputs[tick * model->inputs + i] : plant->u[i];
        }
        if (tick % every == 0) {
            memcpy(rows + tick / every * model->memory_bytes, plant->memory, model->memory_bytes);
        }
        if (tick == ticks) {
            return tick;
        }
        if (end_tick() != model->states) {
            return tick;
        }
    }
}

/* Of each row the outputs and, where dx is not NULL, the derivatives dx[count][states]. */
void rig_look(char *rows, size_t count, real *dx);
void rig_look(char *const rows, const size_t count, real *const dx)
{
    const size_t bytes = plant->model->memory_bytes;
    for (size_t i = 0; i < count; i++) {
        memcpy(plant->memory, rows + i * bytes, bytes);
        if (dx != NULL) {
            iso_the_derivative(dx + i * plant->model->states, plant->x, plant->u, plant->p);
        }
        plant->model->output(plant->memory);
        memcpy(rows + i * bytes, plant->memory, bytes);
    }
}

/* Each row a step later. */
void rig_step(char *rows, size_t count);
void rig_step(char *const rows, const size_t count)
{
    const size_t bytes = plant->model->memory_bytes;
    for (size_t i = 0; i < count; i++) {
        memcpy(plant->memory, rows + i * bytes, bytes);
        plant->model->step(plant->memory);
        memcpy(rows + i * bytes, plant->memory, bytes);
    }
}
