/* output NAME = KIND [of NAME [at FORMULA] [in AXES] [along AXIS]] [every NUMBER ticks], or a formula in the place of the kind */
#include <string.h>

#include "tools/isoc/scene/parse_formula.h"
#include "tools/isoc/scene/statements.h"

/* Whether the next words are those of a row: position of hinge; and not those of a formula: 2 * position of hinge, or
 * position of hinge / 2, or power of drive, which is of an effect. */
static bool next_is_output_kind(const parser *p)
{
    const token *last = p->next;
    const bool has_owner = next_is_owned(p);
    bool is_known = false;
    for (quantity_kind kind = 0; kind < QUANTITY_ROWS; kind++) {
        const bool is_owned = quantity_rows[kind].of >= OF_COORDINATE;
        is_known = is_known || (quantity_is_shown(&quantity_rows[kind]) && next_is_word(p, quantity_rows[kind].word) &&
                                (is_owned || !has_owner));
    }
    if (last->kind != TOKEN_NAME || (!is_known && (!has_owner || next_is_quantity(p)))) {
        return false;
    }
    last += !has_owner ? 0 : last[2].kind == TOKEN_NAME ? 2 : 1;
    const char sign = last[1].first_on_line ? '\0' : last[1].sign;
    return sign == '\0' || strchr("+-*/^(", sign) == NULL;
}

/* The first row of the next word, which is taken. */
static quantity_kind parse_output_kind(parser *p)
{
    const char *words[QUANTITY_ROWS];
    quantity_kind kinds[QUANTITY_ROWS] = {0};
    const char *last = "";
    size_t count = 0;
    for (quantity_kind kind = 0; kind < QUANTITY_ROWS; kind++) {
        if (quantity_is_shown(&quantity_rows[kind]) && strcmp(last, quantity_rows[kind].word) != 0) {
            last = words[count] = quantity_rows[kind].word;
            kinds[count++] = kind;
        }
    }
    const size_t found = take_one_of(p, words, count);
    return found < count ? kinds[found] : 0;
}

/* What outputs of this word are of: a joint or a body. */
static const char *owners(arena *memory, quantity_kind kind)
{
    const char *phrases[OPERANDS];
    size_t count = 0;
    for (operand of = 0; of < OPERANDS; of++) {
        if (of < OF_EFFECT && quantity_called(quantity_rows[kind].word, of) < QUANTITY_ROWS) {
            phrases[count++] = operand_phrases[of];
        }
    }
    return alternatives(memory, phrases, count);
}

static void parse_owner(parser *p, output *o)
{
    const char *wanted = owners(p->s->memory, o->kind);
    if (!take_word(p, "of")) {
        parse_problem(p, arena_format(p->s->memory, "expected 'of' and the name of %s", wanted));
        return;
    }
    o->of = take_name(p, arena_format(p->s->memory, "expected the name of %s", wanted));
    o->point_at = p->next->at;
    if (!p->failed && take_option(p, "at")) {
        o->point = parse_formula(p);
    }
    if (!p->failed && take_option(p, "in")) {
        o->axes = take_name(p, "expected body or ground");
    }
    o->along_at = p->next->at;
    if (!p->failed && take_option(p, "along")) {
        static const char *const axes[] = {"x", "y", "z"};
        o->along = (int)take_one_of(p, axes, COUNT_OF(axes));
    }
}

/* Behind `every`: 4 ticks. */
static void parse_rate(parser *p, output *o)
{
    o->every = parse_formula(p);
    if (!p->failed && !take_word(p, "ticks")) {
        source_problem(p->s, o->every->at, "the rate of an output is a number of ticks: every 4 ticks");
        p->failed = true;
    }
}

void read_output(parser *p, const token *word, void *slot)
{
    (void)word;
    scene *written = slot;
    output o = {.name = take_name(p, "expected a name for the output"), .along = -1};
    if (o.name.text != NULL && strcmp(o.name.text, "t") == 0) {
        source_problem(p->s, o.name.at, "'t' is the time in the trace: choose another name");
    }
    if (!p->failed && !take_sign(p, '=')) {
        parse_problem(p, "expected =, as in: output angle = position of joint");
    }
    o.kind_at = p->next->at;
    if (!p->failed && !next_is_output_kind(p)) {
        o.kind = QUANTITY_ROWS;
        o.formula = parse_formula(p);
    } else if (!p->failed) {
        o.kind = parse_output_kind(p);
    }
    if (!p->failed && o.formula == NULL && quantity_rows[o.kind].of >= OF_COORDINATE) {
        parse_owner(p, &o);
    }
    if (!p->failed && take_option(p, "every")) {
        parse_rate(p, &o);
    }
    if (!p->failed) {
        LIST_ADD(p->s->memory, written->outputs, o);
    }
}
