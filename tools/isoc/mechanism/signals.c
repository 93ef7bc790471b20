#include <string.h>

#include "tools/isoc/mechanism/builder.h"
#include "tools/isoc/scene/names.h"

static bool same_name(name a, name b)
{
    return a.text != NULL && b.text != NULL && strcmp(a.text, b.text) == 0;
}

void build_inputs(builder *b)
{
    mechanism *made = &b->made;
    made->input_count = (int)b->written->input_count;
    made->input_names = arena_take(b->s->memory, b->written->input_count + 1, sizeof *made->input_names);
    made->jumps = arena_take(b->s->memory, b->written->input_count + 1, sizeof *made->jumps);
    made->drives = arena_take(b->s->memory, b->written->input_count + (size_t)made->clocks.count + 1, sizeof(node));
    for (int i = 0; i < made->clocks.count; i++) {
        made->drives[made->input_count + i] = made->clocks.all[i].of_tick;
    }
    b->values.time_allowed = true;
    graph_section(b->g, "Inputs as functions of time");
    for (int i = 0; i < made->input_count; i++) {
        const quantity *q = &b->written->inputs[i];
        bool force = false, torque = false;
        for (size_t j = 0; j < b->written->joint_count; j++) {
            const joint *user = &b->written->joints[j];
            if (same_name(user->drive, q->name)) {
                force = force || user->kind == JOINT_PRISMATIC;
                torque = torque || user->kind == JOINT_REVOLUTE;
            }
        }
        for (size_t j = 0; j < b->written->force_count; j++) {
            force = force || same_name(b->written->forces[j].drive, q->name);
        }
        if (q->name.text == NULL || (!force && !torque && b->written->broken)) {
            continue;
        }
        if (!force && !torque) {
            source_problem(b->s, q->name.at, "the input '%s' drives no joint: write 'drive %s' in one", q->name.text,
                           q->name.text);
        } else if (force && torque) {
            source_problem(b->s, q->name.at, "the input '%s' is a torque in one place and a force in another",
                           q->name.text);
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

/* The coordinate that an output shows: of a joint that has one, or of a part of a joint that has more. */
static int link_called(const mechanism *made, name n)
{
    for (int i = 0; i < made->link_count; i++) {
        if (made->links[i].kind != JOINT_SPHERICAL && strcmp(made->links[i].name, n.text) == 0) {
            return i;
        }
    }
    return -1;
}

/* The parts of a joint that an output can show, as a list; or what to write instead. */
static const char *parts_of(builder *b, const joint *j)
{
    const char *list = "";
    for (int i = 0; i < b->made.link_count; i++) {
        const link *l = &b->made.links[i];
        if (l->at == j->name.at && l->kind != JOINT_SPHERICAL) {
            list = arena_format(b->s->memory, "%s%s%s", list, list[0] == '\0' ? "" : ", ", l->name);
        }
    }
    return list[0] == '\0' ? "the orientation of its child" : list;
}

static void check_joint_output(builder *b, const output *o, const joint *j)
{
    if (j->kind == JOINT_FIXED) {
        source_problem(b->s, o->of.at, "the joint '%s' is fixed: it has no coordinate", o->of.text);
    } else if (j->kind != JOINT_REVOLUTE && j->kind != JOINT_PRISMATIC) {
        source_problem(b->s, o->of.at, "the joint '%s' has more than one coordinate: show %s", o->of.text,
                       parts_of(b, j));
    } else if (o->kind == OUTPUT_VELOCITY) {
        source_problem(b->s, o->kind_at, "a joint has a speed; a velocity is a body's");
    } else if (o->kind == OUTPUT_ORIENTATION || o->kind == OUTPUT_SPIN) {
        source_problem(b->s, o->kind_at, "a joint has a position and a speed; this is a body's");
    } else if (o->kind == OUTPUT_TURNS && !j->continuous) {
        source_problem(b->s, o->kind_at, "only a continuous joint counts its turns");
    }
}

static void check_coordinate_output(builder *b, const output *o)
{
    refuse(b, o->point, "a point", "of a joint: only a body has points");
    if (o->along >= 0) {
        source_problem(b->s, o->along_at, "'along' with a joint: only a body's position and velocity have components");
    }
}

/* The closure whose force or moment an output shows, or the child of the joint. */
static void build_reaction(builder *b, const output *o, int *body_shown, int *cut_shown)
{
    bool is_joint;
    const int of = find_joint_or_closure(b->s, b->written, o->of, &is_joint);
    if (of >= 0 && is_joint) {
        *body_shown = b->children[of];
    } else if (of >= 0) {
        const closure_kind kind = b->written->closures[of].kind;
        *cut_shown = of;
        if (acts_along_joints(kind)) {
            source_problem(b->s, o->of.at, "'%s' acts along joints, not by a force between bodies: effort of %s",
                           o->of.text, o->of.text);
        }
    }
}

/* The gear or the motion whose effort an output shows. */
static int build_effort(builder *b, const output *o)
{
    const int of = find_closure(b->s, b->written, o->of);
    if (of >= 0 && !acts_along_joints(b->written->closures[of].kind)) {
        source_problem(b->s, o->of.at, "'%s' acts by a force between bodies: force of %s, or moment of %s", o->of.text,
                       o->of.text, o->of.text);
    }
    return of;
}

static void build_output(builder *b, const output *o, int *link_shown, int *body_shown)
{
    const scene *written = b->written;
    bool is_joint = false;
    *link_shown = link_called(&b->made, o->of);
    const int of = *link_shown >= 0 ? -1 : find_joint_or_body(b->s, written, o->of, &is_joint);
    for (size_t i = 0; i < written->joint_count; i++) {
        const name *joint_name = &written->joints[i].name;
        if (*link_shown >= 0 && joint_name->text != NULL && strcmp(joint_name->text, o->of.text) == 0) {
            check_joint_output(b, o, &written->joints[i]);
        }
    }
    if (*link_shown >= 0) {
        check_coordinate_output(b, o);
    } else if (of >= 0 && is_joint) {
        check_joint_output(b, o, &written->joints[of]);
        check_coordinate_output(b, o);
    } else if (of >= 0) {
        *body_shown = of;
        if (o->kind != OUTPUT_POSITION && o->kind != OUTPUT_VELOCITY && o->kind != OUTPUT_ORIENTATION &&
            o->kind != OUTPUT_SPIN) {
            source_problem(b->s, o->kind_at, "a body has a position and a velocity; this is a joint's");
        }
    }
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
    made->output_cut = arena_take(b->s->memory, written->output_count + 1, sizeof *made->output_cut);
    for (size_t i = 0; i < written->output_count; i++) {
        const output *o = &written->outputs[i];
        made->output_link[i] = made->output_body[i] = made->output_cut[i] = -1;
        made->points[i] = vector_value(b, o->point, metre, "a point");
        const bool violates = o->kind == OUTPUT_VIOLATION || o->kind == OUTPUT_VIOLATION_RATE;
        if (violates && b->written->closure_count == 0) {
            source_problem(b->s, o->kind_at, "nothing is closed that could be violated");
        } else if ((o->kind == OUTPUT_FORCE || o->kind == OUTPUT_MOMENT) && o->of.text != NULL) {
            build_reaction(b, o, &made->output_body[i], &made->output_cut[i]);
        } else if (o->kind == OUTPUT_EFFORT && o->of.text != NULL) {
            made->output_cut[i] = build_effort(b, o);
        } else if (o->kind < OUTPUT_ENERGY && o->of.text != NULL) {
            build_output(b, o, &made->output_link[i], &made->output_body[i]);
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
