/* A free body that tumbles about its middle axis, rigid_body.scene, over a number of steps: how far its quaternion's
 * length goes from one in units in the last place, and the energy and the momentum in the ground's axes from where they
 * began.
 *
 *     tumble STEPS      prints: ulps, change of energy, change of momentum; the last two as parts of the whole
 */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/runtime/plant.h"

/* Where the orientation and the spin stand among the states: after the place, and after its speed. */
enum { ORIENTATION = 3, SPIN = 10 };

static const double inertia[3] = {1.0, 2.0, 3.0};

typedef struct invariants {
    double energy, momentum[3];
} invariants;

/* E = w.Jw / 2 and R J w, with the turn of a vector v by q: v + 2 q_v x (q_v x v + q_w v). */
static invariants now(void)
{
    const real *const q = iso_the_plant.x + ORIENTATION;
    const real *const w = iso_the_plant.x + SPIN;
    invariants made = {0};
    double body[3], cross[3];
    for (int i = 0; i < 3; i++) {
        body[i] = inertia[i] * (double)w[i];
        made.energy += 0.5 * body[i] * (double)w[i];
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        cross[i] = (double)q[1 + j] * body[k] - (double)q[1 + k] * body[j] + (double)q[0] * body[i];
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        made.momentum[i] = body[i] + 2.0 * ((double)q[1 + j] * cross[k] - (double)q[1 + k] * cross[j]);
    }
    return made;
}

static double norm(const double *const a)
{
    return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

static double length_error(void)
{
    const real *const q = iso_the_plant.x + ORIENTATION;
    double square = 0.0;
    for (int i = 0; i < 4; i++) {
        square += (double)q[i] * (double)q[i];
    }
    return fabs(sqrt(square) - 1.0);
}

int main(int count, char **arguments)
{
    const double ulp = sizeof(real) == sizeof(float) ? (double)FLT_EPSILON : DBL_EPSILON;
    const long steps = count > 1 ? strtol(arguments[1], NULL, 10) : 0;
    enum { EVERY = 16 };
    double length = 0.0, energy = 0.0, momentum = 0.0;
    iso_plant_start(&iso_the_plant);
    const invariants first = now();
    for (long n = 0; n < steps; n++) {
        iso_the_plant.model->step(iso_the_plant.memory);
        length = fmax(length, length_error());
        if (n % EVERY != 0) {
            continue;
        }
        const invariants after = now();
        double moved[3];
        for (int i = 0; i < 3; i++) {
            moved[i] = after.momentum[i] - first.momentum[i];
        }
        energy = fmax(energy, fabs(after.energy - first.energy));
        momentum = fmax(momentum, norm(moved));
    }
    printf("%.2f %.3e %.3e\n", length / ulp, energy / first.energy, momentum / norm(first.momentum));
    return steps > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
