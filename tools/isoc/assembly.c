#include "tools/isoc/assembly.h"

#include <math.h>
#include <string.h>

#include "tools/isoc/least_squares.h"

static const double closed = 1e-6;      /* m, rad, and per second: what the digits of given values may leave open */
static const double tight = 1e-13;      /* where Newton's method ends */
static const double longest_move = 0.5; /* m or rad in an iteration */

typedef struct assembly {
    source *s;
    const dynamics *d;
    const mechanism *m;
    const constraints *held;
    double *x, *numbers;
    bool *looped; /* [freedoms] whether a closure feels it */
    double *jacobian;
} assembly;

static void evaluate(const assembly *a)
{
    const graph *g = a->d->g;
    const int n = a->m->freedom_count;
    graph_evaluate(g, a->x, NULL, a->m->defaults, a->numbers);
    for (int r = 0; r < a->held->count; r++) {
        for (int f = 0; f < n; f++) {
            a->jacobian[r * n + f] = a->numbers[a->held->all[r].row[f]];
        }
    }
}

static double largest_gap(const assembly *a, bool rates, int *worst)
{
    double largest = 0.0;
    *worst = 0;
    for (int r = 0; r < a->held->count; r++) {
        const constraint *c = &a->held->all[r];
        const double gap = fabs(a->numbers[rates ? c->rate : c->position]);
        if (!(gap <= largest)) {
            largest = gap;
            *worst = r;
        }
    }
    return largest;
}

/* Moves the positions of a link by what its freedoms move. */
static void move_link(const assembly *a, const link *l, const double *by)
{
    double *q = a->x + l->position;
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

static void move(const assembly *a, bool rates, const double *by)
{
    for (int i = 0; i < a->m->link_count; i++) {
        const link *l = &a->m->links[i];
        if (!rates) {
            move_link(a, l, by + l->freedom);
        } else {
            for (int f = l->freedom; f < l->freedom + freedoms_of(l->kind); f++) {
                a->x[a->m->position_count + f] += by[f];
            }
        }
    }
}

/* The least move of the free ones that closes the gaps, to first order; the rank of their columns. */
static int newton(const assembly *a, bool rates, const bool *is_free, double *by)
{
    const int n = a->m->freedom_count, rows = a->held->count;
    arena *memory = a->s->memory;
    double *matrix_free = arena_take(memory, (size_t)(rows * n) + 1, sizeof *matrix_free);
    double *gaps = arena_take(memory, (size_t)rows + 1, sizeof *gaps);
    double largest = 0.0;
    for (int r = 0; r < rows; r++) {
        gaps[r] = -a->numbers[rates ? a->held->all[r].rate : a->held->all[r].position];
        for (int f = 0; f < n; f++) {
            matrix_free[r * n + f] = is_free[f] ? a->jacobian[r * n + f] : 0.0;
        }
    }
    const int rank = least_squares(memory, matrix_free, rows, n, gaps, by);
    for (int f = 0; f < n; f++) {
        largest = fmax(largest, fabs(by[f]));
    }
    for (int f = 0; f < n && !rates && largest > longest_move; f++) {
        by[f] *= longest_move / largest;
    }
    return rank;
}

/* Newton's method over the free ones. Returns the gap that is left, *rank and the *worst constraint. */
static double close_gaps(const assembly *a, bool rates, const bool *is_free, int *rank, int *worst)
{
    enum { ITERATIONS = 200 };
    double *by = arena_take(a->s->memory, (size_t)a->m->freedom_count + 1, sizeof *by);
    evaluate(a);
    double gap = largest_gap(a, rates, worst);
    *rank = newton(a, rates, is_free, by);
    for (int i = 0; i < ITERATIONS && gap > tight; i++) {
        move(a, rates, by);
        evaluate(a);
        const double before = gap;
        gap = largest_gap(a, rates, worst);
        *rank = newton(a, rates, is_free, by);
        if (gap < closed && gap > 0.5 * before) {
            break; /* rounding */
        }
    }
    return gap;
}

/* The names of the free coordinates, for a message. */
static const char *list_free(const assembly *a, const bool *is_free)
{
    const char *list = "";
    for (int f = 0; f < a->m->freedom_count; f++) {
        if (is_free[f]) {
            list = arena_format(a->s->memory, "%s%s%s", list, list[0] == '\0' ? "" : ", ", a->m->freedoms[f].name);
        }
    }
    return list;
}

static int choose_free(const assembly *a, bool rates, bool all, bool *is_free)
{
    int count = 0;
    for (int f = 0; f < a->m->freedom_count; f++) {
        const link *l = &a->m->links[a->m->freedoms[f].link];
        const bool given = rates ? l->speed_given : l->start_given;
        is_free[f] = a->looped[f] && (all || !given);
        count += is_free[f];
    }
    return count;
}

static place place_of(const assembly *a, int row)
{
    return a->m->cuts[a->held->all[row].cut].at;
}

static const char *name_of(const assembly *a, int row)
{
    return a->m->cuts[a->held->all[row].cut].name;
}

static bool close_positions(const assembly *a, bool *is_free)
{
    int rank, worst;
    const int count = choose_free(a, false, false, is_free);
    const double gap = close_gaps(a, false, is_free, &rank, &worst);
    if (!(gap <= closed)) {
        source_problem(a->s, place_of(a, worst),
                       "'%s' cannot close: it stays %.3g (m or rad) open, with rank %d of %d constraints over the "
                       "coordinates without a start: %s",
                       name_of(a, worst), gap, rank, a->held->count, count == 0 ? "none" : list_free(a, is_free));
        return false;
    }
    if (rank < count) {
        source_problem(a->s, place_of(a, worst),
                       "the closures leave %d of %d coordinates undetermined (rank %d): give a start to %d of %s",
                       count - rank, count, rank, count - rank, list_free(a, is_free));
        return false;
    }
    choose_free(a, false, true, is_free);
    const double left = close_gaps(a, false, is_free, &rank, &worst);
    if (!(left <= 1e3 * tight)) {
        source_problem(a->s, place_of(a, worst),
                       "'%s' contradicts the other closures: %.3g (m or rad) stay open, with rank %d of %d constraints",
                       name_of(a, worst), left, rank, a->held->count);
        return false;
    }
    if (rank < a->held->count && !a->m->is_redundant) {
        source_problem(a->s, place_of(a, a->held->count - 1),
                       "the closures repeat each other: rank %d of %d constraints at the start; leave out what is "
                       "redundant, or write stabilisation lagrangian",
                       rank, a->held->count);
        return false;
    }
    return true;
}

static void close_speeds(const assembly *a, bool *is_free)
{
    int rank, worst;
    choose_free(a, true, false, is_free);
    const double gap = close_gaps(a, true, is_free, &rank, &worst);
    if (!(gap <= closed)) {
        source_problem(a->s, place_of(a, worst),
                       "the speeds given at the start tear '%s' open at %.3g (m/s or rad/s): leave out all but one",
                       name_of(a, worst), gap);
        return;
    }
    choose_free(a, true, true, is_free);
    close_gaps(a, true, is_free, &rank, &worst);
}

/* Constraints that hold by the shape of the scene do so only if they are not off by a constant. */
static bool check_dropped(const assembly *a)
{
    for (int i = 0; i < a->held->dropped; i++) {
        const double gap = fabs(a->numbers[a->held->dropped_gaps[i]]);
        const cut *c = &a->m->cuts[a->held->dropped_cuts[i]];
        if (!(gap <= closed)) {
            source_problem(a->s, c->at, "'%s' cannot close: it is %.3g (m or rad) off where no joint moves it", c->name,
                           gap);
            return false;
        }
    }
    return true;
}

static void keep_start(const assembly *a)
{
    for (int i = 0; i < a->m->link_count; i++) {
        link *l = &a->m->links[i];
        memcpy(l->start, a->x + l->position, (size_t)positions_of(l->kind) * sizeof *a->x);
        memcpy(l->speed, a->x + a->m->position_count + l->freedom, (size_t)freedoms_of(l->kind) * sizeof *a->x);
    }
}

void assemble(source *s, const dynamics *d)
{
    const mechanism *m = d->m;
    const size_t n = (size_t)m->freedom_count;
    if (m->cut_count == 0) {
        return;
    }
    assembly a = {.s = s, .d = d, .m = m, .held = &d->loops.held, .x = mechanism_start(m, s->memory)};
    a.numbers = arena_take(s->memory, d->g->count, sizeof *a.numbers);
    a.jacobian = arena_take(s->memory, n * (size_t)a.held->count + 1, sizeof *a.jacobian);
    a.looped = arena_take(s->memory, n, sizeof *a.looped);
    bool *is_free = arena_take(s->memory, n, sizeof *is_free);
    for (int r = 0; r < a.held->count; r++) {
        for (size_t f = 0; f < n; f++) {
            a.looped[f] = a.looped[f] || !is_zero(d->g, a.held->all[r].row[f]);
        }
    }
    evaluate(&a);
    if (check_dropped(&a) && close_positions(&a, is_free)) {
        close_speeds(&a, is_free);
        keep_start(&a);
    }
}
