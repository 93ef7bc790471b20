#include "tools/python/instance.h"

#include "core/numbers/self_check.h"
#include "core/runtime/hash.h"
#include "core/runtime/policy.h"
#include "port/port.h"

/* --- The platform ------------------------------------------------------------------------------------------------ */

/* The virtual time of the plant that steps: in nanoseconds, and in ticks. */
static _Thread_local uint64_t reported, period;

uint32_t iso_port_start(const uint32_t period_ns)
{
    period = period_ns;
    reported = 0;
    return period_ns;
}

uint64_t iso_port_wait(void)
{
    return ++reported;
}

uint64_t iso_port_clock(void)
{
    return reported * period;
}

void iso_port_read(real *const u, const size_t inputs)
{
    (void)u;
    (void)inputs;
}

void iso_port_publish(const real *const y, const size_t outputs)
{
    (void)y;
    (void)outputs;
}

void iso_port_safe(void)
{
}

/* --- An instance ------------------------------------------------------------------------------------------------- */

/* The place in a block that a part has in the memory of the program's plant; the layouts are the same. */
static void *placed(const void *const part, unsigned char *const block)
{
    return part == NULL ? NULL : block + ((const unsigned char *)part - (const unsigned char *)iso_the_plant.memory);
}

/* Bytes of a part of a block, up to where a word of 64 bits may begin. */
static size_t whole_words(const size_t bytes)
{
    return (bytes + sizeof(uint64_t) - 1) / sizeof(uint64_t) * sizeof(uint64_t);
}

static size_t before_bytes(void)
{
    return iso_the_plant.before == NULL ? 0 : whole_words(iso_the_plant.model->memory_bytes);
}

size_t iso_instance_bytes(void)
{
    const size_t memory = iso_the_plant.model->memory_bytes;
    return whole_words(sizeof(iso_instance)) + whole_words(memory) + before_bytes() + ISO_SNAPSHOT_BYTES(memory);
}

bool iso_instance_is_alone(void)
{
    return iso_the_plant.model->policy != NULL;
}

/* Copies the data of an instance into those of the library, which exist once. */
static void enter(const iso_instance *const instance)
{
    const iso_policy *const policy = instance->plant.model->policy;
    period = instance->plant.model->period_ns;
    reported = instance->reported;
    if (policy != NULL) {
        memcpy(policy->counts, &instance->policy, policy->count * sizeof(uint64_t));
    }
}

static void leave(iso_instance *const instance)
{
    const iso_policy *const policy = instance->plant.model->policy;
    instance->reported = reported;
    if (policy != NULL) {
        memcpy(&instance->policy, policy->counts, policy->count * sizeof(uint64_t));
    }
}

const real *iso_instance_open(iso_instance *const instance)
{
    const iso_plant *const from = &iso_the_plant;
    unsigned char *const memory = (unsigned char *)instance + whole_words(sizeof *instance);
    unsigned char *const before = memory + whole_words(from->model->memory_bytes);
    *instance = (iso_instance){
        .plant = {.model = from->model,
                  .memory = memory,
                  .x = placed(from->x, memory),
                  .u = placed(from->u, memory),
                  .p = placed(from->p, memory),
                  .y = placed(from->y, memory),
                  .progress = placed(from->progress, memory),
                  .nearness = placed(from->nearness, memory),
                  .event_counts = placed(from->event_counts, memory),
                  .adams = placed(from->adams, memory),
                  .before = from->before == NULL ? NULL : before,
                  .good = placed(from->good, memory)},
        .control = {.loop = &instance->loop,
                    .snapshot = before + before_bytes(),
                    .snapshot_bytes = ISO_SNAPSHOT_BYTES(from->model->memory_bytes),
                    .identity = iso_instance_identity,
                    .hash = ISO_HASH_START},
    };
    enter(instance);
    if (from->model->policy != NULL) {
        iso_policy_reset(from->model->policy);
    }
    iso_loop_start(&instance->loop, &instance->plant);
    leave(instance);
    return iso_self_check() ? instance->plant.y : NULL;
}

/* A run from tick 0, where the plant is. */
static void set_out(iso_instance *const instance)
{
    instance->control.hash = ISO_HASH_START;
    instance->wire.inputs = 0;
    instance->running = true;
}

void iso_instance_start(iso_instance *const instance, const uint64_t ticks)
{
    enter(instance);
    iso_loop_restart(&instance->loop);
    iso_control_run(&instance->control, 0);
    leave(instance);
    instance->ticks = ticks;
    set_out(instance);
}

void iso_instance_stop(iso_instance *const instance)
{
    instance->running = false;
    instance->ended = true;
}

bool iso_instance_runs(const iso_instance *const instance)
{
    return instance->running;
}

/* --- Steps ------------------------------------------------------------------------------------------------------- */

/* The inputs of a step: all of them; or, where that is NULL, a row of columns. */
typedef struct given {
    const real *all;
    const iso_column *columns;
    uint64_t row;
} given;

static void set_inputs(const iso_instance *const instance, const given *const g)
{
    for (size_t i = 0; i < iso_instance_wires; i++) {
        real *const input = &instance->plant.u[iso_instance_inputs[i]];
        if (g->all != NULL) {
            *input = g->all[i];
        } else if (g->columns[i].values != NULL) {
            *input = g->columns[i].values[g->row * g->columns[i].stride];
        }
    }
}

/* Makes the step from a tick. Returns whether the plant is good behind it. */
static bool make_step(iso_instance *const instance, const given *const g)
{
    const iso_plant *const plant = &instance->plant;
    iso_loop_begin(&instance->loop);
    set_inputs(instance, g);
    instance->wire.inputs++;
    const bool goes_on = iso_loop_end(&instance->loop);
    const bool is_good = instance->loop.guard == plant->model->states;
    if (is_good) {
        iso_control_done(&instance->control, iso_hash_reals(instance->control.hash, plant->x, plant->model->states));
    }
    if (!goes_on || (instance->ticks > 0 && instance->loop.tick >= instance->ticks)) {
        iso_instance_stop(instance);
    }
    return is_good;
}

static iso_inside_outcome step_of(iso_instance *const instance, const given *const g)
{
    if (!instance->running) {
        return instance->ended ? ISO_INSIDE_OVER : ISO_INSIDE_NO_RUN;
    }
    if (iso_control_is_resting(&instance->control)) {
        return ISO_INSIDE_RESTS;
    }
    if (!make_step(instance, g)) {
        return ISO_INSIDE_OVER;
    }
    return instance->running ? ISO_INSIDE_STEPPED : ISO_INSIDE_STEPPED_LAST;
}

iso_inside_outcome iso_instance_step(iso_instance *const instance, const iso_column *const columns)
{
    enter(instance);
    const iso_inside_outcome outcome = step_of(instance, &(given){.columns = columns});
    leave(instance);
    return outcome;
}

static void take_row(const iso_instance *const instance, real *const rows, const uint64_t room, const uint64_t row)
{
    for (size_t i = 0; i < instance->plant.model->outputs; i++) {
        rows[i * room + row] = instance->plant.y[i];
    }
}

uint64_t iso_instance_record(iso_instance *const instance, const uint64_t ticks, const iso_column *const columns,
                             real *const rows, const uint64_t room, iso_inside_outcome *const outcome)
{
    uint64_t done = 0;
    enter(instance);
    take_row(instance, rows, room, 0);
    *outcome = ISO_INSIDE_STEPPED;
    while (done < ticks && *outcome == ISO_INSIDE_STEPPED) {
        *outcome = step_of(instance, &(given){.columns = columns, .row = done});
        if (*outcome <= ISO_INSIDE_STEPPED_LAST) {
            done++;
            take_row(instance, rows, room, done);
        }
    }
    leave(instance);
    return done;
}

/* --- Commands ---------------------------------------------------------------------------------------------------- */

const uint8_t *iso_instance_ask(iso_instance *const instance, const uint8_t *const payload, const size_t length,
                                size_t *const answered)
{
    iso_control *const control = &instance->control;
    enter(instance);
    const iso_command_outcome outcome =
        iso_command_do(&instance->commands, control, instance->running, payload, length);
    leave(instance);
    if (outcome == ISO_COMMAND_UNKNOWN) {
        return NULL;
    }
    if (outcome == ISO_COMMAND_ANEW) {
        set_out(instance);
    } else if (outcome == ISO_COMMAND_WENT_ON) {
        instance->running = true;
    }
    iso_frame_writer w = iso_frame_begin(instance->answer, ISO_LINK_ANSWER);
    const size_t head = w.used;
    iso_command_put_answer(&instance->commands, control, &instance->wire, instance->running, payload, &w);
    *answered = w.used - head;
    return instance->answer + head;
}

/* --- For a controller in C --------------------------------------------------------------------------------------- */

static const void *open_inside(void *const plant)
{
    return iso_instance_open(plant);
}

static void start_inside(void *const plant, const uint64_t ticks)
{
    iso_instance_start(plant, ticks);
}

static iso_inside_outcome step_inside(void *const plant, const void *const inputs)
{
    iso_instance *const instance = plant;
    enter(instance);
    const iso_inside_outcome outcome = step_of(instance, &(given){.all = inputs});
    leave(instance);
    return outcome;
}

static void stop_inside(void *const plant)
{
    iso_instance_stop(plant);
}

static bool runs_inside(const void *const plant)
{
    return iso_instance_runs(plant);
}

static const uint8_t *ask_inside(void *const plant, const uint8_t *const payload, const size_t length,
                                 size_t *const answered)
{
    return iso_instance_ask(plant, payload, length, answered);
}

const iso_inside iso_the_inside = {
    .identity = &iso_instance_identity,
    .bytes = iso_instance_bytes,
    .open = open_inside,
    .start = start_inside,
    .step = step_inside,
    .stop = stop_inside,
    .runs = runs_inside,
    .ask = ask_inside,
};
