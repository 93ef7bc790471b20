#include "tools/plot/look.h"

#include <string.h>

#include "core/methods/table.h"

/* Looks that are chosen: variants of a method share a colour. */
static const struct {
    const char *colour;
    int mark;
} chosen[ISO_METHODS] = {
    [ISO_EULER] = {"#8c8c8c", 7},      [ISO_SEMI_IMPLICIT] = {"#8c8c8c", 6}, [ISO_HEUN] = {"#b8860b", 7},
    [ISO_RK4] = {"#0067a5", 7},        [ISO_AB4] = {"#d1590a", 7},           [ISO_ABM4] = {"#3c8d2f", 7},
    [ISO_ABM4_PEC] = {"#3c8d2f", 6},   [ISO_ABM4_PECECE] = {"#3c8d2f", 9},   [ISO_BDF4] = {"#8e3a8e", 7},
    [ISO_ROSENBROCK] = {"#c2185b", 5}, [ISO_ADAMS] = {"#008b8b", 5},
};

/* The others have one of these, none of which is above: for every colour each of the marks. */
static const char *const palette[] = {"#000000", "#8b4513", "#1a237e", "#7cb342",
                                      "#e57373", "#5c9bd5", "#9575cd", "#a1887f"};
static const int marks[] = {7, 5, 9, 13, 11, 15};
enum { COLOURS = sizeof palette / sizeof *palette, MARKS = sizeof marks / sizeof *marks };
_Static_assert((int)ISO_METHODS + (int)LOOKS_MOST <= (int)COLOURS * (int)MARKS, "two methods would look alike");

static const char *const names[ISO_METHODS] = ISO_METHOD_NAMES;

/* The number of a method in core, ISO_METHODS if it is not there. */
static size_t row_of(const char *const method)
{
    size_t row = 0;
    while (row < ISO_METHODS && strcmp(names[row], method) != 0) {
        row++;
    }
    return row;
}

static method_family family_of(const size_t row)
{
    const unsigned recipe = (unsigned)row;
    if (row == ISO_METHODS) {
        return OTHERS;
    }
    if (ISO_IS_VARYING(recipe)) {
        return VARYING_STEP;
    }
    if (ISO_IS_IMPLICIT(recipe)) {
        return STIFF;
    }
    return ISO_PAST_KEPT(recipe) > 0 ? MULTISTEP : ONE_STEP;
}

look look_of(const char *const method, const size_t order)
{
    const size_t row = row_of(method);
    if (row < ISO_METHODS && chosen[row].colour != NULL) {
        return (look){method, family_of(row), chosen[row].colour, chosen[row].mark};
    }
    const size_t number = row < ISO_METHODS ? row : row + order;
    return (look){method, family_of(row), palette[number % COLOURS], marks[number / COLOURS % MARKS]};
}

const char *family_name(const method_family family)
{
    static const char *const families[FAMILIES] = {
        [ONE_STEP] = "one step",         [MULTISTEP] = "multistep", [STIFF] = "stiff",
        [VARYING_STEP] = "varying step", [OTHERS] = "others",
    };
    return families[family];
}
