/* Loop closures of the scene, expressed in the frames of segments. */
#include <math.h>
#include <string.h>

#include "tools/isoc/mechanism/builder.h"

/* A closure between two bodies. */
static bool build_between(builder *b, const closure_statement *written, closure *result)
{
    double axis[3];
    matrix aligned = matrix_identity(b->g);
    if (written->axis != NULL && unit_axis(b, written->axis, axis)) {
        aligned = align(b->g, axis, &result->axis, &result->sign);
    }
    const bool found = place_end(b, &written->parent, aligned, &result->parent);
    if (!place_end(b, &written->child, aligned, &result->child) || !found) {
        return false;
    }
    if (result->parent.segment == result->child.segment) {
        return source_problem(b->s, written->name.at,
                              "'%s' closes nothing: '%s' and '%s' do not move relative to each other",
                              written->name.text, written->parent.body.text, written->child.body.text);
    }
    result->base = common_segment(&b->mechanism, result->parent.segment, result->child.segment);
    if (written->wheel != NULL && unit_axis(b, written->wheel, axis)) {
        const vector axle = {{constant(b->g, axis[0]), constant(b->g, axis[1]), constant(b->g, axis[2])}};
        result->wheel = matrix_apply(b->g, result->child.turn, matrix_apply(b->g, matrix_transpose(aligned), axle));
        result->is_disc = true;
    }
    const bool rolls = written->kind == CLOSE_ROLLING;
    result->length = scalar_value(b, rolls ? written->radius : written->length, metre, rolls ? "a radius" : "a length");
    if (rolls && result->parent.segment != GROUND) {
        source_problem(b->s, written->parent.body.at, "a ball can roll only on the ground: parent ground");
    }
    const bool sized = rolls || written->kind == CLOSE_DISTANCE;
    if (sized && (rolls || written->length != NULL) && !keeps_above_zero(&b->values, result->length)) {
        return source_problem(b->s, rolls && written->radius != NULL ? written->radius->at : written->name.at,
                              "a %s must be larger than zero", rolls ? "radius" : "length");
    }
    return true;
}

/* The factor of first - ratio second with which whole turns of the continuous joints become whole turns of the
 * constraint. If both are continuous, it is the denominator of a ratio of small whole numbers. Zero if there is no such
 * factor. */
static node whole_turns(builder *b, const segment *first, const segment *second_segment, node ratio)
{
    enum { MOST_TEETH = 100 };
    static const double exact = 1e-12; /* relative: the rounding of a ratio of whole numbers */
    graph *g = b->g;
    int whole = first->continuous && !second_segment->continuous;
    if (second_segment->continuous && !first->continuous && value_now(&b->values, ratio) != 0.0) {
        return divide(g, constant(g, 1.0), ratio);
    }
    for (int n = 1; n <= MOST_TEETH && whole == 0 && second_segment->continuous && is_constant(g, ratio); n++) {
        const double product = n * constant_value(g, ratio);
        whole = fabs(product - floor(product + 0.5)) <= exact * fabs(product) ? n : 0;
    }
    return constant(g, whole);
}

/* A gear between two joints; the start satisfies it. */
static bool build_gear(builder *b, const closure_statement *written, closure *result)
{
    result->parent.segment = coordinate_of(b, written->first);
    result->child.segment = coordinate_of(b, written->second);
    if (result->parent.segment < 0 || result->child.segment < 0) {
        return false;
    }
    if (result->parent.segment == result->child.segment) {
        return source_problem(b->s, written->second.at, "a gear needs two joints; both are '%s'", written->second.text);
    }
    const segment *first = &b->mechanism.segments[result->parent.segment],
                  *second_segment = &b->mechanism.segments[result->child.segment];
    dimension expected = coordinate_dimension(first);
    dimension_times(&expected, coordinate_dimension(second_segment), -1);
    result->ratio = scalar_value(b, written->ratio, expected, "the ratio of this gear");
    result->length = constant(b->g, first->start[0] - value_now(&b->values, result->ratio) * second_segment->start[0]);
    result->whole = whole_turns(b, first, second_segment, result->ratio);
    result->in_speed = (first->continuous || second_segment->continuous) && is_zero(b->g, result->whole);
    return true;
}

static void build_closure(builder *b, const closure_statement *written)
{
    const node zero = constant(b->g, 0.0);
    closure result = {
        .name = written->name.text, .at = written->name.at, .kind = written->kind, .base = GROUND, .sign = 1.0};
    result.length = result.ratio = result.motion = result.motion_rate = result.motion_bias = result.whole = zero;
    if (written->broken) {
        return;
    }
    const bool good = written->kind == CLOSE_GEAR     ? build_gear(b, written, &result)
                      : written->kind == CLOSE_MOTION ? build_motion(b, written, &result)
                                                      : build_between(b, written, &result);
    if (good) {
        b->mechanism.closures[b->mechanism.closure_count++] = result;
    }
}

/* --- stabilisation --- */

static double option(builder *b, const formula *f, dimension expected, const char *what, double fallback, double least)
{
    const double number = value_constant(&b->values, f, expected, what, fallback);
    if (f != NULL && !(number >= least)) {
        source_problem(b->s, f->at, "%s must be at least %g", what, least);
        return fallback;
    }
    return number;
}

/* The policy on a tick near a singular position. The energy can be held where closures do no work, and where the step
 * is made from its start alone: a history would carry a step near there into later steps. */
static void build_near(builder *b, const name *near)
{
    mechanism *m = &b->mechanism;
    if (near->text == NULL) {
        return;
    }
    m->drift.near_stops = strcmp(near->text, "stop") == 0;
    m->drift.near_holds = strcmp(near->text, "hold") == 0;
    if (m->drift.projections == 0) {
        source_problem(b->s, near->at,
                       "only a projection watches for singular positions: leave out omega and mu, or near");
    }
    if (m->drift.near_holds && (ISO_PAST_KEPT(m->method.recipe) > 0 || ISO_IS_VARYING(m->method.recipe))) {
        source_problem(b->s, near->at, "near hold needs a method without a history, such as rk4 or rosenbrock");
    }
    for (int i = 0; i < m->closure_count && m->drift.near_holds; i++) {
        if (m->closures[i].kind == CLOSE_MOTION) {
            source_problem(b->s, near->at, "near hold needs closures that do no work: '%s' is a motion",
                           m->closures[i].name);
        }
    }
}

/* Baumgarte's alpha = beta = 1 / (10 h) removes a violation in some tens of steps, and is stable with every method: its
 * double root -1 / (10 h) is within the stability limit of ab4, 0.3 / h. The augmented Lagrangian has no feedback, but
 * where the scene asks for it; then it uses the same value as Omega, with mu = 1, so that gamma is the same.
 *
 * Gains that follow the step take the order from a method with stages inside of it: these are off the constraints by
 * c h^2, and beta^2 makes c / 100 of it, an acceleration that does not vanish with h. So the default is a projection,
 * which moves the end of the step alone, by its local error at most. */
static void build_stabilisation(builder *b)
{
    static const dimension rate = DIMENSION(0, 0, -1, 0, 0, 0);
    const stabilisation *written = &b->written->stabilisation;
    mechanism *m = &b->mechanism;
    const char *kind = written->kind.text == NULL ? "projection" : written->kind.text;
    const bool is_lagrangian = strcmp(kind, "lagrangian") == 0, is_baumgarte = strcmp(kind, "baumgarte") == 0;
    const bool draws = is_baumgarte || (is_lagrangian && (written->omega != NULL || written->mu != NULL));
    const double usual = draws ? 0.1 / method_step(m) : 0.0;
    m->drift.alpha = option(b, written->alpha, rate, "alpha", usual, 0.0);
    m->drift.beta = option(b, written->beta, rate, "beta", written->alpha != NULL ? m->drift.alpha : usual, 0.0);
    m->drift.multiplier_iterations = 1;
    if (is_lagrangian) {
        const double omega = option(b, written->omega, rate, "omega", usual, 0.0);
        m->drift.beta = omega;
        m->drift.alpha = omega * option(b, written->mu, no_unit, "mu", 1.0, 0.0);
        m->drift.is_redundant = true;
        m->drift.penalty = option(b, written->penalty, kilogram, "the penalty", 0.0, 1e-9);
        m->drift.multiplier_iterations =
            (int)option(b, written->iterations, no_unit, "the number of iterations", 6.0, 1.0);
        m->drift.projections = draws ? 0 : 1;
    } else if (strcmp(kind, "projection") == 0) {
        m->drift.projections = (int)option(b, written->iterations, no_unit, "the number of iterations", 1.0, 1.0);
    }
    build_near(b, &written->near);
    const value limit = written->limit == NULL ? nothing : value_any(&b->values, written->limit);
    const dimension of_limit = dimension_equal(limit.dim, radian) ? radian : metre; /* of a displacement */
    m->drift.violation_limit = constant_fitting(&b->values, written->limit, &limit, of_limit, "the limit", 0.0);
    if (m->drift.violation_limit < 0.0) {
        source_problem(b->s, written->limit->at, "the limit must be at least 0");
    }
}

void build_closures(builder *b)
{
    b->mechanism.closures = arena_take(b->s->memory, b->written->closures.count + 1, sizeof *b->mechanism.closures);
    b->mechanism.clocks.first = b->mechanism.position_count;
    for (size_t i = 0; i < b->written->closures.count; i++) {
        build_closure(b, &b->written->closures.all[i]);
    }
    b->mechanism.position_count += b->mechanism.clocks.count;
    build_stabilisation(b);
}
