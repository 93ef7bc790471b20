/* Newton's method on the coordinates of the tree, until the closures hold; damped by as much as they do not, which
 * keeps its order where equations follow from others (Yamashita and Fukushima 2001, Computing Supplement 15). */
#include <string.h>

#include "tests/isoc/dynamics/hold.h"
#include "tests/isoc/dynamics/linear.h"
#include "tests/isoc/dynamics/mechanism.h"
#include "tests/isoc/dynamics/wide3.h"

enum { ROWS_MAX = HELD_MAX * CLOSURES_MAX + COUPLINGS_MAX, DOFS_MAX = SPEEDS_MAX * BODIES_MAX, ITERATIONS = 25 };

/* m or rad: some 2^-64 of the size of mechanisms. */
#define CLOSED 1e-17L

/* What is left of zero in J J' where closures hold to CLOSED but in the square of how far the coordinates are off. */
#define LEAST_PIVOT 1e-13L

typedef struct linear_closures {
    int rows, columns;
    wide value[ROWS_MAX];
    wide rate[ROWS_MAX];
    wide jacobian[ROWS_MAX][DOFS_MAX]; /* in the speeds of the joints */
} linear_closures;

/* The rates of some rows of a body for a unit of speed k of joint j, which carries it. */
static wide swept(const body_motion moved[BODIES_MAX], const int body, const int j, const int k, const wide factor[6])
{
    wide com[3];
    wide arm[3];
    wide velocity[3];
    part(moved[body].com, 0, com);
    difference(com, moved[j].hinge, arm);
    cross(moved[j].turn[k], arm, velocity);
    accumulate(velocity, 1.0L, moved[j].slide[k]);
    return dot(factor, velocity) + dot(factor + 3, moved[j].turn[k]);
}

/* The number of speeds before those of joint j. */
static int first_speed(const mechanism *const m, const int j)
{
    int before = 0;
    for (int i = 0; i < j; i++) {
        before += joint_speeds(m->joint[i].kind);
    }
    return before;
}

static void add_coupling(const mechanism *const m, const coupling *const c, const joint_motion *const motion,
                         linear_closures *const out)
{
    const int row = out->rows++;
    const wide phase = c->omega * m->time + c->phase;
    out->value[row] = motion->q[c->first][0] - c->offset - c->swing * sinl(phase);
    out->rate[row] = motion->v[c->first][0] - c->swing * c->omega * cosl(phase);
    out->jacobian[row][first_speed(m, c->first)] = 1.0L;
    if (c->second != GROUND) {
        out->value[row] -= c->ratio * motion->q[c->second][0];
        out->rate[row] -= c->ratio * motion->v[c->second][0];
        out->jacobian[row][first_speed(m, c->second)] = -c->ratio;
    }
}

static void linearise(const mechanism *const m, const joint_motion *const motion, linear_closures *const out)
{
    body_motion moved[BODIES_MAX];
    mechanism_move(m, motion, moved);
    memset(out, 0, sizeof *out);
    out->columns = mechanism_dofs(m);
    for (int n = 0; n < m->closures; n++) {
        const hold h = hold_of_closure(m, n);
        const held made = hold_linearise(&h, moved);
        for (int r = 0; r < made.rows; r++) {
            int column = 0;
            out->value[out->rows] = made.value[r];
            out->rate[out->rows] = made.rate[r];
            for (int j = 0; j < m->bodies; j++) {
                for (int k = 0; k < joint_speeds(m->joint[j].kind); k++) {
                    out->jacobian[out->rows][column++] =
                        (mechanism_carries(m, j, h.parent) ? swept(moved, h.parent, j, k, made.of_parent[r]) : 0.0L) +
                        (mechanism_carries(m, j, h.child) ? swept(moved, h.child, j, k, made.of_child[r]) : 0.0L);
                }
            }
            out->rows++;
        }
    }
    for (int n = 0; n < m->couplings; n++) {
        add_coupling(m, &m->coupling[n], motion, out);
    }
}

static wide row_product(const linear_closures *const l, const int a, const int b)
{
    wide sum = 0.0L;
    for (int k = 0; k < l->columns; k++) {
        sum += l->jacobian[a][k] * l->jacobian[b][k];
    }
    return sum;
}

/* The least d with J d = right: J' (J J' + mu)^-1 right, with mu = off |J|: damped by how far off the closures are. */
static void least_change(const linear_closures *const l, const wide *const right, const wide off, wide d[DOFS_MAX])
{
    static linear_system s;
    wide y[UNKNOWNS_MAX];
    wide size = 0.0L;
    memset(&s, 0, sizeof s);
    s.n = l->rows;
    for (int r = 0; r < l->rows; r++) {
        for (int c = 0; c < l->rows; c++) {
            s.a[r][c] = row_product(l, r, c);
        }
        s.a[r][s.n] = right[r];
        size = fmaxl(size, s.a[r][r]);
    }
    for (int r = 0; r < l->rows; r++) {
        s.a[r][r] += off * sqrtl(size);
    }
    (void)linear_solve(&s, LEAST_PIVOT, y);
    for (int k = 0; k < l->columns; k++) {
        d[k] = 0.0L;
        for (int r = 0; r < l->rows; r++) {
            d[k] += l->jacobian[r][k] * y[r];
        }
    }
}

/* q times the turn by the small vector d: q (1, d / 2), made of unit length. */
static void turn_quaternion(wide q[4], const wide d[3])
{
    wide turned[3];
    wide p[4];
    cross(q + 1, d, turned);
    p[0] = q[0] - dot(q + 1, d) / 2.0L;
    for (int i = 0; i < 3; i++) {
        p[1 + i] = q[1 + i] + (q[0] * d[i] + turned[i]) / 2.0L;
    }
    const wide length = sqrtl(p[0] * p[0] + dot(p + 1, p + 1));
    for (int i = 0; i < 4; i++) {
        q[i] = p[i] / length;
    }
}

static void displace(const mechanism *const m, joint_motion *const motion, const wide *d)
{
    for (int j = 0; j < m->bodies; j++) {
        const joint_kind kind = m->joint[j].kind;
        const int plain = kind == SPHERICAL ? 0 : kind == FREE ? 3 : joint_speeds(kind);
        for (int k = 0; k < plain; k++) {
            motion->q[j][k] += d[k];
        }
        if (kind == SPHERICAL || kind == FREE) {
            turn_quaternion(motion->q[j] + plain, d + plain);
        }
        d += joint_speeds(kind);
    }
}

bool mechanism_close(const mechanism *const m, joint_motion *const motion)
{
    static linear_closures l;
    wide d[DOFS_MAX];
    bool closed = false;
    for (int n = 0; n < ITERATIONS && !closed; n++) {
        wide worst = 0.0L;
        linearise(m, motion, &l);
        for (int r = 0; r < l.rows; r++) {
            worst = fmaxl(worst, fabsl(l.value[r]));
            l.value[r] = -l.value[r];
        }
        closed = worst <= CLOSED;
        if (!closed) {
            least_change(&l, l.value, worst, d);
            displace(m, motion, d);
        }
    }
    const wide *at = d;
    least_change(&l, l.rate, 0.0L, d);
    for (int j = 0; j < m->bodies; j++) {
        for (int k = 0; k < joint_speeds(m->joint[j].kind); k++) {
            motion->v[j][k] -= *at++;
        }
    }
    return closed;
}

wide mechanism_independence(const mechanism *const m, const joint_motion *const motion)
{
    static linear_closures l;
    wide least = 1.0L;
    linearise(m, motion, &l);
    /* Gram and Schmidt, the longest row that is left first. */
    for (int r = 0; r < l.rows; r++) {
        const wide length = sqrtl(row_product(&l, r, r));
        for (int k = 0; k < l.columns; k++) {
            l.jacobian[r][k] /= length;
        }
    }
    for (int done = 0; done < l.rows; done++) {
        int longest = done;
        for (int r = done + 1; r < l.rows; r++) {
            longest = row_product(&l, r, r) > row_product(&l, longest, longest) ? r : longest;
        }
        const wide length = sqrtl(row_product(&l, longest, longest));
        least = fminl(least, length);
        for (int k = 0; k < l.columns; k++) {
            const wide kept = l.jacobian[done][k];
            l.jacobian[done][k] = l.jacobian[longest][k] / length;
            l.jacobian[longest][k] = longest == done ? l.jacobian[done][k] : kept;
        }
        for (int r = done + 1; r < l.rows; r++) {
            const wide along = row_product(&l, r, done);
            for (int k = 0; k < l.columns; k++) {
                l.jacobian[r][k] -= along * l.jacobian[done][k];
            }
        }
    }
    return least;
}
