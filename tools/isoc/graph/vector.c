#include "tools/isoc/graph/vector.h"

#include <float.h>
#include <math.h>

vector vector_of(graph *g, double x, double y, double z)
{
    return (vector){{constant(g, x), constant(g, y), constant(g, z)}};
}

vector vector_zero(graph *g)
{
    return vector_of(g, 0.0, 0.0, 0.0);
}

vector vector_add(graph *g, vector a, vector b)
{
    for (int i = 0; i < 3; i++) {
        a.at[i] = add(g, a.at[i], b.at[i]);
    }
    return a;
}

vector vector_sub(graph *g, vector a, vector b)
{
    for (int i = 0; i < 3; i++) {
        a.at[i] = sub(g, a.at[i], b.at[i]);
    }
    return a;
}

vector vector_scale(graph *g, node s, vector a)
{
    for (int i = 0; i < 3; i++) {
        a.at[i] = mul(g, s, a.at[i]);
    }
    return a;
}

vector vector_cross(graph *g, vector a, vector b)
{
    vector r;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        r.at[i] = difference_of_products(g, a.at[j], b.at[k], a.at[k], b.at[j]);
    }
    return r;
}

node vector_dot(graph *g, vector a, vector b)
{
    const node xy = sum_of_products(g, a.at[0], b.at[0], a.at[1], b.at[1]);
    return add(g, xy, mul(g, a.at[2], b.at[2]));
}

vector vector_name(graph *g, vector a, const char *quantity, const char *owner)
{
    for (int i = 0; i < 3; i++) {
        graph_name(g, a.at[i], "%s_%s_%c", quantity, owner, "xyz"[i]);
    }
    return a;
}

bool vector_is_constant(const graph *g, vector a)
{
    return is_constant(g, a.at[0]) && is_constant(g, a.at[1]) && is_constant(g, a.at[2]);
}

matrix matrix_identity(graph *g)
{
    matrix r;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            r.at[i][j] = constant(g, i == j ? 1.0 : 0.0);
        }
    }
    return r;
}

matrix matrix_product(graph *g, matrix a, matrix b)
{
    matrix r;
    for (int j = 0; j < 3; j++) {
        const vector image = matrix_apply(g, a, matrix_column(b, j));
        for (int i = 0; i < 3; i++) {
            r.at[i][j] = image.at[i];
        }
    }
    return r;
}

matrix matrix_transpose(matrix a)
{
    matrix r;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            r.at[i][j] = a.at[j][i];
        }
    }
    return r;
}

matrix matrix_add(graph *g, matrix a, matrix b)
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            a.at[i][j] = add(g, a.at[i][j], b.at[i][j]);
        }
    }
    return a;
}

vector matrix_apply(graph *g, matrix a, vector b)
{
    vector r;
    for (int i = 0; i < 3; i++) {
        r.at[i] = vector_dot(g, (vector){{a.at[i][0], a.at[i][1], a.at[i][2]}}, b);
    }
    return r;
}

vector matrix_column(matrix a, int column)
{
    return (vector){{a.at[0][column], a.at[1][column], a.at[2][column]}};
}

matrix matrix_snap(graph *g, matrix a)
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            const double value = constant_value(g, a.at[i][j]), whole = round(value);
            if (fabs(value - whole) <= 4 * DBL_EPSILON) {
                a.at[i][j] = constant(g, whole);
            }
        }
    }
    return a;
}

vector turn_out(graph *g, int k, node s, node c, vector a)
{
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    vector r = a;
    r.at[i] = difference_of_products(g, c, a.at[i], s, a.at[j]);
    r.at[j] = sum_of_products(g, s, a.at[i], c, a.at[j]);
    return r;
}

vector turn_in(graph *g, int k, node s, node c, vector a)
{
    return turn_out(g, k, neg(g, s), c, a);
}

static bool is_multiple_of_identity(const graph *g, matrix a)
{
    bool is = a.at[0][0] == a.at[1][1] && a.at[0][0] == a.at[2][2];
    for (int i = 0; i < 3; i++) {
        is = is && is_zero(g, a.at[i][(i + 1) % 3]) && is_zero(g, a.at[i][(i + 2) % 3]);
    }
    return is;
}

matrix matrix_rotate(graph *g, matrix r, matrix a)
{
    return is_multiple_of_identity(g, a) ? a : matrix_product(g, r, matrix_product(g, a, matrix_transpose(r)));
}

/* With i, j, k cyclic and t = s (A_ii - A_jj) + c (A_ij + A_ji), since c^2 + s^2 = 1:
 * A_ii' = A_ii - s t, A_jj' = A_jj + s t, A_ij' = c t - A_ji, A_ji' = c t - A_ij. The axis' own row and column turn
 * like vectors. */
matrix matrix_turn_out(graph *g, int k, node s, node c, matrix a)
{
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const node ii = a.at[i][i], jj = a.at[j][j], ij = a.at[i][j], ji = a.at[j][i];
    const node across = sub(g, ii, jj), both = add(g, ij, ji);
    const node t = sum_of_products(g, s, across, c, both);
    const node st = mul(g, s, t);
    const vector column = turn_out(g, k, s, c, matrix_column(a, k));
    const vector row = turn_out(g, k, s, c, (vector){{a.at[k][0], a.at[k][1], a.at[k][2]}});

    a.at[i][i] = sub(g, ii, st);
    a.at[j][j] = add(g, jj, st);
    const node ct = mul(g, c, t);
    a.at[i][j] = sub(g, ct, ji);
    a.at[j][i] = sub(g, ct, ij);
    for (int n = 0; n < 3; n++) {
        if (n != k) {
            a.at[n][k] = column.at[n];
            a.at[k][n] = row.at[n];
        }
    }
    return a;
}

tensor tensor_zero(graph *g)
{
    const node zero = constant(g, 0.0);
    return (tensor){zero, zero, zero, zero, zero, zero};
}

matrix tensor_matrix(tensor a)
{
    return (matrix){{{a.xx, a.xy, a.xz}, {a.xy, a.yy, a.yz}, {a.xz, a.yz, a.zz}}};
}

tensor matrix_tensor(matrix m)
{
    return (tensor){m.at[0][0], m.at[1][1], m.at[2][2], m.at[0][1], m.at[0][2], m.at[1][2]};
}

tensor tensor_add(graph *g, tensor a, tensor b)
{
    a.xx = add(g, a.xx, b.xx);
    a.yy = add(g, a.yy, b.yy);
    a.zz = add(g, a.zz, b.zz);
    a.xy = add(g, a.xy, b.xy);
    a.xz = add(g, a.xz, b.xz);
    a.yz = add(g, a.yz, b.yz);
    return a;
}

vector tensor_apply(graph *g, tensor a, vector b)
{
    return matrix_apply(g, tensor_matrix(a), b);
}

tensor tensor_rotate(graph *g, matrix r, tensor j)
{
    return matrix_tensor(matrix_rotate(g, r, tensor_matrix(j)));
}

/* The parallel-axis theorem about any point, with ms' = ms + m p the first moment of the moved body:
 * J_ii' = J_ii + sum over j other than i of p_j (ms_j + ms_j'), J_ij' = J_ij - (p_i ms_j + p_j ms_i'). */
tensor tensor_shift(graph *g, tensor j, node mass, vector ms, vector p)
{
    const vector moved = vector_add(g, ms, vector_scale(g, mass, p));
    node on[3];
    for (int i = 0; i < 3; i++) {
        on[i] = mul(g, p.at[i], add(g, ms.at[i], moved.at[i]));
    }
    tensor r;
    r.xx = add(g, on[1], on[2]);
    r.yy = add(g, on[0], on[2]);
    r.zz = add(g, on[0], on[1]);
    r.xy = neg(g, sum_of_products(g, p.at[0], ms.at[1], p.at[1], moved.at[0]));
    r.xz = neg(g, sum_of_products(g, p.at[0], ms.at[2], p.at[2], moved.at[0]));
    r.yz = neg(g, sum_of_products(g, p.at[1], ms.at[2], p.at[2], moved.at[1]));
    return tensor_add(g, j, r);
}
