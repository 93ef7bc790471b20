/* A port that measures nothing: its C file includes this, which defines iso_port_read. */
#ifndef ISO_PORT_NONE_INPUTS_H
#define ISO_PORT_NONE_INPUTS_H

#include "port/port.h"

#ifdef PINS_INPUTS
#error "a table of pins is for a port that has pins: isochron targets says which"
#endif

void iso_port_read(real *const u, const size_t inputs)
{
    (void)u;
    (void)inputs;
}

#endif
