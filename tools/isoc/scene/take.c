#include "tools/isoc/scene/take.h"

#include <string.h>

void parse_problem(parser *p, const char *message)
{
    if (!p->failed) {
        const bool ended = p->next->text[0] == '\0';
        const char *found = ended ? "the end of the file" : p->next->text, *quote = ended ? "" : "'";
        PARSE_FAULT(p, p->next->at, "%s; found %s%s%s", message, quote, found, quote);
    }
}

bool next_is_sign(const parser *p, char sign)
{
    return p->next->sign == sign;
}

bool next_is_word(const parser *p, const char *word)
{
    return p->next->kind == TOKEN_NAME && strcmp(p->next->text, word) == 0;
}

bool take_sign(parser *p, char sign)
{
    const bool is = !p->failed && next_is_sign(p, sign);
    p->next += is;
    return is;
}

bool take_word(parser *p, const char *word)
{
    const bool is = !p->failed && next_is_word(p, word);
    p->next += is;
    return is;
}

void expect_sign(parser *p, char sign, const char *expected)
{
    if (!take_sign(p, sign)) {
        parse_problem(p, expected);
    }
}

void expect_word(parser *p, const char *word, const char *expected)
{
    if (!take_word(p, word)) {
        parse_problem(p, expected);
    }
}

bool take_option(parser *p, const char *word)
{
    return !p->next->first_on_line && take_word(p, word);
}

size_t take_one_of(parser *p, const char *const *words, size_t count)
{
    const size_t found = p->failed || p->next->kind != TOKEN_NAME ? count : index_of_word(p->next->text, words, count);
    if (found < count) {
        p->next++;
        return found;
    }
    const char *near = p->next->kind == TOKEN_NAME ? source_suggestion(p->s, p->next->text, words, count) : "";
    parse_problem(p, arena_format(p->s->memory, "expected %s%s", alternatives(p->s->memory, words, count), near));
    return count;
}

name take_name(parser *p, const char *expected)
{
    name n = {NULL, p->next->at};
    if (p->failed || p->next->kind != TOKEN_NAME || p->next->first_on_line) {
        parse_problem(p, expected);
        return n;
    }
    n.text = p->next->text;
    p->next++;
    n.text = take_indices(p, n.text);
    return n;
}

/* A new name, which is none of these words. */
static name take_new(parser *p, const char *expected, const char *const *words, size_t count)
{
    const name n = take_name(p, expected);
    if (index_of_word(n.text, words, count) < count) {
        source_problem(p->s, n.at, "'%s' is a word of the language: choose another name", n.text);
    }
    if (n.text != NULL && strchr(n.text, '.') != NULL) {
        source_problem(p->s, n.at, "'%s': a new name has no dot", n.text);
    }
    return n;
}

name take_inner_name(parser *p, const char *expected)
{
    static const char *const words[] = {"pi", "time", "substeps"};
    return take_new(p, expected, words, COUNT_OF(words));
}

/* The ground, where a body can stand, and the numbers that a formula can name, are names already. */
name take_new_name(parser *p, const char *expected)
{
    static const char *const words[] = {"ground", "pi", "time"};
    return take_new(p, expected, words, COUNT_OF(words));
}

/* Nor can words that begin a clause be names in its place: start about 60 deg, start at (1, 2, 0) m. */
name take_parameter_name(parser *p, const char *expected)
{
    static const char *const words[] = {"ground", "pi", "time", "at", "about", "rotate", "quaternion"};
    const name n = take_new(p, expected, words, COUNT_OF(words));
    size_t count;
    const char *const *units = unit_names(&count);
    if (index_of_word(n.text, units, count) < count) {
        source_problem(p->s, n.at, "'%s' is a unit: choose another name", n.text);
    }
    return n;
}

const rate_block *take_rate(parser *p)
{
    if (p->block != NULL) {
        source_problem(p->s, p->word->at, "a block of a rate within the one of %s: put them beside each other",
                       source_line(p->s, p->block->at));
    }
    rate_block *result = arena_take(p->s->memory, 1, sizeof *result);
    result->at = p->word->at;
    result->period = parse_formula(p);
    if (!p->failed && take_word(p, "at")) {
        result->phase = parse_formula(p);
    }
    return p->failed ? NULL : result;
}
