/* Reactions of all joints and closures of a generated plant, in the plant's real: against those of the independent
 * dynamics, and in balance with the momentum of what hangs on each joint as the plant moves it. Linked with one table
 * and with a plant whose last outputs are force and moment of each joint of the table, and then of each closure.
 */

#include "tests/host/report.h"
#include "tests/isoc/dynamics/balance.h"
#include "tests/isoc/dynamics/wide3.h"

enum { REACTIONS_MAX = BODIES_MAX + CLOSURES_MAX, OUTPUTS_ROOM = NUMBERS_MAX + 6 * REACTIONS_MAX };

/* A reaction is what its child takes to move, less what else acts on it: some hundred roundings, of which at most 43
 * EPSILON remain in a tree. With closures at most 105: multipliers are not as well known as the accelerations whose
 * condition is divided out. */
#define REACTION_TOLERANCE (256.0L * EPSILON)
#define BALANCE_TOLERANCE (4096.0L * EPSILON)

static int reaction_count(void)
{
    return the_table.mechanism.bodies + the_table.mechanism.closures;
}

/* Reaction n of the table: of a joint, or of a closure. */
static reaction *reaction_of(solution *const of, const int n)
{
    const int bodies = the_table.mechanism.bodies;
    return n < bodies ? &of->joint[n] : &of->closure[n - bodies];
}

/* The sample with the plant's reactions, times 1 + off, in the place of the exact ones. */
static sample with_reactions(const sample *const s, const wide off)
{
    real y[OUTPUTS_ROOM];
    sample made = *s;
    sample_outputs(s, y);
    const real *at = y + iso_the_plant.model->outputs - 6 * reaction_count();
    for (int n = 0; n < reaction_count(); n++) {
        reaction *const r = reaction_of(&made.exact, n);
        for (int i = 0; i < 3; i++) {
            r->force[i] = (1.0L + off) * (wide)*at++;
        }
        for (int i = 0; i < 3; i++) {
            r->moment[i] = (1.0L + off) * (wide)*at++;
        }
    }
    return made;
}

static wide norm(const wide a[3])
{
    return sqrtl(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

/* The farthest that a body's centre of mass is from its joint. */
static wide farthest(const sample *const s)
{
    body_motion moved[BODIES_MAX];
    wide most = 0.0L;
    mechanism_move(&the_table.mechanism, &s->motion, moved);
    for (int i = 0; i < the_table.mechanism.bodies; i++) {
        wide arm[3];
        part(moved[i].com, 0, arm);
        accumulate(arm, -1.0L, moved[i].hinge);
        most = fmaxl(most, norm(arm));
    }
    return most;
}

/* The force of reaction n; of a joint, at least what its child takes to move and of its weight, which the force may
 * balance to zero, as that of a free joint does. */
static wide force_size(const sample *const s, const int n)
{
    const mechanism *const m = &the_table.mechanism;
    solution exact = s->exact;
    wide taken[3] = {0.0L, 0.0L, 0.0L};
    if (n < m->bodies) {
        accumulate(taken, m->body[n].mass, exact.acceleration[n]);
        accumulate(taken, -m->body[n].mass, m->gravity);
    }
    return fmaxl(norm(reaction_of(&exact, n)->force), norm(taken));
}

/* The worst of all states, relative to the rms of this vector over the states and to the state's condition. What is
 * small or zero of a moment is the difference of moments that forces have about points of the mechanism: as large as
 * the reaction's force at its longest lever, which counts with it. */
static wide worst_difference(sample s[STATES], const int n, const bool of_moment, const wide off)
{
    wide square = 0.0L;
    wide worst = 0.0L;
    for (int k = 0; k < STATES; k++) {
        sample got = with_reactions(&s[k], off);
        const reaction *const r = reaction_of(&s[k].exact, n);
        const reaction *const g = reaction_of(&got.exact, n);
        const wide *const want = of_moment ? r->moment : r->force;
        const wide *const have = of_moment ? g->moment : g->force;
        const wide error[3] = {have[0] - want[0], have[1] - want[1], have[2] - want[2]};
        const wide size = force_size(&s[k], n) * (of_moment ? farthest(&s[k]) : 1.0L);
        square += fmaxl(norm(want), size) * fmaxl(norm(want), size);
        worst = fmaxl(worst, norm(error) / s[k].condition);
    }
    return worst / sqrtl(square / STATES);
}

static wide worst_balance(const sample s[STATES], const wide off)
{
    wide worst = 0.0L;
    for (int k = 0; k < STATES; k++) {
        const sample got = with_reactions(&s[k], off);
        worst = fmaxl(worst, balance_of_reactions(&got));
    }
    return worst;
}

int main(void)
{
    static sample s[STATES];
    if (!report_ok(iso_the_plant.model->outputs >= 6 * reaction_count() &&
                       iso_the_plant.model->outputs <= OUTPUTS_ROOM && sample_all(s),
                   "the plant shows %d reactions; %d states are found", reaction_count(), STATES)) {
        return report_done();
    }
    wide off = 0.0L;
    for (int n = 0; n < reaction_count(); n++) {
        const wide force = worst_difference(s, n, false, 0.0L);
        const wide moment = worst_difference(s, n, true, 0.0L);
        report_ok(force <= REACTION_TOLERANCE && moment <= REACTION_TOLERANCE,
                  "reaction %d, relative to the rms of its force and of its moment: %.2Le and %.2Le <= %.1Le", n, force,
                  moment, REACTION_TOLERANCE);
        off = fmaxl(off, worst_difference(s, n, false, CONTROL_OFF));
    }
    const wide balance = worst_balance(s, 0.0L);
    report_ok(balance <= BALANCE_TOLERANCE, "momentum of what hangs on each joint: %.2Le <= %.1Le", balance,
              BALANCE_TOLERANCE);
    const wide off_balance = worst_balance(s, CONTROL_OFF);
    report_ok(off > REACTION_TOLERANCE && off_balance > BALANCE_TOLERANCE,
              "control: reactions off by %.0Le are seen: %.2Le %.2Le", CONTROL_OFF, off, off_balance);
    return report_done();
}
