#include "tools/plot/pictures.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "tools/plot/gnuplot.h"
#include "tools/table/table.h"

enum { NAME, WHAT, FIRST, SECOND };
enum { STABILISATIONS = 4 };

static const struct {
    const char *name;
    const char *colour;
} looks[STABILISATIONS] = {
    {"none", "#8c8c8c"}, {"baumgarte", "#d1590a"}, {"projection", "#0067a5"}, {"lagrangian", "#3c8d2f"}};

static bool says(const table *const lines, const size_t row, const char *const name, const char *const what)
{
    return strcmp(table_text(lines, row, NAME), name) == 0 && strcmp(table_text(lines, row, WHAT), what) == 0;
}

static bool is_point(const table *const lines, const size_t row, const char *const name)
{
    return says(lines, row, name, "part") && table_number(lines, row, SECOND) > 0;
}

/* The points of a stabilisation, as a block of data. False if it has none. */
static bool put_points(const table *const lines, const char *const name)
{
    size_t points = 0;
    for (size_t row = 0; row < lines->rows; row++) {
        if (is_point(lines, row, name)) {
            if (points++ == 0) {
                printf("$points_%s << END\n", name);
            }
            printf("%s %s\n", table_text(lines, row, FIRST), table_text(lines, row, SECOND));
        }
    }
    fputs(points > 0 ? "END\n" : "", stdout);
    return points > 0;
}

/* The bound of the violation; 0 if there is none. */
static double bound_of(const table *const lines, const char *const name)
{
    for (size_t row = 0; row < lines->rows; row++) {
        if (says(lines, row, name, "bound")) {
            const double bound = table_number(lines, row, FIRST);
            return isfinite(bound) ? bound : 0;
        }
    }
    return 0;
}

/* The axes: time to its end, which it returns, and whole decades around all that is drawn. */
static double put_axes(const table *const lines)
{
    double last = 0;
    double least = HUGE_VAL;
    double most = 0;
    for (size_t row = 0; row < lines->rows; row++) {
        if (strcmp(table_text(lines, row, WHAT), "part") == 0 && table_number(lines, row, SECOND) > 0) {
            last = fmax(last, table_number(lines, row, FIRST));
            least = fmin(least, table_number(lines, row, SECOND));
            most = fmax(most, table_number(lines, row, SECOND));
        }
    }
    for (size_t i = 0; i < STABILISATIONS; i++) {
        const double bound = bound_of(lines, looks[i].name);
        least = bound > 0 ? fmin(least, bound) : least;
        most = fmax(most, bound);
    }
    puts("set logscale y");
    gnuplot_decades('y', pow(10, floor(log10(least))), pow(10, ceil(log10(most))), true);
    printf("set xrange [0:%.9g]\nset xlabel 't, s'\nset ylabel 'largest violation, m or rad'\n", last);
    return last;
}

/* The bounds as lines over the whole time. */
static void put_bounds(const table *const lines, const double last)
{
    for (size_t i = 0; i < STABILISATIONS; i++) {
        const double bound = bound_of(lines, looks[i].name);
        if (bound > 0) {
            printf("$bound_%s << END\n0 %.9g\n%.9g %.9g\nEND\n", looks[i].name, bound, last, bound);
        }
    }
}

void picture_violation(const char *const scene, const char *const path)
{
    table lines = table_read(path, ' ');
    bool drawn[STABILISATIONS];
    bool any = false;
    for (size_t i = 0; i < STABILISATIONS; i++) {
        drawn[i] = put_points(&lines, looks[i].name);
        any = any || drawn[i];
    }
    if (any) {
        puts("# size 900 420");
        gnuplot_style();
        put_bounds(&lines, put_axes(&lines));
        printf("set title '%s: how far the loops come apart, in float; dashed: the bound' noenhanced\n", scene);
        puts("set key on outside right center noenhanced samplen 2");
        const char *comma = "plot";
        for (size_t i = 0; i < STABILISATIONS; i++) {
            if (drawn[i]) {
                const double bound = bound_of(&lines, looks[i].name);
                printf("%s $points_%s with lines linewidth 1.4 linecolor rgb '%s' title '%s'", comma, looks[i].name,
                       looks[i].colour, looks[i].name);
                comma = ",";
                if (bound > 0) {
                    printf(", $bound_%s with lines linewidth 0.7 dashtype 2 linecolor rgb '%s' notitle", looks[i].name,
                           looks[i].colour);
                }
            }
        }
        putchar('\n');
    }
    table_free(&lines);
}
