#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "tools/measure/accuracy/accuracy.h"

/* The tick is the longest part of the time that is at most ten of the long steps, and no more than isoc allows. */
int plan(const char *const nanoseconds, const char *const step_text)
{
    enum { LONGEST = 40 };
    const double step = strtod(step_text, NULL);
    const long wanted = (long)(strtod(nanoseconds, NULL) / (4e9 * step) + 0.5);
    const long coarsest = wanted < 1 ? 1 : wanted;
    long steps = LONGEST;
    while (steps > 1 && (4 * coarsest % steps != 0 || (double)steps * step > 1)) {
        steps--;
    }
    printf("%ld %.17g %.9gs\n", coarsest, (double)(4 * coarsest) * step, (double)steps * step);
    return EXIT_SUCCESS;
}
