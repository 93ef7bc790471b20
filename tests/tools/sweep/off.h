/* Defects for tests/tools/sweep/test_lanes.py, of runs side by side only: what follows the headers of core has other
 * calls.
 */
#ifdef ISO_LANES
#include "core/runtime/hash.h"
#include "core/runtime/tick.h"
#if OFF == 1 /* the values of the runs are lost */
#define iso_lanes_begin(lanes) iso_lanes_start(lanes)
#elif OFF == 2 /* a state is not in the hash */
#define iso_hash_lanes(hashes, x, n) iso_hash_lanes(hashes, x, (n)-1U)
#elif OFF == 3 /* the other of two extremes */
#define iso_select(mask, a, b) iso_select(mask, b, a)
#elif OFF == 4 /* a lane that the guard has stopped is taken for one that was near a singular position */
#define iso_beyond(x, range) (ISO_NOTHING + 0 * iso_bits_of(x))
#endif
#endif
