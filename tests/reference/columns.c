/* Prints some outputs of a plant's own run, every hundredth step for 5 s, a line each.
 *
 *     columns NAME...
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/plant.h"

/* Which output is called so; exits where none is. */
static int find_output(const char *const wanted)
{
    const char *at = iso_the_plant.output_names;
    for (int i = 0; i < iso_the_plant.outputs; i++) {
        const size_t length = strcspn(at, ",");
        if (length == strlen(wanted) && strncmp(at, wanted, length) == 0) {
            return i;
        }
        at += length + 1;
    }
    fprintf(stderr, "no output is called %s\n", wanted);
    exit(EXIT_FAILURE);
}

int main(int count, char **arguments)
{
    enum { EVERY = 100 };
    const long steps = (long)(5.0 / (double)iso_the_plant.step_size + 0.5);
    iso_plant_start(&iso_the_plant);
    for (long n = 1; n <= steps; n++) {
        if (iso_the_plant.drive != NULL) {
            iso_the_plant.drive((uint32_t)n - 1U);
        }
        iso_the_plant.step();
        if (n % EVERY == 0) {
            iso_the_plant.output(iso_the_plant.y, iso_the_plant.x, iso_the_plant.u, iso_the_plant.p);
            for (int i = 1; i < count; i++) {
                printf("%.17g%c", (double)iso_the_plant.y[find_output(arguments[i])], i + 1 < count ? ' ' : '\n');
            }
        }
    }
    return EXIT_SUCCESS;
}
