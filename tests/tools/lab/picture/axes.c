#include "tests/tools/lab/picture/axes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/tools/lab/picture/svg.h"

/* The number that a label says: like 2, 5e-3 or 10^-3. */
static bool label_value(const char *const text, double *const value, bool *const power)
{
    char *end = NULL;
    *power = strncmp(text, "10^", 3) == 0;
    *value = *power ? pow(10, strtod(text + 3, &end)) : strtod(text, &end);
    return end != text && *end == '\0';
}

bool axis_label(axis *const a, const double pixel, const char *const text)
{
    bool power = false;
    if (a->labels == LABELS_MOST || !label_value(text, &a->value[a->labels], &power)) {
        return false;
    }
    a->powers = a->powers || power;
    a->pixel[a->labels++] = pixel;
    return true;
}

static double scaled(const double value, const bool logarithmic)
{
    return logarithmic ? log(value) : value;
}

double pixel_of(const axis *const a, const double value, double *const tolerance)
{
    const size_t last = a->labels - 1;
    const double from = scaled(a->value[0], a->logarithmic);
    const double to = scaled(a->value[last], a->logarithmic);
    const double s = (scaled(value, a->logarithmic) - from) / (to - from);
    *tolerance = RESOLUTION * (1 + fabs(s) + fabs(1 - s));
    return a->pixel[0] + s * (a->pixel[last] - a->pixel[0]);
}

double value_of(const axis *const a, const double pixel)
{
    const size_t last = a->labels - 1;
    const double from = scaled(a->value[0], a->logarithmic);
    const double to = scaled(a->value[last], a->logarithmic);
    const double read = from + (to - from) * (pixel - a->pixel[0]) / (a->pixel[last] - a->pixel[0]);
    return a->logarithmic ? exp(read) : read;
}

/* How far the labels are from a linear or logarithmic axis, in pixels. */
static double misfit(axis *const a, const bool logarithmic)
{
    double most = 0;
    a->logarithmic = logarithmic;
    for (size_t i = 0; i < a->labels; i++) {
        double tolerance = 0;
        if (logarithmic && a->value[i] <= 0) {
            return HUGE_VAL;
        }
        most = fmax(most, fabs(pixel_of(a, a->value[i], &tolerance) - a->pixel[i]));
    }
    return most;
}

bool axis_scale(axis *const a, const char *const title, const char *const name)
{
    if (a->labels < 2) {
        printf("%s: the %s axis has no two labels\n", title, name);
        return false;
    }
    const double linear = misfit(a, false);
    const double logarithmic = misfit(a, true);
    a->logarithmic = a->labels == 2 ? a->powers : logarithmic < linear;
    if ((a->logarithmic ? logarithmic : linear) > 3 * RESOLUTION) {
        printf("%s: the labels of the %s axis agree neither with a linear nor with a logarithmic one\n", title, name);
        return false;
    }
    return true;
}
