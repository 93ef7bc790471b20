/* What the outputs show: the operand of each, found by its name, and the row that its word has for that operand. */
#include <math.h>

#include "tools/isoc/mechanism/builder.h"
#include "tools/isoc/scene/names.h"

/* The parts of a joint that an output can show, as a list; or what to write instead. */
static const char *parts_of(builder *b, const joint *j)
{
    const char *list = "";
    for (int i = 0; i < b->mechanism.segment_count; i++) {
        const segment *l = &b->mechanism.segments[i];
        if (l->at == j->name.at && l->kind != JOINT_SPHERICAL) {
            list = arena_format(b->s->memory, "%s%s%s", list, list[0] == '\0' ? "" : ", ", l->name);
        }
    }
    return list[0] == '\0' ? "the orientation of its child" : list;
}

/* A joint that is no segment by itself: has it no coordinate, or several? */
static void refuse_joint(builder *b, const output *o, const joint *j)
{
    if (j->kind == JOINT_FIXED) {
        source_problem(b->s, o->of.at, "the joint '%s' is fixed: it has no coordinate", o->of.text);
    } else if (!joint_has_one_coordinate(j->kind)) {
        source_problem(b->s, o->of.at, "the joint '%s' has more than one coordinate: show %s", o->of.text,
                       parts_of(b, j));
    }
}

/* A coordinate or a body; false if it is neither, or if there is no such output of it. */
static bool find_operand(builder *b, const output *o, shown *result)
{
    bool is_joint = true;
    result->segment = segment_called(&b->mechanism, o->of);
    const int index = result->segment >= 0 ? -1 : find_joint_or_body(b->s, b->written, o->of, &is_joint);
    if (result->segment < 0 && index < 0) {
        return false;
    }
    result->body = is_joint ? -1 : index;
    result->kind = output_of(o->kind, is_joint ? OF_COORDINATE : OF_BODY);
    if (result->kind == OUTPUT_ROWS) {
        source_problem(b->s, o->kind_at, "'%s' needs %s; '%s' is %s", output_rows[o->kind].word,
                       operand_phrases[is_joint ? OF_BODY : OF_COORDINATE], o->of.text,
                       operand_phrases[is_joint ? OF_COORDINATE : OF_BODY]);
        return false;
    }
    if (is_joint && result->segment < 0) {
        refuse_joint(b, o, &b->written->joints.all[index]);
        return false;
    }
    if (result->kind == OUTPUT_TURNS && !b->mechanism.segments[result->segment].continuous) {
        source_problem(b->s, o->kind_at, "only a continuous joint counts its turns");
    }
    return true;
}

static bool find_transmission(builder *b, const output *o, shown *result)
{
    bool is_closure;
    const int index = find_closure_or_spring(b->s, b->written, o->of, &is_closure);
    result->closure = is_closure ? index : -1;
    result->point_spring = is_closure ? -1 : index;
    if (result->closure >= 0 && !acts_along_joints(b->written->closures.all[result->closure].kind)) {
        source_problem(b->s, o->of.at, "'%s' has no effort: show force of %s, or moment of %s", o->of.text, o->of.text,
                       o->of.text);
    }
    return index >= 0;
}

static bool has_point(const output_row *row)
{
    return row->is_of_point;
}

/* `at` and `along`, where the output has a point or components. */
static void check_parts(builder *b, const output *o, const output_row *row)
{
    if (o->point != NULL && !row->is_of_point) {
        source_problem(b->s, o->point_at, "'at' is only for the %s", output_list(b->s->memory, has_point));
    }
    if (o->along >= 0 && !output_is_vector(row)) {
        source_problem(b->s, o->along_at, "'along' is only for vectors: the %s",
                       output_list(b->s->memory, output_is_vector));
    }
}

/* Any formula: its unit is that of its dimension, without the angle where nothing else has a name. */
static void show_formula(builder *b, const output *o, shown *result)
{
    const value v = value_in_scene(b, o->formula);
    result->formula = v.count == 0 ? constant(b->g, 0.0) : v.parts[0];
    result->unit =
        dimension_equal_but_angle(v.of, no_unit) && v.of.rad == 0 ? "1" : dimension_text_but_angle(b->s->memory, v.of);
    if (v.count > 1) {
        source_problem(b->s, o->formula->at, "an output is one number; this is %d", v.count);
    }
}

static double ticks_between(builder *b, const output *o)
{
    const double most = 16777215.0; /* of iso_tick_modulo */
    const double every = value_constant(&b->values, o->every, no_unit, "the rate of an output", 1.0);
    if (!(every >= 1.0 && every <= most) || every != floor(every)) {
        source_problem(b->s, o->every->at, "the rate of an output is a whole number of ticks from 1 to %.0f", most);
    }
    return every;
}

static void build_output(builder *b, const output *o, shown *result)
{
    const operand kind = output_rows[o->kind].of;
    *result = (shown){.name = o->name,
                      .kind = o->kind,
                      .along = o->along,
                      .segment = -1,
                      .body = -1,
                      .closure = -1,
                      .point_spring = -1};
    result->point = vector_value(b, o->point, metre, "a point");
    result->every = ticks_between(b, o);
    if (o->formula != NULL) {
        show_formula(b, o, result);
    }
    if (kind == OF_CLOSURES && b->written->closures.count == 0) {
        source_problem(b->s, o->kind_at, "a scene without closures has no violation");
    }
    if (kind >= OF_COORDINATE && o->of.text != NULL) {
        const bool found = kind == OF_CONNECTION     ? find_connection(b, o->of, &result->body, &result->closure)
                           : kind == OF_TRANSMISSION ? find_transmission(b, o, result)
                                                     : find_operand(b, o, result);
        if (found) {
            check_parts(b, o, &output_rows[result->kind]);
        }
    }
}

void build_outputs(builder *b)
{
    const size_t count = b->written->outputs.count;
    b->mechanism.outputs = arena_take(b->s->memory, count + 1, sizeof *b->mechanism.outputs);
    b->mechanism.output_count = count;
    for (size_t i = 0; i < count; i++) {
        build_output(b, &b->written->outputs.all[i], &b->mechanism.outputs[i]);
    }
}
