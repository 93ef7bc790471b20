/* The accelerations of imported plants against those of robots.h, and with MUJOCO against those of libmujoco, which
 * reads the files of the robots. With an argument: how many robots must be found wrong, of what was planted. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/runtime/plant.h"

typedef enum joint_kind { HINGE, SLIDE, BALL, FREE } joint_kind;

typedef struct robot_joint {
    const char *name;
    joint_kind kind;
    double zero;               /* the file's coordinate where that of the plant is zero */
    double stiffness, damping; /* where libmujoco made them of inertias, else 0 */
} robot_joint;

typedef struct robot_drive {
    const char *name;
    int is_control; /* of an actuator of the file; else an effort on the joint */
    const char *joint;
    int input; /* of the plant, where another one comes back from MJCF, -1: none; in that, and else, drives are inputs
                */
} robot_drive;

typedef struct robot_body {
    const char *name; /* NULL: the end */
    double mass, centre[3], inertia[3][3];
    double lift;    /* the share of its weight that a force at its centre carries */
    int is_of_mesh; /* whose corners libmujoco has as floats */
} robot_body;

/* Limits of all actuators of a joint together. */
typedef struct robot_limit {
    const char *joint; /* NULL: the end */
    double least, most;
    int counts_lifts;
} robot_limit;

/* The damping of a servo, over that which is critical where the robot is drawn. */
typedef struct robot_ratio {
    const char *drive; /* NULL: the end */
    double ratio;
} robot_ratio;

typedef struct robot_state {
    const double *q, *v, *u; /* as MuJoCo has them, joint after joint; u: of the drives; NULL: made here */
    const double *a;         /* what is right; NULL: what the plant has that comes back from MJCF */
} robot_state;

enum { STATES = 4, MOST = 256 };

typedef struct robot_plant {
    const iso_model *model;
    iso_derivative *const *derivative;
} robot_plant;

typedef struct robot {
    const char *path;
    robot_plant plant;
    const robot_joint *joints;
    int joint_count;
    const robot_body *bodies;
    const robot_drive *drives;
    int drive_count, against_mujoco, closures;
    robot_state states[STATES];
    robot_plant again; /* of the scene that comes back from MJCF */
    const robot_limit *limits;
    const robot_ratio *ratios;
    int is_odd; /* libmujoco refuses its inertias, and gets them behind its back */
} robot;

#include "robots.h"

static const double tolerance =
    1e-9; /* of the largest acceleration: what two ways to compute in double may differ by */

static const int positions[] = {1, 1, 4, 7}, speeds[] = {1, 1, 3, 6};

/* The place of a name in a list with commas; ends the program where there is none. */
static int place_of(const char *list, const char *name)
{
    const size_t length = strlen(name);
    int place = 0;
    for (const char *at = list; at != NULL; at = strchr(at, ','), at += at != NULL, place++) {
        if (strncmp(at, name, length) == 0 && (at[length] == ',' || at[length] == '\0')) {
            return place;
        }
    }
    printf("# no state '%s' in %s\n", name, list);
    exit(1);
}

static int state_of(const robot *r, const iso_model *m, int j, const char *ending)
{
    char name[128];
    snprintf(name, sizeof name, "%s%s", r->joints[j].name, ending);
    return place_of(m->state_names, name);
}

static const char *first_position(joint_kind kind)
{
    return kind == FREE ? "_x" : kind == BALL ? "_w" : "";
}

static const char *first_speed(joint_kind kind)
{
    return kind == FREE ? "_x_speed" : kind == BALL ? "_x_speed" : "_speed";
}

/* a b, or with `back` a's inverse times b */
static void turn_after(const double a[4], const double b[4], int back, double *result)
{
    const double x = back ? -a[1] : a[1], y = back ? -a[2] : a[2], z = back ? -a[3] : a[3];
    result[0] = a[0] * b[0] - x * b[1] - y * b[2] - z * b[3];
    result[1] = a[0] * b[1] + x * b[0] + y * b[3] - z * b[2];
    result[2] = a[0] * b[2] - x * b[3] + y * b[0] + z * b[1];
    result[3] = a[0] * b[3] + x * b[2] - y * b[1] + z * b[0];
}

/* The accelerations of the plant in one state. That of a scene has coordinates of its own, where MJCF has `ref`, and
 * for the turn of a ball from its start. */
static void of_plant(const robot *r, const robot_plant *p, const robot_state *s, double *a)
{
    const iso_model *m = p->model;
    double x[MOST] = {0}, dx[MOST] = {0}, u[MOST] = {0};
    const double *q = s->q, *v = s->v;
    const int is_source = p == &r->plant && r->again.model != NULL;
    for (int j = 0; j < r->joint_count; j++) {
        const joint_kind kind = r->joints[j].kind;
        const int at = state_of(r, m, j, first_position(kind)), speed = state_of(r, m, j, first_speed(kind));
        if (is_source && kind == BALL) {
            turn_after(m->start + at, q, 0, x + at);
        } else {
            memcpy(x + at, q, (size_t)positions[kind] * sizeof *q);
            x[at] -= is_source ? 0.0 : r->joints[j].zero;
        }
        q += positions[kind];
        memcpy(x + speed, v, (size_t)speeds[kind] * sizeof *v);
        v += speeds[kind];
    }
    for (int k = 0; k < r->drive_count; k++) {
        const int input = is_source ? r->drives[k].input : k;
        if (input >= 0) {
            u[input] = s->u[k];
        }
    }
    (*p->derivative)(dx, x, u, m->defaults);
    for (int j = 0; j < r->joint_count; j++) {
        const joint_kind kind = r->joints[j].kind;
        memcpy(a, dx + state_of(r, m, j, first_speed(kind)), (size_t)speeds[kind] * sizeof *a);
        a += speeds[kind];
    }
}

/* From -1 to 1, by Knuth's generator. */
static double next_number(void)
{
    static unsigned long long seed = 1;
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(seed >> 11) / 4503599627370496.0 - 1.0;
}

/* A run of rk4 with steady inputs from the start, which where no closure holds is another one; it keeps what closures
 * hold to 1e-12. */
static void run_plant(const robot *r, const double *u, int steps, double *x)
{
    static const double h = 1e-3, parts[4] = {0.0, 0.5, 0.5, 1.0}, weights[4] = {1.0, 2.0, 2.0, 1.0};
    const iso_model *m = r->plant.model;
    memcpy(x, m->start, m->states * sizeof *x);
    for (int j = 0; j < r->joint_count && r->closures == 0; j++) {
        const joint_kind kind = r->joints[j].kind;
        const int at = state_of(r, m, j, first_position(kind)), speed = state_of(r, m, j, first_speed(kind));
        for (int k = 0; k < speeds[kind]; k++) {
            x[speed + k] = 2.0 * next_number();
        }
        x[at] += kind == BALL ? 0.0 : next_number();
    }
    for (int step = 0; step < steps; step++) {
        double slope[MOST] = {0}, place[MOST], sum[MOST] = {0};
        for (int stage = 0; stage < 4; stage++) {
            for (size_t i = 0; i < m->states; i++) {
                place[i] = x[i] + h * parts[stage] * slope[i];
            }
            (*r->plant.derivative)(slope, place, u, m->defaults);
            for (size_t i = 0; i < m->states; i++) {
                sum[i] += h / 6.0 * weights[stage] * slope[i];
            }
        }
        for (size_t i = 0; i < m->states; i++) {
            x[i] += sum[i];
        }
    }
}

/* A state of the scene's own plant, as MuJoCo has it. */
static robot_state make_state(const robot *r, int number, double q[MOST], double v[MOST], double drives[MOST])
{
    double x[MOST], u[MOST];
    for (int i = 0; i < MOST; i++) {
        u[i] = 3.0 * next_number();
    }
    run_plant(r, u, 100 * (number + 1), x);
    int places = 0, moves = 0;
    for (int j = 0; j < r->joint_count; j++) {
        const joint_kind kind = r->joints[j].kind;
        const int at = state_of(r, r->plant.model, j, first_position(kind));
        if (kind == BALL) {
            const double size =
                sqrt(x[at] * x[at] + x[at + 1] * x[at + 1] + x[at + 2] * x[at + 2] + x[at + 3] * x[at + 3]);
            for (int k = 0; k < 4; k++) {
                x[at + k] /= size;
            }
            turn_after(r->plant.model->start + at, x + at, 1, q + places);
        } else {
            memcpy(q + places, x + at, (size_t)positions[kind] * sizeof *q);
        }
        places += positions[kind];
        memcpy(v + moves, x + state_of(r, r->plant.model, j, first_speed(kind)), (size_t)speeds[kind] * sizeof *v);
        moves += speeds[kind];
    }
    for (int k = 0; k < r->drive_count; k++) {
        drives[k] = r->drives[k].input < 0 ? 0.0 : u[r->drives[k].input];
    }
    return (robot_state){q, v, drives, NULL};
}

/* The largest difference over the largest number. */
static double difference(const double *a, const double *b, int n)
{
    double most = 0.0, size = 1e-3;
    for (int i = 0; i < n; i++) {
        most = fmax(most, isfinite(a[i]) ? fabs(a[i] - b[i]) : (double)INFINITY);
        size = fmax(size, fabs(b[i]));
    }
    return most / size;
}

#ifdef MUJOCO
#include <mujoco/mujoco.h>

static const double rough = 1e-6; /* what libmujoco's inertias are right to */

/* Gauss with pivots, [n n + 1]; what redundant rows leave open is zero. */
static void solve(double *a, int n, double *x)
{
    const int w = n + 1;
    int *pivot_of = calloc((size_t)n, sizeof *pivot_of), row = 0;
    double size = 0.0;
    for (int i = 0; i < n * w; i++) {
        size = i % w < n ? fmax(size, fabs(a[i])) : size;
    }
    for (int k = 0; k < n; k++) {
        int p = row;
        for (int i = row; i < n; i++) {
            p = fabs(a[i * w + k]) > fabs(a[p * w + k]) ? i : p;
        }
        pivot_of[k] = -1;
        if (p >= n || fabs(a[p * w + k]) < 1e-9 * size) {
            continue;
        }
        for (int j = 0; j < w; j++) {
            const double kept = a[row * w + j];
            a[row * w + j] = a[p * w + j];
            a[p * w + j] = kept;
        }
        for (int i = row + 1; i < n; i++) {
            const double f = a[i * w + k] / a[row * w + k];
            for (int j = k; j < w; j++) {
                a[i * w + j] -= f * a[row * w + j];
            }
        }
        pivot_of[k] = row++;
    }
    for (int k = n - 1; k >= 0; k--) {
        const int i = pivot_of[k];
        x[k] = i < 0 ? 0.0 : a[i * w + n];
        for (int j = k + 1; j < n && i >= 0; j++) {
            x[k] -= a[i * w + j] * x[j];
        }
        x[k] /= i < 0 ? 1.0 : a[i * w + k];
    }
    free(pivot_of);
}

/* Makes off-diagonal numbers of a symmetric matrix zero by Jacobi's rotations, whose product is `axes`. */
static void diagonalise(double a[3][3], double axes[3][3])
{
    for (int turn = 0; turn < 60; turn++) {
        const int p = turn % 3 == 2 ? 1 : 0, q = turn % 3 == 0 ? 1 : 2;
        const double angle = 0.5 * atan2(2.0 * a[p][q], a[q][q] - a[p][p]), s = sin(angle), c = cos(angle);
        for (int i = 0; i < 3; i++) {
            const double x = a[i][p], y = a[i][q], z = axes[i][p], w = axes[i][q];
            a[i][p] = c * x - s * y, a[i][q] = s * x + c * y;
            axes[i][p] = c * z - s * w, axes[i][q] = s * z + c * w;
        }
        for (int i = 0; i < 3; i++) {
            const double x = a[p][i], y = a[q][i];
            a[p][i] = c * x - s * y, a[q][i] = s * x + c * y;
        }
    }
}

/* libmujoco finds principal axes to 1e-6 only, as the corners of meshes. Where its inertia is that of the file so far,
 * its axes become exact, and of a mesh mass and centre; one that it refuses takes the place of what stands in its file.
 */
static int refine(const robot_body *b, mjModel *m, int is_odd)
{
    const int at = mj_name2id(m, mjOBJ_BODY, b->name);
    if (at < 0 || fabs(m->body_mass[at] - b->mass) > (b->is_of_mesh ? rough : 1e-12) * b->mass) {
        return 0;
    }
    double turn[9], a[3][3], axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, most = 0.0;
    mju_quat2Mat(turn, m->body_iquat + 4 * at);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            a[i][j] = 0.0;
            for (int k = 0; k < 3; k++) {
                a[i][j] += turn[3 * i + k] * m->body_inertia[3 * at + k] * turn[3 * j + k];
            }
            most =
                fmax(most, fabs(a[i][j] - b->inertia[i][j]) / (b->inertia[0][0] + b->inertia[1][1] + b->inertia[2][2]));
            a[i][j] = b->inertia[i][j];
        }
    }
    most = is_odd ? 0.0 : most;
    for (int i = 0; i < 3; i++) {
        most = fmax(most, fabs(m->body_ipos[3 * at + i] - b->centre[i]) * (b->is_of_mesh ? 1.0 : 1e5));
        m->body_ipos[3 * at + i] = b->is_of_mesh ? b->centre[i] : m->body_ipos[3 * at + i];
    }
    m->body_mass[at] = b->mass;
    diagonalise(a, axes);
    const double sign = axes[0][0] * (axes[1][1] * axes[2][2] - axes[1][2] * axes[2][1]) -
                        axes[0][1] * (axes[1][0] * axes[2][2] - axes[1][2] * axes[2][0]) +
                        axes[0][2] * (axes[1][0] * axes[2][1] - axes[1][1] * axes[2][0]);
    for (int i = 0; i < 3; i++) {
        m->body_inertia[3 * at + i] = a[i][i];
        for (int j = 0; j < 3; j++) {
            turn[3 * i + j] = axes[i][j] * (j == 2 ? sign : 1.0);
        }
    }
    mju_mat2Quat(m->body_iquat + 4 * at, turn);
    m->body_sameframe[at] = 0;
    return most < rough;
}

/* The same for stiffness and damping that libmujoco makes of inertias. */
static int refine_springs(const robot *r, mjModel *m)
{
    int same = 1;
    for (int j = 0; j < r->joint_count; j++) {
        const robot_joint *joint = &r->joints[j];
        const int at = mj_name2id(m, mjOBJ_JOINT, joint->name), first = m->jnt_dofadr[at];
        if (joint->stiffness == 0.0) {
            continue;
        }
        same = same && fabs(m->jnt_stiffness[at] - joint->stiffness) < 10.0 * rough * joint->stiffness &&
               fabs(m->dof_damping[first] - joint->damping) < 10.0 * rough * joint->damping;
        m->jnt_stiffness[at] = joint->stiffness;
        for (int k = 0; k < speeds[joint->kind]; k++) {
            m->dof_damping[first + k] = joint->damping;
        }
    }
    return same;
}

/* J' v of the equalities: the change of their rows along the speeds, by differences of fourth order, times these. */
static void bias_of(const mjModel *m, mjData *d, double *bias)
{
    static const double h = 2e-4, weights[4] = {1.0 / 12.0, -8.0 / 12.0, 8.0 / 12.0, -1.0 / 12.0};
    const int rows = d->ne;
    double *kept = calloc((size_t)m->nq, sizeof *kept);
    memcpy(kept, d->qpos, (size_t)m->nq * sizeof *kept);
    memset(bias, 0, (size_t)rows * sizeof *bias);
    for (int k = 0; k < 4; k++) {
        memcpy(d->qpos, kept, (size_t)m->nq * sizeof *kept);
        mj_integratePos(m, d->qpos, d->qvel, h * (k < 2 ? k - 2 : k - 1));
        mj_fwdPosition(m, d);
        for (int r = 0; r < rows; r++) {
            for (int i = 0; i < m->nv; i++) {
                bias[r] += weights[k] / h * d->efc_J[r * m->nv + i] * d->qvel[i];
            }
        }
    }
    memcpy(d->qpos, kept, (size_t)m->nq * sizeof *kept);
    mj_forward(m, d);
    free(kept);
}

/* MuJoCo's own constraints are soft, and leave out J' v. With its mass matrix, its forces and its rows J of the
 * equalities the hard ones are M a - J' f = forces, J a + J' v = 0, where friction is its full loss against the speed.
 * `more` are forces beside its own.
 * Returns 0 where a joint with friction rests. */
static int hard(const mjModel *m, mjData *d, const double *more, double *a)
{
    const int n = m->nv, rows = d->ne, size = n + rows;
    double *mass = calloc((size_t)(n * n), sizeof *mass), *all = calloc((size_t)(size * (size + 1)), sizeof *all);
    double *x = calloc((size_t)size, sizeof *x), *bias = calloc((size_t)rows + 1, sizeof *bias);
    int moves = 1;
    bias_of(m, d, bias);
    mj_fullM(m, mass, d->qM);
    for (int i = 0; i < n; i++) {
        const double loss = m->dof_frictionloss[i];
        memcpy(all + i * (size + 1), mass + i * n, (size_t)n * sizeof *all);
        all[i * (size + 1) + size] = d->qfrc_smooth[i] + more[i] - (d->qvel[i] < 0.0 ? -loss : loss);
        moves = moves && (loss == 0.0 || fabs(d->qvel[i]) > 0.1);
        for (int r = 0; r < rows; r++) {
            all[i * (size + 1) + n + r] = all[(n + r) * (size + 1) + i] = d->efc_J[r * n + i];
        }
    }
    for (int r = 0; r < rows; r++) {
        all[(n + r) * (size + 1) + size] = -bias[r];
    }
    solve(all, size, x);
    memcpy(a, x, (size_t)n * sizeof *a);
    free(mass), free(all), free(x), free(bias);
    return moves;
}

static int drive_mujoco(const robot *r, const robot_state *s, const mjModel *m, mjData *d)
{
    for (int k = 0; k < r->drive_count; k++) {
        const int of = r->drives[k].is_control ? mj_name2id(m, mjOBJ_ACTUATOR, r->drives[k].name)
                                               : mj_name2id(m, mjOBJ_JOINT, r->drives[k].joint);
        if (of < 0) {
            printf("# libmujoco has no '%s'\n", r->drives[k].name);
            return 0;
        }
        if (r->drives[k].is_control) {
            d->ctrl[of] = s->u[k];
        } else {
            d->qfrc_applied[m->jnt_dofadr[of]] = s->u[k];
        }
    }
    return 1;
}

/* The forces of lifts, and what limits take from those of actuators, with the lifts that count as theirs. */
static void more_forces(const robot *r, const mjModel *m, mjData *d, double *more)
{
    double lifts[MOST] = {0}, force[3];
    for (const robot_body *b = r->bodies; b->name != NULL; b++) {
        const int at = mj_name2id(m, mjOBJ_BODY, b->name);
        mju_scl3(force, m->opt.gravity, -b->lift * m->body_mass[at]);
        mj_applyFT(m, d, force, (const double[3]){0}, d->xipos + 3 * at, at, lifts);
    }
    memcpy(more, lifts, (size_t)m->nv * sizeof *more);
    for (const robot_limit *l = r->limits; l != NULL && l->joint != NULL; l++) {
        const int i = m->jnt_dofadr[mj_name2id(m, mjOBJ_JOINT, l->joint)];
        const double own = d->qfrc_actuator[i], all = own + (l->counts_lifts ? lifts[i] : 0.0);
        more[i] = fmin(fmax(all, l->least), l->most) - own + (l->counts_lifts ? 0.0 : lifts[i]);
    }
}

/* Damping ratios become dampings, by the mass matrix where the robot is drawn. */
static void damp(const robot *r, mjModel *m, mjData *d)
{
    double mass[MOST * MOST];
    mj_resetData(m, d);
    mj_forward(m, d);
    mj_fullM(m, mass, d->qM);
    for (const robot_ratio *s = r->ratios; s != NULL && s->drive != NULL; s++) {
        const int at = mj_name2id(m, mjOBJ_ACTUATOR, s->drive);
        double seen = 0.0;
        for (int i = 0; i < m->nv; i++) {
            const double ratio = d->actuator_moment[at * m->nv + i];
            seen += ratio != 0.0 ? mass[i * m->nv + i] / (ratio * ratio) : 0.0;
        }
        m->actuator_biasprm[at * mjNBIAS + 2] = -2.0 * s->ratio * sqrt(m->actuator_gainprm[at * mjNGAIN] * seen);
    }
}

typedef enum answer { UNKNOWN, RESTS, MOVES } answer;

/* The accelerations by libmujoco, in the order of robots.h. */
static answer of_mujoco(const robot *r, const robot_state *s, const mjModel *m, mjData *d, double *a)
{
    const double *q = s->q, *v = s->v;
    double all[MOST], more[MOST] = {0};
    mj_resetData(m, d);
    for (int j = 0; j < r->joint_count; j++) {
        const int of = mj_name2id(m, mjOBJ_JOINT, r->joints[j].name);
        const joint_kind kind = r->joints[j].kind;
        if (of < 0) {
            printf("# libmujoco has no joint '%s'\n", r->joints[j].name);
            return UNKNOWN;
        }
        memcpy(d->qpos + m->jnt_qposadr[of], q, (size_t)positions[kind] * sizeof *q);
        memcpy(d->qvel + m->jnt_dofadr[of], v, (size_t)speeds[kind] * sizeof *v);
        q += positions[kind];
        v += speeds[kind];
    }
    if (!drive_mujoco(r, s, m, d)) {
        return UNKNOWN;
    }
    mj_forward(m, d);
    more_forces(r, m, d, more);
    const answer found = hard(m, d, more, all) ? MOVES : RESTS;
    for (int j = 0; j < r->joint_count; j++) {
        const int of = mj_name2id(m, mjOBJ_JOINT, r->joints[j].name);
        const joint_kind kind = r->joints[j].kind;
        memcpy(a, all + m->jnt_dofadr[of], (size_t)speeds[kind] * sizeof *a);
        a += speeds[kind];
    }
    return found;
}

/* The largest difference from libmujoco over the states of a robot; -1 where that reads no such file, or the robot
 * rests in all of them. */
static double against_mujoco(const robot *r, int n)
{
    char error[500] = "";
    double worst = -1.0;
    if (!r->against_mujoco) {
        return -1.0;
    }
    mjModel *m = mj_loadXML(r->path, NULL, error, sizeof error);
    if (m == NULL) {
        printf("# %s: %s\n", r->path, error);
        return (double)INFINITY;
    }
    m->opt.disableflags |= mjDSBL_CONTACT | mjDSBL_FRICTIONLOSS | mjDSBL_LIMIT;
    m->opt.jacobian = mjJAC_DENSE;
    for (const robot_body *b = r->bodies; b->name != NULL; b++) {
        if (!refine(b, m, r->is_odd)) {
            printf("# %s: libmujoco has another inertia of %s\n", r->path, b->name);
            worst = (double)INFINITY;
        }
    }
    if (!refine_springs(r, m)) {
        printf("# %s: libmujoco makes other springs of springdamper\n", r->path);
        worst = (double)INFINITY;
    }
    mjData *d = mj_makeData(m);
    damp(r, m, d);
    for (int k = 0; k < STATES; k++) {
        double here[MOST], there[MOST];
        of_plant(r, &r->plant, &r->states[k], here);
        const answer found = of_mujoco(r, &r->states[k], m, d, there);
        worst = found == RESTS ? worst : found == MOVES ? fmax(worst, difference(here, there, n)) : (double)INFINITY;
    }
    mj_deleteData(d);
    mj_deleteModel(m);
    return worst;
}
#else
static double against_mujoco(const robot *r, int n)
{
    (void)r, (void)n;
    return -1.0;
}
#endif

int main(int argc, char **argv)
{
    const int count = (int)(sizeof robots / sizeof *robots);
    int wrong = 0, known = 0;
    double most = 0.0, most_known = 0.0;
    for (int i = 0; i < count; i++) {
        static double q[STATES][MOST], v[STATES][MOST], u[STATES][MOST];
        robot made = robots[i];
        const robot *const r = &made;
        int n = 0;
        double own = 0.0;
        for (int k = 0; k < STATES && r->again.model != NULL; k++) {
            made.states[k] = make_state(r, k, q[k], v[k], u[k]);
        }
        for (int j = 0; j < r->joint_count; j++) {
            n += speeds[r->joints[j].kind];
        }
        for (int k = 0; k < STATES; k++) {
            double a[MOST], again[MOST];
            of_plant(r, &r->plant, &r->states[k], a);
            if (r->again.model != NULL) {
                of_plant(r, &r->again, &r->states[k], again);
            }
            own = fmax(own, difference(a, r->again.model != NULL ? again : r->states[k].a, n));
        }
        const double theirs = against_mujoco(r, n);
        if (own > tolerance || theirs > tolerance) {
            printf("# %s: %.2g of the accelerations here, %.2g of libmujoco's\n", r->path, own, theirs);
            wrong++;
        }
        most = fmax(most, own);
        most_known = fmax(most_known, theirs);
        known += theirs >= 0.0;
    }
    printf("%d robots, %d wrong, the largest difference %.2g; %d also by libmujoco, %.2g\n", count, wrong, most, known,
           most_known);
    return argc > 1 ? wrong < atoi(argv[1]) : wrong != 0 || count == 0;
}
