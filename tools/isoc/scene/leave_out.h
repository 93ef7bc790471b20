/* A scene without some of its effects: what each of them costs is the difference. */
#ifndef ISOC_SCENE_LEAVE_OUT_H
#define ISOC_SCENE_LEAVE_OUT_H

#include "tools/isoc/scene/lexer.h"
#include "tools/isoc/scene/scene.h"

/* Leaves out the effects that the script names, NAME; ...: the scene is then as if it had neither them nor what cannot be
 * without them: the outputs that read them, itself or through signals, the changes of their faults, and the inputs and
 * signals that nothing else reads. One output stays in any case. Where another effect reads them, they are zero. */
void scene_leave_out(source *s, scene *written, const script *of);

/* Whether a formula reads an effect that is left out, itself or through signals. */
bool scene_reads_left_out(const scene *written, const formula *f);

#endif
