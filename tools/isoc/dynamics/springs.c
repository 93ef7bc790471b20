#include "tools/isoc/dynamics/dynamics.h"

static stretched build_one(const kinematics *k, const point_spring *p, const acceleration *still)
{
    graph *g = k->g;
    const mechanism *m = k->m;
    const closure loop = {.parent = p->first, .child = p->second, .base = p->base};
    const matrix *turns = loop_turns(k, &loop, AXES_OF_BASE);
    const side first = side_build(k, still, &p->first, p->base, turns);
    const side second = side_build(k, still, &p->second, p->base, turns);
    stretched result = {.apart = vector_sub(g, second.point, first.point)};
    result.square = graph_name(g, vector_dot(g, result.apart, result.apart), "square_%s", p->name);
    result.inverse = graph_name(g, function(g, OP_INVERSE_ROOT, result.square, 0), "inverse_%s", p->name);
    result.distance = graph_name(g, mul(g, result.square, result.inverse), "distance_%s", p->name);
    result.row = arena_take(g->memory, (size_t)m->dof_count, sizeof *result.row);
    node product = constant(g, 0.0); /* r . r' */
    for (int f = 0; f < m->dof_count; f++) {
        result.row[f] = vector_dot(g, result.apart, vector_sub(g, second.linear[f], first.linear[f]));
        product = add(g, product, mul(g, result.row[f], leaf(g, OP_STATE, m->position_count + f)));
    }
    /* k - k length / d + c d' / d, each with one factor 1 / d at a time. */
    result.rate = graph_name(g, mul(g, product, result.inverse), "rate_%s", p->name);
    const node of_length = mul(g, mul(g, p->stiffness, p->length), result.inverse);
    const node of_damping = mul(g, mul(g, p->damping, result.rate), result.inverse);
    const node of_spring = sub(g, p->stiffness, of_length);
    result.by_length = graph_name(g, add(g, of_spring, of_damping), "factor_%s", p->name);
    return result;
}

stretched *springs_build(const kinematics *k)
{
    graph *g = k->g;
    const mechanism *m = k->m;
    stretched *result = arena_take(g->memory, (size_t)m->forces.spring_count + 1, sizeof *result);
    acceleration *still = arena_take(g->memory, (size_t)m->segment_count, sizeof *still);
    for (int i = 0; i < m->segment_count; i++) {
        still[i] = (acceleration){vector_zero(g), vector_zero(g)};
    }
    for (int i = 0; i < m->forces.spring_count; i++) {
        result[i] = build_one(k, &m->forces.springs[i], still);
    }
    return result;
}

vector spring_force(graph *g, const stretched *s)
{
    return vector_scale(g, neg(g, s->by_length), s->apart);
}

node spring_tension(graph *g, const point_spring *p, const stretched *s)
{
    const node elastic = mul(g, p->stiffness, sub(g, s->distance, p->length));
    return graph_name(g, add(g, elastic, mul(g, p->damping, s->rate)), "tension_%s", p->name);
}

node spring_energy(graph *g, const point_spring *p, const stretched *s)
{
    const node half = mul(g, constant(g, 0.5), p->stiffness);
    if (is_zero(g, p->length)) {
        return mul(g, half, s->square);
    }
    const node stretch = sub(g, s->distance, p->length);
    return mul(g, half, mul(g, stretch, stretch));
}
