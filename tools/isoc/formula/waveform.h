/* Test signals as functions of the tick: step, square, prbs, chirp. */
#ifndef ISOC_FORMULA_WAVEFORM_H
#define ISOC_FORMULA_WAVEFORM_H

#include "tools/isoc/formula/value.h"

/* step(0.5 s), square(2 Hz, 90 deg), prbs(7, 10 ms, 9), chirp(1 Hz, 50 Hz, 10 s), of evaluated arguments. Count 0 after noting
 * a problem. */
value step_of_formula(values *v, const formula *f, const value *given);
value square_of_formula(values *v, const formula *f, const value *given);
value prbs_of_formula(values *v, const formula *f, const value *given);
value chirp_of_formula(values *v, const formula *f, const value *given);

#endif
