/* A controller over a link: 15 lines. Makes a run of so many ticks, with a patience of so many milliseconds, and prints
 * the hash of the run and the last angle of the pole. */
#include "cart_pole_link.h"
#include "tests/core/link/controllers/law.h"

int main(int count, char **arguments)
{
    static cart_pole_link plant;
    bool good = cart_pole_open(&plant, NULL);
    plant.client.patience_ms = count > 2 ? atoi(arguments[2]) : ISO_CLIENT_PATIENCE_MS;
    good = good && cart_pole_start(&plant, ISO_CLIENT_LOCKSTEP, count > 1 ? (uint64_t)atol(arguments[1]) : 0);
    while (good) {
        plant.u[CART_POLE_U_FORCE] = LAW(plant.y);
        good = cart_pole_exchange(&plant);
    }
    if (!plant.client.over) {
        fprintf(stderr, "%s\n", plant.client.problem);
        return EXIT_FAILURE;
    }
    printf("hash %016llx pole %.6g\n", (unsigned long long)plant.client.end.hash, (double)plant.y[CART_POLE_Y_POLE]);
    cart_pole_close(&plant);
    return EXIT_SUCCESS;
}
