/* Two plants of --standalone --name in a program whose flags are a stranger's: writes the hash of both after so many
 * ticks, or `refused` where a start says no. With -DIGNORES the answer of the start is not looked at, as by a careless
 * program; with -DFLUSHES a Cortex-M sets denormals to zero before. */
#include "heavy.h"
#include "rods.h"

#include "core/runtime/tick.h"
#include "hash.h"

#include <stddef.h>

/* Of the port, which is compiled with the project's flags. */
void iso_port_write(const void *bytes, size_t count);
_Noreturn void iso_port_exit(int status);

enum { TICKS = 200, DIGITS = 16 };

static uint64_t moved(const iso_plant *const plant, const uint64_t hash)
{
    uint64_t result = hash;
#ifdef IGNORES
    (void)iso_plant_start(plant);
#else
    if (!iso_plant_start(plant)) {
        return 0;
    }
#endif
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        if (iso_plant_tick(plant, tick) != plant->model->states) {
            return 0;
        }
        result = iso_hash_reals(result, plant->x, plant->model->states);
    }
    return result;
}

int main(void)
{
#ifdef FLUSHES
    __asm__ volatile("vmsr fpscr, %0" ::"r"(UINT32_C(1) << 24)); /* FZ: denormals become zero */
#endif
    static heavy_memory heavy;
    static rods_memory rods;
    const iso_plant first = heavy_plant(&heavy), second = rods_plant(&rods);
    const uint64_t one = moved(&first, ISO_HASH_START);
    uint64_t hash = one == 0 ? 0 : moved(&second, one);
    char text[DIGITS + 1];
    for (int i = DIGITS - 1; i >= 0; i--) {
        text[i] = "0123456789abcdef"[hash & 15];
        hash >>= 4;
    }
    text[DIGITS] = '\n';
    if (one == 0) {
        iso_port_write("refused\n", 8);
    } else {
        iso_port_write(text, sizeof text);
    }
    iso_port_exit(0);
}
