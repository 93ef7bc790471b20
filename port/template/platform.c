/* Before main, where port/mps2/start.c leads from reset to it: turn on clocks, flash wait states and pins here; the
 * stack, the data and the floating-point unit are there already. No word of a command line comes. */
#include "port/mps2/start.h"

int start_platform(char **const words, const int max)
{
    (void)words;
    (void)max;
    return 0;
}
