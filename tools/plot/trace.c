#include <math.h>
#include <stdio.h>

#include "tools/plot/gnuplot.h"
#include "tools/plot/pictures.h"
#include "tools/plot/signals.h"

/* In pixels: the picture, and above, of and below the panels. */
enum { WIDTH = 900, HEAD = 60, PANEL = 118, GAP = 34, FOOT = 36 };
enum { STRETCHES = 300 };

static void put_range(const signals *const s, const group *const g)
{
    double least = HUGE_VAL;
    double most = -HUGE_VAL;
    for (size_t i = 0; i < g->members; i++) {
        least = fmin(least, s->least[g->column[i]]);
        most = fmax(most, s->most[g->column[i]]);
    }
    gnuplot_range('y', least, most);
}

static void put_panel(const signals *const s, const group *const g, const double top, const double bottom,
                      const bool last)
{
    put_range(s, g);
    gnuplot_panel(0.09, 0.975, top, bottom);
    printf("set label 1 ");
    put_label(g, "", g->stem);
    puts(" noenhanced at graph 0, 1 offset 0, 0.6 left font ',11'");
    puts(last ? "set xlabel 't, s'\nset format x '%g'" : "unset xlabel\nset format x ''");
    puts(g->members > 1 ? "set key on at graph 1, 1.02 right bottom horizontal samplen 1.5" : "set key off");
    for (size_t i = 0; i < g->members; i++) {
        printf("%s $column%zu with lines linewidth 1.2 linecolor rgb '%s' title '%c'", i == 0 ? "plot" : ",",
               g->column[i], colours[i], g->members == QUATERNION ? "wxyz"[i] : "xyz"[i]);
    }
    putchar('\n');
}

void picture_trace(const char *const directory, char *const *const names, const size_t count)
{
    signals s = signals_read(directory);
    if (count > 0) {
        signals_choose(&s, names, count);
    }
    const double total = HEAD + PANEL * (double)s.group_count + FOOT;
    gnuplot_style();
    for (size_t i = 0; i < s.group_count; i++) {
        for (size_t member = 0; member < s.groups[i].members; member++) {
            put_column(&s, s.groups[i].column[member], 0, STRETCHES);
        }
    }
    printf("# size %d %.0f\nset multiplot\nset label 2 ", (int)WIDTH, total);
    put_title(&s);
    printf(" noenhanced at screen 0.09, %.5f left font ',14'\n", 1 - 22 / total);
    printf("set xrange [0:%.9g]\n", s.most[0]);
    for (size_t i = 0; i < s.group_count; i++) {
        const double top = HEAD + PANEL * (double)i;
        put_panel(&s, &s.groups[i], 1 - top / total, 1 - (top + PANEL - GAP) / total, i + 1 == s.group_count);
        puts("unset label 2");
    }
    puts("unset multiplot");
    signals_free(&s);
}
