/* A plant on the bench of tests/conftest.py: rows of all that it keeps, for tests in Python. A row is a copy of the
 * plant's memory. Compiled as a library with the plant, -DPLANT="plant.c". */
#include PLANT
#include "core/runtime/tick.h"

static const iso_plant *const plant = &iso_the_plant;

/* Sizes, and where in a row its arrays begin, in bytes. */
struct {
    uint32_t states, inputs, outputs, parameters, memories, bytes, x, u, p, y;
    double step; /* s */
    const char *output_names;
} bench;

static uint32_t place_of(const real *const array)
{
    return array == NULL ? 0 : (uint32_t)((const char *)array - (const char *)plant->memory);
}

void bench_open(void);
void bench_open(void)
{
    const iso_model *const model = plant->model;
    bench.states = model->states;
    bench.inputs = model->inputs;
    bench.outputs = model->outputs;
    bench.parameters = model->parameters;
    bench.memories = model->memories;
    bench.bytes = (uint32_t)model->memory_bytes;
    bench.x = place_of(plant->x);
    bench.u = place_of(plant->u);
    bench.p = place_of(plant->p);
    bench.y = place_of(plant->y);
    bench.step = (double)model->step_size;
    bench.output_names = model->output_names;
}

/* Runs so many ticks from the start, with numbers from `first` on, with tunables p[parameters] where p is not NULL, and
 * inputs given[ticks][inputs] where given is not NULL. Takes a row at every tick that is a multiple of `every`, counted
 * from the first one, when its inputs are known, and that behind the last tick. Returns how many ticks were made before
 * the guard ended it. */
uint64_t bench_run(uint64_t first, uint64_t ticks, uint64_t every, const real *p, const real *given, char *rows);
uint64_t bench_run(const uint64_t first, const uint64_t ticks, const uint64_t every, const real *const p,
                   const real *const given, char *const rows)
{
    const iso_model *const model = plant->model;
    (void)iso_plant_start(plant);
    if (p != NULL) {
        memcpy(plant->p, p, model->parameters * sizeof *p);
        (void)iso_plant_admit(plant);
    }
    model->output(plant->memory);
    for (uint64_t tick = 0;; tick++) {
        iso_plant_drive(plant, first + tick);
        if (given != NULL && tick < ticks) {
            memcpy(plant->u, given + tick * model->inputs, model->inputs * sizeof *given);
        }
        if (tick % every == 0) {
            memcpy(rows + tick / every * model->memory_bytes, plant->memory, model->memory_bytes);
        }
        if (tick == ticks || iso_plant_tick(plant, first + tick) != model->states) {
            return tick;
        }
    }
}

/* Of each row the outputs and, where dx is not NULL, the derivatives dx[count][states]. */
void bench_look(char *rows, size_t count, real *dx);
void bench_look(char *const rows, const size_t count, real *const dx)
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
void bench_step(char *rows, size_t count);
void bench_step(char *const rows, const size_t count)
{
    const size_t bytes = plant->model->memory_bytes;
    for (size_t i = 0; i < count; i++) {
        memcpy(plant->memory, rows + i * bytes, bytes);
        plant->model->step(plant->memory);
        memcpy(rows + i * bytes, plant->memory, bytes);
    }
}
