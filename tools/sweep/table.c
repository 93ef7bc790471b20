#include "tools/sweep/table.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void put_head(FILE *const to, const plan *const p)
{
    fputs("run", to);
    for (uint64_t i = 0; i < p->variable_count; i++) {
        fprintf(to, "\t%s", p->variables[i].name);
    }
    for (uint64_t i = 0; i < p->column_count; i++) {
        fprintf(to, "\t%s", p->columns[i].name);
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
        fprintf(to, "%s\t%s\tresult\n", p->columns[i].name, p->columns[i].unit);
    }
    fputs("status\t1\tword\n", to);
}

/* The command that makes a run alone. */
static void put_command(FILE *const to, const plan *const p, const uint64_t run, const char *const again)
{
    plan_cell *const cells = memory_for(p->variable_count, sizeof *cells);
    (void)plan_cells(p, run, cells);
    fputs(again, to);
    bool any = false;
    for (uint64_t i = 0; i < p->variable_count; i++) {
        const plan_column *const v = &p->variables[i];
        if (strcmp(v->sort, "method") == 0) {
            fprintf(to, " --method %s", cells[i].text);
        } else if (strcmp(v->sort, "step") == 0) {
            fprintf(to, " --step '%s s'", cells[i].text);
        }
    }
    for (uint64_t i = 0; i < p->variable_count; i++) {
        const plan_column *const v = &p->variables[i];
        if (strcmp(v->sort, "number") == 0) {
            fprintf(to, "%s%s = %s", any ? "; " : " --set '", v->name, cells[i].text);
            fprintf(to, "%s%s", strcmp(v->unit, "1") == 0 ? "" : " ", strcmp(v->unit, "1") == 0 ? "" : v->unit);
            any = true;
        }
    }
    fputs(any ? "'\n" : "\n", to);
    free(cells);
}

/* The status of the run of a row: its last cell. */
static const char *status_of(const char *const row)
{
    const char *const tab = strrchr(row, '\t');
    return tab == NULL ? "" : tab + 1;
}

void table_make(const plan *const p, const char *const folder, const char *const again)
{
    static new_file rows, columns, failures;
    static char row[1 << 16];
    uint64_t run = 0, failed = 0;
    file_must_begin(&rows, "sweep", folder, "sweep.tsv", "partial");
    file_must_begin(&columns, "sweep", folder, "columns.tsv", "partial");
    file_must_begin(&failures, "sweep", folder, "failures.txt", "partial");
    put_head(rows.to, p);
    put_columns(columns.to, p);
    for (uint64_t part = 0; part < p->parts; part++) {
        char path[FILE_PATH_BYTES], name[PLAN_NAME_BYTES];
        snprintf(path, sizeof path, "%s/%s", p->folder, plan_part_name(part, name));
        FILE *const from = fopen(path, "r");
        if (from == NULL) {
            plan_fail(strerror(errno), path);
        }
        while (fgets(row, sizeof row, from) != NULL) {
            if (strchr(row, '\n') == NULL || strtoull(row, NULL, 10) != run || run >= plan_first(p, part + 1)) {
                plan_fail("the part has other runs", path);
            }
            fputs(row, rows.to);
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
    file_must_end(&columns, "sweep");
    file_must_end(&failures, "sweep");
    file_must_end(&rows, "sweep");
    printf("runs %" PRIu64 "\nplants %" PRIu64 "\nfailed %" PRIu64 "\n", p->runs, p->plants, failed);
    printf("table %s\n", rows.path);
    if (failed > 0) {
        printf("failures %s\n", failures.path);
    }
}
