#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/plot/gnuplot.h"
#include "tools/plot/pictures.h"
#include "tools/plot/signals.h"

/* In pixels: the picture, and above, of and below the panels. */
enum { WIDTH = 900, HEAD = 60, PANEL = 118, GAP = 34, FOOT = 36 };
enum { STRETCHES = 300, RUNS = 2 };

/* An output that both runs have. */
typedef struct shared {
    const char *name;
    const char *unit;
    size_t column[RUNS];
} shared;

/* A time that both runs have: the row of each. */
typedef struct instant {
    size_t row[RUNS];
} instant;

typedef struct comparison {
    const char *name[RUNS];
    signals run[RUNS];
    shared *outputs;
    size_t output_count;
    instant *instants;
    size_t instant_count;
} comparison;

static const char *last_part(const char *const path)
{
    const char *const slash = strrchr(path, '/');
    return slash == NULL ? path : slash + 1;
}

static const char *unit_of(const signals *const s, const size_t column)
{
    return s->units.rows > 1 ? table_text(&s->units, 1, column) : "";
}

/* The column of this name, 0 if there is none. */
static size_t column_of(const signals *const s, const char *const name)
{
    for (size_t column = 1; column < s->columns; column++) {
        if (strcmp(table_text(&s->rows, 0, column), name) == 0) {
            return column;
        }
    }
    return 0;
}

static void find_outputs(comparison *const c)
{
    const signals *const a = &c->run[0];
    const signals *const b = &c->run[1];
    c->outputs = table_memory(a->columns, sizeof *c->outputs);
    for (size_t column = 1; column < a->columns; column++) {
        const char *const name = table_text(&a->rows, 0, column);
        const size_t other = column_of(b, name);
        if (other == 0) {
            continue;
        }
        if (strcmp(unit_of(a, column), unit_of(b, other)) != 0) {
            fprintf(stderr, "compare: %s is in '%s' in %s, and in '%s' in %s\n", name, unit_of(a, column), c->name[0],
                    unit_of(b, other), c->name[1]);
            exit(EXIT_FAILURE);
        }
        c->outputs[c->output_count++] = (shared){.name = name, .unit = unit_of(a, column), .column = {column, other}};
    }
    if (c->output_count == 0) {
        fprintf(stderr, "compare: %s and %s have no output in common\n", c->name[0], c->name[1]);
        exit(EXIT_FAILURE);
    }
}

/* Times are ticks times a step, rounded: the same where they differ by less than a thousandth of the shorter step. */
static void find_instants(comparison *const c)
{
    const signals *const a = &c->run[0];
    const signals *const b = &c->run[1];
    const double steps[RUNS] = {a->count > 1 ? signal_at(a, 1, 0) : HUGE_VAL,
                                b->count > 1 ? signal_at(b, 1, 0) : HUGE_VAL};
    const double near = 1e-3 * fmin(steps[0], steps[1]);
    c->instants = table_memory(a->count, sizeof *c->instants);
    size_t other = 0;
    for (size_t row = 0; row < a->count; row++) {
        const double t = signal_at(a, row, 0);
        while (other + 1 < b->count && signal_at(b, other, 0) < t - near) {
            other++;
        }
        if (fabs(signal_at(b, other, 0) - t) < near) {
            c->instants[c->instant_count++] = (instant){.row = {row, other}};
        }
    }
    if (c->instant_count < 2) {
        fprintf(
            stderr,
            "compare: %s has a row every %g s and %s every %g s: they have no time in common but the start; run both "
            "with one STEP, or a multiple of it\n",
            c->name[0], steps[0], c->name[1], steps[1]);
        exit(EXIT_FAILURE);
    }
}

static comparison read_both(const char *const first, const char *const second)
{
    comparison c = {
        .name = {last_part(first), last_part(second)},
        .run = {signals_read(first), signals_read(second)},
    };
    find_outputs(&c);
    find_instants(&c);
    return c;
}

static void free_both(comparison *const c)
{
    free(c->outputs);
    free(c->instants);
    signals_free(&c->run[0]);
    signals_free(&c->run[1]);
}

static double value(const comparison *const c, const size_t run, const shared *const s, const size_t at)
{
    return signal_at(&c->run[run], c->instants[at].row[run], s->column[run]);
}

static void put_panel(const comparison *const c, const size_t number, const double top, const double bottom)
{
    const shared *const s = &c->outputs[number];
    const bool last = number + 1 == c->output_count;
    gnuplot_range('y', fmin(c->run[0].least[s->column[0]], c->run[1].least[s->column[1]]),
                  fmax(c->run[0].most[s->column[0]], c->run[1].most[s->column[1]]));
    gnuplot_panel(0.09, 0.975, top, bottom);
    printf("set label 1 ");
    put_label(&(group){.unit = s->unit}, "", s->name);
    puts(" noenhanced at graph 0, 1 offset 0, 0.6 left font ',11'");
    puts(last ? "set xlabel 't, s'\nset format x '%g'" : "unset xlabel\nset format x ''");
    printf("plot");
    for (size_t run = 0; run < RUNS; run++) {
        printf("%s $run%zu_%zu with lines linewidth %s linecolor rgb '%s' title ", run == 0 ? "" : ",", run, number,
               run == 0 ? "2.2" : "1", colours[run]);
        gnuplot_text(c->name[run]);
        printf(" noenhanced");
    }
    putchar('\n');
}

void picture_compare(const char *const first, const char *const second)
{
    comparison c = read_both(first, second);
    const double total = HEAD + PANEL * (double)c.output_count + FOOT;
    gnuplot_style();
    for (size_t i = 0; i < c.output_count; i++) {
        for (size_t run = 0; run < RUNS; run++) {
            printf("$run%zu_%zu << END\n", run, i);
            put_points(&c.run[run], c.outputs[i].column[run], 0, STRETCHES);
            puts("END");
        }
    }
    printf("# size %d %.0f\nset multiplot\nset key on at screen 0.975, %.5f right top horizontal samplen 1.5\n",
           (int)WIDTH, total, 1 - 8 / total);
    printf("set xrange [0:%.9g]\n", fmax(c.run[0].most[0], c.run[1].most[0]));
    for (size_t i = 0; i < c.output_count; i++) {
        const double top = HEAD + PANEL * (double)i;
        put_panel(&c, i, 1 - top / total, 1 - (top + PANEL - GAP) / total);
        puts("set key off");
    }
    puts("unset multiplot");
    free_both(&c);
}

void table_differences(const char *const first, const char *const second)
{
    comparison c = read_both(first, second);
    printf("%s - %s at %zu times, from 0 to %g s\n", c.name[0], c.name[1], c.instant_count,
           signal_at(&c.run[0], c.instants[c.instant_count - 1].row[0], 0));
    printf("%-24s %-8s %14s %14s %10s\n", "output", "unit", "rms", "largest", "at, s");
    for (size_t i = 0; i < c.output_count; i++) {
        double squares = 0;
        size_t most = 0;
        double largest = 0;
        for (size_t at = 0; at < c.instant_count; at++) {
            const double difference = value(&c, 0, &c.outputs[i], at) - value(&c, 1, &c.outputs[i], at);
            squares += difference * difference;
            most = fabs(difference) > fabs(largest) ? at : most;
            largest = fabs(difference) > fabs(largest) ? difference : largest;
        }
        printf("%-24s %-8s %14.6g %14.6g %10g\n", c.outputs[i].name, c.outputs[i].unit,
               sqrt(squares / (double)c.instant_count), largest, signal_at(&c.run[0], c.instants[most].row[0], 0));
    }
    free_both(&c);
}
