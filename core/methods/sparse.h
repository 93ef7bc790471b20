/* Factors of a sparse matrix by loops over constant tables of its places, for a plant whose unrolled elimination would
 * be long. The order of the elimination and its fill-in are known beforehand, there is no pivot search, and no loop or
 * index depends on a real: time and order of operations do not depend on data. */
#ifndef ISO_CORE_METHODS_SPARSE_H
#define ISO_CORE_METHODS_SPARSE_H

#include <stddef.h>

#include "core/numbers/real.h"

/* Where the numbers of L U stand, row by row, from left to right; unknowns are in the order of their elimination. */
typedef struct iso_sparse {
    size_t unknowns;
    size_t states;
    const uint32_t *row;       /* [unknowns + 1] where a row begins */
    const uint32_t *beyond;    /* [unknowns] the begin of the entries beyond its diagonal */
    const uint16_t *column;    /* [row[unknowns]] */
    const uint16_t *target;    /* where in its row each product of the factorisation goes, in their order */
    const uint16_t *right_row; /* [states] the row that has the right side of a state */
    const uint16_t *found;     /* [states] the unknown that a state is */
} iso_sparse;

/* Turns lu[row[unknowns]], the matrix with zeros where it fills in, into its factors; L has ones on its diagonal, that
 * of U is kept inverted. Row by row, each less multiples of those before it: Duff, Erisman, Reid (1986), Direct Methods
 * for Sparse Matrices, section 10.5. */
static inline void iso_sparse_factor(const iso_sparse *const s, real *const lu)
{
    const uint16_t *target = s->target;
    for (size_t i = 0; i < s->unknowns; i++) {
        const uint16_t *const column = s->column + s->row[i];
        real *const row = lu + s->row[i];
        const size_t diagonal = s->beyond[i] - 1 - s->row[i];
        for (size_t at = 0; at < diagonal; at++) {
            const size_t k = column[at];
            const real *const beyond = lu + s->beyond[k];
            const size_t count = s->row[k + 1] - s->beyond[k];
            const real factor = row[at] * beyond[-1];
            row[at] = factor;
            for (size_t j = 0; j < count; j++) {
                row[target[j]] -= factor * beyond[j];
            }
            target += count;
        }
        row[diagonal] = R(1.0) / row[diagonal];
    }
}

/* Solves in place for the states d[states]; w[unknowns] is work space. */
static inline void iso_sparse_solve(const iso_sparse *const s, real *const d, const real *const lu, real *const w)
{
    for (size_t i = 0; i < s->unknowns; i++) {
        w[i] = R(0.0);
    }
    for (size_t i = 0; i < s->states; i++) {
        w[s->right_row[i]] = d[i];
    }
    for (size_t i = 0; i < s->unknowns; i++) {
        real sum = w[i];
        for (uint32_t at = s->row[i]; at + 1 < s->beyond[i]; at++) {
            sum -= lu[at] * w[s->column[at]];
        }
        w[i] = sum;
    }
    for (size_t i = s->unknowns; i-- > 0;) {
        real sum = w[i];
        for (uint32_t at = s->beyond[i]; at < s->row[i + 1]; at++) {
            sum -= lu[at] * w[s->column[at]];
        }
        w[i] = sum * lu[s->beyond[i] - 1];
    }
    for (size_t i = 0; i < s->states; i++) {
        d[i] = w[s->found[i]];
    }
}

#endif
