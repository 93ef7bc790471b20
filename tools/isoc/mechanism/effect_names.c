/* What a formula of an effect, a signal or an output can name. */
#include "tools/isoc/mechanism/effects.h"

#include <string.h>

#include "tools/isoc/mechanism/limits.h"

static const value nothing = {0};

const effect_line *line_called(const effect_kind *kind, const char *called, bool is_output)
{
    for (size_t i = 0; i < kind->line_count; i++) {
        const effect_line *line = &kind->lines[i];
        const bool names = line->kind <= EFFECT_STATE || line->kind == EFFECT_MEMORY;
        if ((is_output ? line->kind == EFFECT_OUTPUT : names) && line->name.text != NULL &&
            strcmp(line->name.text, called) == 0) {
            return line;
        }
    }
    return NULL;
}

const char *suggestion(source *s, const effect_kind *kind, const char *typed, effect_line_kind from,
                       effect_line_kind to)
{
    const char **names = arena_take(s->memory, kind->line_count + 1, sizeof *names);
    size_t count = 0;
    for (size_t i = 0; i < kind->line_count; i++) {
        const effect_line *line = &kind->lines[i];
        if (line->kind >= from && line->kind <= to && line->name.text != NULL) {
            names[count++] = line->name.text;
        }
    }
    return source_suggestion(s, typed, names, count);
}

const quantity *operand_called(const instance *in, const char *called)
{
    for (size_t i = 0; i < in->use->operand_count; i++) {
        if (strcmp(in->use->operands[i].name.text, called) == 0) {
            return &in->use->operands[i];
        }
    }
    return NULL;
}

const instance *enter(world *w, const instance *in)
{
    source *s = w->b->s;
    const instance *before = w->within;
    w->within = in;
    s->used_by = in == NULL ? NULL
                            : arena_format(s->memory, "in the effect '%s', %s", in->use->name.text,
                                           source_line(s, in->use->name.at));
    return before;
}

value evaluate(world *w, const instance *in, const formula *f, const char *called)
{
    if (w->depth >= DEEPEST_EFFECT) {
        source_problem(w->b->s, f->at, "more than %d formulas that need one another", DEEPEST_EFFECT);
        return nothing;
    }
    const instance *before = enter(w, in);
    w->path[w->depth++] = called;
    const value found = value_any(&w->b->values, f);
    w->depth--;
    enter(w, before);
    return found;
}

dimension dimension_of_quantity(const char *word, const link *l)
{
    const bool turns = l->kind == JOINT_REVOLUTE;
    dimension of = turns ? radian : metre;
    if (strcmp(word, "speed") == 0) {
        dimension_times(&of, second, -1);
    }
    return strcmp(word, "effort") == 0 ? (turns ? newton_metre : newton) : of;
}

int link_of(world *w, name n)
{
    const effect_line *line = w->within == NULL ? NULL : line_called(w->within->kind, n.text, false);
    if (w->within == NULL) {
        const int found = link_called(&w->b->made, n);
        return found >= 0 ? found : coordinate_of(w->b, n);
    }
    if (line == NULL || line->kind != EFFECT_JOINT) {
        source_problem(w->b->s, n.at, "'%s' is no joint of this effect: write 'joint %s' in it", n.text, n.text);
        return -1;
    }
    return w->within->links[line - w->within->kind->lines];
}

bool find_point(world *w, const char *called, int *which, vector *point)
{
    const scene *written = w->b->written;
    *point = vector_zero(w->b->g);
    *which = -1;
    if (w->within != NULL) {
        const effect_line *line = line_called(w->within->kind, called, false);
        const bool is = line != NULL && line->kind == EFFECT_BODY;
        if (is) {
            *which = w->within->bodies[line - w->within->kind->lines];
            *point = w->within->points[line - w->within->kind->lines];
        }
        return is;
    }
    for (size_t i = 0; i < written->body_count + written->frame_count; i++) {
        const char *other =
            i < written->body_count ? written->bodies[i].name.text : written->frames[i - written->body_count].name.text;
        *which = other != NULL && strcmp(other, called) == 0 ? (int)i : *which;
    }
    return *which >= 0;
}

static const struct {
    const char *word;
    asked_kind kind;
    dimension of;
} of_bodies[] = {
    {"position", ASKED_POSITION, {0, 1, 0, 0, 0, 0}},
    {"velocity", ASKED_VELOCITY, {0, 1, -1, 0, 0, 0}},
    {"spin", ASKED_SPIN, {0, 0, -1, 1, 0, 0}},
    {"x_axis", ASKED_X_AXIS, {0, 0, 0, 0, 0, 0}},
    {"y_axis", ASKED_Y_AXIS, {0, 0, 0, 0, 0, 0}},
    {"z_axis", ASKED_Z_AXIS, {0, 0, 0, 0, 0, 0}},
    {"specific_force", ASKED_SPECIFIC_FORCE, {0, 1, -2, 0, 0, 0}},
};

vector asked_of(world *w, asked_kind kind, int which, vector point, bool in_body)
{
    mechanism *made = &w->b->made;
    vector leaves;
    made->asked =
        arena_grow(w->b->s->memory, made->asked, (size_t)made->asked_count, &made->asked_room, sizeof *made->asked);
    made->asked[made->asked_count] = (asked){kind, which, point, in_body};
    for (int i = 0; i < 3; i++) {
        leaves.at[i] = leaf(w->b->g, OP_ASKED, 3 * made->asked_count + i);
    }
    made->asked_count++;
    return leaves;
}

/* position of BODY, and the like */
static value point_value(world *w, const formula *f, int which, vector point)
{
    const mechanism *made = &w->b->made;
    const size_t count = sizeof of_bodies / sizeof of_bodies[0];
    size_t row = 0;
    while (row < count && strcmp(f->name, of_bodies[row].word) != 0) {
        row++;
    }
    if (row == count) {
        source_problem(w->b->s, f->at,
                       "a body has no %s: its position, velocity, spin, specific_force, x_axis, y_axis or z_axis",
                       f->name);
    }
    const bool is_measured =
        row < count && (of_bodies[row].kind == ASKED_SPIN || of_bodies[row].kind == ASKED_SPECIFIC_FORCE);
    bool in_body = is_measured;
    if (row < count && f->axes.text != NULL) {
        in_body = strcmp(f->axes.text, "body") == 0;
        if (!in_body && strcmp(f->axes.text, "ground") != 0) {
            source_problem(w->b->s, f->axes.at, "expected 'in body' or 'in ground', the axes that it is in");
        } else if (of_bodies[row].kind != ASKED_VELOCITY && !is_measured) {
            source_problem(w->b->s, f->axes.at, "only a velocity, a spin and a specific force have axes to choose");
        }
    }
    if (row == count || which < 0 || !made->frames[which].placed) {
        return nothing;
    }
    const vector leaves = asked_of(w, of_bodies[row].kind, which, point, in_body);
    value found = {.count = 3, .of = of_bodies[row].of};
    memcpy(found.parts, leaves.at, sizeof leaves.at);
    return found;
}

/* power, energy, loss and work of EFFECT, in the scene alone: there all that it does is known. */
static bool find_account(world *w, const formula *f, value *found)
{
    enum { POWER, ENERGY, LOSS, WORK, WORDS };
    static const char *const words[WORDS] = {"power", "energy", "loss", "work"};
    const char *called = f->parts[0]->name;
    size_t word = POWER;
    while (word < WORDS && strcmp(f->name, words[word]) != 0) {
        word++;
    }
    *found = nothing;
    if (word < WORDS && !w->is_done) {
        source_problem(w->b->s, f->at, "the %s of '%s' is for outputs only", f->name, called);
        return true;
    }
    for (size_t i = 0; i < w->b->written->effect_count && word < WORDS; i++) {
        const instance *in = &w->all[i];
        if (in->use->name.text != NULL && strcmp(in->use->name.text, called) == 0) {
            const node all[WORDS] = {in->account->power, in->account->stored, in->account->loss, in->account->work};
            *found = (value){.count = in->kind != NULL, .parts = {all[word]}, .of = word == ENERGY ? joule : watt};
            return true;
        }
    }
    if (word < WORDS) {
        source_problem(w->b->s, f->at, "no effect is called '%s'", called);
    }
    return word < WORDS;
}

value quantity_value(void *of, const formula *f)
{
    world *w = of;
    value account;
    if (find_account(w, f, &account)) {
        return account;
    }
    graph *g = w->b->g;
    const mechanism *made = &w->b->made;
    int which;
    vector point;
    if (find_point(w, f->parts[0]->name, &which, &point)) {
        return point_value(w, f, which, point);
    }
    const int i = link_of(w, (name){f->parts[0]->name, f->parts[0]->at});
    if (i < 0) {
        return nothing;
    }
    const link *l = &made->links[i];
    if (strcmp(f->name, "inertia") == 0) {
        static const dimension turning = {1, 2, 0, 0, 0, 0};
        return (value){
            .count = 1, .parts = {leaf(g, OP_INERTIA, l->dof)}, .of = l->kind == JOINT_REVOLUTE ? turning : kilogram};
    }
    if (strcmp(f->name, "acceleration") == 0) {
        value found = {.count = 1, .of = dimension_of_quantity("speed", l)};
        dimension_times(&found.of, second, -1);
        found.parts[0] = leaf(g, OP_DERIVATIVE, made->position_count + l->dof);
        return found;
    }
    if (strcmp(f->name, "position") != 0 && strcmp(f->name, "speed") != 0) {
        source_problem(w->b->s, f->at, "a joint has no %s: its position, speed, acceleration or inertia", f->name);
        return nothing;
    }
    const bool is_speed = strcmp(f->name, "speed") == 0;
    value found = {.count = 1, .of = dimension_of_quantity(f->name, l)};
    found.parts[0] = leaf(g, OP_STATE, is_speed ? made->position_count + l->dof : l->position);
    return found;
}

value refuse_loop(world *w, place at, const char *called)
{
    int from = w->depth - 1;
    while (from > 0 && strcmp(w->path[from], called) != 0) {
        from--;
    }
    const char *path = called;
    for (int i = from + 1; i < w->depth; i++) {
        path = arena_format(w->b->s->memory, "%s, %s", path, w->path[i]);
    }
    source_problem(w->b->s, at, "an algebraic loop: %s, %s; a state, a memory or previous(x, START) breaks it", path,
                   called);
    return nothing;
}

/* What the step and the method allow: step, stable_rate, stable_frequency. */
static bool find_limit(world *w, const char *called, value *found)
{
    static const dimension hertz = {0, 0, -1, 0, 0, 0}, speed = {0, 0, -1, 1, 0, 0};
    static const double margin = 0.5; /* of the limit: what is linear here turns over elsewhere */
    const mechanism *made = &w->b->made;
    const stability_limits of = limits_of(made->recipe);
    const bool is_step = strcmp(called, "step") == 0, is_rate = strcmp(called, "stable_rate") == 0;
    if (!is_step && !is_rate && strcmp(called, "stable_frequency") != 0) {
        return false;
    }
    const double limit = margin * (is_rate ? of.rate : of.frequency) / method_step(made);
    *found = (value){.count = 1, .of = is_step ? second : is_rate ? hertz : speed};
    found->parts[0] = constant(w->b->g, is_step ? made->step : limit);
    return true;
}

static bool find_in_instance(world *w, const formula *f, value *found)
{
    const effect_line *line = line_called(w->within->kind, f->name, false);
    if (line == NULL && find_limit(w, f->name, found)) {
        return true;
    }
    if (line == NULL && strcmp(f->name, "pi") != 0) {
        unit u;
        if (unit_find(f->name, &u)) {
            return false;
        }
        source_problem(w->b->s, f->at, "this effect has no '%s': no operand, let, state or memory is called so%s",
                       f->name, suggestion(w->b->s, w->within->kind, f->name, EFFECT_JOINT, EFFECT_MEMORY));
        *found = nothing;
        return true;
    }
    if (line != NULL) {
        const bool is_number = line->kind > EFFECT_BODY;
        *found = is_number ? line_value(w, w->within, line) : nothing;
        if (!is_number) {
            source_problem(w->b->s, f->at, "'%s' is a %s: write 'position of %s', say", f->name,
                           line->kind == EFFECT_JOINT ? "joint" : "body", f->name);
        }
    }
    return line != NULL;
}

/* EFFECT.OUTPUT, or a fault. */
static value output_of_effect(world *w, const formula *f, const char *dot)
{
    source *s = w->b->s;
    const size_t length = (size_t)(dot - f->name);
    for (size_t i = 0; i < w->b->written->effect_count; i++) {
        const instance *in = &w->all[i];
        const char *called = in->use->name.text;
        if (called == NULL || strlen(called) != length || strncmp(called, f->name, length) != 0) {
            continue;
        }
        if (in->kind == NULL || in->use->broken) {
            return nothing;
        }
        const effect_line *line = line_called(in->kind, dot + 1, true);
        if (line == NULL) {
            source_problem(s, f->at, "the effect '%s' has no output '%s'%s", called, dot + 1,
                           suggestion(s, in->kind, dot + 1, EFFECT_OUTPUT, EFFECT_OUTPUT));
            return nothing;
        }
        value found = line_value(w, in, line);
        for (int part = 0; in->use->left_out && part < found.count; part++) {
            found.parts[part] = constant(w->b->g, 0.0);
        }
        return found;
    }
    source_problem(s, f->at, "no effect is called '%.*s'", (int)length, f->name);
    return nothing;
}

static value input_value(world *w, const formula *f, int i)
{
    w->b->is_input_used[i] = true;
    if (!w->b->is_input_known[i]) {
        source_problem(w->b->s, w->b->written->inputs[i].name.at, "the input '%s' has no unit: input %s V", f->name,
                       f->name);
        return nothing;
    }
    return (value){.count = 1, .parts = {leaf(w->b->g, OP_INPUT, i)}, .of = w->b->input_dimensions[i]};
}

/* Of an input that only effects read that are left out: nothing but its dimension. */
static value left_input_value(world *w, const quantity *q)
{
    values *v = &w->b->values;
    v->time_allowed = true;
    value found = q->has_unit || q->value == NULL ? (value){.count = 1, .of = q->unit.of} : value_any(v, q->value);
    v->time_allowed = false;
    found.parts[0] = constant(w->b->g, 0.0);
    return found;
}

value signal_value(world *w, size_t i)
{
    const quantity *q = &w->b->written->signals[i];
    if (w->signal_progress[i] == STARTED) {
        return refuse_loop(w, q->name.at, q->name.text);
    }
    if (w->signal_progress[i] == NOT_YET) {
        w->signal_progress[i] = STARTED;
        w->signals[i] = q->value == NULL ? nothing : evaluate(w, NULL, q->value, q->name.text);
        w->signal_progress[i] = DONE;
    }
    return w->signals[i];
}

static bool find_in_scene(world *w, const formula *f, value *found)
{
    const scene *written = w->b->written;
    const char *dot = strchr(f->name, '.');
    if (dot != NULL) {
        *found = output_of_effect(w, f, dot);
        return true;
    }
    const size_t inputs = written->input_count;
    for (size_t i = 0; i < inputs + written->left_input_count; i++) {
        const quantity *q = &written->inputs[i];
        if (q->name.text != NULL && strcmp(q->name.text, f->name) == 0) {
            *found = i < inputs ? input_value(w, f, (int)i) : left_input_value(w, q);
            return true;
        }
    }
    for (size_t i = 0; i < written->signal_count; i++) {
        if (written->signals[i].name.text != NULL && strcmp(written->signals[i].name.text, f->name) == 0) {
            *found = signal_value(w, i);
            return true;
        }
    }
    return false;
}

bool find_name(void *of, const formula *f, value *found)
{
    world *w = of;
    return w->within != NULL ? find_in_instance(w, f, found) : find_in_scene(w, f, found);
}
