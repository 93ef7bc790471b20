/* A source to a scene. In the grammar, JOINT, CLOSURE, SOLID and QUANTITY are words of the tables in joint_kinds.c,
 * closure_kinds.h, parse_body.c and quantities.h. Which properties a kind has, and which it needs, is in the tables of
 * parse_*.c. README.md in tools/isoc has examples.
 *
 *   scene         = { statement }
 *   statement     = gravity FORMULA | step FORMULA | method NAME | compensated (yes | no) | checked (yes | no)
 *                 | iterations FORMULA | tolerance FORMULA | substeps FORMULA | stabilisation | body | frame | joint
 *                 | closure | spring | force | parameter | input | output | signal NAME = FORMULA
 *                 | mode NAME [in ( NAME { , NAME } )] = FORMULA | when condition { { set target = FORMULA } }
 *                 | events FORMULA [rest NAME] | at FORMULA set NAME = FORMULA | repeat | include
 *                 | every FORMULA [at FORMULA] { { signal | output | effect } }
 *   body          = body NAME { mass FORMULA | com FORMULA | inertia FORMULA [as_given] { rotate FORMULA about
 *                 AXIS } | SOLID FORMULA [as_given] of FORMULA [at FORMULA] { rotate FORMULA about AXIS } }
 *   frame         = frame NAME { on placement }
 *   joint         = joint NAME JOINT { parent placement | child placement | axis AXIS | second AXIS
 *                 | start ([about] FORMULA | pose) | speed FORMULA | spin FORMULA | continuous | damping FORMULA
 *                 | spin_damping FORMULA | spring FORMULA [rest FORMULA] | armature FORMULA
 *                 | spin_armature FORMULA | drive NAME }
 *   closure       = close NAME CLOSURE { parent placement | child placement | axis AXIS | length FORMULA
 *                 | radius FORMULA | first NAME | second NAME | ratio FORMULA | motion FORMULA | speed FORMULA }
 *   spring        = spring NAME { between NAME [at FORMULA] and NAME [at FORMULA] | stiffness FORMULA | damping FORMULA
 *                 | length FORMULA }
 *   force         = force NAME { body NAME [at FORMULA] | axis AXIS | drive NAME | moment FORMULA }
 *   stabilisation = stabilisation (baumgarte | projection | lagrangian | none) [{ alpha FORMULA | beta FORMULA
 *                 | penalty FORMULA | omega FORMULA | mu FORMULA | iterations FORMULA | limit FORMULA }]
 *   placement     = NAME [at FORMULA] { rotate FORMULA about AXIS }
 *   pose          = [at FORMULA] ({ rotate FORMULA [about AXIS] } | quaternion FORMULA)
 *   parameter     = constant NAME = FORMULA | tunable NAME = FORMULA [in FORMULA to FORMULA]
 *   input         = input NAME [UNIT] [held | smooth] [jump FORMULA] [= FORMULA] [in FORMULA to FORMULA]
 *                 [safe FORMULA after FORMULA ticks]
 *   output        = output NAME = FORMULA [every FORMULA ticks]
 *                 a FORMULA has QUANTITY [of NAME [at FORMULA] [in (body | ground)] [along (w | x | y | z)]]
 *   condition     = conjunction { or conjunction }
 *   conjunction   = [not] comparison { and [not] comparison }
 *   comparison    = FORMULA [(< | > | <= | >= | ==) FORMULA]
 *   target        = NAME | speed of NAME | position of NAME
 *   repeat        = repeat WORD from FORMULA to FORMULA { { statement } }
 *   include       = include "FILE"
 *
 * A condition stands in parentheses, and behind `when`. A NAME is a word, which indices may follow: WORD { [ FORMULA ]
 * [WORD] }. Effects are in parse_effect.c; overrun, grace, publish and histogram in parse_policies.c.
 */
#ifndef ISOC_SCENE_PARSER_H
#define ISOC_SCENE_PARSER_H

#include "tools/isoc/base/text.h"
#include "tools/isoc/scene/lexer.h"
#include "tools/isoc/scene/names.h"

/* The statements of the source, as far as it can be understood; the rest is noted as problems. With `joints`, a kind of
 * them, each definition of an effect has a trial: a use with operands of its units. */
scene parse_scene(source *s, const char *joints);

/* trials.c: the statements of the trials of the definitions so far. */
const char *trial_statements(source *s, const scene *written, const char *joints);

/* parts.c: effects in effects. Puts the uses of parts behind the uses that have them; notes a part of itself. */
void expand_parts(source *s, scene *written);

/* Whether a use is another, or a part in it; by their indices. */
bool is_within_use(const scene *written, int use, int outer);

/* The scene's own text for an operand that is a name, by way of the operands of what has the part; NULL: there is none.
 */
const quantity *operand_in_scene(const scene *written, const effect_use *use, const char *called);

/* NAME = VALUE; ...: values that take the place of those of the constants and tunables that have these names, and
 * starts of the faults EFFECT.FAULT, which are 0 without. */
void scene_set(source *s, scene *written, const script *settings);

/* The formula of an option that replaces a statement's; NULL after noting a problem. */
formula *scene_formula(source *s, scene *written, const script *words);

/* The unit that isoc writes so; that of a plain number where it is none. */
unit unit_of_text(arena *memory, const char *words);

/* leave_out.c: a scene without some of its effects: the difference of the two plants is the cost of these effects. */

/* Leaves out the effects that the script names, NAME; ..., and all that depends on them: the outputs that read them,
 * directly or through signals, the changes of their faults, and the inputs and signals that nothing else reads. One
 * output stays in any case. Another effect that reads them reads zero. */
void scene_leave_out(source *s, scene *written, const script *names);

/* Whether a formula reads an effect that is left out, itself or through signals. */
bool scene_reads_left_out(const scene *written, const formula *f);

/* dot.c: the topology of a mechanism as a graph for graphviz: bodies with the forces on them, joints with their kinds
 * and effects and states, closures as dashed edges. */

/* Writes a scene without problems, with the states' names, each where its owner is declared. */
void dot_write(const scene *written, const name_list *states, text *out);

#endif
