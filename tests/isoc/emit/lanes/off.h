/* A defect for tests/isoc/emit/lanes/test_side_by_side.py: with lanes all constants are others. */
#ifdef ISO_LANES
#include "core/numbers/real.h"
#undef R
#define R(literal) ((real){ISO_REPEAT(ISO_LANES, ISO_SCALAR(literal) * ISO_SCALAR(1.000001))})
#endif
