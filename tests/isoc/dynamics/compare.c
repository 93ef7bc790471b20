/* A plant generated from a scene of 3-D bodies against the independent dynamics of the same mechanism, in the plant's
 * real. Linked with the plant and with one table. At each of STATES random states it compares accelerations and outputs
 * and closes the balances of energy and momentum with the plant's accelerations.
 */
#include <string.h>

#include "tests/host/report.h"
#include "tests/isoc/dynamics/balance.h"
#include "tests/isoc/dynamics/sample.h"

/* The plant rounds some hundred to a thousand times, by half of EPSILON each; what remains of it is at most 13 EPSILON
 * in the accelerations and 7 in the outputs, and the limits leave room for another order of operations: in
 * double 2.8e-14, where 1e-10 is asked for. Closed loops multiply rounding by the condition of the state, which is
 * divided out. The balances divide the error of the accelerations by flows of energy and momentum that are small in
 * some states: up to 700 EPSILON. */
#define RATE_TOLERANCE (4.0L * EPSILON)
#define ACCELERATION_TOLERANCE (128.0L * EPSILON)
#define OUTPUT_TOLERANCE (64.0L * EPSILON)
#define BALANCE_TOLERANCE (4096.0L * EPSILON)

/* States on which the controls are tried. */
enum { CONTROL_STATES = 20 };

typedef struct difference {
    wide norm;  /* worst over the states of |a - a*| / |a*|, 2-norms over all joints in rad/s^2 and m/s^2 */
    wide joint; /* worst over the states and speeds of |a_k - a_k*| / rms of a_k* over the states, or its condition */
} difference;

/* The plant's accelerations at a state against others, relative to the state's condition. */
static wide relative(const sample *const s, const solution *const exact)
{
    const mechanism *const m = &the_table.mechanism;
    wide error = 0.0L;
    wide size = 0.0L;
    for (int j = 0; j < m->bodies; j++) {
        for (int k = 0; k < joint_speeds(m->joint[j].kind); k++) {
            const wide e = s->motion.a[j][k] - exact->a[j][k];
            error += e * e;
            size += exact->a[j][k] * exact->a[j][k];
        }
    }
    return sqrtl(error / size) / s->condition;
}

static difference accelerations(const sample s[STATES])
{
    const mechanism *const m = &the_table.mechanism;
    difference d = {0};
    for (int n = 0; n < STATES; n++) {
        d.norm = fmaxl(d.norm, relative(&s[n], &s[n].exact));
    }
    for (int j = 0; j < m->bodies; j++) {
        for (int k = 0; k < joint_speeds(m->joint[j].kind); k++) {
            wide square = 0.0L;
            for (int n = 0; n < STATES; n++) {
                square += s[n].exact.a[j][k] * s[n].exact.a[j][k];
            }
            const wide rms = sqrtl(square / STATES);
            for (int n = 0; n < STATES; n++) {
                const wide error = fabsl(s[n].motion.a[j][k] - s[n].exact.a[j][k]);
                const wide size = fmaxl(rms, s[n].change[j][k]);
                d.joint = fmaxl(d.joint, size > 0.0L ? error / size : error);
            }
        }
    }
    return d;
}

static void test_accelerations(const sample s[STATES])
{
    wide rates = 0.0L;
    wide condition = 0.0L;
    for (int n = 0; n < STATES; n++) {
        rates = fmaxl(rates, sample_position_rates(&s[n]));
        condition = fmaxl(condition, s[n].condition);
    }
    report_ok(rates <= RATE_TOLERANCE,
              "the rates of the positions are the speeds, to the bit but for quaternions: %.2Le <= %.1Le", rates,
              RATE_TOLERANCE);
    const difference d = accelerations(s);
    report_ok(d.norm <= ACCELERATION_TOLERANCE, "accelerations, relative in the 2-norm: %.2Le <= %.1Le", d.norm,
              ACCELERATION_TOLERANCE);
    report_ok(d.joint <= ACCELERATION_TOLERANCE, "accelerations, each joint relative to its rms: %.2Le <= %.1Le",
              d.joint, ACCELERATION_TOLERANCE);
    report_note("largest condition of a state %.1Le", condition);
}

/* Positive control: a table off in one number must not agree. */
static void test_controls(const sample s[STATES])
{
    for (int i = 0; i < the_table.controls; i++) {
        static mechanism off;
        solution exact;
        wide number;
        wide worst = 0.0L;
        off = the_table.mechanism;
        char *const at = (char *)&off + the_table.control[i].offset;
        memcpy(&number, at, sizeof number);
        number *= 1.0L + CONTROL_OFF;
        memcpy(at, &number, sizeof number);
        for (int n = 0; n < CONTROL_STATES; n++) {
            worst = fmaxl(worst, mechanism_solve(&off, &s[n].motion, s[n].input, &exact) ? relative(&s[n], &exact)
                                                                                         : HUGE_VALL);
        }
        report_ok(worst > ACCELERATION_TOLERANCE, "control: %s off by %.0Le is seen: %.2Le", the_table.control[i].name,
                  CONTROL_OFF, worst);
    }
}

/* The solver checks itself: its accelerations of the centres of mass are those of the motion it found. */
static void test_solver(const sample s[STATES])
{
    const mechanism *const m = &the_table.mechanism;
    wide worst = 0.0L;
    for (int n = 0; n < STATES; n++) {
        joint_motion motion = s[n].motion;
        body_motion moved[BODIES_MAX];
        wide error = 0.0L;
        wide size = 0.0L;
        memcpy(motion.a, s[n].exact.a, sizeof motion.a);
        mechanism_move(m, &motion, moved);
        for (int i = 0; i < m->bodies; i++) {
            for (int c = 0; c < 3; c++) {
                error = fmaxl(error, fabsl(2.0L * moved[i].com.x[c].c[2] - s[n].exact.acceleration[i][c]));
                size = fmaxl(size, fabsl(s[n].exact.acceleration[i][c]));
            }
        }
        worst = fmaxl(worst, error / size / s[n].condition);
    }
    report_ok(worst <= 1e-14L, "the independent solver keeps its constraints: %.2Le <= 1e-14", worst);
}

static void test_balances(const sample s[STATES])
{
    const balances b = balances_of(s, 0.0L);
    report_ok(b.energy <= BALANCE_TOLERANCE, "energy rate = input power - damping power: %.2Le <= %.1Le", b.energy,
              BALANCE_TOLERANCE);
    report_ok(b.dof <= BALANCE_TOLERANCE, "momentum along each joint's degree of freedom: %.2Le <= %.1Le", b.dof,
              BALANCE_TOLERANCE);
    report_ok(b.ground <= BALANCE_TOLERANCE, "momentum of the tree and the ground's reaction: %.2Le <= %.1Le", b.ground,
              BALANCE_TOLERANCE);
    const balances off = balances_of(s, CONTROL_OFF);
    report_ok(off.energy > BALANCE_TOLERANCE && off.dof > BALANCE_TOLERANCE && off.ground > BALANCE_TOLERANCE,
              "control: accelerations off by %.0Le break the balances: %.2Le %.2Le %.2Le", CONTROL_OFF, off.energy,
              off.dof, off.ground);
}

/* A quaternion and its negative are one orientation. */
static void align(const wide *const want, wide *const got)
{
    wide along = 0.0L;
    for (int i = 0; i < 4; i++) {
        along += want[i] * got[i];
    }
    for (int i = 0; i < 4 && along < 0.0L; i++) {
        got[i] = -got[i];
    }
}

/* Output o, whose first number is `first`: each of its numbers, relative to the rms of all of them over the states; one
 * that is always zero, as it is. Accelerations and reactions are as well known as the state's condition says. A count
 * of turns is left to the tests of stepping. */
static void test_output(const sample s[STATES], const int o, const int first)
{
    const mechanism *const m = &the_table.mechanism;
    const output_kind kind = m->output[o].kind;
    const int count = output_numbers(kind);
    const bool solved = kind == ACCELERATION || kind == FORCE || kind == MOMENT;
    const wide limit = solved ? ACCELERATION_TOLERANCE : OUTPUT_TOLERANCE;
    wide square = 0.0L;
    wide worst = 0.0L;
    for (int n = 0; n < STATES && kind != TURNS; n++) {
        real y[NUMBERS_MAX] = {R(0.0)};
        wide want[NUMBERS_MAX];
        wide got[NUMBERS_MAX];
        joint_motion motion = s[n].motion;
        memcpy(motion.a, s[n].exact.a, sizeof motion.a);
        (void)mechanism_outputs(m, &motion, &s[n].exact, want);
        sample_outputs(&s[n], y);
        for (int i = 0; i < count; i++) {
            got[i] = (wide)y[first + i];
        }
        if (kind == ORIENTATION) {
            align(want + first, got);
        }
        for (int i = 0; i < count; i++) {
            square += want[first + i] * want[first + i] / count;
            worst = fmaxl(worst, fabsl(got[i] - want[first + i]) / (solved ? s[n].condition : 1.0L));
        }
    }
    if (kind != TURNS) {
        const wide size = sqrtl(square / STATES);
        const wide part = size > 0.0L ? worst / size : worst;
        report_ok(part <= limit, "output %d relative to its rms: %.2Le <= %.1Le", o, part, limit);
    }
}

int main(void)
{
    static sample s[STATES];
    const mechanism *const m = &the_table.mechanism;
    int numbers = 0;
    for (int o = 0; o < m->outputs; o++) {
        numbers += output_numbers(m->output[o].kind);
    }
    if (!report_ok(iso_the_plant.model->states == mechanism_coordinates(m) + mechanism_dofs(m) &&
                       iso_the_plant.model->inputs == the_table.inputs && iso_the_plant.model->outputs == numbers,
                   "the plant has the table's states, inputs and outputs") ||
        !report_ok(sample_all(s), "%d states are found", STATES)) {
        return report_done();
    }
    test_accelerations(s);
    test_controls(s);
    test_solver(s);
    test_balances(s);
    int first = 0;
    for (int o = 0; o < m->outputs; o++) {
        test_output(s, o, first);
        first += output_numbers(m->output[o].kind);
    }
    return report_done();
}
