/* The link of a plant, and the controller's end of it in C and in Python. */
#ifndef ISOC_EMIT_LINK_H
#define ISOC_EMIT_LINK_H

#include "tools/isoc/emit/naming.h"
#include "tools/isoc/emit/write.h"

/* Whether its frames are no longer than what a channel of a port takes at once (port/channel.h); if not, says so. */
bool link_fits(const plant *p, const char *path);

/* Adds interface.c, SCENE_link.h and SCENE_link.py to the plant's header and source, the first two of the files. Where a lock is
 * given, for measurement and calibration, the interface has that, and plant.a2l.in is added (a2l.h). */
void emit_link(const plant *p, const naming *names, const char *lock, file_list *files);

#endif
