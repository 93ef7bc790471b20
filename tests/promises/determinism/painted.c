/* How deep the stack of a step goes: writes `painted N`, in bytes. The memory below the stack is painted; what a step
 * has written over is found. Where its stack begins tells a function that fills a frame of known size, CALIBRATION.
 * With -DDEEPER the step begins further down. */
#include "core/runtime/plant.h"
#include "port/port.h"

enum { SPAN = 6000, NEAR = 64, PAINT = 0xA5, CALIBRATION = 512 };

/* The lowest byte that `run` has written over, below an address in the frame of this function. */
__attribute__((noinline)) static uintptr_t lowest(void (*const run)(void *), void *const argument)
{
    const uintptr_t top = (uintptr_t)__builtin_frame_address(0);
    for (uintptr_t at = top - SPAN; at < top - NEAR; at++) {
        *(volatile uint8_t *)at = PAINT;
    }
    run(argument);
    uintptr_t at = top - SPAN;
    while (at < top - NEAR && *(volatile uint8_t *)at == PAINT) {
        at++;
    }
    return at;
}

/* A frame of CALIBRATION bytes and what a call and saved registers take beside it. */
__attribute__((noinline)) static void fill(void *const argument)
{
    volatile uint8_t *const bytes = __builtin_alloca(CALIBRATION);
    (void)argument;
    for (int i = 0; i < CALIBRATION; i++) {
        bytes[i] = 0;
    }
}

#ifdef DEEPER
__attribute__((noinline)) static void step(void *const memory)
{
    fill(memory);
    volatile uint8_t *const bytes = __builtin_alloca(CALIBRATION);
    bytes[0] = 0;
    iso_the_plant.model->step(memory);
    bytes[0] = 1;
}
#else
static void step(void *const memory)
{
    iso_the_plant.model->step(memory);
}
#endif

int main(void)
{
    const iso_plant *const plant = &iso_the_plant;
    (void)iso_plant_start(plant);
    const uintptr_t filled = lowest(fill, NULL), stepped = lowest(step, plant->memory);
    uint32_t depth = (uint32_t)(filled + CALIBRATION - stepped);
    char text[] = "painted 00000\n";
    for (int i = 12; i > 7; i--) {
        text[i] = (char)('0' + depth % 10);
        depth /= 10;
    }
    iso_port_write(text, sizeof text - 1);
    iso_port_exit(0);
}
