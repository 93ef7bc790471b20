/* The trajectory of a ladder from plants of its methods, one handing its states to the other: the rung of each tick is
 * a line of standard input. Prints the hash. */
#include <inttypes.h>
#include <stdio.h>

#include "by_euler.h"
#include "by_heun.h"
#include "by_rk4.h"

#include "core/runtime/hash.h"
#include "core/runtime/tick.h"

int main(void)
{
    static by_rk4_memory of_rk4;
    static by_heun_memory of_heun;
    static by_euler_memory of_euler;
    const iso_plant plants[] = {by_rk4_plant(&of_rk4), by_heun_plant(&of_heun), by_euler_plant(&of_euler)};
    uint64_t hash = ISO_HASH_START;
    int rung = 0;
    for (int i = 0; i < 3; i++) {
        iso_plant_start(&plants[i]);
    }
    while (scanf("%d", &rung) == 1) {
        if (rung < 3) {
            plants[rung].model->step(plants[rung].memory);
            for (int i = 0; i < 3; i++) {
                memmove(plants[i].x, plants[rung].x, BY_RK4_STATES * sizeof *plants[i].x);
            }
        }
        hash = iso_hash_reals(hash, plants[0].x, BY_RK4_STATES);
    }
    printf("%016" PRIx64 "\n", hash);
    return 0;
}
