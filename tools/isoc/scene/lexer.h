/* Text to tokens. Comments run from # to the end of the line. The grammar ignores line ends, but each token is marked
 * if it is the first on its line: so a unit is distinguished from the next statement, and the parser can continue after
 * an error. */
#ifndef ISOC_SCENE_LEXER_H
#define ISOC_SCENE_LEXER_H

#include "tools/isoc/scene/source.h"

typedef enum token_kind {
    TOKEN_END,
    TOKEN_NAME,
    TOKEN_NUMBER,
    TOKEN_SIGN, /* one of ( ) { } [ ] , ; : = + - * / ^ < > */
    TOKEN_TEXT, /* between quotation marks */
} token_kind;

typedef struct token {
    token_kind kind;
    place at;
    bool first_on_line;
    char sign;        /* of a TOKEN_SIGN, else 0 */
    double number;    /* of a TOKEN_NUMBER */
    const char *text; /* as written */
} token;

/* A parser may look so many tokens ahead: as many more of TOKEN_END stand behind the first one. */
enum { TOKENS_AHEAD = 3 };

/* All tokens of a script whose first byte is at this place, the last one TOKEN_END. Bytes that are no token are noted
 * as a problem and left out. */
token *lex(source *s, const script *input, place from);

#endif
