/* core/tableau.h: the order conditions of every table, exact in whole numbers.
 *
 * Hairer, Norsett, Wanner (1993), Solving Ordinary Differential Equations I, table II.2.1 (the rooted trees to order
 * four) and III.1 (the moments of Adams-Bashforth).
 */
#include "core/tableau.h"
#include "tests/tap.h"

/* A table with one denominator for all of a: a_ij = a[i][j] / a_over, c_i = sum_j a_ij, b_i = b[i] / b_over. */
typedef struct scaled {
    int64_t a[ISO_STAGES_MAX][ISO_STAGES_MAX];
    int64_t c[ISO_STAGES_MAX];
    int64_t a_over;
} scaled;

static scaled scale(const iso_tableau *const t)
{
    scaled s = {.a_over = 1};
    for (unsigned i = 0; i < t->stages; i++) {
        s.a_over *= t->a_over[i];
    }
    for (unsigned i = 0; i < t->stages; i++) {
        for (unsigned j = 0; j < t->stages; j++) {
            s.a[i][j] = t->a[i][j] * (s.a_over / t->a_over[i]);
            s.c[i] += s.a[i][j];
        }
    }
    return s;
}

/* v = a w. */
static void multiply(int64_t v[ISO_STAGES_MAX], const scaled *const s, const int64_t w[ISO_STAGES_MAX])
{
    for (unsigned i = 0; i < ISO_STAGES_MAX; i++) {
        v[i] = 0;
        for (unsigned j = 0; j < ISO_STAGES_MAX; j++) {
            v[i] += s->a[i][j] * w[j];
        }
    }
}

/* gamma sum_i b_i v_i = 1 with v of denominator a_over^power: one order condition, for the tree of density gamma. */
static bool holds(const iso_tableau *const t, const scaled *const s, const int64_t v[ISO_STAGES_MAX],
                  const int64_t gamma, const unsigned power)
{
    int64_t left = 0;
    int64_t right = t->b_over;
    for (unsigned i = 0; i < t->stages; i++) {
        left += gamma * t->b[i] * v[i];
    }
    for (unsigned i = 0; i < power; i++) {
        right *= s->a_over;
    }
    return left == right;
}

/* The highest order, at most four, whose conditions and those below it the table meets. */
static unsigned order_of(const iso_tableau *const t)
{
    const scaled s = scale(t);
    int64_t one[ISO_STAGES_MAX], c2[ISO_STAGES_MAX], c3[ISO_STAGES_MAX];
    int64_t ac[ISO_STAGES_MAX], cac[ISO_STAGES_MAX], ac2[ISO_STAGES_MAX], aac[ISO_STAGES_MAX];

    multiply(ac, &s, s.c);
    multiply(aac, &s, ac);
    for (unsigned i = 0; i < ISO_STAGES_MAX; i++) {
        one[i] = 1;
        c2[i] = s.c[i] * s.c[i];
        c3[i] = c2[i] * s.c[i];
        cac[i] = s.c[i] * ac[i];
    }
    multiply(ac2, &s, c2);

    const bool met[] = {
        holds(t, &s, one, 1, 0),
        holds(t, &s, s.c, 2, 1),
        holds(t, &s, c2, 3, 2) && holds(t, &s, ac, 6, 2),
        holds(t, &s, c3, 4, 3) && holds(t, &s, cac, 8, 3) && holds(t, &s, ac2, 12, 3) && holds(t, &s, aac, 24, 3),
    };
    unsigned order = 0;
    while (order < 4 && met[order]) {
        order++;
    }
    return order;
}

/* Stage i uses slopes before i only, and the fields beyond the stages are empty. */
static bool is_explicit(const iso_tableau *const t)
{
    bool good = t->stages >= 1 && t->stages <= ISO_STAGES_MAX && t->b_over > 0;
    for (unsigned i = 0; i < ISO_STAGES_MAX; i++) {
        good = good && (i < t->stages ? t->a_over[i] > 0 : t->b[i] == 0);
        for (unsigned j = 0; j < ISO_STAGES_MAX; j++) {
            good = good && (t->a[i][j] == 0 || (i < t->stages && j < i));
        }
    }
    return good;
}

/* Nodes c_i = nodes[i] / 2. */
static bool has_nodes(const iso_tableau *const t, const int64_t nodes[ISO_STAGES_MAX])
{
    const scaled s = scale(t);
    bool good = true;
    for (unsigned i = 0; i < t->stages; i++) {
        good = good && 2 * s.c[i] == nodes[i] * s.a_over;
    }
    return good;
}

static void test_tables(void)
{
    tap_count(order_of(&iso_tableau_euler), iso_tableau_euler.order, "euler: order conditions");
    tap_count(order_of(&iso_tableau_heun), iso_tableau_heun.order, "heun: order conditions");
    tap_count(order_of(&iso_tableau_rk4), iso_tableau_rk4.order, "rk4: order conditions");
    tap_count(iso_tableau_euler.order, 1, "euler: order 1");
    tap_count(iso_tableau_heun.order, 2, "heun: order 2");
    tap_count(iso_tableau_rk4.order, 4, "rk4: order 4");
    tap_ok(is_explicit(&iso_tableau_euler), "euler: strictly lower triangular");
    tap_ok(is_explicit(&iso_tableau_heun), "heun: strictly lower triangular");
    tap_ok(is_explicit(&iso_tableau_rk4), "rk4: strictly lower triangular");
    tap_ok(has_nodes(&iso_tableau_euler, (int64_t[ISO_STAGES_MAX]){0}), "euler: nodes 0");
    tap_ok(has_nodes(&iso_tableau_heun, (int64_t[ISO_STAGES_MAX]){0, 2}), "heun: nodes 0, 1");
    tap_ok(has_nodes(&iso_tableau_rk4, (int64_t[ISO_STAGES_MAX]){0, 1, 1, 2}), "rk4: nodes 0, 1/2, 1/2, 1");
}

/* Tables with one wrong number: the conditions must notice each. */
static void test_broken_tables(void)
{
    iso_tableau t = iso_tableau_rk4;
    t.b[1] = 3;
    tap_count(order_of(&t), 0, "a wrong weight leaves order 0");
    t = iso_tableau_rk4;
    t.b[0] = 2;
    t.b[3] = 1;
    t.b_over = 7;
    t.b[1] = 2;
    tap_count(order_of(&t), 1, "unequal outer weights leave order 1");
    t = iso_tableau_rk4;
    t.a[2][0] = 1;
    t.a[2][1] = 0;
    tap_count(order_of(&t), 2, "a third stage from the first slope leaves order 2");
    t = iso_tableau_rk4;
    t.a_over[1] = 3;
    tap_count(order_of(&t), 1, "a second stage at a third of the step leaves order 1");
    t = iso_tableau_rk4;
    t.a[1][2] = 1;
    tap_ok(!is_explicit(&t), "an entry above the diagonal is noticed");

    /* Kutta's third-order method, with a fourth stage of no weight. */
    const iso_tableau kutta3 = {
        .stages = 3,
        .order = 3,
        .a = {{0}, {1}, {-1, 2}},
        .a_over = {1, 2, 1},
        .b = {1, 4, 1},
        .b_over = 6,
    };
    tap_count(order_of(&kutta3), 3, "the conditions tell order 3 from order 4");
}

/* over / (m + 1) = sum_j b_j (-j)^m: exact for polynomials of degree m. */
static bool moment_holds(const iso_adams_bashforth *const t, const unsigned m)
{
    int64_t sum = 0;
    for (int j = 0; j < ISO_AB4_STEPS; j++) {
        int64_t power = 1;
        for (unsigned i = 0; i < m; i++) {
            power *= -j;
        }
        sum += t->b[j] * power;
    }
    return ((int64_t)m + 1) * sum == t->over;
}

static void test_adams_bashforth(void)
{
    tap_ok(moment_holds(&iso_table_ab4, 0), "ab4: exact for a constant slope");
    tap_ok(moment_holds(&iso_table_ab4, 1), "ab4: exact for a linear slope");
    tap_ok(moment_holds(&iso_table_ab4, 2), "ab4: exact for a quadratic slope");
    tap_ok(moment_holds(&iso_table_ab4, 3), "ab4: exact for a cubic slope");
    tap_ok(!moment_holds(&iso_table_ab4, 4), "ab4: not exact for a quartic slope");

    iso_adams_bashforth broken = iso_table_ab4;
    broken.b[2]++;
    tap_ok(!moment_holds(&broken, 0), "a wrong Adams-Bashforth weight is noticed");
}

int main(void)
{
    test_tables();
    test_broken_tables();
    test_adams_bashforth();
    tap_done();
}
