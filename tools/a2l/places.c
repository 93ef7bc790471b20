/* The statistics that a master can read, for its A2L; no part of a program. tools/lab/a2l.py reads the symbols of the
 * object: the size of place__TYPE__SYMBOL__NAME is the offset of the number behind SYMBOL, and one byte more; choice__
 * is a number that a program has only if its scene asks for it. */
#include "core/link/link.h"
#include "core/runtime/policy_counts.h"
#include "core/xcp/service.h"

#define PLACE(type, symbol, container, member, name)                                                                   \
    extern char place__##type##__##symbol##__##name[offsetof(container, member) + 1];                                  \
    char place__##type##__##symbol##__##name[offsetof(container, member) + 1];

PLACE(A_UINT64, loop, iso_loop, tick, tick)
#define LOOP_PLACE(name, member) PLACE(A_UINT64, loop, iso_loop, statistics.member, name)
ISO_STREAM_COUNTS(LOOP_PLACE)
PLACE(REAL, loop, iso_loop, statistics.local_error, local_error)
PLACE(REAL, loop, iso_loop, statistics.violation, violation)
PLACE(A_UINT64, iso_xcp_the_statistics, iso_xcp_statistics, commands, xcp_commands)
PLACE(A_UINT64, iso_xcp_the_statistics, iso_xcp_statistics, samples, xcp_samples)
PLACE(A_UINT64, iso_xcp_the_statistics, iso_xcp_statistics, lost, xcp_lost)
PLACE(A_UINT64, iso_xcp_the_statistics, iso_xcp_statistics, stimuli, xcp_stimuli)
PLACE(A_UINT64, iso_xcp_the_statistics, iso_xcp_statistics, missed, xcp_missed)
#define LINK_PLACE(name) PLACE(A_UINT64, iso_the_link, iso_link, statistics.name, link_##name)
ISO_LINK_COUNTS(LINK_PLACE)
PLACE(A_UINT64, iso_the_link, iso_link, control.left, ticks_left)
PLACE(A_UINT64, iso_the_link, iso_link, control.hash, hash)
PLACE(A_UINT64, iso_the_link, iso_link, commands.done, commands)
PLACE(A_UINT64, iso_the_link, iso_link, commands.refused, commands_refused)

/* The counts of policies, of a plant that has some. */
#define CHOICE(member, name)                                                                                           \
    extern char choice__A_UINT64__policed__##name[offsetof(iso_policy_histogram, member) + 1];                         \
    char choice__A_UINT64__policed__##name[offsetof(iso_policy_histogram, member) + 1];
#define POLICY_COUNT(name) CHOICE(counts.name, name)
ISO_POLICY_COUNTS(POLICY_COUNT)
CHOICE(width, histogram_width)
#define BIN(i) CHOICE(bins[i], histogram_##i)
#define BINS(i, j, k, l) BIN(i) BIN(j) BIN(k) BIN(l)
BINS(0, 1, 2, 3)
BINS(4, 5, 6, 7)
BINS(8, 9, 10, 11)
BINS(12, 13, 14, 15)
BINS(16, 17, 18, 19)
BINS(20, 21, 22, 23)
BINS(24, 25, 26, 27)
BINS(28, 29, 30, 31)
_Static_assert(ISO_HISTOGRAM_BINS == 32, "all bins have a place");
