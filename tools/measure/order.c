/* The order that the method of a scene has with a stabilisation: three plants of it in double, with steps of 4 h, 2 h
 * and h, from their start through SECONDS.
 *
 *     order SECONDS
 *
 * An error C h^p differs by C h^p (4^p - 2^p) between the first two and by C h^p (2^p - 1) between the last two: 2^p
 * times less. Prints `order`, of the root of the sums of squares over all states and all ticks that the three have in
 * common.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "coarse.h"
#include "fine.h"
#include "middle.h"

/* The square of the distance of two states; angles that were counted down to a turn may be a turn apart. */
static double square(const iso_plant *const a, const iso_plant *const b)
{
    double sum = 0.0;
    for (int i = 0; i < a->model->states; i++) {
        const double apart = (double)a->x[i] - (double)b->x[i];
        const double off = fabs(apart) > 6.0 ? remainder(apart, 8.0 * atan(1.0)) : apart;
        sum += off * off;
    }
    return sum;
}

int main(const int argc, char **const argv)
{
    static coarse_memory of_coarse;
    static middle_memory of_middle;
    static fine_memory of_fine;
    const iso_plant plants[] = {coarse_plant(&of_coarse), middle_plant(&of_middle), fine_plant(&of_fine)};
    enum { PLANTS = sizeof plants / sizeof *plants };
    double sums[PLANTS - 1] = {0.0};
    if (argc != 2) {
        fputs("usage: order SECONDS\n", stderr);
        return EXIT_FAILURE;
    }
    for (int k = 0; k < PLANTS; k++) {
        iso_plant_start(&plants[k]);
    }
    const long steps = lround(strtod(argv[1], NULL) / ((double)plants[0].model->period_ns * 1e-9));
    for (long i = 0; i < steps; i++) {
        for (int k = 0; k < PLANTS; k++) {
            for (long tick = i << k; tick < (i + 1) << k; tick++) {
                iso_plant_drive(&plants[k], (uint64_t)tick);
                plants[k].model->step(plants[k].memory);
            }
        }
        for (int k = 0; k + 1 < PLANTS; k++) {
            sums[k] += square(&plants[k], &plants[k + 1]);
        }
    }
    printf("order %.2f\n", 0.5 * log2(sums[0] / sums[1]));
    return EXIT_SUCCESS;
}
