/* A joint as a chain of segments. */
#include <math.h>
#include <string.h>

#include "tools/isoc/mechanism/builder.h"

static const double half_turn = 3.14159265358979323846;

/* --- numbers of the start --- */

/* `count` constants; zeros where nothing is written. */
static void constants(builder *b, const formula *f, dimension expected, int count, const char *what, double *numbers)
{
    const value v = f == NULL ? nothing : value_of(&b->values, f, expected, count, what);
    for (int i = 0; i < count; i++) {
        const bool known = i < v.count && is_constant(b->g, v.parts[i]);
        numbers[i] = known ? constant_value(b->g, v.parts[i]) : 0.0;
        if (i < v.count && !known) {
            source_problem(b->s, f->at, "%s cannot depend on a tunable parameter", what);
            return;
        }
    }
}

/* Angle n of the start. */
static double start_angle(builder *b, const joint *j, size_t n)
{
    const placement *turned = &j->start.place;
    if (n >= turned->turns.count || turned->turns.all[n].angle == NULL) {
        return 0.0;
    }
    const formula *f = turned->turns.all[n].angle;
    const double angle = value_constant(&b->values, f, radian, "an angle", 0.0);
    if (fabs(angle) > largest_angle) {
        source_problem(b->s, f->at, "the start must be within %g rad", largest_angle);
    }
    return angle;
}

static void start_quaternion(builder *b, const joint *j, double q[4])
{
    const formula *f = j->start.quaternion;
    if (f != NULL) {
        const size_t problems = b->s->problem_count;
        constants(b, f, no_unit, 4, "a quaternion", q);
        const double norm = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        for (int i = 0; i < 4; i++) {
            q[i] = norm > 0.0 ? q[i] / norm : 0.0;
        }
        if (!(norm > 0.0) && b->s->problem_count == problems) {
            source_problem(b->s, f->at, "a quaternion of length zero is not an orientation: quaternion (1, 0, 0, 0)");
        }
        return;
    }
    placement turned = j->start.place;
    turned.position = NULL;
    matrix r;
    vector origin;
    double numbers[3][3];
    place_joint(b, &turned, &r, &origin);
    for (int i = 0; i < 9; i++) {
        numbers[i / 3][i % 3] = constant_value(b->g, r.at[i / 3][i % 3]);
    }
    quaternion_of_matrix(numbers, q);
}

/* --- parts --- */

/* A segment that slides along or turns about one of its axes, or turns freely. */
static segment part(builder *b, const joint *j, joint_kind kind, const char *ending, int axis, double sign)
{
    const bool turns = kind != JOINT_PRISMATIC;
    segment result = {.at = j->name.at, .kind = kind, .axis = axis, .sign = sign, .drive = -1};
    result.name = arena_format(b->s->memory, "%s%s", j->name.text, ending);
    result.own.mass = result.spring = result.rest = result.armature = constant(b->g, 0.0);
    result.own.ms = vector_zero(b->g);
    result.own.inertia = tensor_zero(b->g);
    result.origin.start_given = result.origin.speed_given = true;

    const dimension resistance = dimension_of_unit(turns ? "N*m*s/rad" : "N*s/m");
    const formula *damping = turns && !joint_has_one_coordinate(j->kind) ? j->spin_damping : j->damping;
    result.damping = scalar_value(b, damping, resistance, "the damping of this joint");
    if (!keeps_not_below_zero(&b->values, result.damping)) {
        source_problem(b->s, damping->at, "damping must not be negative");
    }
    return result;
}

/* An inertia that the speeds of a part alone move. */
static void give_armature(builder *b, const formula *written, segment *part_made)
{
    const bool turns = part_made->kind != JOINT_PRISMATIC;
    part_made->armature = scalar_value(b, written, turns ? moment_of_inertia : kilogram, "the armature of this joint");
    if (!keeps_not_below_zero(&b->values, part_made->armature)) {
        source_problem(b->s, written->at, "an armature must not be negative");
    }
}

/* The segment of a joint with one coordinate, with damping, spring and drive. */
static segment single(builder *b, const joint *j, int axis, double sign)
{
    segment result = part(b, j, joint_rows[j->kind].parts[0].kind, "", axis, sign);
    const bool turns = result.kind == JOINT_REVOLUTE;
    const dimension coordinate = turns ? radian : metre;
    const dimension stiffness = dimension_of_unit(turns ? "N*m/rad" : "N/m");

    const formula *start = j->start.coordinate;
    result.start[0] = value_constant(&b->values, start, coordinate, "the start of this joint", 0.0);
    result.origin.start_is_rough = j->start.is_rough;
    result.origin.start_given = start != NULL && !j->start.is_rough;
    if (turns && fabs(result.start[0]) > (j->continuous ? half_turn : largest_angle)) {
        source_problem(b->s, start->at, "the start must be within %s", j->continuous ? "180 deg" : "10000 rad");
    }
    result.speed[0] = value_constant(&b->values, j->speed, dimension_of_unit(turns ? "rad/s" : "m/s"),
                                     "the speed of this joint", 0.0);
    result.origin.speed_given = j->speed != NULL;
    result.spring = scalar_value(b, j->spring, stiffness, "the spring of this joint");
    result.rest = scalar_value(b, j->rest, coordinate, "the rest of this spring");
    give_armature(b, j->armature, &result);
    result.drive = j->drive.text == NULL ? -1 : find_input(b->s, b->written, j->drive);
    result.continuous = j->continuous;
    if (j->continuous && j->spring != NULL) {
        source_problem(b->s, j->spring->at, "a continuous joint cannot have a spring: its angle is kept within a turn");
    }
    return result;
}

/* The axes of a joint: `axis`, `second` and those of its frame. */
typedef struct joint_axes {
    matrix turned[2]; /* of axis and second: the frame in which it is coordinate axis k, times sign */
    int k[2];
    double sign[2];
} joint_axes;

static joint_axes axes_of(builder *b, const joint *j)
{
    const formula *const written[] = {j->axis, j->second};
    const matrix own = matrix_identity(b->g);
    joint_axes result = {{own, own}, {0, 0}, {1.0, 1.0}};
    double axis[2][3] = {{0.0}}, across = 0.0;
    for (int n = 0; n < 2; n++) {
        if (written[n] != NULL && unit_axis(b, written[n], axis[n])) {
            result.turned[n] = align(b->g, axis[n], &result.k[n], &result.sign[n]);
        }
    }
    for (int i = 0; i < 3; i++) {
        across += axis[0][i] * axis[1][i];
    }
    if (fabs(across) > 1.0 - 1e-6) {
        source_problem(b->s, j->second->at, "the axes of a %s joint must differ: axis x, second y",
                       joint_rows[j->kind].word);
    }
    return result;
}

/* The frame in which a part moves along or about the coordinate axis *k times *sign. */
static matrix part_frame(builder *b, const joint_axes *axes, part_axis along, int *k, double *sign)
{
    const int which = along == ALONG_SECOND;
    const bool in_frame = along == NO_AXIS || along >= ALONG_X;
    *k = along >= ALONG_X ? (int)along - (int)ALONG_X : in_frame ? 0 : axes->k[which];
    *sign = along == ALONG_AXIS || along == ALONG_SECOND ? axes->sign[which] : 1.0;
    if (along == ACROSS_AXIS || along == ACROSS_BOTH) {
        *k = (*k + (along == ACROSS_AXIS ? 1 : 2)) % 3;
    }
    return in_frame ? matrix_identity(b->g) : axes->turned[which];
}

/* The start of a joint with several coordinates. Position and speed are one number if it has one sliding axis, else a
 * vector. */
typedef struct given {
    int sliding;
    double position[3], speed[3], spin[3];
} given;

/* Place and speed of a joint that slides along two axes must lie in their plane. */
static void check_plane(builder *b, const formula *f, const double at[3], const joint_axes *axes)
{
    const matrix back = matrix_transpose(axes->turned[0]);
    double out = 0.0, size = 0.0;
    for (int i = 0; i < 3; i++) {
        out += constant_value(b->g, back.at[axes->k[0]][i]) * at[i];
        size += fabs(at[i]);
    }
    if (fabs(out) > 1e-12 * size) {
        source_problem(b->s, f->at, "the vector must lie in the joint's plane, which is normal to its axis");
    }
}

static given read_given(builder *b, const joint *j, const joint_axes *axes)
{
    const int turning = joint_parts_that(j->kind, JOINT_REVOLUTE);
    given result = {.sliding = joint_parts_that(j->kind, JOINT_PRISMATIC)};
    if (result.sliding > 0) {
        const int count = result.sliding == 1 ? 1 : 3;
        constants(b, j->start.place.position, metre, count, "the place of this joint", result.position);
        constants(b, j->speed, dimension_of_unit("m/s"), count, "the speed of this joint", result.speed);
    }
    if (result.sliding == 2) {
        check_plane(b, j->start.place.position, result.position, axes);
        check_plane(b, j->speed, result.speed, axes);
    }
    const int count = joint_parts_that(j->kind, JOINT_SPHERICAL) > 0 ? 3 : turning;
    if (count > 0) {
        constants(b, j->spin, dimension_of_unit("rad/s"), count, "the spin of this joint", result.spin);
    }
    return result;
}

static void start_sliding(builder *b, const joint *j, const given *from, matrix turned, segment *part_made)
{
    part_made->origin.start_given = j->start.place.position != NULL;
    part_made->origin.speed_given = j->speed != NULL;
    if (from->sliding == 1) {
        part_made->start[0] = from->position[0];
        part_made->speed[0] = from->speed[0];
        return;
    }
    for (int i = 0; i < 3; i++) {
        const double along = constant_value(b->g, turned.at[i][part_made->axis]);
        part_made->start[0] += along * from->position[i];
        part_made->speed[0] += along * from->speed[i];
    }
}

/* The n-th part that turns about an axis. */
static void start_turning(builder *b, const joint *j, const given *from, int n, segment *part_made)
{
    part_made->start[0] = start_angle(b, j, (size_t)n);
    part_made->origin.start_given = (size_t)n < j->start.place.turns.count;
    part_made->speed[0] = from->spin[n];
    part_made->origin.speed_given = j->spin != NULL;
}

/* The spin in the axes of the joint's frame on the ground; false, after noting a problem, where it is on none. */
static bool spin_from_ground(builder *b, const joint *j, double spin[3])
{
    matrix turned;
    vector origin;
    const int on = stand_on(b, &j->parent, &turned, &origin);
    if (on >= 0 && b->mechanism.bodies.frames[on].segment != GROUND) {
        return source_problem(b->s, j->spin_axes_at,
                              "the joint '%s' is not on the ground: give its spin in the child's axes", j->name.text);
    }
    if (on >= 0) {
        turned = matrix_product(b->g, b->mechanism.bodies.frames[on].turn, turned);
    }
    const double given_spin[3] = {spin[0], spin[1], spin[2]};
    for (int i = 0; i < 3; i++) {
        spin[i] = 0.0;
        for (int n = 0; n < 3; n++) {
            spin[i] += constant_value(b->g, turned.at[n][i]) * given_spin[n];
        }
    }
    return true;
}

/* From the joint's frame to the child's axes, which are turned by the unit quaternion: w' = w - 2 (q0 t - q x t), t = q
 * x w for the vector part q. */
static void spin_to_child(const double q[4], double w[3])
{
    double t[3];
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        t[i] = q[1 + j] * w[k] - q[1 + k] * w[j];
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        w[i] -= 2.0 * (q[0] * t[i] - (q[1 + j] * t[k] - q[1 + k] * t[j]));
    }
}

static void start_ball(builder *b, const joint *j, const given *from, segment *part_made)
{
    start_quaternion(b, j, part_made->start);
    part_made->origin.start_given = j->start.quaternion != NULL || j->start.place.turns.count > 0;
    memcpy(part_made->speed, from->spin, sizeof part_made->speed);
    part_made->origin.speed_given = j->spin != NULL;
    if (!j->spin_in_ground) {
        return;
    }
    if (!part_made->origin.start_given && b->written->closures.count > 0) {
        source_problem(b->s, j->spin_axes_at, "a spin in the axes of the ground needs the start of the joint '%s'",
                       j->name.text);
    } else if (spin_from_ground(b, j, part_made->speed)) {
        spin_to_child(part_made->start, part_made->speed);
    }
}

int joint_segments(builder *b, const joint *j, segment segments[PARTS_OF_A_JOINT], matrix aligned[PARTS_OF_A_JOINT])
{
    const joint_part *parts = joint_rows[j->kind].parts;
    const int count = joint_parts_count(j->kind);
    const joint_axes axes = axes_of(b, j);
    const double lead = value_constant(&b->values, j->pitch, metre, "the pitch of this joint", 0.0) / (2.0 * half_turn);
    if (joint_has_one_coordinate(j->kind)) {
        aligned[0] = axes.turned[0];
        segments[0] = single(b, j, axes.k[0], axes.sign[0]);
        segments[0].lead = lead;
        return 1;
    }
    const given from = read_given(b, j, &axes);
    for (int n = 0, turning = 0; n < count; n++) {
        int k;
        double sign;
        aligned[n] = part_frame(b, &axes, parts[n].axis, &k, &sign);
        segments[n] = part(b, j, parts[n].kind, parts[n].ending == NULL ? effect_endings[k] : parts[n].ending, k, sign);
        segments[n].lead = parts[n].advances ? lead : 0.0;
        give_armature(b, parts[n].kind == JOINT_PRISMATIC ? j->armature : j->spin_armature, &segments[n]);
        if (parts[n].kind == JOINT_PRISMATIC) {
            start_sliding(b, j, &from, aligned[n], &segments[n]);
        } else if (parts[n].kind == JOINT_REVOLUTE) {
            if (j->spin_in_ground) {
                source_problem(b->s, j->spin_axes_at, "a %s joint turns about its own axes: give its spin about these",
                               joint_rows[j->kind].word);
            }
            start_turning(b, j, &from, turning++, &segments[n]);
        } else {
            start_ball(b, j, &from, &segments[n]);
        }
    }
    return count;
}

void list_dofs(builder *b)
{
    mechanism *m = &b->mechanism;
    m->dofs = arena_take(b->s->memory, (size_t)m->dof_count + 1, sizeof *m->dofs);
    for (int i = 0; i < m->segment_count; i++) {
        const segment *l = &m->segments[i];
        const segment *parent = l->parent == GROUND ? NULL : &m->segments[l->parent];
        const bool is_ball = l->kind == JOINT_SPHERICAL;
        int before = parent == NULL ? GROUND : parent->dof + dofs_of(parent->kind) - 1;
        for (int n = 0; n < dofs_of(l->kind); n++) {
            const char *called = arena_format(b->s->memory, "%s%s", l->name, is_ball ? effect_endings[n] : "");
            m->dofs[l->dof + n] = (dof){i, is_ball ? n : l->axis, before, called};
            before = l->dof + n;
        }
    }
}
