#include "tools/isoc/base/numbers.h"

#include <float.h>
#include <math.h>

bool real_holds(double number, bool is_double)
{
    const double largest = is_double ? DBL_MAX : (double)FLT_MAX, least = is_double ? DBL_MIN : (double)FLT_MIN;
    const double nearest = is_double ? number : (double)(float)number;
    return number == 0.0 || (fabs(nearest) >= least && fabs(nearest) <= largest);
}

bool real_is_tiny(double number, bool is_double)
{
    return !is_double && number != 0.0 && fabs(number) < (double)FLT_MIN;
}

const char *real_advice(double number, bool is_double)
{
    return is_double ? "a double holds 0 and 2.2e-308 to 1.8e308: choose another number"
           : !real_holds(number, true)
               ? "a float holds 0 and 1.2e-38 to 3.4e38: choose another number"
               : "a float holds 0 and 1.2e-38 to 3.4e38: choose another number, or --real double";
}
