/* The channel of the port as a script: what comes in, and how much room there is. core/xcp/service.c is compiled for
 * it, so that the same test runs beside any port. */
#ifndef TESTS_UNIT_XCP_CHANNEL_H
#define TESTS_UNIT_XCP_CHANNEL_H

#define iso_port_receive fake_receive
#define iso_port_send fake_send
#define iso_port_opened fake_opened

#include "port/channel.h"

#endif
