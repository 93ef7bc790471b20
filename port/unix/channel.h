/* The functions of a port of the host that its channels call: both, the one in virtual time and the one in real
 * time, share them. */
#ifndef ISO_PORT_HOST_CHANNEL_H
#define ISO_PORT_HOST_CHANNEL_H

#include <stdint.h>

/* Nanoseconds until the next tick is due; negative where time is virtual, and stands still until a byte comes in. */
int64_t host_until_tick(void);

#endif
