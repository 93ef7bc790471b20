/* output NAME = KIND [of NAME [at FORMULA] [along AXIS]] */
#include "tools/isoc/scene/formula.h"
#include "tools/isoc/scene/statements.h"

static const char *const kind_names[] = {
    [OUTPUT_POSITION] = "position", [OUTPUT_SPEED] = "speed",         [OUTPUT_ACCELERATION] = "acceleration",
    [OUTPUT_VELOCITY] = "velocity", [OUTPUT_TURNS] = "turns",         [OUTPUT_ORIENTATION] = "orientation",
    [OUTPUT_SPIN] = "spin",         [OUTPUT_FORCE] = "force",         [OUTPUT_MOMENT] = "moment",
    [OUTPUT_EFFORT] = "effort",     [OUTPUT_ENERGY] = "energy",       [OUTPUT_LOCAL_ERROR] = "local_error",
    [OUTPUT_RESIDUAL] = "residual", [OUTPUT_VIOLATION] = "violation", [OUTPUT_VIOLATION_RATE] = "violation_rate",
};

/* What an output is of; NULL: of the whole mechanism. */
static const char *const owners[COUNT_OF(kind_names)] = {
    [OUTPUT_POSITION] = "a joint or a body",
    [OUTPUT_SPEED] = "a joint",
    [OUTPUT_ACCELERATION] = "a joint",
    [OUTPUT_VELOCITY] = "a body",
    [OUTPUT_TURNS] = "a joint",
    [OUTPUT_ORIENTATION] = "a body",
    [OUTPUT_SPIN] = "a body",
    [OUTPUT_FORCE] = "a joint or a closure",
    [OUTPUT_MOMENT] = "a joint or a closure",
    [OUTPUT_EFFORT] = "a gear or a motion",
};

static bool is_of_point(output_kind kind)
{
    return kind == OUTPUT_POSITION || kind == OUTPUT_VELOCITY;
}

static bool has_components(output_kind kind)
{
    return is_of_point(kind) || kind == OUTPUT_SPIN || kind == OUTPUT_FORCE || kind == OUTPUT_MOMENT;
}

static void parse_owner(parser *p, output *o)
{
    if (!take_word(p, "of")) {
        parse_problem(p, arena_format(p->s->memory, "expected 'of' and the name of %s", owners[o->kind]));
        return;
    }
    o->of = take_name(p, arena_format(p->s->memory, "expected the name of %s", owners[o->kind]));
    place at = p->next->at;
    if (!p->failed && take_word(p, "at")) {
        o->point = parse_formula(p);
        if (!is_of_point(o->kind)) {
            source_problem(p->s, at, "'at' is for a position or a velocity: only they are of a point");
        }
    }
    o->along_at = p->next->at;
    if (!p->failed && take_word(p, "along")) {
        static const char *const axes[] = {"x", "y", "z"};
        o->along = (int)take_one_of(p, axes, COUNT_OF(axes));
        if (!has_components(o->kind)) {
            source_problem(p->s, o->along_at,
                           "'along' is for a position, velocity, spin, force or moment: only they have x, y and z");
        }
    }
}

void read_output(parser *p, const token *word, void *slot)
{
    (void)word;
    scene *made = slot;
    output o = {.name = take_name(p, "expected a name for the output"), .along = -1};
    if (!p->failed && !take_sign(p, '=')) {
        parse_problem(p, "expected =, as in: output angle = position of joint");
    }
    o.kind_at = p->next->at;
    if (!p->failed) {
        o.kind = (output_kind)take_one_of(p, kind_names, COUNT_OF(kind_names));
    }
    if (!p->failed && owners[o.kind] != NULL) {
        parse_owner(p, &o);
    }
    if (!p->failed) {
        made->outputs = arena_grow(p->s->memory, made->outputs, made->output_count, &made->output_room, sizeof o);
        made->outputs[made->output_count++] = o;
    }
}
