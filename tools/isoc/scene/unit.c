#include "tools/isoc/scene/unit.h"

#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

typedef struct named_unit {
    const char *name;
    double numerator, denominator;
    dimension of;
    bool takes_prefix;
} named_unit;

/* Le Systeme international d'unites (BIPM 2019), tables 2, 4 and 8. */
static const named_unit units[] = {
    {"m", 1, 1, {0, 1, 0, 0, 0, 0}, true},         {"g", 1, 1000, {1, 0, 0, 0, 0, 0}, true},
    {"s", 1, 1, {0, 0, 1, 0, 0, 0}, true},         {"N", 1, 1, {1, 1, -2, 0, 0, 0}, true},
    {"J", 1, 1, {1, 2, -2, 0, 0, 0}, true},        {"W", 1, 1, {1, 2, -3, 0, 0, 0}, true},
    {"Pa", 1, 1, {1, -1, -2, 0, 0, 0}, true},      {"Hz", 1, 1, {0, 0, -1, 0, 0, 0}, true},
    {"rad", 1, 1, {0, 0, 0, 1, 0, 0}, true},       {"deg", pi, 180, {0, 0, 0, 1, 0, 0}, false},
    {"rev", 2 * pi, 1, {0, 0, 0, 1, 0, 0}, false}, {"rpm", 2 * pi, 60, {0, 0, -1, 1, 0, 0}, false},
    {"min", 60, 1, {0, 0, 1, 0, 0, 0}, false},     {"h", 3600, 1, {0, 0, 1, 0, 0, 0}, false},
    {"t", 1000, 1, {1, 0, 0, 0, 0, 0}, false},     {"A", 1, 1, {0, 0, 0, 0, 1, 0}, true},
    {"K", 1, 1, {0, 0, 0, 0, 0, 1}, true},         {"V", 1, 1, {1, 2, -3, 0, -1, 0}, true},
    {"Ohm", 1, 1, {1, 2, -3, 0, -2, 0}, true},     {"H", 1, 1, {1, 2, -2, 0, -2, 0}, true},
    {"F", 1, 1, {-1, -2, 4, 0, 2, 0}, true},       {"Wb", 1, 1, {1, 2, -2, 0, -1, 0}, true},
};

typedef struct prefix {
    char letter;
    double numerator, denominator;
} prefix;

static const prefix prefixes[] = {
    {'n', 1, 1e9}, {'u', 1, 1e6}, {'m', 1, 1e3}, {'c', 1, 100},
    {'d', 1, 10},  {'k', 1e3, 1}, {'M', 1e6, 1}, {'G', 1e9, 1},
};

enum { UNITS = sizeof units / sizeof units[0], PREFIXES = sizeof prefixes / sizeof prefixes[0] };

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
    return abs(sum) <= 9;
}

bool dimension_times(dimension *a, dimension b, int n)
{
    const bool kg = add_exponent(&a->kg, b.kg, n), m = add_exponent(&a->m, b.m, n);
    const bool s = add_exponent(&a->s, b.s, n), rad = add_exponent(&a->rad, b.rad, n);
    const bool ampere = add_exponent(&a->A, b.A, n), kelvin = add_exponent(&a->K, b.K, n);
    return kg && m && s && rad && ampere && kelvin;
}

/* Dimensions that have a customary unit. Where torque and energy agree, torque is meant. */
static const struct {
    const char *text;
    dimension of;
} customary[] = {

    {"N", {1, 1, -2, 0, 0, 0}},      {"N*m", {1, 2, -2, 0, 0, 0}},      {"N/m", {1, 0, -2, 0, 0, 0}},
    {"N*s/m", {1, 0, -1, 0, 0, 0}},  {"N*m/rad", {1, 2, -2, -1, 0, 0}}, {"N*m*s/rad", {1, 2, -1, -1, 0, 0}},
    {"kg*m^2", {1, 2, 0, 0, 0, 0}},  {"m/s", {0, 1, -1, 0, 0, 0}},      {"m/s^2", {0, 1, -2, 0, 0, 0}},
    {"rad/s", {0, 0, -1, 1, 0, 0}},  {"Hz", {0, 0, -1, 0, 0, 0}},       {"N*m*s", {1, 2, -1, 0, 0, 0}},
    {"W", {1, 2, -3, 0, 0, 0}},      {"Pa", {1, -1, -2, 0, 0, 0}},      {"V", {1, 2, -3, 0, -1, 0}},
    {"Ohm", {1, 2, -3, 0, -2, 0}},   {"H", {1, 2, -2, 0, -2, 0}},       {"F", {-1, -2, 4, 0, 2, 0}},
    {"N*m/A", {1, 2, -2, 0, -1, 0}},
};

static const char *append_power(arena *memory, const char *text, const char *name, int exponent)
{
    const char *separator = text[0] == '\0' ? "" : "*";
    if (exponent == 0) {
        return text;
    }
    return exponent == 1 ? arena_format(memory, "%s%s%s", text, separator, name)
                         : arena_format(memory, "%s%s%s^%d", text, separator, name, exponent);
}

const char *dimension_phrase(arena *memory, dimension d)
{
    const dimension none = {0, 0, 0, 0, 0, 0};
    return dimension_equal(d, none) ? "has no unit" : arena_format(memory, "is in %s", dimension_text(memory, d));
}

static const char *customary_text(const dimension d)
{
    for (size_t i = 0; i < sizeof customary / sizeof customary[0]; i++) {
        if (dimension_equal(customary[i].of, d)) {
            return customary[i].text;
        }
    }
    return NULL;
}

const char *dimension_text_but_angle(arena *memory, dimension d)
{
    dimension plain = d;
    plain.rad = 0;
    return dimension_text(memory, customary_text(d) == NULL && customary_text(plain) != NULL ? plain : d);
}

const char *dimension_text(arena *memory, dimension d)
{
    const char *const name = customary_text(d);
    if (name != NULL) {
        return name;
    }
    const char *text = append_power(memory, "", "kg", d.kg);
    text = append_power(memory, text, "m", d.m);
    text = append_power(memory, text, "s", d.s);
    text = append_power(memory, text, "rad", d.rad);
    text = append_power(memory, text, "A", d.A);
    text = append_power(memory, text, "K", d.K);
    return text[0] == '\0' ? "a plain number" : text;
}

const char *dimension_unit(arena *memory, dimension d)
{
    const dimension none = {0};
    return dimension_equal(d, none) ? "1" : dimension_text(memory, d);
}

static const named_unit *find_plain(const char *name)
{
    for (size_t i = 0; i < UNITS; i++) {
        if (strcmp(units[i].name, name) == 0) {
            return &units[i];
        }
    }
    return NULL;
}

bool unit_find(const char *name, unit *found)
{
    const named_unit *u = find_plain(name);
    prefix scale = {'\0', 1, 1};
    if (u == NULL && name[0] != '\0') {
        for (size_t i = 0; i < PREFIXES && u == NULL; i++) {
            if (prefixes[i].letter == name[0]) {
                scale = prefixes[i];
                u = find_plain(name + 1);
                u = u != NULL && u->takes_prefix ? u : NULL;
            }
        }
    }
    if (u == NULL) {
        return false;
    }
    *found = (unit){u->numerator * scale.numerator, u->denominator * scale.denominator, u->of};
    return true;
}

const char *const *unit_names(size_t *count)
{
    static const char *const names[] = {"m",    "mm",  "cm",  "km",  "g",   "kg", "s",  "ms",  "us",
                                        "N",    "kN",  "mN",  "J",   "W",   "Pa", "Hz", "kHz", "rad",
                                        "mrad", "deg", "rev", "rpm", "min", "h",  "t",  "Ohm"};
    *count = sizeof names / sizeof names[0];
    return names;
}
