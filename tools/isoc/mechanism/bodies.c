/* The masses of bodies: a mass with its centre and inertia, or solids. */
#include <math.h>
#include <stdbool.h>

#include "tools/isoc/base/numbers.h"
#include "tools/isoc/mechanism/builder.h"

/* Rounding in a tensor that was computed by hand or rotated: relative to its trace. */
static const double slack = 1e-9;

/* All principal minors of a symmetric matrix are at least zero, to rounding. */
static bool semidefinite(const double t[6], double scale)
{
    const double xx = t[0], yy = t[1], zz = t[2], xy = t[3], xz = t[4], yz = t[5];
    const double determinant = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
    const double low = -slack * scale, low2 = low * scale, low3 = low2 * scale;
    return xx >= low && yy >= low && zz >= low && xx * yy - xy * xy >= low2 && xx * zz - xz * xz >= low2 &&
           yy * zz - yz * yz >= low2 && determinant >= low3;
}

/* By how much of their sum the largest principal moment of a tensor (xx, yy, zz, xy, xz, yz) is larger than the other
 * two. */
static double excess(const double t[6])
{
    double moments[3], axes[3][3];
    principal_axes(t, moments, axes);
    const double largest = fmax(moments[0], fmax(moments[1], moments[2]));
    return largest / (moments[0] + moments[1] + moments[2] - largest) - 1.0;
}

/* Notes what is wrong with the tensor of a body about its centre of mass. One that is as it was given may be beyond the
 * triangle inequality, which no body is: the mass matrix is positive all the same. */
static void check_inertia(builder *b, const formula *f, const double t[6], bool is_as_given, const char *whose)
{
    const double scale = fabs(t[0]) + fabs(t[1]) + fabs(t[2]);
    /* The second moments of the mass, half the trace times 1 minus the tensor, are a sum of squares. */
    const double half = (t[0] + t[1] + t[2]) / 2;
    const double moments[6] = {half - t[0], half - t[1], half - t[2], -t[3], -t[4], -t[5]};
    if (!semidefinite(t, scale)) {
        source_problem(b->s, f->at, "the inertia of '%s' is not positive definite: a principal moment is negative",
                       whose);
    } else if (!semidefinite(moments, scale) && is_as_given) {
        source_warn(b->s, f->at,
                    "no body has the inertia of '%s', which is as given: a principal moment is %.3g %% larger than the "
                    "sum of the other two",
                    whose, 100.0 * excess(t));
    } else if (!semidefinite(moments, scale)) {
        source_problem(b->s, f->at,
                       "the inertia of '%s' is impossible: a principal moment is larger than the sum of the other two; "
                       "behind it 'as_given' takes what was measured so",
                       whose);
    }
}

/* A tensor that must be possible; zero where nothing is written. */
static tensor inertia_value(builder *b, const formula *f, bool is_as_given, const char *whose)
{
    const node zero = constant(b->g, 0.0);
    tensor t = tensor_zero(b->g);
    if (f == NULL) {
        return t;
    }
    value v = value_of(&b->values, f, moment_of_inertia, 0, "an inertia");
    if (v.count == 0) {
        return t;
    }
    double numbers[6];
    for (int i = 0; i < 6; i++) {
        v.parts[i] = i < v.count ? v.parts[i] : zero;
        numbers[i] = value_now(&b->values, v.parts[i]);
    }
    t = (tensor){v.parts[0], v.parts[1], v.parts[2], v.parts[3], v.parts[4], v.parts[5]};
    for (int axis = 0; axis < 3; axis++) {
        (void)keeps_not_below_zero(&b->values, v.parts[axis]);
    }
    check_inertia(b, f, numbers, is_as_given, whose);
    return t;
}

/* In the axes that the turns make, to the axes of the body; the place of their origin. */
static tensor place_inertia(builder *b, const placement *at, tensor t, vector *origin)
{
    matrix turned;
    place_joint(b, at, &turned, origin);
    return at->turns.count == 0 ? t : tensor_rotate(b->g, turned, t);
}

/* The tensor of a homogeneous solid. */
static tensor tensor_of_size(builder *b, const solid *written, node mass)
{
    graph *g = b->g;
    const solid_row *kind = written->kind;
    node moments[3] = {constant(g, 0.0), constant(g, 0.0), constant(g, 0.0)};
    const value size = value_of(&b->values, written->size, metre, kind->numbers,
                                arena_format(b->s->memory, "the size of a %s", kind->word));
    for (int n = 0; n < size.count; n++) {
        const node square = mul(g, size.parts[n], size.parts[n]);
        if (!keeps_not_below_zero(&b->values, size.parts[n])) {
            source_problem(b->s, written->size->at, "a size must not be negative");
            break;
        }
        for (int axis = 0; axis < 3; axis++) {
            moments[axis] = add(g, moments[axis], mul(g, constant(g, kind->moments[axis][n]), square));
        }
    }
    if (kind->hollow && size.count == 3 && !keeps(&b->values, (condition){size.parts[1], size.parts[0], false})) {
        source_problem(b->s, written->size->at, "a %s is (outer radius, inner radius, length): the first is the larger",
                       kind->word);
    }
    for (int axis = 0; axis < 3; axis++) {
        moments[axis] = mul(g, mass, moments[axis]);
    }
    const node zero = constant(g, 0.0);
    return (tensor){moments[0], moments[1], moments[2], zero, zero, zero};
}

static node mass_value(builder *b, const formula *f)
{
    return is_of_effects(b, f) ? mass_of_effects(b, f) : scalar_value(b, f, kilogram, "a mass");
}

static lump lump_of_solid(builder *b, const solid *written, const char *whose)
{
    const size_t problems = b->s->problem_count;
    lump result = {.mass = mass_value(b, written->mass)};
    if (b->s->problem_count == problems && !keeps_above_zero(&b->values, result.mass)) {
        source_problem(b->s, written->mass->at, "the mass of a solid must be larger than zero");
    }
    const tensor own = written->kind->numbers == 0 ? inertia_value(b, written->size, written->is_as_given, whose)
                                                   : tensor_of_size(b, written, result.mass);
    result.inertia = place_inertia(b, &written->at, own, &result.com);
    return result;
}

/* The mass of a body, with its centre and its inertia. */
static lump lump_of_body(builder *b, const body *written)
{
    vector none;
    const size_t problems = b->s->problem_count;
    lump result = {.mass = mass_value(b, written->mass)};
    const bool massless = is_zero(b->g, result.mass);
    if (written->mass != NULL && b->s->problem_count == problems && !massless &&
        !keeps_above_zero(&b->values, result.mass)) {
        source_problem(b->s, written->mass->at, "a mass must be larger than zero, or 0 where a body has none");
    }
    if (massless && written->mass != NULL && written->inertia != NULL && b->s->problem_count == problems) {
        source_problem(b->s, written->inertia->at, "a body without mass has no inertia");
    }
    result.com = vector_value(b, written->com, metre, "a centre of mass");
    const tensor own = inertia_value(b, written->inertia, written->is_as_given, written->name.text);
    result.inertia = place_inertia(b, &written->inertia_axes, own, &none);
    return result;
}

void build_bodies(builder *b)
{
    static const dimension acceleration = DIMENSION(0, 1, -2, 0, 0, 0);
    b->mechanism.forces.gravity = vector_value(b, b->written->gravity, acceleration, "gravity");
    for (size_t i = 0; i < b->written->bodies.count; i++) {
        const body *written = &b->written->bodies.all[i];
        weight *result = &b->weights[i];
        result->joint = -1;
        result->lump_count = written->solids.count == 0 ? 1 : written->solids.count;
        result->lumps = arena_take(b->s->memory, result->lump_count, sizeof *result->lumps);
        for (size_t n = 0; n < written->solids.count; n++) {
            result->lumps[n] = lump_of_solid(b, &written->solids.all[n], written->name.text);
        }
        if (written->solids.count == 0) {
            result->lumps[0] = lump_of_body(b, written);
        }
    }
}
