/* Point masses 1 kg on rods of 1 m, absolute angles th1, th2 from the downward vertical, d = th1 - th2 (Lagrange):
 * 2 th1'' + cos d th2'' = -sin d th2'^2 - 2 g sin th1
 * cos d th1'' + th2'' = sin d th1'^2 - g sin th2
 * The scene's joint angles are th1 and th2 - th1. */
#include "tests/isoc/dynamics/closed_form.h"

void closed_form(wide *const a, const wide *const q, const wide *const v, const wide *const u)
{
    (void)u;
    const wide g = 9.81L;
    const wide th1 = q[0];
    const wide th2 = q[0] + q[1];
    const wide w1 = v[0];
    const wide w2 = v[0] + v[1];
    const wide c = cosl(th1 - th2);
    const wide s = sinl(th1 - th2);
    const wide r1 = -s * w2 * w2 - 2.0L * g * sinl(th1);
    const wide r2 = s * w1 * w1 - g * sinl(th2);
    const wide determinant = 2.0L - c * c;
    const wide a1 = (r1 - c * r2) / determinant;
    const wide a2 = (2.0L * r2 - c * r1) / determinant;
    a[0] = a1;
    a[1] = a2 - a1;
}
