#include "tools/isoc/scene/lexer.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct lexer {
    source *s;
    const script *input;
    place from; /* of its first byte */
    size_t at;
    bool line_is_new;
    LIST_OF(token) tokens;
} lexer;

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static bool is_sign(char c)
{
    return c != '\0' && strchr("(){}[],;:=+-*/^<>", c) != NULL;
}

static void note(lexer *l, size_t at, const char *message)
{
    source_problem(l->s, l->from + at, "%s", message);
}

static bool is_space(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/* The text ends with a zero, so looking one character ahead is always allowed. */
static char look(const lexer *l, size_t ahead)
{
    return l->at + ahead < l->input->length ? l->input->text[l->at + ahead] : '\0';
}

static token *add(lexer *l, token_kind kind, size_t from)
{
    const token t = {
        .kind = kind,
        .at = l->from + from,
        .first_on_line = l->line_is_new,
        .text = arena_copy(l->s->memory, l->input->text + from, l->at - from),
    };
    LIST_ADD(l->s->memory, l->tokens, t);
    l->line_is_new = false;
    return &l->tokens.all[l->tokens.count - 1];
}

static void skip_digits(lexer *l)
{
    while (is_digit(look(l, 0))) {
        l->at++;
    }
}

/* digits [. digits] [e [+-] digits], or . digits */
static void lex_number(lexer *l)
{
    const size_t from = l->at;
    skip_digits(l);
    if (look(l, 0) == '.') {
        l->at++;
        skip_digits(l);
    }
    const bool exponent = look(l, 0) == 'e' || look(l, 0) == 'E';
    const size_t sign = look(l, 1) == '+' || look(l, 1) == '-';
    if (exponent && is_digit(look(l, 1 + sign))) {
        l->at += 1 + sign;
        skip_digits(l);
    }
    if (look(l, 0) == '.') {
        note(l, l->at, "a number has one decimal point: 1.5e-3");
        while (is_digit(look(l, 0)) || look(l, 0) == '.') {
            l->at++;
        }
    }
    token *t = add(l, TOKEN_NUMBER, from);
    t->number = strtod(t->text, NULL);
    const bool zero = strpbrk(t->text, "123456789") == NULL || t->text[strcspn(t->text, "123456789eE")] == 'e';
    if (isinf(t->number)) {
        note(l, from, "the number is too large: a double ends at 1.8e308");
        t->number = 1;
    } else if (fabs(t->number) < 2.2250738585072014e-308 && !zero) {
        note(l, from, "the number is too small: a double begins at 2.2e-308");
        t->number = 1;
    }
}

/* A dot joins the name of an effect and that of its member: drive.current, drive[2].current. */
static void lex_name(lexer *l)
{
    const size_t from = l->at;
    while (is_letter(look(l, 0)) || is_digit(look(l, 0)) || (look(l, 0) == '.' && is_letter(look(l, 1)))) {
        l->at++;
    }
    token *t = add(l, TOKEN_NAME, from);
    if (l->at - from > 64) {
        source_problem(l->s, l->from + from, "a name of %zu characters: at most 64 are allowed", l->at - from);
        t->text = arena_copy(l->s->memory, l->input->text + from, 64);
    }
}

/* One message for a sequence of bytes that begin no token. */
static void lex_garbage(lexer *l)
{
    const unsigned char c = (unsigned char)l->input->text[l->at];
    if (c == '\0') {
        note(l, l->at, "a NUL byte: a scene is plain text");
    } else if (l->at == 0 && c == 0xEF && (unsigned char)look(l, 1) == 0xBB && (unsigned char)look(l, 2) == 0xBF) {
        note(l, l->at, "a byte-order mark (EF BB BF): save the scene as UTF-8 without one");
    } else if (c < ' ' || c > '~') {
        source_problem(l->s, l->from + l->at, "a byte 0x%02X outside a comment: a scene is plain ASCII text",
                       (unsigned)c);
    } else {
        source_problem(l->s, l->from + l->at, "unexpected character '%c'", c);
    }
    while (l->at < l->input->length) {
        const char next = l->input->text[l->at];
        if (is_space(next) || is_letter(next) || is_digit(next) || is_sign(next) || next == '#') {
            return;
        }
        l->at++;
    }
}

static void skip_comment(lexer *l)
{
    while (l->at < l->input->length && l->input->text[l->at] != '\n') {
        if (l->input->text[l->at] == '\0') {
            note(l, l->at, "a NUL byte: a scene is plain text");
        }
        l->at++;
    }
}

/* "legs.scene": the text between the quotation marks. */
static void lex_text(lexer *l)
{
    const size_t from = l->at++;
    while (look(l, 0) >= ' ' && look(l, 0) != '"') {
        l->at++;
    }
    const bool closed = look(l, 0) == '"';
    if (!closed) {
        note(l, from, "the closing \" is missing on this line");
    }
    token *t = add(l, TOKEN_TEXT, from);
    t->text = arena_copy(l->s->memory, l->input->text + from + 1, l->at - from - 1);
    l->at += closed;
}

/* A carriage return alone ends no line, and joins it with the next: the first one is told. */
static void check_line_ends(const lexer *l)
{
    const char *end = strchr(l->input->text, '\r');
    while (end != NULL && end[1] == '\n') {
        end = strchr(end + 1, '\r');
    }
    if (end != NULL) {
        source_problem(l->s, l->from + (size_t)(end - l->input->text),
                       "a carriage return without a line feed: lines end with a line feed, or with both");
    }
}

token *lex(source *s, const script *input, place from)
{
    lexer l = {.s = s, .input = input, .from = from, .line_is_new = true};
    check_line_ends(&l);
    while (l.at < input->length) {
        const char c = input->text[l.at];
        if (is_space(c)) {
            l.line_is_new = l.line_is_new || c == '\n';
            l.at++;
        } else if (c == '#') {
            skip_comment(&l);
        } else if (is_digit(c) || (c == '.' && is_digit(look(&l, 1)))) {
            lex_number(&l);
        } else if (is_letter(c) || (c == '.' && l.at > 0 && input->text[l.at - 1] == ']' && is_letter(look(&l, 1)))) {
            lex_name(&l);
        } else if (c == '"') {
            lex_text(&l);
        } else if (is_sign(c)) {
            l.at++;
            add(&l, TOKEN_SIGN, l.at - 1)->sign = c;
        } else {
            lex_garbage(&l);
        }
    }
    l.line_is_new = true;
    l.at = input->length;
    for (int i = 0; i <= TOKENS_AHEAD; i++) {
        add(&l, TOKEN_END, input->length);
    }
    return l.tokens.all;
}
