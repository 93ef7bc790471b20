/* m l^2 theta'' = -m g l sin theta. */
#include "tests/isoc/dynamics/closed_form.h"

void closed_form(wide *const a, const wide *const q, const wide *const v, const wide *const u)
{
    (void)v;
    (void)u;
    a[0] = -9.81L * sinl(q[0]);
}
