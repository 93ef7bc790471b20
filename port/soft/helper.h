/* The functions that compilers call where a processor has no floating-point unit, by names of their own, in place of
 * libgcc's. A number comes and goes where an integer of 32 bits does. */
#ifndef ISO_PORT_SOFT_HELPER_H
#define ISO_PORT_SOFT_HELPER_H

#include <stdint.h>

#include "port/soft/binary32.h"

/* The function with this name and these parameters is this expression. */
#define SOFT_HELPER(type, name, parameters, expression)                                                                \
    type name parameters;                                                                                              \
    type name parameters                                                                                               \
    {                                                                                                                  \
        return expression;                                                                                             \
    }

#endif
