/* Snapshots of a plant as files (core/runtime/snapshot.h). */
#ifndef ISO_TOOLS_MONITOR_SNAPSHOT_H
#define ISO_TOOLS_MONITOR_SNAPSHOT_H

#include "tools/monitor/master.h"

/* Takes a snapshot of the plant and writes it to the file, which is there only when it is whole. False: m->problem says
 * why. */
bool snapshot_save(master *m, const char *path);

/* Pauses the plant and puts it to the snapshot in the file, where it rests; or it goes on from where it was, paused.
 * False: m->problem says why. */
bool snapshot_load(master *m, const char *path);

#endif
