#include "tools/link/link.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/file/file.h"
#include "tools/trace/decimal.h"

enum { LINE_BYTES = 1024, NAME_BYTES = 256 };

/* Two lines of a table: the names of the inputs, and their units, each after a comma. */
typedef struct inputs {
    char *names, *units;
    size_t count;
} inputs;

static FILE *open_file(const char *const path)
{
    FILE *const file = fopen(path, "r");
    if (file == NULL) {
        quit("link: %s: %s", path, strerror(errno));
    }
    return file;
}

static void append(char **const text, const char *const word)
{
    const size_t before = *text == NULL ? 0 : strlen(*text);
    char *const longer = memory_for(before + strlen(word) + 2, 1);
    sprintf(longer, "%s,%s", before == 0 ? "" : *text, word);
    free(*text);
    *text = longer;
}

/* The lines {"volts", "V", -12, 12} of the table whose name ends with _inputs. */
static inputs read_header(const char *const path)
{
    inputs found = {0};
    char line[LINE_BYTES];
    char name[NAME_BYTES];
    char unit[NAME_BYTES];
    bool inside = false;
    FILE *const file = open_file(path);
    while (fgets(line, sizeof line, file) != NULL) {
        if (inside && sscanf(line, " {\"%255[^\"]\", \"%255[^\"]\"", name, unit) == 2) {
            append(&found.names, name);
            append(&found.units, unit);
            found.count++;
        } else {
            inside = strstr(line, "_inputs[") != NULL;
        }
    }
    fclose(file);
    return found;
}

static void put_value(FILE *const to, const uint8_t *const bytes, const size_t count)
{
    char text[DECIMAL_BYTES];
    float narrow = 0.0F;
    double wide = 0.0;
    memcpy(count == sizeof narrow ? (void *)&narrow : &wide, bytes, count);
    fprintf(to, ",%s", decimal_of(count == sizeof narrow ? (double)narrow : wide, count, text));
}

typedef struct rows {
    const inputs *columns;
    const account *account; /* NULL: the table is that of units, which has two lines */
    size_t next;            /* the first exchange that is not yet in the table */
} rows;

/* Writes the added cells of a line. Line 0 has the names, and line k + 1 is row k. */
static void put_end(FILE *const to, const size_t line, rows *const r)
{
    const account *const a = r->account;
    if (line == 0 || a == NULL) {
        fputs(line == 0 ? r->columns->names : r->columns->units, to);
        return;
    }
    while (r->next < a->exchanges && a->answered[r->next] + 1 <= line) {
        r->next++;
    }
    const size_t bytes = a->input_bytes / r->columns->count;
    for (size_t i = 0; i < r->columns->count; i++) {
        if (r->next == 0) {
            fputs(",0", to);
        } else {
            put_value(to, a->inputs + (r->next - 1) * a->input_bytes + i * bytes, bytes);
        }
    }
}

/* Copies the table with cells added to each line; it takes the place of the old one when it is whole. */
static void rewrite(const char *const directory, const char *const name, rows r)
{
    static new_file file;
    file_must_begin(&file, "link", directory, name, "partial");
    FILE *const from = open_file(file.path);
    size_t line = 0;
    for (int c = fgetc(from); c != EOF; c = fgetc(from)) {
        if (c == '\n') {
            put_end(file.to, line++, &r);
        }
        fputc(c, file.to);
    }
    fclose(from);
    file_must_end(&file, "link");
}

void columns_add(const char *const directory, const char *const header, const account *const a)
{
    inputs found = read_header(header);
    if (found.count > 0) {
        const size_t bytes = a->input_bytes / found.count;
        if (a->exchanges > 0 && bytes != sizeof(float) && bytes != sizeof(double)) {
            quit("link: %s: it makes no sense", header);
        }
        rewrite(directory, "trace.csv", (rows){.columns = &found, .account = a});
        rewrite(directory, "units.csv", (rows){.columns = &found});
    }
    free(found.names);
    free(found.units);
}
