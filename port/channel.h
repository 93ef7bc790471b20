/* Bytes to and from other programs: a port whose plants can be connected defines these five functions as well. A plant
 * without a link refers to none of them.
 *
 * A channel is a stream of bytes in both directions: a serial line, a socket, a terminal. Bytes may be damaged or
 * lost on it, and it may be closed and opened again at the other end at any time. Nothing here waits but
 * iso_port_idle and iso_port_drain.
 */
#ifndef ISO_PORT_CHANNEL_H
#define ISO_PORT_CHANNEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The use of each channel. */
typedef enum iso_channel {
    ISO_CHANNEL_CONTROLLER,  /* inputs and outputs, tick by tick (core/link) */
    ISO_CHANNEL_CALIBRATION, /* measurement and calibration (core/xcp) */
    ISO_CHANNELS
} iso_channel;

/* Every channel takes so many bytes at once, if none wait: no frame of a plant is longer, so that it works on every
 * port. */
enum { ISO_CHANNEL_BYTES = 2048 };

/* Takes up to count of the bytes that have come in. Returns how many. */
size_t iso_port_receive(iso_channel channel, void *bytes, size_t count);

/* Hands out all bytes, or none where there is no room for them. Returns whether it did. */
bool iso_port_send(iso_channel channel, const void *bytes, size_t count);

/* How often the other end has been opened: with each, the stream begins anew. 0: never, or it is a serial line, which
 * cannot know, and can damage bytes. */
uint32_t iso_port_opened(iso_channel channel);

/* Sleeps until a byte comes in on a channel, or a tick is due; may return earlier. Time that is virtual stands
 * still. */
void iso_port_idle(void);

/* Before the program ends: waits until all bytes that were handed out have gone, or no peer is there to take them. */
void iso_port_drain(void);

#endif
