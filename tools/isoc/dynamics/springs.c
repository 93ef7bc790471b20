#include "tools/isoc/dynamics/springs.h"

static stretched build_one(const kinematics *k, const point_spring *of, const acceleration *still)
{
    graph *g = k->g;
    const mechanism *m = k->m;
    const closure loop = {.parent = of->first, .child = of->second, .base = of->base};
    const matrix *turns = loop_turns(k, &loop, AXES_OF_BASE);
    const side first = side_build(k, still, &of->first, of->base, turns);
    const side second = side_build(k, still, &of->second, of->base, turns);
    stretched made = {.apart = vector_sub(g, second.point, first.point)};
    made.square = graph_name(g, vector_dot(g, made.apart, made.apart), "square_%s", of->name);
    made.inverse = graph_name(g, function(g, OP_INVERSE_ROOT, made.square, 0), "inverse_%s", of->name);
    made.distance = graph_name(g, mul(g, made.square, made.inverse), "distance_%s", of->name);
    made.row = arena_take(g->memory, (size_t)m->dof_count, sizeof *made.row);
    node product = constant(g, 0.0); /* r . r' */
    for (int f = 0; f < m->dof_count; f++) {
        made.row[f] = vector_dot(g, made.apart, vector_sub(g, second.linear[f], first.linear[f]));
        product = add(g, product, mul(g, made.row[f], leaf(g, OP_STATE, m->position_count + f)));
    }
    /* k - k length / d + c d' / d, each with one factor 1 / d at a time. */
    made.rate = graph_name(g, mul(g, product, made.inverse), "rate_%s", of->name);
    const node of_length = mul(g, mul(g, of->stiffness, of->length), made.inverse);
    const node of_damping = mul(g, mul(g, of->damping, made.rate), made.inverse);
    const node of_spring = sub(g, of->stiffness, of_length);
    made.by_length = graph_name(g, add(g, of_spring, of_damping), "factor_%s", of->name);
    return made;
}

stretched *springs_build(const kinematics *k)
{
    graph *g = k->g;
    const mechanism *m = k->m;
    stretched *made = arena_take(g->memory, (size_t)m->point_spring_count + 1, sizeof *made);
    acceleration *still = arena_take(g->memory, (size_t)m->segment_count, sizeof *still);
    for (int i = 0; i < m->segment_count; i++) {
        still[i] = (acceleration){vector_zero(g), vector_zero(g)};
    }
    for (int i = 0; i < m->point_spring_count; i++) {
        made[i] = build_one(k, &m->point_springs[i], still);
    }
    return made;
}

vector spring_force(graph *g, const stretched *s)
{
    return vector_scale(g, neg(g, s->by_length), s->apart);
}

node spring_tension(graph *g, const point_spring *of, const stretched *s)
{
    const node elastic = mul(g, of->stiffness, sub(g, s->distance, of->length));
    return graph_name(g, add(g, elastic, mul(g, of->damping, s->rate)), "tension_%s", of->name);
}

node spring_energy(graph *g, const point_spring *of, const stretched *s)
{
    const node half = mul(g, constant(g, 0.5), of->stiffness);
    if (is_zero(g, of->length)) {
        return mul(g, half, s->square);
    }
    const node stretch = sub(g, s->distance, of->length);
    return mul(g, half, mul(g, stretch, stretch));
}
