#include "tools/isoc/scene/unit.h"

#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

typedef struct named_unit {
    const char *name;
    double numerator, denominator;
    dimension dim;
    bool takes_prefix;
    double zero; /* of its scale, in hundredths of the SI unit */
} named_unit;

/* Le Systeme international d'unites (BIPM 2019), tables 2, 4 and 8; Ah: IEC 60050-482. */
static const named_unit units[] = {
    {"m", 1, 1, DIMENSION(0, 1, 0, 0, 0, 0), true, 0},
    {"g", 1, 1000, DIMENSION(1, 0, 0, 0, 0, 0), true, 0},
    {"s", 1, 1, DIMENSION(0, 0, 1, 0, 0, 0), true, 0},
    {"N", 1, 1, DIMENSION(1, 1, -2, 0, 0, 0), true, 0},
    {"J", 1, 1, DIMENSION(1, 2, -2, 0, 0, 0), true, 0},
    {"W", 1, 1, DIMENSION(1, 2, -3, 0, 0, 0), true, 0},
    {"Pa", 1, 1, DIMENSION(1, -1, -2, 0, 0, 0), true, 0},
    {"Hz", 1, 1, DIMENSION(0, 0, -1, 0, 0, 0), true, 0},
    {"rad", 1, 1, DIMENSION(0, 0, 0, 1, 0, 0), true, 0},
    {"deg", pi, 180, DIMENSION(0, 0, 0, 1, 0, 0), false, 0},
    {"rev", 2 * pi, 1, DIMENSION(0, 0, 0, 1, 0, 0), false, 0},
    {"rpm", 2 * pi, 60, DIMENSION(0, 0, -1, 1, 0, 0), false, 0},
    {"min", 60, 1, DIMENSION(0, 0, 1, 0, 0, 0), false, 0},
    {"h", 3600, 1, DIMENSION(0, 0, 1, 0, 0, 0), false, 0},
    {"t", 1000, 1, DIMENSION(1, 0, 0, 0, 0, 0), false, 0},
    {"A", 1, 1, DIMENSION(0, 0, 0, 0, 1, 0), true, 0},
    {"K", 1, 1, DIMENSION(0, 0, 0, 0, 0, 1), true, 0},
    {"V", 1, 1, DIMENSION(1, 2, -3, 0, -1, 0), true, 0},
    {"Ohm", 1, 1, DIMENSION(1, 2, -3, 0, -2, 0), true, 0},
    {"H", 1, 1, DIMENSION(1, 2, -2, 0, -2, 0), true, 0},
    {"F", 1, 1, DIMENSION(-1, -2, 4, 0, 2, 0), true, 0},
    {"Wb", 1, 1, DIMENSION(1, 2, -2, 0, -1, 0), true, 0},
    {"T", 1, 1, DIMENSION(1, 0, -2, 0, -1, 0), true, 0},
    {"bar", 1e5, 1, DIMENSION(1, -1, -2, 0, 0, 0), true, 0},
    {"L", 1, 1000, DIMENSION(0, 3, 0, 0, 0, 0), true, 0},
    {"Ah", 3600, 1, DIMENSION(0, 0, 1, 0, 1, 0), true, 0},
    {"degC", 1, 1, DIMENSION(0, 0, 0, 0, 0, 1), false, 27315},
};

typedef struct prefix {
    char letter;
    double numerator, denominator;
} prefix;

static const prefix prefixes[] = {
    {'n', 1, 1e9}, {'u', 1, 1e6}, {'m', 1, 1e3}, {'c', 1, 100},
    {'d', 1, 10},  {'k', 1e3, 1}, {'M', 1e6, 1}, {'G', 1e9, 1},
};

bool dimension_equal_but_angle(dimension a, dimension b)
{
    return a.kg == b.kg && a.m == b.m && a.s == b.s && a.A == b.A && a.K == b.K;
}

bool dimension_equal(dimension a, dimension b)
{
    return a.rad == b.rad && dimension_equal_but_angle(a, b);
}

static bool add_exponent(int8_t *to, int8_t exponent, int n)
{
    const int sum = *to + exponent * n;
    *to = (int8_t)sum;
    return abs(sum) <= 2 * MOST_POWER;
}

bool dimension_times(dimension *a, dimension b, int n)
{
    const bool kg = add_exponent(&a->kg, b.kg, n), m = add_exponent(&a->m, b.m, n), s = add_exponent(&a->s, b.s, n);
    const bool rad = add_exponent(&a->rad, b.rad, n), ampere = add_exponent(&a->A, b.A, n);
    const bool kelvin = add_exponent(&a->K, b.K, n);
    return kg && m && s && rad && ampere && kelvin;
}

static const named_unit *find_plain(const char *name)
{
    for (size_t i = 0; i < COUNT_OF(units); i++) {
        if (strcmp(units[i].name, name) == 0) {
            return &units[i];
        }
    }
    return NULL;
}

bool dimension_is_whole(dimension d)
{
    return ((d.kg | d.m | d.s | d.rad | d.A | d.K) & 1) == 0;
}

bool dimension_root(dimension d, dimension *root)
{
    *root = (dimension){(int8_t)(d.kg / 2),  (int8_t)(d.m / 2), (int8_t)(d.s / 2),
                        (int8_t)(d.rad / 2), (int8_t)(d.A / 2), (int8_t)(d.K / 2)};
    return dimension_is_whole(d);
}

const unit unit_one = {1, 1, DIMENSION(0, 0, 0, 0, 0, 0), 0};

bool unit_find(const char *name, unit *found)
{
    const named_unit *u = find_plain(name);
    prefix scale = {'\0', 1, 1};
    for (size_t i = 0; i < COUNT_OF(prefixes) && u == NULL; i++) {
        if (prefixes[i].letter == name[0]) {
            scale = prefixes[i];
            u = find_plain(name + 1);
            u = u != NULL && u->takes_prefix ? u : NULL;
        }
    }
    if (u == NULL) {
        return false;
    }
    *found = (unit){u->numerator * scale.numerator, u->denominator * scale.denominator, u->dim, u->zero};
    return true;
}

const char *const *unit_names(size_t *count)
{
    static const char *const names[] = {"m",   "mm",  "cm",  "km", "g",  "kg",  "s",   "ms",   "us",   "N",
                                        "kN",  "mN",  "J",   "W",  "Pa", "Hz",  "kHz", "rad",  "mrad", "deg",
                                        "rev", "rpm", "min", "h",  "t",  "Ohm", "bar", "degC", "Ah"};
    *count = COUNT_OF(names);
    return names;
}
