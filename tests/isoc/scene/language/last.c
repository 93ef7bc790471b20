/* Prints outputs of a plant's own run, after so many steps.
 *
 *     last STEPS NAME...
 */
#include <stdio.h>
#include <stdlib.h>

#include "tests/reference/named.h"

int main(int count, char **arguments)
{
    const long steps = count > 1 ? strtol(arguments[1], NULL, 10) : 0;
    iso_plant_start(&iso_the_plant);
    for (long n = 0; n < steps; n++) {
        iso_the_plant.model->step(iso_the_plant.memory);
    }
    iso_the_plant.model->output(iso_the_plant.memory);
    for (int i = 2; i < count; i++) {
        const int found = find_output(arguments[i]);
        if (found < 0) {
            fprintf(stderr, "no output is called %s\n", arguments[i]);
            return EXIT_FAILURE;
        }
        printf("%.17g%c", (double)iso_the_plant.y[found], i + 1 < count ? ' ' : '\n');
    }
    return EXIT_SUCCESS;
}
