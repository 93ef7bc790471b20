/* The size of a program and of what matters in it, from the output of `size` followed by that of `nm -S`.
 *
 *     { size PROGRAM; nm -S PROGRAM; } | size yes|no
 *
 * The stack and the trace buffer are counted apart: the first is the platform's, the second the run's. With `yes` the sizes
 * of the double pendulum's firmware are held to their limits; status 1 if one is exceeded.
 */
#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/table/table.h"

typedef struct sizes {
    double text, data, bss, step, memory, stack, buffer; /* bytes */
} sizes;

/* NAME, NAME.SUFFIX of a copy that the compiler made, or NAME_1 of a part that isoc made. */
static bool is_part_of(const char *const symbol, const char *const name)
{
    const size_t length = strlen(name);
    return strncmp(symbol, name, length) == 0 &&
           (symbol[length] == '\0' || symbol[length] == '.' ||
            (symbol[length] == '_' && isdigit((unsigned char)symbol[length + 1])));
}

/* A line of nm: address, size, type, symbol; of an absolute symbol the size is left out. */
static void add_symbol(sizes *const s, const table *const lines, const size_t row)
{
    const size_t cells = table_cells(lines, row);
    const char *const symbol = cells > 0 ? table_text(lines, row, cells - 1) : "";
    if (strcmp(symbol, "STACK_BYTES") == 0) {
        s->stack = (double)strtoull(table_text(lines, row, 0), NULL, 16);
    }
    if (cells != 4) {
        return;
    }
    const double bytes = (double)strtoull(table_text(lines, row, 1), NULL, 16);
    const char *const type = table_text(lines, row, 2);
    if (strcmp(symbol, "trace_buffer") == 0) {
        s->buffer = bytes;
    } else if (strcmp(symbol, "memory") == 0 && (strcmp(type, "b") == 0 || strcmp(type, "B") == 0)) {
        s->memory = bytes;
    } else if ((strcmp(type, "t") == 0 || strcmp(type, "T") == 0) &&
               (is_part_of(symbol, "step") || is_part_of(symbol, "derivative") ||
                is_part_of(symbol, "held_derivative") || is_part_of(symbol, "hold"))) {
        s->step += bytes;
    }
}

/* Returns whether the limit is kept; one of 0 is none. */
static bool show(const char *const name, const double bytes, const double limit)
{
    const bool kept = limit <= 0 || bytes <= limit;
    printf("%s %.0f", name, bytes);
    if (limit > 0) {
        printf(" of at most %.0f%s", limit, kept ? "" : ": TOO LARGE");
    }
    printf("\n");
    return kept;
}

int main(int argc, char **argv)
{
    enum { TEXT_MOST = 9216, STEP_MOST = 3072, DATA_MOST = 512, SIZES_ROW = 1 };
    table lines = table_read("-", ' ');
    sizes s = {0};
    for (size_t row = SIZES_ROW + 1; row < lines.rows; row++) {
        add_symbol(&s, &lines, row);
    }
    if (lines.rows > SIZES_ROW) {
        s.text = table_number(&lines, SIZES_ROW, 0);
        s.data = table_number(&lines, SIZES_ROW, 1);
        s.bss = table_number(&lines, SIZES_ROW, 2);
    }
    table_free(&lines);
    if (argc != 2 || !(s.text > 0 && s.step > 0 && s.buffer > 0)) {
        fputs("size: this is not the output of size and nm for a plant's program\n", stderr);
        return EXIT_FAILURE;
    }
    const bool limited = strcmp(argv[1], "yes") == 0;
    bool kept = show("text", s.text, limited ? TEXT_MOST : 0);
    kept &= show("step_text", s.step, limited ? STEP_MOST : 0);
    kept &= show("plant_memory", s.memory, 0);
    kept &= show("data_bss", s.data + s.bss - s.stack - s.buffer, limited ? DATA_MOST : 0);
    kept &= show("stack", s.stack, 0);
    kept &= show("trace_buffer", s.buffer, 0);
    return kept ? EXIT_SUCCESS : EXIT_FAILURE;
}
