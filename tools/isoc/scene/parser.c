#include "tools/isoc/scene/parser.h"

#include <stddef.h>
#include <string.h>

#include "tools/isoc/base/embedded.h"
#include "tools/isoc/scene/take.h"

/* LEAST to MOST */
static void read_limits(parser *p, quantity *q)
{
    q->least = parse_formula(p);
    expect_word(p, "to", "expected to and the largest value: in 0.5 N/m to 2 N/m");
    q->most = parse_formula(p);
}

/* tunable or constant */
static void read_parameter(parser *p, void *slot)
{
    scene *written = slot;
    quantity q = {.name = take_parameter_name(p, "expected a name for the parameter")};
    q.tunable = strcmp(p->word->text, "tunable") == 0;
    expect_sign(p, '=', "expected = and a value");
    q.value = parse_formula(p);
    if (!p->failed && q.tunable && take_option(p, "in")) {
        read_limits(p, &q);
    }
    LIST_ADD(p->s->memory, written->parameters, q);
    note_constant(p, &q);
}

/* VALUE after NUMBER ticks */
static void read_safe(parser *p, quantity *q)
{
    q->safe = parse_formula(p);
    expect_word(p, "after", "expected after and a number of ticks: safe 0 N after 5 ticks");
    q->after = parse_ticks(p, "the time of a safe value is in ticks: safe 0 N after 5 ticks");
}

/* A word behind the properties of an input that is none of them, or that is out of order. */
static void refuse_input_word(parser *p)
{
    static const char *const words[] = {"held", "smooth", "jump", "in", "safe"};
    if (!p->failed && p->next->kind == TOKEN_NAME && !p->next->first_on_line) {
        const bool known = index_of_word(p->next->text, words, COUNT_OF(words)) < COUNT_OF(words);
        const char *near = known ? "" : source_suggestion(p->s, p->next->text, words, COUNT_OF(words));
        parse_problem(p, arena_format(p->s->memory,
                                      "expected, in this order, a unit, held or smooth, jump with a change, = with a "
                                      "value, in with limits, safe with a value after ticks%s",
                                      near));
    }
}

static void read_input_statement(parser *p, void *slot)
{
    scene *written = slot;
    quantity q = {.name = take_new_name(p, "expected a name for the input")};
    q.has_unit = take_unit(p, &q.unit);
    q.smooth = !take_option(p, "held") && take_option(p, "smooth");
    if (take_option(p, "jump")) {
        q.jump = parse_formula(p);
    }
    if (take_sign(p, '=')) {
        q.value = parse_formula(p);
    }
    if (take_option(p, "in")) {
        read_limits(p, &q);
    }
    if (take_option(p, "safe")) {
        read_safe(p, &q);
    }
    refuse_input_word(p);
    LIST_ADD(p->s->memory, written->inputs, q);
}

/* every PERIOD [at PHASE] { ... }: what of the scene is computed at a rate. */
static const property paced[] = {
    {"signal", read_signal, 0, EVERY_KIND | MANY, NULL},
    {"output", read_output, 0, EVERY_KIND | MANY, NULL},
    {"effect", read_effect, 0, EVERY_KIND | MANY, NULL},
};

static const block rate = {"block of a rate", PROPERTIES(paced)};

void read_rate_block(parser *p, void *slot)
{
    scene *written = slot;
    const name word = {p->word->text, p->word->at};
    const rate_block *of_rate = take_rate(p);
    if (of_rate == NULL) {
        return;
    }
    const rate_block *around = p->block;
    p->block = of_rate;
    written->broken |= !parse_block(p, &rate, 0, word, slot);
    p->block = around;
}

#define IN(member) offsetof(scene, member)
static const property statements[] = {
    {"gravity", read_formula, IN(gravity), EVERY_KIND, NULL},
    {"step", read_formula, IN(step), EVERY_KIND, NULL},
    {"method", read_method, IN(method), EVERY_KIND, NULL},
    {"compensated", read_switch, IN(options.compensated), EVERY_KIND, NULL},
    {"checked", read_switch, IN(options.checked), EVERY_KIND, NULL},
    {"iterations", read_formula, IN(options.iterations), EVERY_KIND, NULL},
    {"tolerance", read_formula, IN(options.tolerance), EVERY_KIND, NULL},
    {"substeps", read_formula, IN(options.substeps), EVERY_KIND, NULL},
    {"stabilisation", read_stabilisation, IN(stabilisation), EVERY_KIND, NULL},
    {"overrun", read_overrun, IN(policies), EVERY_KIND, NULL},
    {"grace", read_grace, IN(policies), EVERY_KIND, NULL},
    {"publish", read_publish, IN(policies), EVERY_KIND, NULL},
    {"histogram", read_histogram, IN(policies), EVERY_KIND, NULL},
    {"body", read_body, 0, EVERY_KIND | MANY, NULL},
    {"frame", read_frame, 0, EVERY_KIND | MANY, NULL},
    {"joint", read_joint_statement, 0, EVERY_KIND | MANY, NULL},
    {"closure", read_closure, 0, EVERY_KIND | MANY, NULL},
    {"close", read_closure, 0, EVERY_KIND | MANY, NULL},
    {"spring", read_spring_statement, 0, EVERY_KIND | MANY, NULL},
    {"force", read_force, 0, EVERY_KIND | MANY, NULL},
    {"constant", read_parameter, 0, EVERY_KIND | MANY, NULL},
    {"tunable", read_parameter, 0, EVERY_KIND | MANY, NULL},
    {"input", read_input_statement, 0, EVERY_KIND | MANY, NULL},
    {"output", read_output, 0, EVERY_KIND | MANY, NULL},
    {"effect", read_effect, 0, EVERY_KIND | MANY, NULL},
    {"signal", read_signal, 0, EVERY_KIND | MANY, NULL},
    {"mode", read_mode, 0, EVERY_KIND | MANY, NULL},
    {"when", read_when, 0, EVERY_KIND | MANY, NULL},
    {"hold", read_hold, 0, EVERY_KIND | MANY, NULL},
    {"events", read_events, IN(events), EVERY_KIND, NULL},
    {"at", read_setting, 0, EVERY_KIND | MANY, NULL},
    {"every", read_rate_block, 0, EVERY_KIND | MANY, NULL},
    {"repeat", read_repeat, 0, EVERY_KIND | MANY, NULL},
    {"include", read_include, 0, EVERY_KIND | MANY, NULL},
};
#undef IN

/* The factors of units by their words, of which there are few: a scene may have as many names as it has factors. */
static dictionary factor_words(const parser *p)
{
    dictionary words = {.memory = p->s->memory};
    FOR_EACH (const name, factor, p->factors) {
        if (dictionary_find(&words, factor->text) == NULL) {
            dictionary_put(&words, factor->text, 0);
        }
    }
    return words;
}

static void refuse_factors(parser *p, const dictionary *words, const quantity *all, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (all[i].name.text != NULL && dictionary_find(words, all[i].name.text) != NULL) {
            refuse_factor(p, 0, all[i].name);
        }
    }
}

/* The definition of a kind that the scene does not define, from those that come with isoc. */
static void read_kind(parser *p, scene *written, name kind)
{
    const char *path = kind.text == NULL ? "" : arena_format(p->s->memory, "models/effects/%s.scene", kind.text);
    const embedded_file *file = embedded_find(effect_files, path, strlen(path));
    if (file != NULL && find_effect_kind(written, kind) == NULL) {
        const script *s = source_add(p->s, file->path, file->text);
        parse_nested(p, lex(p->s, s, source_passage(p->s, s, 0, s->length, NULL)), written);
    }
}

/* Those of the kinds that the scene uses, and that parts of definitions are of. */
static void read_library(parser *p, scene *written)
{
    for (size_t i = 0; i < written->effects.count; i++) {
        read_kind(p, written, written->effects.all[i].kind);
    }
    for (size_t i = 0; i < written->effect_kinds.count; i++) {
        for (size_t n = 0; n < written->effect_kinds.all[i].line_count; n++) {
            const effect_use *part = written->effect_kinds.all[i].lines[n].part;
            if (part != NULL) {
                read_kind(p, written, part->kind);
            }
        }
    }
}

/* Uses of all definitions so far. */
static void read_trials(parser *p, scene *written, const char *joints)
{
    const size_t before = written->effects.count;
    const script *s = source_add(p->s, "--check", trial_statements(p->s, written, joints));
    parse_nested(p, lex(p->s, s, source_passage(p->s, s, 0, s->length, NULL)), written);
    for (size_t i = before; i < written->effects.count; i++) {
        written->effects.all[i].is_trial = true;
    }
}

scene parse_scene(source *s, const char *joints)
{
    static const block whole = {"scene", PROPERTIES(statements)};
    const inclusion opened = {.file = s->scripts[0]};
    scene result = {.name = source_name(s)};
    parser p = {.s = s, .target = &result, .next = lex(s, opened.file, 0), .included = &opened};
    p.known = (dictionary){.memory = s->memory};
    const bool read = parse_statements(&p, &whole, &result);
    result.broken |= !read;
    if (joints != NULL) {
        read_trials(&p, &result, joints);
    }
    read_library(&p, &result);
    expand_parts(s, &result);
    const dictionary words = factor_words(&p);
    refuse_factors(&p, &words, result.parameters.all, result.parameters.count);
    refuse_factors(&p, &words, result.inputs.all, result.inputs.count);
    refuse_factors(&p, &words, result.signals.all, result.signals.count);
    refuse_factors(&p, &words, result.events.modes.all, result.events.modes.count);
    check_indices(&p);
    return result;
}

/* The name EFFECT.FAULT of a fault that is called so, or EFFECT_FAULT as in the header of the plant; else NULL. */
static const char *fault_called(const parser *p, const scene *whole, const char *called)
{
    FOR_EACH (const effect_use, use, whole->effects) {
        const size_t length = use->name.text == NULL ? 0 : strlen(use->name.text);
        const bool is_name = length > 0 && strncmp(called, use->name.text, length) == 0;
        const bool begins = (is_name || (length > 0 && strncmp(called, use->symbol, length) == 0)) &&
                            (called[length] == '.' || called[length] == '_');
        const effect_kind *kind = begins ? find_effect_kind(whole, use->kind) : NULL;
        for (size_t i = 0; kind != NULL && i < kind->line_count; i++) {
            if (kind->lines[i].kind == EFFECT_FAULT && name_is(kind->lines[i].name, called + length + 1)) {
                return arena_format(p->s->memory, "%s.%s", use->name.text, called + length + 1);
            }
        }
    }
    return NULL;
}

/* NAME = VALUE: takes the place of the value of a parameter, or is the start of a fault. */
static void set_parameter(parser *p, void *to)
{
    scene *written = to;
    const token *called = p->next;
    p->next += called->kind == TOKEN_NAME;
    if (called->kind != TOKEN_NAME || !take_sign(p, '=')) {
        parse_problem(p, "expected NAME = VALUE");
    }
    formula *value = p->failed ? NULL : parse_formula(p);
    const int i = p->failed ? -1 : INDEX_OF(written->parameters, called->text);
    if (i >= 0) {
        quantity *q = &written->parameters.all[i];
        q->stated = q->stated == NULL ? q->value : q->stated;
        q->value = value;
        return;
    }
    const char *fault = p->failed ? NULL : fault_called(p, written, called->text);
    if (fault != NULL) {
        LIST_ADD(p->s->memory, written->fault_starts, ((setting){.what = {fault, called->at}, .value = value}));
    } else if (!p->failed) {
        source_problem(p->s, called->at, "no constant, tunable or fault is called '%s'%s", called->text,
                       suggest_setting(p->s, written, called->text));
    }
}

void scene_set(source *s, scene *written, const script *settings)
{
    parser p = parser_of_option(s, written, settings, settings);
    parse_items(&p, set_parameter, written, "expected ; and a further NAME = VALUE");
}

formula *scene_formula(source *s, scene *written, const script *words)
{
    parser p = parser_of_option(s, written, words, words);
    formula *value = parse_formula(&p);
    if (!p.failed && p.next->kind != TOKEN_END) {
        parse_problem(&p, "expected one value");
    }
    return p.failed ? NULL : value;
}

unit unit_of_text(arena *memory, const char *words)
{
    source s = {.memory = memory};
    const script *option = source_add(&s, "unit", words);
    parser p = parser_of_option(&s, NULL, option, option);
    unit read;
    return take_unit(&p, &read) && p.next->kind == TOKEN_END && s.problem_count == 0 ? read : unit_one;
}
