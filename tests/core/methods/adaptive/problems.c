#include "tests/core/methods/adaptive/problems.h"

#include <math.h>

#define EQUATIONS(name)                                                                                                \
    static void name(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)

/* Restricted three bodies; one period. Arenstorf (1963); Hairer, Norsett, Wanner (1993), Solving Ordinary Differential
 * Equations I, eq. II.0.1. */
EQUATIONS(arenstorf)
{
    (void)u;
    (void)p;
    const double mu = 0.012277471;
    const double a = x[0] + mu;
    const double b = x[0] - (1.0 - mu);
    const double a3 = pow(a * a + x[1] * x[1], 1.5);
    const double b3 = pow(b * b + x[1] * x[1], 1.5);
    dx[0] = x[2];
    dx[1] = x[3];
    dx[2] = x[0] + 2.0 * x[3] - (1.0 - mu) * a / a3 - mu * b / b3;
    dx[3] = x[1] - 2.0 * x[2] - (1.0 - mu) * x[1] / a3 - mu * x[1] / b3;
}

/* Double pendulum of point masses, m = l = 1, g = 9.81: absolute angles and their rates. */
EQUATIONS(double_pendulum)
{
    (void)u;
    (void)p;
    const double c = cos(x[0] - x[1]);
    const double s = sin(x[0] - x[1]);
    const double a = -s * x[3] * x[3] - 2.0 * 9.81 * sin(x[0]);
    const double b = s * x[2] * x[2] - 9.81 * sin(x[1]);
    const double det = 2.0 - c * c;
    dx[0] = x[2];
    dx[1] = x[3];
    dx[2] = (a - c * b) / det;
    dx[3] = (2.0 * b - c * a) / det;
}

/* DETEST: Hull, Enright, Fellen, Sedgwick (1972), SIAM J. Numer. Anal. 9, 603-637. A3, with time as a state. */
EQUATIONS(detest_a3)
{
    (void)u;
    (void)p;
    dx[0] = x[0] * cos(x[1]);
    dx[1] = 1.0;
}

/* B1: two populations. */
EQUATIONS(detest_b1)
{
    (void)u;
    (void)p;
    dx[0] = 2.0 * (x[0] - x[0] * x[1]);
    dx[1] = -(x[1] - x[0] * x[1]);
}

/* B5: a rigid body without forces. */
EQUATIONS(detest_b5)
{
    (void)u;
    (void)p;
    dx[0] = x[1] * x[2];
    dx[1] = -x[0] * x[2];
    dx[2] = -0.51 * x[0] * x[1];
}

/* C3: heat along a rod. */
EQUATIONS(detest_c3)
{
    (void)u;
    (void)p;
    for (size_t i = 0; i < 10; i++) {
        dx[i] = (i > 0 ? x[i - 1] : 0.0) - 2.0 * x[i] + (i < 9 ? x[i + 1] : 0.0);
    }
}

/* D: Kepler's orbits; of eccentricity 0.1 (D1) and 0.9 (D5). */
EQUATIONS(detest_d)
{
    (void)u;
    (void)p;
    const double r3 = pow(x[0] * x[0] + x[1] * x[1], 1.5);
    dx[0] = x[2];
    dx[1] = x[3];
    dx[2] = -x[0] / r3;
    dx[3] = -x[1] / r3;
}

/* E2: Van der Pol. */
EQUATIONS(detest_e2)
{
    (void)u;
    (void)p;
    dx[0] = x[1];
    dx[1] = (1.0 - x[0] * x[0]) * x[1] - x[0];
}

const problem problems[PROBLEMS] = {
    {"Arenstorf's orbit",
     arenstorf,
     4,
     {0.994, 0.0, 0.0, -2.00158510637908252240537862224},
     17.0652165601579625588917206249,
     16,
     {0.994, 0.0, 0.0, -2.00158510637908252240537862224},
     7,
     350.0,
     0.1},
    {"double pendulum",
     double_pendulum,
     4,
     {1.57079632679489661923, 1.57079632679489661923, 0.0, 0.0},
     5.0,
     50,
     {-6.27186705066530730138e-1, -1.30131555020981167791e0, 2.12540867384291065065e0, 3.88188872726560743925e0},
     4,
     0.2,
     2.0},
    {"DETEST A3", detest_a3, 2, {1.0, 0.0}, 20.0, 16, {2.491650271850414523461175, 20.0}, 4, 0.07, 2.0},
    {"DETEST B1",
     detest_b1,
     2,
     {1.0, 3.0},
     20.0,
     16,
     {6.761876008576606607255741e-1, 1.860816099640029800751086e-1},
     4,
     0.75,
     2.0},
    {"DETEST B5",
     detest_b5,
     3,
     {0.0, 1.0, 1.0},
     20.0,
     16,
     {-9.396570798729203961884362e-1, -3.421177754000749065348221e-1, 7.414126596199953007825587e-1},
     4,
     0.8,
     3.0},
    {"DETEST C3",
     detest_c3,
     10,
     {1.0},
     20.0,
     16,
     {2.948119211022699412570728e-3, 5.635380154845295920824822e-3, 7.829072515927038293550260e-3,
      9.348257908595597083337289e-3, 1.007943610301980475016599e-2, 9.982674171429489014199244e-3,
      9.088693332765331902509506e-3, 7.489115195185085003980225e-3, 5.322964130952675595000004e-3,
      2.762434379029514432362538e-3},
     4,
     0.09,
     4.0},
    {"DETEST D1",
     detest_d,
     4,
     {0.9, 0.0, 0.0, 1.10554159678513328304},
     20.0,
     16,
     {2.198835352008396612849470e-1, 9.427076846341813085211993e-1, -9.787659841058176514576667e-1,
      3.287977990962036082625254e-1},
     4,
     6.0,
     2.0},
    {"DETEST D5",
     detest_d,
     4,
     {0.1, 0.0, 0.0, 4.35889894354067355224},
     20.0,
     16,
     {-1.295266250987574, 4.003938963792322e-1, -6.775390924707566e-1, -1.270838154278686e-1},
     4,
     6.0,
     0.2},
    {"DETEST E2",
     detest_e2,
     2,
     {2.0, 0.0},
     20.0,
     16,
     {2.008149762174948592014491, -4.250887527320214698592508e-2},
     4,
     0.1,
     2.0},
};

/* A quarter car on a damped bushing, linear: eigenvalues -2992, -1485 and -2.34 +- 7.95i per s. The reference is that
 * of a matrix exponential. States: zs, zu, zs', zu'. */
EQUATIONS(bushing)
{
    (void)u;
    (void)p;
    const double between = 22000.0 * (x[0] - x[1]) + 1500.0 * (x[2] - x[3]);
    dx[0] = x[2];
    dx[1] = x[3];
    dx[2] = -between / 320.0;
    dx[3] = (between - 2e8 * x[1] - 2e5 * x[3]) / 45.0;
}

const problem problem_bushing = {
    .name = "quarter car on a bushing",
    .f = bushing,
    .n = 4,
    .start = {0.05, 0.01, 0.0, 0.0},
    .end = 2.0,
    .ticks = 2000,
    .reference = {-4.68460287026972044069868827643e-4, -4.30037332816053997222e-8, 1.1804508400801001117915878677e-3,
                  3.28431349641969232e-7},
};
