/* What the outputs show: the operand of each, found by its name, and the row that its word has for that operand. */
#include <math.h>
#include <string.h>

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
    query *q = &result->of;
    q->segment = segment_called(&b->mechanism, o->of);
    const int index = q->segment >= 0 ? -1 : find_joint_or_body(b->s, b->written, o->of, &is_joint);
    if (q->segment < 0 && index < 0) {
        return false;
    }
    q->body = is_joint ? -1 : index;
    q->kind = quantity_called(quantity_rows[o->kind].word, is_joint ? OF_COORDINATE : OF_BODY);
    if (q->kind == QUANTITY_ROWS) {
        source_problem(b->s, o->kind_at, "'%s' needs %s; '%s' is %s", quantity_rows[o->kind].word,
                       operand_phrases[is_joint ? OF_BODY : OF_COORDINATE], o->of.text,
                       operand_phrases[is_joint ? OF_COORDINATE : OF_BODY]);
        return false;
    }
    if (is_joint && q->segment < 0) {
        refuse_joint(b, o, &b->written->joints.all[index]);
        return false;
    }
    return counts_turns(b, q, o->kind_at);
}

/* `at`, `in` and `along`, where the output has a point, axes or components. */
static void check_parts(builder *b, const output *o, const quantity_row *row, shown *result)
{
    const bool is_body = o->axes.text != NULL && strcmp(o->axes.text, "body") == 0;
    if (o->point != NULL && !quantity_has_point(row)) {
        source_problem(b->s, o->point_at, "'at' is only for the %s", quantity_list(b->s->memory, quantity_has_point));
    }
    if (o->along >= 0 && !quantity_is_vector(row)) {
        source_problem(b->s, o->along_at, "'along' is only for vectors: the %s",
                       quantity_list(b->s->memory, quantity_is_vector));
    }
    if (o->axes.text != NULL && (row->asks & IN_AXES) == 0) {
        source_problem(b->s, o->axes.at, "only a velocity, a spin and a specific force have axes to choose");
    } else if (o->axes.text != NULL && !is_body && strcmp(o->axes.text, "ground") != 0) {
        source_problem(b->s, o->axes.at, "expected 'in body' or 'in ground', the axes that it is in");
    }
    result->of.in_body = o->axes.text == NULL ? (row->asks & OF_BODY_AXES) != 0 : is_body;
}

/* Any formula: its unit is that of its dimension, without the angle where nothing else has a name. */
static void show_formula(builder *b, const output *o, shown *result)
{
    const value v = value_in_scene(b, o->formula);
    result->formula = v.count == 0 ? (value){.count = 1, .parts = {constant(b->g, 0.0)}} : v;
    result->unit =
        dimension_equal_but_angle(v.of, no_unit) && v.of.rad == 0 ? "1" : dimension_text_but_angle(b->s->memory, v.of);
    if (v.count > 1 && formula_components(&v)[0] == '\0') {
        source_problem(b->s, o->formula->at, "an output is one number, a vector or a quaternion; this is %d", v.count);
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
    query *q = &result->of;
    *result = (shown){.name = o->name,
                      .of = {.kind = o->kind, .segment = -1, .body = -1, .closure = -1, .spring = -1},
                      .along = o->along};
    q->point = vector_value(b, o->point, metre, "a point");
    result->every = ticks_between(b, o);
    if (o->formula != NULL) {
        show_formula(b, o, result);
        return;
    }
    const operand kind = quantity_rows[o->kind].of;
    if (kind < OF_COORDINATE) {
        (void)is_of_plant(b, o->kind, o->kind_at);
    } else if (o->of.text != NULL) {
        const bool found = kind == OF_CONNECTION     ? find_connection(b, o->of, &q->body, &q->closure)
                           : kind == OF_TRANSMISSION ? find_transmission(b, o->of, &q->closure, &q->spring)
                                                     : find_operand(b, o, result);
        if (found) {
            check_parts(b, o, &quantity_rows[result->of.kind], result);
        }
    }
}

/* The names of all components, where those of a formula are among them: which it has is known only now. */
static void check_names(builder *b)
{
    listing all = {0};
    bool any = false;
    for (size_t i = 0; i < b->mechanism.output_count; i++) {
        const shown *o = &b->mechanism.outputs[i];
        const char *of_formula = formula_components(&o->formula);
        any = any || of_formula[0] != '\0';
        listing_add(b->s, &all, o->name);
        for (const char *c = shows_formula(o) ? of_formula : output_components(b->written, &b->written->outputs.all[i]);
             *c != '\0' && o->name.text != NULL; c++) {
            listing_add(b->s, &all, (name){arena_format(b->s->memory, "%s_%c", o->name.text, *c), o->name.at});
        }
    }
    if (any) {
        listing_check(b->s, &all);
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
    check_names(b);
}
