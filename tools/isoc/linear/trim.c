#include "tools/isoc/linear/linear.h"

#include <math.h>
#include <string.h>

#include "tools/isoc/base/numbers.h"

/* An equilibrium by Newton's method in small coordinates and free inputs. The residuals: the rates of all coordinates,
 * the gaps of the closures and their rates, and the user's conditions. A position whose speed has a condition other
 * than zero may change, and those that closures tie to it. Each row is divided by its largest slope, so that a stiff
 * spring counts as a soft one; of equally good moves the shortest is made, so that a coordinate that nothing holds
 * stays where it is. */
typedef struct search {
    const expansion *e;
    const scene *written;
    const trim_conditions *w;
    arena *memory;
    point at;
    chart c;
    bool *goes_on; /* [all] */
    int *free;     /* [frees] inputs */
    int frees, rows, columns;
    double *left;   /* [rows] the residuals */
    double *slopes; /* [rows][columns] */
    double *scales; /* [rows] */
} search;

static int rows_before_conditions(const search *s)
{
    return s->c.all + 2 * s->e->gaps;
}

/* The root that a condition is about, or -1: of an input. */
static int root_of(const search *s, const trim_condition *w)
{
    return w->sort == TRIM_OUTPUT ? s->e->states + w->index : -1;
}

static void fill_condition(search *s, const trim_condition *w, int row, const double *now, const double *by_coordinates,
                           const double *by_inputs)
{
    double *slope = s->slopes + row * s->columns;
    const int all = s->c.all, root = root_of(s, w);
    if (w->is_free || w->sort == TRIM_INPUT) {
        return;
    }
    s->left[row] = (root < 0 ? s->at.x[w->index] : now[root]) - w->value;
    for (int k = 0; k < all; k++) {
        slope[k] = root < 0 ? s->c.turn[w->index * all + k] : by_coordinates[root * all + k];
    }
    for (int k = 0; k < s->frees && root >= 0; k++) {
        slope[all + k] = by_inputs[root * s->frees + k];
    }
}

static void fill_rates(search *s, const double *now, const double *by_coordinates, const double *by_inputs)
{
    const chart *c = &s->c;
    const double *reduced = reduced_rates(c, s->memory, by_coordinates);
    for (int i = 0; i < c->all; i++) {
        double *slope = s->slopes + i * s->columns;
        for (int n = 0; n < s->e->states && !s->goes_on[i]; n++) {
            const double back = c->back[i * c->states + n];
            s->left[i] += back * now[n];
            for (int k = 0; k < s->frees; k++) {
                slope[c->all + k] += back * by_inputs[n * s->frees + k];
            }
        }
        for (int k = 0; k < c->all && !s->goes_on[i]; k++) {
            slope[k] = reduced[i * c->all + k];
        }
    }
}

/* The residuals at the point; with their slopes where these are wanted. */
static void look(search *s, bool with_slopes)
{
    const expansion *e = s->e;
    const size_t roots = (size_t)e->roots + 1;
    s->c = chart_at(e->p->m, s->written, s->memory, s->at.x);
    const int all = s->c.all, gaps = rows_before_conditions(s) - all;
    double *now = arena_take(s->memory, roots, sizeof *now), *column = arena_take(s->memory, roots, sizeof *column),
           *by_coordinates = arena_take(s->memory, roots * ((size_t)all + 1), sizeof *by_coordinates),
           *by_inputs = arena_take(s->memory, roots * ((size_t)s->frees + 1), sizeof *by_inputs);
    numbers_at(e, &s->at, NULL, e->l.values, now);
    if (with_slopes) {
        slopes_by_coordinates(e, &s->c, &s->at, by_coordinates);
    }
    for (int k = 0; k < s->frees && with_slopes; k++) {
        numbers_at(e, &s->at, NULL, e->by_input + s->free[k] * e->roots, column);
        for (int i = 0; i < e->roots; i++) {
            by_inputs[i * s->frees + k] = column[i];
        }
    }
    memset(s->left, 0, (size_t)s->rows * sizeof *s->left);
    memset(s->slopes, 0, (size_t)(s->rows * s->columns) * sizeof *s->slopes);
    fill_rates(s, now, by_coordinates, by_inputs);
    for (int i = 0; i < gaps; i++) {
        const int root = e->states + e->outputs + i;
        s->left[all + i] = now[root];
        memcpy(s->slopes + (all + i) * s->columns, by_coordinates + root * all, (size_t)all * sizeof *s->slopes);
    }
    FOR_EACH (const trim_condition, w, *s->w) {
        fill_condition(s, w, all + gaps + (int)(w - s->w->all), now, by_coordinates, by_inputs);
    }
}

static void find_scales(search *s)
{
    for (int i = 0; i < s->rows; i++) {
        s->scales[i] = 1.0;
        for (int k = 0; k < s->columns; k++) {
            s->scales[i] = fmax(s->scales[i], fabs(s->slopes[i * s->columns + k]));
        }
    }
}

/* The sum of the squares of the residuals, by the scales. */
static double size_left(const search *s)
{
    double sum = 0.0;
    for (int i = 0; i < s->rows; i++) {
        sum += s->left[i] * s->left[i] / (s->scales[i] * s->scales[i]);
    }
    return isfinite(sum) ? sum : HUGE_VAL;
}

static void move(search *s, const point *from, const double *by, double part)
{
    const mechanism *m = s->e->p->m;
    double *change = arena_take(s->memory, (size_t)s->c.all + 1, sizeof *change);
    memcpy(s->at.x, from->x, (size_t)s->e->states * sizeof *s->at.x);
    for (int k = 0; k < s->c.all; k++) {
        change[k] = part * by[k];
    }
    chart_move(&s->c, m, s->at.x, change);
    for (int k = 0; k < s->frees; k++) {
        s->at.u[s->free[k]] = from->u[s->free[k]] + part * by[s->c.all + k];
    }
}

/* The shortest move that removes most of the residuals; positions by no more than half a metre or radian. */
static double *aim(search *s)
{
    const double longest = 0.5;
    double *by = arena_take(s->memory, (size_t)s->columns + 1, sizeof *by),
           *wanted = arena_take(s->memory, (size_t)s->rows + 1, sizeof *wanted),
           *rows = arena_take(s->memory, (size_t)(s->rows * s->columns) + 1, sizeof *rows), largest = 0.0;
    for (int i = 0; i < s->rows; i++) {
        wanted[i] = -s->left[i] / s->scales[i];
        for (int k = 0; k < s->columns; k++) {
            rows[i * s->columns + k] = s->slopes[i * s->columns + k] / s->scales[i];
        }
    }
    least_squares(s->memory, rows, s->rows, s->columns, wanted, by);
    for (int k = 0; k < s->c.all; k++) {
        const bool is_position = s->c.coordinates[k].segment >= 0 && !s->c.coordinates[k].is_speed;
        largest = is_position ? fmax(largest, fabs(by[k])) : largest;
    }
    for (int k = 0; k < s->columns && largest > longest; k++) {
        by[k] *= longest / largest;
    }
    return by;
}

/* One move, which is halved until the residuals are less. Returns whether they are. */
static bool step(search *s)
{
    enum { HALVINGS = 24 };
    find_scales(s);
    const double before = size_left(s);
    const double *by = aim(s);
    const point from = point_copy(s->memory, s->e, &s->at);
    double part = 1.0;
    for (int i = 0; i < HALVINGS; i++, part *= 0.5) {
        move(s, &from, by, part);
        look(s, false);
        if (size_left(s) < before) {
            return true;
        }
    }
    move(s, &from, by, 0.0);
    return false;
}

/* Newton's method from the point, until no step lowers the residual; returns the residual there. */
static double descend(search *s)
{
    enum { ITERATIONS = 60 };
    arena *whole = s->memory;
    s->memory = arena_new();
    look(s, true);
    for (int i = 0; i < ITERATIONS && step(s); i++) {
        look(s, true);
    }
    look(s, true);
    find_scales(s);
    const double left = size_left(s);
    arena_free(s->memory);
    s->memory = whole;
    return left;
}

/* Moves positions to the n-th of a sequence of other beginnings, farther and farther away. */
static void move_away(search *s, int n)
{
    double *by = arena_take(s->memory, (size_t)s->c.all + 1, sizeof *by);
    double phase = 0.0;
    for (int k = 0; k < s->c.all; k++) {
        phase += 0.7548776662466927 * n + 0.1;
        phase -= floor(phase);
        if (s->c.coordinates[k].segment >= 0 && !s->c.coordinates[k].is_speed) {
            by[k] = (phase - 0.5) * 0.2 * n;
        }
    }
    chart_move(&s->c, s->e->p->m, s->at.x, by);
}

/* Positions whose speed is to be other than zero, and those that closures tie to these. */
static void find_going_on(search *s)
{
    const expansion *e = s->e;
    const int all = s->c.all;
    double *slopes = arena_take(s->memory, (size_t)(e->roots * all) + 1, sizeof *slopes);
    bool *speeds = arena_take(s->memory, (size_t)all + 1, sizeof *speeds);
    slopes_by_coordinates(e, &s->c, &s->at, slopes);
    FOR_EACH (const trim_condition, w, *s->w) {
        const int root = root_of(s, w);
        for (int k = 0; k < all && !w->is_free && w->sort != TRIM_INPUT && w->value != 0.0; k++) {
            const double slope = root < 0 ? s->c.turn[w->index * all + k] : slopes[root * all + k];
            speeds[k] = speeds[k] || (s->c.coordinates[k].is_speed && slope != 0.0);
        }
    }
    for (bool more = true; more;) {
        more = false;
        for (int i = 0; i < e->gaps; i++) {
            const double *row = slopes + (e->states + e->outputs + e->gaps + i) * all;
            bool tied = false;
            for (int k = 0; k < all; k++) {
                tied = tied || (speeds[k] && row[k] != 0.0);
            }
            for (int k = 0; k < all && tied; k++) {
                const bool joins = s->c.coordinates[k].is_speed && row[k] != 0.0 && !speeds[k];
                speeds[k] = speeds[k] || joins;
                more = more || joins;
            }
        }
    }
    for (int i = 0; i < all; i++) {
        for (int k = 0; k < all; k++) {
            s->goes_on[i] = s->goes_on[i] || (speeds[k] && !s->c.coordinates[i].is_speed &&
                                              s->c.coordinates[i].segment == s->c.coordinates[k].segment);
        }
    }
}

/* The row that is farthest from zero, by its scale; of those that nothing moves first. */
static int worst_row(const search *s)
{
    int worst = 0;
    double most = -1.0;
    for (int i = 0; i < s->rows; i++) {
        const double size = fabs(s->left[i]) / s->scales[i];
        worst = size > most ? i : worst;
        most = fmax(most, size);
    }
    return worst;
}

static void refuse_trim(source *s, const search *attempt, const trim_conditions *w, place at)
{
    const int row = worst_row(attempt), all = attempt->c.all;
    const double left = attempt->left[row];
    if (row >= rows_before_conditions(attempt)) {
        const trim_condition *missed = &w->all[row - rows_before_conditions(attempt)];
        source_problem(s, missed->at,
                       "no equilibrium found: '%s' stays %.4g %s away from %.4g; free an input that moves it, or begin "
                       "nearer",
                       missed->name, left, missed->unit, missed->value);
    } else if (row >= all) {
        const expansion *e = attempt->e;
        const constraints *phi = &e->p->d->loops.phi;
        const closure *c = &e->p->m->closures[phi->all[(row - all) % e->gaps].closure];
        const char *fault = row - all < e->gaps ? "stays open by" : "moves, at a rate of";
        source_problem(s, at, "no equilibrium found: the closure '%s' %s %.4g", c->name, fault, left);
    } else {
        const coordinate *is = &attempt->c.coordinates[row];
        source_problem(s, at, "no equilibrium found: '%s' of %s keeps a rate of %.4g %s: free an input", is->name,
                       is->whose, left, unit_of_rate(s->memory, is->unit));
    }
}

static search search_start(const expansion *e, const scene *written, const trim_conditions *w, const point *at)
{
    arena *memory = e->l.g.memory;
    search s = {.e = e, .written = written, .w = w, .memory = memory, .at = point_copy(memory, e, at)};
    s.c = chart_at(e->p->m, written, memory, s.at.x);
    s.free = arena_take(memory, (size_t)e->inputs + 1, sizeof *s.free);
    s.goes_on = arena_take(memory, (size_t)s.c.all + 1, sizeof *s.goes_on);
    FOR_EACH (const trim_condition, is, *w) {
        if (is->is_free) {
            s.free[s.frees++] = is->index;
        } else if (is->sort == TRIM_INPUT) {
            s.at.u[is->index] = is->value;
        } else if (is->sort == TRIM_STATE) {
            s.at.x[is->index] = is->value;
        }
    }
    s.rows = rows_before_conditions(&s) + (int)w->count;
    s.columns = s.c.all + s.frees;
    s.left = arena_take(memory, (size_t)s.rows + 1, sizeof *s.left);
    s.scales = arena_take(memory, (size_t)s.rows + 1, sizeof *s.scales);
    s.slopes = arena_take(memory, (size_t)(s.rows * s.columns) + 1, sizeof *s.slopes);
    find_going_on(&s);
    return s;
}

bool trim(source *s, const expansion *e, const scene *written, const trim_conditions *w, point *at)
{
    enum { TRIES = 24, FEW_TRIES = 3, SMALL = 40 };
    const double enough = 1e-16; /* 1e-8 of the scale of a row */
    search attempt = search_start(e, written, w, at);
    const point start = point_copy(attempt.memory, e, &attempt.at);
    point best = start;
    const int tries = attempt.columns > SMALL ? FEW_TRIES : TRIES; /* they bound the time of isoc */
    double least = HUGE_VAL;
    for (int n = 0; n < tries && !(least <= enough); n++) {
        attempt.at = point_copy(attempt.memory, e, &start);
        if (n > 0) {
            attempt.c = chart_at(e->p->m, written, attempt.memory, attempt.at.x);
            move_away(&attempt, n);
        }
        const double left = descend(&attempt);
        if (left < least) {
            least = left;
            best = attempt.at;
        }
    }
    attempt.at = best;
    look(&attempt, true);
    find_scales(&attempt);
    if (!(least <= enough)) {
        refuse_trim(s, &attempt, w, w->count > 0 ? w->all[0].at : e->p->m->segments[0].at);
        return false;
    }
    *at = attempt.at;
    return true;
}
