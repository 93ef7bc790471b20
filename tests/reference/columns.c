/* Prints some outputs of a plant's own run, every hundredth step for 5 s, a line each.
 *
 *     columns NAME...
 */
#include <stdio.h>
#include <stdlib.h>

#include "tests/reference/named.h"

/* Which output is called so; exits where none is. */
static int known_output(const char *const wanted)
{
    const int found = find_output(wanted);
    if (found < 0) {
        fprintf(stderr, "no output is called %s\n", wanted);
        exit(EXIT_FAILURE);
    }
    return found;
}

int main(int count, char **arguments)
{
    enum { EVERY = 100 };
    const long steps = (long)(5.0 / (double)iso_the_plant.model->step_size + 0.5);
    iso_plant_start(&iso_the_plant);
    for (long n = 1; n <= steps; n++) {
        if (iso_the_plant.model->drive != NULL) {
            iso_the_plant.model->drive(iso_the_plant.memory, (uint32_t)n - 1U);
        }
        iso_the_plant.model->step(iso_the_plant.memory);
        if (n % EVERY == 0) {
            iso_the_plant.model->output(iso_the_plant.memory);
            for (int i = 1; i < count; i++) {
                printf("%.17g%c", (double)iso_the_plant.y[known_output(arguments[i])], i + 1 < count ? ' ' : '\n');
            }
        }
    }
    return EXIT_SUCCESS;
}
