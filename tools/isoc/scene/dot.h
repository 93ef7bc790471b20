/* The topology of a mechanism as a graph for graphviz: bodies with the forces on them, joints with their kinds and
 * effects, closures as dashed edges. */
#ifndef ISOC_SCENE_DOT_H
#define ISOC_SCENE_DOT_H

#include "tools/isoc/base/text.h"
#include "tools/isoc/scene/scene.h"

/* Of a scene in which nothing is wrong. */
void dot_write(const scene *written, text *out);

#endif
