/* The topology of a mechanism as a graph for graphviz: bodies with the forces on them, joints with their kinds and
 * effects and states, closures as dashed edges. */
#ifndef ISOC_SCENE_DOT_H
#define ISOC_SCENE_DOT_H

#include "tools/isoc/base/text.h"
#include "tools/isoc/scene/scene.h"

/* The states' names, each with the place in the scene where its owner is declared. */
typedef struct drawn_states {
    const name *names;
    size_t count;
} drawn_states;

/* Of a scene in which nothing is wrong. */
void dot_write(const scene *written, const drawn_states *states, text *out);

#endif
