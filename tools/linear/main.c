/* Runs and drives a plant for `isochron linear`; compiled with the plant, in double.
 *
 *     linear reach NANOSECONDS               the state, inputs and tunables in the last tick until then
 *     linear bode POINT 'INPUT to OUTPUT'    gain and phase over the frequency, of the model in POINT, which isoc
 * wrote, and at five frequencies as measured on the plant
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/runtime/tick.h"
#include "tools/file/file.h"
#include "tools/linear/linear.h"

enum { POINTS = 241, MEASURED = 5 };

static const double tau = 6.28318530717958647692, half_turn = 180.0;

static const iso_plant *const plant = &iso_the_plant;

static void put_line(const char *const word, const real *const all, const int count)
{
    printf("%s %d", word, count);
    for (int i = 0; i < count; i++) {
        printf(" %.17g", (double)all[i]);
    }
    printf("\n");
}

/* Returns whether the plant did so many ticks. */
static bool reach(const uint64_t ticks)
{
    const iso_model *const m = plant->model;
    iso_plant_start(plant);
    (void)iso_plant_output(plant);
    for (uint64_t tick = 0; tick < ticks; tick++) {
        if (iso_plant_tick(plant, tick) < m->states) {
            fprintf(stderr, "linear: the guard ends the run at tick %llu\n", (unsigned long long)tick + 1);
            return false;
        }
    }
    iso_plant_drive(plant, ticks);
    put_line("x", plant->x, m->states);
    put_line("u", plant->u, m->inputs + m->memories);
    put_line("p", plant->p, m->parameters);
    return true;
}

static int find(const labels *const all, const char *const name, const size_t length, const char *const sort)
{
    for (int i = 0; i < all->count; i++) {
        if (strlen(all->names[i]) == length && strncmp(all->names[i], name, length) == 0) {
            return i;
        }
    }
    fprintf(stderr, "linear: no %s is called '%.*s'; there is", sort, (int)length, name);
    for (int i = 0; i < all->count; i++) {
        fprintf(stderr, " %s", all->names[i]);
    }
    fprintf(stderr, all->count == 0 ? " none\n" : "\n");
    exit(EXIT_FAILURE);
}

/* Degrees, nearest to those before. */
static double phase_of(const double complex g, const double before)
{
    const double phase = carg(g) * half_turn / (0.5 * tau);
    return phase + 2.0 * half_turn * round((before - phase) / (2.0 * half_turn));
}

/* Frequencies and phases of the model, from low to high. */
typedef struct curve {
    double w[POINTS], phase[POINTS];
} curve;

static void put_model(const model *const m, const int input, const int output, const double low, const double high,
                      curve *const to)
{
    for (int i = 0; i < POINTS; i++) {
        to->w[i] = low * pow(high / low, (double)i / (POINTS - 1));
        const double complex g = gain(m, input, output, to->w[i]);
        to->phase[i] = phase_of(g, i == 0 ? 0.0 : to->phase[i - 1]);
        printf("model\t%.9g\t%.9g\t%.9g\n", to->w[i] / tau, cabs(g), to->phase[i]);
    }
}

/* Writes the plant's gain at w, with a phase near the model's. Returns the relative difference; -1: none is found. */
static double put_measured(const model *const m, const int input, const int output, const double w,
                           const curve *const beside)
{
    const double complex g = gain(m, input, output, w);
    const measured found = measure(plant, m, input, output, w);
    if (!found.found) {
        return -1.0;
    }
    int nearest = 0;
    while (nearest + 1 < POINTS && beside->w[nearest + 1] <= w) {
        nearest++;
    }
    printf("plant\t%.9g\t%.9g\t%.9g\n", w / tau, cabs(found.gain), phase_of(found.gain, beside->phase[nearest]));
    return cabs(found.gain - g) / fmax(cabs(g), 1e-300);
}

static int bode(const char *const path, const char *const pair)
{
    const model m = model_read(path);
    const char *const between = strstr(pair, " to ");
    if (between == NULL) {
        quit("linear: '%s' is no pair; it could be 'force to pole'", pair);
    }
    const int input = find(&m.inputs, pair, (size_t)(between - pair), "input");
    const int output = find(&m.outputs, between + 4, strlen(between + 4), "output");
    const double fastest = m.fastest > 0.0 ? m.fastest : tau, slowest = m.slowest > 0.0 ? m.slowest : tau;
    const double high = 10.0 * fastest, low = fmax(0.1 * slowest, 1e-6 * high);
    const bool is_whole = strpbrk(m.inputs.units[input], "*/ ") == NULL;
    printf("from\tfrequency Hz\tgain %s/%s%s%s\tphase deg\n", m.outputs.units[output], is_whole ? "" : "(",
           m.inputs.units[input], is_whole ? "" : ")");
    curve shown;
    put_model(&m, input, output, low, high, &shown);
    if (!is_steady(&m)) {
        fputs("measured none: the plant is in no equilibrium here, so that no sine has a response of its own\n",
              stderr);
        return EXIT_SUCCESS;
    }
    const double from = fmax(0.3 * slowest, slowest_measured(&m)), to = fmax(3.0 * fastest, 2.0 * from);
    double largest = 0.0;
    int count = 0;
    for (int i = 0; i < MEASURED; i++) {
        const double apart = put_measured(&m, input, output, from * pow(to / from, (double)i / (MEASURED - 1)), &shown);
        largest = fmax(largest, apart);
        count += apart >= 0.0;
    }
    fprintf(stderr, "measured %d of %d sines from %.3g to %.3g Hz: the plant is within %.2g %% of the model\n", count,
            MEASURED, from / tau, to / tau, 100.0 * largest);
    return EXIT_SUCCESS;
}

int main(const int argc, char **const argv)
{
    if (argc == 3 && strcmp(argv[1], "reach") == 0) {
        return reach(strtoull(argv[2], NULL, 10) / plant->model->period_ns) ? EXIT_SUCCESS : EXIT_FAILURE;
    }
    if (argc == 4 && strcmp(argv[1], "bode") == 0) {
        return bode(argv[2], argv[3]);
    }
    fputs("usage: linear reach NANOSECONDS | linear bode POINT 'INPUT to OUTPUT'\n", stderr);
    return EXIT_FAILURE;
}
