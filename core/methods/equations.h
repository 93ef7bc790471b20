/* The equations of motion x' = f(x, u, p) as a method needs them: the derivative, and for implicit methods the solution
 * with its Jacobian. */
#ifndef ISO_CORE_METHODS_EQUATIONS_H
#define ISO_CORE_METHODS_EQUATIONS_H

#include <stdbool.h>
#include <stddef.h>

#include "core/numbers/real.h"

/* dx[states] = f(x[states], u[inputs], p[parameters]). The arrays do not overlap, so that a definition says `restrict`
 * (these types do not: this header is C++ as well); an empty one may be NULL. */
typedef void iso_derivative(real *dx, const real *x, const real *u, const real *p);

/* The same where sines[2 angle_count] has sine and cosine of each of some states. If kept[] is not NULL, it gets the
 * values that the plant keeps for its computations after a step. */
typedef void iso_derivative_by_sines(real *dx, const real *x, const real *u, const real *p, const real *sines,
                                     real *kept);

/* lu[factors] = the factors of 1 - hb J, J[i][j] = df_i/dx_j at x, u, p. */
typedef void iso_factor(real *lu, const real *x, const real *u, const real *p, real hb);

/* The same, and the derivative there, dx[states]: what they have in common is computed once. */
typedef void iso_linearise(real *lu, const real *x, const real *u, const real *p, real hb, real *dx);

/* d[states] = (1 - hb J)^-1 d, from the factors lu. */
typedef void iso_solve(real *d, const real *lu);

/* The equations of motion as a method needs them. */
typedef struct iso_equations {
    iso_derivative *derivative;
    iso_factor *factor; /* these four for implicit methods only */
    iso_solve *solve;
    size_t factors;
    iso_linearise *linearise; /* NULL: `derivative`, then `factor` */
    iso_derivative *prepared; /* for ISO_PREPARED: the derivative at the states of the memory, behind whose history
                                 stand the values of them that it needs, sines first */
    iso_derivative *rates;    /* dx[positions] alone, for semi_implicit only; NULL where they are the speeds in order */
    size_t positions;         /* how many of the states are positions, which come first, where `rates` is given */
    const struct iso_adams_options *adams; /* for adams only; NULL for the defaults */
    /* Where inputs are smooth (core/methods/inputs.h): */
    size_t held;        /* reals of u */
    size_t inputs;      /* of them, which come first */
    const bool *smooth; /* [inputs] which are smooth */
    bool curved;        /* for rosenbrock: whether the derivative is not affine in them */
    /* For explicit methods of several stages: */
    iso_derivative_by_sines *by_sines; /* `derivative`, with the sines of a stage */
    const bool *steady;                /* [states] whose derivative is one number throughout a step; NULL: none */
    const uint16_t *angles;            /* [angle_count] the states whose sines these are; NULL: the first ones */
    size_t angle_count;                /* 0: there is none */
    const bool *spins;                 /* [angle_count] which may turn far in a step; NULL: none */
    size_t unread;                     /* of the first states `by_sines` reads only the sines: so many states */
    size_t kept;                       /* reals that the last stage keeps, behind its sines: iso_method_end_sines */
} iso_equations;

#endif
