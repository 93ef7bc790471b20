/* The outputs of all.scene, a row of its trace for each tick on the input, against the host's libm in double.
 *
 * The arguments are computed in real, as the plant does: angle and rate read back exactly. The tolerance is the bound
 * of the functions (core/numbers): 4 ulp of the result, for those that are sums of 1 and the result.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/tap.h"

enum { OUTPUTS = 30, FIRST_SUM = 21, LINE = 4096 };

static double sign(const double x)
{
    return (x > 0.0) - (x < 0.0);
}

/* Straight lines between the points. */
static double table(const double q, const double width)
{
    const double places[] = {-0.5, 0.0, 0.25, 1.0}, values[] = {-1.0, 0.25, width, 2.5};
    if (q <= places[0]) {
        return values[0];
    }
    for (int i = 1; i < 4; i++) {
        if (q <= places[i]) {
            const double part = (q - places[i - 1]) / (places[i] - places[i - 1]);
            return values[i - 1] + part * (values[i] - values[i - 1]);
        }
    }
    return values[3];
}

/* Where x is among the places: how many stretches lie before it, and what part of the next. */
static int stretch_of(const double x, const double places[3], double *const part)
{
    const int i = x < places[1] ? 0 : 1;
    *part = fmin(fmax((x - places[i]) / (places[i + 1] - places[i]), 0.0), 1.0);
    return i;
}

/* Bilinear in the cell of q and v. */
static double grid(const double q, const double v, const double width)
{
    const double columns[] = {-0.5, 0.25, 1.0}, rows[] = {-1.0, 0.0, 2.5};
    const double cells[3][3] = {{0.0, 1.0, 0.5}, {width, 2.0, -1.0}, {1.0, 0.0, 3.0}};
    double a, b;
    const int i = stretch_of(q, columns, &a), j = stretch_of(v, rows, &b);
    return (1.0 - b) * ((1.0 - a) * cells[j][i] + a * cells[j][i + 1]) +
           b * ((1.0 - a) * cells[j + 1][i] + a * cells[j + 1][i + 1]);
}

/* What each output is; q and v are those that the plant had. */
static void expect(const real q, const real v, double want[OUTPUTS])
{
    const real width = R(0.4), shifted = q * q + width, half = R(0.5) * q, low = R(-0.2), third = R(0.3);
    const real rest = (R(1.0) - half) * (R(1.0) + half), root = (real)sqrt((double)rest);
    const double all[OUTPUTS] = {
        (double)q,
        (double)v,
        sqrt((double)shifted),
        exp((double)v),
        log((double)shifted),
        tanh((double)(R(3.0) * v)),
        atan2((double)q, (double)v),
        atan2((double)half, (double)root),
        atan2((double)root, (double)-half),
        sign((double)v),
        floor((double)(R(10.0) * q)),
        nearbyint((double)(R(10.0) * q)),
        (double)(q < low     ? low
                 : q > width ? width
                             : q),
        (double)(q < v && q < third ? q
                 : v < third        ? v
                                    : third),
        (double)(q > v && q > -third ? q
                 : v > -third        ? v
                                     : -third),
        fabs((double)v),
        q<v, q <= v, q>
            v,
        q >= v,
        (double)(q * v > 0 ? q : R(2.0) * v),
        sin((double)q) + tan((double)q),
        fmax((double)q, 0.0) + fmin((double)v, 0.0),
        table((double)q, (double)width),
        grid((double)q, (double)v, (double)width),
        pow((double)shifted, (double)R(0.7)),
        1.0 / ((double)shifted * (double)shifted),
        atan((double)v),
        hypot((double)q, (double)v),
        (double)(q - third * (real)floor((double)(q / third))),
    };
    memcpy(want, all, sizeof all);
}

int main(void)
{
    static char line[LINE];
    double worst[OUTPUTS] = {0};
    uint32_t rows = 0, moved = 0;
    (void)!fgets(line, sizeof line, stdin); /* the names */
    while (fgets(line, sizeof line, stdin) != NULL) {
        double got[OUTPUTS + 1], want[OUTPUTS];
        char *at = line;
        for (int i = 0; i <= OUTPUTS; i++) {
            got[i] = strtod(at, &at);
            at += *at == ',';
        }
        expect((real)got[1], (real)got[2], want);
        for (int i = 0; i < OUTPUTS; i++) {
            const double scale = i >= FIRST_SUM ? 1.0 + fabs(want[i]) : fabs(want[i]);
            const double error = fabs(got[i + 1] - want[i]) / ((double)ISO_REAL_EPSILON * (scale + 1e-30));
            worst[i] = fmax(worst[i], error);
        }
        rows++;
        moved += got[2] < 0.0;
    }
    tap_ok(rows > 1000 && moved > 100 && moved < rows - 100, "the pendulum swings both ways");
    for (int i = 0; i < OUTPUTS; i++) {
        char name[80];
        snprintf(name, sizeof name, "output %d: %.2f ulp", i + 1, worst[i]);
        tap_ok(worst[i] <= 4.0, name);
    }
    tap_done();
}
