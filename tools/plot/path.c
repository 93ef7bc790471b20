#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tools/plot/gnuplot.h"
#include "tools/plot/pictures.h"
#include "tools/plot/signals.h"

/* In pixels: a square panel with the path, and on its right one with the energy. */
enum { LEFT = 80, SIDE = 300, TOP = 56, HEIGHT = TOP + SIDE + 64, WIDTH_ALONE = LEFT + SIDE + 20, WIDTH = 900 };
enum { POINTS = 1600, STRETCHES = 400 };

/* The first vector that is a place: in m, or where no unit is known. */
static const group *find_point(const signals *const s)
{
    for (size_t i = 0; i < s->group_count; i++) {
        const group *const g = &s->groups[i];
        if (g->members == VECTOR && (strcmp(g->unit, "m") == 0 || g->unit[0] == '\0')) {
            return g;
        }
    }
    return NULL;
}

static const group *find_energy(const signals *const s)
{
    for (size_t i = 0; i < s->group_count; i++) {
        if (strcmp(s->groups[i].unit, "J") == 0 || strcmp(s->groups[i].stem, "energy") == 0) {
            return &s->groups[i];
        }
    }
    return NULL;
}

static double extent(const signals *const s, const size_t column)
{
    return s->most[column] - s->least[column];
}

/* The plane of two components without the one that moves least; in order. */
static void find_plane(const signals *const s, const group *const g, size_t plane[2])
{
    size_t least = g->column[0];
    for (size_t i = 1; i < g->members; i++) {
        least = extent(s, g->column[i]) <= extent(s, least) ? g->column[i] : least;
    }
    size_t count = 0;
    for (size_t i = 0; i < g->members; i++) {
        if (g->column[i] != least) {
            plane[count++] = g->column[i];
        }
    }
}

/* An axis around the middle of a column. */
static void put_axis(const signals *const s, const char axis, const group *const g, const size_t column,
                     const double side)
{
    const double middle = (s->least[column] + s->most[column]) / 2;
    gnuplot_range(axis, middle - side / 2, middle + side / 2);
    printf("set %clabel ", axis);
    put_label(g, "", table_text(&s->rows, 0, column));
    puts(" noenhanced");
}

static void put_path(const signals *const s, const group *const g, const double width)
{
    size_t plane[2];
    find_plane(s, g, plane);
    const size_t every = (s->count + POINTS - 1) / POINTS;
    puts("$plane << END");
    for (size_t row = 0; row < s->count; row += every) {
        printf("%s %s\n", table_text(&s->rows, row + 1, plane[0]), table_text(&s->rows, row + 1, plane[1]));
    }
    puts("END");
    const double side = fmax(extent(s, plane[0]), extent(s, plane[1]));
    put_axis(s, 'x', g, plane[0], side);
    put_axis(s, 'y', g, plane[1], side);
    gnuplot_panel(LEFT / width, (LEFT + SIDE) / width, 1 - (double)TOP / HEIGHT, 1 - (double)(TOP + SIDE) / HEIGHT);
    printf("plot $plane with lines linewidth 0.8 linecolor rgb '%s'\n", colours[0]);
}

static void put_energy(const signals *const s, const group *const g)
{
    const size_t column = g->column[0];
    const double start = signal_at(s, 0, column);
    put_column(s, column, start, STRETCHES);
    printf("set xrange [0:%.9g]\nset xtics autofreq\n", s->most[0]);
    gnuplot_range('y', s->least[column] - start, s->most[column] - start);
    printf("set xlabel 't, s'\nset ylabel ");
    put_label(g, "change of ", g->stem);
    puts(" noenhanced");
    gnuplot_panel(0.55, 0.975, 1 - (double)TOP / HEIGHT, 1 - (double)(TOP + SIDE) / HEIGHT);
    printf("plot $column%zu with lines linewidth 0.8 linecolor rgb '%s'\n", column, colours[1]);
}

void picture_path(const char *const directory)
{
    signals s = signals_read(directory);
    const group *const point = find_point(&s);
    const group *const energy = find_energy(&s);
    if (point != NULL) {
        const double width = energy == NULL ? WIDTH_ALONE : WIDTH;
        printf("# size %.0f %d\nset multiplot\n", width, (int)HEIGHT);
        gnuplot_style();
        printf("set label 1 ");
        put_title(&s);
        printf(" noenhanced at screen %.5f, %.5f left font ',13'\n", LEFT / width, 1 - 24.0 / HEIGHT);
        put_path(&s, point, width);
        puts("unset label 1");
        if (energy != NULL) {
            put_energy(&s, energy);
        }
        puts("unset multiplot");
    }
    signals_free(&s);
}
