/* Planar simple pendulum, m = l = 1, g = 9.81, released at rest: angle from the downward vertical (rad) and its rate.
 *
 * theta = 2 asin(k sn(K(k) - w t, k)), k = sin(a / 2), w = sqrt(g / l), to 21 digits; the closed form and a second
 * computation by extrapolation agree on 29. The first start is benchmark A01 of the IFToMM library of multibody
 * problems. Starts near the top are left out: there rounding grows above the truncation error of a step of 1 ms.
 */
#ifndef ISO_TESTS_REFERENCE_PENDULUM_H
#define ISO_TESTS_REFERENCE_PENDULUM_H

#include "tests/reference/reference.h"

static const reference_case pendulum_cases[] = {
    {"A01, from the horizontal",
     {1.57079632679489661923L, 0.0L},
     6,
     {
         {500, {4.01770849808083341861e-1L, -4.24943036125613794459e+0L}},
         {1000, {-1.40502731152479914596e+0L, -1.79930901690707861881e+0L}},
         {2000, {9.16647589663244980066e-1L, 3.45520689905932977792e+0L}},
         {5000, {1.22945181148538555928e+0L, -2.56278756819262946008e+0L}},
         {9990, {3.21970555688020066379e-1L, -4.31413964583632078186e+0L}},
         {10000, {2.78680673569982948435e-1L, -4.34316069286468305329e+0L}},
     }},
    {"from 0.1 rad",
     {0.1L, 0.0L},
     6,
     {
         {500, {5.73024129485913008250e-4L, -3.13073563346471246722e-1L}},
         {1000, {-9.99934383401046519272e-2L, -3.58498403752463459951e-3L}},
         {2000, {9.99737542186545102405e-2L, 7.16949917494278010057e-3L}},
         {5000, {-9.98360014106012751745e-2L, -1.79155434344994180964e-2L}},
         {9990, {9.89382303486125475520e-2L, 4.54831541923362828266e-2L}},
         {10000, {9.93445417677253289194e-2L, 3.57725189554638688001e-2L}},
     }},
};

#endif
