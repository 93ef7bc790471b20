/* A scene without some of its effects: the difference of the two plants is the cost of these effects. */
#ifndef ISOC_SCENE_LEAVE_OUT_H
#define ISOC_SCENE_LEAVE_OUT_H

#include "tools/isoc/scene/lexer.h"
#include "tools/isoc/scene/scene.h"

/* Leaves out the effects that the script names, NAME; ..., and all that depends on them: the outputs that read them,
 * directly or through signals, the changes of their faults, and the inputs and signals that nothing else reads. One
 * output stays in any case. Another effect that reads them reads zero. */
void scene_leave_out(source *s, scene *written, const script *of);

/* Whether a formula reads an effect that is left out, itself or through signals. */
bool scene_reads_left_out(const scene *written, const formula *f);

#endif
