/* A duration such as 1ms, 500us, 0.001 or 2.5e-3 s, in whole nanoseconds or as a decimal number of seconds.
 *
 *     duration ns|s TEXT LEAST MOST
 *
 * Without a unit TEXT is in seconds; LEAST and MOST are in nanoseconds. Prints nothing and exits with status 1 if TEXT
 * is no duration, no whole number of nanoseconds, or out of bounds.
 */
#include <ctype.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Nanoseconds in a unit; 0 if there is none of this name. */
static double scale_of(const char *const unit)
{
    static const struct {
        const char *name;
        double nanoseconds;
    } units[] = {{"", 1e9}, {"s", 1e9}, {"ms", 1e6}, {"us", 1e3}, {"ns", 1.0}};
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++) {
        if (strcmp(unit, units[i].name) == 0) {
            return units[i].nanoseconds;
        }
    }
    return 0.0;
}

/* A decimal number, spaces and a unit; strtod alone would take hexadecimal numbers, signs and words too. */
static bool read_duration(const char *const text, double *const nanoseconds)
{
    char *end = NULL;
    const double number = strtod(text, &end);
    const size_t length = (size_t)(end - text);
    if (length == 0 || strspn(text, "0123456789.eE+-") < length ||
        !(isdigit((unsigned char)text[0]) || text[0] == '.')) {
        return false;
    }
    while (*end == ' ') {
        end++;
    }
    *nanoseconds = number * scale_of(end);
    return scale_of(end) > 0.0;
}

/* Seconds without the zeros that end them, but for one behind the point. */
static void print_seconds(const double seconds)
{
    char text[64];
    snprintf(text, sizeof text, "%.9f", seconds);
    size_t length = strlen(text);
    while (text[length - 1] == '0' && text[length - 2] != '.') {
        length--;
    }
    printf("%.*s\n", (int)length, text);
}

int main(int argc, char **argv)
{
    double exact = 0.0;
    if (argc != 5 || !read_duration(argv[2], &exact)) {
        return EXIT_FAILURE;
    }
    const double whole = round(exact);
    if (!(fabs(exact - whole) <= 1e-9 * exact) || whole < strtod(argv[3], NULL) || whole > strtod(argv[4], NULL)) {
        return EXIT_FAILURE;
    }
    if (strcmp(argv[1], "s") == 0) {
        print_seconds(whole / 1e9);
    } else {
        printf("%.0f\n", whole);
    }
    return EXIT_SUCCESS;
}
