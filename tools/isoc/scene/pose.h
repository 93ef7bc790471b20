/* Where things stand: a place, and turns one after the other. */
#ifndef ISOC_SCENE_POSE_H
#define ISOC_SCENE_POSE_H

#include "tools/isoc/scene/block.h"

/* [at FORMULA] ({ rotate FORMULA [about AXIS] } | quaternion FORMULA), as far as it is there; where a turn needs an
 * axis of its own it must have one. */
pose parse_pose(parser *p, bool axis_needed);

/* A body, and a place and turns on it; the slot is a placement. */
property_reader read_placement;

#endif
