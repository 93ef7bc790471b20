/* The unit of a dimension as its field writes it: at most one derived unit, which takes all of the mass, and base
 * units, with as few powers as there can be; half powers are one root of a unit. */
#include <stdlib.h>
#include <string.h>

#include "tools/isoc/scene/unit.h"

enum { KG, A, M, S, RAD, K, BASES, MOST_OF_DERIVED = 2, UNREADABLE = 1000 };

static const char *const bases[BASES] = {"kg", "A", "m", "s", "rad", "K"};

/* Dimensions with a unit that is not the shortest: a damping is no mass per time, a rate no power of a time. */
static const struct {
    const char *text;
    dimension unit;
} customary[] = {
    {"Hz", DIMENSION(0, 0, -1, 0, 0, 0)},
    {"N*s/m", DIMENSION(1, 0, -1, 0, 0, 0)},
    {"N*m*s^2/rad^2", DIMENSION(1, 2, 0, -2, 0, 0)},
    {"N*m/A", DIMENSION(1, 2, -2, 0, -1, 0)},
    {"J/K", DIMENSION(1, 2, -2, 0, 0, -1)},
    {"J/kg/K", DIMENSION(0, 2, -2, 0, 0, -1)},
};

/* Derived units, where two are as short the first. Heat is no matter of forces: a thermal conductivity is W/m/K. */
static const struct {
    const char *text;
    dimension unit;
    int cost_of_heat;
} derived[] = {
    {"N", DIMENSION(1, 1, -2, 0, 0, 0), 1},  {"V", DIMENSION(1, 2, -3, 0, -1, 0), 0},
    {"W", DIMENSION(1, 2, -3, 0, 0, 0), 0},  {"Pa", DIMENSION(1, -1, -2, 0, 0, 0), 1},
    {"T", DIMENSION(1, 0, -2, 0, -1, 0), 0}, {"Ohm", DIMENSION(1, 2, -3, 0, -2, 0), 0},
    {"H", DIMENSION(1, 2, -2, 0, -2, 0), 0}, {"F", DIMENSION(-1, -2, 4, 0, 2, 0), 0},
};

/* A derived unit and its power, 0 where there is none, with the remaining base units. */
typedef struct product {
    const char *derived;
    int power, powers[BASES];
    int cost;
} product;

static product product_of(dimension d)
{
    product result = {.powers = {d.kg / 2, d.A / 2, d.m / 2, d.s / 2, d.rad / 2, d.K / 2}};
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
    bool is_readable = result.power != 0 && abs(result.power) <= MOST_OF_DERIVED;
    result.cost = abs(result.power) + (whole.powers[K] != 0 ? derived[i].cost_of_heat : 0);
    for (int b = 0; b < BASES; b++) {
        result.powers[b] = whole.powers[b] - result.power * one.powers[b];
        result.cost += abs(result.powers[b]);
        is_readable = is_readable && abs(result.powers[b]) <= MOST_POWER;
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

/* Units that stand under a root, the first where two are as short; with the base units. */
static const char *const under_roots[] = {"Hz", "Pa", "N", "W", "V", "kg", "m", "s", "rad", "A", "K"};

/* Half powers of several units that none of them explains: each under the root. */
static dimension odd_part(dimension d)
{
    return (dimension){(int8_t)(2 * (d.kg % 2)),  (int8_t)(2 * (d.m % 2)), (int8_t)(2 * (d.s % 2)),
                       (int8_t)(2 * (d.rad % 2)), (int8_t)(2 * (d.A % 2)), (int8_t)(2 * (d.K % 2))};
}

/* A root of a unit and the rest: 1/sqrt(Hz), m^3/s/sqrt(Pa), sqrt(N). */
static const char *text_of_roots(arena *memory, dimension d)
{
    const dimension odd = odd_part(d);
    const product all = shortest(odd);
    const char *root = text_of(memory, &all);
    dimension rest = d, part;
    int sign = 1, least = UNREADABLE;
    dimension_root(odd, &part);
    dimension_times(&rest, part, -1);
    for (size_t i = 0; i < 2 * COUNT_OF(under_roots); i++) {
        const int up = i % 2 == 0 ? -1 : 1; /* below the stroke first */
        dimension left = d;
        unit u;
        unit_find(under_roots[i / 2], &u);
        dimension_root(u.dim, &part);
        dimension_times(&left, part, -up);
        const int cost = dimension_is_whole(left) ? shortest(left).cost : UNREADABLE;
        if (cost < least) {
            least = cost;
            rest = left;
            sign = up;
            root = under_roots[i / 2];
        }
    }
    const bool is_plain = dimension_equal(rest, unit_one.dim);
    const char *before = is_plain ? (sign < 0 ? "1" : "") : dimension_text(memory, rest);
    return arena_format(memory, "%s%ssqrt(%s)", before, sign < 0 ? "/" : is_plain ? "" : "*", root);
}

const char *dimension_text(arena *memory, dimension d)
{
    for (size_t i = 0; i < COUNT_OF(customary); i++) {
        if (dimension_equal(customary[i].unit, d)) {
            return customary[i].text;
        }
    }
    if (!dimension_is_whole(d)) {
        return text_of_roots(memory, d);
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
