/* Sizes and limits in documents that are constants of core and of the monitor: a document and a text on a line. */
#include <stdio.h>

#include "core/runtime/loop.h"
#include "core/runtime/policy.h"
#include "core/runtime/snapshot.h"
#include "core/xcp/service.h"
#include "tools/monitor/monitor.h"

int main(void)
{
    const char *const runs = "core/README.md", *const link = "core/link/README.md", *const xcp = "core/xcp/README.md";
    printf("%s more than 1/%d of a period after they were due\n", runs, 1 << ISO_LATE_SHIFT);
    printf("%s counts the execution times of all ticks in %d equal bins of a period\n", runs, ISO_HISTOGRAM_BINS);
    printf("%s The size is %zu bytes and the\n", runs, ISO_SNAPSHOT_BYTES((size_t)0));
    printf("%s reads a piece of it, of %d bytes; the last one has what is left\n", link, ISO_COMMAND_PIECE);
    printf("%s in one packet or in a block of up to %d bytes\n", xcp, ISO_XCP_BLOCK_BYTES);
    printf("%s A packet of commands has up to %d bytes (MAX_CTO)\n", xcp, ISO_XCP_MAX_CTO);
    printf("%s up to %d lists, %d ODTs, and %d entries of up to 255 bytes\n", xcp, ISO_XCP_LISTS, ISO_XCP_TABLES,
           ISO_XCP_ENTRIES);
    printf("%s A packet has up to %d bytes (MAX_DTO), and one sample of a list, with its frames, up to %d.\n", xcp,
           ISO_XCP_MAX_DTO, ISO_XCP_SAMPLE_BYTES);
    printf("%s one command is answered, %d bytes are taken in at most, and a checksum is that of %d bytes at most\n",
           xcp, ISO_XCP_TICK_BYTES, ISO_XCP_CHECKSUM_BYTES);
    printf("%s more than %d bytes of values, the list more than %d inputs or %d bytes of frames\n", xcp,
           ISO_XCP_MAX_CTO - 1, ISO_XCP_STIMULI, ISO_XCP_STIMULUS_BYTES);
    printf("%s those within a frame's length (%d bytes) behind it\n", xcp, ISO_XCP_FRAME_BYTES);
    printf("%s a small curve of the last %g s\n", xcp, DISPLAY_CURVE * DISPLAY_PERIOD);
    printf("%s It waits %d s for an answer\n", xcp, MASTER_PATIENCE_MS / 1000);
    printf("%s A record is a DAQ list of up to %d values\n", xcp, MASTER_LIST_VALUES);
    return 0;
}
