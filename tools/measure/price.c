/* The cost and the influence of each effect of a scene, from the counts of tools/measure/price.sh and the traces beside them.
 *
 *     price FOLDER effects.tsv
 *
 * FOLDER/counts has a line for each effect: its name and kind, and what was counted of the scene without it. Then come two
 * lines without a name: `base`, the scene without any effect, and `whole`, the scene. FOLDER/without-NAME/trace.csv and
 * FOLDER/whole/trace.csv are runs of the same time. Prints two tables in Markdown and writes one, separated by tabs.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/table/table.h"

enum { COUNTS = 10, PATH_BYTES = 4096 };

static const char *const headings[COUNTS] = {
    "add",       "mul",           "div",       "sincos", "instructions of a step",
    "of a tick", "bytes of text", "of memory", "states", "memories"};
static const char *const keys[COUNTS] = {"add",  "mul",  "div",    "sincos", "step",
                                         "tick", "text", "memory", "states", "memories"};

/* The change of an output by an effect: of its values with the effect less those without it, over the ticks of both runs. */
typedef struct change {
    bool known; /* false: without the effect there is no such output */
    double rms, largest;
    double part; /* the rms over that of the output itself, with or without, whichever is larger */
} change;

typedef struct effect {
    const char *name, *kind;
    double cost[COUNTS];
    change *of; /* by output */
    double end; /* s, of a run without it that the guard stopped; else 0 */
} effect;

typedef struct prices {
    table counts, run, units; /* the run of the whole scene */
    size_t outputs, count;
    effect *effects;
    double base[COUNTS], whole[COUNTS], sum[COUNTS];
} prices;

_Noreturn static void fail(const char *const what)
{
    fprintf(stderr, "price: %s\n", what);
    exit(EXIT_FAILURE);
}

static table read_beside(const char *const folder, const char *const place, const char *const name,
                         const char separator)
{
    char path[PATH_BYTES];
    const int length = snprintf(path, sizeof path, "%s/%s%s", folder, place, name);
    if (length < 0 || length >= (int)sizeof path) {
        fail("the path of the folder is too long");
    }
    return table_read(path, separator);
}

/* The column of an output in a run, 0 if it has none: there the time is. */
static size_t column_of(const table *const run, const char *const output)
{
    for (size_t column = 1; column < table_cells(run, 0); column++) {
        if (strcmp(table_text(run, 0, column), output) == 0) {
            return column;
        }
    }
    return 0;
}

static change change_of(const table *const with, const table *const without, const size_t column)
{
    const size_t other = column_of(without, table_text(with, 0, column));
    const size_t rows = with->rows < without->rows ? with->rows : without->rows;
    double squares = 0;
    double squares_with = 0;
    double squares_without = 0;
    change result = {.known = other > 0 && rows > 1};
    for (size_t row = 1; row < rows && result.known; row++) {
        const double a = table_number(with, row, column);
        const double b = table_number(without, row, other);
        squares += (a - b) * (a - b);
        squares_with += a * a;
        squares_without += b * b;
        result.largest = fmax(result.largest, fabs(a - b));
    }
    result.rms = result.known ? sqrt(squares / (double)(rows - 1)) : 0;
    result.part = squares > 0 ? sqrt(squares / fmax(squares_with, squares_without)) : 0;
    return result;
}

static void read_changes(prices *const all, const char *const folder, effect *const e)
{
    char place[PATH_BYTES];
    (void)snprintf(place, sizeof place, "without-%s", e->name);
    table run = read_beside(folder, place, "/trace.csv", ',');
    e->of = table_memory(all->outputs, sizeof *e->of);
    for (size_t i = 0; i < all->outputs; i++) {
        e->of[i] = change_of(&all->run, &run, i + 1);
    }
    e->end = run.rows < all->run.rows ? table_number(&run, run.rows - 1, 0) : 0;
    table_free(&run);
}

static prices read_prices(const char *const folder)
{
    prices all = {.counts = read_beside(folder, "", "counts", ' ')};
    if (all.counts.rows < 3) {
        fail("there are no counts");
    }
    all.run = read_beside(folder, "whole", "/trace.csv", ',');
    all.units = read_beside(folder, "whole", "/units.csv", ',');
    all.outputs = table_cells(&all.run, 0) - 1;
    all.count = all.counts.rows - 2;
    all.effects = table_memory(all.count, sizeof *all.effects);
    for (size_t i = 0; i < COUNTS; i++) {
        all.base[i] = table_number(&all.counts, all.count, i + 2);
        all.whole[i] = table_number(&all.counts, all.count + 1, i + 2);
    }
    for (size_t row = 0; row < all.count; row++) {
        effect *const e = &all.effects[row];
        e->name = table_text(&all.counts, row, 0);
        e->kind = table_text(&all.counts, row, 1);
        for (size_t i = 0; i < COUNTS; i++) {
            e->cost[i] = all.whole[i] - table_number(&all.counts, row, i + 2);
            all.sum[i] += e->cost[i];
        }
        read_changes(&all, folder, e);
    }
    return all;
}

static const char *unit_of(const prices *const all, const size_t output)
{
    const char *const unit = table_text(&all->units, 1, output + 1);
    return strcmp(unit, "1") == 0 ? "" : unit;
}

/* The output that an effect changes most, as a part of the output itself; NULL if it changes none. */
static const change *most_changed(const prices *const all, const effect *const e)
{
    const change *most = NULL;
    for (size_t i = 0; i < all->outputs; i++) {
        if (e->of[i].part > (most == NULL ? 0 : most->part)) {
            most = &e->of[i];
        }
    }
    return most;
}

static void print_heading(const char *const first)
{
    printf("| %s |", first);
    for (size_t i = 0; i < COUNTS; i++) {
        printf(" %s |", headings[i]);
    }
    printf(" change, rms | largest | of |\n|---|");
    for (size_t i = 0; i < COUNTS + 2; i++) {
        printf("--:|");
    }
    puts("---|");
}

static void print_costs(const double *const cost, const bool is_difference)
{
    for (size_t i = 0; i < COUNTS; i++) {
        printf(is_difference ? " %+.0f |" : " %.0f |", cost[i]);
    }
}

static void print_rows(const prices *const all)
{
    print_heading("effect");
    for (const effect *e = all->effects; e < all->effects + all->count; e++) {
        const change *const most = most_changed(all, e);
        printf("| %s, %s |", e->name, e->kind);
        print_costs(e->cost, true);
        if (most == NULL) {
            puts(" 0 | 0 | |");
        } else {
            const size_t i = (size_t)(most - e->of);
            printf(" %.3g | %.3g | %s%s%s |\n", most->rms, most->largest, table_text(&all->run, 0, i + 1),
                   unit_of(all, i)[0] == '\0' ? "" : ", ", unit_of(all, i));
        }
    }
    fputs("| base, without any |", stdout);
    print_costs(all->base, false);
    fputs(" | | |\n| sum of the effects |", stdout);
    print_costs(all->sum, true);
    fputs(" | | |\n| whole |", stdout);
    print_costs(all->whole, false);
    puts(" | | |");
}

/* The change of every output by every effect. */
static void print_changes(const prices *const all)
{
    fputs("\n| change, rms; largest | unit |", stdout);
    for (size_t e = 0; e < all->count; e++) {
        printf(" %s |", all->effects[e].name);
    }
    fputs("\n|---|---|", stdout);
    for (size_t e = 0; e < all->count; e++) {
        fputs("--:|", stdout);
    }
    putchar('\n');
    for (size_t i = 0; i < all->outputs; i++) {
        printf("| %s | %s |", table_text(&all->run, 0, i + 1), unit_of(all, i));
        for (size_t e = 0; e < all->count; e++) {
            const change *const c = &all->effects[e].of[i];
            if (c->known) {
                printf(" %.3g; %.3g |", c->rms, c->largest);
            } else {
                fputs(" gone |", stdout);
            }
        }
        putchar('\n');
    }
    for (size_t e = 0; e < all->count; e++) {
        if (all->effects[e].end > 0) {
            printf("\nWithout %s the guard stops the run at %.9g s; the changes are until then.\n",
                   all->effects[e].name, all->effects[e].end);
        }
    }
}

static void write_costs(FILE *const file, const char *const name, const char *const kind, const double *const cost)
{
    fprintf(file, "%s\t%s", name, kind);
    for (size_t i = 0; i < COUNTS; i++) {
        fprintf(file, "\t%.0f", cost[i]);
    }
}

/* A line for each effect, then base, sum and whole; a change that there is not is empty. */
static void write_table(const prices *const all, FILE *const file)
{
    fputs("effect\tkind", file);
    for (size_t i = 0; i < COUNTS; i++) {
        fprintf(file, "\t%s", keys[i]);
    }
    fputs("\tpart\tof", file);
    for (size_t i = 0; i < all->outputs; i++) {
        const char *const output = table_text(&all->run, 0, i + 1);
        fprintf(file, "\t%s_rms\t%s_largest", output, output);
    }
    for (const effect *e = all->effects; e < all->effects + all->count; e++) {
        const change *const most = most_changed(all, e);
        fputc('\n', file);
        write_costs(file, e->name, e->kind, e->cost);
        fprintf(file, "\t%.9g\t%s", most == NULL ? 0 : most->part,
                most == NULL ? "" : table_text(&all->run, 0, (size_t)(most - e->of) + 1));
        for (size_t i = 0; i < all->outputs; i++) {
            if (e->of[i].known) {
                fprintf(file, "\t%.9g\t%.9g", e->of[i].rms, e->of[i].largest);
            } else {
                fputs("\t\t", file);
            }
        }
    }
    fputc('\n', file);
    write_costs(file, "", "base", all->base);
    fputc('\n', file);
    write_costs(file, "", "sum", all->sum);
    fputc('\n', file);
    write_costs(file, "", "whole", all->whole);
    fputc('\n', file);
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        fputs("usage: price FOLDER TABLE\n", stderr);
        return EXIT_FAILURE;
    }
    prices all = read_prices(argv[1]);
    FILE *const file = fopen(argv[2], "w");
    if (file == NULL) {
        fail("the table cannot be written");
    }
    write_table(&all, file);
    if (fclose(file) != 0) {
        fail("the table cannot be written");
    }
    print_rows(&all);
    print_changes(&all);
    for (size_t e = 0; e < all.count; e++) {
        free(all.effects[e].of);
    }
    free(all.effects);
    table_free(&all.counts);
    table_free(&all.run);
    table_free(&all.units);
    return EXIT_SUCCESS;
}
