/* Forces of inputs on bodies. */
#include "tools/isoc/mechanism/builder.h"
#include "tools/isoc/scene/names.h"

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
    if (pushed < 0 || drive < 0 || written->axis == NULL || !unit_axis(b, written->axis, axis)) {
        return;
    }
    const body_frame *frame = &b->mechanism.bodies.frames[pushed];
    if (!frame->placed || frame->segment == GROUND) {
        if (frame->placed) {
            source_problem(b->s, written->at.body.at, "'%s' is fixed to the ground: a force on it has no effect",
                           written->at.body.text);
        }
        return;
    }
    applied_force result = {.body = pushed, .segment = frame->segment, .drive = drive, .lever = lever};
    result.point = vector_add(g, matrix_apply(g, frame->turn, point), frame->offset);
    result.axis = matrix_apply(g, frame->turn, matrix_apply(g, turned, vector_of(g, axis[0], axis[1], axis[2])));
    b->mechanism.forces.applied[b->mechanism.forces.applied_count++] = result;
}

void build_applied_forces(builder *b)
{
    b->mechanism.forces.applied = arena_take(b->s->memory, b->written->forces.count + count_forces(b->written) + 1,
                                             sizeof *b->mechanism.forces.applied);
    for (size_t i = 0; i < b->written->forces.count; i++) {
        build_applied_force(b, &b->written->forces.all[i]);
    }
}
