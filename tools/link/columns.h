/* The inputs of a run as columns of its table. */
#ifndef ISO_TOOLS_LINK_COLUMNS_H
#define ISO_TOOLS_LINK_COLUMNS_H

#include "tools/link/account.h"

/* Adds the inputs to DIRECTORY/trace.csv and units.csv, by the names and units in the header that isoc wrote for a
 * controller. The row of a tick has the inputs that answered its outputs; without an answer, the last ones; before
 * these, 0. */
void columns_add(const char *directory, const char *header, const account *a);

#endif
