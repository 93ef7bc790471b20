/* The computations of make report and make bench; accuracy.h says it for each command.
 *
 *     accuracy plan NANOSECONDS STEP
 *     accuracy agree TIME TOLERANCE <references
 *     accuracy errors REFERENCE POINTS
 *     accuracy text TABLE
 *     accuracy fewest DRIVE TIME COARSEST ERROR REFERENCE
 *     accuracy loosest DRIVE TIME ERROR REFERENCE
 *     accuracy bench METHODS MEASURED TIME STEP ERROR
 *     accuracy loop MEASURED TIME STEP ERROR
 *
 * POINTS and MEASURED may be -, the standard input.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/measure/accuracy/accuracy.h"

static int run(const char *const command, const int arguments, char **const a)
{
    if (strcmp(command, "plan") == 0 && arguments == 2) {
        return plan(a[0], a[1]);
    }
    if (strcmp(command, "agree") == 0 && arguments == 2) {
        return agree(a[0], a[1]);
    }
    if (strcmp(command, "errors") == 0 && arguments == 2) {
        return errors(a[0], a[1]);
    }
    if (strcmp(command, "text") == 0 && arguments == 1) {
        return text(a[0]);
    }
    if (strcmp(command, "fewest") == 0 && arguments == 5) {
        return fewest(a[0], a[1], a[2], a[3], a[4]);
    }
    if (strcmp(command, "loosest") == 0 && arguments == 4) {
        return loosest(a[0], a[1], a[2], a[3]);
    }
    if (strcmp(command, "bench") == 0 && arguments == 5) {
        return bench(a[0], a[1], a[2], a[3], a[4]);
    }
    if (strcmp(command, "loop") == 0 && arguments == 4) {
        return loop(a[0], a[1], a[2], a[3]);
    }
    fputs("usage: accuracy plan|agree|errors|text|fewest|loosest|bench|loop ...; see tools/measure/accuracy/main.c\n",
          stderr);
    return EXIT_FAILURE;
}

int main(const int argc, char **const argv)
{
    const int status = run(argc > 1 ? argv[1] : "", argc - 2, argv + 2);
    return fflush(stdout) == 0 && ferror(stdout) == 0 ? status : EXIT_FAILURE;
}
