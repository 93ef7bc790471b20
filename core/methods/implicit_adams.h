/* Adams formulas; the implicit ones by the number of their derivatives, for correctors and for checks of steps. */
#ifndef ISO_CORE_METHODS_IMPLICIT_ADAMS_H
#define ISO_CORE_METHODS_IMPLICIT_ADAMS_H

#include "core/numbers/real.h"

enum { ISO_ADAMS_DERIVATIVES = 6 };

/* x += h / over (b[0] f + b[1] f[-1] + ...), where an explicit one begins with the derivative at the start of the step
 * and an implicit one with that at its end. The coefficients are whole numbers, so a test can prove the order exactly.
 */
typedef struct iso_adams {
    int16_t b[ISO_ADAMS_DERIVATIVES];
    int16_t over;
} iso_adams;

/* By the number of derivatives from before the end of the step; their order is one more. Bashforth and Adams (1883), An
 * Attempt to Test the Theories of Capillary Action, ch. 3; in this form Hairer, Norsett, Wanner (1993), Solving
 * Ordinary Differential Equations I, table III.1.2. */
static const iso_adams iso_table_am[ISO_ADAMS_DERIVATIVES] = {
    {.b = {1}, .over = 1},
    {.b = {1, 1}, .over = 2},
    {.b = {5, 8, -1}, .over = 12},
    {.b = {9, 19, -5, 1}, .over = 24},
    {.b = {251, 646, -264, 106, -19}, .over = 720},
    {.b = {475, 1427, -798, 482, -173, 27}, .over = 1440},
};

#endif
