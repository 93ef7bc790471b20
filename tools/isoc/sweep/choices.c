/* NAME = VALUE {, VALUE} {; NAME = ...}. A VALUE is a number, numbers from one to another (0.1 .. 0.3 kg by 21), or one
 * that is random (normal(0.2, 0.01) kg); of `method` the word of a method, of `step` a time. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tools/isoc/formula/scalar.h"
#include "tools/isoc/scene/names.h"
#include "tools/isoc/scene/parser.h"
#include "tools/isoc/scene/take.h"
#include "tools/isoc/sweep/sweep.h"

enum { MOST_VALUES = 1000000 };

static const char *const laws[] = {[SWEEP_UNIFORM] = "uniform", [SWEEP_NORMAL] = "normal"};

/* What a reader of SET has at hand. */
typedef struct reading {
    parser at;
    values v;
    const plant *p;
    const scene *written;
    sweep_variables made;
} reading;

/* The text as the lexer is to read it: the signs `..` and `by`, which no scene has, are `:` and `=`. Of the same length, so
 * that places stay. */
static const char *readable(arena *memory, const script *of)
{
    static const char rest[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.";
    char *made = arena_copy(memory, of->text, of->length);
    for (size_t i = 0; i + 1 < of->length; i++) {
        const bool begins = i == 0 || strchr(rest, made[i - 1]) == NULL;
        const bool ends = made[i + 2] == '\0' || strchr(rest, made[i + 2]) == NULL;
        if (made[i] == '.' && made[i + 1] == '.') {
            made[i] = ':';
            made[i + 1] = ' ';
        } else if (begins && ends && made[i] == 'b' && made[i + 1] == 'y') {
            made[i] = '=';
            made[i + 1] = ' ';
        }
    }
    return made;
}

/* The unit that isoc writes for a dimension, as it reads it. */
static unit unit_as_written(arena *memory, const char *text)
{
    source s = source_of_text(memory, "unit", arena_format(memory, "constant c = 1 %s\n", text));
    const scene of = parse_scene(&s);
    const bool is_read = s.problem_count == 0 && of.parameters.count == 1 && of.parameters.all[0].value != NULL;
    return is_read ? of.parameters.all[0].value->unit : unit_one;
}

static void be_of(arena *memory, sweep_variable *v, dimension of)
{
    const char *text = dimension_unit(memory, of);
    v->of = of;
    v->unit_text = strcmp(text, "1") == 0 ? "" : text;
    v->si = unit_as_written(memory, v->unit_text);
}

int sweep_tunable_called(const mechanism *m, const char *called)
{
    for (int i = 0; i < m->parameters.count; i++) {
        const variable *v = &m->parameters.all[i];
        const bool is = (v->name != NULL && strcmp(v->name, called) == 0) ||
                        (v->display_name != NULL && strcmp(v->display_name, called) == 0);
        if (is) {
            return i;
        }
    }
    return -1;
}

/* Which it is, and of what dimension. */
static bool find_variable(reading *r, sweep_variable *v)
{
    static const dimension time = {.s = 1};
    source *s = r->at.s;
    const mechanism *m = r->p->m;
    const int parameter = INDEX_OF(r->written->parameters, v->name);
    v->tunable = sweep_tunable_called(m, v->name);
    v->sort = SWEEP_NUMBER;
    if (v->tunable >= 0) {
        be_of(s->memory, v, m->parameters.all[v->tunable].dimension);
    } else if (parameter >= 0) {
        const value is = r->v.parameters[parameter];
        if (is.count != 1) {
            return PARSE_FAULT(&r->at, v->at, "'%s' is a vector: only numbers vary", v->name);
        }
        be_of(s->memory, v, is.of);
    } else if (strcmp(v->name, "method") == 0) {
        v->sort = SWEEP_METHOD;
    } else if (strcmp(v->name, "step") == 0) {
        v->sort = SWEEP_STEP;
        be_of(s->memory, v, time);
    } else {
        const char *near = suggest_setting(s, r->written, v->name);
        return PARSE_FAULT(&r->at, v->at,
                           "no constant, tunable or fault is called '%s'%s; `method` and `step` vary too", v->name,
                           near);
    }
    FOR_EACH (const sweep_variable, other, r->made) {
        if (strcmp(other->name, v->name) == 0 || (v->tunable >= 0 && other->tunable == v->tunable)) {
            return PARSE_FAULT(&r->at, v->at, "'%s' stands twice", v->name);
        }
    }
    return true;
}

/* The number in a formula that is one, with a sign or without; NULL. */
static formula *number_in(formula *f)
{
    return f == NULL ? NULL : f->kind == FORMULA_NUMBER ? f : f->kind == FORMULA_NEGATE ? number_in(f->parts[0]) : NULL;
}

static bool is_bare(const formula *f)
{
    return f != NULL && dimension_equal(f->unit.of, unit_one.of) && f->unit.numerator == 1 && f->unit.denominator == 1;
}

/* 0.1 .. 0.3 kg: what has no unit takes that of what follows. */
static void lend_unit(formula *to, const unit *of)
{
    formula *number = number_in(to);
    if (is_bare(number)) {
        number->unit = *of;
    }
}

/* The number that a formula is. */
static double number_of(reading *r, const sweep_variable *v, const formula *f)
{
    FOR_EACH (const sweep_variable, other, r->made) {
        if (f != NULL && f->kind == FORMULA_NAME && strcmp(f->name, other->name) == 0) {
            PARSE_FAULT(&r->at, f->at, "'%s' varies itself: a value is of what does not", f->name);
            return 0.0;
        }
    }
    return r->at.failed ? 0.0 : value_constant(&r->v, f, v->of, arena_format(r->at.s->memory, "'%s'", v->name), 0.0);
}

static void add_number(reading *r, sweep_variable *v, double number, bool is_round)
{
    LIST_ADD(r->at.s->memory, v->listed, ((sweep_value){number, NULL, is_round}));
}

/* FIRST .. LAST by COUNT, of which FIRST has been read. */
static void read_range(reading *r, sweep_variable *v, formula *first)
{
    parser *at = &r->at;
    formula *last = parse_formula(at), *with = number_in(last);
    if (at->failed || !take_sign(at, '=')) {
        parse_problem(at, "expected by and the number of values: 0.1 .. 0.3 kg by 21");
        return;
    }
    const double count = at->next->number;
    if (at->next->kind != TOKEN_NUMBER || count != floor(count) || count < 2 || count > MOST_VALUES) {
        parse_problem(at, "expected the number of values, from 2 to 1000000: 0.1 .. 0.3 kg by 21");
        return;
    }
    at->next++;
    if (with != NULL) {
        lend_unit(first, &with->unit);
    }
    const double from = number_of(r, v, first), to = number_of(r, v, last);
    for (double i = 0; i < count && !at->failed; i++) {
        add_number(r, v, (from * (count - 1 - i) + to * i) / (count - 1), true);
    }
}

/* LAW(FIRST, SECOND) [UNIT] */
static void read_random(reading *r, sweep_variable *v, sweep_law law)
{
    parser *at = &r->at;
    const place where = at->next->at;
    at->next += 2;
    formula *first = parse_formula(at);
    expect_sign(at, ',',
                "expected , and a second number: uniform(0.1, 0.3) kg is from 0.1 kg to 0.3 kg, "
                "normal(0.2, 0.01) kg has this mean and this standard deviation");
    formula *second = parse_formula(at), *with = number_in(second);
    expect_sign(at, ')', "expected )");
    unit behind;
    if (!at->failed && take_unit(at, &behind)) {
        lend_unit(first, &behind);
        lend_unit(second, &behind);
    } else if (with != NULL) {
        lend_unit(first, &with->unit);
    }
    v->law = law;
    v->first = number_of(r, v, first);
    v->second = number_of(r, v, second);
    if (!at->failed && (law == SWEEP_NORMAL ? !(v->second >= 0.0) : !(v->second >= v->first))) {
        PARSE_FAULT(at, where,
                    law == SWEEP_NORMAL ? "the standard deviation of '%s' is below zero"
                                        : "the limits of '%s' are not in their order",
                    v->name);
    }
}

static void read_method_word(reading *r, sweep_variable *v)
{
    parser *at = &r->at;
    const token *t = at->next;
    if (t->kind != TOKEN_NAME || index_of_word(t->text, method_names, ISO_METHODS) == ISO_METHODS) {
        PARSE_FAULT(at, t->at, "expected a method%s: %s", source_suggestion(at->s, t->text, method_names, ISO_METHODS),
                    alternatives(at->s->memory, method_names, ISO_METHODS));
        return;
    }
    at->next++;
    LIST_ADD(at->s->memory, v->listed, ((sweep_value){0.0, t->text, false}));
}

static void read_value(reading *r, sweep_variable *v)
{
    parser *at = &r->at;
    for (sweep_law law = SWEEP_UNIFORM; law <= SWEEP_NORMAL; law++) {
        if (v->sort == SWEEP_NUMBER && next_is_word(at, laws[law]) && at->next[1].sign == '(') {
            if (v->listed.count > 0) {
                parse_problem(at, "a random value stands alone, without further ones");
            } else {
                read_random(r, v, law);
            }
            return;
        }
    }
    if (v->sort == SWEEP_METHOD) {
        read_method_word(r, v);
        return;
    }
    formula *f = parse_formula(at);
    if (!at->failed && take_sign(at, ':')) {
        read_range(r, v, f);
    } else if (!at->failed) {
        LIST_ADD(at->s->memory, v->listed, ((sweep_value){number_of(r, v, f), NULL, false}));
    }
}

static void read_variable(reading *r)
{
    parser *at = &r->at;
    sweep_variable v = {.name = at->next->text, .at = at->next->at, .unit_text = ""};
    if (at->next->kind != TOKEN_NAME) {
        parse_problem(at, "expected what varies, such as mass = 0.1 .. 0.3 kg by 21");
        return;
    }
    at->next++;
    if (!find_variable(r, &v)) {
        return;
    }
    expect_sign(at, '=', "expected = and values, such as mass = 0.1 .. 0.3 kg by 21");
    do {
        if (!at->failed) {
            read_value(r, &v);
        }
    } while (!at->failed && v.law == SWEEP_LISTED && take_sign(at, ','));
    LIST_ADD(at->s->memory, r->made, v);
}

sweep_variables sweep_read_variables(source *s, graph *g, const scene *written, const plant *p, const script *of)
{
    static const block none = {.what = "value"};
    scene with = *written;
    reading r = {.at = {.s = s, .made = &with, .statements = &none, .within = &none}, .p = p, .written = written};
    script read = *of;
    read.text = readable(s->memory, of);
    r.at.known = (dictionary){.memory = s->memory};
    r.at.next = lex(s, &read, source_passage(s, of, 0, of->length, NULL));
    values_start(&r.v, s, g, written, (size_t)p->m->parameters.count, p->is_double);
    values_resolve(&r.v);
    if (r.at.next->kind == TOKEN_END) {
        parse_problem(&r.at, "SET is what varies, such as mass = 0.1 .. 0.3 kg by 21");
    }
    while (r.at.next->kind != TOKEN_END && !r.at.failed) {
        read_variable(&r);
        if (!r.at.failed && r.at.next->kind != TOKEN_END && !take_sign(&r.at, ';')) {
            parse_problem(&r.at, "expected , and a further value, or ; and what varies besides");
        }
    }
    return r.made;
}
