/* A mechanism whose second plant eliminates its closures leg by leg, along a run of the first, which does not; the run
 * begins where a leg is stretched, and comes there again. The second rounds no more than ROOM times what the first
 * does. */
#include <float.h>

#include "tests/host/report.h"
#include "tests/isoc/dynamics/formulation/evaluation.h"

static const double ROOM = 4.0;

enum { STATES = 5000 };

int main(void)
{
    double x[STATES_MAX], exact[STATES_MAX], other[STATES_MAX];
    const size_t n = first_double.start(x);
    const bool same =
        second_double.start(other) == n && first_float.start(other) == n && second_float.start(other) == n;
    double in_double = 0.0, in_float = 0.0, in_first = 0.0;
    for (int place = 0; place < STATES && same; place++) {
        first_double.derivatives(exact, x);
        second_double.derivatives(other, x);
        in_double = fmax(in_double, difference(other, exact, n));
        in_first = fmax(in_first, error_in_float(&first_float, x, n));
        in_float = fmax(in_float, error_in_float(&second_float, x, n));
        first_double.step(x, 1);
    }
    const double limit = ROOM * in_first, fine_limit = limit * DBL_EPSILON / (double)FLT_EPSILON;
    report_ok(same, "all have %u states", (unsigned)n);
    report_ok(in_float <= limit, "in float the second is off by %.1e <= %.1e", in_float, limit);
    report_ok(in_double <= fine_limit, "in double they differ by %.1e <= %.1e", in_double, fine_limit);
    return report_done();
}
