/* Seven bodies in a plane that attract each other, with close encounters: the problem PLEI of Hairer, Norsett, Wanner
 * (1993), Solving Ordinary Differential Equations I, II.10. */
#include <math.h>

#include "core/runtime/handwritten.h"

enum { BODIES = 7, STATES = 4 * BODIES };

ISO_PLANT_MEMORY(STATES, 0, 0, STATES);

static const real start[STATES] = {R(3.0), R(3.0),  -R(1.0), -R(3.0),  R(2.0), -R(2.0), R(2.0),
                                   R(3.0), -R(3.0), R(2.0),  R(0.0),   R(0.0), -R(4.0), R(4.0),
                                   R(0.0), R(0.0),  R(0.0),  R(0.0),   R(0.0), R(1.75), -R(1.5),
                                   R(0.0), R(0.0),  R(0.0),  -R(1.25), R(1.0), R(0.0),  R(0.0)};

/* An instruction on both, correctly rounded. */
static inline real root(const real x)
{
#ifdef ISO_REAL_DOUBLE
    return sqrt(x);
#else
    return sqrtf(x);
#endif
}

static void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                       const real *restrict const p)
{
    (void)u;
    (void)p;
    for (int i = 0; i < 2 * BODIES; i++) {
        dx[i] = x[2 * BODIES + i];
        dx[2 * BODIES + i] = R(0.0);
    }
    for (int i = 0; i < BODIES; i++) {
        for (int j = 0; j < i; j++) {
            const real a = x[j] - x[i];
            const real b = x[BODIES + j] - x[BODIES + i];
            const real square = a * a + b * b;
            const real w = R(1.0) / (square * root(square));
            dx[2 * BODIES + i] += (real)(j + 1) * w * a;
            dx[3 * BODIES + i] += (real)(j + 1) * w * b;
            dx[2 * BODIES + j] -= (real)(i + 1) * w * a;
            dx[3 * BODIES + j] -= (real)(i + 1) * w * b;
        }
    }
}

static void output(real *restrict const y, const real *restrict const x, const real *restrict const u,
                   const real *restrict const p)
{
    (void)u;
    (void)p;
    for (int i = 0; i < STATES; i++) {
        y[i] = x[i];
    }
}

static const iso_equations equations = {.derivative = derivative};

ISO_PLANT(STATES, 0, 0, STATES, .name = "pleiades",
          .output_names = "x1,x2,x3,x4,x5,x6,x7,y1,y2,y3,y4,y5,y6,y7,"
                          "u1,u2,u3,u4,u5,u6,u7,v1,v2,v3,v4,v5,v6,v7");
