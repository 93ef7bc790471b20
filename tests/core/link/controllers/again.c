/* A controller that ends its run, makes the same one again, and then a free one of a plant whose time is virtual, which
 * is far ahead of every answer. */
#include "cart_pole_link.h"
#include "tests/core/link/controllers/law.h"

static cart_pole_link plant;

/* So many exchanges of a run in lockstep that has no end; returns its hash, 0 if something failed. */
static uint64_t run(const int exchanges)
{
    bool good = cart_pole_start(&plant, ISO_CLIENT_LOCKSTEP, 0) && plant.client.tick == 0;
    for (int i = 0; i < exchanges && good; i++) {
        plant.u[CART_POLE_U_FORCE] = LAW(plant.y);
        good = cart_pole_exchange(&plant);
    }
    good = good && cart_pole_stop(&plant) && plant.client.over;
    return good && plant.client.end.ticks == (uint64_t)exchanges ? plant.client.end.hash : 0;
}

int main(void)
{
    enum { TICKS = 20000 };
    bool good = cart_pole_open(&plant, NULL);
    const uint64_t once = good ? run(100) : 0, again = good ? run(100) : 0;
    uint64_t last = 0;
    good = once != 0 && once == again && cart_pole_start(&plant, ISO_CLIENT_FREE, TICKS);
    while (good) {
        last = plant.client.tick;
        good = cart_pole_exchange(&plant) && plant.client.tick > last;
    }
    const iso_client_end *const end = &plant.client.end;
    good = plant.client.over && end->ticks == TICKS && end->link_inputs > 0 &&
           end->link_inputs + end->link_missing >= TICKS && end->link_damaged + end->link_refused == 0;
    printf("%016llx %016llx: %s%s\n", (unsigned long long)once, (unsigned long long)again, good ? "good" : "bad ",
           plant.client.problem);
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
