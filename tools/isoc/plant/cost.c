#include "tools/isoc/plant/cost.h"

/* a + times * b */
static operations plus(operations a, int times, operations b)
{
    return (operations){a.add + times * b.add, a.mul + times * b.mul, a.div + times * b.div,
                        a.sincos + times * b.sincos};
}

/* A sum of `terms` whole multiples, scaled by h / over: products by other numbers than 1 and -1, sums, the scaling. */
static operations combination(const int *c, int terms)
{
    operations n = {.add = -1, .mul = 1};
    for (int i = 0; i < terms; i++) {
        n.add += c[i] != 0;
        n.mul += c[i] != 0 && c[i] != 1 && c[i] != -1;
    }
    return n;
}

static operations of_tableau(const int8_t *row, int terms)
{
    int c[ISO_STAGES_MAX] = {0};
    for (int i = 0; i < terms; i++) {
        c[i] = row[i];
    }
    return combination(c, terms);
}

/* A formula of `terms` derivatives, by its sums. */
static operations of_derivatives(int terms)
{
    return (operations){.add = terms - 1, .mul = terms};
}

static const operations one_sum = {.add = 1};

/* What it takes to solve with 1 - hb J. */
typedef struct implicit_cost {
    operations factor, solve;
} implicit_cost;

static operations explicit_step(const iso_tableau *table, int n, operations derivative)
{
    operations total = plus(derivative, n, of_tableau(table->b, table->stages));
    for (int i = 1; i < table->stages; i++) {
        total = plus(plus(total, 1, derivative), n, plus(of_tableau(table->a[i], i), 1, one_sum));
    }
    return total;
}

static operations abm4_step(unsigned recipe, int n, operations derivative)
{
    const operations correct = {.add = 1, .mul = 1};
    const int corrections = ISO_IS(recipe, ISO_ABM4_PECECE) ? 2 : 1;
    operations total =
        plus((operations){0}, n, plus(of_derivatives(ISO_ABM4_PREDICTOR), 1, of_derivatives(ISO_ABM4_CORRECTOR)));
    total = plus(total, corrections * n, plus(correct, 1, one_sum)); /* the sum is that of the state before */
    total = plus(total, corrections, derivative);
    if (ISO_IS_CHECKED(recipe)) {
        total = plus(total, n, one_sum);
        total.mul++;
    }
    return ISO_IS(recipe, ISO_ABM4_PEC) ? total : plus(total, 1, derivative);
}

static operations bdf4_step(unsigned recipe, int n, operations derivative, implicit_cost cost)
{
    const operations predict = {.add = 3, .mul = 3}, past = {.add = 2, .mul = 4}, residual = {.add = 5, .mul = 1};
    operations total = plus(cost.factor, n, plus(plus(predict, 1, one_sum), 1, past));
    const operations iteration = plus(plus(derivative, 1, cost.solve), n, residual);
    total = plus(plus(total, ISO_ITERATIONS_OF((int)recipe), iteration), n, one_sum);
    if (ISO_IS_CHECKED(recipe)) {
        total = plus(total, n, plus(predict, 2, one_sum));
        total.mul++;
    }
    return total;
}

static operations rosenbrock_step(int n, operations derivative, implicit_cost cost)
{
    const operations stages = {.add = 6, .mul = 8}; /* k1, the state of the second stage, k2, k3, the increment */
    return plus(plus(plus(cost.factor, 2, derivative), 3, cost.solve), n, stages);
}

/* A step of n states, with its options. */
static operations step_operations(unsigned recipe, int n, operations derivative, implicit_cost cost)
{
    operations total = {0};
    switch (ISO_METHOD_OF(recipe)) {
    case ISO_EULER:
        total = explicit_step(&iso_tableau_euler, n, derivative);
        break;
    case ISO_HEUN:
        total = explicit_step(&iso_tableau_heun, n, derivative);
        break;
    case ISO_RK4:
        total = explicit_step(&iso_tableau_rk4, n, derivative);
        break;
    case ISO_AB4:
        total = plus(derivative, n, of_derivatives(ISO_AB4_STEPS));
        break;
    case ISO_SEMI_IMPLICIT:
        total = plus(derivative, n, (operations){.mul = 1});
        break;
    case ISO_BDF4:
        total = bdf4_step(recipe, n, derivative, cost);
        break;
    case ISO_ROSENBROCK:
        total = rosenbrock_step(n, derivative, cost);
        break;
    default:
        total = abm4_step(recipe, n, derivative);
        break;
    }
    if (ISO_CHECKS_DERIVATIVES(recipe)) {
        total = plus(total, n, plus(of_derivatives(ISO_CHECK_KEPT(recipe) + 1), 1, one_sum));
        total = ISO_IS(recipe, ISO_ROSENBROCK) ? plus(total, 1, cost.solve) : total;
    }
    /* x += dx, or with what rounding took away */
    return plus(total, ISO_IS_COMPENSATED(recipe) ? 7 * n : n, one_sum);
}

static void count_line(text *out, const char *what, operations n)
{
    text_add(out, "%s add %d mul %d div %d sincos %d\n", what, n.add, n.mul, n.div, n.sincos);
}

static void formulation_lines(const plant *p, text *out)
{
    for (formulation f = 0; f < FORMULATIONS; f++) {
        if (formulation_fits(p->m, f)) {
            const char *verdict = f == p->formulations.kept ? "kept" : "left";
            count_line(out, arena_format(out->memory, "formulation %s %s", formulation_names[f], verdict),
                       p->formulations.of[f]);
        }
    }
}

/* Where the closures put what the scene gives no start. */
static void assembled_lines(const mechanism *m, text *out)
{
    for (int i = 0; i < m->link_count; i++) {
        const link *l = &m->links[i];
        const char *of = slides(l) ? "m" : "rad";
        if (l->kind == JOINT_SPHERICAL && l->start_found) {
            const double *q = l->start;
            text_add(out, "assembled %s quaternion %.9g %.9g %.9g %.9g\n", l->name, q[0], q[1], q[2], q[3]);
        } else if (l->start_found) {
            text_add(out, "assembled %s %.9g %s\n", l->name, l->start[0], of);
        }
        if (l->kind == JOINT_SPHERICAL && l->speed_found) {
            const double *w = l->speed;
            text_add(out, "assembled %s_spin %.9g %.9g %.9g rad/s\n", l->name, w[0], w[1], w[2]);
        } else if (l->speed_found) {
            text_add(out, "assembled %s_speed %.9g %s/s\n", l->name, l->speed[0], of);
        }
    }
}

static implicit_cost cost_of_solving(const plant *p, const graph *g)
{
    implicit_cost cost = {{0}, {0}};
    if (ISO_IS_IMPLICIT(p->m->recipe)) {
        cost.factor = count_operations(g, p->j.factors, (size_t)p->j.factor_count);
        cost.solve = count_operations(g, p->j.solution, (size_t)state_count(p->m));
    }
    return cost;
}

operations cost_of_step(const plant *p, const graph *g)
{
    const int n = state_count(p->m);
    const operations derivative = count_operations(g, p->derivatives, (size_t)n);
    const operations rates = count_operations(g, p->derivatives, (size_t)p->rate_count);
    return plus(step_operations(p->m->recipe, n, derivative, cost_of_solving(p, g)), 1, rates);
}

void cost_summary(const plant *p, const graph *g, text *out)
{
    const mechanism *m = p->m;
    const int n = state_count(m), real_bytes = p->is_double ? 8 : 4;
    text_add(out, "scene %s\nmethod %s\nstep %g s\nreal %s\n", m->name, method_names[ISO_METHOD_OF(m->recipe)], m->step,
             p->is_double ? "double" : "float");
    text_add(out, "states %d\ninputs %d\nparameters %d\noutputs %d\n", n, m->input_count, m->parameter_count,
             p->output_count);
    assembled_lines(m, out);
    formulation_lines(p, out);
    count_line(out, "derivative", count_operations(g, p->derivatives, (size_t)n));
    if (ISO_IS_IMPLICIT(m->recipe)) {
        const implicit_cost cost = cost_of_solving(p, g);
        count_line(out, "factor", cost.factor);
        count_line(out, "solve", cost.solve);
        text_add(out, "factors %d\n", p->j.factor_count);
    }
    if (!ISO_IS(m->recipe, ISO_ADAMS)) { /* whose sub-steps are as many as it needs */
        const operations settle = count_operations(g, p->after.values, (size_t)p->after.count);
        count_line(out, "step", plus(cost_of_step(p, g), m->projections > 1 ? m->projections : 1, settle));
    }
    text_add(out, "state_bytes %d\nkept_bytes %d\n", n * real_bytes, ISO_VECTORS_KEPT(m->recipe) * n * real_bytes);
}

int cost_evaluations(unsigned recipe)
{
    switch (ISO_METHOD_OF(recipe)) {
    case ISO_HEUN:
    case ISO_ABM4:
    case ISO_ROSENBROCK:
        return 2;
    case ISO_RK4:
    case ISO_ABM4_PECECE:
        return ISO_IS(recipe, ISO_RK4) ? 4 : 3;
    case ISO_BDF4:
        return ISO_ITERATIONS_OF((int)recipe);
    default:
        return 1;
    }
}

void cost_methods(text *out)
{
    text_add(out, "| method | order | evaluations | Jacobians | solutions | vectors kept | with a check |\n");
    text_add(out, "|---|---|---|---|---|---|---|\n");
    for (unsigned method = 0; method < ISO_METHODS; method++) {
        const int solutions = ISO_IS(method, ISO_BDF4) ? ISO_ITERATIONS_OF((int)method) : 3;
        text_add(out, "| %s | %d | %d | %d | %d | %d | %d |\n", method_names[method], ISO_ORDER_OF(method),
                 cost_evaluations(method), ISO_IS_IMPLICIT(method) ? 1 : 0, ISO_IS_IMPLICIT(method) ? solutions : 0,
                 ISO_VECTORS_KEPT(method), ISO_VECTORS_KEPT(method | ISO_CHECKED));
    }
    text_add(out, "| %s | 1 to %d | 2 a sub-step | 0 | 0 | %d | %d |\n", method_names[ISO_ADAMS], ISO_ADAMS_ORDERS,
             ISO_VECTORS_KEPT(ISO_ADAMS), ISO_VECTORS_KEPT(ISO_ADAMS | ISO_CHECKED));
}
