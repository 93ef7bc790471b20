/* Forces on bodies: of springs and dampers between points, and of inputs. */
#include "tools/isoc/mechanism/builder.h"

static void build_applied_force(builder *b, const body_force *written)
{
    graph *g = b->g;
    double axis[3];
    if (written->broken) {
        return;
    }
    matrix turned;
    vector point;
    const int pushed = stand_on(b, &written->at, &turned, &point);
    const int drive = find_input(b->s, b->written, written->drive);
    const node lever = scalar_value(b, written->moment, metre, "the moment of a force for each newton");
    if (pushed == -2) {
        source_problem(b->s, written->at.body.at, "a force on the ground has no effect");
    }
    if (pushed < 0 || drive < 0 || written->axis == NULL || !unit_axis(b, written->axis, axis) ||
        !b->mechanism.bodies.frames[pushed].placed) {
        return;
    }
    const body_frame *frame = &b->mechanism.bodies.frames[pushed];
    if (frame->segment == GROUND) {
        source_problem(b->s, written->at.body.at, "'%s' is fixed to the ground: a force on it has no effect",
                       written->at.body.text);
        return;
    }
    applied_force result = {.body = pushed, .segment = frame->segment, .drive = drive, .lever = lever};
    result.point = vector_add(g, matrix_apply(g, frame->turn, point), frame->offset);
    result.axis = matrix_apply(g, frame->turn, matrix_apply(g, turned, vector_of(g, axis[0], axis[1], axis[2])));
    force_set *all = &b->mechanism.forces;
    ADD_TO(b->s->memory, all->applied, all->applied_count, b->applied_room, result);
}

void build_applied_forces(builder *b)
{
    for (size_t i = 0; i < b->written->forces.count; i++) {
        build_applied_force(b, &b->written->forces.all[i]);
    }
}

static const dimension per_metre = DIMENSION(1, 0, -2, 0, 0, 0), per_speed = DIMENSION(1, 0, -1, 0, 0, 0);

static node positive(builder *b, const formula *f, dimension expected, const char *what)
{
    const node n = scalar_value(b, f, expected, what);
    if (!keeps_not_below_zero(&b->values, n)) {
        source_problem(b->s, f->at, "%s must not be negative", what);
    }
    return n;
}

static void build_spring(builder *b, const spring_statement *written)
{
    point_spring result = {.name = written->name.text, .at = written->name.at, .base = GROUND};
    if (written->broken) {
        return;
    }
    result.stiffness = positive(b, written->stiffness, per_metre, "a stiffness");
    result.damping = positive(b, written->damping, per_speed, "a damping");
    result.length = positive(b, written->length, metre, "a length");
    if (written->stiffness == NULL && written->damping == NULL) {
        source_problem(b->s, result.at, "the spring '%s' has neither stiffness nor damping: stiffness 100 N/m",
                       result.name);
    } else if ((written->stiffness != NULL) != (written->length != NULL)) {
        source_problem(b->s, result.at,
                       written->length == NULL ? "the spring '%s' has no length, at which it is slack: length 0.1 m"
                                               : "the spring '%s' has a length and no stiffness: stiffness 100 N/m",
                       result.name);
    }
    const bool found = place_end(b, &written->first, matrix_identity(b->g), &result.first);
    if (!place_end(b, &written->second, matrix_identity(b->g), &result.second) || !found) {
        return;
    }
    if (result.first.segment == result.second.segment) {
        source_problem(b->s, result.at, "'%s' has no effect: '%s' and '%s' do not move relative to each other",
                       result.name, written->first.body.text, written->second.body.text);
        return;
    }
    result.base = common_segment(&b->mechanism, result.first.segment, result.second.segment);
    b->mechanism.forces.springs[b->mechanism.forces.spring_count++] = result;
}

void build_springs(builder *b)
{
    b->mechanism.forces.springs =
        arena_take(b->s->memory, b->written->springs.count + 1, sizeof *b->mechanism.forces.springs);
    for (size_t i = 0; i < b->written->springs.count; i++) {
        build_spring(b, &b->written->springs.all[i]);
    }
}
