/* A plant generated from a scene of 3-D bodies against the independent dynamics of the same mechanism, in the plant's
 * real. Linked with the plant and with one table. At each of STATES random states (angles over the whole circle, sliders
 * within 0.5 m, speeds to 10 rad/s or m/s, inputs to 10 N or N m) it compares accelerations and outputs and closes the
 * balances of energy and momentum with the plant's accelerations.
 */
#include <string.h>

#include "core/plant.h"
#include "tests/dynamics/random.h"
#include "tests/dynamics/tables.h"
#include "tests/host/report.h"

enum { STATES = 100, STATES_MAX = 2 * BODIES_MAX, INPUTS_MAX = 6, NUMBERS_MAX = 3 * OUTPUTS_MAX };

/* The plant rounds some hundred to a thousand times, by half of EPSILON each; what remains of it is at most 13 EPSILON in
 * the accelerations and 7 in the outputs, and the limits leave room for another order of operations: in double 2.8e-14,
 * where 1e-10 is asked for. The balances divide the error of the accelerations by flows of energy and momentum that are
 * small in some states: up to 700 EPSILON. */
#define EPSILON ((wide)ISO_REAL_EPSILON)
#define ACCELERATION_TOLERANCE (128.0L * EPSILON)
#define OUTPUT_TOLERANCE (64.0L * EPSILON)
#define BALANCE_TOLERANCE (4096.0L * EPSILON)

/* How far off the positive controls are. */
#ifdef ISO_REAL_DOUBLE
#define CONTROL_OFF 1e-6L
#else
#define CONTROL_OFF 1.0L
#endif

typedef struct sample {
    real x[STATES_MAX];
    real u[INPUTS_MAX];
    real dx[STATES_MAX];
    wide input[INPUTS_MAX];
    joint_motion motion; /* qdd is the plant's */
} sample;

static int freedoms;

/* State index of joint j; fixed joints have none. */
static int state_of(const mechanism *const m, const int j)
{
    int index = 0;
    for (int i = 0; i < j; i++) {
        index += m->joint[i].kind != FIXED;
    }
    return index;
}

static void draw(sequence *const random, sample *const s)
{
    const mechanism *const m = &the_table.mechanism;
    memset(s, 0, sizeof *s);
    for (int j = 0; j < m->bodies; j++) {
        if (m->joint[j].kind == FIXED) {
            continue;
        }
        const int i = state_of(m, j);
        s->x[i] = (real)sequence_next(random, m->joint[j].kind == REVOLUTE ? 3.14159265358979 : 0.5);
        s->x[freedoms + i] = (real)sequence_next(random, 10.0);
    }
    for (int i = 0; i < the_table.inputs; i++) {
        s->u[i] = (real)sequence_next(random, 10.0);
        s->input[i] = (wide)s->u[i];
    }
    iso_the_plant.derivative(s->dx, s->x, s->u, iso_the_plant.defaults);
    for (int j = 0; j < m->bodies; j++) {
        const int i = state_of(m, j);
        if (m->joint[j].kind != FIXED) {
            s->motion.q[j] = (wide)s->x[i];
            s->motion.qd[j] = (wide)s->x[freedoms + i];
            s->motion.qdd[j] = (wide)s->dx[freedoms + i];
        }
    }
}

static void draw_all(sample s[STATES])
{
    sequence random = {UINT64_C(0x9E3779B97F4A7C15)};
    for (int k = 0; k < STATES; k++) {
        draw(&random, &s[k]);
    }
}

typedef struct difference {
    wide norm;  /* worst over the states of |a - a*| / |a*|, 2-norms over all joints in rad/s^2 and m/s^2 */
    wide joint; /* worst over the states and joints of |a_j - a_j*| / rms of a_j* over the states */
} difference;

/* The plant's accelerations against the solver's on mechanism m. Infinite if a state is singular. */
static difference accelerations(const mechanism *const m, const sample s[STATES])
{
    wide square[BODIES_MAX] = {0};
    wide worst[BODIES_MAX] = {0};
    difference d = {0};
    for (int k = 0; k < STATES; k++) {
        solution exact;
        if (!mechanism_solve(m, &s[k].motion, s[k].input, &exact)) {
            return (difference){HUGE_VALL, HUGE_VALL};
        }
        wide error = 0.0L;
        wide size = 0.0L;
        for (int j = 0; j < m->bodies; j++) {
            const wide e = s[k].motion.qdd[j] - exact.qdd[j];
            error += e * e;
            size += exact.qdd[j] * exact.qdd[j];
            square[j] += exact.qdd[j] * exact.qdd[j];
            worst[j] = fmaxl(worst[j], fabsl(e));
        }
        d.norm = fmaxl(d.norm, sqrtl(error / size));
    }
    for (int j = 0; j < m->bodies; j++) {
        if (m->joint[j].kind != FIXED) {
            d.joint = fmaxl(d.joint, worst[j] / sqrtl(square[j] / STATES));
        }
    }
    return d;
}

static void test_accelerations(const sample s[STATES])
{
    bool speeds = true;
    for (int k = 0; k < STATES; k++) {
        speeds = speeds && memcmp(s[k].dx, s[k].x + freedoms, (size_t)freedoms * sizeof(real)) == 0;
    }
    report_ok(speeds, "the rates of the positions are the speeds, to the bit");
    const difference d = accelerations(&the_table.mechanism, s);
    report_ok(d.norm <= ACCELERATION_TOLERANCE, "accelerations, relative in the 2-norm: %.2Le <= %.1Le", d.norm,
              ACCELERATION_TOLERANCE);
    report_ok(d.joint <= ACCELERATION_TOLERANCE, "accelerations, each joint relative to its rms: %.2Le <= %.1Le",
              d.joint, ACCELERATION_TOLERANCE);
}

/* Positive control: a table off in one number must not agree. */
static void test_controls(const sample s[STATES])
{
    for (int i = 0; i < the_table.controls; i++) {
        mechanism off = the_table.mechanism;
        wide number;
        char *const at = (char *)&off + the_table.control[i].offset;
        memcpy(&number, at, sizeof number);
        number *= 1.0L + CONTROL_OFF;
        memcpy(at, &number, sizeof number);
        const difference d = accelerations(&off, s);
        report_ok(d.norm > ACCELERATION_TOLERANCE, "control: %s off by %.0Le is seen: %.2Le", the_table.control[i].name,
                  CONTROL_OFF, d.norm);
    }
}

/* The solver checks itself: its accelerations of the centres of mass are those of the motion it found. */
static void test_solver(const sample s[STATES])
{
    const mechanism *const m = &the_table.mechanism;
    wide worst = 0.0L;
    for (int k = 0; k < STATES; k++) {
        solution exact;
        joint_motion motion = s[k].motion;
        body_motion moved[BODIES_MAX];
        wide error = 0.0L;
        wide size = 0.0L;
        if (!mechanism_solve(m, &motion, s[k].input, &exact)) {
            worst = HUGE_VALL;
            break;
        }
        memcpy(motion.qdd, exact.qdd, sizeof motion.qdd);
        mechanism_move(m, &motion, moved);
        for (int i = 0; i < m->bodies; i++) {
            for (int c = 0; c < 3; c++) {
                error = fmaxl(error, fabsl(2.0L * moved[i].com.x[c].c[2] - exact.acceleration[i][c]));
                size = fmaxl(size, fabsl(exact.acceleration[i][c]));
            }
        }
        worst = fmaxl(worst, error / size);
    }
    report_ok(worst <= 1e-14L, "the independent solver keeps its constraints: %.2Le <= 1e-14", worst);
}

/* The relative size of a sum that should be zero. */
typedef struct balance {
    wide sum;
    wide size;
} balance;

static void balance_add(balance *const b, const wide term)
{
    b->sum += term;
    b->size += fabsl(term);
}

/* dE/dt = sum over joints of (input - damping speed) speed, E by the independent energy along the plant's motion.
 * Its size is that of the energies that flow: m v.a of every body. */
static wide energy_balance(const mechanism *const m, const sample *const s)
{
    body_motion moved[BODIES_MAX];
    mechanism_move(m, &s->motion, moved);
    balance b = {0};
    balance_add(&b, mechanism_energy(m, &s->motion, moved).c[1]);
    for (int j = 0; j < m->bodies; j++) {
        const tree_joint *const joint = &m->joint[j];
        const wide qd = s->motion.qd[j];
        balance_add(&b, joint->input == 0 ? 0.0L : -s->input[joint->input - 1] * qd);
        balance_add(&b, joint->damping * qd * qd);
    }
    for (int i = 0; i < m->bodies; i++) {
        b.size += m->body[i].mass * fabsl(jet_mul(moved[i].velocity.x[0], moved[i].velocity.x[0]).c[1]);
    }
    return fabsl(b.sum) / b.size;
}

/* Along the freedom of joint j, all that hangs on it: turning, dL/dt about the hinge = moment of the weight + joint
 * force; sliding, dp/dt = weight + joint force. No reaction enters. */
static wide momentum_balance(const mechanism *const m, const sample *const s, const int j)
{
    body_motion moved[BODIES_MAX];
    wide weight[3];
    wide moment[3];
    mechanism_move(m, &s->motion, moved);
    const momentum sum = mechanism_momentum(m, moved, j, weight, moment);
    const wide *const e = moved[j].axis;
    const wide *const p = moved[j].hinge;
    balance b = {0};
    balance_add(&b, -mechanism_force(m, j, &s->motion, s->input));
    for (int i = 0; i < 3; i++) {
        const int k = (i + 1) % 3;
        const int l = (i + 2) % 3;
        if (m->joint[j].kind == PRISMATIC) {
            balance_add(&b, e[i] * sum.linear.x[i].c[1]);
            balance_add(&b, -e[i] * weight[i]);
        } else {
            balance_add(&b, e[i] * (sum.angular.x[i].c[1]));
            balance_add(&b, -e[i] * (p[k] * sum.linear.x[l].c[1] - p[l] * sum.linear.x[k].c[1]));
            balance_add(&b, -e[i] * (moment[i] - (p[k] * weight[l] - p[l] * weight[k])));
        }
    }
    return fabsl(b.sum) / b.size;
}

/* The whole tree, all six components: dp/dt = weight + F, dL/dt about the origin = moment of the weight + hinge x F + N
 * with the ground's reaction F, N from the independent solver and the momentum from the plant's motion. */
static wide ground_balance(const mechanism *const m, const sample *const s)
{
    body_motion moved[BODIES_MAX];
    solution exact;
    wide weight[3];
    wide moment[3];
    if (!mechanism_solve(m, &s->motion, s->input, &exact)) {
        return HUGE_VALL;
    }
    mechanism_move(m, &s->motion, moved);
    const momentum sum = mechanism_momentum(m, moved, 0, weight, moment);
    const joint_reaction *const ground = &exact.reaction[0];
    const wide *const p = moved[0].hinge;
    balance force = {0};
    balance turn = {0};
    wide worst = 0.0L;
    for (int i = 0; i < 3; i++) {
        const int k = (i + 1) % 3;
        const int l = (i + 2) % 3;
        force.sum = sum.linear.x[i].c[1] - weight[i] - ground->force[i];
        turn.sum =
            sum.angular.x[i].c[1] - moment[i] - (p[k] * ground->force[l] - p[l] * ground->force[k]) - ground->moment[i];
        force.size += fabsl(sum.linear.x[i].c[1]) + fabsl(weight[i]);
        turn.size += fabsl(sum.angular.x[i].c[1]) + fabsl(moment[i]);
        worst = fmaxl(worst, fmaxl(fabsl(force.sum), fabsl(turn.sum)));
    }
    return worst / fminl(force.size, turn.size);
}

typedef struct balances {
    wide energy;
    wide freedom;
    wide ground;
} balances;

/* The worst of each balance over all states, with every acceleration of the plant times 1 + off. */
static balances worst_balances(const sample s[STATES], const wide off)
{
    const mechanism *const m = &the_table.mechanism;
    balances worst = {0};
    for (int k = 0; k < STATES; k++) {
        sample one = s[k];
        for (int j = 0; j < m->bodies; j++) {
            one.motion.qdd[j] *= 1.0L + off;
        }
        worst.energy = fmaxl(worst.energy, energy_balance(m, &one));
        worst.ground = fmaxl(worst.ground, ground_balance(m, &one));
        for (int j = 0; j < m->bodies; j++) {
            if (m->joint[j].kind != FIXED) {
                worst.freedom = fmaxl(worst.freedom, momentum_balance(m, &one, j));
            }
        }
    }
    return worst;
}

static void test_balances(const sample s[STATES])
{
    const balances b = worst_balances(s, 0.0L);
    report_ok(b.energy <= BALANCE_TOLERANCE, "energy rate = input power - damping power: %.2Le <= %.1Le", b.energy,
              BALANCE_TOLERANCE);
    report_ok(b.freedom <= BALANCE_TOLERANCE, "momentum along each joint's freedom: %.2Le <= %.1Le", b.freedom,
              BALANCE_TOLERANCE);
    report_ok(b.ground <= BALANCE_TOLERANCE, "momentum of the tree and the ground's reaction: %.2Le <= %.1Le", b.ground,
              BALANCE_TOLERANCE);
    const balances off = worst_balances(s, CONTROL_OFF);
    report_ok(off.energy > BALANCE_TOLERANCE && off.freedom > BALANCE_TOLERANCE && off.ground > BALANCE_TOLERANCE,
              "control: accelerations off by %.0Le break the balances: %.2Le %.2Le %.2Le", CONTROL_OFF, off.energy,
              off.freedom, off.ground);
}

/* The kind of number n of the outputs. */
static output_kind kind_of(const mechanism *const m, const int n)
{
    int first = 0;
    int i = 0;
    while (first + (m->output[i].kind == POINT || m->output[i].kind == POINT_VELOCITY ? 3 : 1) <= n) {
        first += m->output[i].kind == POINT || m->output[i].kind == POINT_VELOCITY ? 3 : 1;
        i++;
    }
    return m->output[i].kind;
}

/* Each output relative to its rms over the states; one that is always zero, as it is. A count of turns is left to the tests of stepping. */
static void test_outputs(const sample s[STATES])
{
    const mechanism *const m = &the_table.mechanism;
    wide square[NUMBERS_MAX] = {0};
    wide worst[NUMBERS_MAX] = {0};
    int count = 0;
    for (int k = 0; k < STATES; k++) {
        real got[NUMBERS_MAX] = {0};
        wide want[NUMBERS_MAX];
        joint_motion motion = s[k].motion;
        solution exact;
        if (mechanism_solve(m, &motion, s[k].input, &exact)) {
            memcpy(motion.qdd, exact.qdd, sizeof motion.qdd);
        }
        count = mechanism_outputs(m, &motion, want);
        iso_the_plant.output(got, s[k].x, s[k].u, iso_the_plant.defaults);
        for (int n = 0; n < count; n++) {
            square[n] += want[n] * want[n];
            worst[n] = fmaxl(worst[n], fabsl((wide)got[n] - want[n]));
        }
    }
    report_ok(count == iso_the_plant.outputs, "the plant has the table's %d outputs", count);
    for (int n = 0; n < count; n++) {
        if (kind_of(m, n) != TURNS) {
            const wide size = sqrtl(square[n] / STATES);
            const wide relative = size > 0.0L ? worst[n] / size : worst[n];
            const wide limit = kind_of(m, n) == ACCELERATION ? ACCELERATION_TOLERANCE : OUTPUT_TOLERANCE;
            report_ok(relative <= limit, "output %d relative to its rms: %.2Le <= %.1Le", n, relative, limit);
        }
    }
}

int main(void)
{
    static sample s[STATES];
    freedoms = mechanism_freedoms(&the_table.mechanism);
    if (!report_ok(iso_the_plant.states == 2 * freedoms && iso_the_plant.inputs == the_table.inputs,
                   "the plant has the table's states and inputs") ||
        iso_the_plant.outputs > NUMBERS_MAX) {
        return report_done();
    }
    draw_all(s);
    test_accelerations(s);
    test_controls(s);
    test_solver(s);
    test_balances(s);
    test_outputs(s);
    return report_done();
}
