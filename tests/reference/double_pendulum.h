/* Planar double pendulum, point masses, m = l = 1, g = 9.81, released at rest: absolute angles from the downward
 * vertical th1, th2 (rad) and their rates.
 *
 * Computed at 58 digits by extrapolation and checked by a second method; at least 22 digits agree. The second start is
 * that of relative joint angles pi/2, pi/2; a start error grows 5e5 times in 10 s there, so it ends at 5 s.
 */
#ifndef ISO_TESTS_REFERENCE_DOUBLE_PENDULUM_H
#define ISO_TESTS_REFERENCE_DOUBLE_PENDULUM_H

#include "tests/reference/reference.h"

static const reference_case double_pendulum_cases[] = {
    {"both arms horizontal",
     {1.57079632679489661923L, 1.57079632679489661923L, 0.0L, 0.0L},
     4,
     {
         {1000,
          {-6.25087699806390629954e-1L, -1.03458508568001234061e+0L, -3.92227957288797661687e+0L,
           -1.30309924869633124332e+0L}},
         {2000,
          {-4.82971534251754377449e-1L, -1.32404871230236254879e+0L, 3.06528819207340131517e+0L,
           2.94927154757161898304e+0L}},
         {5000,
          {-6.27186705066530730138e-1L, -1.30131555020981167791e+0L, 2.12540867384291065065e+0L,
           3.88188872726560743925e+0L}},
         {10000,
          {-5.68474664015950188776e-1L, -5.26393727932404698330e-1L, 6.07838488576196485482e+0L,
           -9.68136068170887875808e+0L}},
     }},
    {"lower arm upright",
     {1.57079632679489661923L, 3.14159265358979323846L, 0.0L, 0.0L},
     3,
     {
         {1000,
          {1.03467879073071977199e-1L, -1.68659681173517167988e+0L, -2.87969530493927966347e+0L,
           -6.96595836716847524578e+0L}},
         {2000,
          {-9.49997460153003754046e-1L, -2.47781243694755241598e+0L, 3.09984204456465840729e+0L,
           2.65803500344054269182e+0L}},
         {5000,
          {-2.00839500395857694595e+0L, 1.37431419461558583158e+0L, 1.86951626657370288453e+0L,
           4.70227245004053627351e-2L}},
     }},
};

#endif
