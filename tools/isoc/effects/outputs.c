/* The content of outputs: each a quantity alone, or a formula. */
#include "tools/isoc/effects/effects.h"

/* Any formula: its unit is that of its dimension, without the angle where nothing else has a name. */
static void show_formula(builder *b, const output *o, shown *result)
{
    const value v = value_in_scene(b, o->formula);
    result->formula = v.count == 0 ? (value){.count = 1, .parts = {constant(b->g, 0.0)}} : v;
    result->unit = dimension_equal_but_angle(v.dim, no_unit) && v.dim.rad == 0
                       ? "1"
                       : dimension_text_but_angle(b->s->memory, v.dim);
    if (v.count > 1 && formula_components(&v)[0] == '\0') {
        source_problem(b->s, o->formula->at, "an output is one number, a vector or a quaternion; this is %d", v.count);
    }
}

static void build_output(builder *b, const output *o, shown *result)
{
    static const double slowest = 16777215.0; /* ticks, of iso_tick_modulo */
    effect_scope *w = b->around->context;
    const char *along = o->formula->along.text;
    *result = (shown){.name = o->name, .along = -1};
    result->rate =
        o->block != NULL
            ? rate_of_block(w, NULL, o->block)
            : (row_rate){whole_number(b, o->every, "the rate of an output", " of ticks", 1.0, 1.0, slowest), 0.0};
    const row_rate before = pace(w, o->block == NULL ? each_row : result->rate);
    if (!find_shown(b, o->formula, &result->content)) {
        show_formula(b, o, result);
    } else if (along != NULL && result->content.kind < QUANTITY_ROWS) {
        result->along = quantity_part(&quantity_rows[result->content.kind], along);
    }
    pace(w, before);
}

/* An output of several components declares NAME_x and so on as well. */
static void check_names(builder *b)
{
    name_list all = {0};
    FOR_ALL (const shown, o, b->mechanism.outputs, b->mechanism.output_count) {
        const char *of_quantity = shows_formula(o) || o->along >= 0 ? "" : quantity_rows[o->content.kind].components;
        listing_add(b->s, &all, o->name);
        for (const char *c = shows_formula(o) ? formula_components(&o->formula) : of_quantity;
             *c != '\0' && o->name.text != NULL; c++) {
            listing_add(b->s, &all, (name){arena_format(b->s->memory, "%s_%c", o->name.text, *c), o->name.at});
        }
    }
    listing_check(b->s, &all);
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
