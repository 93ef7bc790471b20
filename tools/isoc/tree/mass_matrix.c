#include "tools/isoc/tree/tree.h"

/* --- composite bodies --- */

static composite unturn_composite(const kinematics *k, int i, composite whole)
{
    const vector ms = unturn(k, i, whole.ms);
    return (composite){whole.mass, ms, matrix_tensor(unturn_matrix(k, i, tensor_matrix(whole.inertia)))};
}

/* A segment with its descendants: as one body; as the body that the segment's own speed turns, in which all that this
 * speed only moves along is a point; and the moment of that point about other axes. */
typedef struct outboard {
    composite whole, turned;
    vector swung;
} outboard;

/* The contribution of a composite body, in unturned axes, to its parent. */
static void join_composite(const kinematics *k, int i, composite unturned, composite *parent)
{
    graph *g = k->g;
    const segment *l = &k->m->segments[i];
    const vector p = k->motions[i].p;
    const vector ms = matrix_apply(g, l->turn, unturned.ms);
    const tensor inertia = tensor_shift(g, tensor_rotate(g, l->turn, unturned.inertia), unturned.mass, ms, p);
    parent->mass = add(g, parent->mass, unturned.mass);
    parent->ms = vector_add(g, parent->ms, vector_add(g, ms, vector_scale(g, unturned.mass, p)));
    parent->inertia = tensor_add(g, parent->inertia, inertia);
}

composite composite_of_all(const kinematics *k)
{
    composite ground = {k->m->bodies.ground_mass, k->m->bodies.ground_moment, tensor_zero(k->g)};
    composite *bodies = arena_take(k->g->memory, (size_t)k->m->segment_count, sizeof *bodies);
    for (int i = 0; i < k->m->segment_count; i++) {
        bodies[i] = k->m->segments[i].own;
    }
    for (int i = k->m->segment_count - 1; i >= 0; i--) {
        const int parent = k->m->segments[i].parent;
        join_composite(k, i, unturn_composite(k, i, bodies[i]), parent == GROUND ? &ground : &bodies[parent]);
    }
    return ground;
}

/* --- the mass matrix, row by row --- */

/* The part of armatures in an entry: their energy is that of the speed of one joint, which is w_f - (+-) w_before where
 * speeds are absolute. */
static node armature_at(const kinematics *k, int f, int j)
{
    graph *g = k->g;
    const dof *dofs = k->m->dofs;
    const segment *all = k->m->segments;
    const int i = dofs[f].segment;
    if (j != f) {
        const bool above = shared_axis(k, i) != 0 && j == dofs[f].before;
        return above ? mul(g, constant(g, -shared_axis(k, i)), all[i].armature) : constant(g, 0.0);
    }
    node sum = all[i].armature;
    for (int behind = i + 1; behind < k->m->segment_count; behind++) {
        if (all[behind].parent == i && shared_axis(k, behind) != 0) {
            sum = add(g, sum, all[behind].armature);
        }
    }
    return sum;
}

/* The wrench that a segment with its descendants needs for a unit acceleration of degree of freedom f. That of an
 * elementary joint is made after the joint's own turn, which does not change its axis; that of a free turn, before. */
static wrench unit_wrench(const kinematics *k, int f, composite whole)
{
    graph *g = k->g;
    const int i = k->m->dofs[f].segment;
    const segment *l = &k->m->segments[i];
    const vector e = axis_of(k, f);
    wrench w;
    if (slides(l)) {
        w.force = vector_scale(g, whole.mass, e);
        w.moment = vector_cross(g, whole.ms, e);
    } else {
        w.force = vector_cross(g, e, whole.ms);
        w.moment = tensor_apply(g, whole.inertia, e);
    }
    if (l->lead != 0.0) {
        const vector slid = slide_of(k, i, e);
        w.force = vector_add(g, w.force, vector_scale(g, whole.mass, slid));
        w.moment = vector_add(g, w.moment, vector_cross(g, whole.ms, slid));
    }
    return w;
}

/* Row f: the efforts at f and at its ancestors for a unit acceleration of degree of freedom f. */
static void build_row(const mass_matrix *m, int f, composite whole, vector swung)
{
    const kinematics *k = m->k;
    graph *g = k->g;
    const dof *dofs = k->m->dofs;
    const int i = dofs[f].segment;
    const segment *l = &k->m->segments[i];
    node *row = m->at + f * m->n;
    wrench w = unit_wrench(k, f, whole);
    int j = f;
    for (; j != GROUND && dofs[j].segment == i; j = dofs[j].before) {
        const node armature = armature_at(k, f, j);
        row[j] = graph_name(g, add(g, component_along(k, j, w), armature), "M_%s_%s", dofs[f].name, dofs[j].name);
    }
    w.moment = vector_add(g, w.moment, swung);
    if (l->kind == JOINT_SPHERICAL) {
        w.force = unturn(k, i, w.force);
        w.moment = unturn(k, i, w.moment);
    }
    for (int at = i; j != GROUND; at = k->m->segments[at].parent) {
        const segment *above = &k->m->segments[at];
        w.force = matrix_apply(g, above->turn, at == i ? w.force : unturn(k, at, w.force));
        w.moment = matrix_apply(g, above->turn, at == i ? w.moment : unturn(k, at, w.moment));
        const vector about = vector_cross(g, k->motions[at].p, w.force);
        w.moment = vector_add(g, w.moment, about);
        const wrench felt = {w.force, shared_axis(k, at) != 0 ? about : w.moment};
        for (; j != GROUND && dofs[j].segment == above->parent; j = dofs[j].before) {
            const node armature = armature_at(k, f, j);
            row[j] =
                graph_name(g, add(g, component_along(k, j, felt), armature), "M_%s_%s", dofs[f].name, dofs[j].name);
        }
    }
}

/* An absolute speed of the parent about a shared axis moves the segment without turning it. */
static void hang(const kinematics *k, int i, composite unturned, outboard *parent)
{
    graph *g = k->g;
    const segment *l = &k->m->segments[i];
    composite carried = unturned;
    join_composite(k, i, unturned, &parent->whole);
    if (shared_axis(k, i) != 0) {
        const vector axis = axis_of(k, k->m->segments[l->parent].dof);
        const vector along = vector_cross(g, axis, k->motions[i].p);
        const vector moment = vector_cross(g, matrix_apply(g, l->turn, unturned.ms), along);
        parent->swung = vector_add(g, parent->swung, moment);
        carried = (composite){unturned.mass, vector_zero(g), tensor_zero(g)};
    }
    join_composite(k, i, carried, &parent->turned);
}

static outboard *segments_alone(const kinematics *k)
{
    outboard *bodies = arena_take(k->g->memory, (size_t)k->m->segment_count, sizeof *bodies);
    for (int i = 0; i < k->m->segment_count; i++) {
        bodies[i] = (outboard){k->m->segments[i].own, k->m->segments[i].own, vector_zero(k->g)};
    }
    graph_section(k->g, "Mass matrix M (composite rigid bodies)");
    return bodies;
}

/* Hangs a segment with all its descendants on its parent. */
static void hang_whole(const kinematics *k, int i, outboard *bodies)
{
    const segment *l = &k->m->segments[i];
    if (l->parent != GROUND) {
        hang(k, i, unturn_composite(k, i, bodies[i].whole), &bodies[l->parent]);
    }
}

/* The rows of a segment, whose descendants hang on it. */
static void build_rows(const mass_matrix *m, int i, const outboard *carried)
{
    const kinematics *k = m->k;
    const segment *l = &k->m->segments[i];
    const composite turned = unturn_composite(k, i, carried->turned);
    const vector swung = unturn(k, i, carried->swung);
    for (int f = l->dof; f < l->dof + dofs_of(l->kind); f++) {
        build_row(m, f, l->kind == JOINT_SPHERICAL ? carried->turned : turned, swung);
    }
}

void mass_matrix_diagonal(const kinematics *k, node *diagonal)
{
    outboard *bodies = segments_alone(k);
    for (int i = k->m->segment_count - 1; i >= 0; i--) {
        const segment *l = &k->m->segments[i];
        const composite turned = unturn_composite(k, i, bodies[i].whole);
        for (int f = l->dof; f < l->dof + dofs_of(l->kind); f++) {
            const wrench w = unit_wrench(k, f, l->kind == JOINT_SPHERICAL ? bodies[i].whole : turned);
            diagonal[f] = add(k->g, component_along(k, f, w), l->armature);
        }
        hang_whole(k, i, bodies);
    }
}

/* --- M = L' D L --- */

static bool is_left(const mass_matrix *m, int i)
{
    return m->is_left != NULL && m->is_left[i];
}

/* Featherstone (2008), table 6.3: from the tips to the root, each row is divided by its pivot and taken out of its
 * ancestors' rows. */
static void factorise(const mass_matrix *m)
{
    graph *g = m->k->g;
    const int n = m->n;
    const dof *dofs = m->k->m->dofs;
    node *at = m->at;
    graph_section(g, "Factorisation M = L' D L");
    for (int i = n - 1; i >= 0; i--) {
        if (is_left(m, i)) {
            m->inverse[i] = constant(g, 0.0);
            continue;
        }
        m->pivots[i] = graph_name(g, at[i * n + i], "D_%s", dofs[i].name);
        m->inverse[i] = divide(g, constant(g, 1.0), m->pivots[i]);
        if (dofs[i].before != GROUND) {
            graph_name(g, m->inverse[i], "inverse_D_%s", dofs[i].name);
        }
        for (int j = dofs[i].before; j != GROUND; j = dofs[j].before) {
            const node factor = mul(g, at[i * n + j], m->inverse[i]);
            graph_name(g, factor, "L_%s_%s", dofs[i].name, dofs[j].name);
            for (int k = j; k != GROUND; k = dofs[k].before) {
                at[j * n + k] = sub(g, at[j * n + k], mul(g, factor, at[i * n + k]));
            }
            at[i * n + j] = factor;
        }
    }
}

mass_matrix mass_matrix_build(const kinematics *k)
{
    const size_t n = (size_t)k->m->dof_count;
    mass_matrix m = {.k = k, .n = k->m->dof_count, .at = arena_take(k->g->memory, n * n, sizeof *m.at)};
    outboard *bodies = segments_alone(k);
    for (int i = k->m->segment_count - 1; i >= 0; i--) {
        build_rows(&m, i, &bodies[i]);
        hang_whole(k, i, bodies);
    }
    m.entries = m.at;
    return m;
}

void mass_matrix_factorise(mass_matrix *m)
{
    const size_t n = (size_t)m->n;
    arena *memory = m->k->g->memory;
    m->pivots = arena_take(memory, n, sizeof *m->pivots);
    m->inverse = arena_take(memory, n, sizeof *m->inverse);
    m->at = list_copy(memory, m->entries, n * n, sizeof *m->at);
    factorise(m);
}

node mass_matrix_left(const mass_matrix *m, int i, int j)
{
    int at = i;
    while (at != GROUND && at != j) {
        at = m->k->m->dofs[at].before;
    }
    return at == GROUND ? constant(m->k->g, 0.0) : m->at[i * m->n + j];
}

/* The products by which row f is taken out of its ancestors' rows; is_entry[n n] where M and its factors are other than
 * zero and other constants. */
static int products_of_row(const mass_matrix *m, int f, bool *is_entry)
{
    const dof *dofs = m->k->m->dofs;
    const int n = m->n;
    int products = 0;
    for (int j = f; j != GROUND; j = dofs[j].before) {
        is_entry[f * n + j] = is_entry[f * n + j] || !is_constant(m->k->g, m->at[f * n + j]);
    }
    for (int j = dofs[f].before; j != GROUND; j = dofs[j].before) {
        for (int k = j; k != GROUND && is_entry[f * n + j]; k = dofs[k].before) {
            products += is_entry[f * n + k];
            is_entry[j * n + k] = is_entry[j * n + k] || is_entry[f * n + k];
        }
    }
    return products;
}

int mass_matrix_products(const kinematics *k, int most)
{
    const size_t n = (size_t)k->m->dof_count;
    const mass_matrix m = {.k = k, .n = k->m->dof_count, .at = arena_take(k->g->memory, n * n, sizeof *m.at)};
    bool *is_entry = arena_take(k->g->memory, n * n, sizeof *is_entry);
    outboard *bodies = segments_alone(k);
    int products = 0;
    for (int i = k->m->segment_count - 1; i >= 0 && products <= most; i--) {
        const segment *l = &k->m->segments[i];
        build_rows(&m, i, &bodies[i]);
        hang_whole(k, i, bodies);
        for (int f = l->dof + dofs_of(l->kind) - 1; f >= l->dof; f--) {
            products += products_of_row(&m, f, is_entry);
        }
    }
    arena_return(k->g->memory, is_entry, n * n, sizeof *is_entry);
    arena_return(k->g->memory, m.at, n * n, sizeof *m.at);
    return products;
}

void mass_matrix_inward(const mass_matrix *m, node *x)
{
    graph *g = m->k->g;
    const dof *dofs = m->k->m->dofs;
    for (int i = m->n - 1; i >= 0; i--) {
        for (int j = is_left(m, i) ? GROUND : dofs[i].before; j != GROUND; j = dofs[j].before) {
            x[j] = sub(g, x[j], mul(g, m->at[i * m->n + j], x[i]));
        }
    }
}

void mass_matrix_scale(const mass_matrix *m, node *x)
{
    graph *g = m->k->g;
    for (int i = m->n - 1; i >= 0; i--) {
        const bool alone = m->k->m->dofs[i].before == GROUND;
        x[i] = alone ? divide(g, x[i], m->pivots[i]) : mul(g, x[i], m->inverse[i]);
    }
}

void mass_matrix_outward(const mass_matrix *m, node *x)
{
    graph *g = m->k->g;
    const dof *dofs = m->k->m->dofs;
    for (int i = 0; i < m->n; i++) {
        for (int j = is_left(m, i) ? GROUND : dofs[i].before; j != GROUND; j = dofs[j].before) {
            x[i] = sub(g, x[i], mul(g, m->at[i * m->n + j], x[j]));
        }
    }
}
