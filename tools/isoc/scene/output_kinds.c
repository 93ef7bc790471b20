#include "tools/isoc/scene/output_kinds.h"

#include <string.h>

#include "tools/isoc/base/text.h"

#define OUTPUT_ROW(kind, word, of, is_of_point, components, unit, turning_unit)                                        \
    {word, of, is_of_point, components, unit, turning_unit},
const output_row output_rows[OUTPUT_ROWS] = {OUTPUT_KINDS(OUTPUT_ROW)};
#undef OUTPUT_ROW

const char *const operand_phrases[OPERANDS] = {
    [OF_COORDINATE] = "a joint",
    [OF_BODY] = "a body",
    [OF_CONNECTION] = "a joint or a closure",
    [OF_TRANSMISSION] = "a gear, a motion or a spring",
};

output_kind output_of(output_kind kind, operand of)
{
    output_kind found = 0;
    while (found < OUTPUT_ROWS &&
           (output_rows[found].of != of || strcmp(output_rows[found].word, output_rows[kind].word) != 0)) {
        found++;
    }
    return found;
}

bool output_is_vector(const output_row *row)
{
    return strcmp(row->components, "xyz") == 0;
}

const char *output_list(arena *memory, bool (*is_listed)(const output_row *row))
{
    const char *list = "";
    for (operand of = 0; of < OPERANDS; of++) {
        const char *words[OUTPUT_ROWS];
        size_t count = 0;
        for (output_kind kind = 0; kind < OUTPUT_ROWS; kind++) {
            if (output_rows[kind].of == of && is_listed(&output_rows[kind])) {
                words[count++] = output_rows[kind].word;
            }
        }
        if (count > 0) {
            list = arena_format(memory, "%s%s%s of %s", list, list[0] == '\0' ? "" : "; ",
                                alternatives(memory, words, count), operand_phrases[of]);
        }
    }
    return list;
}
