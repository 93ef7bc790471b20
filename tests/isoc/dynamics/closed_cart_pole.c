/* Cart M at x, uniform rod m of half length l at theta from the upward vertical, its centre at
 * (x + l sin theta, l cos theta), its inertia m l^2 / 3 about the centre (Lagrange):
 * (M + m) x'' + m l cos theta theta'' = F - d x' + m l sin theta theta'^2
 * m l cos theta x'' + 4/3 m l^2 theta'' = m g l sin theta - e theta' */
#include "tests/isoc/dynamics/closed_form.h"

void closed_form(wide *const a, const wide *const q, const wide *const v, const wide *const u)
{
    const wide cart = 1.0L;
    const wide m = 0.2L;
    const wide l = 0.25L;
    const wide coupling = m * l * cosl(q[1]);
    const wide inertia = 4.0L / 3.0L * m * l * l;
    const wide r1 = u[0] - 0.1L * v[0] + m * l * sinl(q[1]) * v[1] * v[1];
    const wide r2 = m * 9.81L * l * sinl(q[1]) - 0.002L * v[1];
    const wide determinant = (cart + m) * inertia - coupling * coupling;
    a[0] = (inertia * r1 - coupling * r2) / determinant;
    a[1] = ((cart + m) * r2 - coupling * r1) / determinant;
}
