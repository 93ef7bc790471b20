/* One mechanism in two formulations, each in float and in double: along a run they say the same, to rounding.
 *
 * How much the equations magnify rounding differs from scene to scene: a planar chain of 16 rods loses six times as
 * much by its mass matrix as by articulated bodies. What either says in float is off from what it says in double by
 * that times the roundings in float, as many as there are in double; so that in double the two may differ by as much
 * times the ratio of the roundings. Roundings of the two reals are not the same ones: at some states they happen to
 * cancel in float, for which the worst of all states stands, and a factor of ROOM.
 */
#include <float.h>
#include <math.h>

#include "tests/host/report.h"
#include "tests/isoc/dynamics/formulation/evaluation.h"

static const double ROOM = 8.0;
static const double single_epsilon = (double)FLT_EPSILON;

enum { PLACES = 50, STEPS_BETWEEN = 20 };

int main(void)
{
    double x[STATES_MAX], others[STATES_MAX];
    const size_t n = first_double.start(x);
    const bool same =
        second_double.start(others) == n && first_float.start(others) == n && second_float.start(others) == n;
    double apart = 0.0, in_first = single_epsilon, in_second = single_epsilon;
    for (int place = 0; place < PLACES && same; place++) {
        double first[STATES_MAX], second[STATES_MAX];
        first_double.step(x, STEPS_BETWEEN);
        first_double.derivatives(first, x);
        second_double.derivatives(second, x);
        apart = fmax(apart, difference(second, first, n));
        in_first = fmax(in_first, error_in_float(&first_float, x, n));
        in_second = fmax(in_second, error_in_float(&second_float, x, n));
    }
    const double limit = ROOM * (DBL_EPSILON / single_epsilon) * (in_first + in_second);
    report_ok(same, "all have %u states", (unsigned)n);
    report_note("in float the first is off by %.1e, the second by %.1e", in_first, in_second);
    report_ok(apart <= limit, "in double they differ by %.1e <= %.1e", apart, limit);
    return report_done();
}
