/* A pose: a place, then turns one after the other. */
#ifndef ISOC_SCENE_POSE_H
#define ISOC_SCENE_POSE_H

#include "tools/isoc/scene/block.h"

/* [at FORMULA] ({ rotate FORMULA [about AXIS] } | quaternion FORMULA), or as much of it as there is. If axis_needed,
 * each turn must have its axis; if part_needed, the first part may stand on the next line. */
pose parse_pose(parser *p, bool axis_needed, bool part_needed);

/* A body, and a place and turns on it; the slot is a placement. */
property_reader read_placement;

#endif
