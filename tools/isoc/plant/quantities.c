#include "tools/isoc/plant/plant.h"

#include <string.h>

#include "tools/isoc/tree/point_query.h"

/* --- one function for each quantity, or for a few that differ little --- */

typedef void quantity_function(plant *p, graph *g, const query *q, node *parts);

static void find_position(plant *p, graph *g, const query *q, node *parts)
{
    (void)g;
    parts[0] = p->d->k.motions[q->segment].q[0];
}

static void find_speed(plant *p, graph *g, const query *q, node *parts)
{
    (void)g;
    parts[0] = p->d->k.motions[q->segment].qd[0];
}

static void find_acceleration(plant *p, graph *g, const query *q, node *parts)
{
    parts[0] = leaf(g, OP_DERIVATIVE, p->m->position_count + p->m->segments[q->segment].dof);
}

static void find_turns(plant *p, graph *g, const query *q, node *parts)
{
    int index = 0;
    for (int i = 0; i < q->segment; i++) {
        index += p->m->segments[i].continuous;
    }
    parts[0] = leaf(g, OP_TURNS, index);
}

static void find_accelerations(plant *p)
{
    p->accelerations = p->accelerations == NULL ? reaction_accelerations(p->d) : p->accelerations;
}

/* With the ground accelerated by -gravity, as the accelerations of the segments are. */
static void find_specific_force(plant *p, graph *g, const query *q, node *parts)
{
    find_accelerations(p);
    const kinematics *k = &p->d->k;
    const body_frame *frame = &p->m->bodies.frames[q->body];
    vector found;
    if (frame->segment == GROUND) {
        const vector up = vector_sub(g, vector_zero(g), p->m->forces.gravity);
        found = q->in_body ? matrix_apply(g, matrix_transpose(frame->turn), up) : up;
    } else {
        const acceleration *now = &p->accelerations[frame->segment];
        const vector point = vector_add(g, matrix_apply(g, frame->turn, q->point), frame->offset);
        const vector moved = swing(g, k->motions[frame->segment].omega, now->alpha, point);
        const vector in_segment = vector_add(g, now->a, moved);
        found = q->in_body ? matrix_apply(g, matrix_transpose(frame->turn), in_segment)
                           : outward_axes(k, frame->segment, GROUND, in_segment);
    }
    memcpy(parts, found.at, sizeof found.at);
}

/* Of the joint of a child, or of a closure. */
static void find_reaction(plant *p, graph *g, const query *q, node *parts)
{
    wrench passed;
    if (q->closure >= 0) {
        passed = closure_reaction(p->d, q->closure);
    } else {
        find_accelerations(p);
        graph_section(g, "Reactions");
        passed = joint_reaction(p->d, p->accelerations, q->body);
    }
    const vector *found = q->kind == QUANTITY_FORCE ? &passed.force : &passed.moment;
    memcpy(parts, found->at, sizeof found->at);
}

static void find_effort(plant *p, graph *g, const query *q, node *parts)
{
    parts[0] = q->spring >= 0 ? spring_tension(g, &p->m->forces.springs[q->spring], &p->d->springs[q->spring])
                              : closure_effort(p->d, q->closure);
}

static void find_energy(plant *p, graph *g, const query *q, node *parts)
{
    (void)g;
    (void)q;
    p->energy = p->energy < 0 ? account_energy(p->d) : p->energy;
    parts[0] = p->energy;
}

static void find_power(plant *p, graph *g, const query *q, node *parts)
{
    (void)g;
    (void)q;
    parts[0] = account_power(p->d);
}

static void find_balance(plant *p, graph *g, const query *q, node *parts)
{
    (void)g;
    (void)q;
    parts[0] = account_balance(p->d);
}

static void find_of_step(plant *p, graph *g, const query *q, node *parts)
{
    (void)p;
    parts[0] = leaf(g, q->kind == QUANTITY_LOCAL_ERROR ? OP_LOCAL_ERROR : OP_RESIDUAL, 0);
}

static void find_violation(plant *p, graph *g, const query *q, node *parts)
{
    (void)g;
    parts[0] = largest_violation(&p->d->k, &p->d->loops.held, q->kind == QUANTITY_VIOLATION_RATE);
}

/* The residual of the closures' equations for the accelerations: rounding, but where an augmented Lagrangian
 * does not reach. */
static void find_violation_acceleration(plant *p, graph *g, const query *q, node *parts)
{
    (void)q;
    const constraints *closures = &p->d->loops.held;
    parts[0] = constant(g, 0.0);
    graph_section(g, "Residuals of the closures' equations for the accelerations");
    for (int r = 0; r < closures->count; r++) {
        node left = demand_of(g, p->m, &closures->all[r]);
        for (int f = 0; f < p->m->dof_count; f++) {
            left = add(g, left, mul(g, closures->all[r].row[f], p->d->acceleration[f]));
        }
        parts[0] = r == 0 ? magnitude(g, left) : larger(g, parts[0], magnitude(g, left));
    }
}

/* The others are of points. */
static quantity_function *const functions[QUANTITY_ROWS] = {
    [QUANTITY_POSITION] = find_position,
    [QUANTITY_SPEED] = find_speed,
    [QUANTITY_ACCELERATION] = find_acceleration,
    [QUANTITY_TURNS] = find_turns,
    [QUANTITY_SPECIFIC_FORCE] = find_specific_force,
    [QUANTITY_FORCE] = find_reaction,
    [QUANTITY_MOMENT] = find_reaction,
    [QUANTITY_EFFORT] = find_effort,
    [QUANTITY_ENERGY] = find_energy,
    [QUANTITY_POWER] = find_power,
    [QUANTITY_BALANCE] = find_balance,
    [QUANTITY_LOCAL_ERROR] = find_of_step,
    [QUANTITY_RESIDUAL] = find_of_step,
    [QUANTITY_VIOLATION] = find_violation,
    [QUANTITY_VIOLATION_RATE] = find_violation,
    [QUANTITY_VIOLATION_ACCELERATION] = find_violation_acceleration,
};

void quantity_nodes(plant *p, graph *g, const query *q, node parts[QUERY_PARTS])
{
    if (functions[q->kind] != NULL) {
        functions[q->kind](p, g, q, parts);
    } else {
        point_query_nodes(&p->d->k, q, parts);
    }
}

/* --- what formulas ask for --- */

/* Accounts and violations are of velocities. The accelerations have a heading of their own, and what follows from them
 * another. */
static void begin_answer(plant *p, graph *g, quantity_kind kind, quantity_kind before)
{
    const operand of = quantity_rows[kind].of;
    if (of == OF_MECHANISM || of == OF_CLOSURES) {
        kinematics_velocities(&p->d->k);
    }
    if (kind == QUANTITY_SPECIFIC_FORCE) {
        find_accelerations(p);
        if (before != kind) {
            graph_section(g, "Specific forces");
        }
    }
}

void late_queries_resolve(plant *p, graph *g)
{
    const mechanism *m = p->m;
    node *answers = arena_take(g->memory, QUERY_PARTS * (size_t)m->queries.count + 1, sizeof *answers);
    quantity_kind before = QUANTITY_ROWS;
    for (int i = 0; i < m->queries.count; i++) {
        const query *q = &m->queries.all[i];
        for (int n = 0; n < QUERY_PARTS; n++) {
            answers[QUERY_PARTS * i + n] = constant(g, 0.0);
        }
        if (is_known_late(q->kind)) {
            begin_answer(p, g, q->kind, before);
            quantity_nodes(p, g, q, &answers[QUERY_PARTS * i]);
            before = q->kind;
        }
    }
    const bool any = before < QUANTITY_ROWS;
    for (int i = 0; i < m->effects.memory_count && any; i++) {
        replace_leaves(g, &m->effects.memories[i].next, 1, OP_QUERY, answers);
        replace_leaves(g, &m->effects.memories[i].begin, 1, OP_QUERY, answers);
    }
    for (int i = 0; i < m->effects.state_count && any; i++) {
        replace_leaves(g, &m->effects.states[i].begin, 1, OP_QUERY, answers);
    }
    for (size_t i = 0; i < m->output_count && any; i++) {
        replace_leaves(g, m->outputs[i].formula.parts, (size_t)m->outputs[i].formula.count, OP_QUERY, answers);
    }
}
