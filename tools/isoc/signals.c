#include <string.h>

#include "tools/isoc/builder.h"
#include "tools/isoc/names.h"

void build_inputs(builder *b)
{
    mechanism *made = &b->made;
    made->input_count = (int)b->written->input_count;
    made->input_names = arena_take(b->s->memory, b->written->input_count + 1, sizeof *made->input_names);
    made->jumps = arena_take(b->s->memory, b->written->input_count + 1, sizeof *made->jumps);
    made->drives = arena_take(b->s->memory, b->written->input_count + 1, sizeof *made->drives);
    b->values.time_allowed = true;
    graph_section(b->g, "Inputs as functions of time");
    for (int i = 0; i < made->input_count; i++) {
        const quantity *q = &b->written->inputs[i];
        bool force = false, torque = false;
        for (size_t j = 0; j < b->written->joint_count; j++) {
            const joint *user = &b->written->joints[j];
            if (user->drive.text != NULL && q->name.text != NULL && strcmp(user->drive.text, q->name.text) == 0) {
                force = force || user->kind == JOINT_PRISMATIC;
                torque = torque || user->kind == JOINT_REVOLUTE;
            }
        }
        if (q->name.text == NULL || (!force && !torque && b->written->broken)) {
            continue;
        }
        if (!force && !torque) {
            source_problem(b->s, q->name.at, "the input '%s' drives no joint: write 'drive %s' in one", q->name.text,
                           q->name.text);
        } else if (force && torque) {
            source_problem(b->s, q->name.at, "the input '%s' drives a revolute and a prismatic joint", q->name.text);
        }
        made->input_names[i] = q->name.text;
        const dimension effort = torque ? newton_metre : newton;
        const char *what = torque ? "a torque" : "a force";
        made->drives[i] = scalar_value(b, force || torque ? q->value : NULL, effort, what);
        made->jumps[i] =
            value_constant(&b->values, force || torque ? q->jump : NULL, effort, what, q->jump != NULL ? 1.0 : 0.0);
        if (q->jump != NULL && !(made->jumps[i] > 0.0)) {
            source_problem(b->s, q->jump->at, "a jump is larger than zero");
        }
    }
    b->values.time_allowed = false;
}

static void check_joint_output(builder *b, const output *o, const joint *j)
{
    if (j->kind == JOINT_FIXED) {
        source_problem(b->s, o->of.at, "the joint '%s' is fixed: it has no coordinate", o->of.text);
    } else if (o->kind == OUTPUT_VELOCITY) {
        source_problem(b->s, o->kind_at, "a joint has a speed; a velocity is a body's");
    } else if (o->kind == OUTPUT_TURNS && !j->continuous) {
        source_problem(b->s, o->kind_at, "only a continuous joint counts its turns");
    }
    refuse(b, o->point, "a point", "of a joint: only a body has points");
    if (o->along >= 0) {
        source_problem(b->s, o->along_at, "'along' with a joint: only a body's position and velocity have components");
    }
}

static int link_of_joint(const mechanism *made, const char *joint_name)
{
    for (int i = 0; i < made->link_count; i++) {
        if (strcmp(made->links[i].name, joint_name) == 0) {
            return i;
        }
    }
    return -1;
}

void build_outputs(builder *b)
{
    const scene *written = b->written;
    mechanism *made = &b->made;
    made->outputs = written->outputs;
    made->output_count = written->output_count;
    made->points = arena_take(b->s->memory, written->output_count + 1, sizeof *made->points);
    made->output_link = arena_take(b->s->memory, written->output_count + 1, sizeof *made->output_link);
    made->output_body = arena_take(b->s->memory, written->output_count + 1, sizeof *made->output_body);
    for (size_t i = 0; i < written->output_count; i++) {
        const output *o = &written->outputs[i];
        made->output_link[i] = made->output_body[i] = -1;
        made->points[i] = vector_value(b, o->point, metre, "a point");
        bool is_joint = false;
        const int of =
            o->kind == OUTPUT_ENERGY || o->of.text == NULL ? -1 : find_joint_or_body(b->s, written, o->of, &is_joint);
        if (of >= 0 && is_joint) {
            check_joint_output(b, o, &written->joints[of]);
            made->output_link[i] = link_of_joint(made, written->joints[of].name.text);
        } else if (of >= 0) {
            made->output_body[i] = of;
            if (o->kind != OUTPUT_POSITION && o->kind != OUTPUT_VELOCITY) {
                source_problem(b->s, o->kind_at, "a body has a position and a velocity; this is a joint's");
            }
        }
    }
}

void build_parameters(builder *b)
{
    const scene *written = b->written;
    mechanism *made = &b->made;
    made->parameter_names = arena_take(b->s->memory, written->parameter_count + 1, sizeof *made->parameter_names);
    for (size_t i = 0; i < written->parameter_count; i++) {
        if (written->parameters[i].tunable) {
            made->parameter_names[made->parameter_count++] = written->parameters[i].name.text;
        }
    }
    made->defaults = b->values.defaults;
}
