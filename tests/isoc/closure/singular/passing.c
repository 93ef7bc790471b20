/* A loop without losses, in its own steps: its energy (its first output, J), and what the watch over singular positions
 * says.
 *
 *     passing SECONDS BOUND [EACH]
 *
 * prints: the largest change of the energy over that of the start, or `lost` where a state is not finite; ticks that
 * were told as near a singular position; the guard's last word: good, bad or near; and `within` or `beyond`, the change
 * compared with BOUND and EACH for each of these ticks. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/runtime/tick.h"

int main(const int count, char **const arguments)
{
    const iso_plant *const plant = &iso_the_plant;
    const double seconds = count > 2 ? strtod(arguments[1], NULL) : 0.0;
    const double bound = count > 2 ? strtod(arguments[2], NULL) : 0.0;
    const double each = count > 3 ? strtod(arguments[3], NULL) : 0.0;
    const uint64_t ticks = (uint64_t)llround(seconds * 1e9 / plant->model->period_ns);
    const uint16_t states = plant->model->states;
    iso_tick_counts counts = {.near_singular = 0};
    uint16_t guard = states;
    double most = 0.0;
    iso_plant_start(plant);
    (void)iso_plant_output(plant);
    const double start = (double)plant->y[0];
    for (uint64_t tick = 0; tick < ticks && guard == states; tick++) {
        guard = iso_plant_tick_counted(plant, tick, &counts);
        const double change = fabs((double)plant->y[0] / start - 1.0);
        most = change <= most ? most : change;
    }
    printf(guard < states ? "lost" : "%.1e", most);
    printf(" %llu %s %s\n", (unsigned long long)counts.near_singular,
           guard == states  ? "good"
           : guard < states ? "bad"
                            : "near",
           guard >= states && most <= bound + each * (double)counts.near_singular ? "within" : "beyond");
    return 0;
}
