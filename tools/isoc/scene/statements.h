/* Statements that have a file of their own; the slot of each reader is the scene, of `stabilisation` and of how the loop runs that of a scene.
 * `repeat` and `include` add what the statements in them are. */
#ifndef ISOC_SCENE_STATEMENTS_H
#define ISOC_SCENE_STATEMENTS_H

#include "tools/isoc/scene/block.h"

property_reader read_body, read_frame, read_joint_statement, read_closure, read_force, read_spring_statement,
    read_stabilisation, read_output, read_effect, read_signal, read_setting, read_repeat, read_include, read_overrun,
    read_grace, read_publish, read_histogram;

#endif
