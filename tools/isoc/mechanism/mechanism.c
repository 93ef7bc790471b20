/* Joints: the bodies that they connect, and the tree of segments that carries them. */
#include "tools/isoc/mechanism/builder.h"

void connect_joints(builder *b)
{
    for (size_t i = 0; i < b->written->joints.count; i++) {
        const joint *j = &b->written->joints.all[i];
        matrix turned;
        vector origin;
        b->parents[i] = stand_on(b, &j->parent, &turned, &origin);
        const int child = stand_on(b, &j->child, &turned, &origin);
        b->children[i] = -1;
        if (child == -2) {
            source_problem(b->s, j->child.body.at, "the ground cannot be a child: swap parent and child");
        } else if (child >= 0 && child == b->parents[i]) {
            source_problem(b->s, j->child.body.at, "a joint needs two bodies; both are '%s'", j->child.body.text);
        } else if (child >= 0 && b->weights[child].joint >= 0) {
            const name *first = &b->written->joints.all[b->weights[child].joint].name;
            source_problem(b->s, j->child.body.at,
                           "'%s' is already the child of the joint '%s' in %s: a closure closes the loop: closure NAME "
                           "KIND { ... }",
                           j->child.body.text, first->text, source_line(b->s, first->at));
        } else if (child >= 0) {
            b->children[i] = child;
            b->weights[child].joint = (int)i;
        }
    }
}

/* --- the tree --- */

/* Adds a part of a body to its segment, or to the ground, and returns it in that frame. */
static composite weld_lump(builder *b, const lump *part, const body_frame *frame)
{
    graph *g = b->g;
    const vector com = vector_add(g, matrix_apply(g, frame->turn, part->com), frame->offset);
    composite own = {part->mass, vector_scale(g, part->mass, com), tensor_zero(g)};
    if (frame->segment == GROUND) {
        b->mechanism.bodies.ground_mass = add(g, b->mechanism.bodies.ground_mass, own.mass);
        b->mechanism.bodies.ground_moment = vector_add(g, b->mechanism.bodies.ground_moment, own.ms);
        return own;
    }
    segment *l = &b->mechanism.segments[frame->segment];
    const tensor turned = tensor_rotate(g, frame->turn, part->inertia);
    own.inertia = tensor_shift(g, turned, part->mass, vector_zero(g), com);
    l->own.inertia = tensor_add(g, l->own.inertia, own.inertia);
    l->own.ms = vector_add(g, l->own.ms, own.ms);
    l->own.mass = add(g, l->own.mass, own.mass);
    return own;
}

static composite weld(builder *b, const weight *whole, const body_frame *frame)
{
    graph *g = b->g;
    composite sum = {constant(g, 0.0), vector_zero(g), tensor_zero(g)};
    for (size_t i = 0; i < whole->lump_count; i++) {
        const composite part = weld_lump(b, &whole->lumps[i], frame);
        sum.mass = add(g, sum.mass, part.mass);
        sum.ms = vector_add(g, sum.ms, part.ms);
        sum.inertia = tensor_add(g, sum.inertia, part.inertia);
    }
    return sum;
}

/* Connects the child of a joint to its parent, whose frame is known, by a chain of segments. */
static void hang(builder *b, size_t i)
{
    graph *g = b->g;
    const joint *j = &b->written->joints.all[i];
    const body_frame parent = frame_on(b, b->parents[i]);
    body_frame *child = &b->mechanism.bodies.frames[b->children[i]];

    matrix on_parent, on_child;
    vector at_parent, at_child;
    stand_on(b, &j->parent, &on_parent, &at_parent);
    stand_on(b, &j->child, &on_child, &at_child);

    /* From the axes of the last segment to those of the joint: the axis of a segment is one of its own coordinate axes.
     */
    body_frame last = {parent.segment, matrix_product(g, parent.turn, on_parent), vector_zero(g), true};
    last.offset = vector_add(g, matrix_apply(g, parent.turn, at_parent), parent.offset);
    segment segments[PARTS_OF_A_JOINT];
    matrix aligned[PARTS_OF_A_JOINT];
    const int count = joint_segments(b, j, segments, aligned);
    for (int n = 0; n < count; n++) {
        segment *result = &b->mechanism.segments[b->mechanism.segment_count];
        *result = segments[n];
        result->parent = last.segment;
        result->turn = matrix_snap(g, matrix_product(g, last.turn, aligned[n]));
        result->offset = last.offset;
        result->position = b->mechanism.position_count;
        result->dof = b->mechanism.dof_count;
        b->mechanism.position_count += positions_of(result->kind);
        b->mechanism.dof_count += dofs_of(result->kind);
        last = (body_frame){b->mechanism.segment_count++, matrix_transpose(aligned[n]), vector_zero(g), true};
    }
    child->segment = last.segment;
    child->turn = matrix_snap(g, matrix_product(g, last.turn, matrix_transpose(on_child)));
    const vector back = matrix_apply(g, child->turn, vector_sub(g, vector_zero(g), at_child));
    child->offset = vector_add(g, last.offset, back);
    child->placed = true;

    member *result = &b->mechanism.bodies.members[b->children[i]];
    *result = (member){.joint = j->name.text, .parent = b->parents[i] == -2 ? GROUND : b->parents[i]};
    result->hinge = last.offset;
    result->own = weld(b, &b->weights[b->children[i]], child);
}

/* Connects joints whose parent is placed, in the order of the scene, until there are no more. */
void build_tree(builder *b)
{
    const size_t joints = b->written->joints.count;
    bool *hung = arena_take(b->s->memory, joints + 1, sizeof *hung);
    for (bool going = true; going;) {
        going = false;
        for (size_t i = 0; i < joints && !going; i++) {
            const int parent = b->parents[i];
            const bool placed = parent == -2 || (parent >= 0 && b->mechanism.bodies.frames[parent].placed);
            if (!hung[i] && placed && b->children[i] >= 0) {
                hang(b, i);
                hung[i] = going = true;
            }
        }
    }
    /* The rest is part of a loop, or its parent is unknown. */
    for (size_t i = 0; i < joints; i++) {
        int above = (int)i;
        size_t steps = 0;
        while (above >= 0 && b->parents[above] >= 0 && steps++ <= joints) {
            above = b->weights[b->parents[above]].joint;
        }
        if (!hung[i] && b->children[i] >= 0 && steps > joints) {
            source_problem(b->s, b->written->joints.all[i].name.at,
                           "the joint '%s' is part of a loop that is not connected to the ground",
                           b->written->joints.all[i].name.text);
        }
    }
    bool known = !b->written->broken;
    for (size_t i = 0; i < joints; i++) {
        known = known && b->children[i] >= 0 && !b->written->joints.all[i].broken;
    }
    for (size_t i = 0; i < b->written->bodies.count && known; i++) {
        if (b->weights[i].joint < 0) {
            source_problem(b->s, b->written->bodies.all[i].name.at,
                           "the body '%s' is not the child of a joint: one that floats needs a free joint",
                           b->written->bodies.all[i].name.text);
        }
    }
}

void check_whole(builder *b)
{
    source *s = b->s;
    const scene *written = b->written;
    if (written->broken) {
        return;
    }
    const place end = s->scripts[0]->length;
    if (written->step == NULL) {
        source_problem(s, end, "the scene has no step: step 1 ms");
    }
    /* A joint with an error of its own has no state. */
    bool moves = state_count(&b->mechanism) > 0;
    for (size_t i = 0; i < written->joints.count; i++) {
        moves = moves || written->joints.all[i].kind != JOINT_FIXED;
    }
    if (!moves) {
        source_problem(s, end,
                       "nothing moves: the scene has neither a joint that is not fixed nor an effect with a state");
    }
    if (written->outputs.count == 0) {
        source_problem(s, end, "the scene has no output: output angle = position of a joint");
    }
}

builder builder_of(source *s, graph *g, const scene *written, bool is_double, const mechanism *whole)
{
    builder b = {.s = s, .g = g, .written = written, .whole = whole};
    mechanism *m = &b.mechanism;
    const size_t bodies = written->bodies.count, joints = written->joints.count;
    b.weights = arena_take(s->memory, bodies + 1, sizeof *b.weights);
    b.parents = arena_take(s->memory, joints + 1, sizeof *b.parents);
    b.children = arena_take(s->memory, joints + 1, sizeof *b.children);
    *m = (mechanism){.name = written->name, .source = s, .is_double = is_double};
    m->bodies.ground_mass = constant(g, 0.0);
    m->bodies.ground_moment = vector_zero(g);
    m->segments = arena_take(s->memory, PARTS_OF_A_JOINT * joints + 1, sizeof *m->segments);
    m->bodies.frames = arena_take(s->memory, bodies + written->frames.count + 1, sizeof *m->bodies.frames);
    m->bodies.members = arena_take(s->memory, bodies + 1, sizeof *m->bodies.members);
    m->bodies.count = (int)bodies;
    values_start(&b.values, s, g, written, 0, is_double);
    return b;
}
