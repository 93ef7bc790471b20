#include "tools/isoc/tree/tree.h"

wrench wrench_add(graph *g, wrench a, wrench b)
{
    a.force = vector_add(g, a.force, b.force);
    a.moment = vector_add(g, a.moment, b.moment);
    return a;
}

wrench wrench_sub(graph *g, wrench a, wrench b)
{
    a.force = vector_sub(g, a.force, b.force);
    a.moment = vector_sub(g, a.moment, b.moment);
    return a;
}

wrench wrench_at(graph *g, vector point, vector force, vector moment)
{
    return (wrench){force, vector_add(g, vector_cross(g, point, force), moment)};
}

/* omega x J omega, from the products of omega that swing() has, so that equal moments of inertia cancel. */
static vector gyration(graph *g, vector w, tensor inertia)
{
    const matrix j = tensor_matrix(inertia);
    vector result;
    for (int x = 0; x < 3; x++) {
        const int y = (x + 1) % 3, z = (x + 2) % 3;
        const node square_y = mul(g, w.at[y], w.at[y]), square_z = mul(g, w.at[z], w.at[z]);
        const node yz = mul(g, w.at[y], w.at[z]), xy = mul(g, w.at[x], w.at[y]), xz = mul(g, w.at[x], w.at[z]);
        const node across = mul(g, sub(g, j.at[z][z], j.at[y][y]), yz);
        const node squares = mul(g, j.at[y][z], sub(g, square_y, square_z));
        const node products = difference_of_products(g, j.at[x][z], xy, j.at[x][y], xz);
        result.at[x] = add(g, add(g, across, squares), products);
    }
    return result;
}

/* Newton and Euler about the origin: F = m a + swing(ms), N = J alpha + omega x J omega + ms x a. */
wrench wrench_of_motion(graph *g, composite whole, vector w, acceleration now)
{
    wrench result;
    result.force = vector_scale(g, whole.mass, now.a);
    result.force = vector_add(g, result.force, swing(g, w, now.alpha, whole.ms));
    const vector gyroscopic = gyration(g, w, whole.inertia);
    const vector angular = vector_add(g, tensor_apply(g, whole.inertia, now.alpha), gyroscopic);
    result.moment = vector_add(g, angular, vector_cross(g, whole.ms, now.a));
    return result;
}

/* u e at its point, with a moment about its own line; of an effect, its force there and its moment. */
wrench wrench_of_applied_force(graph *g, const applied_force *t)
{
    if (t->drive < 0) {
        return wrench_at(g, t->point, t->force, t->moment);
    }
    const vector force = vector_scale(g, leaf(g, OP_INPUT, t->drive), t->axis);
    return wrench_at(g, t->point, force, vector_scale(g, t->lever, force));
}

wrench wrench_to_parent(const kinematics *k, int i, wrench w)
{
    const vector force = to_parent(k, i, w.force), moment = to_parent(k, i, w.moment);
    const vector about = vector_cross(k->g, k->motions[i].p, force);
    return (wrench){force, vector_add(k->g, moment, about)};
}
