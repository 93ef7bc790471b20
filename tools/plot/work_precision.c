#include "tools/plot/pictures.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/plot/gnuplot.h"
#include "tools/table/table.h"

/* Columns of the table. */
enum { KIND, METHOD, STEP, STEPS, ERROR, ORDER, PER_STEP, PER_SECOND, TOLERANCE };

/* An error beyond this means nothing, and is not drawn. */
#define ERROR_MOST 100

enum { KINDS = 3, FAMILIES = 5, METHODS_MOST = 32 };
enum { WIDTH = 960, HEIGHT = 760 };

static const struct {
    const char *name;
    const char *title;
    const char *machine;
} kinds[KINDS] = {{"float", "float", "Cortex-M4F"},
                  {"compensated", "float, compensated sums", "Cortex-M4F"},
                  {"double", "double", "host"}};

static const char *const families[FAMILIES] = {"one step", "multistep", "stiff", "varying step", "others"};

typedef struct look {
    const char *method;
    int family;
    const char *colour;
    int mark; /* gnuplot's pointtype */
} look;

static const look looks[] = {
    {"euler", 0, "#8c8c8c", 7},      {"semi_implicit", 0, "#8c8c8c", 6}, {"heun", 0, "#b8860b", 7},
    {"rk4", 0, "#0067a5", 7},        {"ab4", 1, "#d1590a", 7},           {"abm4", 1, "#3c8d2f", 7},
    {"abm4_pec", 1, "#3c8d2f", 6},   {"abm4_pecece", 1, "#3c8d2f", 9},   {"bdf4", 2, "#8e3a8e", 7},
    {"rosenbrock", 2, "#c2185b", 5}, {"adams", 3, "#008b8b", 5},
};
enum { LOOKS = sizeof looks / sizeof *looks };

/* Methods without a look of their own have a black mark each. */
enum { FIRST_OTHER_MARK = 4, OTHER_MARKS = 12 };

#define FRONT_COLOUR "#f0d060"

typedef struct picture {
    table rows;
    look methods[METHODS_MOST]; /* those of the table */
    size_t count;
    double error[2]; /* least and greatest of what is drawn */
    double cost[2];
    double step[2];
} picture;

/* Whether a line of the table has a place in the picture. */
static bool drawn(const table *const rows, const size_t row)
{
    const double error = table_number(rows, row, ERROR);
    return error > 0 && error <= ERROR_MOST;
}

static bool belongs(const picture *const p, const size_t row, const size_t kind, const char *const method)
{
    return drawn(&p->rows, row) && strcmp(table_text(&p->rows, row, KIND), kinds[kind].name) == 0 &&
           (method == NULL || strcmp(table_text(&p->rows, row, METHOD), method) == 0);
}

static void extend(double range[2], const double value)
{
    range[0] = fmin(range[0], value);
    range[1] = fmax(range[1], value);
}

/* Adds the method unless it is there. */
static void add_method(picture *const p, const char *const name)
{
    for (size_t i = 0; i < p->count; i++) {
        if (strcmp(p->methods[i].method, name) == 0) {
            return;
        }
    }
    if (p->count == METHODS_MOST) {
        fprintf(stderr, "%s: more than %d methods\n", p->rows.path, (int)METHODS_MOST);
        exit(EXIT_FAILURE);
    }
    look found = {name, FAMILIES - 1, "#000000", FIRST_OTHER_MARK + (int)(p->count % OTHER_MARKS)};
    for (size_t i = 0; i < LOOKS; i++) {
        if (strcmp(looks[i].method, name) == 0) {
            found = looks[i];
        }
    }
    p->methods[p->count++] = found;
}

static picture read_picture(const char *const path)
{
    picture p = {.rows = table_read(path, '\t')};
    for (int i = 0; i < 2; i++) {
        p.error[i] = p.cost[i] = p.step[i] = i == 0 ? HUGE_VAL : 0;
    }
    for (size_t row = 1; row < p.rows.rows; row++) {
        add_method(&p, table_text(&p.rows, row, METHOD));
        if (drawn(&p.rows, row)) {
            extend(p.error, table_number(&p.rows, row, ERROR));
            extend(p.cost, table_number(&p.rows, row, PER_SECOND));
            extend(p.step, table_number(&p.rows, row, STEP) * 1000);
        }
    }
    return p;
}

/* --- The Pareto front: the points that no other point of the kind betters in error and in cost --- */

static bool better(const table *const rows, const size_t a, const size_t b)
{
    const double cost = table_number(rows, a, PER_SECOND) - table_number(rows, b, PER_SECOND);
    const double error = table_number(rows, a, ERROR) - table_number(rows, b, ERROR);
    return cost <= 0 && error <= 0 && (cost < 0 || error < 0);
}

static bool on_front(const picture *const p, const size_t kind, const size_t row)
{
    for (size_t other = 1; other < p->rows.rows; other++) {
        if (belongs(p, other, kind, NULL) && better(&p->rows, other, row)) {
            return false;
        }
    }
    return belongs(p, row, kind, NULL);
}

/* The next point of the front that costs more than `cost`, 0 if there is none. */
static size_t next_on_front(const picture *const p, const size_t kind, const double cost)
{
    size_t next = 0;
    for (size_t row = 1; row < p->rows.rows; row++) {
        const double its = table_number(&p->rows, row, PER_SECOND);
        if (its > cost && on_front(p, kind, row) && (next == 0 || its < table_number(&p->rows, next, PER_SECOND))) {
            next = row;
        }
    }
    return next;
}

/* Names an end of the front: the cheapest at the upper edge of the panel, the most exact below its point. */
static void put_end(const picture *const p, const size_t row, const int label, const bool cheapest)
{
    const double cost = table_number(&p->rows, row, PER_SECOND);
    const bool left = log(cost / p->cost[0]) < log(p->cost[1] / p->cost[0]) / 2;
    printf("set label %d '%s, %.3g ms' noenhanced at first %.9g, ", label, table_text(&p->rows, row, METHOD),
           table_number(&p->rows, row, STEP) * 1000, cost);
    if (cheapest) {
        printf("graph 0.955 ");
    } else {
        printf("first %s offset 0, -0.9 ", table_text(&p->rows, row, ERROR));
    }
    printf("%s font ',10' front\n", left ? "left" : "right");
}

enum { TITLE = 1, CHEAPEST, MOST_EXACT, HEAD };

/* The front as a block of data, $front_KIND, and labels at its ends. */
static void put_front(const picture *const p, const size_t kind)
{
    size_t row = next_on_front(p, kind, 0);
    put_end(p, row, CHEAPEST, true);
    printf("$front_%s << END\n", kinds[kind].name);
    for (size_t next = row; next != 0; next = next_on_front(p, kind, table_number(&p->rows, row, PER_SECOND))) {
        row = next;
        printf("%s %s\n", table_text(&p->rows, row, PER_SECOND), table_text(&p->rows, row, ERROR));
    }
    puts("END");
    put_end(p, row, MOST_EXACT, false);
}

/* --- Panels --- */

static void put_line(const look *const its)
{
    printf("with linespoints linewidth 1.1 pointsize 0.55 pointtype %d linecolor rgb '%s'", its->mark, its->colour);
}

/* The points of each method of a kind, as blocks of data $KIND_METHOD: cost, error, step in ms. */
static void put_points(const picture *const p, const size_t kind)
{
    for (size_t m = 0; m < p->count; m++) {
        size_t points = 0;
        for (size_t row = 1; row < p->rows.rows; row++) {
            if (belongs(p, row, kind, p->methods[m].method)) {
                if (points++ == 0) {
                    printf("$%s_%s << END\n", kinds[kind].name, p->methods[m].method);
                }
                printf("%s %s %.9g\n", table_text(&p->rows, row, PER_SECOND), table_text(&p->rows, row, ERROR),
                       table_number(&p->rows, row, STEP) * 1000);
            }
        }
        fputs(points > 0 ? "END\n" : "", stdout);
    }
}

static bool has_points(const picture *const p, const size_t kind, const char *const method)
{
    for (size_t row = 1; row < p->rows.rows; row++) {
        if (belongs(p, row, kind, method)) {
            return true;
        }
    }
    return false;
}

/* Draws a panel of a kind whose abscissa is a column of the points; after the front, if it has that one. */
static void put_curves(const picture *const p, const size_t kind, const int column, const bool front)
{
    const char *comma = "plot";
    if (front) {
        printf("plot $front_%s with lines linewidth 6 linecolor rgb '%s'", kinds[kind].name, FRONT_COLOUR);
        comma = ",";
    }
    for (size_t m = 0; m < p->count; m++) {
        if (has_points(p, kind, p->methods[m].method)) {
            printf("%s $%s_%s using %d:2 ", comma, kinds[kind].name, p->methods[m].method, column);
            put_line(&p->methods[m]);
            comma = ",";
        }
    }
    putchar('\n');
}

/* Labels at the steps of fixed methods, and by twos at whatever lies beyond them; every other one has a text. */
static void put_step_axis(const picture *const p)
{
    double longest = 0;
    for (size_t row = 1; row < p->rows.rows; row++) {
        const bool fixed = strcmp(table_text(&p->rows, row, TOLERANCE), "-") == 0;
        if (drawn(&p->rows, row) && fixed) {
            longest = fmax(longest, table_number(&p->rows, row, STEP) * 1000);
        }
    }
    double step = longest > 0 ? longest : p->step[1];
    while (2 * step <= 1.25 * p->step[1]) {
        step *= 2;
    }
    printf("set xrange [%.4g:%.4g]\nset xtics (", p->step[0] * 0.8, p->step[1] * 1.25);
    const char *comma = "";
    for (int i = 0; step >= 0.8 * p->step[0]; i++) {
        printf(i % 2 == 0 ? "%s'%.4g' %.4g" : "%s'' %.4g", comma, step, step);
        comma = ", ";
        step /= 2;
    }
    puts(")\nset xlabel 'step, ms'");
}

/* The two panels of a kind, one above the other. */
static void put_kind(const picture *const p, const size_t kind, const char *const time, const int place,
                     const int places)
{
    const double width = 0.91 / places;
    const double left = 0.075 + place * width;
    const double right = left + width - 0.025;
    put_points(p, kind);
    put_front(p, kind);
    printf("set label %d '%s' at graph 0, 1 offset 0, 0.8 left font ',12'\n", TITLE, kinds[kind].title);
    printf("set xlabel 'instructions per second, %s'\n", kinds[kind].machine);
    printf("set ylabel '%s%s%s' offset 1, 0\n", place == 0 ? "error after " : "", place == 0 ? time : "",
           place == 0 ? " s" : "");
    gnuplot_decades('y', p->error[0] / 30, p->error[1] * 30, place == 0);
    gnuplot_decades('x', p->cost[0] / 1.5, p->cost[1] * 1.5, true);
    gnuplot_panel(left, right, 1 - 80.0 / HEIGHT, 1 - 310.0 / HEIGHT);
    put_curves(p, kind, 1, true);
    printf("unset label %d\nunset label %d\nunset label %d\n", CHEAPEST, MOST_EXACT, HEAD);
    put_step_axis(p);
    gnuplot_panel(left, right, 1 - 395.0 / HEIGHT, 1 - 600.0 / HEIGHT);
    put_curves(p, kind, 3, false);
}

/* The names of the methods in a panel of its own below the others: a row for each family. */
static void put_legend(const picture *const p)
{
    enum { FIRST_LABEL = 10 };
    int label = FIRST_LABEL;
    int row = 0;
    puts("unset border\nunset tics\nunset grid\nunset xlabel\nunset ylabel\nunset logscale\nunset label");
    printf("set xrange [0:%d]\nset yrange [100:0]\n", (int)WIDTH);
    gnuplot_panel(0, 1, 100.0 / HEIGHT, 0);
    printf("$legend_front << END\n%d 12\n%d 12\nEND\n", 85, 115);
    printf("set label %d 'Pareto front' at 122, 12 left\n", label++);
    printf("set label %d 'no other point has a smaller error and fewer instructions' at 232, 12 left\n", label++);
    for (int family = 0; family < FAMILIES; family++) {
        int column = 0;
        for (size_t m = 0; m < p->count; m++) {
            if (p->methods[m].family == family) {
                const int x = 220 + 150 * column;
                const int y = 30 + 16 * row;
                if (column++ == 0) {
                    printf("set label %d '%s:' at 85, %d left\n", label++, families[family], y);
                }
                printf("set label %d '%s' noenhanced at %d, %d left\n", label++, p->methods[m].method, x + 12, y);
                printf("$legend_%s << END\n%d %d\n%d %d\n%d %d\nEND\n", p->methods[m].method, x - 20, y, x - 7, y,
                       x + 6, y);
            }
        }
        row += column > 0;
    }
    printf("plot $legend_front with lines linewidth 6 linecolor rgb '%s'", FRONT_COLOUR);
    for (size_t m = 0; m < p->count; m++) {
        printf(", $legend_%s ", p->methods[m].method);
        put_line(&p->methods[m]);
    }
    putchar('\n');
}

void picture_work_precision(const char *const scene, const char *const time, const char *const path)
{
    picture p = read_picture(path);
    if (p.error[1] > 0) {
        int places = 0;
        for (size_t kind = 0; kind < KINDS; kind++) {
            places += has_points(&p, kind, NULL);
        }
        printf("# size %d %d\nset multiplot\n", (int)WIDTH, (int)HEIGHT);
        gnuplot_style();
        puts("set logscale xy\nset mxtics 1\nset mytics 1");
        printf("set label %d '%s: error over cost' noenhanced at screen 0.075, %.5f left font ',14'\n", HEAD, scene,
               1 - 30.0 / HEIGHT);
        int place = 0;
        for (size_t kind = 0; kind < KINDS; kind++) {
            if (has_points(&p, kind, NULL)) {
                put_kind(&p, kind, time, place++, places);
            }
        }
        put_legend(&p);
        puts("unset multiplot");
    }
    table_free(&p.rows);
}
