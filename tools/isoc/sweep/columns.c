#include "tools/isoc/sweep/sweep.h"

#include <string.h>

#include "tools/isoc/base/text.h"
#include "tools/isoc/scene/take.h"

static const char *const functions[] = {"final", "max", "min", "mean", "rms", "peak"};

/* The facts of the run itself. */
static const char *const facts[] = {"hash", "ticks", "restarts"};

static const char *const example = "max energy, or hash";

/* Whether an output is that of a name, or a component of it: tip_x of tip. */
static bool is_of(const char *one, const char *called)
{
    const size_t length = strlen(called);
    const char *rest = strncmp(one, called, length) == 0 ? one + length : "?";
    return rest[0] == '\0' || (rest[0] == '_' && rest[1] >= 'w' && rest[1] <= 'z' && rest[2] == '\0');
}

static void add_column(source *s, place at, sweep_column c, sweep_columns *to)
{
    bool is_new = true;
    FOR_EACH (const sweep_column, other, *to) {
        is_new = is_new && strcmp(other->title, c.title) != 0;
    }
    if (is_new) {
        LIST_ADD(s->memory, *to, c);
    } else {
        source_problem(s, at, "the table has %s already", c.title);
    }
}

static void add_outputs(source *s, const plant *p, const char *function, const token *called, sweep_columns *to)
{
    const output_set *all = &p->outputs;
    bool found = false;
    for (int i = 0; i < all->count; i++) {
        if (is_of(all->names[i], called->text)) {
            const char *title = arena_format(s->memory, "%s_%s", function, all->names[i]);
            add_column(s, called->at, (sweep_column){title, all->units[i], function, i}, to);
            found = true;
        }
    }
    if (!found) {
        source_problem(s, called->at, "no output is called '%s'%s", called->text,
                       source_suggestion(s, called->text, all->names, (size_t)all->count));
    }
}

/* The columns of a plant. */
typedef struct table {
    const plant *p;
    sweep_columns columns;
} table;

/* FUNCTION OUTPUT, or a fact. */
static void read_column(parser *p, void *to)
{
    table *t = to;
    const token *word = p->next;
    if (word->kind != TOKEN_NAME) {
        parse_problem(p, arena_format(p->s->memory, "expected what the table shows, such as %s", example));
        return;
    }
    p->next++;
    if (index_of_word(word->text, facts, COUNT_OF(facts)) < COUNT_OF(facts)) {
        add_column(p->s, word->at, (sweep_column){word->text, "1", word->text, -1}, &t->columns);
        return;
    }
    const size_t f = index_of_word(word->text, functions, COUNT_OF(functions));
    if (f == COUNT_OF(functions)) {
        const char *words[COUNT_OF(functions) + COUNT_OF(facts)];
        memcpy(words, functions, sizeof functions);
        memcpy(words + COUNT_OF(functions), facts, sizeof facts);
        PARSE_FAULT(p, word->at, "'%s' is not known%s: it is %s, of an output; or %s", word->text,
                    source_suggestion(p->s, word->text, words, COUNT_OF(words)),
                    alternatives(p->s->memory, functions, COUNT_OF(functions)),
                    alternatives(p->s->memory, facts, COUNT_OF(facts)));
    } else if (p->next->kind != TOKEN_NAME) {
        parse_problem(p, arena_format(p->s->memory, "expected an output behind '%s', such as %s", word->text, example));
    } else {
        add_outputs(p->s, t->p, functions[f], p->next++, &t->columns);
    }
}

sweep_columns sweep_read_columns(source *s, const plant *p, const script *columns)
{
    parser at = parser_of_option(s, NULL, columns, columns);
    table result = {.p = p};
    if (at.next->kind == TOKEN_END) {
        parse_problem(&at, arena_format(s->memory, "--of is what the table shows, such as %s", example));
    }
    parse_items(&at, read_column, &result, "expected ; and what the table shows further");
    return result.columns;
}
