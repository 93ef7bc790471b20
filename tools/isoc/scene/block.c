#include "tools/isoc/scene/take.h"

#include <string.h>

/* A block, as far as it is read. */
typedef struct reading {
    const block *b;
    const char *kind;    /* its name; NULL: there is but one, or it is none */
    unsigned traits;     /* of its kind; of all kinds where it is none */
    const token **first; /* [MOST_PROPERTIES] where each property stands; NULL: not yet */
    char *to;
} reading;

size_t block_index(const block *b, const token *t)
{
    size_t i = 0;
    while (i < b->property_count && (t->kind != TOKEN_NAME || strcmp(t->text, b->properties[i].word) != 0)) {
        i++;
    }
    return i;
}

bool block_has_word(const block *b, const token *t)
{
    return block_index(b, t) < b->property_count;
}

/* The next token is not a property, or one of another kind: notes which properties there are. */
static void refuse_property(parser *p, const reading *r, bool of_another)
{
    const char *words[MOST_PROPERTIES + 1];
    size_t count = 0;
    for (size_t i = 0; i < r->b->property_count; i++) {
        if (r->b->properties[i].kinds & r->traits) {
            words[count++] = r->b->properties[i].word;
        }
    }
    if (r->b != p->statements) {
        words[count++] = "}";
    }
    if (of_another) {
        PARSE_FAULT(p, p->next->at, "a %s %s has no '%s'; expected %s", r->kind, r->b->what, p->next->text,
                    alternatives(p->s->memory, words, count));
    } else {
        take_one_of(p, words, count);
    }
}

static void read_property(parser *p, reading *r)
{
    const token *word = p->next;
    const size_t i = block_index(r->b, word);
    const bool known = i < r->b->property_count;
    if (!known || !(r->b->properties[i].kinds & r->traits)) {
        refuse_property(p, r, known);
        return;
    }
    const property *found = &r->b->properties[i];
    if (r->first[i] != NULL && !(found->kinds & MANY)) {
        source_problem(p->s, word->at, "a second '%s'; the first is in %s", word->text,
                       source_line(p->s, r->first[i]->at));
    }
    r->first[i] = word;
    p->next++;
    p->word = word;
    found->read(p, r->to + found->slot);
}

/* After an error: on to the next line that begins with a word of this block or a statement, or to a closing brace. */
static void recover(parser *p, const block *b, const token *before)
{
    p->next += p->next == before;
    while (p->next->kind != TOKEN_END && !next_is_sign(p, '}') &&
           !(p->next->first_on_line && (block_has_word(b, p->next) || block_has_word(p->statements, p->next)))) {
        p->next++;
    }
    p->failed = false;
}

/* The word of a kind. */
static const char *word_of(const block *b, size_t kind)
{
    const char *word;
    memcpy(&word, (const char *)b->kinds + kind * b->kind_size, sizeof word);
    return word;
}

size_t parse_kind(parser *p, const block *b)
{
    const char *words[MOST_KINDS];
    for (size_t i = 0; i < b->kind_count; i++) {
        words[i] = word_of(b, i);
    }
    const size_t kind = take_one_of(p, words, b->kind_count);
    if (p->failed && p->next[0].kind != TOKEN_END && p->next[1].sign == '{') {
        p->failed = false;
        p->next++;
    }
    return kind;
}

/* The properties between the braces. Returns whether all could be read. */
static bool read_properties(parser *p, reading *r)
{
    const token *open = p->next - 1;
    bool whole = true;
    while (!take_sign(p, '}')) {
        const bool statement = block_has_word(p->statements, p->next) && !block_has_word(r->b, p->next);
        if (p->next->kind == TOKEN_END || (statement && p->next->first_on_line)) {
            return source_problem(p->s, open->at, "this { is never closed");
        }
        if (!take_sign(p, ';')) {
            const token *before = p->next;
            read_property(p, r);
            if (p->failed) {
                recover(p, r->b, before);
                whole = false;
            }
        }
    }
    return whole;
}

bool parse_block(parser *p, const block *b, size_t kind, name whose, void *to)
{
    const bool known = kind < b->kind_count;
    const token *first[MOST_PROPERTIES] = {NULL};
    reading r = {.b = b, .kind = known ? word_of(b, kind) : NULL, .first = first, .to = to};
    r.traits = !known ? EVERY_KIND : b->traits == NULL ? 1U << kind : b->traits(kind);
    if (!take_sign(p, '{')) {
        parse_problem(p, "expected {");
        return false;
    }
    const block *around = p->within;
    p->within = b;
    const bool whole = read_properties(p, &r);
    p->within = around;

    bool complete = whole;
    for (size_t i = 0; i < b->property_count && whole; i++) {
        const property *absent = &b->properties[i];
        if (r.first[i] == NULL && absent->needed != NULL && (absent->kinds & r.traits) &&
            (known || b->kind_count == 0)) {
            source_problem(p->s, whose.at, "the %s '%s' has no %s: %s", b->what, whose.text, absent->word,
                           absent->needed);
            complete = false;
        }
    }
    return complete;
}

bool parse_statements(parser *p, const block *statements, void *to)
{
    p->statements = statements;
    return parse_items_of(p, statements, to);
}

bool parse_items_of(parser *p, const block *b, void *to)
{
    const token *first[MOST_PROPERTIES] = {NULL};
    reading r = {.b = b, .traits = EVERY_KIND, .first = b == p->statements ? p->first : first, .to = to};
    p->within = b;
    bool whole = true;
    while (p->next->kind != TOKEN_END) {
        if (take_sign(p, ';')) {
            continue;
        }
        const token *before = p->next;
        read_property(p, &r);
        if (!p->failed && !p->next->first_on_line && !next_is_sign(p, ';') && p->next->kind != TOKEN_END) {
            parse_problem(p, "expected the end of the line");
        }
        if (p->failed) {
            recover(p, b, before);
            p->next += next_is_sign(p, '}');
            whole = false;
        }
    }
    return whole;
}

parser parser_of_option(source *s, scene *target, const script *original, const script *read)
{
    static const block none = {.what = "value"};
    token *first = lex(s, read, source_passage(s, original, 0, original->length, NULL));
    first->first_on_line = false; /* the line begins with the option */
    return (parser){
        .s = s, .target = target, .next = first, .statements = &none, .within = &none, .known = {.memory = s->memory}};
}

void parse_items(parser *p, item_reader *read, void *to, const char *further)
{
    while (p->next->kind != TOKEN_END && !p->failed) {
        read(p, to);
        if (!p->failed && p->next->kind != TOKEN_END && !take_sign(p, ';')) {
            parse_problem(p, further);
        }
    }
}

void read_formula(parser *p, void *slot)
{
    formula **to = slot;
    *to = parse_formula(p);
}

formula *parse_ticks(parser *p, const char *expected)
{
    formula *number = parse_formula(p);
    if (!p->failed && !take_word(p, "ticks")) {
        PARSE_FAULT(p, number->at, "%s", expected);
        return NULL;
    }
    return number;
}

void read_axis(parser *p, void *slot)
{
    formula **to = slot;
    *to = parse_axis(p);
}

/* A reader whose slot is a name. */
#define NAME_READER(reader, expected)                                                                                  \
    void reader(parser *p, void *slot)                                                                                 \
    {                                                                                                                  \
        *(name *)slot = take_name(p, expected);                                                                        \
    }
NAME_READER(read_input, "expected the name of an input")
NAME_READER(read_joint, "expected the name of a joint")
NAME_READER(read_method, "expected a method, such as rk4")

void read_switch(parser *p, void *slot)
{
    static const char *const words[] = {"yes", "no"};
    bool *to = slot;
    *to = take_one_of(p, words, COUNT_OF(words)) == 0;
}
