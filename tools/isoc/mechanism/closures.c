/* Loop closures of the scene, expressed in the frames of segments. */
#include <math.h>
#include <string.h>

#include "tools/isoc/mechanism/builder.h"
#include "tools/isoc/scene/names.h"

/* The last common ancestor of two segments. */
int common_segment(const mechanism *m, int a, int b)
{
    while (a != b) {
        /* A parent stands before its children. */
        if (a > b) {
            a = m->segments[a].parent;
        } else {
            b = m->segments[b].parent;
        }
    }
    return a;
}

bool place_end(builder *b, const placement *p, matrix aligned, closure_end *end)
{
    graph *g = b->g;
    matrix turned;
    vector origin;
    const int on = stand_on(b, p, &turned, &origin);
    if (on == -1 || (on >= 0 && !b->made.frames[on].placed)) {
        return false;
    }
    const body_frame ground = {GROUND, matrix_identity(g), vector_zero(g), true};
    const body_frame frame = on == -2 ? ground : b->made.frames[on];
    end->body = on == -2 ? GROUND : on;
    end->segment = frame.segment;
    end->turn = matrix_snap(g, matrix_product(g, frame.turn, matrix_product(g, turned, aligned)));
    end->point = vector_add(g, matrix_apply(g, frame.turn, origin), frame.offset);
    return true;
}

/* Between two bodies. */
static bool build_between(builder *b, const closure_statement *written, closure *made)
{
    double axis[3];
    matrix aligned = matrix_identity(b->g);
    if (written->axis != NULL && unit_axis(b, written->axis, axis)) {
        aligned = align(b->g, axis, &made->axis, &made->sign);
    }
    bool good = place_end(b, &written->parent, aligned, &made->parent);
    good = place_end(b, &written->child, aligned, &made->child) && good;
    if (!good) {
        return false;
    }
    if (made->parent.segment == made->child.segment) {
        source_problem(b->s, written->name.at, "'%s' closes nothing: '%s' and '%s' do not move relative to each other",
                       written->name.text, written->parent.body.text, written->child.body.text);
        return false;
    }
    made->base = common_segment(&b->made, made->parent.segment, made->child.segment);
    if (written->wheel != NULL && unit_axis(b, written->wheel, axis)) {
        const vector axle = {{constant(b->g, axis[0]), constant(b->g, axis[1]), constant(b->g, axis[2])}};
        made->wheel = matrix_apply(b->g, made->child.turn, matrix_apply(b->g, matrix_transpose(aligned), axle));
        made->is_disc = true;
    }
    const bool rolls = written->kind == CLOSE_ROLLING;
    made->length = scalar_value(b, rolls ? written->radius : written->length, metre, rolls ? "a radius" : "a length");
    if (rolls && made->parent.segment != GROUND) {
        source_problem(b->s, written->parent.body.at, "a ball can roll only on the ground: parent ground");
    }
    const bool sized = rolls || written->kind == CLOSE_DISTANCE;
    if (sized && (rolls || written->length != NULL) && !(value_now(&b->values, made->length) > 0.0)) {
        source_problem(b->s, rolls && written->radius != NULL ? written->radius->at : written->name.at,
                       "a %s must be larger than zero", rolls ? "radius" : "length");
        return false;
    }
    return true;
}

int coordinate_of(builder *b, name n)
{
    if (n.text == NULL || b->written->broken) {
        return -1;
    }
    for (int i = 0; i < b->made.segment_count; i++) {
        if (strcmp(b->made.segments[i].name, n.text) == 0 && b->made.segments[i].kind != JOINT_SPHERICAL) {
            return i;
        }
    }
    const int found = find_joint(b->s, b->written, n);
    if (found >= 0) {
        source_problem(b->s, n.at, "this needs one coordinate; the joint '%s' has none or several", n.text);
    }
    return -1;
}

dimension coordinate_dimension(const segment *l)
{
    return l->kind == JOINT_PRISMATIC ? metre : radian;
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
static bool build_gear(builder *b, const closure_statement *written, closure *made)
{
    made->parent.segment = coordinate_of(b, written->first);
    made->child.segment = coordinate_of(b, written->second);
    if (made->parent.segment < 0 || made->child.segment < 0) {
        return false;
    }
    if (made->parent.segment == made->child.segment) {
        source_problem(b->s, written->second.at, "a gear needs two joints; both are '%s'", written->second.text);
        return false;
    }
    const segment *first = &b->made.segments[made->parent.segment],
                  *second_segment = &b->made.segments[made->child.segment];
    dimension of = coordinate_dimension(first);
    dimension_times(&of, coordinate_dimension(second_segment), -1);
    made->ratio = scalar_value(b, written->ratio, of, "the ratio of this gear");
    made->length = constant(b->g, first->start[0] - value_now(&b->values, made->ratio) * second_segment->start[0]);
    made->whole = whole_turns(b, first, second_segment, made->ratio);
    made->in_speed = (first->continuous || second_segment->continuous) && is_zero(b->g, made->whole);
    return true;
}

static void build_closure(builder *b, const closure_statement *written)
{
    const node zero = constant(b->g, 0.0);
    closure made = {
        .name = written->name.text, .at = written->name.at, .kind = written->kind, .base = GROUND, .sign = 1.0};
    made.length = made.ratio = made.motion = made.motion_rate = made.motion_bias = made.whole = zero;
    if (written->broken) {
        return;
    }
    const bool good = written->kind == CLOSE_GEAR     ? build_gear(b, written, &made)
                      : written->kind == CLOSE_MOTION ? build_motion(b, written, &made)
                                                      : build_between(b, written, &made);
    if (good) {
        b->made.closures[b->made.closure_count++] = made;
    }
}

/* --- stabilisation --- */

static double option(builder *b, const formula *f, dimension of, const char *what, double fallback, double least)
{
    const double number = value_constant(&b->values, f, of, what, fallback);
    if (f != NULL && !(number >= least)) {
        source_problem(b->s, f->at, "%s must be at least %g", what, least);
        return fallback;
    }
    return number;
}

/* What is done about a tick near a singular position. The energy can be held where closures do no work, and where the step is
 * made from its start alone: what a history keeps of a step near there would act later. */
static void build_near(builder *b, const name *near)
{
    mechanism *made = &b->made;
    if (near->text == NULL) {
        return;
    }
    made->near_stops = strcmp(near->text, "stop") == 0;
    made->near_holds = strcmp(near->text, "hold") == 0;
    if (made->projections == 0) {
        source_problem(b->s, near->at,
                       "only a projection watches for singular positions: leave out omega and mu, or near");
    }
    if (made->near_holds && (ISO_PAST_KEPT(made->recipe) > 0 || ISO_IS_VARYING(made->recipe))) {
        source_problem(b->s, near->at, "near hold needs a method without a history, such as rk4 or rosenbrock");
    }
    for (int i = 0; i < made->closure_count && made->near_holds; i++) {
        if (made->closures[i].kind == CLOSE_MOTION) {
            source_problem(b->s, near->at, "near hold needs closures that do no work: '%s' is a motion",
                           made->closures[i].name);
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
    static const dimension rate = {0, 0, -1, 0, 0, 0, 0};
    const stabilisation *written = &b->written->stabilisation;
    mechanism *made = &b->made;
    const char *kind = written->kind.text == NULL ? "projection" : written->kind.text;
    const bool is_lagrangian = strcmp(kind, "lagrangian") == 0, is_baumgarte = strcmp(kind, "baumgarte") == 0;
    const bool draws = is_baumgarte || (is_lagrangian && (written->omega != NULL || written->mu != NULL));
    const double usual = draws ? 0.1 / method_step(made) : 0.0;
    made->alpha = option(b, written->alpha, rate, "alpha", usual, 0.0);
    made->beta = option(b, written->beta, rate, "beta", written->alpha != NULL ? made->alpha : usual, 0.0);
    made->multiplier_iterations = 1;
    if (is_lagrangian) {
        const double omega = option(b, written->omega, rate, "omega", usual, 0.0);
        made->beta = omega;
        made->alpha = omega * option(b, written->mu, no_unit, "mu", 1.0, 0.0);
        made->is_redundant = true;
        made->penalty = option(b, written->penalty, kilogram, "the penalty", 0.0, 1e-9);
        made->multiplier_iterations =
            (int)option(b, written->iterations, no_unit, "the number of iterations", 6.0, 1.0);
        made->projections = draws ? 0 : 1;
    } else if (strcmp(kind, "projection") == 0) {
        made->projections = (int)option(b, written->iterations, no_unit, "the number of iterations", 1.0, 1.0);
    }
    build_near(b, &written->near);
    made->violation_limit = value_displacement(&b->values, written->limit, "the limit", 0.0);
    if (made->violation_limit < 0.0) {
        source_problem(b->s, written->limit->at, "the limit must be at least 0");
    }
}

void build_closures(builder *b)
{
    b->made.closures = arena_take(b->s->memory, b->written->closure_count + 1, sizeof *b->made.closures);
    b->made.clocks.first = b->made.position_count;
    for (size_t i = 0; i < b->written->closure_count; i++) {
        build_closure(b, &b->written->closures[i]);
    }
    b->made.position_count += b->made.clocks.count;
    build_stabilisation(b);
}
