#include "tools/monitor/monitor.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "tools/file/file.h"

enum { STATISTICS_A_LINE = 3 };

static const char statistics[] = "statistics.";

void display_make(display *const d, const a2l *const a)
{
    *d = (display){.count = a->count, .rows = memory_for(a->count, sizeof *d->rows)};
    for (size_t i = 0; i < a->count; i++) {
        d->rows[i].quantity = &a->quantities[i];
    }
}

void display_set(display_row *const row, const double value)
{
    row->value = value;
    if (row->points == 0) {
        row->points = 1;
        row->curve[DISPLAY_CURVE - 1] = value;
    }
}

void display_step(display *const d)
{
    for (size_t i = 0; i < d->count; i++) {
        display_row *const row = &d->rows[i];
        if (row->points > 0) {
            memmove(row->curve, row->curve + 1, (DISPLAY_CURVE - 1) * sizeof row->curve[0]);
            row->curve[DISPLAY_CURVE - 1] = row->value;
            row->points += row->points < DISPLAY_CURVE;
        }
    }
}

/* Blocks of an eighth to a whole line, from the least to the most value of the curve. */
static void write_curve(FILE *const to, const display_row *const row)
{
    static const char *const blocks[] = {"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
    enum { BLOCKS = sizeof blocks / sizeof blocks[0] };
    double least = DBL_MAX, most = -DBL_MAX;
    for (size_t i = DISPLAY_CURVE - row->points; i < DISPLAY_CURVE; i++) {
        least = fmin(least, row->curve[i]);
        most = fmax(most, row->curve[i]);
    }
    for (size_t i = DISPLAY_CURVE - row->points; i < DISPLAY_CURVE; i++) {
        const double part = most > least ? (row->curve[i] - least) / (most - least) : 0.0;
        const bool is_number = part >= 0 && part <= 1;
        fputs(is_number ? blocks[(size_t)(part * (BLOCKS - 1) + 0.5)] : "?", to);
    }
}

static bool is_statistic(const display_row *const row)
{
    return strncmp(row->quantity->name, statistics, sizeof statistics - 1) == 0;
}

/* A count is shown with all digits, as far as a double is exact; a larger one, as for `without an end`, is not. */
static int digits(const display_row *const row)
{
    const bool is_whole = row->quantity->type == A2L_UNSIGNED || row->quantity->type == A2L_SIGNED;
    return is_whole && fabs(row->value) < 1e12 ? 12 : 4;
}

static void write_statistics(FILE *const to, const display *const d)
{
    int shown = 0;
    for (size_t i = 0; i < d->count; i++) {
        const display_row *const row = &d->rows[i];
        if (row->points > 0 && is_statistic(row)) {
            const bool is_last = ++shown % STATISTICS_A_LINE == 0;
            fprintf(to, "%-18s %-12.*g%s", row->quantity->name + sizeof statistics - 1, digits(row), row->value,
                    is_last ? "\n" : " ");
        }
    }
    fputs(shown % STATISTICS_A_LINE == 0 ? "" : "\n", to);
}

void display_write(FILE *const to, const display *const d)
{
    int width = 0;
    for (size_t i = 0; i < d->count; i++) {
        const int length = (int)strlen(d->rows[i].quantity->name);
        width = d->rows[i].points > 0 && !is_statistic(&d->rows[i]) && length > width ? length : width;
    }
    fprintf(to, "t %.3f s%s\n", d->time, d->rests ? "  rests" : "");
    for (size_t i = 0; i < d->count; i++) {
        const display_row *const row = &d->rows[i];
        if (row->points > 0 && !is_statistic(row)) {
            fprintf(to, "%-*s %13.6g %-10s ", width, row->quantity->name, row->value, row->quantity->unit);
            write_curve(to, row);
            fputc('\n', to);
        }
    }
    write_statistics(to, d);
}
