/* The unit of a dimension as its field writes it: at most one derived unit, which takes all of the mass, and base
 * units, with as few powers as there can be. */
#include <stdlib.h>
#include <string.h>

#include "tools/isoc/scene/unit.h"

enum { KG, A, M, S, RAD, K, BASES, MOST_POWER = 2, MOST_REST = 9, UNREADABLE = 1000 };

static const char *const bases[BASES] = {"kg", "A", "m", "s", "rad", "K"};

/* Dimensions with a unit that is not the shortest: a damping is no mass per time, a rate no power of a time. */
static const struct {
    const char *text;
    dimension unit;
} customary[] = {
    {"Hz", {0, 0, -1, 0, 0, 0, 0}},     {"N*s/m", {1, 0, -1, 0, 0, 0, 0}}, {"N*m*s^2/rad^2", {1, 2, 0, -2, 0, 0, 0}},
    {"N*m/A", {1, 2, -2, 0, -1, 0, 0}}, {"J/K", {1, 2, -2, 0, 0, -1, 0}},  {"J/kg/K", {0, 2, -2, 0, 0, -1, 0}},
};

/* Derived units, where two are as short the first. Heat is no matter of forces: a thermal conductivity is W/m/K. */
static const struct {
    const char *text;
    dimension unit;
    int cost_of_heat;
} derived[] = {
    {"N", {1, 1, -2, 0, 0, 0, 0}, 1},   {"V", {1, 2, -3, 0, -1, 0, 0}, 0}, {"W", {1, 2, -3, 0, 0, 0, 0}, 0},
    {"Pa", {1, -1, -2, 0, 0, 0, 0}, 1}, {"T", {1, 0, -2, 0, -1, 0, 0}, 0}, {"Ohm", {1, 2, -3, 0, -2, 0, 0}, 0},
    {"H", {1, 2, -2, 0, -2, 0, 0}, 0},  {"F", {-1, -2, 4, 0, 2, 0, 0}, 0},
};

/* A derived unit and its power, 0 where there is none, with the remaining base units. */
typedef struct product {
    const char *derived;
    int power, powers[BASES];
    int cost;
} product;

static product product_of(dimension d)
{
    product result = {.powers = {d.kg, d.A, d.m, d.s, d.rad, d.K}};
    for (int i = 0; i < BASES; i++) {
        result.cost += abs(result.powers[i]);
    }
    return result;
}

/* The same with a power of a derived unit that takes all of the mass, as far as there is one and it can be read. */
static product product_with(product whole, size_t i)
{
    const product one = product_of(derived[i].unit);
    product result = {.derived = derived[i].text, .power = whole.powers[KG] / one.powers[KG]};
    bool is_readable = result.power != 0 && abs(result.power) <= MOST_POWER;
    result.cost = abs(result.power) + (whole.powers[K] != 0 ? derived[i].cost_of_heat : 0);
    for (int b = 0; b < BASES; b++) {
        result.powers[b] = whole.powers[b] - result.power * one.powers[b];
        result.cost += abs(result.powers[b]);
        is_readable = is_readable && abs(result.powers[b]) <= MOST_REST;
    }
    result.cost = is_readable ? result.cost : UNREADABLE;
    return result;
}

static product shortest(dimension d)
{
    const product whole = product_of(d);
    product best = whole;
    for (size_t i = 0; i < COUNT_OF(derived); i++) {
        const product with = product_with(whole, i);
        best = with.cost < best.cost ? with : best;
    }
    return best;
}

/* A factor with a power above zero, or below it behind a stroke: m^2, 1/s. */
static const char *append(arena *memory, const char *text, const char *called, int power, bool below)
{
    const int size = below ? -power : power;
    if (size <= 0) {
        return text;
    }
    const char *sign = text[0] == '\0' ? (below ? "1/" : "") : below ? "/" : "*";
    return size == 1 ? arena_format(memory, "%s%s%s", text, sign, called)
                     : arena_format(memory, "%s%s%s^%d", text, sign, called, size);
}

static const char *text_of(arena *memory, const product *p)
{
    const char *text = append(memory, "", p->derived, p->power, false);
    for (int i = 0; i < BASES; i++) {
        text = append(memory, text, bases[i], p->powers[i], false);
    }
    /* A speed for each volt is rad/s/V, a compliance m/N. */
    text = append(memory, text, bases[S], p->powers[S], true);
    text = append(memory, text, p->derived, p->power, true);
    for (int i = 0; i < BASES; i++) {
        text = i == S ? text : append(memory, text, bases[i], p->powers[i], true);
    }
    return text;
}

const char *dimension_text(arena *memory, dimension d)
{
    for (size_t i = 0; i < COUNT_OF(customary); i++) {
        if (dimension_equal(customary[i].unit, d)) {
            return customary[i].text;
        }
    }
    if (d.root_s != 0) {
        d.root_s = 0;
        const bool is_plain = dimension_equal(d, unit_one.dim);
        return arena_format(memory, "%s/sqrt(Hz)", is_plain ? "1" : dimension_text(memory, d));
    }
    const product result = shortest(d);
    return result.cost == 0 ? "a plain number" : text_of(memory, &result);
}

const char *dimension_text_but_angle(arena *memory, dimension d)
{
    const bool is_mechanical = d.kg > 0 || d.m > 0;
    d.rad = is_mechanical && d.rad > 0 ? 0 : d.rad;
    return dimension_text(memory, d);
}

const char *dimension_unit(arena *memory, dimension d)
{
    return dimension_equal(d, unit_one.dim) ? "1" : dimension_text(memory, d);
}

const char *dimension_phrase(arena *memory, dimension d)
{
    return dimension_equal(d, unit_one.dim) ? "has no unit"
                                            : arena_format(memory, "is in %s", dimension_text(memory, d));
}

const char *unit_of_rate(arena *memory, const char *base)
{
    const size_t length = strlen(base);
    const bool is_speed = length > 2 && strcmp(base + length - 2, "/s") == 0;
    return arena_format(memory, "%s%s", base, is_speed ? "^2" : "/s");
}
