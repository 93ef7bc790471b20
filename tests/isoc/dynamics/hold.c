#include "tests/isoc/dynamics/hold.h"

#include <string.h>

#include "tests/isoc/dynamics/wide3.h"

/* What is asked of the place of the child's origin, and of its axes. */
typedef enum place_held { ANYWHERE, AT_POINT, ON_LINE, IN_PLANE, AT_DISTANCE } place_held;
typedef enum axes_held { ANY_AXES, SAME_AXES, SAME_AXIS, SQUARE_AXES, TURNED } axes_held;

/* Holds of a coordinate. */
enum { ANGLE = MOTION + 1, DISPLACEMENT };

/* Two unit vectors square to the axis and to each other. */
typedef struct square_axes {
    wide first[3], second[3];
} square_axes;

static const struct {
    place_held place;
    axes_held axes;
} kinds[] = {
    [FIXED] = {AT_POINT, SAME_AXES},       [REVOLUTE] = {AT_POINT, SAME_AXIS},   [PRISMATIC] = {ON_LINE, SAME_AXES},
    [UNIVERSAL] = {AT_POINT, SQUARE_AXES}, [CYLINDRICAL] = {ON_LINE, SAME_AXIS}, [PLANAR] = {IN_PLANE, SAME_AXIS},
    [SPHERICAL] = {AT_POINT, ANY_AXES},    [FREE] = {ANYWHERE, ANY_AXES},        [LINE] = {ON_LINE, ANY_AXES},
    [DISTANCE] = {AT_DISTANCE, ANY_AXES},  [ROLLING] = {ANYWHERE, ANY_AXES},     [ANGLE] = {ANYWHERE, TURNED},
    [DISPLACEMENT] = {IN_PLANE, ANY_AXES},
};

hold hold_of_joint(const mechanism *const m, const int j)
{
    const tree_joint *const of = &m->joint[j];
    hold h = {(int)of->kind, of->parent, j, of->on_parent, of->on_child, {0.0L}, {0.0L}, 0.0L};
    memcpy(h.axis, of->axis, sizeof h.axis);
    memcpy(h.second, of->second, sizeof h.second);
    return h;
}

hold hold_of_closure(const mechanism *const m, const int n)
{
    const loop_closure *const of = &m->closure[n];
    hold h = {(int)of->kind, of->parent, of->child, of->on_parent, of->on_child, {0.0L}, {0.0L}, of->length};
    memcpy(h.axis, of->axis, sizeof h.axis);
    memcpy(h.second, of->wheel, sizeof h.second);
    return h;
}

hold hold_of_coordinate(const mechanism *const m, const int j, const wide q)
{
    hold h = hold_of_joint(m, j);
    h.kind = h.kind == REVOLUTE ? ANGLE : DISPLACEMENT;
    h.length = q;
    unit(m->joint[j].axis, h.axis);
    return h;
}

/* A direction of a frame, in the world. */
static jet3 direction(const pose *const frame, const wide e[3])
{
    return jet33_apply(&frame->turn, jet3_constant(e));
}

static int place_rows(const hold *const h, const pose *const p, const pose *const c, const square_axes *const square,
                      jet *const row)
{
    static const wide axes[3][3] = {{1.0L, 0.0L, 0.0L}, {0.0L, 1.0L, 0.0L}, {0.0L, 0.0L, 1.0L}};
    const jet3 from = jet3_add(c->origin, jet3_scale(-1.0L, p->origin));
    switch (kinds[h->kind].place) {
    case AT_POINT:
        for (int i = 0; i < 3; i++) {
            row[i] = jet3_dot(direction(p, axes[i]), from);
        }
        return 3;
    case ON_LINE:
        row[0] = jet3_dot(direction(p, square->first), from);
        row[1] = jet3_dot(direction(p, square->second), from);
        return 2;
    case IN_PLANE:
        row[0] = jet_add(jet3_dot(direction(p, h->axis), from), jet_constant(-h->length));
        return 1;
    case AT_DISTANCE:
        row[0] = jet_add(jet3_dot(from, from), jet_constant(-h->length * h->length));
        return 1;
    default:
        return 0;
    }
}

static int axes_rows(const hold *const h, const pose *const p, const pose *const c, const square_axes *const square,
                     jet *const row)
{
    static const wide axes[3][3] = {{1.0L, 0.0L, 0.0L}, {0.0L, 1.0L, 0.0L}, {0.0L, 0.0L, 1.0L}};
    switch (kinds[h->kind].axes) {
    case SAME_AXES:
        for (int i = 0; i < 3; i++) {
            row[i] = jet3_dot(direction(p, axes[i]), direction(c, axes[(i + 1) % 3]));
        }
        return 3;
    case SAME_AXIS:
        row[0] = jet3_dot(direction(p, square->first), direction(c, h->axis));
        row[1] = jet3_dot(direction(p, square->second), direction(c, h->axis));
        return 2;
    case SQUARE_AXES:
        row[0] = jet3_dot(direction(p, h->axis), direction(c, h->second));
        return 1;
    case TURNED: {
        /* The sine of the angle less h->length, where it is zero. */
        wide turned[3] = {0.0L, 0.0L, 0.0L};
        accumulate(turned, -cosl(h->length), square->first);
        accumulate(turned, -sinl(h->length), square->second);
        row[0] = jet3_dot(direction(p, turned), direction(c, square->second));
        return 1;
    }
    default:
        return 0;
    }
}

/* The equations for the poses of the parent and of the child, of which one may be the ground. */
static int equations(const hold *const h, const pose bodies[2], jet row[HELD_MAX])
{
    wide e[3] = {0.0L, 0.0L, 1.0L};
    square_axes square;
    if (dot(h->axis, h->axis) > 0.0L) {
        unit(h->axis, e);
    }
    across(e, square.first, square.second);
    const pose p = frame_on(h->parent == GROUND ? NULL : &bodies[0], &h->on_parent);
    const pose c = frame_on(h->child == GROUND ? NULL : &bodies[1], &h->on_child);
    const int places = place_rows(h, &p, &c, &square, row);
    return places + axes_rows(h, &p, &c, &square, row + places);
}

/* The pose of a body that stands as `moved` does and turns with omega, its centre of mass accelerated by a, itself by
 * alpha: R'' = (alpha x + omega x omega x) R, o'' likewise. */
static pose accelerated(const body_motion *const moved, const pose *const at, const wide omega[3], const wide a[3],
                        const wide alpha[3])
{
    pose b = *at;
    wide com[3];
    wide origin[3];
    part(moved->com, 0, com);
    part(at->origin, 0, origin);
    for (int column = 0; column < 4; column++) {
        wide arm[3];
        wide turned[3];
        wide swung[3];
        wide second[3];
        for (int i = 0; i < 3; i++) {
            arm[i] = column < 3 ? at->turn.m[i][column].c[0] : origin[i] - com[i];
        }
        cross(omega, arm, turned);
        cross(omega, turned, second);
        cross(alpha, arm, swung);
        for (int i = 0; i < 3; i++) {
            jet *const to = column < 3 ? &b.turn.m[i][column] : &b.origin.x[i];
            to->c[2] = (second[i] + swung[i] + (column < 3 ? 0.0L : a[i])) / 2.0L;
        }
    }
    return b;
}

/* The pose without its velocity. */
static pose at_rest(const pose *const moving)
{
    pose b;
    for (int i = 0; i < 3; i++) {
        b.origin.x[i] = jet_constant(moving->origin.x[i].c[0]);
        for (int j = 0; j < 3; j++) {
            b.turn.m[i][j] = jet_constant(moving->turn.m[i][j].c[0]);
        }
    }
    return b;
}

/* From the centre of a ball or disc to the plane with the normal n: -length u, with u = n, or n less its part along the
 * axle a, u = (n - c a) / s, c = n.a, s^2 = 1 - c^2. With its rate for a' = omega x a, as jets, and s. */
static jet3 to_plane(const hold *const h, const wide n[3], const wide axle[3], const wide omega[3], wide *const s)
{
    wide turned[3];
    jet3 lever;
    const wide c = dot(n, axle);
    cross(omega, axle, turned);
    const wide c_rate = dot(n, turned);
    *s = sqrtl(1.0L - c * c);
    const wide s_rate = -c * c_rate / *s;
    for (int i = 0; i < 3; i++) {
        const wide u = (n[i] - c * axle[i]) / *s;
        const wide u_rate = (-c_rate * axle[i] - c * turned[i] - u * s_rate) / *s;
        lever.x[i] = (jet){{-h->length * u, -h->length * u_rate, 0.0L}};
    }
    return lever;
}

/* The point of the child that touches the plane, at r from its frame's origin o, has no velocity, v(o) + omega x r = 0,
 * along the normal n and two directions across it. The first of these is the rate of n.(o - p) = length s. */
static void add_rolling(const hold *const h, const body_motion *const child, held *const made)
{
    wide n[3], e[3][3], o[3], p[3], com[3], arm[3], omega[3], velocity[3], axle[3], r[3], r_rate[3], turned[3],
        swung[3], s;
    const pose plane = frame_on(NULL, &h->on_parent), frame = frame_on(&child->body, &h->on_child);
    part(direction(&plane, h->axis), 0, n);
    part(direction(&frame, h->second), 0, axle);
    unit(n, e[0]);
    across(e[0], e[1], e[2]);
    part(plane.origin, 0, p);
    part(frame.origin, 0, o);
    part(child->com, 0, com);
    part(child->velocity, 0, velocity);
    part(child->omega, 0, omega);
    difference(o, com, arm);
    const jet3 lever = to_plane(h, e[0], axle, omega, &s);
    part(lever, 0, r);
    part(lever, 1, r_rate);
    cross(omega, arm, turned);
    cross(omega, turned, swung);
    cross(omega, r_rate, turned);
    for (; made->rows < 3; made->rows++) {
        const int row = made->rows;
        wide *const factor = made->of_child[row];
        wide about[3];
        memcpy(factor, e[row], sizeof e[row]);
        cross(arm, e[row], factor + 3);
        cross(r, e[row], about);
        accumulate(factor + 3, 1.0L, about);
        made->value[row] = row == 0 ? dot(n, o) - dot(n, p) - h->length * s : 0.0L;
        made->rate[row] = dot(factor, velocity) + dot(factor + 3, omega);
        made->bias[row] = dot(e[row], swung) + dot(e[row], turned);
    }
}

held hold_linearise(const hold *const h, const body_motion moved[BODIES_MAX])
{
    static const wide zero[3] = {0.0L, 0.0L, 0.0L};
    const int of[2] = {h->parent, h->child};
    pose coasting[2] = {0};
    pose still[2] = {0};
    jet row[HELD_MAX];
    held made = {0};
    for (int side = 0; side < 2; side++) {
        if (of[side] != GROUND) {
            const body_motion *const b = &moved[of[side]];
            wide omega[3];
            part(b->omega, 0, omega);
            coasting[side] = accelerated(b, &b->body, omega, zero, zero);
            still[side] = at_rest(&b->body);
        }
    }
    made.rows = equations(h, coasting, row);
    for (int r = 0; r < made.rows; r++) {
        made.value[r] = row[r].c[0];
        made.rate[r] = row[r].c[1];
        made.bias[r] = 2.0L * row[r].c[2];
    }
    /* From rest, second derivatives are linear in the accelerations, with the factors that rates have in velocities. */
    for (int side = 0; side < 2; side++) {
        for (int k = 0; k < 6 && of[side] != GROUND; k++) {
            wide pushed[6] = {0.0L};
            pose bodies[2] = {still[0], still[1]};
            pushed[k] = 1.0L;
            bodies[side] = accelerated(&moved[of[side]], &still[side], zero, pushed, pushed + 3);
            (void)equations(h, bodies, row);
            for (int r = 0; r < made.rows; r++) {
                (side == 0 ? made.of_parent : made.of_child)[r][k] = 2.0L * row[r].c[2];
            }
        }
    }
    if (h->kind == ROLLING) {
        add_rolling(h, &moved[h->child], &made);
    }
    return made;
}
