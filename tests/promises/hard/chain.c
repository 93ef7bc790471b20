#include "tests/promises/hard/chain.h"

#include <math.h>

#include "core/numbers/sincos.h"

/* What the equations and their Jacobian share: angles between rods, the tensions, the factors of their system. */
typedef struct chain {
    real sine_first, cosine_first;
    real d[CHAIN_LINKS_MAX]; /* D_i, C_i; zero for the last */
    real c[CHAIN_LINKS_MAX];
    real t[CHAIN_LINKS_MAX];
    real below[CHAIN_LINKS_MAX]; /* L has these under its diagonal of ones */
    real over[CHAIN_LINKS_MAX];  /* the inverse of D in L D L' */
} chain;

/* Solves the tensions' system in place. Golub and Van Loan (2013), Matrix Computations, algorithm 4.3.6. */
static void solve_tensions(const chain *const ch, real *const b, const size_t links)
{
    for (size_t i = 1; i < links; i++) {
        b[i] -= ch->below[i - 1] * b[i - 1];
    }
    b[links - 1] *= ch->over[links - 1];
    for (size_t i = links - 1; i-- > 0;) {
        b[i] = b[i] * ch->over[i] - ch->below[i] * b[i + 1];
    }
}

static void set_up(chain *const ch, const real *const x, const real *const p, const size_t links)
{
    const real *const w = p + CHAIN_INVERSE_MASSES;
    real sine = R(0.0);
    real cosine = R(0.0);
    for (size_t i = 0; i < links; i++) {
        const iso_sine_cosine q = iso_sincos(x[i]);
        if (i == 0) {
            ch->sine_first = q.sin;
            ch->cosine_first = q.cos;
        } else {
            ch->d[i - 1] = q.sin * cosine - q.cos * sine;
            ch->c[i - 1] = q.cos * cosine + q.sin * sine;
        }
        sine = q.sin;
        cosine = q.cos;
        ch->t[i] = p[CHAIN_LENGTH] * x[links + i] * x[links + i];
    }
    ch->t[0] += p[CHAIN_GRAVITY] * ch->cosine_first;
    ch->d[links - 1] = ch->c[links - 1] = R(0.0);

    real diagonal = w[0];
    for (size_t i = 0; i < links; i++) {
        ch->over[i] = R(1.0) / diagonal;
        ch->below[i] = -w[i] * ch->c[i] * ch->over[i];
        diagonal = i + 1 < links ? w[i + 1] + w[i] + ch->below[i] * w[i] * ch->c[i] : R(1.0);
    }
    solve_tensions(ch, ch->t, links);
}

static void derive(real *const dx, const real *const x, const real *const p, const size_t links)
{
    const real *const w = p + CHAIN_INVERSE_MASSES;
    chain ch;
    set_up(&ch, x, p, links);
    for (size_t i = 0; i < links; i++) {
        const real below = i + 1 < links ? w[i] * ch.d[i] * ch.t[i + 1] : R(0.0);
        const real above = i > 0 ? w[i - 1] * ch.d[i - 1] * ch.t[i - 1] : p[CHAIN_GRAVITY] * ch.sine_first;
        dx[i] = x[links + i];
        dx[links + i] = (below - above) / p[CHAIN_LENGTH];
    }
}

/* What the change of dC_i and dD_i with q_k leaves on the right-hand side of the tensions' system: db - dA T. */
static void tension_rates(const chain *const ch, real *const r, const real *const x, const real *const p,
                          const size_t k, const size_t links)
{
    const real *const w = p + CHAIN_INVERSE_MASSES;
    memset(r, 0, links * sizeof *r);
    if (k >= links) {
        r[k - links] = R(2.0) * p[CHAIN_LENGTH] * x[k];
        return;
    }
    if (k == 0) {
        r[0] -= p[CHAIN_GRAVITY] * ch->sine_first;
    } else { /* dC_(k-1)/dq_k = -D_(k-1) */
        r[k - 1] -= w[k - 1] * ch->d[k - 1] * ch->t[k];
        r[k] -= w[k - 1] * ch->d[k - 1] * ch->t[k - 1];
    }
    if (k + 1 < links) { /* dC_k/dq_k = D_k */
        r[k] += w[k] * ch->d[k] * ch->t[k + 1];
        r[k + 1] += w[k] * ch->d[k] * ch->t[k];
    }
}

/* The column of state k: differences of the equations above. */
static void column(const chain *const ch, real *const a, const real *const x, const real *const p, const size_t k,
                   const size_t links)
{
    const real *const w = p + CHAIN_INVERSE_MASSES;
    const size_t n = 2 * links;
    real t[CHAIN_LINKS_MAX];
    tension_rates(ch, t, x, p, k, links);
    solve_tensions(ch, t, links);
    for (size_t i = 0; i < links; i++) {
        /* dD_i/dq_(i+1) = C_i = -dD_i/dq_i */
        const real turn_below = k == i + 1 ? ch->c[i] : (k == i ? -ch->c[i] : R(0.0));
        const real turn_above = i > 0 ? (k == i ? ch->c[i - 1] : (k == i - 1 ? -ch->c[i - 1] : R(0.0))) : R(0.0);
        real rate = R(0.0);
        if (i + 1 < links) {
            rate += w[i] * (ch->d[i] * t[i + 1] + turn_below * ch->t[i + 1]);
        }
        if (i > 0) {
            rate -= w[i - 1] * (ch->d[i - 1] * t[i - 1] + turn_above * ch->t[i - 1]);
        } else if (k == 0) {
            rate -= p[CHAIN_GRAVITY] * ch->cosine_first;
        }
        a[i * n + k] = k == links + i ? R(1.0) : R(0.0);
        a[(links + i) * n + k] = rate / p[CHAIN_LENGTH];
    }
}

static void factorise(real *const lu, const real *const x, const real *const p, const real hb, const size_t links)
{
    chain ch;
    set_up(&ch, x, p, links);
    for (size_t k = 0; k < 2 * links; k++) {
        column(&ch, lu, x, p, k, links);
    }
    iso_dense_factor(lu, 2 * links, hb);
}

/* The number of links, which the equations do not carry, is part of their names. */
#define CHAIN_OF(links)                                                                                                \
    static void derivative_##links(real *restrict const dx, const real *restrict const x,                              \
                                   const real *restrict const u, const real *restrict const p)                         \
    {                                                                                                                  \
        (void)u;                                                                                                       \
        derive(dx, x, p, links);                                                                                       \
    }                                                                                                                  \
    static void factor_##links(real *restrict const lu, const real *restrict const x, const real *restrict const u,    \
                               const real *restrict const p, const real hb)                                            \
    {                                                                                                                  \
        (void)u;                                                                                                       \
        factorise(lu, x, p, hb, links);                                                                                \
    }                                                                                                                  \
    static void solve_##links(real *restrict const d, const real *restrict const lu)                                   \
    {                                                                                                                  \
        iso_dense_solve(d, lu, 2 * links);                                                                             \
    }                                                                                                                  \
    const iso_equations chain_of_##links = {derivative_##links, factor_##links, solve_##links,                         \
                                            .factors = 4 * links * links};

CHAIN_OF(1)
CHAIN_OF(2)
CHAIN_OF(3)
CHAIN_OF(10)

double chain_energy(const hard_run *const run)
{
    const size_t links = run->problem->n / 2;
    const double g = (double)run->problem->p[CHAIN_GRAVITY];
    const double l = (double)run->problem->p[CHAIN_LENGTH];
    double energy = 0.0;
    double vx = 0.0;
    double vy = 0.0;
    double height = 0.0;
    for (size_t i = 0; i < links; i++) {
        const double m = 1.0 / (double)run->problem->p[CHAIN_INVERSE_MASSES + i];
        const double q = (double)run->x[i];
        const double rate = (double)run->x[links + i];
        vx += l * rate * cos(q);
        vy += l * rate * sin(q);
        height += l * (1.0 - cos(q));
        energy += m * (0.5 * (vx * vx + vy * vy) + g * height);
    }
    return energy;
}
