#include "tools/isoc/scene/solid_kinds.h"

#include <stddef.h>
#include <string.h>

/* Goldstein, Poole and Safko (2002), Classical Mechanics, sec. 5.3; a homogeneous body, its own axis along z. */
#define TWELFTH (1.0 / 12.0)
static const solid_row solid_rows[SOLIDS] = {
    {"box",
     "box (1, 2, 3) cm of 2 kg",
     3,
     false,
     {{0, TWELFTH, TWELFTH}, {TWELFTH, 0, TWELFTH}, {TWELFTH, TWELFTH, 0}}},
    {"cylinder", "cylinder (2, 10) cm of 2 kg", 2, false, {{0.25, TWELFTH}, {0.25, TWELFTH}, {0.5, 0}}},
    {"sphere", "sphere 5 cm of 2 kg", 1, false, {{0.4}, {0.4}, {0.4}}},
    {"rod", "rod 1 m of 2 kg", 1, false, {{TWELFTH}, {TWELFTH}, {0}}},
    {"tube", "tube (3, 2, 10) cm of 2 kg", 3, true, {{0.25, 0.25, TWELFTH}, {0.25, 0.25, TWELFTH}, {0.5, 0.5, 0}}},
    {"lump", "lump (1, 2, 3) g*m^2 of 2 kg", 0, false, {{0}}},
};
#undef TWELFTH

const solid_row *find_solid(const char *word)
{
    const solid_row *found = NULL;
    for (int i = 0; i < SOLIDS; i++) {
        found = strcmp(word, solid_rows[i].word) == 0 ? &solid_rows[i] : found;
    }
    return found;
}
