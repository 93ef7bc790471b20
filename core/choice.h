/* The method and the step of a plant written by hand, where the build says nothing else:
 * -DISO_METHOD=ISO_HEUN -DISO_METHOD_NAME=heun -DISO_STEP=0.0005 (seconds, with a decimal point). A generated plant has
 * its own. */
#ifndef ISO_CORE_CHOICE_H
#define ISO_CORE_CHOICE_H

#include "core/method.h"

#ifndef ISO_METHOD
#define ISO_METHOD ISO_RK4
#define ISO_METHOD_NAME rk4
#endif

#ifndef ISO_STEP
#define ISO_STEP 0.001
#endif

_Static_assert(!ISO_IS(ISO_METHOD, ISO_ADAMS),
               "adams is for scenes; a plant in C calls iso_adams_tick of core/adams.h");

/* The step as a number, as text, and as the port's tick. */
#define ISO_STEP_SIZE ISO_EXPAND(R, ISO_STEP)
#define ISO_METHOD_TEXT ISO_EXPAND(ISO_STRING, ISO_METHOD_NAME)
#define ISO_STEP_TEXT ISO_EXPAND(ISO_STRING, ISO_STEP)
#define ISO_STEP_NS ((uint32_t)(ISO_STEP * 1e9 + 0.5))

#define ISO_EXPAND(macro, argument) macro(argument)
#define ISO_STRING(text) #text

#endif
