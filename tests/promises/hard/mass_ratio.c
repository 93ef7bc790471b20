/* Three links with masses in the ratio 1e6, heavy above and light below or the other way round, for a second without
 * damping. Run twice, by the tensions of the rods (tests/promises/hard/chain.h) and as isoc generates it from a scene
 * by its mass matrix, in angles of the joints; the program links the plant of one scene. Against a solution on which
 * rk4 and abm4 agree, both in double, compensated, at h = 2^-21 s: 12 digits of the angles, 11 of the rates.
 *
 * What must hold for rk4, in float and in double:
 *   light tip, 2500 steps: the largest error of a state is 1e-11 rad (rad/s) in double, 3e-5 in float.
 *   heavy tip, 40,000 steps: its links of 1 mg and 1 g swing at 3e3 rad/s and more. Angles to
 *   2e-9 rad and 2e-5 rad, rates to 1e-5 rad/s and 0.05 rad/s (the rounding of an angle, 3e-8 rad, is 1e-4 rad/s at
 *   that frequency, every step anew).
 *   the energy stays to 1.3e-14 with the light tip, which is the truncation of rk4, and walks by rounding: the
 * variances of all steps add, and a walk is within four of their standard deviations but once in 8000 runs. Controls:
 * euler with the same step does not keep the energy; rk4 at h = 2^-9 s, where the heavy tip is beyond its limit on the
 * imaginary axis, ends with states that are not finite.
 */
#include <math.h>

#include "core/runtime/plant.h"
#include "tests/promises/hard/chain.h"

/* Standard deviations that a walk is allowed. */
#define SIGMAS 4.0

enum { LINKS = 3, STATES = 2 * LINKS };

typedef struct mass_case {
    hard_problem problem;
    long steps;
    long double exact[STATES];
    double angle[2], rate[2]; /* bounds in float and in double */
    double energy;            /* that truncation takes, relative */
} mass_case;

static const real light_tip[] = {R(9.81), R(1.0), R(1.0), R(1e3), R(1e6)};
static const real heavy_tip[] = {R(9.81), R(1.0), R(1e6), R(1e3), R(1.0)};

static const mass_case cases[] = {
    {.problem = {"light_tip", STATES, {.derivative = NULL}, {1.0, 0.5, 0.8}, light_tip},
     .steps = 2500,
     .exact = {-0.978569202054988L, -0.799321896318418L, -0.000289000338197758L, -0.566546391969171L,
               -4.64936125993142L, -4.06888522738103L},
     .angle = {3e-5, 1e-11},
     .rate = {3e-5, 1e-11},
     .energy = 1.3e-14},
    {.problem = {"heavy_tip", STATES, {.derivative = NULL}, {0.5, 0.5, 0.5}, heavy_tip},
     .steps = 40000,
     .exact = {-0.104447306637695L, -0.104447666665176L, -0.104638798787056L, -0.87606065407L, -0.87663086211L,
               -0.87139878725L},
     .angle = {2e-5, 2e-9},
     .rate = {0.05, 1e-5}},
};

/* From angles of the joints and their rates to those of the rods. */
static void to_rods(real *const x, const real *const joints)
{
    for (size_t i = 0; i < STATES; i++) {
        x[i] = i % LINKS == 0 ? joints[i] : x[i - 1] + joints[i];
    }
}

/* What rounding does to the energy in a step, as the variance of a random number: every state is off by anything up to
 * half an ulp, the variance of which is ulp^2 / 12, and the energy by its derivative times that. */
static double variance(const mass_case *const c, const real *const x, const bool generated)
{
    static hard_run aside[2];
    const real d = R(0.0078125);
    double sum = 0.0;
    for (size_t s = 0; s < STATES; s++) {
        for (int i = 0; i < 2; i++) {
            real moved[STATES];
            memcpy(moved, x, sizeof moved);
            moved[s] += i == 0 ? d : -d;
            aside[i].problem = &c->problem;
            memcpy(aside[i].x, moved, sizeof moved);
            if (generated) {
                to_rods(aside[i].x, moved);
            }
        }
        const double derivative = (chain_energy(&aside[0]) - chain_energy(&aside[1])) / (2.0 * (double)d);
        const double ulp = ldexp((double)ISO_REAL_EPSILON, ilogb((double)x[s]));
        sum += derivative * derivative * ulp * ulp / 12.0;
    }
    return sum;
}

/* A run of a second, by the equations written by hand or by the plant; checks it. Returns how far the energy may be
 * off. */
static double test_second(const mass_case *const c, const bool generated)
{
    static hard_run run;
    const real *const x = generated ? iso_the_plant.x : run.x;
    const double h = 1.0 / (double)c->steps;
    double error[2] = {0.0, 0.0};
    double drift = 0.0;
    double rounding = 0.0;
    hard_begin(&run, &c->problem, ISO_RK4, h);
    const double start = chain_energy(&run);
    for (long i = 0; i < c->steps; i++) {
        rounding += variance(c, x, generated);
        if (generated) {
            iso_the_plant.model->step(iso_the_plant.memory);
            to_rods(run.x, iso_the_plant.x);
        } else {
            (void)hard_go(&run, 1);
        }
        drift = fmax(drift, fabs(chain_energy(&run) - start) / start);
    }
    for (size_t i = 0; i < STATES; i++) {
        error[i / LINKS] = fmax(error[i / LINKS], fabs((double)((long double)run.x[i] - c->exact[i])));
    }
    const int real_of = HARD_PICK(0, 1);
    const char *const from = generated ? "generated" : "by hand";
    const double most = c->energy + SIGMAS * sqrt(rounding) / start;
    report_ok(hard_guard(&run) == STATES && error[0] <= c->angle[real_of] && error[1] <= c->rate[real_of],
              "%s, %s, rk4, %ld steps: errors %.1e rad, %.1e rad/s", c->problem.name, from, c->steps, error[0],
              error[1]);
    report_ok(drift <= most, "%s, %s: energy to %.1e, at most %.1e", c->problem.name, from, drift, most);
    return most;
}

static void test_euler(const mass_case *const c, const double most)
{
    static hard_run run;
    hard_begin(&run, &c->problem, ISO_EULER, 1.0 / (double)c->steps);
    const double start = chain_energy(&run);
    (void)hard_go(&run, c->steps);
    const double drift = fabs(chain_energy(&run) - start) / start;
    report_ok(!(drift <= most), "control: %s: euler does not keep the energy: %.1e", c->problem.name, drift);
}

int main(void)
{
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        mass_case c = cases[i];
        c.problem.equations = chain_of_3;
        if (strcmp(iso_the_plant.model->name, c.problem.name) == 0) {
            iso_plant_start(&iso_the_plant);
            report_ok(iso_the_plant.model->step_size == (real)(1.0 / (double)c.steps), "%s: the scene has the step",
                      c.problem.name);
            (void)test_second(&c, false);
            test_euler(&c, test_second(&c, true));
            if (c.problem.p == heavy_tip) {
                hard_expect_failure(&c.problem, ISO_RK4, ldexp(1.0, -9), 1 << 9);
            }
        }
    }
    return report_done();
}
