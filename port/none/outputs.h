/* A port that moves nothing: its C file includes this, which defines iso_port_publish and iso_port_safe. */
#ifndef ISO_PORT_NONE_OUTPUTS_H
#define ISO_PORT_NONE_OUTPUTS_H

#include "port/port.h"

#ifdef PINS_OUTPUTS
#error "a table of pins is for a port that has pins: isochron targets says which"
#endif

void iso_port_publish(const real *const y, const size_t outputs)
{
    (void)y;
    (void)outputs;
}

void iso_port_safe(void)
{
}

#endif
