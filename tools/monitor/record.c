#include "tools/monitor/monitor.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "tools/file/file.h"
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

enum { LINE_BYTES = 65536, COLUMNS_MAX = 1024 };

typedef struct lines {
    FILE *file;
    const char *path;
    size_t line;
    char text[LINE_BYTES];
    table_row *rows[COLUMNS_MAX]; /* of the columns behind t */
    size_t count;
} lines;

static bool next_line(lines *const l)
{
    l->line++;
    if (fgets(l->text, sizeof l->text, l->file) == NULL) {
        return false;
    }
    l->text[strcspn(l->text, "\r\n")] = '\0';
    return true;
}

/* The line of names. */
static void head(lines *const l, const a2l *const a, const table *const t)
{
    char *rest = NULL;
    const char *name = next_line(l) ? strtok_r(l->text, ",", &rest) : NULL;
    if (name == NULL || strcmp(name, "t") != 0) {
        quit("monitor: %s:1: a table begins with t and names, such as `t,pole`", l->path);
    }
    for (name = strtok_r(NULL, ",", &rest); name != NULL; name = strtok_r(NULL, ",", &rest)) {
        const a2l_quantity *const q = l->count < COLUMNS_MAX ? a2l_find(a, name) : NULL;
        if (q == NULL) {
            quit("monitor: %s:1: the A2L has no '%.60s'; is the table of this plant?", l->path, name);
        }
        l->rows[l->count++] = &t->rows[q - a->quantities];
    }
}

/* A line of numbers. */
static void take_line(const lines *const l, table *const t)
{
    const char *at = l->text;
    char *end = NULL;
    t->time = strtod(at, &end);
    size_t taken = 0;
    for (; taken < l->count && end != at && *end == ','; taken++) {
        at = end + 1;
        table_set(l->rows[taken], strtod(at, &end));
    }
    if (end == at || *end != '\0' || taken < l->count) {
        quit("monitor: %s:%zu: expected %zu numbers, separated by commas", l->path, l->line, l->count + 1);
    }
}

void record_replay(const char *const path, const a2l *const a, table *const t, record_shown *const shown,
                   void *const context)
{
    lines *const l = memory_for(1, sizeof *l);
    l->path = path;
    l->file = fopen(path, "r");
    if (l->file == NULL) {
        quit("monitor: %s: %s", path, strerror(errno));
    }
    double due = 0;
    bool goes_on = true;
    head(l, a, t);
    while (goes_on && next_line(l)) {
        take_line(l, t);
        if (t->time >= due) {
            table_step(t);
            due = t->time + TABLE_PERIOD;
            goes_on = shown(context);
        }
    }
    fclose(l->file);
    free(l);
}
