#include "tools/plot/pictures.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/plot/gnuplot.h"
#include "tools/plot/signals.h"

enum { BINS = 32, BOUND_BYTES = 16 };

static const double below_one = 0.5; /* where the bars begin: a bin of one tick has a height too */

/* The histogram in the summary: lines `histogram 0 to 31250 ns: 9999`, and of the last bin `histogram from 968750 ns: 1`. */
typedef struct histogram {
    double ticks[BINS];
    double width, all;
    char unit[BOUND_BYTES];
} histogram;

static void take_line(histogram *const h, const table *const run, const size_t row)
{
    const bool is_last = strcmp(table_text(run, row, 1), "from") == 0;
    const size_t behind = is_last ? 3 : 4;
    const double from = table_number(run, row, is_last ? 2 : 1), ticks = table_number(run, row, behind + 1);
    h->width = is_last ? from / (BINS - 1) : table_number(run, row, 3) - from;
    const long bin = lround(from / h->width);
    if (bin >= 0 && bin < BINS) {
        h->ticks[bin] = ticks;
        h->all += ticks;
    }
    (void)snprintf(h->unit, sizeof h->unit, "%.*s", (int)strcspn(table_text(run, row, behind), ":"),
                   table_text(run, row, behind));
}

static histogram histogram_of(const table *const run)
{
    histogram h = {.all = 0};
    for (size_t row = 0; row < run->rows; row++) {
        if (strcmp(table_text(run, row, 0), "histogram") == 0) {
            take_line(&h, run, row);
        }
    }
    return h;
}

/* Each bin that is not empty: its bounds and its ticks; and the same as a line along its top. */
static void put_bins(const histogram *const h, const double scale)
{
    puts("$bars << END");
    for (int i = 0; i < BINS; i++) {
        if (h->ticks[i] > 0) {
            const double from = i * h->width * scale, to = (i + 1) * h->width * scale;
            printf("%.9g %.9g %.9g %.9g %.9g %.9g\n", (from + to) / 2, h->ticks[i], from, to, below_one, h->ticks[i]);
        }
    }
    puts("END\n$tops << END");
    for (int i = 0; i < BINS; i++) {
        if (h->ticks[i] > 0) {
            printf("%.9g %.9g\n%.9g %.9g\n\n", i * h->width * scale, h->ticks[i], (i + 1) * h->width * scale,
                   h->ticks[i]);
        }
    }
    puts("END");
}

void picture_histogram(const char *const directory)
{
    signals s = signals_read(directory);
    const histogram h = histogram_of(&s.run);
    if (h.all > 0) {
        const bool is_time = strcmp(h.unit, "ns") == 0;
        const double scale = is_time ? 1e-3 : 1;
        double most = 0;
        for (int i = 0; i < BINS; i++) {
            most = fmax(most, h.ticks[i]);
        }
        puts("# size 720 360");
        gnuplot_style();
        put_bins(&h, scale);
        puts("set logscale y");
        gnuplot_decades('y', below_one, 2 * most, true);
        gnuplot_range('x', 0, BINS * h.width * scale);
        printf("set xrange [0:%.9g]\n", BINS * h.width * scale);
        printf("set xlabel 'execution of a step, %s, to the end of the period; the last bin is open'\n",
               is_time ? "us" : h.unit);
        puts("set ylabel 'ticks'");
        fputs("set title ", stdout);
        put_title(&s);
        printf(" noenhanced\nplot $bars using 1:2:3:4:5:6 with boxxyerror fill solid 0.5 noborder linecolor rgb '%s', "
               "$tops with lines linewidth 1.6 linecolor rgb '%s'\n",
               colours[0], colours[0]);
    }
    signals_free(&s);
}
