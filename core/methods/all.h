/* All methods: for each its header, and a row with its constant and its name. A plant has a list of its own, of the
 * methods of its steps: it includes their headers, and defines ISO_METHOD_LIST before core/methods/method.h. */
#ifndef ISO_CORE_METHODS_ALL_H
#define ISO_CORE_METHODS_ALL_H

/* clang-format off */
#include "core/methods/euler.h"
#include "core/methods/heun.h"
#include "core/methods/rk4.h"
#include "core/methods/ab4.h"
#include "core/methods/semi_implicit.h"
#include "core/methods/abm4.h"
#include "core/methods/abm4_pec.h"
#include "core/methods/abm4_pecece.h"
#include "core/methods/bdf4.h"
#include "core/methods/rosenbrock.h"
#include "core/methods/adams.h"

#define ISO_METHOD_LIST(X, r)                                                                                          \
    X(r, ISO_EULER, euler)                                                                                             \
    X(r, ISO_HEUN, heun)                                                                                               \
    X(r, ISO_RK4, rk4)                                                                                                 \
    X(r, ISO_AB4, ab4)                                                                                                 \
    X(r, ISO_SEMI_IMPLICIT, semi_implicit)                                                                             \
    X(r, ISO_ABM4, abm4)                                                                                               \
    X(r, ISO_ABM4_PEC, abm4_pec)                                                                                       \
    X(r, ISO_ABM4_PECECE, abm4_pecece)                                                                                 \
    X(r, ISO_BDF4, bdf4)                                                                                               \
    X(r, ISO_ROSENBROCK, rosenbrock)                                                                                   \
    X(r, ISO_ADAMS, adams)
/* clang-format on */

#endif
