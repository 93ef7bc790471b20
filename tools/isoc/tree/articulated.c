#include <float.h>
#include <math.h>

#include "tools/isoc/tree/tree.h"

/* A segment with its descendants, whose joints are free: an acceleration A needs the wrench inertia A + bias. */
typedef struct articulated {
    spatial inertia;
    node bias[SPATIAL];
} articulated;

/* Values of a degree of freedom that the way inward keeps for the way outward: its column U of the inertia, the pivot D
 * on the diagonal, and the remaining effort u. All along its coordinate axis, whatever the sign of the joint's axis. */
typedef struct release {
    int at;                               /* its place among the six components */
    double lead;                          /* of a screw: its part in the linear component of the same axis */
    bool alone;                           /* the effort of its acceleration is in its own component alone */
    node column[SPATIAL], share[SPATIAL]; /* U, U / D */
    node pivot, inverse, effort;
} release;

static void put_block(spatial *s, int row, int column, matrix m)
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            s->at[row + i][column + j] = s->at[column + j][row + i] = m.at[i][j];
        }
    }
}

static matrix block_of(const spatial *s, int row, int column)
{
    matrix m;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            m.at[i][j] = s->at[row + i][column + j];
        }
    }
    return m;
}

static void put_vector(node *to, int at, vector a)
{
    memcpy(to + at, a.at, sizeof a.at);
}

static vector vector_at(const node *from, int at)
{
    return (vector){{from[at], from[at + 1], from[at + 2]}};
}

static matrix cross_matrix(graph *g, vector a)
{
    const node zero = constant(g, 0.0);
    const vector minus = vector_sub(g, vector_zero(g), a);
    return (matrix){{{zero, minus.at[2], a.at[1]}, {a.at[2], zero, minus.at[0]}, {minus.at[1], a.at[0], zero}}};
}

/* A segment alone; `still` is the wrench that it needs when its origin and its rotation are not accelerated. */
static articulated rigid(graph *g, const segment *l, wrench still)
{
    const node zero = constant(g, 0.0), mass = l->own.mass;
    articulated result;
    put_block(&result.inertia, ANGULAR, ANGULAR, tensor_matrix(l->own.inertia));
    put_block(&result.inertia, ANGULAR, LINEAR, cross_matrix(g, l->own.ms));
    put_block(&result.inertia, LINEAR, LINEAR, (matrix){{{mass, zero, zero}, {zero, mass, zero}, {zero, zero, mass}}});
    put_vector(result.bias, ANGULAR, still.moment);
    put_vector(result.bias, LINEAR, still.force);
    return result;
}

/* The component of a release's own motion. */
static node own_component(graph *g, const release *r, const node *components)
{
    const node own = components[r->at];
    return r->lead == 0.0 ? own : add(g, own, mul(g, constant(g, r->lead), components[r->at + LINEAR]));
}

/* Whether component i is that degree of freedom, and nothing else: no screw, no armature. */
static bool is_own(const release *r, int i)
{
    return i == r->at && r->alone;
}

/* entry - U_i part / D. Where D = d U_i + e and entry = part / d + c, with constants c, d and e, that is
 * c + e part / (d D), without the difference of two numbers that are nearly equal. A rod that bears a force across
 * itself is such a case. -1 where there are no such constants. */
static node less_share(graph *g, const release *r, node entry, int i, node part)
{
    double d, e, slope, c;
    const bool is_line = is_line_in(g, r->pivot, r->column[i], &d, &e) && is_line_in(g, entry, part, &slope, &c) &&
                         fabs(slope * d - 1.0) <= 4 * DBL_EPSILON;
    return is_line ? add(g, constant(g, c), mul(g, constant(g, e / d), mul(g, part, r->inverse))) : -1;
}

/* I_ij - U_i U_j / D */
static node inertia_left(graph *g, const release *r, node inertia, int i, int j)
{
    node result = -1;
    if (i != j) {
        result = less_share(g, r, inertia, i, r->column[j]);
        result = result >= 0 ? result : less_share(g, r, inertia, j, r->column[i]);
    }
    return result >= 0 ? result : sub(g, inertia, mul(g, r->share[i], r->column[j]));
}

/* The bias of a component and U_i / D times the effort. */
static node bias_left(graph *g, const release *r, node bias, int i)
{
    const node result = less_share(g, r, bias, i, neg(g, r->effort));
    return result >= 0 ? result : add(g, bias, mul(g, r->share[i], r->effort));
}

/* Frees a degree of freedom: the inertia becomes I - U U' / D, and the bias gets U / D times the effort less its part
 * of the bias. Along the degree of freedom itself only the effort is left. */
static release let_go(const kinematics *k, int f, node effort, articulated *b)
{
    graph *g = k->g;
    const segment *l = &k->m->segments[k->m->dofs[f].segment];
    const int at = k->m->dofs[f].axis + (slides(l) ? LINEAR : ANGULAR);
    const node borne = mul(g, axis_of(k, f).at[at % 3], effort), zero = constant(g, 0.0);
    release result = {.at = at, .lead = l->lead, .alone = l->lead == 0.0 && is_zero(g, l->armature)};
    for (int i = 0; i < SPATIAL; i++) {
        result.column[i] = own_component(g, &result, b->inertia.at[i]);
    }
    const node pivot = add(g, own_component(g, &result, result.column), l->armature);
    result.pivot = graph_name(g, pivot, "D_%s", k->m->dofs[f].name);
    result.inverse = divide(g, constant(g, 1.0), result.pivot);
    result.effort = sub(g, borne, own_component(g, &result, b->bias));
    for (int i = 0; i < SPATIAL; i++) {
        result.share[i] = mul(g, result.column[i], result.inverse);
    }
    for (int i = 0; i < SPATIAL; i++) {
        for (int j = 0; j <= i; j++) {
            const bool gone = is_own(&result, i) || is_own(&result, j);
            b->inertia.at[i][j] = b->inertia.at[j][i] =
                gone ? zero : inertia_left(g, &result, b->inertia.at[i][j], i, j);
        }
        b->bias[i] = is_own(&result, i) ? borne : bias_left(g, &result, b->bias[i], i);
    }
    return result;
}

/* bias += inertia A, for accelerations that do not depend on those of the joints. */
static void feel(graph *g, articulated *b, acceleration coriolis)
{
    node a[SPATIAL];
    put_vector(a, ANGULAR, coriolis.alpha);
    put_vector(a, LINEAR, coriolis.a);
    for (int i = 0; i < SPATIAL; i++) {
        for (int j = 0; j < SPATIAL; j++) {
            b->bias[i] = add(g, b->bias[i], mul(g, b->inertia.at[i][j], a[j]));
        }
    }
}

/* Turns an articulated body from segment axes to the parent's. */
static void turn_to_parent(const kinematics *k, int i, articulated *b)
{
    for (int row = ANGULAR; row <= LINEAR; row += 3) {
        for (int column = row; column <= LINEAR; column += 3) {
            const matrix unturned = unturn_matrix(k, i, block_of(&b->inertia, row, column));
            put_block(&b->inertia, row, column, matrix_rotate(k->g, k->m->segments[i].turn, unturned));
        }
        put_vector(b->bias, row, to_parent(k, i, vector_at(b->bias, row)));
    }
}

/* Moves the reference from the segment's origin to the parent's, that is by p. With inertia J, coupling H and mass M:
 * H' = H + [p] M, J' = J + [p] H'^T - H [p]. */
static void shift(graph *g, articulated *b, vector p)
{
    const matrix across = cross_matrix(g, p), mass = block_of(&b->inertia, LINEAR, LINEAR);
    const matrix coupling = block_of(&b->inertia, ANGULAR, LINEAR), inertia = block_of(&b->inertia, ANGULAR, ANGULAR);
    const matrix moved = matrix_add(g, coupling, matrix_product(g, across, mass));
    const matrix outer = matrix_product(g, across, matrix_transpose(moved));
    const matrix inner = matrix_product(g, across, matrix_transpose(coupling)); /* (-H [p])' */
    const vector about = vector_cross(g, p, vector_at(b->bias, LINEAR));
    put_block(&b->inertia, ANGULAR, LINEAR, moved);
    put_block(&b->inertia, ANGULAR, ANGULAR, matrix_add(g, inertia, matrix_add(g, outer, matrix_transpose(inner))));
    put_vector(b->bias, ANGULAR, vector_add(g, vector_at(b->bias, ANGULAR), about));
}

static void add_inertia(graph *g, const articulated *from, articulated *to)
{
    for (int i = 0; i < SPATIAL; i++) {
        for (int j = 0; j <= i; j++) {
            to->inertia.at[i][j] = to->inertia.at[j][i] = add(g, to->inertia.at[i][j], from->inertia.at[i][j]);
        }
        to->bias[i] = add(g, to->bias[i], from->bias[i]);
    }
}

static void name_parts(graph *g, const char *owner, const articulated *b)
{
    for (int i = 0; i < SPATIAL; i++) {
        for (int j = 0; j <= i; j++) {
            graph_name(g, b->inertia.at[i][j], "I_%s_%d%d", owner, i + 1, j + 1);
        }
    }
    vector_name(g, vector_at(b->bias, ANGULAR), "moment", owner);
    vector_name(g, vector_at(b->bias, LINEAR), "force", owner);
}

/* The part of a segment in its parent. Without accelerations of the joints its acceleration is that of its own joint's
 * rate, which is turned, and at its origin omega x (omega x p) of the parent. */
static void hand_inward(const kinematics *k, int i, articulated *b)
{
    graph *g = k->g;
    const vector p = k->motions[i].p, still = vector_zero(g);
    feel(g, b, joint_coriolis(k, i));
    turn_to_parent(k, i, b);
    feel(g, b, (acceleration){still, swing(g, k->motions[k->m->segments[i].parent].omega, still, p)});
    shift(g, b, p);
}

static void inward(const kinematics *k, const node *effort, articulated *bodies, release *releases)
{
    for (int i = k->m->segment_count - 1; i >= 0; i--) {
        const segment *l = &k->m->segments[i];
        name_parts(k->g, l->name, &bodies[i]);
        for (int f = l->dof + dofs_of(l->kind) - 1; f >= l->dof; f--) {
            releases[f] = let_go(k, f, effort[f], &bodies[i]);
        }
        if (l->parent != GROUND) {
            hand_inward(k, i, &bodies[i]);
            add_inertia(k->g, &bodies[i], &bodies[l->parent]);
        }
    }
}

/* (u - U' A) / D over the other components of A: the degree of freedom's own component of A. A division, if nothing
 * else needs the inverse of the pivot. */
static node follow(graph *g, const release *r, bool alone, const node *a)
{
    node sum = alone ? r->effort : mul(g, r->effort, r->inverse);
    for (int i = 0; i < SPATIAL; i++) {
        if (!is_own(r, i)) {
            sum = sub(g, sum, mul(g, alone ? r->column[i] : r->share[i], a[i]));
        }
    }
    return alone ? divide(g, sum, r->pivot) : sum;
}

static void outward(const kinematics *k, const release *releases, node *x)
{
    graph *g = k->g;
    const mechanism *m = k->m;
    acceleration *all = arena_take(g->memory, (size_t)m->segment_count, sizeof *all);
    for (int i = 0; i < m->segment_count; i++) {
        const segment *l = &m->segments[i];
        node a[SPATIAL];
        all[i] = accelerate_outward(k, i, all);
        put_vector(a, ANGULAR, all[i].alpha);
        put_vector(a, LINEAR, all[i].a);
        for (int f = l->dof; f < l->dof + dofs_of(l->kind); f++) {
            const release *r = &releases[f];
            const node result = follow(g, r, m->dofs[f].before == GROUND, a);
            const node moved = r->alone ? sub(g, result, a[r->at]) : result;
            x[f] = mul(g, axis_of(k, f).at[m->dofs[f].axis], moved);
            a[r->at] = r->alone ? result : add(g, a[r->at], result);
            if (r->lead != 0.0) {
                a[r->at + LINEAR] = add(g, a[r->at + LINEAR], mul(g, constant(g, r->lead), result));
            }
        }
        all[i] = (acceleration){vector_at(a, ANGULAR), vector_at(a, LINEAR)};
    }
}

void articulated_solve(const kinematics *k, node *x)
{
    graph *g = k->g;
    const size_t n = (size_t)k->m->segment_count;
    articulated *bodies = arena_take(g->memory, n, sizeof *bodies);
    release *releases = arena_take(g->memory, (size_t)k->m->dof_count, sizeof *releases);
    acceleration *still = arena_take(g->memory, n, sizeof *still);
    wrench *wrenches = arena_take(g->memory, n, sizeof *wrenches);
    graph_section(g, "Articulated bodies inward: inertia, and what it takes where the joints are free");
    for (size_t i = 0; i < n; i++) {
        still[i] = (acceleration){vector_zero(g), vector_zero(g)};
    }
    inertial_wrenches(k, still, wrenches);
    for (size_t i = 0; i < n; i++) {
        bodies[i] = rigid(g, &k->m->segments[i], wrenches[i]);
    }
    inward(k, x, bodies, releases);
    graph_section(g, "Accelerations outward, with the ground accelerated by -gravity: q'' = (u - U' A) / D");
    outward(k, releases, x);
}

/* --- at rest --- */

/* The releases of all degrees of freedom of a mechanism that neither moves nor is pushed. */
static release *releases_at_rest(const kinematics *k)
{
    graph *g = k->g;
    const mechanism *m = k->m;
    const wrench none = {vector_zero(g), vector_zero(g)};
    articulated *bodies = arena_take(g->memory, (size_t)m->segment_count, sizeof *bodies);
    release *releases = arena_take(g->memory, (size_t)m->dof_count, sizeof *releases);
    for (int i = 0; i < m->segment_count; i++) {
        bodies[i] = rigid(g, &m->segments[i], none);
    }
    for (int i = m->segment_count - 1; i >= 0; i--) {
        const segment *l = &m->segments[i];
        for (int f = l->dof + dofs_of(l->kind) - 1; f >= l->dof; f--) {
            releases[f] = let_go(k, f, constant(g, 0.0), &bodies[i]);
        }
        if (l->parent != GROUND) {
            turn_to_parent(k, i, &bodies[i]);
            shift(g, &bodies[i], k->motions[i].p);
            add_inertia(g, &bodies[i], &bodies[l->parent]);
        }
    }
    return releases;
}

void articulated_pivots(const kinematics *k, node *pivots)
{
    const release *releases = releases_at_rest(k);
    for (int f = 0; f < k->m->dof_count; f++) {
        pivots[f] = releases[f].pivot;
    }
}

static void apply(graph *g, const spatial *s, const node *to, node *result)
{
    for (int i = 0; i < SPATIAL; i++) {
        result[i] = constant(g, 0.0);
        for (int j = 0; j < SPATIAL; j++) {
            result[i] = add(g, result[i], mul(g, s->at[i][j], to[j]));
        }
    }
}

/* The response of a segment whose joint is locked, column by column: what its parent does. */
static spatial locked_response(const kinematics *k, int i, const spatial *parent)
{
    graph *g = k->g;
    spatial result;
    for (int column = 0; column < SPATIAL; column++) {
        node pushed[SPATIAL], moved[SPATIAL];
        wrench pushing = {vector_zero(g), vector_zero(g)};
        (column < LINEAR ? &pushing.moment : &pushing.force)->at[column % 3] = constant(g, 1.0);
        const wrench w = wrench_to_parent(k, i, pushing);
        put_vector(pushed, ANGULAR, w.moment);
        put_vector(pushed, LINEAR, w.force);
        apply(g, parent, pushed, moved);
        const vector alpha = vector_at(moved, ANGULAR), about = vector_cross(g, alpha, k->motions[i].p);
        const vector a = vector_add(g, vector_at(moved, LINEAR), about);
        put_vector(moved, ANGULAR, from_parent(k, i, alpha));
        put_vector(moved, LINEAR, from_parent(k, i, a));
        for (int row = 0; row <= column; row++) {
            result.at[row][column] = result.at[column][row] = moved[row];
        }
    }
    return result;
}

/* Frees a degree of freedom: with its motion S, and y = C U / D and z = y' U / D of the response C until then, that
 * becomes C - S y' - y S' + S S' (z + 1 / D); z + 1 / D is the degree's own acceleration by a unit effort. */
static node free_response(graph *g, const release *r, spatial *c)
{
    node y[SPATIAL], own = r->inverse;
    const double along[2] = {1.0, r->lead};
    apply(g, c, r->share, y);
    for (int i = 0; i < SPATIAL; i++) {
        own = add(g, own, mul(g, y[i], r->share[i]));
    }
    for (int n = 0; n < (r->lead == 0.0 ? 1 : 2); n++) {
        const int moved = r->at + n * LINEAR;
        for (int i = 0; i < SPATIAL; i++) {
            const node part = mul(g, constant(g, along[n]), y[i]);
            c->at[moved][i] = sub(g, c->at[moved][i], part);
            c->at[i][moved] = sub(g, c->at[i][moved], part);
        }
    }
    for (int n = 0; n < (r->lead == 0.0 ? 1 : 4); n++) {
        node *at = &c->at[r->at + n / 2 * LINEAR][r->at + n % 2 * LINEAR];
        *at = add(g, *at, mul(g, constant(g, along[n / 2] * along[n % 2]), own));
    }
    return own;
}

void articulated_responses(const kinematics *k, node *joints, spatial *segments)
{
    const mechanism *m = k->m;
    const release *releases = releases_at_rest(k);
    spatial still;
    for (int i = 0; i < SPATIAL * SPATIAL; i++) {
        still.at[i / SPATIAL][i % SPATIAL] = constant(k->g, 0.0);
    }
    for (int i = 0; i < m->segment_count; i++) {
        const segment *l = &m->segments[i];
        segments[i] = l->parent == GROUND ? still : locked_response(k, i, &segments[l->parent]);
        for (int f = l->dof; f < l->dof + dofs_of(l->kind); f++) {
            joints[f] = free_response(k->g, &releases[f], &segments[i]);
        }
    }
}
