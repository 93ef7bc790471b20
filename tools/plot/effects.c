#include "tools/plot/pictures.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tools/plot/gnuplot.h"
#include "tools/table/table.h"

enum { NAME, KIND };
enum { TWO_BARS = 2, ROW_PIXELS = 44, PIXELS_ABOVE = 84, PIXELS_BELOW = 28 };

static const char *const colour_of[TWO_BARS] = {"#0067a5", "#d1590a"};

/* Bars from zero for each row of the table: a column of it, or two, which share the row. */
typedef struct panel {
    const char *title;
    const char *key[TWO_BARS];    /* columns of the table */
    const char *legend[TWO_BARS]; /* NULL where there is no second */
    double times;                 /* what is shown is the number times this */
    const char *format;           /* of the number at the end of a bar */
    double left, right;           /* of the picture, as parts */
} panel;

static const panel panels[] = {
    {"instructions", {"step", "tick"}, {"of a step", "of a tick"}, 1.0, "%.0f", 0.17, 0.43},
    {"bytes", {"text", "memory"}, {"of text", "of memory"}, 1.0, "%.0f", 0.46, 0.72},
    {"largest change of an output, rms, %", {"part", NULL}, {NULL, NULL}, 100.0, "%.3g", 0.75, 0.98},
};
enum { PANELS = sizeof panels / sizeof panels[0] };

static size_t column_called(const table *const lines, const char *const key)
{
    size_t column = 0;
    while (column < table_cells(lines, 0) && strcmp(table_text(lines, 0, column), key) != 0) {
        column++;
    }
    return column;
}

/* How many effects there are: the lines that have a name, below that of the columns. */
static size_t count_effects(const table *const lines)
{
    size_t count = 0;
    while (count + 1 < lines->rows && table_text(lines, count + 1, NAME)[0] != '\0') {
        count++;
    }
    return count;
}

/* The bars of a panel, each with its number at its end; the axis has room for these. */
static void put_data(const table *const lines, const size_t rows, const panel *const p, const size_t number)
{
    const size_t bars = p->key[1] == NULL ? 1 : TWO_BARS;
    const double height = 0.7 / (double)bars;
    double least = 0;
    double most = 0;
    for (size_t bar = 0; bar < bars; bar++) {
        const size_t column = column_called(lines, p->key[bar]);
        printf("$bars_%zu_%zu << END\n", number, bar);
        for (size_t row = 1; row <= rows; row++) {
            const double value = p->times * table_number(lines, row, column);
            const double top = (double)row - 0.35 + (double)bar * height;
            printf("%.9g %.4g %.9g %.9g %.4g %.4g %.9g\n", value, top + height / 2, fmin(0, value), fmax(0, value), top,
                   top + height, fmax(0, value));
            least = fmin(least, value);
            most = fmax(most, value);
        }
        puts("END");
    }
    const double width = most > least ? most - least : 1;
    gnuplot_range('x', least, least + 1.2 * width);
    printf("set xrange [%.9g:%.9g]\n", least < 0 ? least - 0.1 * width : 0, least + 1.25 * width);
}

/* A number of the line of this kind: base or whole. */
static double number_of(const table *const lines, const char *const kind, const char *const key)
{
    size_t row = 1;
    while (row < lines->rows && strcmp(table_text(lines, row, KIND), kind) != 0) {
        row++;
    }
    return row < lines->rows ? table_number(lines, row, column_called(lines, key)) : 0;
}

static double height_of(const size_t rows)
{
    return (double)(ROW_PIXELS * rows + PIXELS_ABOVE + PIXELS_BELOW);
}

static void put_panel(const table *const lines, const size_t rows, const panel *const p, const size_t number)
{
    put_data(lines, rows, p, number);
    const double height = height_of(rows);
    const double middle = (p->left + p->right) / 2;
    gnuplot_panel(p->left, p->right, 1 - PIXELS_ABOVE / height, PIXELS_BELOW / height);
    printf("set label 2 '%s' at screen %.4g, screen %.4g center\n", p->title, middle, 1 - 46 / height);
    printf("set key on at screen %.4g, screen %.4g horizontal center top samplen 1\n", middle, 1 - 58 / height);
    printf("set yrange [%.1f:0.5]\nset ytics (", (double)rows + 0.5);
    for (size_t row = 1; row <= rows; row++) {
        fputs(row > 1 ? ", " : "", stdout);
        gnuplot_text(number == 0 ? table_text(lines, row, NAME) : "");
        printf(" %zu", row);
    }
    puts(") scale 0 noenhanced");
    const char *comma = "plot";
    for (size_t bar = 0; bar < (p->key[1] == NULL ? 1 : TWO_BARS); bar++) {
        printf("%s $bars_%zu_%zu using 1:2:3:4:5:6 with boxxyerror fill solid noborder linecolor rgb '%s' ", comma,
               number, bar, colour_of[bar]);
        if (p->legend[bar] == NULL) {
            fputs("notitle", stdout);
        } else {
            printf("title '%s'", p->legend[bar]);
        }
        printf(", $bars_%zu_%zu using 7:2:(sprintf(' %s', $1)) with labels left notitle", number, bar, p->format);
        comma = ",";
    }
    putchar('\n');
}

void picture_effects(const char *const scene, const char *const target, const char *const path)
{
    table lines = table_read(path, '\t');
    const size_t rows = count_effects(&lines);
    if (rows > 0) {
        printf("# size 900 %.0f\n", height_of(rows));
        gnuplot_style();
        puts("set grid noytics");
        char title[512];
        (void)snprintf(title, sizeof title, "%s on the %s: of %.0f instructions of a step, %.0f are without any effect",
                       scene, strcmp(target, "host") == 0 ? target : "Cortex-M4F", number_of(&lines, "whole", "step"),
                       number_of(&lines, "base", "step"));
        fputs("set label 1 ", stdout);
        gnuplot_text(title);
        printf(" at screen 0.5, screen %.4g center noenhanced\n", 1 - 18 / height_of(rows));
        puts("set multiplot");
        for (size_t i = 0; i < PANELS; i++) {
            put_panel(&lines, rows, &panels[i], i);
            puts("unset label 1");
        }
        puts("unset multiplot");
    }
    table_free(&lines);
}
