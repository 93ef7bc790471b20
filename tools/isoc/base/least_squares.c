#include "tools/isoc/base/numbers.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

static const double rank_limit = 1e-10;

static double dot(const double *a, const double *b, int n, int stride)
{
    double sum = 0.0;
    for (int i = 0; i < n; i++) {
        sum += a[i * stride] * b[i * stride];
    }
    return sum;
}

double *product_of_matrices(arena *memory, const double *left, int rows, int inner, const double *right, int columns)
{
    double *result = arena_take(memory, (size_t)(rows * columns) + 1, sizeof *result);
    for (int i = 0; i < rows; i++) {
        for (int k = 0; k < inner; k++) {
            const double factor = left[i * inner + k];
            for (int j = 0; j < columns && factor != 0.0; j++) {
                result[i * columns + j] += factor * right[k * columns + j];
            }
        }
    }
    return result;
}

/* Turns columns p and q by the angle of cosine c and sine s. */
static void turn_columns(double *m, int rows, int columns, int p, int q, double c, double s)
{
    for (int i = 0; i < rows; i++) {
        double *row = m + i * columns;
        const double at_p = row[p], at_q = row[q];
        row[p] = c * at_p - s * at_q;
        row[q] = s * at_p + c * at_q;
    }
}

/* Makes columns p and q of u orthogonal, and turns those of v alike. Returns whether they were not. */
static bool orthogonalise(double *u, double *v, int rows, int columns, int p, int q)
{
    const double pp = dot(u + p, u + p, rows, columns), qq = dot(u + q, u + q, rows, columns);
    const double pq = dot(u + p, u + q, rows, columns);
    if (fabs(pq) <= 1e-16 * sqrt(pp * qq)) {
        return false;
    }
    const double zeta = (qq - pp) / (2.0 * pq);
    const double t = (zeta >= 0.0 ? 1.0 : -1.0) / (fabs(zeta) + sqrt(1.0 + zeta * zeta));
    const double c = 1.0 / sqrt(1.0 + t * t);
    turn_columns(u, rows, columns, p, q, c, c * t);
    turn_columns(v, columns, columns, p, q, c, c * t);
    return true;
}

decomposition decompose(arena *memory, const double *a, int rows, int columns)
{
    enum { SWEEPS = 60 };
    decomposition result = {.rows = rows, .columns = columns};
    double *u = result.u = arena_take(memory, (size_t)(rows * columns) + 1, sizeof *u);
    double *v = result.v = arena_take(memory, (size_t)(columns * columns) + 1, sizeof *v);
    result.value = arena_take(memory, (size_t)columns + 1, sizeof *result.value);
    memcpy(u, a, (size_t)(rows * columns) * sizeof *u);
    for (int i = 0; i < columns; i++) {
        v[i * columns + i] = 1.0;
    }
    bool turned = true;
    for (int sweep = 0; turned && sweep < SWEEPS; sweep++) {
        turned = false;
        for (int p = 0; p < columns; p++) {
            for (int q = p + 1; q < columns; q++) {
                turned = orthogonalise(u, v, rows, columns, p, q) || turned;
            }
        }
    }
    for (int j = 0; j < columns; j++) {
        result.value[j] = sqrt(dot(u + j, u + j, rows, columns));
        result.largest = fmax(result.largest, result.value[j]);
    }
    return result;
}

/* With columns u_j of length sigma_j: x = sum of v_j (u_j . b) / sigma_j^2. */
int least_squares(arena *memory, const double *a, int rows, int columns, const double *b, double *x)
{
    const decomposition result = decompose(memory, a, rows, columns);
    int rank = 0;
    for (int i = 0; i < columns; i++) {
        x[i] = 0.0;
    }
    for (int j = 0; j < columns; j++) {
        const double *u = result.u + j, square = dot(u, u, rows, columns);
        if (square > rank_limit * rank_limit * result.largest * result.largest) {
            double along = 0.0;
            for (int i = 0; i < rows; i++) {
                along += u[i * columns] * b[i];
            }
            for (int i = 0; i < columns; i++) {
                x[i] += result.v[i * columns + j] * along / square;
            }
            rank++;
        }
    }
    return rank;
}
