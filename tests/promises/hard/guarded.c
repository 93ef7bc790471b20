/* A plant for the guard (tests/promises/hard/test_guard.py): a body of 1 kg that moves freely, and one on a bushing of
 * 1e8 N/m, undamped, that starts 1 mm aside. Each has a force, which an input switches on. Written by hand; method and
 * step by core/runtime/handwritten.h. The words in the variable FAULT of the environment say what goes wrong:
 *
 *     soft                               the bushing has 100 N/m
 *     not_a_number, infinite, enormous   after 100 ticks the force on the free body is that for good
 *     bushing                            not on the free body, but on the other one
 *     input                              not the force, but the input itself is that
 */
#define ISO_HAS_JACOBIAN
#include "core/methods/dense.h"
#include "core/runtime/handwritten.h"
#include <stdlib.h>
#include <string.h>

enum { FREE, BUSHING, FREE_SPEED, BUSHING_SPEED, STATES };
enum { FREE_FORCE, BUSHING_FORCE, INPUTS };
enum { FAULT_TICK = 100 };

ISO_PLANT_MEMORY(STATES, INPUTS, 0, STATES);

static const real start[STATES] = {[BUSHING] = R(0.001)};

static size_t fault_force;
static real stiffness, fault_value, fault_input;

static bool has_fault(const char *const word)
{
    const char *const words = getenv("FAULT");
    return words != NULL && strstr(words, word) != NULL;
}

static void read_faults(void)
{
    const real value = has_fault("not_a_number") ? iso_real_of(ISO_EXPONENT_BITS | 1)
                       : has_fault("infinite")   ? iso_real_of(ISO_EXPONENT_BITS)
                       : has_fault("enormous")   ? R(1e38)
                                                 : R(0.0);
    stiffness = has_fault("soft") ? R(100.0) : R(1e8);
    fault_force = has_fault("bushing") ? BUSHING_FORCE : FREE_FORCE;
    fault_value = has_fault("input") ? R(0.0) : value;
    fault_input = has_fault("input") ? value : R(1.0);
}

/* The force that an input switches on. */
static real force(const real on)
{
    return iso_select(iso_less(R(0.5), on), fault_value, R(0.0));
}

static void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                       const real *restrict const p)
{
    (void)p;
    dx[FREE] = x[FREE_SPEED];
    dx[BUSHING] = x[BUSHING_SPEED];
    dx[FREE_SPEED] = force(u[FREE_FORCE]);
    dx[BUSHING_SPEED] = force(u[BUSHING_FORCE]) - stiffness * x[BUSHING];
}

static void output(real *restrict const y, const real *restrict const x, const real *restrict const u,
                   const real *restrict const p)
{
    (void)u;
    (void)p;
    memcpy(y, x, STATES * sizeof *y);
}

static void drive(void *const instance, const uint64_t tick)
{
    plant_memory *const memory = instance;
    if (tick == 0) {
        read_faults();
    }
    memory->u[FREE_FORCE] = memory->u[BUSHING_FORCE] = R(0.0);
    if (tick >= FAULT_TICK) {
        memory->u[fault_force] = fault_input;
    }
}

/* 1 - hb J of each body by itself, so that a fault of one stays with it. */
static void factor(real *restrict const lu, const real *restrict const x, const real *restrict const u,
                   const real *restrict const p, const real hb)
{
    (void)x;
    (void)u;
    (void)p;
    for (size_t body = 0; body < 2; body++) {
        real *const a = lu + 4 * body;
        a[0] = a[3] = R(0.0);
        a[1] = R(1.0);
        a[2] = body == 0 ? R(0.0) : -stiffness;
        iso_dense_factor(a, 2, hb);
    }
}

static void solve(real *restrict const d, const real *restrict const lu)
{
    for (size_t body = 0; body < 2; body++) {
        real part[2] = {d[body], d[2 + body]};
        iso_dense_solve(part, lu + 4 * body, 2);
        d[body] = part[0];
        d[2 + body] = part[1];
    }
}

static const iso_equations equations = {derivative, factor, solve, .factors = 8};

ISO_PLANT(STATES, INPUTS, 0, STATES, .name = "guarded", .state_names = "free,bushing,free_speed,bushing_speed",
          .output_names = "free,bushing,free_speed,bushing_speed", .drive = drive);
