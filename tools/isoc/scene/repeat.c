/* repeat INDEX from FIRST to LAST { statements }, include "file", and indices in names: leg[i + 1]. The statements are
 * read once for each value of the index, each time as a reading of its own. */
#include "tools/isoc/scene/names.h"
#include "tools/isoc/scene/take.h"

#include <math.h>
#include <string.h>

enum {
    MOST_NESTED = 16,      /* repeats and includes in one another */
    MOST_WORDS = 1000000,  /* of all readings together */
    WORDS_OF_A_ROUND = 20, /* that a round of a repeat counts as, beside those in it */
    LARGEST_INDEX = 65535,
};

/* --- plain numbers, which are known while the scene is read --- */

/* The number of a formula of plain numbers and of constants above that are; false if it is none. */
static bool plain_number(const parser *p, const formula *f, double *number)
{
    const int *known;
    double part;
    switch (f->kind) {
    case FORMULA_NUMBER:
        *number = f->number * f->unit.numerator / f->unit.denominator;
        return dimension_equal(f->unit.dim, unit_one.dim);
    case FORMULA_NAME:
        known = dictionary_find(&p->known, f->name);
        *number = known == NULL ? 0.0 : p->numbers.all[*known];
        return known != NULL;
    case FORMULA_NEGATE:
        if (!plain_number(p, f->parts[0], &part)) {
            return false;
        }
        *number = -part;
        return true;
    case FORMULA_CHAIN:
        if (!plain_number(p, f->parts[0], number)) {
            return false;
        }
        for (size_t i = 1; i < f->count; i++) {
            if (!plain_number(p, f->parts[i]->parts[0], &part)) {
                return false;
            }
            const char sign = f->parts[i]->sign;
            *number = sign == '+'   ? *number + part
                      : sign == '-' ? *number - part
                      : sign == '*' ? *number * part
                                    : *number / part;
        }
        return true;
    default:
        return false;
    }
}

void note_constant(parser *p, const quantity *q)
{
    double number;
    if (!q->tunable && q->name.text != NULL && q->value != NULL && plain_number(p, q->value, &number) &&
        dictionary_find(&p->known, q->name.text) == NULL) {
        dictionary_put(&p->known, q->name.text, (int)p->numbers.count);
        LIST_ADD(p->s->memory, p->numbers, number);
    }
}

/* A whole number; problems are noted. */
static bool parse_whole(parser *p, const char *what, int least, int *whole)
{
    const formula *f = parse_formula(p);
    double number = 0.0;
    if (f == NULL) {
        return false;
    }
    if (!plain_number(p, f, &number)) {
        PARSE_FAULT(p, f->at,
                    "%s must be made of whole numbers, of indices, and of constants that stand above and are plain "
                    "numbers",
                    what);
    } else if (number != floor(number) || !(number >= least && number <= (double)LARGEST_INDEX)) {
        PARSE_FAULT(p, f->at, "%s must be a whole number from %d to %d; this is %g", what, least, LARGEST_INDEX,
                    number);
    }
    *whole = p->failed ? 0 : (int)number;
    return !p->failed;
}

/* --- indices --- */

const int *find_index(const parser *p, const char *called)
{
    for (const repetition *r = p->repeated; r != NULL; r = r->outer) {
        if (strcmp(r->index.text, called) == 0) {
            return &r->value;
        }
    }
    return NULL;
}

const char *take_indices(parser *p, const char *called)
{
    while (!p->failed && !p->next->first_on_line && take_sign(p, '[')) {
        int index;
        if (parse_whole(p, "an index", 0, &index) && !take_sign(p, ']')) {
            parse_problem(p, "expected ] after the index");
        }
        if (!p->failed) {
            const char last = called[strlen(called) - 1];
            called = arena_format(p->s->memory, "%s%s%d", called, last >= '0' && last <= '9' ? "_" : "", index);
        }
        /* leg[i]_speed */
        if (!p->failed && p->next->kind == TOKEN_NAME && p->next->at == p->next[-1].at + 1) {
            called = arena_format(p->s->memory, "%s%s", called, p->next->text);
            p->next++;
        }
    }
    if (strlen(called) > LONGEST_NAME) {
        PARSE_FAULT(p, p->next[-1].at, "a name of %zu characters: at most %d are allowed", strlen(called),
                    LONGEST_NAME);
    }
    return called;
}

/* --- repeat --- */

/* The sign that closes a brace which is open, or the end. */
static const token *closing_of(const token *t)
{
    int open = 1;
    for (; t->kind != TOKEN_END; t++) {
        open += t->sign == '{';
        open -= t->sign == '}';
        if (open == 0) {
            break;
        }
    }
    return t;
}

/* Whether so many more words, one level deeper, are allowed. */
static bool has_room(parser *p, const token *word, size_t words)
{
    p->words += words;
    if (p->nested >= MOST_NESTED || p->words > MOST_WORDS) {
        if (!p->is_full) {
            source_problem(p->s, word->at,
                           p->nested >= MOST_NESTED ? "repeats and includes in one another, more than %d deep"
                                                    : "the repeats make the scene longer than %d words",
                           p->nested >= MOST_NESTED ? MOST_NESTED : MOST_WORDS);
        }
        p->is_full = p->failed = true;
    }
    return !p->is_full;
}

void parse_nested(parser *p, const token *tokens, void *to)
{
    const token *next = p->next;
    const struct block *within = p->within;
    p->next = tokens;
    p->nested++;
    p->target->broken |= !parse_items_of(p, within, to);
    p->nested--;
    p->next = next;
    p->within = within;
    p->failed = p->is_full;
}

static const char *note_of(parser *p, const repetition *r)
{
    const char *own = arena_format(p->s->memory, "%s = %d", r->index.text, r->value);
    return r->outer == NULL ? own : arena_format(p->s->memory, "%s, %s", note_of(p, r->outer), own);
}

/* The tokens from `first` up to `end`, as a reading of their own. */
static const token *copy_of(parser *p, const token *first, const token *end)
{
    const size_t count = (size_t)(end - first);
    const passage *in = source_find(p->s, first->at);
    const size_t offset = in->offset + (first->at - in->from);
    const place from = source_passage(p->s, in->origin, offset, end->at - first->at, note_of(p, p->repeated));
    token *result = arena_take(p->s->memory, count + 1 + TOKENS_AHEAD, sizeof *result);
    for (size_t i = 0; i <= count + TOKENS_AHEAD; i++) {
        result[i] = first[i < count ? i : count];
        result[i].at = from + (result[i].at - first->at);
        if (i >= count) {
            result[i].kind = TOKEN_END; /* with the text of its brace */
            result[i].sign = 0;
        }
    }
    return result;
}

static void repeat(parser *p, const token *word, repetition *r, int last, const token *end, void *slot)
{
    for (; r->value <= last && has_room(p, word, (size_t)(end - p->next) + WORDS_OF_A_ROUND); r->value++) {
        p->repeated = r;
        parse_nested(p, copy_of(p, p->next, end), slot);
        p->repeated = r->outer;
    }
}

static name take_index_name(parser *p)
{
    unit u;
    const name n = take_parameter_name(p, "expected a name for the index: repeat i from 1 to 6 {");
    if (n.text != NULL && find_index(p, n.text) != NULL) {
        source_problem(p->s, n.at, "'%s' is the index of a repeat around this one", n.text);
    } else if (n.text != NULL && unit_find(n.text, &u)) {
        source_problem(p->s, n.at, "'%s' is a unit: choose another name", n.text);
    }
    if (n.text != NULL) {
        LIST_ADD(p->s->memory, p->indices, n);
    }
    return n;
}

void read_repeat(parser *p, void *slot)
{
    const token *word = p->word;
    repetition r = {.index = take_index_name(p), .outer = p->repeated};
    int last = 0;
    expect_word(p, "from", "expected from: repeat i from 1 to 6 {");
    const token *begin = p->next;
    if (parse_whole(p, "the first index", 0, &r.value) && !take_word(p, "to")) {
        parse_problem(p, "expected to: repeat i from 1 to 6 {");
    }
    if (parse_whole(p, "the last index", -1, &last) && last < r.value - 1) {
        PARSE_FAULT(p, begin->at,
                    "from %d to %d goes backward: the last index may be one less than the first, for none", r.value,
                    last);
    }
    if (!p->failed && !next_is_sign(p, '{')) {
        parse_problem(p, "expected {");
    }
    while (p->failed && p->next->kind != TOKEN_END && !p->next->first_on_line && !next_is_sign(p, '{')) {
        p->next++;
    }
    if (!next_is_sign(p, '{')) {
        return;
    }
    const token *open = p->next++, *end = closing_of(p->next);
    if (end->kind == TOKEN_END) {
        PARSE_FAULT(p, open->at, "this { is never closed");
    } else if (!p->failed) {
        repeat(p, word, &r, last, end, slot);
    }
    p->next = end + (end->kind != TOKEN_END);
}

/* --- include --- */

const script *open_beside(parser *p, place word, const char *named, const char **fault)
{
    const char *path = source_find(p->s, word)->origin->path;
    const char *slash = strrchr(path, '/');
    const char *folder =
        named[0] == '/' || slash == NULL ? "" : arena_format(p->s->memory, "%.*s/", (int)(slash - path), path);
    return source_open(p->s, arena_format(p->s->memory, "%s%s", folder, named), fault);
}

/* a.scene includes b.scene, which includes a.scene */
static const char *circle_of(parser *p, const inclusion *inner, const script *again)
{
    const char *rest = again->path;
    for (const inclusion *i = inner; i != NULL; i = i->file == again ? NULL : i->outer) {
        rest = arena_format(p->s->memory, "%s%s includes %s", i->file->path, i->file == again ? "" : ", which", rest);
    }
    return rest;
}

void read_include(parser *p, void *slot)
{
    const token *named = p->next;
    if (named->kind != TOKEN_TEXT || named->first_on_line) {
        parse_problem(p, "expected a file between quotation marks: include \"legs.scene\"");
        return;
    }
    p->next++;
    const char *fault;
    const passage *in = source_find(p->s, p->word->at);
    const script *s = open_beside(p, p->word->at, named->text, &fault);
    if (s == NULL) {
        PARSE_FAULT(p, named->at, "cannot include '%s': %s", named->text, fault);
        return;
    }
    for (const inclusion *i = p->included; i != NULL; i = i->outer) {
        if (i->file == s) {
            PARSE_FAULT(p, named->at, "an include in a circle: %s", circle_of(p, p->included, s));
            return;
        }
    }
    const token *tokens = lex(p->s, s, source_passage(p->s, s, 0, s->length, in->note));
    size_t count = 0;
    while (tokens[count].kind != TOKEN_END) {
        count++;
    }
    inclusion opened = {.file = s, .outer = p->included};
    if (has_room(p, p->word, count + 1)) {
        p->included = &opened;
        parse_nested(p, tokens, slot);
        p->included = opened.outer;
    }
}

/* --- afterwards --- */

void check_indices(const parser *p)
{
    FOR_EACH (const name, n, p->indices) {
        if (INDEX_OF(p->target->parameters, n->text) >= 0) {
            source_problem(p->s, n->at, "'%s' is a parameter too: choose another name for the index", n->text);
        }
    }
}
