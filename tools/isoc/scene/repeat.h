/* Indices of repeats, and what they are made of. */
#ifndef ISOC_SCENE_REPEAT_H
#define ISOC_SCENE_REPEAT_H

#include "tools/isoc/scene/take.h"

/* The index of a repeat that is being read; NULL if none has this name. */
const int *find_index(const parser *p, const char *called);

/* { [ index ] } after a name: leg[3] is leg3, and wheel2[3] is wheel2_3. Returns the whole name. */
const char *take_indices(parser *p, const char *called);

/* A file that the file of this place names: relative to its folder. NULL with the reason in *fault. */
const script *open_beside(parser *p, place word, const char *named, const char **fault);

/* Reads these tokens as statements. */
void parse_nested(parser *p, const token *tokens, void *to);

/* A constant that is a plain number can be used in indices below it. */
void note_constant(parser *p, const quantity *q);

/* An index and a parameter must not have one name. */
void check_indices(const parser *p);

#endif
