/* One mechanism by two ways to the factors of an implicit method, each in float and in double: along a run their steps
 * are the same, to rounding.
 *
 * Both solve the same equations. How far rounding sets them apart in double follows from how far it does in float: as
 * much times the ratio of the roundings. Where it happens to cancel there, each step rounds each state by half a unit
 * at least, and a factor of ROOM is for roundings that are others.
 */
#include <float.h>
#include <math.h>

#include "tests/host/report.h"
#include "tests/isoc/dynamics/formulation/evaluation.h"

static const double ROOM = 8.0;

enum { STEPS = 200 };

/* The largest difference of a state after the steps, over the largest state. */
static double apart(const evaluation *const a, const evaluation *const b)
{
    double x[STATES_MAX], y[STATES_MAX], most = 0.0, largest = 0.0;
    const size_t n = a->start(x);
    (void)b->start(y);
    a->step(x, STEPS);
    b->step(y, STEPS);
    for (size_t i = 0; i < n; i++) {
        most = fmax(most, fabs(x[i] - y[i]));
        largest = fmax(largest, fabs(x[i]));
    }
    return most / largest;
}

int main(void)
{
    double x[STATES_MAX], y[STATES_MAX];
    const size_t n = first_double.start(x);
    const double in_float = apart(&first_float, &second_float), in_double = apart(&first_double, &second_double);
    const double limit = ROOM * (DBL_EPSILON / (double)FLT_EPSILON) * fmax(in_float, STEPS * 0.5 * (double)FLT_EPSILON);
    report_ok(second_double.start(y) == n, "both have %u states", (unsigned)n);
    report_ok(in_double <= limit, "after %d steps they differ by %.1e <= %.1e, in float by %.1e", (int)STEPS, in_double,
              limit, in_float);
    /* Control: a state that is off by the limit a few times over. */
    first_double.step(x, STEPS);
    const double first = x[0];
    second_double.start(y);
    y[0] += 1e3 * limit;
    second_double.step(y, STEPS);
    report_ok(fabs(y[0] - first) > limit, "control: from a start %.1e aside they differ by %.1e", 1e3 * limit,
              fabs(y[0] - first));
    return report_done();
}
