/* Tables: their lines of values, their options, and files of points. */
#include <stdlib.h>
#include <string.h>

#include "tools/isoc/scene/lexer.h"
#include "tools/isoc/scene/take.h"

enum { MOST_POINTS = 1000, MOST_CELLS = 10000 };

/* smooth, or beyond held | linear | error; a comma or an end follows. */
bool take_table_option(parser *p, formula *f)
{
    static const char *const ends[] = {"held", "linear", "error"};
    const char after = p->next[1].sign;
    if (next_is_word(p, "smooth") && (after == ',' || after == ';' || after == ')')) {
        p->next++;
        f->is_smooth = true;
        return true;
    }
    if (!next_is_word(p, "beyond") || p->next[1].kind != TOKEN_NAME) {
        return false;
    }
    p->next++;
    const place at = p->next->at;
    const size_t which = take_one_of(p, ends, COUNT_OF(ends));
    f->beyond = (name){which < COUNT_OF(ends) ? ends[which] : NULL, at};
    return true;
}

/* The lines of a table of two quantities: ; place {, place} {; place : value {, value}}, each as a vector. */
void parse_grid(parser *p, formula *f)
{
    f->number = 2.0;
    while (take_sign(p, ';')) {
        if (take_table_option(p, f)) {
            continue;
        }
        formula *line = formula_new(p, FORMULA_VECTOR, p->next->at);
        const bool is_row = f->count > 2;
        do {
            formula *part = parse_condition(p);
            if (part == NULL) {
                return;
            }
            formula_put(p, line, part);
            if (is_row && line->count == 1 && !next_is_sign(p, ':')) {
                parse_problem(
                    p, "expected : behind the place of a row, as in table(x, y; 0 m, 1 m; 0 s: 1 N, 2 N; 1 s: 3 N, "
                       "5 N)");
                return;
            }
        } while (take_sign(p, ',') || (is_row && line->count == 1 && take_sign(p, ':')));
        formula_put(p, f, line);
    }
    expect_sign(p, ')', "expected , ; or )");
}

/* --- files --- */

/* A file that is being read. */
typedef struct map_file {
    parser *p;          /* of its tokens */
    unit units[3];      /* of x, of y, and of the values; of x and of a column's values */
    int columns, value; /* fields of a line, and which has the values, from 0 on */
} map_file;

static bool ends_line(const parser *p)
{
    return p->next->kind == TOKEN_END || p->next->first_on_line;
}

static bool take_comma(parser *p)
{
    return !ends_line(p) && (take_sign(p, ',') || take_sign(p, ';'));
}

/* { word } [ '[' unit ']' ] { , ... }: the units of the fields; those of the columns that are wanted. */
static void read_head(map_file *m, bool is_grid)
{
    parser *p = m->p;
    int field = 0;
    do {
        unit u = unit_one;
        while (p->next->kind == TOKEN_NAME || p->next->kind == TOKEN_TEXT) {
            p->next++;
            if (p->next->first_on_line) {
                break;
            }
        }
        if (!ends_line(p) && take_sign(p, '[')) {
            if (!take_unit(p, &u)) {
                parse_problem(p, "expected a unit: speed [m/s]");
                return;
            }
            expect_sign(p, ']', "expected ] behind the unit");
        }
        const int which = is_grid ? field : field == 0 ? 0 : field == m->value ? 1 : -1;
        if (which >= 0 && which < 3) {
            m->units[which] = u;
        }
        field++;
    } while (!p->failed && take_comma(p));
    if (!p->failed && !ends_line(p)) {
        parse_problem(p, "expected , or the end of the line: speed [m/s], force [N]");
    }
    if (!p->failed && is_grid && field != 3) {
        parse_problem(p, "the first line of a table of two numbers names both and the value: current [A], angle [rad], "
                         "torque [N*m]; the second has the places of the first number");
    }
    m->columns = field;
}

/* [+ | -] number, with this unit. NULL after noting a problem. */
static formula *read_number(parser *p, const unit *u)
{
    const place at = p->next->at;
    const bool is_negative = take_sign(p, '-') || (take_sign(p, '+') && false);
    if (p->failed || p->next->kind != TOKEN_NUMBER) {
        parse_problem(p, "expected a number");
        return NULL;
    }
    formula *f = formula_new(p, FORMULA_NUMBER, at);
    f->number = is_negative ? -p->next->number : p->next->number;
    f->unit = *u;
    p->next++;
    return f;
}

/* A line of numbers, the first with the unit of its place: all of them, of a grid, or the place and the value. */
static void read_points(map_file *m, formula *f)
{
    parser *p = m->p;
    int field = 0;
    do {
        formula *number = read_number(p, &m->units[field == 0 ? 0 : 1]);
        if (number != NULL && (field == 0 || field == m->value)) {
            formula_put(p, f, number);
        }
        field++;
    } while (!p->failed && take_comma(p));
    if (!p->failed && (!ends_line(p) || field <= m->value)) {
        parse_problem(p, "expected numbers with a comma between, one for each column");
    }
}

/* [corner] , place {, place}; then y, value {, value}. */
static void read_line_of_grid(map_file *m, formula *f)
{
    parser *p = m->p;
    const bool is_first = f->count == 2;
    formula *line = formula_new(p, FORMULA_VECTOR, p->next->at);
    if (!is_first) {
        formula *place_of_row = read_number(p, &m->units[1]);
        if (place_of_row != NULL) {
            formula_put(p, line, place_of_row);
        }
    } else if (p->next->kind == TOKEN_NAME || p->next->kind == TOKEN_TEXT) {
        p->next++;
    }
    if (!p->failed && !take_sign(p, ',') && !take_sign(p, ';')) {
        parse_problem(p, "expected a comma: the first line of places begins with one, and stands above the values");
    }
    do {
        formula *number = p->failed ? NULL : read_number(p, &m->units[is_first ? 0 : 2]);
        if (number != NULL) {
            formula_put(p, line, number);
        }
    } while (!p->failed && take_comma(p));
    if (!p->failed && !ends_line(p)) {
        parse_problem(p, "expected , or the end of the line");
    }
    formula_put(p, f, line);
}

static int column_of(parser *p)
{
    if (!take_option(p, "column")) {
        return 1;
    }
    const double column = p->next->number;
    if (p->next->kind != TOKEN_NUMBER || !(column >= 2.0 && column <= MOST_POINTS) || column != (int)column) {
        parse_problem(p, "expected the number of a column, from 2 on: the first has the places");
        return 1;
    }
    p->next++;
    return (int)column - 1;
}

bool take_map(parser *p, formula *f)
{
    const token *named = p->next;
    const char *fault;
    if (named->kind != TOKEN_TEXT || f->count > 2) {
        return false;
    }
    const script *opened = open_beside(p, named->at, named->text, &fault);
    p->next++;
    if (opened == NULL) {
        PARSE_FAULT(p, named->at, "cannot read '%s': %s", named->text, fault);
        return true;
    }
    const bool is_grid = f->count == 2;
    parser of_file = *p;
    map_file m = {.p = &of_file, .units = {unit_one, unit_one, unit_one}, .value = column_of(p)};
    f->number = (double)f->count;
    of_file.next = lex(p->s, opened, source_passage(p->s, opened, 0, opened->length, NULL));
    if (of_file.next->kind == TOKEN_NAME || of_file.next->kind == TOKEN_TEXT || of_file.next->sign == '[') {
        read_head(&m, is_grid);
    }
    size_t numbers = 0;
    while (!of_file.failed && of_file.next->kind != TOKEN_END && numbers <= (is_grid ? MOST_CELLS : 2 * MOST_POINTS)) {
        is_grid ? read_line_of_grid(&m, f) : read_points(&m, f);
        numbers = is_grid ? numbers + f->parts[f->count - 1]->count : f->count;
    }
    p->failed = p->failed || of_file.failed;
    if (!p->failed && of_file.next->kind != TOKEN_END) {
        PARSE_FAULT(p, named->at, "a table has at most %d points, or %d cells: each costs in every step", MOST_POINTS,
                    MOST_CELLS);
    }
    return true;
}
