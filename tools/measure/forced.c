/* A generated plant in which every second tick has a discontinuity; its cause is between the ticks, outside of what is
 * counted.
 *
 *     forced announced|detected <plant.c >forced.c
 *
 * Announced: a tunable `forced` changes. Detected, where steps are checked: the usual error is so small that every error is
 * larger; in the ticks between it is so large that none is. A tick is 10 ms, within which every step ends; the step is as
 * long as it was.
 */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/table/table.h"

static const char announced[] = "    memory->p[PLANT_P_FORCED] += (real)(tick % 2);\n";
static const char detected[] = "    memory->progress.usual = tick % 2 == 0 ? ISO_REAL_MAX : R(-1.0);\n"
                               "    memory->progress.watched = ISO_USUAL_STEPS;\n";

static bool begins(const char *const line, const char *const with)
{
    return strncmp(line, with, strlen(with)) == 0;
}

/* The function that stands in the place of the plant's own `drive`. */
static void put_forced(const bool driven, const char *const cause)
{
    printf("static void forced(void *const instance, const uint64_t tick)\n{\n"
           "    plant_memory *const memory = instance;\n%s%s}\n\n",
           driven ? "    drive(instance, tick);\n" : "", cause);
}

int main(const int argc, char **const argv)
{
    const char *const cause = argc == 2 && strcmp(argv[1], "announced") == 0  ? announced
                              : argc == 2 && strcmp(argv[1], "detected") == 0 ? detected
                                                                              : NULL;
    if (cause == NULL) {
        fputs("usage: forced announced|detected <plant.c >forced.c\n", stderr);
        return EXIT_FAILURE;
    }
    table lines = table_read("-", '\n');
    bool driven = false;
    int places = 0;
    for (size_t row = 0; row < lines.rows; row++) {
        const char *const line = table_text(&lines, row, 0);
        driven = driven || begins(line, "static void drive(");
        if (begins(line, "const iso_model plant_model")) {
            put_forced(driven, cause);
            places++;
        }
        if (begins(line, "    .period_ns = ")) {
            puts("    .period_ns = UINT32_C(10000000),");
            places++;
        } else if (begins(line, "    .step = step,")) {
            printf("%s\n    .drive = forced,\n", line);
            places++;
        } else if (!begins(line, "    .drive = ")) {
            puts(line);
        }
    }
    table_free(&lines);
    if (places != 3) {
        fputs("forced: this is no plant made by isoc\n", stderr);
        return EXIT_FAILURE;
    }
    return fflush(stdout) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
