#include "tools/isoc/graph/vector.h"

#include <math.h>
#include <string.h>

/* The sum of four products, with signs. */
static node products(graph *g, const node a[4], const node b[4], const int signs[4])
{
    node sum = constant(g, 0.0);
    for (int i = 0; i < 4; i++) {
        const node product = mul(g, a[i], b[i]);
        sum = signs[i] > 0 ? add(g, sum, product) : sub(g, sum, product);
    }
    return sum;
}

/* |q|^2 */
static node square_of(graph *g, const node q[4])
{
    static const int plus[4] = {1, 1, 1, 1};
    return graph_name(g, products(g, q, q, plus), "norm");
}

/* R_ii = 1 - s (q_j^2 + q_k^2), R_ij = s (q_i q_j - w q_k), R_ji = s (q_i q_j + w q_k), for i, j, k cyclic. */
static matrix matrix_scaled(graph *g, const node q[4], node s)
{
    const node one = constant(g, 1.0);
    matrix r;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const node qi = q[1 + i], qj = q[1 + j], qk = q[1 + k];
        const node square_j = mul(g, qj, qj), square_k = mul(g, qk, qk);
        r.at[i][i] = sub(g, one, mul(g, s, add(g, square_j, square_k)));
        const node across = mul(g, qi, qj), turned = mul(g, q[0], qk);
        r.at[i][j] = mul(g, s, sub(g, across, turned));
        r.at[j][i] = mul(g, s, add(g, across, turned));
    }
    return r;
}

matrix quaternion_matrix(graph *g, const node q[4])
{
    return matrix_scaled(g, q, constant(g, 2.0));
}

/* 2 / |q|^2 = 4 - 2 |q|^2 to first order. */
matrix quaternion_matrix_of_any(graph *g, const node q[4])
{
    const node doubled = mul(g, constant(g, 2.0), square_of(g, q));
    return matrix_scaled(g, q, sub(g, constant(g, 4.0), doubled));
}

/* (ab)_w = w w - x x - y y - z z, (ab)_x = x w + w x - z y + y z, and so on, round. */
void quaternion_product(graph *g, const node a[4], const node b[4], node product[4])
{
    static const struct {
        int index[4], signs[4];
    } rows[4] = {
        {{0, 1, 2, 3}, {1, -1, -1, -1}},
        {{1, 0, 3, 2}, {1, 1, -1, 1}},
        {{2, 3, 0, 1}, {1, 1, 1, -1}},
        {{3, 2, 1, 0}, {1, -1, 1, 1}},
    };
    node result[4];
    for (int i = 0; i < 4; i++) {
        node factors[4];
        for (int j = 0; j < 4; j++) {
            factors[j] = a[rows[i].index[j]];
        }
        result[i] = products(g, factors, b, rows[i].signs);
    }
    memcpy(product, result, sizeof result);
}

void quaternion_rates(graph *g, const node q[4], const node omega[3], node rates[4])
{
    node half[4] = {constant(g, 0.0)};
    for (int i = 0; i < 3; i++) {
        half[1 + i] = mul(g, constant(g, 0.5), omega[i]);
    }
    quaternion_product(g, q, half, rates);
}

void quaternion_lengthening(graph *g, const node q[4], node change[4])
{
    const node half = constant(g, 0.5), part = sub(g, half, mul(g, half, square_of(g, q)));
    for (int i = 0; i < 4; i++) {
        change[i] = mul(g, q[i], part);
    }
}

void quaternion_normalise(graph *g, const node q[4], node normed[4])
{
    const node square = square_of(g, q);
    const node scale = sub(g, constant(g, 1.5), mul(g, constant(g, 0.5), square));
    for (int i = 0; i < 4; i++) {
        normed[i] = mul(g, q[i], scale);
    }
}

/* From the largest of w, x, y, z, whose square is known from the diagonal. */
void quaternion_of_matrix(double r[3][3], double q[4])
{
    const double squares[4] = {1.0 + r[0][0] + r[1][1] + r[2][2], 1.0 + r[0][0] - r[1][1] - r[2][2],
                               1.0 - r[0][0] + r[1][1] - r[2][2], 1.0 - r[0][0] - r[1][1] + r[2][2]};
    int largest = 0;
    for (int i = 1; i < 4; i++) {
        largest = squares[i] > squares[largest] ? i : largest;
    }
    const double sums[4][4] = {
        {squares[0], r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]},
        {r[2][1] - r[1][2], squares[1], r[0][1] + r[1][0], r[0][2] + r[2][0]},
        {r[0][2] - r[2][0], r[0][1] + r[1][0], squares[2], r[1][2] + r[2][1]},
        {r[1][0] - r[0][1], r[0][2] + r[2][0], r[1][2] + r[2][1], squares[3]},
    };
    for (int i = 0; i < 4; i++) {
        q[i] = 0.5 * sums[largest][i] / sqrt(squares[largest]);
    }
}

void quaternion_of_constant(graph *g, matrix r, node q[4])
{
    double numbers[3][3], components[4];
    for (int i = 0; i < 9; i++) {
        numbers[i / 3][i % 3] = constant_value(g, r.at[i / 3][i % 3]);
    }
    quaternion_of_matrix(numbers, components);
    for (int i = 0; i < 4; i++) {
        q[i] = constant(g, components[i]);
    }
}
