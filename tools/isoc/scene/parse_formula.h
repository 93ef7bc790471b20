/* Tokens to formulas. */
#ifndef ISOC_SCENE_PARSE_FORMULA_H
#define ISOC_SCENE_PARSE_FORMULA_H

#include "tools/isoc/scene/take.h"

/* One formula: sums of products of signed powers of numbers with units, names, vectors and calls. Returns NULL, with
 * p->failed set and a problem noted, where there is none, or where one is noted already. */
formula *parse_formula(parser *p);

/* x, y, z, -x, -y, -z or a vector. */
formula *parse_axis(parser *p);

/* Whether `of` follows the next word on its line. */
bool next_is_owned(const parser *p);

/* Whether the next words are those of a quantity: speed of NAME. */
bool next_is_quantity(const parser *p);

/* Takes a unit, such as N*m/A, where the next token begins one. Returns whether it does. */
bool take_unit(parser *p, unit *taken);

/* 2 N * ks: a unit, though something is called so too. Notes it for all such factors from this one on. */
void refuse_factor(parser *p, size_t from, const char *called);

#endif
