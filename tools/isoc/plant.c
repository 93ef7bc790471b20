#include "tools/isoc/emit.h"

static int turn_index(const mechanism *m, int link_wanted)
{
    int index = 0;
    for (int i = 0; i < link_wanted; i++) {
        index += m->links[i].continuous;
    }
    return index;
}

static node joint_output(const plant *p, graph *g, const output *o, int i)
{
    switch (o->kind) {
    case OUTPUT_POSITION:
        return p->d.motions[i].q;
    case OUTPUT_SPEED:
        return p->d.motions[i].qd;
    case OUTPUT_TURNS:
        return leaf(g, OP_TURNS, turn_index(p->m, i));
    default:
        return leaf(g, OP_SLOPE, p->m->link_count + i);
    }
}

static void add_output(plant *p, const char *label, node shown)
{
    p->output_names[p->output_count] = label;
    p->outputs[p->output_count++] = shown;
}

/* A body's point: its position or velocity, whole or along one axis. */
static void add_point(plant *p, graph *g, size_t i)
{
    const output *o = &p->m->outputs[i];
    const body_frame *frame = &p->m->frames[p->m->output_body[i]];
    const vector in_link = vector_add(g, matrix_apply(g, frame->turn, p->m->points[i]), frame->offset);
    const vector made = o->kind == OUTPUT_POSITION ? point_position(&p->d, frame->link, in_link)
                                                   : point_velocity(&p->d, frame->link, in_link);
    for (int k = 0; k < 3; k++) {
        if (o->along < 0) {
            add_output(p, arena_format(g->memory, "%s_%c", o->name.text, "xyz"[k]), made.at[k]);
        } else if (o->along == k) {
            add_output(p, o->name.text, made.at[k]);
        }
    }
}

static void build_outputs(plant *p, graph *g)
{
    const mechanism *m = p->m;
    dynamics_velocities(&p->d);
    const node energy = dynamics_energy(&p->d);
    graph_section(g, "Points in the ground's frame");
    for (size_t i = 0; i < m->output_count; i++) {
        const output *o = &m->outputs[i];
        if (o->kind == OUTPUT_ENERGY) {
            add_output(p, o->name.text, energy);
        } else if (o->kind == OUTPUT_LOCAL_ERROR || o->kind == OUTPUT_RESIDUAL) {
            add_output(p, o->name.text, leaf(g, o->kind == OUTPUT_RESIDUAL ? OP_RESIDUAL : OP_LOCAL_ERROR, 0));
        } else if (m->output_link[i] >= 0) {

            add_output(p, o->name.text, joint_output(p, g, o, m->output_link[i]));
        } else {
            add_point(p, g, i);
        }
    }
}

plant plant_build(graph *g, const mechanism *m, bool is_double)
{
    plant p = {.m = m, .input_count = m->input_count, .is_double = is_double};
    p.output_names = arena_take(g->memory, 3 * m->output_count + 1, sizeof *p.output_names);
    p.outputs = arena_take(g->memory, 3 * m->output_count + 1, sizeof *p.outputs);
    p.slopes = arena_take(g->memory, 2 * (size_t)m->link_count, sizeof *p.slopes);
    p.d = dynamics_build(g, m);
    for (int i = 0; i < m->link_count; i++) {
        p.slopes[i] = p.d.motions[i].qd;
        p.slopes[m->link_count + i] = p.d.acceleration[i];
        p.turn_count += m->links[i].continuous;
    }
    if (ISO_IS_IMPLICIT(m->recipe)) {
        p.j = jacobian_build(g, &p.d);
    }
    build_outputs(&p, g);
    return p;
}
