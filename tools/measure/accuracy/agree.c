#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "tools/measure/accuracy/accuracy.h"
#include "tools/table/table.h"

enum { STEPS, TIME, STATE };

int agree(const char *const time, const char *const tolerance)
{
    table lines = table_read("-", ' ');
    double square = 0;
    double apart = 0;
    const size_t cells = lines.rows > 0 ? table_cells(&lines, 0) : 0;
    const size_t second = lines.rows > 1 ? 1 : 0;
    for (size_t i = STATE; i < cells; i++) {
        const double state = table_number(&lines, 0, i);
        const double off = state - table_number(&lines, second, i);
        square += state * state;
        apart += off * off;
    }
    apart = isfinite(apart) ? sqrt(apart) : HUGE_VAL;
    printf("%s %.3g", time, apart);
    for (size_t i = STATE; i < cells; i++) {
        printf(" %s", table_text(&lines, 0, i));
    }
    printf("\n");
    const int agreed = lines.rows == 2 && cells > STATE && cells == table_cells(&lines, 1) &&
                       apart <= strtod(tolerance, NULL) * (1 + sqrt(square));
    table_free(&lines);
    return agreed ? EXIT_SUCCESS : EXIT_FAILURE;
}
