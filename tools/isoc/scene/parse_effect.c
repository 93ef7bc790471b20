/* The definition of a kind of effect, effect KIND { line ... }; its use in a scene, effect NAME KIND { operand value
 * ... }; the signals that effects read, signal NAME = FORMULA; and changes at times, at TIME set NAME = VALUE. */
#include <string.h>

#include "tools/isoc/scene/take.h"

/* --- lines of a definition --- */

/* like speed of JOINT, or a unit. */
static void parse_unit_or_like(parser *p, effect_line *line)
{
    static const char *const words[] = {"effort", "speed", "position", "stiffness", "damping"};
    if (!take_option(p, "like")) {
        line->has_unit = take_unit(p, &line->unit);
        return;
    }
    line->like = (name){p->next->text, p->next->at};
    take_one_of(p, words, COUNT_OF(words));
    expect_word(p, "of", "expected 'of' and the name of a joint");
    line->like_of = take_name(p, "expected the name of a joint");
}

static void parse_equals(parser *p, effect_line *line, const char *example)
{
    expect_sign(p, '=', arena_format(p->s->memory, "expected =, as in: %s", example));
    line->value = parse_formula(p);
}

static void parse_optional_value(parser *p, effect_line *line)
{
    if (take_sign(p, '=')) {
        line->value = parse_formula(p);
    }
}

/* The parts of a line besides its name. */
static void parse_rest(parser *p, effect_line *line)
{
    switch (line->kind) {
    case EFFECT_JOINT:
        line->is_bounded = take_option(p, "not");
        if (line->is_bounded && !take_word(p, "continuous")) {
            parse_problem(p, "expected 'continuous', as in: joint along not continuous");
        }
        break;
    case EFFECT_BODY:
    case EFFECT_FAULT:
        break;
    case EFFECT_SIGNAL:
    case EFFECT_VALUE:
        parse_unit_or_like(p, line);
        line->is_external = line->kind == EFFECT_SIGNAL && take_option(p, "external");
        parse_optional_value(p, line);
        break;
    case EFFECT_STATE:
    case EFFECT_MEMORY:
        line->has_unit = take_unit(p, &line->unit);
        parse_equals(p, line, "state current A = 0 A");
        break;
    case EFFECT_FORCE:
    case EFFECT_MOMENT:
        if (take_option(p, "in")) {
            static const char *const words[] = {"body", "ground"};
            line->in_body = take_one_of(p, words, COUNT_OF(words)) == 0;
        }
        if (take_option(p, "against")) {
            line->against = take_name(p, "expected the name of the other body");
        }
        parse_equals(p, line, "force on wheel = (0, 0, 1 N)");
        break;
    case EFFECT_OUTPUT:
        parse_optional_value(p, line);
        break;
    default:
        parse_equals(p, line, "let v = speed of along");
        break;
    }
}

static void add_line(parser *p, effect_kind *result, effect_line line)
{
    line.block = p->block;
    ADD_TO(p->s->memory, result->lines, result->line_count, result->line_room, line);
}

static effect_line_kind kind_of_line(const parser *p)
{
    return (effect_line_kind)block_index(p->within, p->word);
}

/* A line that goes on with a name: a new one where it declares a quantity, else one that another line declares. */
static void read_line(parser *p, void *slot)
{
    effect_line line = {.kind = kind_of_line(p), .at = p->next->at};
    const bool is_new = line.kind < EFFECT_EFFORT && line.kind != EFFECT_RATE && line.kind != EFFECT_NEXT;
    line.name =
        is_new ? take_inner_name(p, "expected a name") : take_name(p, "expected the name of what this is about");
    if (!p->failed) {
        parse_rest(p, &line);
    }
    add_line(p, slot, line);
}

/* effort on JOINT = FORMULA; force on BODY [in body] [against BODY] = VECTOR, and likewise a moment. */
static void read_action(parser *p, void *slot)
{
    if (take_word(p, "on")) {
        read_line(p, slot);
    } else {
        parse_problem(p, kind_of_line(p) == EFFECT_EFFORT ? "expected 'on' and the name of a joint"
                                                          : "expected 'on' and the name of a body");
    }
}

/* energy = FORMULA, loss = FORMULA, work = FORMULA */
static void read_account(parser *p, void *slot)
{
    effect_line line = {.kind = kind_of_line(p), .name = {p->word->text, p->word->at}, .at = p->word->at};
    parse_equals(p, &line, "energy = stiffness * stretch^2 / 2");
    add_line(p, slot, line);
}

/* require A <= B { and C <= D } */
static void read_require(parser *p, void *slot)
{
    do {
        effect_line line = {.kind = EFFECT_REQUIRE, .at = p->word->at};
        formula *left = parse_formula(p);
        const bool rises = next_is_sign(p, '<');
        if (!p->failed && !rises && !next_is_sign(p, '>')) {
            parse_problem(p, "expected <=, >=, < or >");
        }
        if (p->failed) {
            return;
        }
        line.is_strict = p->next[1].sign != '=';
        p->next += line.is_strict ? 1 : 2;
        formula *right = parse_formula(p);
        line.value = rises ? left : right;
        line.most = rises ? right : left;
        add_line(p, slot, line);
    } while (take_option(p, "and"));
}

/* mode NAME [in (NAME, ...)] = START: a state, and a let for each name of a value. */
static void read_mode_line(parser *p, void *slot)
{
    effect_line line = {.kind = EFFECT_STATE, .is_mode = true, .at = p->next->at, .has_unit = true, .unit = unit_one};
    line.name = take_inner_name(p, "expected a name for the mode");
    quantity q = {.name = line.name};
    name_choices choices = {0};
    parse_mode(p, &q, &choices);
    line.value = q.value;
    add_line(p, slot, line);
    for (size_t i = 0; i < choices.count; i++) {
        const name n = choices.all[i];
        add_line(
            p, slot,
            (effect_line){.kind = EFFECT_LET, .name = n, .at = n.at, .value = formula_of_number(p, (double)i, n.at)});
    }
}

/* when CONDITION { set ... } */
static void read_when_line(parser *p, void *slot)
{
    when_statement *when = arena_take(p->s->memory, 1, sizeof *when);
    *when = (when_statement){.at = p->word->at};
    when->condition = parse_condition(p);
    parse_sets(p, when);
    if (!p->failed) {
        add_line(p, slot, (effect_line){.kind = EFFECT_WHEN, .at = when->at, .value = when->condition, .when = when});
    }
}

static void parse_operands(parser *p, effect_use *use);

/* part NAME KIND { operand value ... } */
static void read_part(parser *p, void *slot)
{
    const effect_kind *around = slot;
    effect_use *part = arena_take(p->s->memory, 1, sizeof *part);
    *part = (effect_use){.name = take_inner_name(p, "expected a name for the part")};
    part->kind = take_name(p, "expected a kind of effect, as in: part motor dc_motor { ... }");
    FOR_ALL (const effect_line, line, around->lines, around->line_count) {
        if (line->kind == EFFECT_PART && part->name.text != NULL && name_is(line->name, part->name.text)) {
            source_problem(p->s, part->name.at, "a second part '%s'; the first is in %s", part->name.text,
                           source_line(p->s, line->at));
        }
    }
    if (!p->failed) {
        parse_operands(p, part);
    }
    part->broken = p->failed;
    part->block = p->block;
    add_line(p, slot, (effect_line){.kind = EFFECT_PART, .name = part->name, .at = part->name.at, .part = part});
}

/* constant NAME = FORMULA */
static void read_constant_line(parser *p, void *slot)
{
    effect_line line = {.kind = EFFECT_LET, .is_constant = true, .at = p->next->at};
    line.name = take_inner_name(p, "expected a name for the constant");
    parse_equals(p, &line, "constant window = 0.3 m");
    add_line(p, slot, line);
}

/* function NAME(ARGUMENT, ...) = FORMULA */
static void read_function_line(parser *p, void *slot)
{
    effect_line line = {.kind = EFFECT_FUNCTION, .at = p->next->at};
    line.name = take_inner_name(p, "expected a name for the function");
    expect_sign(p, '(', "expected ( and the names of the arguments: function hill(x, width) = ...");
    do {
        const name argument = take_inner_name(p, "expected a name for an argument");
        FOR_EACH (const name, other, line.arguments) {
            if (argument.text != NULL && name_is(*other, argument.text)) {
                PARSE_FAULT(p, argument.at, "a second argument '%s'", argument.text);
            }
        }
        LIST_ADD(p->s->memory, line.arguments, argument);
    } while (!p->failed && take_sign(p, ','));
    expect_sign(p, ')', "expected , or )");
    parse_equals(p, &line, "function hill(x, width) = exp(-(x / width)^2)");
    add_line(p, slot, line);
}

/* Of a rate are numbers that a row can keep; the rest acts within a step. */
static void check_paced(parser *p, const effect_kind *all, size_t from)
{
    for (size_t i = from; i < all->line_count; i++) {
        const effect_line *line = &all->lines[i];
        if (line->kind != EFFECT_LET && line->kind != EFFECT_MEMORY && line->kind != EFFECT_NEXT &&
            line->kind != EFFECT_OUTPUT && line->kind != EFFECT_PART) {
            source_problem(p->s, line->at,
                           "a block of a rate has memories, next, let, outputs and parts: this stands outside");
        }
    }
}

static const block definition;

/* every PERIOD [at PHASE] { ... } */
static void read_paced_lines(parser *p, void *slot)
{
    effect_kind *result = slot;
    const name word = {p->word->text, p->word->at};
    const rate_block *paced = take_rate(p);
    if (paced == NULL) {
        return;
    }
    const size_t from = result->line_count;
    const rate_block *around = p->block;
    p->block = paced;
    result->broken |= !parse_block(p, &definition, 0, word, slot);
    p->block = around;
    check_paced(p, result, from);
}

/* hold NAME on JOINT up to LIMIT: a mode, and a line for the hold itself. */
static void read_hold_line(parser *p, void *slot)
{
    hold_statement *hold = arena_take(p->s->memory, 1, sizeof *hold);
    hold->name = take_inner_name(p, "expected a name for the hold");
    parse_hold(p, hold);
    if (p->failed) {
        return;
    }
    effect_line line = {.kind = EFFECT_STATE, .is_mode = true, .name = hold->name, .at = hold->name.at};
    line.has_unit = true;
    line.unit = unit_one;
    line.value = formula_of_number(p, 0.0, hold->name.at);
    add_line(p, slot, line);
    add_line(p, slot, (effect_line){.kind = EFFECT_HOLD, .at = hold->name.at, .value = hold->limit, .hold = hold});
}

/* One row for each effect_line_kind, in their order; then a constant, which is a let, and what has lines. */
static const property lines[] = {
    {"joint", read_line, 0, EVERY_KIND | MANY, NULL},
    {"body", read_line, 0, EVERY_KIND | MANY, NULL},
    {"signal", read_line, 0, EVERY_KIND | MANY, NULL},
    {"value", read_line, 0, EVERY_KIND | MANY, NULL},
    {"fault", read_line, 0, EVERY_KIND | MANY, NULL},
    {"let", read_line, 0, EVERY_KIND | MANY, NULL},
    {"state", read_line, 0, EVERY_KIND | MANY, NULL},
    {"rate", read_line, 0, EVERY_KIND | MANY, NULL},
    {"memory", read_line, 0, EVERY_KIND | MANY, NULL},
    {"next", read_line, 0, EVERY_KIND | MANY, NULL},
    {"effort", read_action, 0, EVERY_KIND | MANY, NULL},
    {"force", read_action, 0, EVERY_KIND | MANY, NULL},
    {"moment", read_action, 0, EVERY_KIND | MANY, NULL},
    {"energy", read_account, 0, EVERY_KIND | MANY, NULL},
    {"loss", read_account, 0, EVERY_KIND | MANY, NULL},
    {"work", read_account, 0, EVERY_KIND | MANY, NULL},
    {"output", read_line, 0, EVERY_KIND | MANY, NULL},
    {"require", read_require, 0, EVERY_KIND | MANY, NULL},
    {"mode", read_mode_line, 0, EVERY_KIND | MANY, NULL},
    {"when", read_when_line, 0, EVERY_KIND | MANY, NULL},
    {"hold", read_hold_line, 0, EVERY_KIND | MANY, NULL},
    {"part", read_part, 0, EVERY_KIND | MANY, NULL},
    {"function", read_function_line, 0, EVERY_KIND | MANY, NULL},
    {"constant", read_constant_line, 0, EVERY_KIND | MANY, NULL},
    {"every", read_paced_lines, 0, EVERY_KIND | MANY, NULL},
    {"repeat", read_repeat, 0, EVERY_KIND | MANY, NULL},
};

static const block definition = {"effect", PROPERTIES(lines)};

/* --- values that start with a vector --- */

static bool is_vector(const effect_kind *e, const formula *f, size_t depth);

/* Whether its formula is a start or a default. */
static bool has_start(const effect_line *line)
{
    return line->kind == EFFECT_STATE || line->kind == EFFECT_MEMORY || line->kind == EFFECT_SIGNAL ||
           line->kind == EFFECT_VALUE;
}

/* A name of the definition: a let, a state, a memory or an operand, by its formula. `depth`: names on the way, which
 * may form a loop: that error is noted elsewhere. */
static bool names_vector(const effect_kind *e, const char *called, size_t depth)
{
    bool is = false;
    for (size_t i = 0; i < e->line_count && depth <= e->line_count && !is; i++) {
        const effect_line *line = &e->lines[i];
        const bool has_value = line->kind == EFFECT_LET || has_start(line);
        is = has_value && name_is(line->name, called) && is_vector(e, line->value, depth + 1);
    }
    return is;
}

/* A quantity of a body is a vector, and so is a force or a moment of a joint; a component of them is none. */
static bool asks_for_vector(const effect_kind *e, const formula *f)
{
    bool is = quantity_called(f->name, OF_CONNECTION) < QUANTITY_ROWS;
    if (f->along.text != NULL) {
        return false;
    }
    FOR_ALL (const effect_line, line, e->lines, e->line_count) {
        is = is || (line->kind == EFFECT_BODY && name_is(line->name, f->parts[0]->name));
    }
    return is;
}

/* Whether a formula is a vector, by its form. */
static bool is_vector(const effect_kind *e, const formula *f, size_t depth)
{
    if (f == NULL) {
        return false;
    }
    switch (f->kind) {
    case FORMULA_VECTOR:
        return f->count == 3;
    case FORMULA_NAME:
        return names_vector(e, f->name, depth);
    case FORMULA_OF:
        return asks_for_vector(e, f);
    case FORMULA_CALL:
        return strcmp(f->name, "cross") == 0;
    case FORMULA_SCALE:
    case FORMULA_NEGATE:
    case FORMULA_STEP:
    case FORMULA_CHAIN:
        break;
    default:
        return false;
    }
    bool is = false;
    for (size_t i = 0; i < f->count && !is; i++) {
        is = is_vector(e, f->parts[i], depth);
    }
    return is;
}

/* States and memories that start with a vector have three numbers, and so have operands whose default is one. */
static void find_vectors(effect_kind *e)
{
    FOR_ALL (effect_line, line, e->lines, e->line_count) {
        line->parts = has_start(line) && is_vector(e, line->value, 0) ? 3 : 1;
    }
}

static void parse_definition(parser *p, scene *written, name called)
{
    effect_kind kind = {.name = called};
    const size_t factors = p->factors.count;
    const bool was_broken = written->broken;
    written->broken = false;
    kind.broken |= !parse_block(p, &definition, 0, called, &kind);
    kind.broken |= written->broken; /* in a repeat */
    written->broken |= was_broken;
    for (size_t i = 0; i < kind.line_count; i++) {
        if (kind.lines[i].kind <= EFFECT_STATE || kind.lines[i].kind == EFFECT_MEMORY) {
            refuse_factor(p, factors, kind.lines[i].name);
        }
    }
    p->factors.count = factors;
    find_vectors(&kind);
    LIST_ADD(p->s->memory, written->effect_kinds, kind);
}

/* --- uses --- */

/* { operand value; ... }: which operands there are, only the definition knows, and that may come later. */
static void parse_operands(parser *p, effect_use *use)
{
    expect_sign(p, '{', "expected {");
    while (!p->failed && !take_sign(p, '}')) {
        if (take_sign(p, ';')) {
            continue;
        }
        quantity argument = {.name = {p->next->text, p->next->at}};
        if (p->next->kind != TOKEN_NAME) {
            parse_problem(p, "expected an operand of the effect, or }");
            return;
        }
        p->next++;
        /* substeps NUMBER: no operand, but how often in a step the states of the effect move. */
        if (name_is(argument.name, "substeps")) {
            if (use->substeps != NULL) {
                source_problem(p->s, argument.name.at, "a second 'substeps'");
            }
            use->substeps = parse_formula(p);
            continue;
        }
        argument.value = parse_formula(p);
        if (take_option(p, "at")) {
            argument.point = parse_formula(p);
        }
        ADD_TO(p->s->memory, use->operands, use->operand_count, use->operand_room, argument);
    }
}

void read_effect(parser *p, void *slot)
{
    scene *written = slot;
    effect_use use = {.name = take_new_name(p, "expected a name for the effect")};
    if (p->failed) {
        return;
    }
    if (next_is_sign(p, '{')) {
        if (p->block != NULL) {
            source_problem(p->s, use.name.at, "a definition has no rate of its own: put it outside of the block");
        }
        const rate_block *around = p->block;
        p->block = NULL;
        parse_definition(p, written, use.name);
        p->block = around;
        return;
    }
    use.kind = take_name(p, "expected a kind of effect, or { and what it is");
    if (!p->failed) {
        parse_operands(p, &use);
    }
    use.broken = p->failed;
    use.block = p->block;
    use.symbol = use.name.text;
    use.used_at = use.name.at;
    use.outer = -1;
    LIST_ADD(p->s->memory, written->effects, use);
}

void read_signal(parser *p, void *slot)
{
    scene *written = slot;
    quantity q = {.name = take_new_name(p, "expected a name for the signal")};
    expect_sign(p, '=', "expected = and a formula");
    q.value = parse_formula(p);
    q.block = p->block;
    LIST_ADD(p->s->memory, written->signals, q);
}

void read_setting(parser *p, void *slot)
{
    scene *written = slot;
    setting set = {.time = parse_formula(p)};
    expect_word(p, "set", "expected set, as in: at 2 s set drive.open = 1");
    set.what = take_name(p, "expected the name of a tunable, or of a fault: drive.open");
    expect_sign(p, '=', "expected = and a value");
    set.value = parse_formula(p);
    LIST_ADD(p->s->memory, written->settings, set);
}
