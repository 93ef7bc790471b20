#include "tools/sweep/table.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A file that takes its name when it is whole. */
typedef struct made {
    char path[PLAN_PATH_BYTES], beside[PLAN_PATH_BYTES];
    FILE *to;
} made;

static made begin(const char *const folder, const char *const name)
{
    made m;
    const plan at = {.folder = folder};
    char hidden[64];
    snprintf(hidden, sizeof hidden, ".%s", name);
    plan_path(&at, name, m.path, sizeof m.path);
    plan_path(&at, hidden, m.beside, sizeof m.beside);
    m.to = fopen(m.beside, "w");
    if (m.to == NULL) {
        plan_fail(strerror(errno), m.beside);
    }
    return m;
}

static void end(made *const m)
{
    const bool is_written = ferror(m->to) == 0;
    if (fclose(m->to) != 0 || !is_written || rename(m->beside, m->path) != 0) {
        plan_fail(strerror(errno), m->path);
    }
}

static void put_head(FILE *const to, const plan *const p)
{
    fputs("run", to);
    for (uint64_t i = 0; i < p->variable_count; i++) {
        fprintf(to, "\t%s", p->variables[i].name);
    }
    for (uint64_t i = 0; i < p->column_count; i++) {
        fprintf(to, "\t%s", p->columns[i].title);
    }
    fputs("\tstatus\n", to);
}

static void put_columns(FILE *const to, const plan *const p)
{
    fputs("column\tunit\tsort\nrun\t1\tnumber\n", to);
    for (uint64_t i = 0; i < p->variable_count; i++) {
        fprintf(to, "%s\t%s\tset\n", p->variables[i].name, p->variables[i].unit);
    }
    for (uint64_t i = 0; i < p->column_count; i++) {
        fprintf(to, "%s\t%s\tresult\n", p->columns[i].title, p->columns[i].unit);
    }
    fputs("status\t1\tword\n", to);
}

/* The command that makes a run alone. */
static void put_command(FILE *const to, const plan *const p, const uint64_t run, const char *const again)
{
    plan_cell *const cells = calloc((size_t)p->variable_count + 1, sizeof *cells);
    if (cells == NULL) {
        plan_fail(strerror(errno), "memory");
    }
    (void)plan_cells(p, run, cells);
    fputs(again, to);
    bool any = false;
    for (uint64_t i = 0; i < p->variable_count; i++) {
        const plan_variable *const v = &p->variables[i];
        if (strcmp(v->sort, "method") == 0) {
            fprintf(to, " METHOD=%s", cells[i].text);
        } else if (strcmp(v->sort, "step") == 0) {
            fprintf(to, " STEP='%s s'", cells[i].text);
        }
    }
    for (uint64_t i = 0; i < p->variable_count; i++) {
        const plan_variable *const v = &p->variables[i];
        if (strcmp(v->sort, "number") == 0) {
            fprintf(to, "%s%s = %s", any ? "; " : " SET='", v->name, cells[i].text);
            fprintf(to, "%s%s", strcmp(v->unit, "1") == 0 ? "" : " ", strcmp(v->unit, "1") == 0 ? "" : v->unit);
            any = true;
        }
    }
    fputs(any ? "'\n" : "\n", to);
    free(cells);
}

/* What is the matter with the run of a row: its last cell. */
static const char *status_of(const char *const row)
{
    const char *const tab = strrchr(row, '\t');
    return tab == NULL ? "" : tab + 1;
}

static FILE *opened(const char *const path)
{
    FILE *const from = fopen(path, "r");
    if (from == NULL) {
        plan_fail(strerror(errno), path);
    }
    return from;
}

void table_make(const plan *const p, const char *const folder, const char *const again)
{
    made table = begin(folder, "sweep.tsv"), columns = begin(folder, "columns.tsv"),
         failures = begin(folder, "failures.txt");
    static char row[1 << 16];
    uint64_t run = 0, failed = 0;
    put_head(table.to, p);
    put_columns(columns.to, p);
    for (uint64_t part = 0; part < p->parts; part++) {
        char path[PLAN_PATH_BYTES];
        plan_part_path(p, part, path, sizeof path);
        FILE *const from = opened(path);
        while (fgets(row, sizeof row, from) != NULL) {
            if (strchr(row, '\n') == NULL || strtoull(row, NULL, 10) != run || run >= plan_first(p, part + 1)) {
                plan_fail("the part has other runs", path);
            }
            fputs(row, table.to);
            if (strcmp(status_of(row), "ok\n") != 0) {
                fprintf(failures.to, "run %" PRIu64 ": %s    ", run, status_of(row));
                put_command(failures.to, p, run, again);
                failed++;
            }
            run++;
        }
        if (run != plan_first(p, part + 1)) {
            plan_fail("the part is not whole", path);
        }
        fclose(from);
    }
    end(&columns);
    end(&failures);
    end(&table);
    printf("runs %" PRIu64 "\nplants %" PRIu64 "\nfailed %" PRIu64 "\n", p->runs, p->plants, failed);
    printf("table %s\n", table.path);
    if (failed > 0) {
        printf("failures %s\n", failures.path);
    }
}
