#include "tools/sweep/plan.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

void plan_fail(const char *const what, const char *const which)
{
    quit("sweep: %s: %s", which, what);
}

/* The rows of the text, one after another. */
typedef struct reader {
    table text;
    size_t row;
} reader;

/* The next row, which has so many cells. */
static size_t read_row(reader *const r, const size_t cells)
{
    if (r->row == r->text.rows) {
        plan_fail("the plan is not whole", r->text.path);
    }
    if (table_cells(&r->text, r->row) != cells) {
        plan_fail("a line of the plan has other cells", r->text.path);
    }
    return r->row++;
}

/* The number behind a word. */
static uint64_t read_count(reader *const r, const char *const word)
{
    const char *const line = table_text(&r->text, read_row(r, 1), 0);
    const size_t length = strlen(word);
    char *end = NULL;
    const bool is_it = strncmp(line, word, length) == 0 && line[length] == ' ';
    const uint64_t count = is_it ? strtoull(line + length + 1, &end, 10) : 0;
    if (!is_it || *end != '\0' || count > 10000000) {
        plan_fail("it is no plan of a sweep", r->text.path);
    }
    return count;
}

static plan_column *read_columns(reader *const r, const char *const word, uint64_t *const count)
{
    *count = read_count(r, word);
    plan_column *const all = memory_for(*count, sizeof *all);
    for (uint64_t i = 0; i < *count; i++) {
        char **const cell = r->text.cell + r->text.first[read_row(r, 4)];
        all[i] = (plan_column){cell[0], cell[1], cell[2], atoi(cell[3])};
    }
    return all;
}

plan plan_read(const char *const folder)
{
    static char path[FILE_PATH_BYTES];
    plan p = {.folder = folder, .width = 1};
    snprintf(path, sizeof path, "%s/plan", folder);
    reader r = {.text = table_read(path, '\t')};
    if (read_count(&r, "sweep") != 1) {
        plan_fail("another version of this program wrote the plan", path);
    }
    p.runs = read_count(&r, "runs");
    p.parts = read_count(&r, "parts");
    p.plants = read_count(&r, "plants");
    p.variables = read_columns(&r, "variables", &p.variable_count);
    p.columns = read_columns(&r, "columns", &p.column_count);
    p.output_count = read_count(&r, "outputs");
    p.outputs = table_text(&r.text, read_row(&r, 1), 0);
    p.first_run = r.row;
    p.text = r.text;
    if (p.text.rows - p.first_run < p.runs) {
        plan_fail("the plan is not whole", path);
    }
    if (p.parts == 0 || p.parts > p.runs) {
        plan_fail("it is no plan of a sweep", path);
    }
    return p;
}

void plan_widen(plan *const p, const unsigned width)
{
    const uint64_t groups = (p->runs + width - 1) / width;
    p->width = width;
    p->parts = p->parts < groups ? p->parts : groups;
}

uint64_t plan_first(const plan *const p, const uint64_t part)
{
    const uint64_t groups = (p->runs + p->width - 1) / p->width;
    const uint64_t first = part * groups / p->parts * p->width;
    return first < p->runs ? first : p->runs;
}

uint64_t plan_cells(const plan *const p, const uint64_t run, plan_cell *const cells)
{
    const size_t row = p->first_run + (size_t)run;
    const uint64_t plant = strtoull(table_text(&p->text, row, 0), NULL, 10);
    size_t next = 1;
    for (uint64_t i = 0; i < p->variable_count; i++) {
        cells[i].text = table_text(&p->text, row, next++);
        cells[i].literal = p->variables[i].place >= 0 ? table_text(&p->text, row, next++) : "";
    }
    if (next != table_cells(&p->text, row)) {
        plan_fail("a run of the plan has other cells", p->folder);
    }
    if (plant >= p->plants) {
        plan_fail("a run of the plan is of no plant", p->folder);
    }
    return plant;
}

const char *plan_part_name(const uint64_t part, char name[PLAN_NAME_BYTES])
{
    snprintf(name, PLAN_NAME_BYTES, "parts/%" PRIu64 ".tsv", part);
    return name;
}

bool plan_has_part(const plan *const p, const uint64_t part)
{
    char path[FILE_PATH_BYTES], name[PLAN_NAME_BYTES];
    snprintf(path, sizeof path, "%s/%s", p->folder, plan_part_name(part, name));
    return access(path, F_OK) == 0;
}
