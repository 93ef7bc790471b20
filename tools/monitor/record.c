#include "tools/monitor/monitor.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "tools/table/table.h"
#include "tools/trace/decimal.h"

/* --- Writing ----------------------------------------------------------------------------------------------------- */

static void write_row(record *const r)
{
    char text[DECIMAL_BYTES];
    fputs(decimal_of((double)r->tick * r->description->step, sizeof(double), text), r->file);
    for (size_t i = 0; i < r->count; i++) {
        fprintf(r->file, ",%s", decimal_of(r->values[i], a2l_bytes(r->columns[i]->type), text));
    }
    fputc('\n', r->file);
    r->rows++;
}

/* A packet of table 0 has the tick, modulo 2^32; the last table completes a row. */
static void take_sample(void *const context, const uint8_t *const packet, const size_t length)
{
    record *const r = context;
    const uint8_t number = packet[0] & 0x7F;
    size_t at = number == 0 ? 5 : 1;
    r->lost += packet[0] >> 7;
    if (number == 0 && length >= at) {
        r->tick += (uint32_t)(iso_xcp_long(packet + 1) - (uint32_t)r->tick);
    }
    for (size_t i = 0; i < r->count; i++) {
        const size_t bytes = a2l_bytes(r->columns[i]->type);
        if (r->tables[i] == number && at + bytes <= length) {
            r->values[i] = a2l_value(r->columns[i]->type, packet + at);
            at += bytes;
        }
    }
    if (number == r->tables[r->count - 1]) {
        write_row(r);
    }
}

static void choose(record *const r, const char prefix)
{
    for (size_t i = 0; i < r->description->count && r->count < MASTER_LIST_VALUES; i++) {
        const a2l_quantity *const q = &r->description->quantities[i];
        if (q->name[0] == prefix && q->name[1] == '.') {
            r->columns[r->count++] = q;
        }
    }
}

bool record_begin(record *const r, const a2l *const a, master *const m, const char *const path)
{
    *r = (record){.description = a};
    choose(r, 'y');
    choose(r, 'u');
    FILE *const file = fopen(path, "w");
    if (file == NULL) {
        return master_fail(m, "%.200s: %s", path, strerror(errno));
    }
    r->file = file;
    fputc('t', file);
    for (size_t i = 0; i < r->count; i++) {
        fprintf(file, ",%s", r->columns[i]->name + 2);
    }
    fputc('\n', file);
    m->context = r;
    m->sample = take_sample;
    if (!master_measure(m, r->columns, r->count, r->tables)) {
        m->sample = NULL;
        fclose(file);
        r->file = NULL;
        return false;
    }
    return true;
}

bool record_end(record *const r, master *const m)
{
    const bool stopped = master_stop(m), is_whole = fclose(r->file) == 0;
    m->sample = NULL;
    r->file = NULL;
    return stopped && (is_whole || master_fail(m, "the record is not whole: %s", strerror(errno)));
}

/* --- Reading ----------------------------------------------------------------------------------------------------- */

/* The rows of the display for the columns after t, by the line of names. */
static display_row **rows_of(const table *const t, const a2l *const a, const display *const d)
{
    const size_t columns = table_cells(t, 0);
    display_row **const rows = memory_for(columns, sizeof *rows);
    if (strcmp(table_text(t, 0, 0), "t") != 0) {
        quit("monitor: %s:1: a table begins with t and names, such as `t,pole`", t->path);
    }
    for (size_t i = 1; i < columns; i++) {
        char *const name = t->cell[i];
        name[strcspn(name, "\r")] = '\0';
        const a2l_quantity *const q = a2l_find(a, name);
        if (q == NULL) {
            quit("monitor: %s:1: the A2L has no '%.60s'; is the table of this plant?", t->path, name);
        }
        rows[i] = &d->rows[q - a->quantities];
    }
    return rows;
}

/* A line of numbers: the time, and the values of these rows. */
static void take_line(const table *const t, const size_t line, display_row *const *const rows, display *const d)
{
    const size_t columns = table_cells(t, 0);
    bool good = table_cells(t, line) == columns;
    for (size_t i = 0; i < columns && good; i++) {
        const char *const text = table_text(t, line, i);
        char *end = NULL;
        const double value = strtod(text, &end);
        good = end != text && (*end == '\0' || *end == '\r');
        if (i == 0) {
            d->time = value;
        } else {
            display_set(rows[i], value);
        }
    }
    if (!good) {
        quit("monitor: %s:%zu: expected %zu numbers, separated by commas", t->path, line + 1, columns);
    }
}

void record_replay(const char *const path, const a2l *const a, display *const d, record_shown *const shown,
                   void *const context)
{
    const table t = table_read(path, ',');
    display_row **const rows = rows_of(&t, a, d);
    double due = 0;
    bool goes_on = true;
    for (size_t line = 1; line < t.rows && goes_on; line++) {
        take_line(&t, line, rows, d);
        if (d->time >= due) {
            display_step(d);
            due = d->time + DISPLAY_PERIOD;
            goes_on = shown(context);
        }
    }
    free(rows);
}
