/* A mechanism whose second plant eliminates its closures leg by leg, along a run of the first, which does not, from a
 * stretched leg on. There the second divides by what is nearly nothing; it is off by a part of sqrt(u) at most, with
 * the unit roundoff u, and a factor of ROOM for the condition of the rest. */
#include <float.h>

#include "tests/formulation/evaluation.h"
#include "tests/host/report.h"

static const double ROOM = 16.0;

enum { STATES = 5000 };

int main(void)
{
    double x[STATES_MAX], others[STATES_MAX];
    const size_t n = first_double.start(x);
    const bool same = second_double.start(others) == n && second_float.start(others) == n;
    double in_double = 0.0, in_float = 0.0, least = HUGE_VAL;
    for (int place = 0; place < STATES && same; place++) {
        double exact[STATES_MAX], other[STATES_MAX];
        for (size_t i = 0; i < n; i++) {
            others[i] = (double)(float)x[i];
        }
        first_double.derivatives(exact, x);
        second_double.derivatives(other, x);
        in_double = fmax(in_double, difference(other, exact, n));
        least = fmin(least, difference(other, exact, n));
        first_double.derivatives(exact, others);
        second_float.derivatives(other, others);
        in_float = fmax(in_float, difference(other, exact, n));
        first_double.step(x, 1);
    }
    report_ok(same, "both have %u states", (unsigned)n);
    report_ok(in_double <= ROOM * sqrt(0.5 * DBL_EPSILON), "in double it is off by %.1e at most", in_double);
    report_ok(in_float <= ROOM * sqrt(0.5 * (double)FLT_EPSILON), "in float it is off by %.1e at most", in_float);
    report_ok(in_double > 1e4 * least, "the leg is stretched on the way: elsewhere it is off by %.1e in double", least);
    return report_done();
}
