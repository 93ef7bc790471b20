/* Hunt, Crossley (1975), J. Applied Mechanics 42(2), 440-445: a damping in proportion to the depth, m x'' = -k x (1 + d
 * x').
 *
 * With v = x', v dv / (1 + d v) = -(k / m) x dx. The depth is zero where the impact begins, with v = 1, and where it
 * ends, with v = -e; so the integral of the left side from 1 to -e is zero, whatever k and m are: d (1 + e) = ln((1 +
 * d) / (1 - e d)). In q = d (1 + e) / 2 this is coth(q) - 1 / q = (1 - e) / (1 + e): d follows from the inverse of
 * Langevin's function. Here nothing cancels where e is near 1, as the logarithm does.
 */
#include "tools/isoc/formula/scalar.h"

/* (coth(q) - 1 / q) / q, for small q by the continued fraction 1 / (3 + q^2 / (5 + q^2 / (7 + ...))) of Lambert. */
static node langevin_over(graph *g, node q)
{
    enum { DEPTH = 8 };
    const node one = constant(g, 1.0), least = constant(g, 2.0);
    const node square = mul(g, q, q);
    node below = constant(g, 2 * DEPTH + 3);
    for (int i = DEPTH; i > 0; i--) {
        const node rest = divide(g, square, below);
        below = add(g, constant(g, 2 * i + 1), rest);
    }
    const node small = divide(g, one, below);
    const node far = larger(g, q, least);
    const node cotangent = divide(g, one, function(g, OP_TANH, far, 0));
    const node inverse = divide(g, one, far);
    const node large = divide(g, sub(g, cotangent, inverse), far);
    const node is_large = above(g, q, least);
    const node of_large = function(g, OP_WHERE, is_large, large);
    const node of_small = function(g, OP_UNLESS, is_large, small);
    return add(g, of_large, of_small);
}

/* y (3 - y^2 (6 + y^2 - 2 y^4) / 5) / (1 - y^2), within 0.28 % of the inverse: Kroeger (2015), J. Non-Newtonian Fluid
 * Mechanics 223, 77-87. */
static node first_guess(graph *g, node y)
{
    const node square = mul(g, y, y);
    const node twice = mul(g, constant(g, -0.4), square);
    const node outer = mul(g, square, add(g, constant(g, 0.2), twice));
    const node inner = mul(g, square, add(g, constant(g, 1.2), outer));
    const node above_it = mul(g, y, sub(g, constant(g, 3.0), inner));
    return divide(g, above_it, sub(g, constant(g, 1.0), square));
}

node impact_damping(graph *g, node e)
{
    enum { STEPS = 3 }; /* of Newton: errors of 1e-5, 1e-10, and rounding */
    const node one = constant(g, 1.0);
    const node more = add(g, one, e);
    const node y = divide(g, sub(g, one, e), more);
    node q = first_guess(g, y);
    for (int i = 0; i < STEPS; i++) {
        /* The slope of Langevin's function L is 1 - L^2 - 2 L / q. */
        const node over = langevin_over(g, q), found = mul(g, q, over), square = mul(g, found, found);
        const node twice = mul(g, constant(g, 2.0), over);
        const node rest = sub(g, sub(g, one, square), twice);
        const node off = sub(g, found, y);
        q = sub(g, q, divide(g, off, rest));
    }
    return divide(g, mul(g, constant(g, 2.0), q), more);
}
