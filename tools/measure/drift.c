/* How far closed loops come apart: runs a plant from its start and prints, for each part of the time, the largest
 * violation.
 *
 *     drift SECONDS PARTS STABILISATION TRUNCATION
 *
 * The plant's last three outputs are the violation, its rate and the energy. Lines: `part TIME VIOLATION`, then `end
 * TIME`, where TIME is less than SECONDS if a state left the finite numbers; `violation`, `rate`, `energy`: the
 * largest, and the largest change; `bound`: the largest violation that rounding and truncation explain.
 *
 * The bound. With u the unit roundoff, and Phi_i and Phi'_i the derivatives of a closure's equation and of its rate by
 * the state x_i, a step may be off by
 *
 *     q = sum |Phi_i| s_i                  in the position: s_i = u (|x_i| + 16 h |x_i'|), by rounding
 *     v = sum |Phi'_i| s_i                 in the speed
 *     p = sum |Phi_i| 4 u max(1, |x_i|)    in the computed Phi: a sine has 1.6 u, products and sums the rest
 *
 * Projection, that of the augmented Lagrangian too, leaves p by its computed Phi and q by rounding its result, and the
 * output adds p again: q + 2 p. Baumgarte's e'' + 2 b e' + b^2 e = 0 answers to q with q (1 + b t) exp(-b t), and to v
 * with v t exp(-b t): summed over all steps 2 q / (b h) and v / (b^2 h), at b = 0.1 / h 20 q and 100 h v; it follows p
 * as well. This is the worst case, all errors of one sign; random ones give about a tenth. To it comes TRUNCATION,
 * which is the method's: the violation of the same plant in double.
 */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/runtime/plant.h"

enum {
    OUTPUTS = 3,
    STATES_MAX = 256,
    EVERY = 101, /* steps from one look at the sizes to the next: a prime, so as to meet all phases */
};

static const iso_plant *const plant = &iso_the_plant;

typedef struct sizes {
    double position, speed, look;
} sizes;

static double output(const int which)
{
    return (double)plant->y[plant->model->outputs - OUTPUTS + which];
}

static void look(void)
{
    plant->model->output(plant->memory);
}

/* The errors of a step here; each keeps the largest. The derivatives are differences, good to a part in 1000. */
static void measure(sizes *const s)
{
    const double by = 0x1p-10, u = sizeof(real) == sizeof(float) ? 0.5 * (double)FLT_EPSILON : 0.5 * DBL_EPSILON;
    static real derivatives[STATES_MAX];
    sizes here = {0.0, 0.0, 0.0};
    iso_the_derivative(derivatives, plant->x, plant->u, plant->p);
    for (int i = 0; i < plant->model->states; i++) {
        const real kept = plant->x[i];
        const double size = fabs((double)kept);
        const double off = u * (size + 16.0 * (double)plant->model->step_size * fabs((double)derivatives[i]));
        plant->x[i] = kept + (real)by;
        look();
        plant->x[i] = kept;
        here.position += output(0) / by * off;
        here.speed += output(1) / by * off;
        here.look += output(0) / by * 4.0 * u * fmax(1.0, size);
    }
    look(); /* the states are those of the run again */
    s->position = fmax(s->position, here.position);
    s->speed = fmax(s->speed, here.speed);
    s->look = fmax(s->look, here.look);
}

static double bound(const sizes *const s, const char *const stabilisation, const double truncation)
{
    if (strcmp(stabilisation, "none") == 0) {
        return (double)INFINITY;
    }
    if (strcmp(stabilisation, "baumgarte") != 0) {
        return truncation + s->position + 2.0 * s->look;
    }
    return truncation + 20.0 * s->position + 100.0 * (double)plant->model->step_size * s->speed + 2.0 * s->look;
}

/* The largest so far. */
typedef struct statistics {
    long done; /* steps */
    double violation, rate, change;
    sizes sizes;
} statistics;

/* Runs until the steps are done or a state is not finite; a line for each part. */
static statistics run(const long steps, const long parts, const double step)
{
    statistics a = {0};
    double of_part = 0.0;
    iso_plant_start(plant);
    look();
    const double energy = output(2);
    for (long part = 1; a.done < steps; a.done++) {
        iso_plant_drive(plant, (uint64_t)a.done);
        plant->model->step(plant->memory);
        look();
        if (!isfinite(output(0)) || !isfinite(output(2))) {
            break;
        }
        of_part = fmax(of_part, output(0));
        a.violation = fmax(a.violation, output(0));
        a.rate = fmax(a.rate, output(1));
        a.change = fmax(a.change, fabs(output(2) - energy));
        if (a.done % EVERY == 0) {
            measure(&a.sizes);
        }
        if (a.done + 1 == steps * part / parts) {
            printf("part %.9g %.3e\n", (double)(a.done + 1) * step, of_part);
            of_part = 0.0;
            part++;
        }
    }
    return a;
}

int main(const int argc, char **const argv)
{
    if (argc != 5 || plant->model->states > STATES_MAX) {
        fputs("usage: drift SECONDS PARTS STABILISATION TRUNCATION, of a plant of at most 256 states\n", stderr);
        return EXIT_FAILURE;
    }
    const double step = (double)plant->model->period_ns * 1e-9;
    const statistics a = run(lround(strtod(argv[1], NULL) / step), strtol(argv[2], NULL, 10), step);
    printf("end %.9g\nviolation %.3e\nrate %.3e\nenergy %.3e\n", (double)a.done * step, a.violation, a.rate, a.change);
    printf("bound %.3e\n", bound(&a.sizes, argv[3], strtod(argv[4], NULL)));
    return EXIT_SUCCESS;
}
