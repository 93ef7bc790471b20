#include "tools/isoc/linear/linear.h"

#include <math.h>

/* --- the coordinates --- */

/* Whether the segment is `root`, or moves with it. */
static bool is_beyond(const mechanism *m, int which, int root)
{
    int at = which;
    while (at != GROUND && at != root) {
        at = m->segments[at].parent;
    }
    return at == root;
}

/* The first body that the segment moves: its own, or one beyond it. */
static const char *body_of(const mechanism *m, const scene *written, arena *memory, int which)
{
    int found = -1;
    for (int i = 0; i < (int)written->bodies.count; i++) {
        const int at = m->bodies.frames[i].segment;
        if (at != GROUND && is_beyond(m, at, which) && (found < 0 || at < m->bodies.frames[found].segment)) {
            found = i;
        }
    }
    return found < 0 ? arena_format(memory, "joint '%s'", m->segments[which].name)
                     : arena_format(memory, "body '%s'", written->bodies.all[found].name.text);
}

static coordinate *add_coordinate(chart *c, const state *origin, int index, int which, const char *whose)
{
    coordinate *result = &c->coordinates[c->all++];
    *result =
        (coordinate){origin->about.name, origin->about.unit, "", whose, index, which, origin->kind == STATE_SPEED};
    return result;
}

static void add_segment_positions(chart *c, const mechanism *m, const state *states, arena *memory, int index,
                                  const char *whose)
{
    static const char axes[] = "xyz";
    const segment *l = &m->segments[index];
    if (l->kind != JOINT_SPHERICAL) {
        add_coordinate(c, &states[l->position], l->position, index, whose)->meaning =
            slides(l) ? "way along the axis of the joint" : "angle about the axis of the joint";
        return;
    }
    for (int i = 0; i < 3; i++) {
        coordinate *to = add_coordinate(c, &states[l->position], -1, index, whose);
        to->name = arena_format(memory, "%s_about_%c", l->name, axes[i]);
        to->unit = "rad";
        to->meaning = arena_format(memory, "small turn away from the point, about the %c axis of the parent", axes[i]);
    }
}

static void add_segment_speeds(chart *c, const mechanism *m, const state *states, arena *memory, int index,
                               const char *whose)
{
    static const char axes[] = "xyz";
    const segment *l = &m->segments[index];
    for (int i = 0; i < dofs_of(l->kind); i++) {
        const int at = m->position_count + l->dof + i;
        coordinate *to = add_coordinate(c, &states[at], at, index, whose);
        to->meaning = l->kind == JOINT_SPHERICAL
                          ? arena_format(memory, "angular velocity about the body's own %c axis", axes[i])
                          : "rate of the position";
    }
}

static void add_coordinates(chart *c, const mechanism *m, const scene *written, arena *memory)
{
    const state *states = mechanism_states(m, memory);
    const char **whose = arena_take(memory, (size_t)m->segment_count + 1, sizeof *whose);
    for (int i = 0; i < m->segment_count; i++) {
        whose[i] = body_of(m, written, memory, i);
        add_segment_positions(c, m, states, memory, i, whose[i]);
    }
    for (int i = 0; i < m->effects.state_count; i++) {
        const int at = m->effects.first_state + i;
        const int effect = m->effects.states[i].effect;
        const char *owner =
            effect < 0 ? "the scene" : arena_format(memory, "effect '%s'", m->effects.names[effect].text);
        add_coordinate(c, &states[at], at, -1, owner)->meaning =
            effect < 0 ? "mode of the scene" : "state of the effect";
    }
    for (int i = 0; i < m->segment_count; i++) {
        add_segment_speeds(c, m, states, memory, i, whose[i]);
    }
}

/* --- small changes --- */

chart chart_at(const mechanism *m, const scene *written, arena *memory, const double *x)
{
    chart c = {.states = state_count(m)};
    const turnings turned = turnings_at(m, memory, x);
    const size_t states = (size_t)c.states + 1;
    c.coordinates = arena_take(memory, states, sizeof *c.coordinates);
    add_coordinates(&c, m, written, memory);
    c.count = c.all;
    c.turn = arena_take(memory, states * ((size_t)c.all + 1), sizeof *c.turn);
    c.back = arena_take(memory, states * ((size_t)c.all + 1), sizeof *c.back);
    c.basis = arena_take(memory, (size_t)(c.all * c.all) + 1, sizeof *c.basis);
    c.chosen = arena_take(memory, (size_t)c.all + 1, sizeof *c.chosen);
    for (int i = 0; i < c.all; i++) {
        const coordinate *is = &c.coordinates[i];
        c.chosen[i] = i;
        c.basis[i * c.all + i] = 1.0;
        if (is->state >= 0) {
            c.turn[is->state * c.all + i] = c.back[i * c.states + is->state] = 1.0;
        }
    }
    FOR_EACH (const turning, t, turned) {
        if (t->quaternion != NULL) { /* these stand in the same order, before all that is no position of a segment */
            c.turn[t->state * c.all + t->reduced] = t->factor;
            c.back[t->reduced * c.states + t->state] = t->back;
        }
    }
    return c;
}

/* By half of the angle's tangent, which is exact to third order; lengths stay one. */
void chart_move(const chart *c, const mechanism *m, double *x, const double *by)
{
    for (int i = 0; i < c->states; i++) {
        for (int k = 0; k < c->all; k++) {
            x[i] += c->turn[i * c->all + k] * by[k];
        }
    }
    FOR_ALL (const segment, l, m->segments, m->segment_count) {
        double *q = x + l->position;
        if (l->kind == JOINT_SPHERICAL) {
            const double size = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
            for (int i = 0; i < 4; i++) {
                q[i] /= size;
            }
        }
    }
}

/* --- closed loops --- */

/* Whether an input or an effect moves the degrees of freedom of the segment. */
static bool is_driven(const mechanism *m, int index)
{
    const segment *l = &m->segments[index];
    bool is = l->drive >= 0;
    FOR_ALL (const effect_effort, push, m->effects.pushes, m->effects.push_count) {
        is = is || (push->dof >= l->dof && push->dof < l->dof + dofs_of(l->kind));
    }
    return is;
}

/* A matrix of rows over small coordinates. */
typedef struct rows_of_coordinates {
    double *at;
    int rows, all;
} rows_of_coordinates;

static void swap_rows(const rows_of_coordinates *m, int a, int b)
{
    for (int k = 0; k < m->all; k++) {
        const double kept = m->at[a * m->all + k];
        m->at[a * m->all + k] = m->at[b * m->all + k];
        m->at[b * m->all + k] = kept;
    }
}

/* Makes a column that of a unit matrix. */
static void clear_column(const rows_of_coordinates *m, int row, int column)
{
    double *own = m->at + row * m->all;
    const double pivot = own[column];
    for (int k = 0; k < m->all; k++) {
        own[k] /= pivot;
    }
    for (int i = 0; i < m->rows; i++) {
        const double factor = m->at[i * m->all + column];
        for (int k = 0; k < m->all && i != row && factor != 0.0; k++) {
            m->at[i * m->all + k] -= factor * own[k];
        }
    }
}

/* Gauss and Jordan in the rows from `from` to `end`, with the largest pivot of all: row_of[column] for each eliminated
 * column. A column of weight zero is not eliminated; one of a small weight stays independent where another is nearly as
 * good. */
static void eliminate(const rows_of_coordinates *m, int from, int end, const double *weights, int *row_of)
{
    double least = 0.0;
    for (int i = from * m->all; i < end * m->all; i++) {
        least = fmax(least, 1e-9 * fabs(m->at[i]));
    }
    for (int step = from; step < end; step++) {
        int row = -1, column = -1;
        double best = 0.0;
        for (int i = step; i < end; i++) {
            for (int k = 0; k < m->all; k++) {
                const double size = fabs(m->at[i * m->all + k]);
                if (size > least && weights[k] * size > best) {
                    best = weights[k] * size;
                    row = i;
                    column = k;
                }
            }
        }
        if (row < 0) {
            return;
        }
        swap_rows(m, step, row);
        clear_column(m, step, column);
        row_of[column] = step;
    }
}

void chart_choose(chart *c, const mechanism *m, arena *memory, double *slopes, int rows, int positions)
{
    const double driven = 0.05;
    const rows_of_coordinates equations = {slopes, rows, c->all};
    int *row_of = arena_take(memory, (size_t)c->all + 1, sizeof *row_of);
    double *weights = arena_take(memory, (size_t)c->all + 1, sizeof *weights);
    for (int speeds = 0; speeds < 2; speeds++) {
        for (int k = 0; k < c->all; k++) {
            const coordinate *is = &c->coordinates[k];
            row_of[k] = speeds == 0 ? -1 : row_of[k];
            const bool may = is->segment >= 0 && is->is_speed == (speeds == 1);
            weights[k] = !may ? 0.0 : is_driven(m, is->segment) ? driven : 1.0;
        }
        eliminate(&equations, speeds == 0 ? 0 : positions, speeds == 0 ? positions : rows, weights, row_of);
    }
    c->count = 0;
    for (int k = 0; k < c->all; k++) {
        if (row_of[k] < 0) {
            c->chosen[c->count++] = k;
        }
    }
    for (int k = 0; k < c->all; k++) {
        for (int j = 0; j < c->count; j++) {
            c->basis[k * c->count + j] =
                row_of[k] < 0 ? (c->chosen[j] == k ? 1.0 : 0.0) : -slopes[row_of[k] * c->all + c->chosen[j]];
        }
    }
}
