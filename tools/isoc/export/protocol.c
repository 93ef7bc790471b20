#include "tools/isoc/export/terminals.h"

#include "core/wire/protocol.h"

/* As C writes them; NULL where a table has none of these. Of the fields of a payload that stand once: as the module
 * struct of Python has them, and their bytes. */
typedef struct row_of_protocol {
    const char *name, *number, *words, *layout;
    int bytes;
} row_of_protocol;

#define LETTER_OF_U8 "B"
#define LETTER_OF_U16 "H"
#define LETTER_OF_U32 "I"
#define LETTER_OF_U64 "Q"
#define LETTER_IF_1(type) LETTER_OF_##type
#define LETTER_IF_MANY(type)
#define LETTER(name, type, count) LETTER_IF_##count(type)
#define FIELDS(list) "<" list(LETTER), 0 list(ISO_FIELD_BYTES)

#define WORD(name, ...) {#name, NULL, NULL, NULL, 0},
#define WORD_OF_LINK(name) {"link_" #name, NULL, NULL, NULL, 0},
#define FRAME(name, letter) {#name, #letter, NULL, FIELDS(ISO_LINK_##name##_FIELDS)},
#define COMMAND(name, number) {#name, #number, NULL, FIELDS(ISO_COMMAND_##name##_TAKES)},
#define FIELD(name, type, count) {#name, NULL, NULL, LETTER_OF_##type, ISO_BYTES_OF_##type},
#define CONSTANT(name, number, words) {#name, #number, #words, NULL, 0},
#define TEXT(name, number, words) {NULL, #number, #words, NULL, 0},
static const row_of_protocol words[] = {ISO_STREAM_COUNTS(WORD) ISO_STREAM_WORDS(WORD) ISO_LINK_COUNTS(WORD_OF_LINK)};
static const row_of_protocol frames[] = {ISO_LINK_TYPE_LIST(FRAME)};
static const row_of_protocol start_fields[] = {ISO_LINK_START_FIELDS(FIELD)};
static const row_of_protocol modes[] = {ISO_LINK_MODE_LIST(CONSTANT)};
static const row_of_protocol reasons[] = {ISO_LINK_REASON_LIST(TEXT)};
static const row_of_protocol commands[] = {ISO_COMMAND_LIST(COMMAND)};
static const row_of_protocol state_fields[] = {ISO_COMMAND_STATE_FIELDS(FIELD)};
static const row_of_protocol states[] = {ISO_COMMAND_STATE_LIST(CONSTANT)};
static const row_of_protocol answers[] = {ISO_SNAPSHOT_REFUSALS(TEXT) ISO_CONTROL_REFUSALS(TEXT)};

#define TABLE(rows) rows, COUNT_OF(rows)
static const struct {
    const char *name;
    const row_of_protocol *rows;
    size_t count;
    const char *pattern; /* of a row in C */
} tables[PROTOCOL_TABLES] = {
    [PROTOCOL_WORDS] = {"WORDS", TABLE(words), "X(@name@)"},
    [PROTOCOL_FRAMES] = {"FRAMES", TABLE(frames), "X(@name@, @number@, @bytes@)"},
    [PROTOCOL_START_FIELDS] = {"START_FIELDS", TABLE(start_fields), "X(@name@, @bytes@)"},
    [PROTOCOL_MODES] = {"MODES", TABLE(modes), "X(@name@, @number@, @words@)"},
    [PROTOCOL_REASONS] = {"REASONS", TABLE(reasons), "X(@number@, @words@)"},
    [PROTOCOL_COMMANDS] = {"COMMANDS", TABLE(commands), "X(@name@, @number@, @bytes@)"},
    [PROTOCOL_STATE_FIELDS] = {"STATE_FIELDS", TABLE(state_fields), "X(@name@, @bytes@)"},
    [PROTOCOL_STATES] = {"STATES", TABLE(states), "X(@name@, @number@, @words@)"},
    [PROTOCOL_ANSWERS] = {"ANSWERS", TABLE(answers), "X(@number@, @words@)"},
};

static const char *row_as(arena *memory, const row_of_protocol *r, const char *as)
{
    text row = {.memory = memory};
    text_fill(&row, as,
              (const filling[]){{"name", r->name},
                                {"number", r->number},
                                {"words", r->words},
                                {"layout", r->layout},
                                {"bytes", arena_format(memory, "%d", r->bytes)},
                                {NULL, NULL}});
    return row.bytes;
}

const char *protocol_rows(arena *memory, protocol_table table, const char *as)
{
    text all = {.memory = memory};
    for (size_t i = 0; i < tables[table].count; i++) {
        text_add(&all, "%s", row_as(memory, &tables[table].rows[i], as));
    }
    return all.bytes;
}

const char *protocol_in_c(arena *memory)
{
    enum { BACKSLASH_AT = 119 };
    text all = {.memory = memory};
    text_add(&all, "enum { ISO_CLIENT_VERSION = %d, ISO_CLIENT_PIECE = %d };\n", ISO_LINK_VERSION, ISO_COMMAND_PIECE);
    for (int k = 0; k < PROTOCOL_TABLES; k++) {
        const char *line = arena_format(memory, "#define ISO_CLIENT_%s(X)", tables[k].name);
        for (size_t i = 0; i < tables[k].count; i++) {
            text_add(&all, "%-*s\\\n", BACKSLASH_AT, line);
            line = arena_format(memory, "    %s", row_as(memory, &tables[k].rows[i], tables[k].pattern));
        }
        text_add(&all, "%s\n", line);
    }
    return all.bytes;
}
