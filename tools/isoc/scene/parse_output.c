/* output NAME = FORMULA [every NUMBER ticks] */
#include <string.h>

#include "tools/isoc/scene/take.h"

/* A word that is no quantity, as in `place of hinge`, or that stands alone. */
static void refuse_quantity(parser *p)
{
    const char *words[QUANTITY_ROWS] = {NULL};
    size_t count = 0;
    for (quantity_kind kind = 0; kind < QUANTITY_ROWS; kind++) {
        const quantity_row *row = &quantity_rows[kind];
        if (row->owner >= OF_COORDINATE && (count == 0 || strcmp(words[count - 1], row->word) != 0)) {
            words[count++] = row->word;
        }
    }
    const size_t found = take_one_of(p, words, count);
    if (found < count) {
        p->next++;
        (void)take_name(
            p, arena_format(p->s->memory, "expected the name of %s", quantity_owners(p->s->memory, words[found])));
    }
}

void read_output(parser *p, void *slot)
{
    scene *written = slot;
    output o = {.name = take_name(p, "expected a name for the output")};
    if (o.name.text != NULL && strcmp(o.name.text, "t") == 0) {
        source_problem(p->s, o.name.at, "'t' is the time in the trace: choose another name");
    }
    expect_sign(p, '=', "expected =, as in: output angle = position of joint");
    if (!p->failed && next_is_owned(p) && !next_is_quantity(p)) {
        refuse_quantity(p);
    }
    o.formula = parse_formula(p);
    o.block = p->block;
    if (take_option(p, "every")) {
        if (o.block != NULL) {
            PARSE_FAULT(p, p->next[-1].at, "this output has the rate of its block: leave out 'every'");
        }
        o.every = parse_ticks(p, "the rate of an output is a number of ticks: every 4 ticks");
    }
    if (!p->failed) {
        LIST_ADD(p->s->memory, written->outputs, o);
    }
}
