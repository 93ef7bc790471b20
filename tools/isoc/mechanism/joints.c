/* A joint as the chain of links that it is. */
#include <math.h>

#include "tools/isoc/graph/quaternion.h"
#include "tools/isoc/mechanism/builder.h"
#include "tools/isoc/scene/names.h"

static const double half_turn = 3.14159265358979323846;

/* --- numbers of the start --- */

static dimension per_second(dimension of)
{
    dimension_times(&of, second, -1);
    return of;
}

/* `count` constants; zeros where nothing is written. */
static void constants(builder *b, const formula *f, dimension of, int count, const char *what, double *numbers)
{
    value v = {0};
    if (f != NULL) {
        v = value_of(&b->values, f, of, count, what);
    }
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
    if (n >= j->start.turn_count || j->start.turns[n].angle == NULL) {
        return 0.0;
    }
    const formula *f = j->start.turns[n].angle;
    const double angle = value_constant(&b->values, f, radian, "an angle", 0.0);
    if (fabs(angle) > largest_angle) {
        source_problem(b->s, f->at, "the start is beyond %g rad", largest_angle);
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
            source_problem(b->s, f->at, "a quaternion of length zero is no orientation: quaternion (1, 0, 0, 0)");
        }
        return;
    }
    const placement turned = {.turns = j->start.turns, .turn_count = j->start.turn_count};
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

/* A part that slides along or turns about one of its axes, or turns freely. */
static link part(builder *b, const joint *j, joint_kind kind, const char *ending, int axis, double sign)
{
    const bool turns = kind != JOINT_PRISMATIC;
    link made = {.name = arena_format(b->s->memory, "%s%s", j->name.text, ending), .at = j->name.at, .kind = kind};
    made.axis = axis;
    made.sign = sign;
    made.drive = -1;
    made.mass = made.spring = made.rest = constant(b->g, 0.0);
    made.first_moment = vector_zero(b->g);
    made.inertia = tensor_zero(b->g);
    made.start_given = made.speed_given = true;

    dimension resistance = turns ? newton_metre : newton;
    dimension_times(&resistance, per_second(turns ? radian : metre), -1);
    const formula *damping = turns && j->kind != JOINT_REVOLUTE ? j->spin_damping : j->damping;
    made.damping = scalar_value(b, damping, resistance, "the damping of this joint");
    if (value_now(&b->values, made.damping) < 0.0) {
        source_problem(b->s, damping->at, "damping is not negative: it takes energy away");
    }
    return made;
}

/* The only coordinate of a revolute or prismatic joint, with its effects. */
static link single(builder *b, const joint *j, int axis, double sign)
{
    link made = part(b, j, j->kind, "", axis, sign);
    const bool turns = j->kind == JOINT_REVOLUTE;
    const dimension coordinate = turns ? radian : metre;
    dimension stiffness = turns ? newton_metre : newton;
    dimension_times(&stiffness, coordinate, -1);

    const formula *start = j->start.coordinate;
    made.start[0] = value_constant(&b->values, start, coordinate, "the start of this joint", 0.0);
    made.start_is_rough = j->start.is_rough;
    made.start_given = start != NULL && !j->start.is_rough;
    if (turns && fabs(made.start[0]) > (j->continuous ? half_turn : largest_angle)) {
        source_problem(b->s, start->at, "the start is beyond %s", j->continuous ? "180 deg" : "10000 rad");
    }
    made.speed[0] = value_constant(&b->values, j->speed, per_second(coordinate), "the speed of this joint", 0.0);
    made.speed_given = j->speed != NULL;
    made.spring = scalar_value(b, j->spring, stiffness, "the spring of this joint");
    made.rest = scalar_value(b, j->rest, coordinate, "the rest of this spring");
    made.drive = j->drive.text == NULL ? -1 : find_input(b->s, b->written, j->drive);
    made.continuous = j->continuous;
    if (j->continuous) {
        refuse(b, j->spring, "a spring", "on a continuous joint, whose angle starts anew each turn");
    }
    return made;
}

static int universal_parts(builder *b, const joint *j, link *parts, matrix *aligned)
{
    static const char *const endings[] = {"_first", "_second"};
    const formula *const axes[] = {j->axis, j->second};
    double spins[2], axis[2][3] = {{0.0}};
    constants(b, j->spin, per_second(radian), 2, "the spin of a universal joint", spins);
    for (int n = 0; n < 2; n++) {
        if (axes[n] == NULL || !unit_axis(b, axes[n], axis[n])) {
            return 0;
        }
        int k;
        double sign;
        aligned[n] = align(b->g, axis[n], &k, &sign);
        parts[n] = part(b, j, JOINT_REVOLUTE, endings[n], k, sign);
        parts[n].start[0] = start_angle(b, j, (size_t)n);
        parts[n].start_given = (size_t)n < j->start.turn_count;
        parts[n].speed[0] = spins[n];
        parts[n].speed_given = j->spin != NULL;
    }
    double across = 0.0;
    for (int i = 0; i < 3; i++) {
        across += axis[0][i] * axis[1][i];
    }
    if (fabs(across) > 1.0 - 1e-6) {
        source_problem(b->s, j->second->at, "the two axes of a universal joint differ: axis x, second y");
    }
    return 2;
}

static int cylindrical_parts(builder *b, const joint *j, int k, double sign, link *parts)
{
    parts[0] = part(b, j, JOINT_PRISMATIC, "_slide", k, sign);
    constants(b, j->start.position, metre, 1, "the place of a cylindrical joint", parts[0].start);
    constants(b, j->speed, per_second(metre), 1, "the speed of a cylindrical joint", parts[0].speed);
    parts[0].start_given = j->start.position != NULL;
    parts[0].speed_given = j->speed != NULL;
    parts[1] = part(b, j, JOINT_REVOLUTE, "_turn", k, sign);
    return 2;
}

/* Slides along two axes, or three, from a place given in the joint's frame. `back` turns from there to the axes. */
static int slide_parts(builder *b, const joint *j, matrix back, int first, int count, link *parts)
{
    static const char *const endings[] = {"_x", "_y", "_z"};
    double place_given[3], speed[3];
    constants(b, j->start.position, metre, 3, "the place of this joint", place_given);
    constants(b, j->speed, per_second(metre), 3, "the speed of this joint", speed);
    for (int n = 0; n < count; n++) {
        const int k = (first + n) % 3;
        parts[n] = part(b, j, JOINT_PRISMATIC, endings[k], k, 1.0);
        parts[n].start_given = j->start.position != NULL;
        parts[n].speed_given = j->speed != NULL;
        for (int i = 0; i < 3; i++) {
            const double along = constant_value(b->g, back.at[k][i]);
            parts[n].start[0] += along * place_given[i];
            parts[n].speed[0] += along * speed[i];
        }
    }
    return count;
}

/* A place or a speed of a planar joint lies in its plane. */
static void check_plane(builder *b, const formula *f, dimension of, matrix back, int normal)
{
    double given[3], out = 0.0, size = 0.0;
    constants(b, f, of, 3, "a vector", given);
    for (int i = 0; i < 3; i++) {
        out += constant_value(b->g, back.at[normal][i]) * given[i];
        size += fabs(given[i]);
    }
    if (fabs(out) > 1e-12 * size) {
        source_problem(b->s, f->at, "out of the joint's plane, which its axis is normal to");
    }
}

static int free_parts(builder *b, const joint *j, link *parts)
{
    const int slid = j->kind == JOINT_FREE ? slide_parts(b, j, matrix_identity(b->g), 0, 3, parts) : 0;
    link *turned = &parts[slid];
    *turned = part(b, j, JOINT_SPHERICAL, j->kind == JOINT_FREE ? "_turn" : "", 0, 1.0);
    start_quaternion(b, j, turned->start);
    turned->start_given = j->start.quaternion != NULL || j->start.turn_count > 0;
    constants(b, j->spin, per_second(radian), 3, "the spin of this joint", turned->speed);
    turned->speed_given = j->spin != NULL;
    return slid + 1;
}

int joint_parts(builder *b, const joint *j, link parts[LINKS_OF_A_JOINT], matrix aligned[LINKS_OF_A_JOINT])
{
    double axis[3];
    int k = 0, count = 0;
    double sign = 1.0;
    matrix turned = matrix_identity(b->g);
    if (j->kind == JOINT_UNIVERSAL) {
        return universal_parts(b, j, parts, aligned);
    }
    if (j->axis != NULL && unit_axis(b, j->axis, axis)) {
        turned = align(b->g, axis, &k, &sign);
    }
    for (int n = 0; n < LINKS_OF_A_JOINT; n++) {
        aligned[n] = turned;
    }
    const matrix back = matrix_transpose(turned);
    switch (j->kind) {
    case JOINT_REVOLUTE:
    case JOINT_PRISMATIC:
        parts[0] = single(b, j, k, sign);
        return 1;
    case JOINT_SPHERICAL:
    case JOINT_FREE:
        return free_parts(b, j, parts);
    case JOINT_CYLINDRICAL:
        count = cylindrical_parts(b, j, k, sign, parts);
        break;
    case JOINT_PLANAR:
        check_plane(b, j->start.position, metre, back, k);
        check_plane(b, j->speed, per_second(metre), back, k);
        count = slide_parts(b, j, back, k + 1, 2, parts) + 1;
        parts[2] = part(b, j, JOINT_REVOLUTE, "_turn", k, sign);
        break;
    default:
        return 0;
    }
    /* What turns about the axis, last. */
    link *turning = &parts[count - 1];
    turning->start[0] = start_angle(b, j, 0);
    turning->start_given = j->start.turn_count > 0;
    constants(b, j->spin, per_second(radian), 1, "the spin of this joint", turning->speed);
    turning->speed_given = j->spin != NULL;
    return count;
}

/* Every link's degrees of degree of freedom, one after the other. */
void list_dofs(builder *b)
{
    static const char *const endings[] = {"_x", "_y", "_z"};
    mechanism *made = &b->made;
    made->dofs = arena_take(b->s->memory, (size_t)made->dof_count + 1, sizeof *made->dofs);
    for (int i = 0; i < made->link_count; i++) {
        const link *l = &made->links[i];
        const link *parent = l->parent == GROUND ? NULL : &made->links[l->parent];
        const bool is_ball = l->kind == JOINT_SPHERICAL;
        int before = parent == NULL ? GROUND : parent->dof + dofs_of(parent->kind) - 1;
        for (int n = 0; n < dofs_of(l->kind); n++) {
            const char *called = arena_format(b->s->memory, "%s%s", l->name, is_ball ? endings[n] : "");
            made->dofs[l->dof + n] = (dof){i, is_ball ? n : l->axis, before, called};
            before = l->dof + n;
        }
    }
}
