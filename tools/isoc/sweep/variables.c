/* NAME = VALUE {, VALUE} {; NAME = ...}. A VALUE is a number, numbers from one to another (0.1 .. 0.3 kg by 21), or one
 * that is random (normal(0.2, 0.01) kg); of `method` the word of a method, of `step` a time. */
#include "tools/isoc/sweep/sweep.h"

#include <math.h>
#include <string.h>

#include "tools/isoc/scene/names.h"
#include "tools/isoc/scene/parser.h"
#include "tools/isoc/scene/take.h"

enum { MOST_VALUES = 1000000 };

static const char *const laws[] = {[SWEEP_UNIFORM] = "uniform", [SWEEP_NORMAL] = "normal"};

/* The data of the reader of --set. */
typedef struct reading {
    parser at;
    values v;
    const plant *p;
    const scene *written;
    sweep_variables result;
} reading;

/* The text as the lexer is to read it: the signs `..` and `by`, which no scene has, are `:` and `=`. Of the same
 * length, so that places stay. */
static const char *readable(arena *memory, const script *original)
{
    static const char rest[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.";
    char *copy = arena_copy(memory, original->text, original->length);
    for (size_t i = 0; i + 1 < original->length; i++) {
        const bool begins = i == 0 || strchr(rest, copy[i - 1]) == NULL;
        const bool ends = copy[i + 2] == '\0' || strchr(rest, copy[i + 2]) == NULL;
        if (copy[i] == '.' && copy[i + 1] == '.') {
            copy[i] = ':';
            copy[i + 1] = ' ';
        } else if (begins && ends && copy[i] == 'b' && copy[i + 1] == 'y') {
            copy[i] = '=';
            copy[i + 1] = ' ';
        }
    }
    return copy;
}

static void be_of(arena *memory, sweep_variable *v, dimension dim)
{
    const char *words = dimension_unit(memory, dim);
    v->dim = dim;
    v->unit_text = strcmp(words, "1") == 0 ? "" : words;
    v->si = unit_of_text(memory, v->unit_text);
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

/* The sort of a variable, by its name, and its dimension. */
static bool find_variable(reading *r, sweep_variable *v)
{
    static const dimension time = DIMENSION(0, 0, 1, 0, 0, 0);
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
        be_of(s->memory, v, is.dim);
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
    FOR_EACH (const sweep_variable, other, r->result) {
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
    return f != NULL && dimension_equal(f->unit.dim, unit_one.dim) && f->unit.numerator == 1 &&
           f->unit.denominator == 1;
}

/* 0.1 .. 0.3 kg: a number without a unit takes that of the number that follows. */
static void lend_unit(formula *to, const unit *loan)
{
    formula *number = number_in(to);
    if (is_bare(number)) {
        number->unit = *loan;
    }
}

/* A name in a formula that varies itself; NULL. */
static const formula *varying(const reading *r, const formula *f)
{
    FOR_EACH (const sweep_variable, v, r->result) {
        if (f->kind == FORMULA_NAME && strcmp(f->name, v->name) == 0) {
            return f;
        }
    }
    const formula *found = NULL;
    for (size_t i = 0; i < f->count && found == NULL; i++) {
        found = varying(r, f->parts[i]);
    }
    return found;
}

/* The number that a formula is. */
static double number_of(reading *r, const sweep_variable *v, const formula *f)
{
    const formula *itself = r->at.failed ? NULL : varying(r, f);
    if (itself != NULL) {
        PARSE_FAULT(&r->at, itself->at, "'%s' is varied too: a value follows from what is not", itself->name);
    }
    return r->at.failed ? 0.0 : value_constant(&r->v, f, v->dim, arena_format(r->at.s->memory, "'%s'", v->name), 0.0);
}

/* An item of a list: a value, or so many values from one to another. */
typedef struct stretch {
    formula *first, *last;
    double count;
} stretch;

/* FIRST [.. LAST by COUNT] */
static stretch read_stretch(parser *at)
{
    stretch result = {parse_formula(at), NULL, 1};
    if (at->failed || !take_sign(at, ':')) {
        return result;
    }
    result.last = parse_formula(at);
    if (!at->failed && !take_sign(at, '=')) {
        parse_problem(at, "expected by and the number of values: 0.1 .. 0.3 kg by 21");
    }
    result.count = at->next->number;
    if (!at->failed && (at->next->kind != TOKEN_NUMBER || result.count != floor(result.count) || result.count < 2 ||
                        result.count > (double)MOST_VALUES)) {
        parse_problem(at, "expected the number of values, from 2 to 1000000: 0.1 .. 0.3 kg by 21");
    }
    at->next += !at->failed;
    return result;
}

/* 200, 250 mm: a number without a unit takes that of the next number that has one. */
static void lend_backward(const stretch *all, size_t count)
{
    unit found = unit_one;
    for (size_t i = 2 * count; i-- > 0;) {
        formula *f = number_in(i % 2 == 0 ? all[i / 2].first : all[i / 2].last);
        lend_unit(f, &found);
        found = f != NULL ? f->unit : found;
    }
}

static void add_values(reading *r, sweep_variable *v, const stretch *range)
{
    const double from = number_of(r, v, range->first), to = range->last == NULL ? from : number_of(r, v, range->last);
    for (double i = 0; i < range->count && !r->at.failed; i++) {
        const double between =
            range->last == NULL ? from : (from * (range->count - 1 - i) + to * i) / (range->count - 1);
        LIST_ADD(r->at.s->memory, v->listed, ((sweep_value){between, NULL, range->last != NULL}));
    }
}

/* Values with commas between them. */
static void read_list(reading *r, sweep_variable *v)
{
    LIST_OF(stretch) all = {0};
    do {
        const stretch next = read_stretch(&r->at);
        LIST_ADD(r->at.s->memory, all, next);
    } while (!r->at.failed && take_sign(&r->at, ','));
    if (r->at.failed) {
        return;
    }
    lend_backward(all.all, all.count);
    FOR_EACH (const stretch, s, all) {
        add_values(r, v, s);
    }
}

/* LAW(FIRST, SECOND) [UNIT] */
static void read_random(reading *r, sweep_variable *v, sweep_law law)
{
    parser *at = &r->at;
    const place where = at->next->at;
    at->next += 2;
    formula *low = parse_formula(at);
    expect_sign(at, ',',
                "expected , and a second number: uniform(0.1, 0.3) kg is from 0.1 kg to 0.3 kg, "
                "normal(0.2, 0.01) kg has this mean and this standard deviation");
    formula *high = parse_formula(at), *with = number_in(high);
    expect_sign(at, ')', "expected )");
    unit behind;
    if (!at->failed && take_unit(at, &behind)) {
        lend_unit(low, &behind);
        lend_unit(high, &behind);
    } else if (with != NULL) {
        lend_unit(low, &with->unit);
    }
    v->law = law;
    v->first = number_of(r, v, low);
    v->second = number_of(r, v, high);
    if (!at->failed && (law == SWEEP_NORMAL ? !(v->second >= 0.0) : !(v->second >= v->first))) {
        PARSE_FAULT(at, where,
                    law == SWEEP_NORMAL ? "the standard deviation of '%s' is below zero"
                                        : "the limits of '%s' are not in their order",
                    v->name);
    }
}

static void read_methods(reading *r, sweep_variable *v)
{
    parser *at = &r->at;
    do {
        const token *t = at->next;
        if (t->kind != TOKEN_NAME || index_of_word(t->text, method_names, ISO_METHODS) == ISO_METHODS) {
            PARSE_FAULT(at, t->at, "expected a method%s: %s",
                        source_suggestion(at->s, t->text, method_names, ISO_METHODS),
                        alternatives(at->s->memory, method_names, ISO_METHODS));
            return;
        }
        at->next++;
        LIST_ADD(at->s->memory, v->listed, ((sweep_value){0.0, t->text, false}));
    } while (take_sign(at, ','));
}

static void read_values(reading *r, sweep_variable *v)
{
    for (sweep_law law = SWEEP_UNIFORM; law <= SWEEP_NORMAL; law++) {
        if (v->sort == SWEEP_NUMBER && next_is_word(&r->at, laws[law]) && r->at.next[1].sign == '(') {
            read_random(r, v, law);
            return;
        }
    }
    if (v->sort == SWEEP_METHOD) {
        read_methods(r, v);
    } else {
        read_list(r, v);
    }
}

static void read_variable(parser *at, void *to)
{
    reading *r = to;
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
    if (!at->failed) {
        read_values(r, &v);
    }
    LIST_ADD(at->s->memory, r->result, v);
}

sweep_variables sweep_read_variables(source *s, graph *g, const scene *written, const plant *p, const script *set)
{
    scene with = *written;
    script read = *set;
    read.text = readable(s->memory, set);
    reading r = {.at = parser_of_option(s, &with, set, &read), .p = p, .written = written};
    values_start(&r.v, s, g, written, (size_t)p->m->parameters.count, p->is_double);
    values_resolve(&r.v);
    if (r.at.next->kind == TOKEN_END) {
        parse_problem(&r.at, "--set is what varies, such as mass = 0.1 .. 0.3 kg by 21");
    }
    parse_items(&r.at, read_variable, &r, "expected , and a further value, or ; and what varies besides");
    return r.result;
}
