/* How many states, inputs, parameters and outputs a plant can have: core/runtime/plant.h counts them in 16 bits. */
#ifndef ISOC_SCENE_COUNTS_H
#define ISOC_SCENE_COUNTS_H

#include "tools/isoc/scene/scene.h"

/* Notes the first one that is too many of each. Returns whether there is none. */
bool counts_check(source *s, const scene *written);

#endif
