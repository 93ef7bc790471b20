#include "tools/isoc/dynamics/dynamics.h"

#include <math.h>
#include <string.h>

#include "tools/isoc/base/numbers.h"

static const double tight = 1e-13;       /* where Newton's method ends */
static const double smallest_gap = 1e-6; /* a gap smaller than this that is no longer halved is the smallest possible */
static const double around = 6.28318530717958648;
static const double longest_move = 0.5; /* m or rad in an iteration */

void closing_evaluate(const closing *c)
{
    const int n = c->m->dof_count;
    const evaluation at = {.x = c->x, .p = c->m->parameters.at_start};
    graph_evaluate(c->d->g, 0, &at, c->numbers);
    for (int r = 0; r < c->phi->count; r++) {
        for (int f = 0; f < n; f++) {
            c->jacobian[r * n + f] = c->numbers[c->phi->all[r].row[f]];
        }
    }
}

double *closing_keep(const closing *c)
{
    return list_copy(c->memory, c->x, (size_t)state_count(c->m), sizeof *c->x);
}

/* Without an evaluation: the caller evaluates after it has moved on from there. */
static void go_back(const closing *c, const double *kept)
{
    memcpy(c->x, kept, (size_t)state_count(c->m) * sizeof *kept);
}

void closing_restore(const closing *c, const double *kept)
{
    go_back(c, kept);
    closing_evaluate(c);
}

bool closing_counts(const closing *c, bool rates, int row)
{
    return rates || !is_zero(c->d->g, c->phi->all[row].position);
}

double closing_gap(const closing *c, bool rates, int row)
{
    return c->numbers[rates ? c->phi->all[row].rate : c->phi->all[row].position];
}

static double square_gaps(const closing *c, bool rates)
{
    double sum = 0.0;
    for (int r = 0; r < c->phi->count; r++) {
        sum += closing_gap(c, rates, r) * closing_gap(c, rates, r);
    }
    return sum;
}

/* Moves the positions of a segment by a change of its degrees of freedom. */
static void move_segment(const closing *c, const segment *l, const double *by)
{
    double *q = c->x + l->position;
    if (l->kind != JOINT_SPHERICAL) {
        q[0] += by[0];
        return;
    }
    const double w = q[0], i = q[1], j = q[2], k = q[3];
    q[0] = w - 0.5 * (i * by[0] + j * by[1] + k * by[2]);
    q[1] = i + 0.5 * (w * by[0] + j * by[2] - k * by[1]);
    q[2] = j + 0.5 * (w * by[1] + k * by[0] - i * by[2]);
    q[3] = k + 0.5 * (w * by[2] + i * by[1] - j * by[0]);
    const double norm = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (int n = 0; n < 4; n++) {
        q[n] /= norm;
    }
}

void closing_move(const closing *c, bool rates, const double *by)
{
    FOR_ALL (const segment, l, c->m->segments, c->m->segment_count) {
        if (!rates) {
            move_segment(c, l, by + l->dof);
        } else {
            for (int f = l->dof; f < l->dof + dofs_of(l->kind); f++) {
                c->x[c->m->position_count + f] += by[f];
            }
        }
    }
}

/* The least change of the free coordinates that closes the gaps, to first order; returns the largest gap, and the rank
 * of the columns. */
static gap aim(const closing *c, bool rates, const bool *is_free, double *by)
{
    const int n = c->m->dof_count, rows = c->phi->count;
    double *matrix_free = arena_take(c->memory, (size_t)(rows * n) + 1, sizeof *matrix_free);
    double *wanted = arena_take(c->memory, (size_t)rows + 1, sizeof *wanted);
    gap open = {0};
    for (int r = 0; r < rows; r++) {
        if (!closing_counts(c, rates, r)) {
            continue;
        }
        open.all++;
        wanted[r] = -closing_gap(c, rates, r);
        if (!(fabs(wanted[r]) <= open.size)) {
            open.size = fabs(wanted[r]);
            open.row = r;
        }
        for (int f = 0; f < n; f++) {
            matrix_free[r * n + f] = is_free[f] ? c->jacobian[r * n + f] : 0.0;
        }
    }
    open.rank = least_squares(c->memory, matrix_free, rows, n, wanted, by);
    const double largest = largest_of(by, n);
    for (int f = 0; f < n && !rates && largest > longest_move; f++) {
        by[f] *= longest_move / largest;
    }
    return open;
}

/* Moves by a step, which is halved until the gaps decrease. */
static void move_closer(const closing *c, bool rates, double *by)
{
    enum { HALVINGS = 30 };
    const double before = square_gaps(c, rates);
    const double *from = closing_keep(c);
    for (int i = 0; i < HALVINGS; i++) {
        go_back(c, from);
        closing_move(c, rates, by);
        closing_evaluate(c);
        if (square_gaps(c, rates) < before) {
            return;
        }
        for (int f = 0; f < c->m->dof_count; f++) {
            by[f] *= 0.5;
        }
    }
}

gap closing_run(const closing *c, bool rates, const bool *is_free)
{
    enum { ITERATIONS = 100 };
    double *by = arena_take(c->memory, (size_t)c->m->dof_count + 1, sizeof *by);
    closing_evaluate(c);
    gap open = aim(c, rates, is_free, by);
    for (int i = 0; i < ITERATIONS && open.size > tight; i++) {
        const double size = open.size, square = square_gaps(c, rates);
        move_closer(c, rates, by);
        open = aim(c, rates, is_free, by);
        if ((open.size < smallest_gap && open.size > 0.5 * size) || square_gaps(c, rates) > (1.0 - 1e-6) * square) {
            break; /* the least there is near here */
        }
    }
    return open;
}

/* Moves free coordinates to the n-th point of a sequence that fills their space evenly: a turn wide for angles, `reach`
 * for lengths. Roberts (2018), "The unreasonable effectiveness of quasirandom sequences": multiples of the powers of 1
 * / g, g^(count + 1) = g + 1. */
static void move_away(const closing *c, const bool *is_free, int n, double reach)
{
    double *by = arena_take(c->memory, (size_t)c->m->dof_count + 1, sizeof *by);
    double g = 1.5, power = 1.0;
    int count = 0;
    for (int f = 0; f < c->m->dof_count; f++) {
        count += is_free[f];
    }
    for (int i = 0; i < 50; i++) {
        g = pow(1.0 + g, 1.0 / (count + 1));
    }
    for (int f = 0; f < c->m->dof_count; f++) {
        if (is_free[f]) {
            power /= g;
            const double part = n * power - floor(n * power) - 0.5;
            by[f] = part * (slides(&c->m->segments[c->m->dofs[f].segment]) ? reach : around);
        }
    }
    closing_move(c, false, by);
}

/* Brings free angles to within half a turn of their rough start, continuous ones of zero. */
static void fold(const closing *c, const bool *is_free)
{
    FOR_ALL (const segment, l, c->m->segments, c->m->segment_count) {
        if (l->kind == JOINT_REVOLUTE && l->lead == 0.0 && is_free[l->dof]) {
            const double from = l->continuous ? 0.0 : l->start[0];
            c->x[l->position] -= around * floor((c->x[l->position] - from) / around + 0.5);
        }
    }
}

gap closing_search(const closing *c, const bool *is_free, double enough)
{
    enum { TRIES = 64 };
    const double *start = closing_keep(c), *best = start;
    double *by = arena_take(c->memory, (size_t)c->m->dof_count + 1, sizeof *by);
    closing_evaluate(c);
    const double reach = aim(c, false, is_free, by).size;
    double least = HUGE_VAL;
    for (int n = 0; n < TRIES && !(least <= enough); n++) {
        go_back(c, start);
        if (n > 0) {
            move_away(c, is_free, n, 2.0 * reach);
        }
        const gap open = closing_run(c, false, is_free);
        if (open.size < least) {
            least = open.size;
            best = closing_keep(c);
        }
    }
    go_back(c, best);
    fold(c, is_free);
    return closing_run(c, false, is_free);
}

closing closing_start(arena *memory, const dynamics *d)
{
    const mechanism *m = d->m;
    const size_t n = (size_t)m->dof_count;
    closing c = {.d = d, .m = m, .phi = &d->loops.phi, .memory = memory, .x = mechanism_start(m, memory)};
    c.numbers = arena_take(memory, d->g->count, sizeof *c.numbers);
    c.jacobian = arena_take(memory, n * (size_t)c.phi->count + 1, sizeof *c.jacobian);
    for (int r = 0; r < c.phi->count; r++) {
        const node gaps[2] = {c.phi->all[r].position, c.phi->all[r].rate};
        note_built_in(d->g, m, gaps, 2);
        note_built_in(d->g, m, c.phi->all[r].row, n);
    }
    closing_evaluate(&c);
    return c;
}
