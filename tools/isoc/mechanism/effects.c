/* Effects: each use of an effect is its definition with the operands put in. A formula is evaluated when something asks
 * for it; so the lines of a definition may stand in any order, and what would need its own value is found. */
#include <math.h>
#include <string.h>

#include "tools/isoc/graph/operations.h"
#include "tools/isoc/mechanism/builder.h"
#include "tools/isoc/scene/names.h"

enum { DEEPEST = 200 };

/* One effect of the scene: of each line of its definition, the value, or the link of a joint. */
typedef struct instance {
    const effect_use *use;
    const effect_kind *kind; /* NULL: there is none */
    value *values;
    progress *progress;
    int *links;  /* -1: none */
    int *places; /* of a state, a memory or a fault, among all of its sort */
} instance;

/* All of them. `within` is the instance whose lines are being evaluated, NULL in formulas of the scene. */
typedef struct world {
    builder *b;
    instance *all;
    value *signals;
    progress *signal_progress;
    const instance *within;
    const char *path[DEEPEST]; /* what is being evaluated, each for the one before */
    int depth;
} world;

static const value nothing = {0};

static int count_lines(const effect_kind *kind, effect_line_kind of)
{
    int count = 0;
    for (size_t i = 0; kind != NULL && i < kind->line_count; i++) {
        count += kind->lines[i].kind == of;
    }
    return count;
}

static int count_all(const scene *written, effect_line_kind of)
{
    int count = 0;
    for (size_t i = 0; i < written->effect_count; i++) {
        count += count_lines(find_effect_kind(written, written->effects[i].kind), of);
    }
    return count;
}

size_t count_faults(const scene *written)
{
    return (size_t)count_all(written, EFFECT_FAULT);
}

void count_effects(builder *b)
{
    mechanism *made = &b->made;
    arena *memory = b->s->memory;
    made->first_effect_state = made->position_count;
    made->effect_state_count = count_all(b->written, EFFECT_STATE);
    made->memory_count = count_all(b->written, EFFECT_MEMORY);
    made->position_count += made->effect_state_count;
    made->effect_states = arena_take(memory, (size_t)made->effect_state_count + 1, sizeof *made->effect_states);
    made->memories = arena_take(memory, (size_t)made->memory_count + 1, sizeof *made->memories);
    made->efforts = arena_take(memory, (size_t)made->dof_count + 1, sizeof *made->efforts);
    for (int f = 0; f < made->dof_count; f++) {
        made->efforts[f] = constant(b->g, 0.0);
    }
}

/* --- what a formula names --- */

static const effect_line *line_called(const effect_kind *kind, const char *called, bool is_output)
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

/* The nearest name among the lines of these kinds. */
static const char *suggestion(source *s, const effect_kind *kind, const char *typed, effect_line_kind from,
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

static const quantity *operand_called(const instance *in, const char *called)
{
    for (size_t i = 0; i < in->use->operand_count; i++) {
        if (strcmp(in->use->operands[i].name.text, called) == 0) {
            return &in->use->operands[i];
        }
    }
    return NULL;
}

static value line_value(world *w, const instance *in, const effect_line *line);

/* From here on names are those of an instance, or of the scene where it is NULL, and problems are of it. Returns what it
 * was before. */
static const instance *enter(world *w, const instance *in)
{
    source *s = w->b->s;
    const instance *before = w->within;
    w->within = in;
    s->used_by = in == NULL ? NULL
                            : arena_format(s->memory, "in the effect '%s', %s", in->use->name.text,
                                           source_line(s, in->use->name.at));
    return before;
}

/* The value of a formula that is called so. */
static value evaluate(world *w, const instance *in, const formula *f, const char *called)
{
    if (w->depth >= DEEPEST) {
        source_problem(w->b->s, f->at, "more than %d formulas that need one another", DEEPEST);
        return nothing;
    }
    const instance *before = enter(w, in);
    w->path[w->depth++] = called;
    const value found = value_any(&w->b->values, f);
    w->depth--;
    enter(w, before);
    return found;
}

static dimension dimension_of_quantity(const char *word, const link *l)
{
    const bool turns = l->kind == JOINT_REVOLUTE;
    dimension of = turns ? radian : metre;
    if (strcmp(word, "speed") == 0) {
        dimension_times(&of, second, -1);
    }
    return strcmp(word, "effort") == 0 ? (turns ? newton_metre : newton) : of;
}

/* The link that a word stands for: an operand of the instance, or a joint of the scene. */
static int link_of(world *w, name n)
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

/* position, speed or turns of a joint. */
static value quantity_value(void *of, const formula *f)
{
    world *w = of;
    graph *g = w->b->g;
    const mechanism *made = &w->b->made;
    const int i = link_of(w, (name){f->parts[0]->name, f->parts[0]->at});
    if (i < 0) {
        return nothing;
    }
    const link *l = &made->links[i];
    if (strcmp(f->name, "turns") == 0) {
        source_problem(w->b->s, f->at, "the turns of a joint are an output, and no part of a formula");
        return nothing;
    }
    const bool is_speed = strcmp(f->name, "speed") == 0;
    value found = {.count = 1, .of = dimension_of_quantity(f->name, l)};
    found.parts[0] = leaf(g, OP_STATE, is_speed ? made->position_count + l->dof : l->position);
    return found;
}

/* Notes a formula that needs its own value, with the path to it. */
static value refuse_loop(world *w, place at, const char *called)
{
    int from = w->depth - 1;
    while (from > 0 && strcmp(w->path[from], called) != 0) {
        from--;
    }
    const char *path = called;
    for (int i = from + 1; i < w->depth; i++) {
        path = arena_format(w->b->s->memory, "%s, %s", path, w->path[i]);
    }
    source_problem(w->b->s, at, "an algebraic loop: %s, %s; a state or a memory breaks it", path, called);
    return nothing;
}

static bool find_in_instance(world *w, const formula *f, value *found)
{
    const effect_line *line = line_called(w->within->kind, f->name, false);
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
        *found = line->kind == EFFECT_JOINT ? nothing : line_value(w, w->within, line);
        if (line->kind == EFFECT_JOINT) {
            source_problem(w->b->s, f->at, "'%s' is a joint: write 'speed of %s' or 'position of %s'", f->name, f->name,
                           f->name);
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
        return line_value(w, in, line);
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

static value signal_value(world *w, size_t i)
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
    for (size_t i = 0; i < written->input_count; i++) {
        if (written->inputs[i].name.text != NULL && strcmp(written->inputs[i].name.text, f->name) == 0) {
            *found = input_value(w, f, (int)i);
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

static bool find_name(void *of, const formula *f, value *found)
{
    world *w = of;
    return w->within != NULL ? find_in_instance(w, f, found) : find_in_scene(w, f, found);
}

/* --- the lines of an instance --- */

/* The dimension that a line declares, or false. */
static bool declared_dimension(world *w, const instance *in, const effect_line *line, dimension *of)
{
    if (line->has_unit) {
        *of = line->unit.of;
    } else if (line->like.text != NULL && line->like_of.text != NULL) {
        const instance *before = enter(w, in);
        const int l = link_of(w, line->like_of);
        enter(w, before);
        *of = l < 0 ? no_unit : dimension_of_quantity(line->like.text, &w->b->made.links[l]);
    }
    return line->has_unit || line->like.text != NULL;
}

/* One number of the dimension that the line declares, if it does. */
static value checked(world *w, const instance *in, const effect_line *line, const formula *f, value found)
{
    dimension of;
    source *s = w->b->s;
    if (found.count > 1) {
        source_problem(s, f->at, "'%s' is one number; this is %d", line->name.text, found.count);
        return nothing;
    }
    if (found.count == 0 || !declared_dimension(w, in, line, &of)) {
        return found;
    }
    if (!found.any && !dimension_equal_but_angle(found.of, of)) {
        source_problem(s, f->at, "'%s' %s; this %s", line->name.text, dimension_phrase(s->memory, of),
                       dimension_phrase(s->memory, found.of));
        return nothing;
    }
    found.of = of;
    found.any = false;
    return found;
}

static bool changes(const graph *g, node n)
{
    return uses_operation(g, &n, 1, OP_STATE) || uses_operation(g, &n, 1, OP_INPUT);
}

/* A signal or a value: what the use gives, in the words of the scene, or the default, in those of the effect. */
static value operand_value(world *w, const instance *in, const effect_line *line)
{
    const quantity *given = operand_called(in, line->name.text);
    const formula *f = given != NULL ? given->value : line->value;
    if (f == NULL) {
        return nothing;
    }
    const instance *of = given != NULL ? NULL : in, *before = enter(w, of);
    value found = checked(w, in, line, f, evaluate(w, of, f, line->name.text));
    if (found.count == 1 && line->kind == EFFECT_VALUE && changes(w->b->g, found.parts[0])) {
        source_problem(w->b->s, f->at, "'%s' is a constant or a tunable: it cannot change with time", line->name.text);
        found = nothing;
    }
    enter(w, before);
    return found;
}

/* What a state or a memory has at the start gives its dimension. */
static value start_value(world *w, const instance *in, const effect_line *line, variable *about)
{
    value found = checked(w, in, line, line->value, evaluate(w, in, line->value, line->name.text));
    source *s = w->b->s;
    if (found.count == 1 && !is_constant(w->b->g, found.parts[0])) {
        source_problem(s, line->value->at, "the start of '%s' must be a constant", line->name.text);
        return nothing;
    }
    const char *called = arena_format(s->memory, "%s_%s", in->use->name.text, line->name.text);
    *about = (variable){.name = called, .quote = source_quote(s, line->name.at), .least = -HUGE_VAL, .most = HUGE_VAL};
    about->unit = found.count == 0 || dimension_equal(found.of, no_unit) ? "1" : dimension_text(s->memory, found.of);
    about->start = found.count == 0 ? 0.0 : constant_value(w->b->g, found.parts[0]);
    return found;
}

static value new_value(world *w, const instance *in, const effect_line *line)
{
    graph *g = w->b->g;
    mechanism *made = &w->b->made;
    const size_t i = (size_t)(line - in->kind->lines);
    const int at = in->places[i];
    value found;
    switch (line->kind) {
    case EFFECT_SIGNAL:
    case EFFECT_VALUE:
        return operand_value(w, in, line);
    case EFFECT_FAULT:
        return (value){.count = 1, .parts = {leaf(g, OP_PARAMETER, at)}};
    case EFFECT_STATE:
        found = start_value(w, in, line, &made->effect_states[at].about);
        found.parts[0] = leaf(g, OP_STATE, made->first_effect_state + at);
        return found;
    case EFFECT_MEMORY:
        found = start_value(w, in, line, &made->memories[at].about);
        found.parts[0] = leaf(g, OP_INPUT, made->input_count + at);
        return found;
    default:
        return line->value == NULL ? nothing : evaluate(w, in, line->value, line->name.text);
    }
}

static value line_value(world *w, const instance *in, const effect_line *line)
{
    const effect_line *meant = line;
    if (line->kind == EFFECT_OUTPUT && line->value == NULL) {
        meant = line_called(in->kind, line->name.text, false);
        if (meant == NULL || meant->kind == EFFECT_JOINT) {
            source_problem(w->b->s, line->name.at, "this effect has no '%s' to show", line->name.text);
            return nothing;
        }
    }
    const size_t i = (size_t)(meant - in->kind->lines);
    if (in->progress[i] == STARTED) {
        return refuse_loop(w, meant->name.at, meant->name.text);
    }
    if (in->progress[i] == NOT_YET) {
        in->progress[i] = STARTED;
        in->values[i] = new_value(w, in, meant);
        in->progress[i] = DONE;
    }
    return in->values[i];
}

/* --- what lines do --- */

/* The line of this kind that a rate or a next is of. */
static const effect_line *subject(world *w, const instance *in, const effect_line *line, effect_line_kind of,
                                  const char *word)
{
    const effect_line *found = line->name.text == NULL ? NULL : line_called(in->kind, line->name.text, false);
    if (found == NULL || found->kind != of) {
        source_problem(w->b->s, line->name.at, "this effect has no %s '%s'", word, line->name.text);
        return NULL;
    }
    return found;
}

/* A formula of this dimension. */
static node node_of(world *w, const instance *in, const effect_line *line, dimension of, const char *what)
{
    source *s = w->b->s;
    const value found = evaluate(w, in, line->value, line->name.text);
    if (found.count > 1 || (found.count == 1 && !found.any && !dimension_equal_but_angle(found.of, of))) {
        source_problem(s, line->value->at, "%s '%s' %s; this %s", what, line->name.text,
                       dimension_phrase(s->memory, of),
                       found.count > 1 ? "is a vector" : dimension_phrase(s->memory, found.of));
        return constant(w->b->g, 0.0);
    }
    return found.count == 1 ? found.parts[0] : constant(w->b->g, 0.0);
}

static void do_rate(world *w, const instance *in, const effect_line *line)
{
    const effect_line *of = subject(w, in, line, EFFECT_STATE, "state");
    if (of != NULL && line->value != NULL) {
        dimension rate = line_value(w, in, of).of;
        dimension_times(&rate, second, -1);
        effect_quantity *made = &w->b->made.effect_states[in->places[of - in->kind->lines]];
        made->next = graph_name(w->b->g, node_of(w, in, line, rate, "the rate of"), "rate_%s", made->about.name);
    }
}

static void do_next(world *w, const instance *in, const effect_line *line)
{
    const effect_line *of = subject(w, in, line, EFFECT_MEMORY, "memory");
    if (of != NULL && line->value != NULL) {
        const dimension same = line_value(w, in, of).of;
        w->b->made.memories[in->places[of - in->kind->lines]].next = node_of(w, in, line, same, "the next");
    }
}

static void do_effort(world *w, const instance *in, const effect_line *line)
{
    const effect_line *of = subject(w, in, line, EFFECT_JOINT, "joint");
    const int l = of == NULL ? -1 : in->links[of - in->kind->lines];
    if (l >= 0 && line->value != NULL) {
        graph *g = w->b->g;
        const dimension effort = dimension_of_quantity("effort", &w->b->made.links[l]);
        const node added =
            graph_name(g, node_of(w, in, line, effort, "the effort on"), "effort_%s", in->use->name.text);
        node *sum = &w->b->made.efforts[w->b->made.links[l].dof];
        *sum = add(g, *sum, added);
    }
}

/* At the defaults of the tunables. */
static void do_require(world *w, const instance *in, const effect_line *line)
{
    source *s = w->b->s;
    const value least = evaluate(w, in, line->value, "require"), most = evaluate(w, in, line->most, "require");
    if (least.count != 1 || most.count != 1) {
        return;
    }
    if (changes(w->b->g, least.parts[0]) || changes(w->b->g, most.parts[0])) {
        source_problem(s, line->at, "only values can be required, which do not change with time");
    } else if (!least.any && !most.any && !dimension_equal_but_angle(least.of, most.of)) {
        source_problem(s, line->at, "%s and %s cannot be compared", dimension_text(s->memory, least.of),
                       dimension_text(s->memory, most.of));
    } else if (value_now(&w->b->values, least.parts[0]) > value_now(&w->b->values, most.parts[0])) {
        enter(w, NULL);
        source_problem(s, in->use->name.at, "'%s' breaks what its effect requires in %s: %s", in->use->name.text,
                       source_line(s, line->at), source_quote(s, line->at));
    }
}

/* What a definition must have besides: each state a rate, each memory a next. */
static void check_subjects(world *w, const instance *in)
{
    for (size_t i = 0; i < in->kind->line_count; i++) {
        const effect_line *line = &in->kind->lines[i];
        const bool is_state = line->kind == EFFECT_STATE;
        const effect_line_kind wanted = is_state ? EFFECT_RATE : EFFECT_NEXT;
        int found = 0;
        for (size_t j = 0; j < in->kind->line_count; j++) {
            const effect_line *other = &in->kind->lines[j];
            found += other->kind == wanted && other->name.text != NULL && line->name.text != NULL &&
                     strcmp(other->name.text, line->name.text) == 0;
        }
        if ((is_state || line->kind == EFFECT_MEMORY) && found != 1) {
            source_problem(w->b->s, line->name.at, "the %s '%s' needs one %s, and has %d: %s %s = ...",
                           is_state ? "state" : "memory", line->name.text, is_state ? "rate" : "next", found,
                           is_state ? "rate" : "next", line->name.text);
        }
    }
}

static void do_line(world *w, const instance *in, const effect_line *line)
{
    enter(w, in);
    if (line->kind == EFFECT_RATE) {
        do_rate(w, in, line);
    } else if (line->kind == EFFECT_NEXT) {
        do_next(w, in, line);
    } else if (line->kind == EFFECT_EFFORT) {
        do_effort(w, in, line);
    } else if (line->kind == EFFECT_REQUIRE) {
        do_require(w, in, line);
    } else if (line->kind != EFFECT_JOINT) {
        (void)line_value(w, in, line);
    }
    enter(w, NULL);
}

/* --- uses --- */

/* The joint that the use names for an operand. */
static int bound_link(world *w, const instance *in, const effect_line *line)
{
    const quantity *given = operand_called(in, line->name.text);
    if (given == NULL || given->value == NULL) {
        return -1;
    }
    if (given->value->kind != FORMULA_NAME) {
        source_problem(w->b->s, given->value->at, "expected the name of a joint for '%s'", line->name.text);
        return -1;
    }
    return link_of(w, (name){given->value->name, given->value->at});
}

/* Each operand once, none but those of the definition, and none missing that has no default. */
static bool check_operands(builder *b, const instance *in)
{
    source *s = b->s;
    const size_t problems = s->problem_count;
    for (size_t i = 0; i < in->use->operand_count; i++) {
        const quantity *given = &in->use->operands[i];
        const effect_line *line = line_called(in->kind, given->name.text, false);
        if (line == NULL || line->kind >= EFFECT_FAULT) {
            source_problem(s, given->name.at, "the effect %s has no operand '%s'%s", in->kind->name.text,
                           given->name.text, suggestion(s, in->kind, given->name.text, EFFECT_JOINT, EFFECT_VALUE));
        } else if (operand_called(in, given->name.text) != given) {
            source_problem(s, given->name.at, "a second '%s'", given->name.text);
        }
    }
    for (size_t i = 0; i < in->kind->line_count; i++) {
        const effect_line *line = &in->kind->lines[i];
        if (line->kind < EFFECT_FAULT && line->value == NULL && line->name.text != NULL &&
            operand_called(in, line->name.text) == NULL) {
            source_problem(s, in->use->name.at, "'%s' has no %s: the effect %s needs it", in->use->name.text,
                           line->name.text, in->kind->name.text);
        }
    }
    return s->problem_count == problems;
}

/* A switch: a tunable of its own, which is 0 until somebody sets it to 1. */
static int add_fault(builder *b, const effect_use *use, const effect_line *line)
{
    const char *called = arena_format(b->s->memory, "%s_%s", use->name.text, line->name.text);
    b->faults[b->fault_count++] =
        (variable){.name = called, .unit = "1", .quote = source_quote(b->s, line->name.at), .most = 1.0};
    return b->values.tunables++;
}

static void build_instance(world *w, instance *in, int *states, int *memories)
{
    builder *b = w->b;
    in->kind = find_effect_kind(b->written, in->use->kind);
    if (in->kind == NULL && in->use->kind.text != NULL) {
        source_problem(b->s, in->use->kind.at, "no effect of the kind '%s' is defined", in->use->kind.text);
    }
    if (in->kind == NULL || in->kind->broken || in->use->broken || !check_operands(b, in)) {
        in->kind = NULL;
        return;
    }
    const size_t room = in->kind->line_count + 1;
    in->values = arena_take(b->s->memory, room, sizeof *in->values);
    in->progress = arena_take(b->s->memory, room, sizeof *in->progress);
    in->links = arena_take(b->s->memory, room, sizeof *in->links);
    in->places = arena_take(b->s->memory, room, sizeof *in->places);
    for (size_t i = 0; i < in->kind->line_count; i++) {
        const effect_line *line = &in->kind->lines[i];
        in->links[i] = line->kind == EFFECT_JOINT ? bound_link(w, in, line) : -1;
        in->places[i] = line->kind == EFFECT_STATE    ? (*states)++
                        : line->kind == EFFECT_MEMORY ? (*memories)++
                        : line->kind == EFFECT_FAULT  ? add_fault(b, in->use, line)
                                                      : -1;
    }
}

static world *world_of(builder *b)
{
    arena *memory = b->s->memory;
    world *w = arena_take(memory, 1, sizeof *w);
    w->b = b;
    w->all = arena_take(memory, b->written->effect_count + 1, sizeof *w->all);
    w->signals = arena_take(memory, b->written->signal_count + 1, sizeof *w->signals);
    w->signal_progress = arena_take(memory, b->written->signal_count + 1, sizeof *w->signal_progress);
    for (size_t i = 0; i < b->written->effect_count; i++) {
        w->all[i].use = &b->written->effects[i];
    }
    return w;
}

void build_effects(builder *b)
{
    world *w = world_of(b);
    surroundings *around = arena_take(b->s->memory, 1, sizeof *around);
    *around = (surroundings){.of = w, .find = find_name, .quantity = quantity_value};
    b->around = around;
    b->faults = arena_take(b->s->memory, count_faults(b->written) + 1, sizeof *b->faults);
    int states = 0, memories = 0;
    for (size_t i = 0; i < b->written->effect_count; i++) {
        build_instance(w, &w->all[i], &states, &memories);
    }
    b->values.around = around;
    graph_section(b->g, "Effects");
    for (size_t i = 0; i < b->written->effect_count; i++) {
        const instance *in = &w->all[i];
        for (size_t j = 0; in->kind != NULL && j < in->kind->line_count; j++) {
            do_line(w, in, &in->kind->lines[j]);
        }
        if (in->kind != NULL) {
            enter(w, in);
            check_subjects(w, in);
            enter(w, NULL);
        }
    }
    for (size_t i = 0; i < b->written->signal_count; i++) {
        (void)signal_value(w, i);
    }
    b->values.around = NULL;
}

value value_in_scene(builder *b, const formula *f)
{
    b->values.around = b->around;
    const value found = value_any(&b->values, f);
    b->values.around = NULL;
    return found;
}
