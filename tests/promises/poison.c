/* Under memcheck: steps of every plant with all of its memory marked undefined. Any branch, loop count or address that
 * depends on state, history, input or parameter is an error that memcheck counts. Many plants stand in one program,
 * since memcheck takes longer to start than a plant to run.
 */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <valgrind/memcheck.h>

#include "core/methods/all.h"
#include "core/methods/method.h"
#include "core/runtime/tick.h"
#include "tests/promises/poison.h"

enum { STEPS = 2 };

static int tests, failures;

static void ok(const bool passed, const char *const name, const char *const text)
{
    tests++;
    failures += passed ? 0 : 1;
    printf("%sok %d - %s: %s\n", passed ? "" : "not ", tests, name, text);
}

/* Whether any bit of x is marked undefined. */
static bool is_poisoned(const real *const x)
{
    iso_bits undefined = 0;
    return VALGRIND_GET_VBITS(x, &undefined, sizeof undefined) == 1 && undefined != 0;
}

/* Where a plant has the number of its row in its memory; its size where nowhere. */
static size_t row_of(const iso_plant *const plant)
{
    const uint64_t tick = UINT64_C(0x0123456789ABCD);
    const unsigned char *const memory = plant->memory;
    size_t at = 0;
    iso_plant_drive(plant, tick);
    while (at + sizeof tick <= plant->model->memory_bytes && memcmp(memory + at, &tick, sizeof tick) != 0) {
        at += sizeof tick;
    }
    return at + sizeof tick <= plant->model->memory_bytes ? at : plant->model->memory_bytes;
}

/* Marks all memory of a plant but the number of its row, which is no data. */
static void poison(const iso_plant *const plant, const size_t row)
{
    const size_t bytes = plant->model->memory_bytes;
    VALGRIND_MAKE_MEM_UNDEFINED(plant->memory, bytes);
    if (row < bytes) {
        VALGRIND_MAKE_MEM_DEFINED((unsigned char *)plant->memory + row, sizeof(uint64_t));
    }
}

static void examine(const iso_plant *const plant, const char *const name)
{
    const size_t row = row_of(plant);
    iso_plant_start(plant);

    const unsigned long before = VALGRIND_COUNT_ERRORS;
    poison(plant, row);
    for (int i = 0; i < STEPS; i++) {
        if (plant->model->amiss != NULL) { /* iso_plant_admit branches on what it returns, and on nothing else */
            (void)plant->model->amiss(plant->memory);
        }
        if (plant->model->admit != NULL) {
            (void)plant->model->admit(plant->memory);
        }
        plant->model->step(plant->memory);
    }
    const unsigned long after_step = VALGRIND_COUNT_ERRORS;
    bool poisoned = RUNNING_ON_VALGRIND != 0;
    for (uint16_t i = 0; i < plant->model->states; i++) {
        poisoned = poisoned && is_poisoned(plant->x + i);
    }
    /* The tick is no data, nor what it sets; all that is held is. */
    iso_plant_drive(plant, STEPS);
    VALGRIND_MAKE_MEM_UNDEFINED(plant->u, (plant->model->inputs + (size_t)plant->model->memories) * sizeof *plant->u);
    if (plant->model->advance != NULL) {
        plant->model->advance(plant->memory);
    }
    plant->model->output(plant->memory);
    (void)iso_any_beyond(plant->x, plant->model->range, plant->model->states);
    (void)iso_any_beyond(plant->y, NULL, plant->model->outputs);
    const unsigned long after_output = VALGRIND_COUNT_ERRORS;
    VALGRIND_MAKE_MEM_DEFINED(plant->memory, plant->model->memory_bytes);

    ok(poisoned, name, "memcheck watches, and the marks reach every state");
    ok(after_step == before, name, "a step does not depend on data");
    ok(after_output == after_step, name, "nor do the memories and the outputs");
}

int main(void)
{
    for (const poison_case *c = poison_cases; c->name != NULL; c++) {
        examine(c->plant, c->name);
    }
    printf("1..%d\n", tests);
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
