/* The statistics that a master can read, for its A2L: nothing that a program has. tools/build/a2l.sh reads the symbols of the
 * object: place__TYPE__SYMBOL__NAME is as large as the offset of what is there, behind SYMBOL, and one byte more. */
#include "core/link/link.h"
#include "core/xcp/service.h"

#define PLACE(type, symbol, of, member, name)                                                                          \
    extern char place__##type##__##symbol##__##name[offsetof(of, member) + 1];                                         \
    char place__##type##__##symbol##__##name[offsetof(of, member) + 1];

PLACE(A_UINT64, loop, iso_loop, tick, tick)
#define LOOP_PLACE(name, member) PLACE(A_UINT64, loop, iso_loop, statistics.member, name)
ISO_STREAM_COUNTS(LOOP_PLACE)
PLACE(REAL, loop, iso_loop, statistics.local_error, local_error)
PLACE(REAL, loop, iso_loop, statistics.violation, violation)
PLACE(A_UINT64, iso_xcp_the_statistics, iso_xcp_statistics, commands, xcp_commands)
PLACE(A_UINT64, iso_xcp_the_statistics, iso_xcp_statistics, samples, xcp_samples)
PLACE(A_UINT64, iso_xcp_the_statistics, iso_xcp_statistics, lost, xcp_lost)
#define LINK_PLACE(name) PLACE(A_UINT64, iso_the_link, iso_link, statistics.name, link_##name)
ISO_LINK_COUNTS(LINK_PLACE)
PLACE(A_UINT64, iso_the_link, iso_link, control.left, ticks_left)
PLACE(A_UINT64, iso_the_link, iso_link, control.hash, hash)
PLACE(A_UINT64, iso_the_link, iso_link, commands.done, commands)
PLACE(A_UINT64, iso_the_link, iso_link, commands.refused, commands_refused)
