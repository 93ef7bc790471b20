/* The names that a scene declares: each must be declared once, and is found where it is used. */
#ifndef ISOC_SCENE_NAMES_H
#define ISOC_SCENE_NAMES_H

#include "tools/isoc/scene/scene.h"

/* Names that must be different, also in upper case, as the generated enumerators are. */
typedef LIST_OF(name) name_list;

void listing_add(source *s, name_list *l, name n);

/* Notes names that are in it twice, or that differ only in case. */
void listing_check(source *s, name_list *l);

/* The same for the names that are declared; the states, which have names that follow from them, are not among these. */
void names_check(source *s, const scene *written);

/* The letters of an output's components; none where it has but one. */
const char *output_components(const scene *written, const output *o);

/* The index of the item with this name in a list of structs that begin with their name; -1 if there is none. */
#define INDEX_OF(list, called) index_called((list).all, (list).count, sizeof *(list).all, called)
int index_called(const void *things, size_t count, size_t size, const char *called);

/* The definition of a kind of effect; NULL if there is none. */
const effect_kind *find_effect_kind(const scene *written, name n);

/* The use's text for an operand, or NULL. */
const quantity *operand_called(const effect_use *use, const char *called);

/* The nearest name to a mistyped one, as a source_suggestion: of a kind of effect, in the scene or the library; of an
 * effect; of a tunable or a fault EFFECT.FAULT, which --set can name; of a name in formulas. */
const char *suggest_kind(source *s, const scene *written, const char *typed);
const char *suggest_effect(source *s, const scene *written, const char *typed);
const char *suggest_setting(source *s, const scene *written, const char *typed);
const char *suggest_number(source *s, const scene *written, const char *typed, bool in_formula);

/* The name of the memory that keeps a let, an output or (use NULL) a signal of a rate. */
const char *held_name(arena *memory, const effect_use *use, name kept);

/* The endings of the names of a state or a memory: three of a vector, then that of one number. */
extern const char *const effect_endings[];

/* The largest number of clocks that a motion can have: one for each use of the time in its formula. */
int closure_clocks(const closure_statement *c);

/* The index of the body, joint, input or effect that is called n; -1, with a problem that suggests the nearest, if
 * none is. Where a body can stand, a frame can: its index comes after those of the bodies. find_body gives -2 for
 * `ground`. */
int find_body(source *s, const scene *written, name n);
int find_joint(source *s, const scene *written, name n);
int find_input(source *s, const scene *written, name n);
int find_effect(source *s, const scene *written, name n);

/* The index of a closure or of a spring called n, as *is_closure says; -1 with a problem if none is. */
int find_closure_or_spring(source *s, const scene *written, name n, bool *is_closure);

/* The index of a joint, or of a body or a closure, called n, as *is_joint says; -1 with a problem if none is. */
int find_joint_or_body(source *s, const scene *written, name n, bool *is_joint);
int find_joint_or_closure(source *s, const scene *written, name n, bool *is_joint);

/* counts.c: the numbers of states, inputs, parameters and outputs of a plant: core/runtime/plant.h counts them in 16
 * bits. Notes the first one of each that is too many. Returns whether there is none. */
bool counts_check(source *s, const scene *written);

#endif
