/* Writes gnuplot's commands for a picture.
 *
 *     plot trace DIRECTORY [OUTPUT...]              of a run: trace.csv, units.csv and summary.txt there
 *     plot path DIRECTORY
 *     plot histogram DIRECTORY
 *     plot work_precision SCENE TIME report.tsv
 *     plot violation SCENE measured
 *     plot effects SCENE TARGET effects.tsv
 *     plot compare DIRECTORY DIRECTORY
 *     plot differences DIRECTORY DIRECTORY          as a table
 *     plot compact <drawn.svg >smaller.svg
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/plot/pictures.h"

int main(const int argc, char **const argv)
{
    const char *const kind = argc > 1 ? argv[1] : "";
    if (strcmp(kind, "trace") == 0 && argc >= 3) {
        picture_trace(argv[2], argv + 3, (size_t)argc - 3);
    } else if (strcmp(kind, "path") == 0 && argc == 3) {
        picture_path(argv[2]);
    } else if (strcmp(kind, "histogram") == 0 && argc == 3) {
        picture_histogram(argv[2]);
    } else if (strcmp(kind, "work_precision") == 0 && argc == 5) {
        picture_work_precision(argv[2], argv[3], argv[4]);
    } else if (strcmp(kind, "violation") == 0 && argc == 4) {
        picture_violation(argv[2], argv[3]);
    } else if (strcmp(kind, "effects") == 0 && argc == 5) {
        picture_effects(argv[2], argv[3], argv[4]);
    } else if (strcmp(kind, "compare") == 0 && argc == 4) {
        picture_compare(argv[2], argv[3]);
    } else if (strcmp(kind, "differences") == 0 && argc == 4) {
        table_differences(argv[2], argv[3]);
    } else if (strcmp(kind, "compact") == 0 && argc == 2) {
        compact_svg();
    } else {
        fputs("usage: plot trace DIRECTORY [OUTPUT...] | plot path DIRECTORY | plot histogram DIRECTORY | "
              "plot work_precision SCENE TIME TABLE | "
              "plot violation SCENE LINES | plot effects SCENE TARGET TABLE | plot compare DIRECTORY DIRECTORY | plot "
              "differences DIRECTORY DIRECTORY | plot compact\n",
              stderr);
        return EXIT_FAILURE;
    }
    return fflush(stdout) == 0 && ferror(stdout) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
