#include "tools/isoc/plant/plant.h"

#include <string.h>

/* --- quantities that take more than a line --- */

static void find_accelerations(plant *p)
{
    p->accelerations = p->accelerations == NULL ? reaction_accelerations(p->d) : p->accelerations;
}

/* The specific force: the acceleration where the ground is accelerated by -gravity, as in those of the segments. */
static void find_specific_force(plant *p, graph *g, const query *q, node *parts)
{
    find_accelerations(p);
    const kinematics *k = &p->d->k;
    const body_frame *frame = &p->m->bodies.frames[q->body];
    vector found = vector_sub(g, vector_zero(g), p->m->forces.gravity);
    if (frame->segment != GROUND) {
        const acceleration *now = &p->accelerations[frame->segment];
        const vector point = vector_add(g, matrix_apply(g, frame->turn, q->point), frame->offset);
        const vector moved = swing(g, k->motions[frame->segment].omega, now->alpha, point);
        found = vector_add(g, now->a, moved);
    }
    found = axes_of_body(k, frame, q->in_body, found);
    memcpy(parts, found.at, sizeof found.at);
}

/* The reaction of the joint of a child, or of a closure. */
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

/* The residual of the closures' equations for the accelerations: rounding, but where an augmented Lagrangian
 * does not reach. */
static node violation_acceleration(const plant *p, graph *g)
{
    const constraints *closures = &p->d->loops.phi;
    node largest = constant(g, 0.0);
    graph_section(g, "Residuals of the closures' equations for the accelerations");
    for (int r = 0; r < closures->count; r++) {
        node left = demand_of(g, p->m, &closures->all[r]);
        for (int f = 0; f < p->m->dof_count; f++) {
            left = add(g, left, mul(g, closures->all[r].row[f], p->d->acceleration[f]));
        }
        largest = r == 0 ? magnitude(g, left) : larger(g, largest, magnitude(g, left));
    }
    return largest;
}

/* Of the hold with this mode; zero where its effect is left out. */
static node effort_of_hold(const dynamics *d, int mode)
{
    node found = constant(d->g, 0.0);
    for (int i = 0; i < d->m->events.hold_count; i++) {
        found = d->m->events.holds[i].state == mode ? d->holds.effort[i] : found;
    }
    return found;
}

static int turns_before(const mechanism *m, int index)
{
    int count = 0;
    for (int i = 0; i < index; i++) {
        count += m->segments[i].continuous;
    }
    return count;
}

/* --- all of them --- */

/* The node of a quantity of one number that is of no point; -1: it is another quantity. */
static node number_of(plant *p, graph *g, const query *q)
{
    const mechanism *m = p->m;
    const dynamics *d = p->d;
    switch (q->kind) {
    case QUANTITY_POSITION:
        return d->k.motions[q->segment].q[0];
    case QUANTITY_SPEED:
        return d->k.motions[q->segment].qd[0];
    case QUANTITY_ACCELERATION:
        return leaf(g, OP_DERIVATIVE, m->position_count + m->segments[q->segment].dof);
    case QUANTITY_TURNS:
        return leaf(g, OP_TURNS, turns_before(m, q->segment));
    case QUANTITY_EFFORT:
        return q->hold >= 0     ? effort_of_hold(d, m->effects.first_state + q->hold)
               : q->spring >= 0 ? spring_tension(g, &m->forces.springs[q->spring], &d->springs[q->spring])
                                : closure_effort(d, q->closure);
    case QUANTITY_ENERGY:
        return p->energy = p->energy < 0 ? account_energy(d) : p->energy;
    case QUANTITY_EVENT_LOSS:
        return leaf(g, OP_STATE, m->events.loss_state);
    case QUANTITY_POWER:
        return account_power(d);
    case QUANTITY_BALANCE:
        return account_balance(d);
    case QUANTITY_POWER_OF_EFFECT:
    case QUANTITY_ENERGY_OF_EFFECT:
    case QUANTITY_LOSS:
    case QUANTITY_WORK:
        return account_with_parts(g, &m->effects, q->effect, q->kind);
    case QUANTITY_LOCAL_ERROR:
    case QUANTITY_RESIDUAL:
        return leaf(g, q->kind == QUANTITY_LOCAL_ERROR ? OP_LOCAL_ERROR : OP_RESIDUAL, 0);
    case QUANTITY_VIOLATION:
    case QUANTITY_VIOLATION_RATE:
        return largest_violation(&d->k, &d->loops.phi, q->kind == QUANTITY_VIOLATION_RATE);
    case QUANTITY_VIOLATION_ACCELERATION:
        return violation_acceleration(p, g);
    default:
        return -1;
    }
}

void quantity_nodes(plant *p, graph *g, const query *q, node parts[QUERY_PARTS])
{
    if (q->kind == QUANTITY_SPECIFIC_FORCE) {
        find_specific_force(p, g, q, parts);
    } else if (q->kind == QUANTITY_FORCE || q->kind == QUANTITY_MOMENT) {
        find_reaction(p, g, q, parts);
    } else if ((parts[0] = number_of(p, g, q)) < 0) {
        point_query_nodes(&p->d->k, q, parts);
    }
}

/* --- quantities in formulas --- */

/* Accounts and violations are of velocities. The accelerations have a heading of their own, and quantities that follow
 * from them another. */
static void begin_answer(plant *p, graph *g, quantity_kind kind, quantity_kind before)
{
    const operand owner = quantity_rows[kind].owner;
    if (owner == OF_MECHANISM || owner == OF_CLOSURES) {
        kinematics_velocities(&p->d->k);
    }
    if (kind == QUANTITY_SPECIFIC_FORCE) {
        find_accelerations(p);
        if (before != kind) {
            graph_section(g, "Specific forces");
        }
    }
}

static void replace_queries(graph *g, node *roots, size_t count, void *context)
{
    replace_more_leaves(g, roots, count, context);
}

void late_queries_resolve(plant *p, graph *g)
{
    const mechanism *m = p->m;
    node *answers = zero_nodes(g, QUERY_PARTS * (size_t)m->queries.count + 1);
    quantity_kind before = QUANTITY_ROWS;
    FOR_EACH (const query, q, m->queries) {
        if (is_known_late(q->kind)) {
            begin_answer(p, g, q->kind, before);
            quantity_nodes(p, g, q, &answers[QUERY_PARTS * (q - m->queries.all)]);
            before = q->kind;
        }
    }
    if (before < QUANTITY_ROWS) {
        replacement all = {.op = OP_QUERY, .by = answers};
        for_roots(g, m, true, replace_queries, &all);
    }
}
