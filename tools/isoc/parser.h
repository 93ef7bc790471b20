/* Tokens to a scene. The grammar (README.md has it with examples):
 *
 *   scene      = { gravity FORMULA | step FORMULA | method NAME | compensated (yes | no) | checked (yes | no)
 *                | iterations FORMULA | tolerance FORMULA | substeps FORMULA | body | joint | parameter | input | output }
 *   body       = body NAME { mass FORMULA | com FORMULA | inertia FORMULA }
 *   joint      = joint NAME (fixed | revolute | prismatic) { parent placement | child placement | axis AXIS
 *                | start FORMULA | speed FORMULA | continuous | damping FORMULA | spring FORMULA [rest FORMULA]
 *                | drive NAME }
 *   placement  = NAME [at FORMULA] { rotate FORMULA about AXIS }
 *   parameter  = (constant | tunable) NAME = FORMULA
 *   input      = input NAME [jump FORMULA] [= FORMULA]
 *   output     = output NAME = energy | local_error | residual | (position | speed | acceleration | velocity | turns) of NAME
 *                [at FORMULA] [along (x | y | z)]
 */
#ifndef ISOC_PARSER_H
#define ISOC_PARSER_H

#include "tools/isoc/lexer.h"
#include "tools/isoc/scene.h"

/* Where the parser stands; shared by parser.c and formula.c. */
typedef struct parser {
    source *s;
    const token *next;
    bool failed; /* in this statement */
    int depth;   /* of nested parentheses */
} parser;

/* What the source says, as far as it can be understood; the rest is noted as problems. */
scene parse_scene(source *s, const token *tokens);

/* One formula: sums of products of signed powers of numbers with units, names, vectors and calls. Returns NULL, with
 * p->failed set and a problem noted, where there is none. */
formula *parse_formula(parser *p);

/* x, y, z, -x, -y, -z or a vector. */
formula *parse_axis(parser *p);

formula *formula_new(parser *p, formula_kind kind, place at);

/* Takes the next token if it is this sign or this word. */
bool take_sign(parser *p, char sign);
bool take_word(parser *p, const char *word);
bool next_is_sign(const parser *p, char sign);

/* Notes a problem at the next token, once a statement, and sets p->failed. */
void parse_problem(parser *p, const char *message);

#endif
