/* Where joints, frames, closures and forces stand on bodies and segments. */
#include <math.h>

#include "tools/isoc/mechanism/builder.h"

bool unit_axis(builder *b, const formula *f, double axis[3])
{
    const value v = value_of(&b->values, f, no_unit, 3, "an axis");
    if (v.count == 0) {
        return false;
    }
    double square = 0.0;
    for (int i = 0; i < 3; i++) {
        if (!is_constant(b->g, v.parts[i])) {
            return source_problem(b->s, f->at, "an axis cannot depend on a tunable parameter");
        }
        axis[i] = constant_value(b->g, v.parts[i]);
        square += axis[i] * axis[i];
    }
    if (!(square > 0.0) || !isfinite(square)) {
        return source_problem(b->s, f->at, "the axis has no direction: its length is %s",
                              square > 0.0 ? "infinite" : "zero");
    }
    const double length = sqrt(square);
    for (int i = 0; i < 3; i++) {
        axis[i] /= length;
    }
    return true;
}

/* The turn by an angle about a unit axis (Rodrigues 1840): c 1 + s [a]x + (1 - c) a a'. */
static matrix rodrigues(graph *g, const double a[3], double angle)
{
    const double s = constant_value(g, sine(g, constant(g, angle)));
    const double c = constant_value(g, cosine(g, constant(g, angle)));
    matrix r;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            const double cross = i == j ? 0.0 : (j == (i + 1) % 3 ? -1.0 : 1.0) * a[3 - i - j];
            r.at[i][j] = constant(g, (i == j ? c : 0.0) + s * cross + (1.0 - c) * a[i] * a[j]);
        }
    }
    return matrix_snap(g, r);
}

/* The joint's frame on a body: R = R1 R2 ..., and its origin. */
void place_joint(builder *b, const placement *p, matrix *turn_made, vector *origin)
{
    *origin = vector_value(b, p->position, metre, "a position");
    *turn_made = matrix_identity(b->g);
    FOR_EACH (const turn, t, p->turns) {
        double axis[3];
        if (t->angle == NULL || t->axis == NULL || !unit_axis(b, t->axis, axis)) {
            continue;
        }
        double angle = value_constant(&b->values, t->angle, radian, "an angle", 0.0);
        if (fabs(angle) > largest_angle) {
            source_problem(b->s, t->angle->at, "an angle must be within %g rad", largest_angle);
            angle = 0.0;
        }
        *turn_made = matrix_snap(b->g, matrix_product(b->g, *turn_made, rodrigues(b->g, axis, angle)));
    }
}

/* Frames that stand on one another, from the last to the first: p in a frame is o + R p in its parent. */
int stand_on(builder *b, const placement *p, matrix *turn_made, vector *origin)
{
    const scene *written = b->written;
    place_joint(b, p, turn_made, origin);
    int on = p->body.text == NULL ? -1 : find_body(b->s, written, p->body);
    for (size_t steps = 0; on >= (int)written->bodies.count; steps++) {
        const named_frame *under = &written->frames.all[(size_t)on - written->bodies.count];
        if (steps >= written->frames.count) {
            source_problem(b->s, under->name.at, "the frame '%s' stands on itself", under->name.text);
            return -1;
        }
        matrix turned;
        vector from;
        place_joint(b, &under->on, &turned, &from);
        *origin = vector_add(b->g, matrix_apply(b->g, turned, *origin), from);
        *turn_made = matrix_snap(b->g, matrix_product(b->g, turned, *turn_made));
        on = under->on.body.text == NULL ? -1 : find_body(b->s, written, under->on.body);
    }
    return on;
}

body_frame frame_on(const builder *b, int on)
{
    const body_frame ground = {GROUND, matrix_identity(b->g), vector_zero(b->g), true};
    return on == -2 ? ground : b->mechanism.bodies.frames[on];
}

void build_frames(builder *b)
{
    graph *g = b->g;
    const size_t bodies = b->written->bodies.count;
    for (size_t i = 0; i < b->written->frames.count; i++) {
        matrix turned;
        vector origin;
        const int on = stand_on(b, &b->written->frames.all[i].on, &turned, &origin);
        if (on >= 0 || on == -2) {
            const body_frame under = frame_on(b, on);
            body_frame *result = &b->mechanism.bodies.frames[bodies + i];
            *result = under;
            result->turn = matrix_snap(g, matrix_product(g, under.turn, turned));
            result->offset = vector_add(g, matrix_apply(g, under.turn, origin), under.offset);
        }
    }
}

/* Turns the frame so that the axis is one of its own: *k and *sign say which. The identity for x, y, z, -x, -y, -z. */
matrix align(graph *g, const double a[3], int *k, double *sign)
{
    for (int i = 0; i < 3; i++) {
        if (fabs(a[i]) == 1.0) {
            *k = i;
            *sign = a[i];
            return matrix_identity(g);
        }
    }
    /* z along the axis, x across it and across the coordinate axis that is farthest from it. */
    int far = 0;
    for (int i = 1; i < 3; i++) {
        far = fabs(a[i]) < fabs(a[far]) ? i : far;
    }
    const int i = (far + 1) % 3, j = (far + 2) % 3;
    const double length = sqrt(a[i] * a[i] + a[j] * a[j]);
    double x[3] = {0.0}, y[3];
    x[i] = a[j] / length;
    x[j] = -a[i] / length;
    for (int n = 0; n < 3; n++) {
        y[n] = a[(n + 1) % 3] * x[(n + 2) % 3] - a[(n + 2) % 3] * x[(n + 1) % 3];
    }
    matrix r;
    for (int row = 0; row < 3; row++) {
        r.at[row][0] = constant(g, x[row]);
        r.at[row][1] = constant(g, y[row]);
        r.at[row][2] = constant(g, a[row]);
    }
    *k = 2;
    *sign = 1.0;
    return r;
}

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
    if (on == -1 || (on >= 0 && !b->mechanism.bodies.frames[on].placed)) {
        return false;
    }
    const body_frame frame = frame_on(b, on);
    end->body = on == -2 ? GROUND : on;
    end->segment = frame.segment;
    end->turn = matrix_snap(g, matrix_product(g, frame.turn, matrix_product(g, turned, aligned)));
    end->point = vector_add(g, matrix_apply(g, frame.turn, origin), frame.offset);
    return true;
}
