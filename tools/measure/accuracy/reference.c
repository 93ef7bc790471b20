#include "tools/measure/accuracy/reference.h"

#include <math.h>
#include <string.h>

reference reference_read(const char *const path)
{
    reference r = {.lines = table_read(path, ' ')};
    r.states = r.lines.rows > 0 ? table_cells(&r.lines, 0) - REFERENCE_STATE : 0;
    return r;
}

int reference_at(const reference *const r, const char *const time)
{
    for (size_t row = 0; row < r->lines.rows; row++) {
        if (strcmp(table_text(&r->lines, row, REFERENCE_TIME), time) == 0) {
            return (int)row;
        }
    }
    return -1;
}

double reference_error(const reference *const r, const int line, const table *const t, const size_t row,
                       const size_t cell)
{
    double square = 0;
    for (size_t i = 0; i < r->states; i++) {
        const double state = table_number(t, row, cell + i);
        const double off = state - table_number(&r->lines, (size_t)line, REFERENCE_STATE + i);
        square += off * off;
    }
    return isfinite(square) ? sqrt(square) : HUGE_VAL;
}
