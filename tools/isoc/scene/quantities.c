#include "tools/isoc/scene/quantities.h"

#include <string.h>

#include "tools/isoc/base/text.h"

#define QUANTITY_ROW(kind, word, owner, asks, components, unit, turning_unit, known)                                   \
    {word, owner, asks, components, unit, turning_unit, known},
const quantity_row quantity_rows[QUANTITY_ROWS] = {QUANTITIES(QUANTITY_ROW)};
#undef QUANTITY_ROW

const char *const operand_phrases[OPERANDS] = {
    [OF_COORDINATE] = "a joint",
    [OF_BODY] = "a body",
    [OF_CONNECTION] = "a joint or a closure",
    [OF_TRANSMISSION] = "a gear, a motion, a spring or a hold",
    [OF_EFFECT] = "an effect",
};

quantity_kind quantity_called(const char *word, operand owner)
{
    quantity_kind found = 0;
    while (found < QUANTITY_ROWS &&
           (quantity_rows[found].owner != owner || strcmp(quantity_rows[found].word, word) != 0)) {
        found++;
    }
    return found;
}

quantity_kind quantity_of_nothing(const char *word)
{
    quantity_kind found = QUANTITY_ROWS;
    for (operand owner = 0; owner < OF_COORDINATE && found == QUANTITY_ROWS; owner++) {
        found = quantity_called(word, owner);
    }
    return found;
}

bool quantity_has_parts(const quantity_row *row)
{
    return row->components[0] != '\0';
}

int quantity_part(const quantity_row *row, const char *along)
{
    return (int)(strchr(row->components, along[0]) - row->components);
}

bool quantity_has_point(const quantity_row *row)
{
    return (row->asks & AT_POINT) != 0;
}

int quantity_parts(const quantity_row *row)
{
    return row->components[0] == '\0' ? 1 : (int)strlen(row->components);
}

const char *quantity_list(arena *memory, bool (*is_listed)(const quantity_row *row))
{
    const char *list = "";
    for (operand owner = 0; owner < OPERANDS; owner++) {
        const char *words[QUANTITY_ROWS];
        size_t count = 0;
        for (quantity_kind kind = 0; kind < QUANTITY_ROWS; kind++) {
            const quantity_row *row = &quantity_rows[kind];
            if (row->owner == owner && is_listed(row)) {
                words[count++] = row->word;
            }
        }
        if (count > 0) {
            list = arena_format(memory, "%s%s%s of %s", list, list[0] == '\0' ? "" : "; ",
                                alternatives(memory, words, count), operand_phrases[owner]);
        }
    }
    return list;
}

const char *quantity_words(arena *memory, operand owner, operand or_of)
{
    const char *words[QUANTITY_ROWS];
    size_t count = 0;
    for (quantity_kind kind = 0; kind < QUANTITY_ROWS; kind++) {
        if (quantity_rows[kind].owner == owner || quantity_rows[kind].owner == or_of) {
            words[count++] = quantity_rows[kind].word;
        }
    }
    return alternatives(memory, words, count);
}

const char *quantity_owners(arena *memory, const char *word)
{
    const char *phrases[OPERANDS];
    size_t count = 0;
    for (operand owner = OF_COORDINATE; owner < OPERANDS; owner++) {
        if (quantity_called(word, owner) < QUANTITY_ROWS) {
            phrases[count++] = operand_phrases[owner];
        }
    }
    return count == 0 ? NULL : alternatives(memory, phrases, count);
}

dimension dimension_of_unit(const char *written)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    static const dimension none = {0};
    dimension all = none;
    int sign = 1;
    while (strchr(letters, *written) != NULL && *written != '\0') {
        char called[8] = "";
        const size_t length = strspn(written, letters);
        unit u;
        memcpy(called, written, length < sizeof called ? length : 0);
        if (!unit_find(called, &u)) {
            return none;
        }
        written += length;
        const bool is_power = *written == '^';
        dimension_times(&all, u.dim, is_power ? sign * (written[1] - '0') : sign);
        written += is_power ? 2 : 0;
        sign = *written == '/' ? -1 : 1;
        written += *written == '*' || *written == '/';
    }
    return *written == '\0' ? all : none;
}
