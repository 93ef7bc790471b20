#include "tools/isoc/vector.h"

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
    const matrix columns = matrix_transpose(b);
    matrix r;
    for (int j = 0; j < 3; j++) {
        const vector column = {{columns.at[j][0], columns.at[j][1], columns.at[j][2]}};
        const vector image = matrix_apply(g, a, column);
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

vector matrix_apply(graph *g, matrix a, vector b)
{
    vector r;
    for (int i = 0; i < 3; i++) {
        r.at[i] = vector_dot(g, (vector){{a.at[i][0], a.at[i][1], a.at[i][2]}}, b);
    }
    return r;
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

tensor tensor_zero(graph *g)
{
    const node zero = constant(g, 0.0);
    return (tensor){zero, zero, zero, zero, zero, zero};
}

static matrix tensor_matrix(tensor a)
{
    return (matrix){{{a.xx, a.xy, a.xz}, {a.xy, a.yy, a.yz}, {a.xz, a.yz, a.zz}}};
}

static tensor matrix_tensor(matrix m)
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
    return matrix_tensor(matrix_product(g, r, matrix_product(g, tensor_matrix(j), matrix_transpose(r))));
}

/* With i, j, k cyclic and t = s (J_ii - J_jj) + 2 c J_ij, since c^2 + s^2 = 1:
 * J_ii' = J_ii - s t, J_jj' = J_jj + s t, J_ij' = c t - J_ij. The axis' own row turns like a vector. */
tensor tensor_turn_out(graph *g, int k, node s, node c, tensor a)
{
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    matrix m = tensor_matrix(a);
    const node ii = m.at[i][i], jj = m.at[j][j], ij = m.at[i][j];
    const node across = sub(g, ii, jj), twice = mul(g, constant(g, 2.0), ij);
    const node t = sum_of_products(g, s, across, c, twice);
    const node st = mul(g, s, t);
    vector axis = {{m.at[k][0], m.at[k][1], m.at[k][2]}};
    axis = turn_out(g, k, s, c, axis);

    m.at[i][i] = sub(g, ii, st);
    m.at[j][j] = add(g, jj, st);
    m.at[i][j] = m.at[j][i] = sub(g, mul(g, c, t), ij);
    m.at[i][k] = m.at[k][i] = axis.at[i];
    m.at[j][k] = m.at[k][j] = axis.at[j];
    return matrix_tensor(m);
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
