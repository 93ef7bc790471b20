/* A sine drives a stable plant until what it started with has decayed; then the gain is fitted over whole periods:
 * decay BODE INPUT OUTPUT WAIT, where BODE has what `linear bode` printed, INPUT and OUTPUT are numbers, and WAIT is
 * in seconds. Prints the largest difference from the model, as a part of the gain, at the frequencies of the plant's
 * sines.
 *
 * The plant stands at the point that is read from standard input: x, u, p, each with its count. */
#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/runtime/tick.h"

enum { MOST = 64, STEPS = 400, FEWEST = 100 };

static const double tau = 6.28318530717958647692, amplitude = 1e-4;

static const iso_plant *const plant = &iso_the_plant;

static void read_numbers(double *const to)
{
    int count = 0;
    if (scanf(" %*s %d", &count) == 1) {
        for (int i = 0; i < count; i++) {
            (void)!scanf("%lf", &to[i]);
        }
    }
}

/* Kutta's method of order four; the sine goes on within the step. */
static void step(double *const x, const double *const u0, const int input, const double w, const double t,
                 const double h)
{
    static const double at[] = {0.0, 0.5, 0.5, 1.0}, weight[] = {1.0, 2.0, 2.0, 1.0};
    double u[MOST], y[MOST], slope[MOST] = {0.0}, sum[MOST] = {0.0};
    const int n = plant->model->states;
    memcpy(u, u0, sizeof u);
    for (int stage = 0; stage < 4; stage++) {
        for (int i = 0; i < n; i++) {
            y[i] = x[i] + h * at[stage] * slope[i];
        }
        u[input] = u0[input] + amplitude * sin(w * (t + h * at[stage]));
        iso_the_derivative(slope, y, u, plant->p);
        for (int i = 0; i < n; i++) {
            sum[i] += weight[stage] * slope[i];
        }
    }
    for (int i = 0; i < n; i++) {
        x[i] += h / 6.0 * sum[i];
    }
}

static double complex measure(const double *const x0, const double *const u0, const int input, const int output,
                              const double w, const double wait)
{
    double x[MOST];
    const int periods = 2 + (int)(wait * w / tau);
    const double longest = 1e-4, period = tau / w;
    const int steps = (int)fmax(STEPS, ceil(period / longest));
    double complex sum = 0.0;
    memcpy(x, x0, sizeof x);
    for (int i = 0; i < steps * periods; i++) {
        const double t = period / steps * i;
        if (i >= steps * (periods - 1)) {
            memcpy(plant->x, x, plant->model->states * sizeof *plant->x);
            plant->model->output(plant->memory);
            sum += plant->y[output] * cexp(-(double complex)_Complex_I * w * t);
        }
        step(x, u0, input, w, t, period / steps);
    }
    return 2.0 * (double complex)_Complex_I * sum / (steps * amplitude);
}

int main(const int argc, char **const argv)
{
    double x[MOST], u[MOST], p[MOST], frequency, gain, phase, largest = -1.0;
    char from[8], line[256];
    FILE *const bode = argc == 5 ? fopen(argv[1], "r") : NULL;
    if (bode == NULL) {
        return EXIT_FAILURE;
    }
    iso_plant_start(plant);
    read_numbers(x);
    read_numbers(u);
    read_numbers(p);
    double complex model[512];
    double frequencies[512];
    int count = 0;
    while (fgets(line, sizeof line, bode) != NULL) {
        if (sscanf(line, "%7s %lf %lf %lf", from, &frequency, &gain, &phase) != 4) {
            continue;
        }
        const double complex g = gain * cexp((double complex)_Complex_I * phase * tau / 360.0);
        if (strcmp(from, "model") == 0 && count < 512) {
            frequencies[count] = frequency;
            model[count++] = g;
        }
    }
    fclose(bode);
    /* Every fiftieth frequency of the model. */
    for (int i = 60; i < count - 20; i += 40) {
        const double complex g =
            measure(x, u, atoi(argv[2]), atoi(argv[3]), tau * frequencies[i], strtod(argv[4], NULL));
        largest = fmax(largest, cabs(g - model[i]) / cabs(model[i]));
        printf("# %.4g Hz: %.6g, model %.6g\n", frequencies[i], cabs(g), cabs(model[i]));
    }
    printf("%.3g\n", largest);
    return largest >= 0.0 && largest < 0.01 ? EXIT_SUCCESS : EXIT_FAILURE;
}
