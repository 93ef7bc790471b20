/* The derivative of every operator against a difference quotient of its own values. */
#include "tools/isoc/graph/operators.h"

#include <math.h>
#include <stdio.h>

#include "tests/tap.h"
#include "tools/isoc/graph/graph.h"
#include "tools/isoc/graph/rules.h"

/* Places where no operator has a kink or a jump within `step`: two states each. */
static const double places[][2] = {{2.0, 1.3}, {-0.65, 0.4}, {0.3, -1.5}, {-1.2, -2.5}, {0.6, 5.5}};
enum { PLACES = sizeof places / sizeof places[0] };
static const double step = 1e-5;

static double value_at(const graph *g, node n, const double *x)
{
    double *values = arena_take(g->memory, g->count, sizeof *values);
    const evaluation at = {.x = x};
    graph_evaluate(g, 0, &at, values);
    return values[n];
}

/* The largest difference between the derivatives of a node by both states and the quotients. */
static double worst(graph *g, node of)
{
    double largest = 0.0;
    for (int by = 0; by < 2; by++) {
        node derivative;
        differentiate(g, &of, 1, leaf(g, OP_STATE, by), &derivative);
        for (int i = 0; i < PLACES; i++) {
            double x[2] = {places[i][0], places[i][1]};
            const double exact = value_at(g, derivative, x);
            x[by] = places[i][by] + step;
            const double after = value_at(g, of, x);
            x[by] = places[i][by] - step;
            const double before = value_at(g, of, x);
            largest = fmax(largest, fabs(exact - (after - before) / (2 * step)));
        }
    }
    return largest;
}

/* An operator of two sums, products and functions of the states, so that the chain rule is tried as well. */
static void test_operator(arena *memory, operation op)
{
    graph g;
    graph_start(&g, memory, "");
    const node x = leaf(&g, OP_STATE, 0), y = leaf(&g, OP_STATE, 1), half = constant(&g, 0.5);
    const node a = add(&g, x, mul(&g, half, y)), b = sub(&g, mul(&g, x, y), y);
    const double apart = worst(&g, rules[op].again(&g, a, b));
    char name[80];
    snprintf(name, sizeof name, "%s has its derivative, to %.0e", operators[op].name, apart);
    tap_ok(apart < 1e-8, name);
}

static double slope_at(graph *g, node of, double place)
{
    node derivative;
    differentiate(g, &of, 1, leaf(g, OP_STATE, 0), &derivative);
    return value_at(g, derivative, (double[]){place});
}

/* Where two are equal, the derivative of the larger is that of either; that of |x| is the mean of both sides. */
static void test_kinks(arena *memory)
{
    graph g;
    graph_start(&g, memory, "");
    const node x = leaf(&g, OP_STATE, 0), twice = mul(&g, constant(&g, 2.0), x);
    const node bent = add(&g, twice, mul(&g, x, x));
    tap_same(slope_at(&g, larger(&g, twice, bent), 0.0), 2.0, "max(2 x, 2 x + x^2) at 0");
    tap_same(slope_at(&g, magnitude(&g, x), 0.0), 0.0, "|x| at 0");
    tap_same(slope_at(&g, mul(&g, magnitude(&g, x), x), -3.0), 6.0, "|x| x at -3");
}

int main(void)
{
    arena *memory = arena_new();
    for (operation op = 0; op < OPERATIONS; op++) {
        if (operators[op].kind == KIND_OPERATION) {
            test_operator(memory, op);
        }
    }
    test_kinks(memory);
    arena_free(memory);
    tap_done();
}
