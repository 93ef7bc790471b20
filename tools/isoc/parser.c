#include "tools/isoc/parser.h"

#include <string.h>

static const char *const statement_words[] = {"gravity", "step",       "method",    "body",     "joint",
                                              "input",   "output",     "tunable",   "constant", "compensated",
                                              "checked", "iterations", "tolerance", "substeps"};
static const char *const body_words[] = {"mass", "com", "inertia"};
static const char *const joint_words[] = {"parent",     "child",   "axis",   "start", "speed",
                                          "continuous", "damping", "spring", "drive"};
static const char *const joint_kinds[] = {"fixed", "revolute", "prismatic"};
static const char *const output_kinds[] = {"position",    "speed",    "acceleration", "velocity",      "turns",
                                           "orientation", "spin",     "force",        "moment",        "energy",
                                           "local_error", "residual", "violation",    "violation_rate"};

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

bool next_is_sign(const parser *p, char sign)
{
    return p->next->sign == sign;
}

static bool next_is_word(const parser *p, const char *word)
{
    return p->next->kind == TOKEN_NAME && strcmp(p->next->text, word) == 0;
}

bool take_sign(parser *p, char sign)
{
    const bool is = next_is_sign(p, sign);
    p->next += is;
    return is;
}

bool take_word(parser *p, const char *word)
{
    const bool is = next_is_word(p, word);
    p->next += is;
    return is;
}

void parse_problem(parser *p, const char *message)
{
    if (!p->failed) {
        const char *found = p->next->kind == TOKEN_END ? "the end of the file" : p->next->text;
        const char *quote = p->next->kind == TOKEN_END ? "" : "'";
        source_problem(p->s, p->next->at, "%s; found %s%s%s", message, quote, found, quote);
        p->failed = true;
    }
}

/* The index of the next token among words, which is taken; or COUNT, with a problem that says `expected`. */
static size_t take_one_of(parser *p, const char *const *words, size_t count, const char *expected)
{
    for (size_t i = 0; i < count; i++) {
        if (take_word(p, words[i])) {
            return i;
        }
    }
    const char *near = p->next->kind == TOKEN_NAME ? source_suggestion(p->s, p->next->text, words, count) : "";
    parse_problem(p, arena_format(p->s->memory, "expected %s%s", expected, near));
    return count;
}

static bool is_reserved(const char *word)
{
    unit u;
    static const char *const own[] = {"x", "y", "z", "ground", "pi", "at", "about", "rotate", "rest", "along", "of"};
    for (size_t i = 0; i < COUNT(own); i++) {
        if (strcmp(word, own[i]) == 0) {
            return true;
        }
    }
    return unit_find(word, &u);
}

static name take_name(parser *p, const char *expected, bool declared)
{
    name n = {NULL, p->next->at};
    if (p->next->kind != TOKEN_NAME || p->next->first_on_line) {
        parse_problem(p, expected);
        return n;
    }
    n.text = p->next->text;
    if (declared && is_reserved(n.text)) {
        source_problem(p->s, n.at, "'%s' is a unit or a word of the language: choose another name", n.text);
    }
    p->next++;
    return n;
}

/* Puts a value into its slot, which must be empty. */
static void set(parser *p, formula **slot, const token *word, formula *value)
{
    if (*slot != NULL) {
        source_problem(p->s, word->at, "a second '%s'; the first is in line %zu", word->text,
                       source_line(p->s, (*slot)->at));
    } else if (value != NULL) {
        *slot = value;
    }
}

static void parse_placement(parser *p, placement *to, const token *word)
{
    placement read = {.body = take_name(p, "expected the name of a body, or ground", false)};
    while (!p->failed && (next_is_word(p, "at") || next_is_word(p, "rotate"))) {
        const token *t = p->next++;
        if (strcmp(t->text, "at") == 0) {
            if (read.turn_count != 0) {
                source_problem(p->s, t->at, "'at' comes before 'rotate': first move, then turn");
            }
            set(p, &read.position, t, parse_formula(p));
        } else {
            read.turns = arena_grow(p->s->memory, read.turns, read.turn_count, &read.turn_room, sizeof *read.turns);
            turn *r = &read.turns[read.turn_count++];
            *r = (turn){.at = t->at, .angle = parse_formula(p)};
            if (!p->failed && !take_word(p, "about")) {
                parse_problem(p, "expected 'about' and an axis: rotate 90 deg about x");
            }
            r->axis = p->failed ? NULL : parse_axis(p);
        }
    }
    if (to->body.text != NULL) {
        source_problem(p->s, word->at, "a second '%s'; the first is in line %zu", word->text,
                       source_line(p->s, to->body.at));
    } else {
        *to = read;
    }
}

static void parse_body_property(parser *p, void *to)
{
    body *b = to;
    const token *word = p->next;
    formula **const slots[] = {&b->mass, &b->com, &b->inertia};
    const size_t i = take_one_of(p, body_words, COUNT(body_words), "mass, com, inertia or }");
    if (i < COUNT(body_words)) {
        set(p, slots[i], word, parse_formula(p));
    }
}

static void parse_drive(parser *p, joint *j, const token *word)
{
    name n = take_name(p, "expected the name of an input", false);
    if (j->drive.text != NULL) {
        source_problem(p->s, word->at, "a second 'drive'; the first is in line %zu", source_line(p->s, j->drive.at));
    }
    j->drive = n;
}

static void parse_joint_property(parser *p, void *to)
{
    joint *j = to;
    const token *word = p->next;
    switch (take_one_of(p, joint_words, COUNT(joint_words),
                        "parent, child, axis, start, speed, continuous, damping, spring, drive or }")) {
    case 0:
        parse_placement(p, &j->parent, word);
        break;
    case 1:
        parse_placement(p, &j->child, word);
        break;
    case 2:
        set(p, &j->axis, word, parse_axis(p));
        break;
    case 3:
        set(p, &j->start.coordinate, word, parse_formula(p));
        break;
    case 4:
        set(p, &j->speed, word, parse_formula(p));
        break;
    case 5:
        j->continuous = true;
        j->continuous_at = word->at;
        break;
    case 6:
        set(p, &j->damping, word, parse_formula(p));
        break;
    case 7:
        set(p, &j->spring, word, parse_formula(p));
        if (!p->failed && next_is_word(p, "rest")) {
            word = p->next++;
            set(p, &j->rest, word, parse_formula(p));
        }
        break;
    case 8:
        parse_drive(p, j, word);
        break;
    default:
        break;
    }
}

static bool is_one_of(const token *t, const char *const *words, size_t count)
{
    for (size_t i = 0; t->kind == TOKEN_NAME && i < count; i++) {
        if (strcmp(t->text, words[i]) == 0) {
            return true;
        }
    }
    return false;
}

/* After an error: on to the next line that begins with one of these words, or with a brace. */
static void recover(parser *p, const char *const *words, size_t count)
{
    while (p->next->kind != TOKEN_END && !next_is_sign(p, '}') &&
           !(p->next->first_on_line &&
             (is_one_of(p->next, words, count) || is_one_of(p->next, statement_words, COUNT(statement_words))))) {
        p->next++;
    }
    p->failed = false;
}

/* { property ... }, each read by parse_property. Returns whether all could be read. */
static bool parse_block(parser *p, void *to, void (*parse_property)(parser *, void *), const char *const *words,
                        size_t count)
{
    const token *open = p->next;
    if (!take_sign(p, '{')) {
        parse_problem(p, "expected {");
        return false;
    }
    bool whole = true;
    while (!take_sign(p, '}')) {
        const bool statement = p->next->first_on_line && is_one_of(p->next, statement_words, COUNT(statement_words));
        if (p->next->kind == TOKEN_END || statement) {
            source_problem(p->s, open->at, "this { is never closed");
            return false;
        }
        if (!take_sign(p, ';')) {
            const token *before = p->next;
            parse_property(p, to);
            if (p->failed) {
                p->next += p->next == before;
                recover(p, words, count);
                whole = false;
            }
        }
    }
    return whole;
}

static void parse_body(parser *p, scene *made)
{
    body b = {.name = take_name(p, "expected a name for the body", true)};
    b.broken = p->failed || !parse_block(p, &b, parse_body_property, body_words, COUNT(body_words));
    made->bodies = arena_grow(p->s->memory, made->bodies, made->body_count, &made->body_room, sizeof b);
    made->bodies[made->body_count++] = b;
}

/* A kind that is none: the rest of the scene is looked at as if it were one that moves. */
static void parse_kind(parser *p, scene *made, joint *j)
{
    j->kind = (joint_kind)take_one_of(p, joint_kinds, COUNT(joint_kinds), "fixed, revolute or prismatic");
    if (p->failed && p->next[0].kind != TOKEN_END && p->next[1].sign == '{') {
        made->broken = true;
        j->kind = JOINT_REVOLUTE;
        p->failed = false;
        p->next++;
    }
}

static void parse_joint(parser *p, scene *made)
{
    joint j = {.name = take_name(p, "expected a name for the joint", true)};
    if (!p->failed) {
        parse_kind(p, made, &j);
    }
    j.broken = p->failed || !parse_block(p, &j, parse_joint_property, joint_words, COUNT(joint_words));
    made->joints = arena_grow(p->s->memory, made->joints, made->joint_count, &made->joint_room, sizeof j);
    made->joints[made->joint_count++] = j;
}

static void parse_parameter(parser *p, scene *made, bool tunable)
{
    quantity q = {.name = take_name(p, "expected a name for the parameter", true), .tunable = tunable};
    if (!p->failed && !take_sign(p, '=')) {
        parse_problem(p, "expected = and a value");
    }
    q.value = p->failed ? NULL : parse_formula(p);
    made->parameters =
        arena_grow(p->s->memory, made->parameters, made->parameter_count, &made->parameter_room, sizeof q);
    made->parameters[made->parameter_count++] = q;
}

static void parse_input(parser *p, scene *made)
{
    quantity q = {.name = take_name(p, "expected a name for the input", true)};
    if (!p->failed && take_word(p, "jump")) {
        q.jump = parse_formula(p);
    }
    if (!p->failed && take_sign(p, '=')) {
        q.value = parse_formula(p);
    }
    made->inputs = arena_grow(p->s->memory, made->inputs, made->input_count, &made->input_room, sizeof q);
    made->inputs[made->input_count++] = q;
}

static void parse_output(parser *p, scene *made)
{
    output o = {.name = take_name(p, "expected a name for the output", false), .along = -1};
    if (!p->failed && !take_sign(p, '=')) {
        parse_problem(p, "expected =, as in: output angle = position of joint");
    }
    o.kind_at = p->next->at;
    if (!p->failed) {
        o.kind =
            (output_kind)take_one_of(p, output_kinds, COUNT(output_kinds),
                                     "position, speed, acceleration, velocity, turns, energy, local_error or residual");
    }
    if (!p->failed && o.kind < OUTPUT_ENERGY) {
        if (!take_word(p, "of")) {
            parse_problem(p, "expected 'of' and the name of a joint or a body");
        } else {
            o.of = take_name(p, "expected the name of a joint or a body", false);
        }
        if (!p->failed && take_word(p, "at")) {
            o.point = parse_formula(p);
        }
        o.along_at = p->next->at;
        if (!p->failed && take_word(p, "along")) {
            static const char *const axes[] = {"x", "y", "z"};
            o.along = (int)take_one_of(p, axes, COUNT(axes), "x, y or z");
        }
    }
    if (!p->failed) {
        made->outputs = arena_grow(p->s->memory, made->outputs, made->output_count, &made->output_room, sizeof o);
        made->outputs[made->output_count++] = o;
    }
}

/* A word as a value: of `method`, and of switches. */
static void parse_word(parser *p, name *slot, const token *word, const char *expected)
{
    const name n = take_name(p, expected, false);
    if (slot->text != NULL) {
        source_problem(p->s, word->at, "a second '%s'; the first is in line %zu", word->text,
                       source_line(p->s, slot->at));
    }
    *slot = n;
}

static void parse_statement(parser *p, scene *made)
{
    const token *word = p->next;
    switch (take_one_of(p, statement_words, COUNT(statement_words),
                        "body, joint, gravity, step, method, compensated, checked, iterations, tolerance, substeps, "
                        "input, output, tunable or constant")) {
    case 0:
        set(p, &made->gravity, word, parse_formula(p));
        break;
    case 1:
        set(p, &made->step, word, parse_formula(p));
        break;
    case 2:
        parse_word(p, &made->method, word, "expected a method, such as rk4");
        break;
    case 3:
        parse_body(p, made);
        break;
    case 4:
        parse_joint(p, made);
        break;
    case 5:
        parse_input(p, made);
        break;
    case 6:
        parse_output(p, made);
        break;
    case 7:
        parse_parameter(p, made, true);
        break;
    case 8:
        parse_parameter(p, made, false);
        break;
    case 9:
        parse_word(p, &made->compensated, word, "expected yes or no");
        break;
    case 10:
        parse_word(p, &made->checked, word, "expected yes or no");
        break;
    case 11:
        set(p, &made->iterations, word, parse_formula(p));
        break;
    case 12:
        set(p, &made->tolerance, word, parse_formula(p));
        break;
    case 13:
        set(p, &made->substeps, word, parse_formula(p));
        break;
    default:
        break;
    }
    if (!p->failed && !p->next->first_on_line && !next_is_sign(p, ';')) {
        parse_problem(p, "expected the end of the line");
    }
}

scene parse_scene(source *s, const token *tokens)
{
    parser p = {.s = s, .next = tokens};
    scene made = {0};
    while (p.next->kind != TOKEN_END) {
        if (take_sign(&p, ';')) {
            continue;
        }
        const token *before = p.next;
        parse_statement(&p, &made);
        if (p.failed) {
            made.broken = true;
            p.next += p.next == before;
            recover(&p, NULL, 0);
            p.next += next_is_sign(&p, '}');
        }
    }
    return made;
}
