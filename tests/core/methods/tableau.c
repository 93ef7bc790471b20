/* The tables of the methods: the order conditions of every table, exact in whole numbers.
 *
 * Hairer, Norsett, Wanner (1993), Solving Ordinary Differential Equations I, table II.2.1 (the rooted trees to order
 * five) and III.1 (the moments of the Adams methods).
 */
#include "core/methods/all.h"
#include "core/methods/method.h"
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
        const int64_t before = s.a_over;
        while (s.a_over % t->a_over[i] != 0) {
            s.a_over += before;
        }
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

/* The highest order, at most five, whose conditions and those below it the table meets. */
static unsigned order_of(const iso_tableau *const t)
{
    const scaled s = scale(t);
    int64_t one[ISO_STAGES_MAX], c2[ISO_STAGES_MAX], c3[ISO_STAGES_MAX];
    int64_t ac[ISO_STAGES_MAX], cac[ISO_STAGES_MAX], ac2[ISO_STAGES_MAX], aac[ISO_STAGES_MAX];
    int64_t c4[ISO_STAGES_MAX], c2ac[ISO_STAGES_MAX], cac2[ISO_STAGES_MAX], caac[ISO_STAGES_MAX], acac[ISO_STAGES_MAX];
    int64_t ac3[ISO_STAGES_MAX], ac_square[ISO_STAGES_MAX], aac2[ISO_STAGES_MAX], aaac[ISO_STAGES_MAX];

    multiply(ac, &s, s.c);
    multiply(aac, &s, ac);
    for (unsigned i = 0; i < ISO_STAGES_MAX; i++) {
        one[i] = 1;
        c2[i] = s.c[i] * s.c[i];
        c3[i] = c2[i] * s.c[i];
        cac[i] = s.c[i] * ac[i];
    }
    multiply(ac2, &s, c2);
    multiply(ac3, &s, c3);
    multiply(acac, &s, cac);
    multiply(aac2, &s, ac2);
    multiply(aaac, &s, aac);
    for (unsigned i = 0; i < ISO_STAGES_MAX; i++) {
        c4[i] = c3[i] * s.c[i];
        c2ac[i] = c2[i] * ac[i];
        cac2[i] = s.c[i] * ac2[i];
        caac[i] = s.c[i] * aac[i];
        ac_square[i] = ac[i] * ac[i];
    }

    const bool met[] = {
        holds(t, &s, one, 1, 0),
        holds(t, &s, s.c, 2, 1),
        holds(t, &s, c2, 3, 2) && holds(t, &s, ac, 6, 2),
        holds(t, &s, c3, 4, 3) && holds(t, &s, cac, 8, 3) && holds(t, &s, ac2, 12, 3) && holds(t, &s, aac, 24, 3),
        holds(t, &s, c4, 5, 4) && holds(t, &s, c2ac, 10, 4) && holds(t, &s, cac2, 15, 4) && holds(t, &s, caac, 30, 4) &&
            holds(t, &s, ac_square, 20, 4) && holds(t, &s, ac3, 20, 4) && holds(t, &s, acac, 40, 4) &&
            holds(t, &s, aac2, 60, 4) && holds(t, &s, aaac, 120, 4),
    };
    unsigned order = 0;
    while (order < 5 && met[order]) {
        order++;
    }
    return order;
}

/* Stage i uses derivatives before i only, and the fields beyond the stages are empty. */
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

/* The explicit methods of one step: by the columns of each. */
typedef struct method_row {
    const char *name;
    const iso_tableau *table;
    unsigned order, stages;
} method_row;

#define ROW(r, m, name) {#name, m##_TABLEAU, m##_ORDER(r), m##_STAGES(r)},
static const method_row method_rows[] = {ISO_METHOD_LIST(ROW, 0)};

static void test_tables(void)
{
    for (unsigned i = 0; i < ISO_METHODS; i++) {
        const iso_tableau *const t = method_rows[i].table;
        if (t != NULL) {
            tap_count(order_of(t), method_rows[i].order, method_rows[i].name);
            tap_ok(t->order == method_rows[i].order && t->stages == method_rows[i].stages,
                   "its columns are those of its table");
            tap_ok(is_explicit(t), "it is strictly lower triangular");
        } else {
            tap_ok(method_rows[i].stages == 0, method_rows[i].name);
        }
    }
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
    tap_count(order_of(&t), 2, "a third stage from the first derivative leaves order 2");
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

/* (m + 1) sum_j b_j t_j^m against over, with derivatives at t = first, first - 1, ...: what the formula gives for the
 * derivative (m + 1) t^m, whose integral from 0 to 1 is 1. Times `over`, so that it is whole; zero where the formula is
 * exact. */
static int64_t adams_defect(const iso_adams *const t, const int first, const int64_t m)
{
    int64_t sum = 0;
    for (int j = 0; j < ISO_ADAMS_DERIVATIVES; j++) {
        int64_t power = 1;
        for (int64_t i = 0; i < m; i++) {
            power *= first - j;
        }
        sum += t->b[j] * power;
    }
    return t->over - (m + 1) * sum;
}

/* The highest order, at most six: the formula is exact for derivatives of the degrees below. */
static unsigned adams_order(const iso_adams *const t, const int first)
{
    unsigned order = 0;
    while (order < 6 && adams_defect(t, first, order) == 0) {
        order++;
    }
    return order;
}

enum { FROM_START = 0, FROM_END = 1 };

static void test_adams(void)
{
    tap_count(adams_order(&iso_table_ab4, FROM_START), 4, "ab4: order 4");
    tap_count(adams_order(&iso_table_am[0], FROM_END), 1, "am, no derivative of before: order 1");
    tap_count(adams_order(&iso_table_am[1], FROM_END), 2, "am, one derivative of before: order 2");
    tap_count(adams_order(&iso_table_am[2], FROM_END), 3, "am, two derivatives of before: order 3");
    tap_count(adams_order(&iso_table_am[3], FROM_END), 4, "am, three derivatives of before: order 4");
    tap_count(adams_order(&iso_table_am[4], FROM_END), 5, "am, four derivatives of before: order 5");

    tap_count(adams_order(&iso_table_am[5], FROM_END), 6, "am, five derivatives of before: order 6");

    bool empty = iso_table_ab4.b[4] == 0 && iso_table_ab4.b[5] == 0;
    bool alternate = true;
    for (int j = 0; j < ISO_ADAMS_DERIVATIVES; j++) {
        alternate = alternate && iso_table_ab4.b[j] * (j % 2 == 0 ? 1 : -1) >= 0;
        for (int row = 0; row < ISO_ADAMS_DERIVATIVES && j > 0; row++) {
            alternate = alternate && iso_table_am[row].b[j] * (j % 2 == 0 ? -1 : 1) >= 0;
        }
    }
    tap_ok(alternate, "Adams: the weights of the derivatives before the end of a step alternate in sign");
    for (int row = 0; row < ISO_ADAMS_DERIVATIVES; row++) {
        for (int j = row + 1; j < ISO_ADAMS_DERIVATIVES; j++) {
            empty = empty && iso_table_am[row].b[j] == 0;
        }
    }
    tap_ok(empty, "Adams: no weight beyond the derivatives that a formula has");

    iso_adams broken = iso_table_ab4;
    broken.b[2]++;
    tap_count(adams_order(&broken, FROM_START), 0, "a wrong Adams-Bashforth weight is noticed");
    broken = iso_table_am[3];
    broken.b[0]++;
    broken.b[1]--;
    tap_count(adams_order(&broken, FROM_END), 1, "a weight moved to the next derivative leaves order 1");
    tap_count(adams_order(&iso_table_am[3], FROM_START), 1,
              "an implicit formula taken for an explicit one has order 1");
}

/* The error of a formula of order p is C h^(p+1) x^(p+1), with C = defect / (over (p+1)!) (Hairer, Norsett, Wanner
 * 1993, III.2). Milne's weight is -C_am / (C_ab - C_am): of the difference of the two, the corrector's part. */
static bool milne_holds(const iso_adams *const weight)
{
    const int64_t am = -adams_defect(&iso_table_am[3], FROM_END, 4) * iso_table_ab4.over;
    const int64_t ab = adams_defect(&iso_table_ab4, FROM_START, 4) * iso_table_am[3].over;
    return am > 0 && weight->b[0] * (ab + am) == am * weight->over;
}

static void test_milne(void)
{
    /* 5! C over = 1004 for C = 251/720 and -76 for C = -19/720, both with over = 24. */
    tap_ok(adams_defect(&iso_table_ab4, FROM_START, 4) == 1004, "ab4: error constant 251/720");
    tap_ok(adams_defect(&iso_table_am[3], FROM_END, 4) == -76, "am of order four: error constant -19/720");
    tap_ok(milne_holds(&iso_table_milne), "Milne: 19/270 of the difference");
    const iso_adams broken = {.b = {1}, .over = 14};
    tap_ok(!milne_holds(&broken), "a wrong Milne weight is noticed");
}

/* x = t^m at t = 1, 0, -1, -2, -3, -4 with h = 1. */
static int64_t power_of(const int t, const int m)
{
    int64_t power = 1;
    for (int i = 0; i < m; i++) {
        power *= t;
    }
    return power;
}

/* over (dx - dx of the formula) for x = t^m from t = 0 to 1, the increments before known. */
static int64_t bdf_defect(const iso_bdf *const t, const int m)
{
    int64_t sum = t->over * (power_of(1, m) - power_of(0, m)) - t->derivative * m;
    for (int j = 0; j < ISO_BDF4_STEPS - 1; j++) {
        sum -= t->b[j] * (power_of(-j, m) - power_of(-j - 1, m));
    }
    return sum;
}

/* dx - dx of the predictor, likewise. */
static int64_t predictor_defect(const iso_bdf *const t, const int m)
{
    int64_t sum = power_of(1, m) - power_of(0, m);
    for (int j = 0; j < ISO_BDF4_STEPS; j++) {
        sum -= t->predictor[j] * (power_of(-j, m) - power_of(-j - 1, m));
    }
    return sum;
}

/* The highest degree, at most five, up to which all defects are zero. */
static int degree_of(const iso_bdf *const t, int64_t (*const defect)(const iso_bdf *t, int m))
{
    int degree = 0;
    while (degree < 5 && defect(t, degree + 1) == 0) {
        degree++;
    }
    return degree;
}

static void test_bdf4(void)
{
    const iso_bdf *const t = &iso_table_bdf4;
    tap_count((uint32_t)degree_of(t, bdf_defect), 4, "bdf4: order 4");
    tap_count((uint32_t)degree_of(t, predictor_defect), 4, "bdf4: the predictor continues degree 4");
    /* 5! C = -288/25 for C = -12/125, and 120 for C = 1: the corrector's part of their difference is 12/137. */
    tap_ok(bdf_defect(t, 5) == -288 && t->over == 25, "bdf4: error constant -12/125");
    tap_ok(predictor_defect(t, 5) == 120, "bdf4: the predictor's error constant 1");

    /* 1/25 (48 y - 36 y[-1] + 16 y[-2] - 3 y[-3]) - y in increments: partial sums of the coefficients. */
    tap_ok(t->b[0] == 48 - t->over && t->b[1] == 48 - 36 - t->over && t->b[2] == 48 - 36 + 16 - t->over,
           "bdf4: the increments' weights are those of the states");

    iso_bdf broken = *t;
    broken.b[1]++;
    tap_count((uint32_t)degree_of(&broken, bdf_defect), 0, "a wrong bdf4 weight is noticed");
    broken = *t;
    broken.derivative++;
    tap_count((uint32_t)degree_of(&broken, bdf_defect), 0, "a wrong bdf4 derivative is noticed");
    broken = *t;
    broken.predictor[3]++;
    tap_count((uint32_t)degree_of(&broken, predictor_defect), 0, "a wrong bdf4 predictor is noticed");
}

enum { STAGES = ISO_ROSENBROCK_STAGES };

/* v = a w. */
static void apply(real v[STAGES], real a[STAGES][STAGES], const real w[STAGES])
{
    for (unsigned i = 0; i < STAGES; i++) {
        v[i] = R(0.0);
        for (unsigned j = 0; j < STAGES; j++) {
            v[i] += a[i][j] * w[j];
        }
    }
}

/* a b, of lower triangular matrices. */
static void product(real ab[STAGES][STAGES], real a[STAGES][STAGES], real b[STAGES][STAGES])
{
    for (unsigned i = 0; i < STAGES; i++) {
        for (unsigned j = 0; j < STAGES; j++) {
            ab[i][j] = R(0.0);
            for (unsigned k = 0; k < STAGES; k++) {
                ab[i][j] += a[i][k] * b[k][j];
            }
        }
    }
}

enum { CONDITIONS = 4 };

/* The left sides of the order conditions to order three, sum b_i = 1, sum b_i beta_i = 1/2, sum b_i alpha_i^2 = 1/3,
 * sum b_i beta_ij beta_j = 1/6 (Hairer and Wanner 1996, table IV.7.1, with beta_ij = alpha_ij + gamma_ij and gamma_ii
 * in it), from the coefficients that a step uses: (gamma_ij) = (1/gamma - c)^-1 = gamma (1 + gamma c + gamma^2 c c),
 * alpha = a (gamma_ij), b = m (gamma_ij). */
static void left_sides(const iso_rosenbrock *const t, real left[CONDITIONS])
{
    real a[STAGES][STAGES] = {{R(0.0)}, {t->a21}, {t->a21}};
    real c[STAGES][STAGES] = {{R(0.0)}, {t->c21}, {t->c31, t->c32}};
    real gamma[STAGES][STAGES], alpha[STAGES][STAGES], beta[STAGES][STAGES];
    real b[STAGES] = {R(0.0)}, alpha2[STAGES], beta1[STAGES], beta2[STAGES];
    const real one[STAGES] = {R(1.0), R(1.0), R(1.0)};

    product(gamma, c, c);
    for (unsigned i = 0; i < STAGES; i++) {
        for (unsigned j = 0; j < STAGES; j++) {
            gamma[i][j] = t->gamma * (t->gamma * (c[i][j] + t->gamma * gamma[i][j]) + (i == j ? R(1.0) : R(0.0)));
        }
    }
    product(alpha, a, gamma);
    for (unsigned j = 0; j < STAGES; j++) {
        for (unsigned i = 0; i < STAGES; i++) {
            b[j] += t->m[i] * gamma[i][j];
            beta[i][j] = alpha[i][j] + gamma[i][j];
        }
    }
    apply(alpha2, alpha, one);
    apply(beta1, beta, one);
    apply(beta2, beta, beta1);
    for (unsigned k = 0; k < CONDITIONS; k++) {
        left[k] = R(0.0);
    }
    for (unsigned i = 0; i < STAGES; i++) {
        left[0] += b[i];
        left[1] += b[i] * beta1[i];
        left[2] += b[i] * (alpha2[i] * alpha2[i]);
        left[3] += b[i] * beta2[i];
    }
}

/* Roundings on the way from the exact coefficients to a term of a left side, at most: those of three gamma and two c in
 * gamma_ij and of 5 operations, 10; of b_i 14, of beta_ij 15, of beta_j 17; two products and two sums. */
enum { ROSENBROCK_ROUNDINGS = 14 + 15 + 17 + 4 };

/* The same sums with every sign positive bound the sizes of all terms, and half an epsilon of them is one rounding. */
static unsigned rosenbrock_order(const iso_rosenbrock *const t)
{
    static const real right[CONDITIONS] = {R(1.0), R(1.0) / R(2.0), R(1.0) / R(3.0), R(1.0) / R(6.0)};
    const iso_rosenbrock positive = {
        .gamma = iso_abs(t->gamma),
        .a21 = iso_abs(t->a21),
        .c21 = iso_abs(t->c21),
        .c31 = iso_abs(t->c31),
        .c32 = iso_abs(t->c32),
        .m = {iso_abs(t->m[0]), iso_abs(t->m[1]), iso_abs(t->m[2])},
    };
    real left[CONDITIONS], size[CONDITIONS];
    bool met[CONDITIONS];
    left_sides(t, left);
    left_sides(&positive, size);
    for (unsigned k = 0; k < CONDITIONS; k++) {
        met[k] = iso_abs(left[k] - right[k]) <= R(0.5) * ISO_REAL_EPSILON * (real)ROSENBROCK_ROUNDINGS * size[k];
    }
    return !met[0] ? 0 : (!met[1] ? 1 : (!met[2] || !met[3] ? 2 : 3));
}

/* R(infinity) = 1 + sum_i m_i k_i, where every stage of x' = lambda x tends to k_i = -(1 + sum_j a_ij k_j). */
static real at_infinity(const iso_rosenbrock *const t)
{
    const real k1 = R(-1.0);
    const real k2 = -(R(1.0) + t->a21 * k1);
    const real k3 = -(R(1.0) + t->a21 * k1);
    return R(1.0) + (t->m[0] * k1 + t->m[1] * k2 + t->m[2] * k3);
}

static void test_rosenbrock(void)
{
    const iso_rosenbrock *const t = &iso_table_ros3;
    tap_count(rosenbrock_order(t), 3, "ros3: order 3");
    tap_same(at_infinity(t), R(0.0), "ros3: R(infinity) = 0");
    /* The one L-stable of order three: a root of 6 g^3 - 18 g^2 + 9 g - 1 (Hairer and Wanner 1996, table IV.6.4). Half
     * an ulp of each value on the way, and of g times the derivative there, 3.3: 3.2 epsilons in all. */
    const real cubic = ((R(6.0) * t->gamma - R(18.0)) * t->gamma + R(9.0)) * t->gamma - R(1.0);
    tap_ok(iso_abs(cubic) <= R(4.0) * ISO_REAL_EPSILON, "ros3: gamma is the one of an L-stable method");

    iso_rosenbrock broken = *t;
    broken.gamma += R(0.001);
    tap_ok(rosenbrock_order(&broken) < 3, "a wrong gamma is noticed");
    broken = *t;
    broken.c21 += R(0.001);
    tap_ok(rosenbrock_order(&broken) < 3, "a wrong c21 is noticed");
    broken = *t;
    broken.c31 += R(0.001);
    tap_ok(rosenbrock_order(&broken) < 3, "a wrong c31 is noticed");
    broken = *t;
    broken.c32 += R(0.001);
    tap_ok(rosenbrock_order(&broken) < 3, "a wrong c32 is noticed");
    broken = *t;
    broken.m[1] += R(0.001);
    tap_ok(rosenbrock_order(&broken) < 3, "a wrong weight is noticed");
    broken = *t;
    broken.m[0] += R(0.001);
    tap_ok(rosenbrock_order(&broken) < 3 && at_infinity(&broken) != R(0.0), "a wrong first weight is noticed");
    broken = *t;
    broken.a21 += R(0.001);
    tap_ok(rosenbrock_order(&broken) < 3 && at_infinity(&broken) != R(0.0), "a wrong a21 is noticed");
}

int main(void)
{
    test_tables();
    test_broken_tables();
    test_adams();
    test_milne();
    test_bdf4();
    test_rosenbrock();
    tap_done();
}
