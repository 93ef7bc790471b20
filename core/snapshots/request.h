/* The request of a run beyond its length: to begin at a snapshot, to take one. tools/build/request.sh writes it for
 * each such run, the snapshot with it, so that no port needs a file to read from. */
#ifndef ISO_CORE_SNAPSHOTS_REQUEST_H
#define ISO_CORE_SNAPSHOTS_REQUEST_H

#include <stddef.h>
#include <stdint.h>

#define ISO_REQUEST_NONE UINT64_MAX

typedef struct iso_request {
    uint64_t at;               /* the tick of the snapshot that is taken, or ISO_REQUEST_NONE */
    const unsigned char *from; /* [from_bytes] the snapshot that the run begins at; NULL: at the start */
    size_t from_bytes;
} iso_request;

extern const iso_request iso_the_request;

#endif
