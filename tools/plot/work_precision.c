#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#include "tools/plot/gnuplot.h"
#include "tools/plot/measured.h"
#include "tools/plot/pictures.h"

enum { KINDS = 5 };
enum { WIDTH = 960, HEIGHT = 760 };

/* The legend, in pixels: it has room for so many rows of methods, and a picture with more of them is as much higher. */
enum { LEGEND = 100, LEGEND_ROWS = 4, LEGEND_COLUMNS = 5, ROW = 16, COLUMN = 150 };

static const struct {
    const char *name;
    const char *title;
    const char *machine;
} kinds[KINDS] = {{"float", "float", "Cortex-M4F"},
                  {"compensated", "float, compensated sums", "Cortex-M4F"},
                  {"double", "double", "host"},
                  {"held", "held inputs, double", "host"},
                  {"smooth", "smooth inputs, double", "host"}};

#define FRONT_COLOUR "#f0d060"

typedef struct picture {
    measured m;
    int higher; /* than HEIGHT */
    double height;
} picture;

/* --- The Pareto front --- */

enum { TITLE = 1, CHEAPEST, MOST_EXACT, HEAD };

/* Names an end of the front: the cheapest at the upper edge of the panel, the most exact below its point. */
static void put_end(const measured *const m, const size_t row, const int label, const bool cheapest)
{
    const double cost = cost_of(m, row);
    const bool left = log(cost / m->cost[0]) < log(m->cost[1] / m->cost[0]) / 2;
    printf("set label %d '%s, %.3g ms' noenhanced at first %.9g, ", label, table_text(&m->rows, row, METHOD),
           step_ms(m, row), cost);
    if (cheapest) {
        printf("graph 0.955 ");
    } else {
        printf("first %s offset 0, -0.9 ", table_text(&m->rows, row, ERROR));
    }
    printf("%s font ',10' front\n", left ? "left" : "right");
}

/* The front as a block of data, $front_KIND, and labels at its ends. */
static void put_front(const measured *const m, const char *const kind)
{
    size_t row = next_on_front(m, kind, 0);
    put_end(m, row, CHEAPEST, true);
    printf("$front_%s << END\n", kind);
    for (size_t next = row; next != 0; next = next_on_front(m, kind, cost_of(m, row))) {
        row = next;
        printf("%s %s\n", table_text(&m->rows, row, PER_SECOND), table_text(&m->rows, row, ERROR));
    }
    puts("END");
    put_end(m, row, MOST_EXACT, false);
}

/* --- Panels --- */

static void put_line(const look *const its)
{
    printf("with linespoints linewidth 1.1 pointsize 0.55 pointtype %d linecolor rgb '%s'", its->mark, its->colour);
}

/* The points of each method of a kind, as blocks of data $KIND_METHOD: cost, error, step in ms. */
static void put_points(const measured *const m, const char *const kind)
{
    for (size_t i = 0; i < m->count; i++) {
        const char *const method = m->methods[i].method;
        if (!has_points(m, kind, method)) {
            continue;
        }
        printf("$%s_%s << END\n", kind, method);
        for (size_t row = 1; row < m->rows.rows; row++) {
            if (is_drawn(m, row, kind, method)) {
                printf("%s %s %.9g\n", table_text(&m->rows, row, PER_SECOND), table_text(&m->rows, row, ERROR),
                       step_ms(m, row));
            }
        }
        puts("END");
    }
}

/* Draws a panel of a kind whose abscissa is a column of the points; after the front, if it has that one. */
static void put_curves(const measured *const m, const char *const kind, const int column, const bool front)
{
    const char *comma = "plot";
    if (front) {
        printf("plot $front_%s with lines linewidth 6 linecolor rgb '%s'", kind, FRONT_COLOUR);
        comma = ",";
    }
    for (size_t i = 0; i < m->count; i++) {
        if (has_points(m, kind, m->methods[i].method)) {
            printf("%s $%s_%s using %d:2 ", comma, kind, m->methods[i].method, column);
            put_line(&m->methods[i]);
            comma = ",";
        }
    }
    putchar('\n');
}

/* Labels at the steps of fixed methods, and by twos at whatever lies beyond them; every other one has a text. */
static void put_step_axis(const measured *const m)
{
    const double longest = longest_fixed_step(m);
    double step = longest > 0 ? longest : m->step[1];
    while (2 * step <= 1.25 * m->step[1]) {
        step *= 2;
    }
    printf("set xrange [%.4g:%.4g]\nset xtics (", m->step[0] * 0.8, m->step[1] * 1.25);
    const char *comma = "";
    for (int i = 0; step >= 0.8 * m->step[0]; i++) {
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
    const measured *const m = &p->m;
    const double width = 0.91 / places;
    const double left = 0.075 + place * width;
    const double right = left + width - 0.025;
    put_points(m, kinds[kind].name);
    put_front(m, kinds[kind].name);
    printf("set label %d '%s' at graph 0, 1 offset 0, 0.8 left font ',12'\n", TITLE, kinds[kind].title);
    printf("set xlabel 'instructions per second, %s'\n", kinds[kind].machine);
    printf("set ylabel '%s%s%s' offset 1, 0\n", place == 0 ? "error after " : "", place == 0 ? time : "",
           place == 0 ? " s" : "");
    gnuplot_decades('y', m->error[0] / 30, m->error[1] * 30, place == 0);
    gnuplot_decades('x', m->cost[0] / 1.5, m->cost[1] * 1.5, true);
    gnuplot_panel(left, right, 1 - 80.0 / p->height, 1 - 310.0 / p->height);
    put_curves(m, kinds[kind].name, 1, true);
    printf("unset label %d\nunset label %d\nunset label %d\n", CHEAPEST, MOST_EXACT, HEAD);
    put_step_axis(m);
    gnuplot_panel(left, right, 1 - 395.0 / p->height, 1 - 600.0 / p->height);
    put_curves(m, kinds[kind].name, 3, false);
}

/* --- The legend --- */

/* The rows that the methods of a family take. */
static int family_rows(const measured *const m, const method_family family)
{
    int methods = 0;
    for (size_t i = 0; i < m->count; i++) {
        methods += m->methods[i].family == family;
    }
    return (methods + LEGEND_COLUMNS - 1) / LEGEND_COLUMNS;
}

static int legend_rows(const measured *const m)
{
    int rows = 0;
    for (method_family family = 0; family < FAMILIES; family++) {
        rows += family_rows(m, family);
    }
    return rows;
}

/* The names of the methods in a panel of its own below the others: each family begins a row. */
static void put_legend(const picture *const p)
{
    enum { FIRST_LABEL = 10 };
    const measured *const m = &p->m;
    int label = FIRST_LABEL;
    int row = 0;
    puts("unset border\nunset tics\nunset grid\nunset xlabel\nunset ylabel\nunset logscale\nunset label");
    printf("set xrange [0:%d]\nset yrange [%d:0]\n", (int)WIDTH, (int)LEGEND + p->higher);
    gnuplot_panel(0, 1, (LEGEND + p->higher) / p->height, 0);
    printf("$legend_front << END\n%d 12\n%d 12\nEND\n", 85, 115);
    printf("set label %d 'Pareto front' at 122, 12 left\n", label++);
    printf("set label %d 'no other point has a smaller error and fewer instructions' at 232, 12 left\n", label++);
    for (method_family family = 0; family < FAMILIES; family++) {
        int number = 0;
        for (size_t i = 0; i < m->count; i++) {
            if (m->methods[i].family == family) {
                const int x = 220 + COLUMN * (number % LEGEND_COLUMNS);
                const int y = 30 + ROW * (row + number / LEGEND_COLUMNS);
                if (number++ == 0) {
                    printf("set label %d '%s:' at 85, %d left\n", label++, family_name(family), y);
                }
                printf("set label %d '%s' noenhanced at %d, %d left\n", label++, m->methods[i].method, x + 12, y);
                printf("$legend_%s << END\n%d %d\n%d %d\n%d %d\nEND\n", m->methods[i].method, x - 20, y, x - 7, y,
                       x + 6, y);
            }
        }
        row += family_rows(m, family);
    }
    printf("plot $legend_front with lines linewidth 6 linecolor rgb '%s'", FRONT_COLOUR);
    for (size_t i = 0; i < m->count; i++) {
        printf(", $legend_%s ", m->methods[i].method);
        put_line(&m->methods[i]);
    }
    putchar('\n');
}

static void put_picture(const picture *const p, const char *const scene, const char *const time)
{
    int places = 0;
    for (size_t kind = 0; kind < KINDS; kind++) {
        places += has_points(&p->m, kinds[kind].name, NULL);
    }
    printf("# size %d %d\nset multiplot\n", (int)WIDTH, HEIGHT + p->higher);
    gnuplot_style();
    puts("set logscale xy\nset mxtics 1\nset mytics 1");
    printf("set label %d '%s: error over cost' noenhanced at screen 0.075, %.5f left font ',14'\n", HEAD, scene,
           1 - 30.0 / p->height);
    int place = 0;
    for (size_t kind = 0; kind < KINDS; kind++) {
        if (has_points(&p->m, kinds[kind].name, NULL)) {
            put_kind(p, kind, time, place++, places);
        }
    }
    put_legend(p);
    puts("unset multiplot");
}

void picture_work_precision(const char *const scene, const char *const time, const char *const path)
{
    picture p = {.m = read_measured(path)};
    const int rows = legend_rows(&p.m);
    p.higher = rows > LEGEND_ROWS ? ROW * (rows - LEGEND_ROWS) : 0;
    p.height = HEIGHT + p.higher;
    if (has_points(&p.m, NULL, NULL)) {
        put_picture(&p, scene, time);
    }
    table_free(&p.m.rows);
}
